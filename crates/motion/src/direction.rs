//! The direction of a component, according to its name in formats and files.

/// A `Direction` is the direction of a component, as far as its name shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the ground: an azimuth, a compass point, a channel code such as HNE.
    Horizontal,
    /// Up or down.
    Vertical,
}

/// Words for up and down, in capitals. Words that begin with `VERT` count too.
const UPRIGHT: [&str; 14] = [
    "UP", "U", "UD", "U-D", "V", "VER", "VRT", "Z", "DOWN", "DWN", "DN", "UP-DOWN", "UPDOWN", "VTCL",
];

/// Words for directions along the ground, in capitals.
const LEVEL: [&str; 33] = [
    "N",
    "S",
    "E",
    "W",
    "NS",
    "EW",
    "N-S",
    "E-W",
    "NORTH",
    "SOUTH",
    "EAST",
    "WEST",
    "NORTH-SOUTH",
    "EAST-WEST",
    "H",
    "H1",
    "H2",
    "L",
    "T",
    "R",
    "X",
    "Y",
    "LON",
    "LONG",
    "LONGITUDINAL",
    "TRA",
    "TRAN",
    "TRANS",
    "TRANSVERSE",
    "RADIAL",
    "FN",
    "FP",
    "HORIZONTAL",
];

/// Words in front of a channel number, which is not an azimuth.
const CHANNEL: [&str; 7] = ["CHAN", "CHN", "CHA", "CHANNEL", "CANAL", "COLUMN", "COL"];

/// Second letters of the channel codes of accelerometers and seismometers, as in HNZ.
const INSTRUMENTS: &str = "NLGHMP";

impl Direction {
    /// Returns the direction from the words of a component's name: `UP`, `CHAN 1: 90 DEG`, `1 Up`, `N08W`, `V;+`, `HNZ`, `BHZ00`; `None` if
    /// no word is known.
    ///
    /// A word for up or down counts at any position; other words are searched from the last. Text in brackets and the number of a channel
    /// are ignored.
    pub fn of_component(name: &str) -> Option<Self> {
        let words = telling_words(name);
        let told = words.iter().filter_map(|word| Self::of_word(word));
        told.reduce(|before, last| match before {
            Self::Vertical => before,
            Self::Horizontal => last,
        })
    }

    fn of_word(word: &str) -> Option<Self> {
        let code = end_of_code(word);
        // Sensors may be numbered: V2, UP1.
        let letters = word.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let is = |words: &[&str]| words.contains(&word) || words.contains(&letters);
        if is(&UPRIGHT) || word.starts_with("VERT") || code == Some('Z') {
            Some(Self::Vertical)
        } else if is(&LEVEL) || code.is_some_and(|end| "NE12RT".contains(end)) || is_azimuth(word) {
            Some(Self::Horizontal)
        } else {
            None
        }
    }
}

/// Returns the words of a component's name in capitals, without text in brackets and without numbers of channels.
pub(crate) fn telling_words(name: &str) -> Vec<String> {
    let name = name.to_ascii_uppercase();
    let name = name.split('(').next().unwrap_or_default();
    let separates = |letter: char| !(letter.is_alphanumeric() || letter == '-');
    let words: Vec<&str> = name
        .split(separates)
        .filter(|word| !word.is_empty() && !word.starts_with("DEG"))
        .collect();
    let is_channel = |index: &usize| {
        let before = index.checked_sub(1).map(|before| words[before]);
        let is_number = words[*index].bytes().all(|byte| byte.is_ascii_digit());
        is_number && before.is_some_and(|word| CHANNEL.contains(&word))
    };
    let telling = (0..words.len()).filter(|index| !is_channel(index));
    telling.map(|index| words[index].to_owned()).collect()
}

/// Whether a channel code such as BHE, in any case, belongs to a seismometer, which measures velocity.
pub(crate) fn is_seismometer(code: &str) -> bool {
    let code = code.to_ascii_uppercase();
    let instrument = code.chars().nth(1);
    end_of_code(&code).is_some() && instrument.is_some_and(|letter| "HLMP".contains(letter))
}

/// The direction letter of a channel code such as HNZ, in capitals: its last letter. The code of a location may follow: HNZ00.
fn end_of_code(word: &str) -> Option<char> {
    let word = word.strip_suffix("--").unwrap_or(word);
    let letters: Vec<char> = word.chars().collect();
    let (band, instrument, end) = match letters[..] {
        [band, instrument, end] => (band, instrument, end),
        [band, instrument, end, tens, ones] if tens.is_ascii_digit() && ones.is_ascii_digit() => (band, instrument, end),
        _ => return None,
    };
    let is_code = band.is_ascii_uppercase() && INSTRUMENTS.contains(instrument) && "ZNE123RTUVWXYABC".contains(end);
    is_code.then_some(end)
}

/// Whether a word is an azimuth in degrees, 0 to 360, or in degrees from one compass point to another, `N08W`.
fn is_azimuth(word: &str) -> bool {
    let between = word.strip_prefix(['N', 'S']).and_then(|word| word.strip_suffix(['E', 'W']));
    let (degrees, most) = between.map_or((word, 360), |degrees| (degrees, 90));
    let digits = (1..=3).contains(&degrees.len()) && degrees.bytes().all(|b| b.is_ascii_digit());
    digits && degrees.parse().is_ok_and(|degrees: u32| degrees <= most)
}

/// Whether a word is the channel code of an instrument that measures in one of these directions.
pub(crate) fn is_channel_end(word: &str, ends: &str) -> bool {
    let instrument = word.chars().nth(1);
    instrument.is_some_and(|letter| "NLGH".contains(letter)) && end_of_code(word).is_some_and(|end| ends.contains(end))
}

#[cfg(test)]
mod tests {
    use super::Direction;

    #[test]
    fn reference_vertical_components_as_formats_write_them() {
        for name in [
            "CHAN 2: UP",
            "Sta Cha: 2: up",
            "Up",
            "U-D",
            "HNZ",
            "U",
            "V",
            "vertical",
            "Vert.",
            "DWN",
            "6: UP",
            "1 Up",
            "CHAN 2: UP (STA CHN: 15)",
            "CHAN 2: V (STA CHN: 2)",
            "V;+",
            "Z",
            "BHZ",
            "BHZ00",
            "HNZ--",
            "COMP V2",
            "acc_UD(gal)",
            "ver",
            "Up-down",
        ] {
            let found = Direction::of_component(name);
            assert_eq!(found, Some(Direction::Vertical), "{name}");
        }
    }

    #[test]
    fn reference_horizontal_components_as_formats_write_them() {
        for name in [
            "S16W",
            "COMP N08W",
            "CHAN 1: 90 DEG",
            "Sta Cha: 1: 340 deg",
            "N-S",
            "E-W",
            "HNE",
            "HN1",
            "NS",
            "000",
            "360",
            "CHAN 1: L (STA CHN: 1)",
            "N90E;+",
            "BHE00",
            "COMP T3",
            "acc_NS(gal)",
            "North-south",
        ] {
            let found = Direction::of_component(name);
            assert_eq!(found, Some(Direction::Horizontal), "{name}");
        }
    }

    #[test]
    fn extreme_names_that_tell_no_direction() {
        for name in [
            "", " ", "Chan", "361", "1234", "N99W", "S 100", "ß", "STATION", "CHAN 2", "column 3", "(UP)",
        ] {
            let horizontal = name == "S 100";
            let expected = horizontal.then_some(Direction::Horizontal);
            assert_eq!(Direction::of_component(name), expected, "{name}");
        }
    }
}
