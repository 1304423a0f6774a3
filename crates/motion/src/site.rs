//! Where a sensor is: at the ground, in it, or on a structure.

/// A `Site` is where the sensor of a component is, as its file says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Site {
    /// At the ground, or the file does not say.
    Ground,
    /// Below the ground, with what the file says.
    Borehole(String),
    /// On or in a structure, with what the file says.
    Structure(String),
}

/// Words of a free ground, in capitals, which come first: `GROUND FLOOR`, `FREE FIELD`.
const GROUND: [&str; 9] = [
    "GROUND",
    "GRND",
    "FREE",
    "FREEFIELD",
    "BASEMENT",
    "BSMT",
    "BASE",
    "FOUNDATION",
    "FOOTING",
];

/// Words of a place below the ground, in capitals.
const BOREHOLE: [&str; 5] = ["BOREHOLE", "DOWNHOLE", "DOWN-HOLE", "HOLE", "DEPTH"];

/// Words of a place on a structure, in capitals.
const STRUCTURE: [&str; 24] = [
    "ROOF",
    "AZOTEA",
    "DECK",
    "TOP",
    "MIDSPAN",
    "MID-SPAN",
    "SPAN",
    "CREST",
    "PIER",
    "BENT",
    "GIRDER",
    "TOWER",
    "PENTHOUSE",
    "MEZZANINE",
    "ATTIC",
    "BALCONY",
    "BRIDGE",
    "GALLERY",
    "COLUMN",
    "BEAM",
    "SLAB",
    "CABLE",
    "PYLON",
    "PARAPET",
];

/// Words of an address, in capitals: `Tower Rd` is no tower.
const STREET: [&str; 10] = [
    "ST", "STREET", "AVE", "AVENUE", "RD", "ROAD", "BLVD", "DR", "DRIVE", "HWY",
];

/// Words of a floor, in capitals, which need a number before or behind them: `10TH FLOOR`, `FLOOR 3`.
const FLOOR: [&str; 8] = [
    "FLOOR", "FLR", "FL", "STORY", "STOREY", "LEVEL", "PISO", "NIVEL",
];

impl Site {
    /// Returns where a sensor is by what a header says of its place: `Location: 10TH FLOOR`, `Dam crest`, `Depth 40 m`.
    pub(crate) fn of_location(text: &str) -> Self {
        let capitals = text.to_ascii_uppercase();
        let separates = |letter: char| !(letter.is_alphanumeric() || letter == '-');
        let words: Vec<&str> = capitals
            .split(separates)
            .filter(|word| !word.is_empty())
            .collect();
        let said = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let has = |known: &[&str]| words.iter().any(|word| known.contains(word));
        let mut depths = words
            .iter()
            .filter_map(|word| word.trim_end_matches('M').parse::<f64>().ok());
        let is_shallow = depths.clone().count() > 0 && depths.all(|depth| depth <= 0.0);
        if has(&BOREHOLE) && !is_shallow {
            return Self::Borehole(said);
        }
        let upper = words.iter().enumerate().any(|(index, word)| {
            let near = [
                index.checked_sub(1).map(|at| words[at]),
                words.get(index + 1).copied(),
            ];
            FLOOR.contains(word) && near.into_iter().flatten().any(is_upper)
        });
        if upper || (has(&STRUCTURE) && !has(&GROUND) && !has(&STREET)) {
            return Self::Structure(said);
        }
        Self::Ground
    }
}

/// Whether a word counts a floor above the lowest: `10TH`, `2nd`, `3`, `SECOND`.
fn is_upper(word: &str) -> bool {
    let digits: String = word.chars().take_while(char::is_ascii_digit).collect();
    let behind = &word[digits.len()..];
    let is_number = matches!(behind, "" | "ST" | "ND" | "RD" | "TH");
    let counted = digits.parse().is_ok_and(|number: u32| number > 1);
    (is_number && counted) || ["SECOND", "THIRD", "FOURTH", "FIFTH", "UPPER", "TOP"].contains(&word)
}

#[cfg(test)]
mod tests {
    use super::Site;

    /// Roofs, decks and floors counted as the ground.
    #[test]
    fn issue_places_on_structures() {
        for text in [
            "Roof",
            "Deck",
            "Top",
            "Midspan",
            "10TH FLOOR",
            "2nd Floor, NE corner",
            "Dam crest",
            "Roof: Center",
            "Deck - Mid Span",
            "Top of Pier 3",
            "Level 5",
            "Del Valle Dam, crest",
            "6th Flr",
        ] {
            assert!(
                matches!(Site::of_location(text), Site::Structure(_)),
                "{text}"
            );
        }
        for text in ["Downhole, 40 m", "Depth 30m", "depth 30.0 m", "Borehole"] {
            assert!(
                matches!(Site::of_location(text), Site::Borehole(_)),
                "{text}"
            );
        }
    }

    #[test]
    fn limit_places_at_the_ground() {
        for text in [
            "",
            "Ground Floor",
            "Ground level",
            "Basement",
            "Free Field",
            "Freefield",
            "1st Floor",
            "FOOTING OF CENTER COLUMN: W. EDGE",
            "Instrument shelter",
            "Free field near bridge",
            "1ST LEVEL",
            "Tower Rd.",
            "building location description",
            "Depth 0.0 m",
            "DEPTH 0M",
        ] {
            assert_eq!(Site::of_location(text), Site::Ground, "{text}");
        }
    }
}
