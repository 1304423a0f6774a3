//! The place of a sensor: at the ground, in it, or on a structure.

use crate::Unusual;

/// A `Site` is the place of a component's sensor, according to the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Site {
    /// At the ground, or unknown.
    Ground,
    /// Below the ground, with the text of the file.
    Borehole(String),
    /// On or in a structure, with the text of the file.
    Structure(String),
}

/// Words of the ground, in capitals, which overrule others: `GROUND FLOOR`, `FREE FIELD`.
const GROUND: &str = "GROUND GRND GRADE FREE FREEFIELD BASEMENT SUBBASEMENT BSMT SOTANO";

/// Words of the ground, in capitals, that overrule a place on a structure: `FOOTING OF CENTER COLUMN`, `Seismic pier in vault`.
const FOOT: &str = "FOUNDATION FOOTING VAULT SHELTER";

/// Words of a place below the ground, in capitals.
const BOREHOLE: &str = "BOREHOLE DOWNHOLE";

/// Words of a place below the ground if the text has a depth, in capitals: `30m deep`.
const DEPTH: &str = "HOLE DEPTH DEEP";

/// Words of a place on a structure, in capitals.
const STRUCTURE: &str = "ROOF AZOTEA DECK TOP MIDSPAN SPAN MIDHEIGHT CREST PIER BENT GIRDER TOWER PENTHOUSE MEZZANINE ATTIC \
     BALCONY BRIDGE GALLERY COLUMN BEAM SLAB CABLE PYLON PARAPET ARCH SUPERSTRUCTURE";

/// Words of structures whose base is above the ground, in capitals.
const ABOVE: &str = "TOWER PYLON ARCH DECK SUPERSTRUCTURE ROOF";

/// Words of an address, in capitals, which may follow such a word: `Tower Rd` is not a tower.
const STREET: &str = "ST STREET AVE AVENUE RD ROAD BLVD DR DRIVE HWY";

/// Words of the landscape, in capitals, which has tops, crests and arches too.
const LAND: &str = "MOUNTAIN MT MTN HILL HILLS RIDGE PEAK MESA CLIFF BLUFF SLOPE CANYON ROCK";

/// Words of a floor, in capitals, that need a number before or after them: `10TH FLOOR`, `FLOOR 3`.
const FLOOR: &str = "FLOOR FLR FL STORY STOREY LEVEL PISO NIVEL";

/// Numbers of floors above the lowest, in capitals.
const UPPER: &str = "SECOND THIRD FOURTH FIFTH SIXTH SEVENTH EIGHTH NINTH TENTH ELEVENTH TWELFTH UPPER TOP";

fn is(known: &str, word: &str) -> bool {
    known.split(' ').any(|known| known == word)
}

impl Site {
    /// The warning for a place that is not the ground.
    pub(crate) fn off_the_ground(&self) -> Option<Unusual> {
        match self {
            Self::Ground => None,
            Self::Borehole(found) | Self::Structure(found) => Some(Unusual::OffTheGround { found: found.clone() }),
        }
    }

    /// Returns the place of a sensor from the text of a header: `Location: 10TH FLOOR`, `Dam crest`, `Depth 40 m`.
    pub(crate) fn of_location(text: &str) -> Self {
        let capitals = text.to_ascii_uppercase();
        let separates = |letter: char| !(letter.is_alphanumeric() || letter == '.');
        let words: Vec<&str> = (capitals.split(separates))
            .map(|word| word.trim_matches('.'))
            .filter(|word| !word.is_empty())
            .collect();
        let said = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let word = |index: Option<usize>| index.and_then(|index| words.get(index)).map_or("", |word| *word);
        // `Mid-Height`, `Down-hole`, `Free field`.
        let pairs: Vec<String> = words.windows(2).map(<[_]>::concat).collect();
        let has = |known: &str| {
            let pairs = pairs.iter().map(String::as_str);
            words.iter().copied().chain(pairs).any(|word| is(known, word))
        };
        let depths: Vec<f64> = (words.iter())
            .filter_map(|word| word.trim_end_matches(['M', 'F', 'T']).parse().ok())
            .collect();
        let is_deep = depths.iter().any(|depth: &f64| *depth != 0.0);
        let is_shallow = !is_deep && (!depths.is_empty() || has("SURFACE"));
        if (has(BOREHOLE) && !is_shallow) || (has(DEPTH) && is_deep) {
            return Self::Borehole(said);
        }
        let floors = |counts: fn(&str, bool) -> bool| {
            (0..words.len()).any(|index| {
                let [before, behind] = [word(index.checked_sub(1)), word(Some(index + 1))];
                // The number of a building's stories is not a place in it.
                let is_size = words[index].starts_with("STOR") && before.parse::<u32>().is_ok();
                let near = [before, behind].into_iter().any(|near| counts(near, false));
                counts(words[index], true) || (is(FLOOR, words[index]) && near && !is_size)
            })
        };
        let is_placed = |(index, place): (usize, &&str)| {
            let on_land = is("TOP CREST ARCH", place) && has(LAND);
            is(STRUCTURE, place) && !is(STREET, word(Some(index + 1))) && !on_land
        };
        let is_on = words.iter().enumerate().any(is_placed) || pairs.iter().any(|pair| is(STRUCTURE, pair));
        let at_foot = has(FOOT) || floors(is_lowest) || (has("BASE") && !has(ABOVE));
        if (!has(GROUND) || has("ABOVE")) && (floors(is_upper) || (is_on && !at_foot)) {
            return Self::Structure(said);
        }
        Self::Ground
    }
}

/// The number at the beginning of a word, if an ordinal suffix follows, or with `glued` a word for a floor: `10TH`, `10F`.
fn number(word: &str, glued: bool) -> Option<u32> {
    let behind = word.trim_start_matches(|letter: char| letter.is_ascii_digit());
    let ends = if glued { "F FL FLR" } else { "ST ND RD TH" };
    let is_number = is(ends, behind) || (behind.is_empty() && !glued);
    word[..word.len() - behind.len()].parse().ok().filter(|_| is_number)
}

/// Whether a word counts a floor above the lowest: `10TH`, `2nd`, `3`, `SECOND`.
fn is_upper(word: &str, glued: bool) -> bool {
    number(word, glued).is_some_and(|number| number > 1) || (!glued && is(UPPER, word))
}

/// Whether a word counts the lowest floor: `1ST`, `1`, `FIRST`.
fn is_lowest(word: &str, glued: bool) -> bool {
    number(word, glued) == Some(1) || (!glued && is("FIRST LOWER", word))
}

#[cfg(test)]
mod tests {
    use super::Site;

    /// Roofs, decks, floors above the fifth, towers and depths below zero counted as the ground.
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
            "SIXTH FLOOR",
            "10F",
            "Mid-Height",
            "Superstructure",
            "Arch",
            "Arch crown",
            "Base of Tower",
            "Tower, 30 m above ground",
            "Tower base, north leg",
            "Twelfth Floor, base of column",
            "Base isolated building, roof",
            "Roof, 120 Main St",
            "3 Story Bldg, Roof",
            "3rd Story",
            "Story 3",
            "5th floor, bank vault",
            "Top of Hill Street Bridge, deck",
        ] {
            assert!(matches!(Site::of_location(text), Site::Structure(_)), "{text}");
        }
        for text in [
            "Downhole, 40 m",
            "Depth 30m",
            "depth 30.0 m",
            "Borehole",
            "Downhole -100",
            "Down-hole",
            "30m deep",
            "30 m deep",
            "100 ft deep hole",
            "Borehole array, 12 m below surface",
        ] {
            assert!(matches!(Site::of_location(text), Site::Borehole(_)), "{text}");
        }
    }

    /// Slabs, vaults and hills counted as structures, and so did the size of a building.
    #[test]
    fn issue_places_at_the_ground() {
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
            "3 Story Bldg, Ground Flr",
            "Three-story building, 1st floor",
            "Basement Level 2",
            "Level 2, Basement",
            "1st Flr Slab",
            "First floor, column line A",
            "Slab on grade",
            "Slab-on-grade",
            "Table Top Mountain",
            "Top of Hill",
            "Crest of ridge",
            "Seismic pier in vault",
            "Bridge St. fire station",
            "Downhole array, surface",
            "Borehole, 0 m",
            "Deep Canyon",
            "Jackson Hole",
            "1F",
            "South Tower, Ground Floor",
            "NORTH FLOOR",
        ] {
            assert_eq!(Site::of_location(text), Site::Ground, "{text}");
        }
    }
}
