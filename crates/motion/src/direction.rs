//! Whether a component is vertical, by what formats and file names call it.

/// A `Direction` is how a component lies, as far as its name tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the ground: an azimuth, a compass point, a channel code such as HNE.
    Horizontal,
    /// Up or down.
    Vertical,
}

/// Words for up and down, in capitals; so are those that begin with `VERT`.
const UPRIGHT: [&str; 14] = [
    "UP", "U", "UD", "U-D", "V", "VER", "VRT", "Z", "DOWN", "DWN", "DN", "UP-DOWN", "UPDOWN",
    "VTCL",
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

/// Words at the end of a file name for up and down, in capitals: `U` may stand for uncorrected there.
const UPRIGHT_IN_FILES: [&str; 11] = [
    "UP", "UD", "V", "VER", "VRT", "VERT", "VERTICAL", "Z", "DOWN", "DWN", "DN",
];

/// Words at the end of a file name for directions along the ground, in capitals.
const LEVEL_IN_FILES: [&str; 8] = ["NS", "EW", "NS1", "EW1", "NS2", "EW2", "H1", "H2"];

/// Words before the number of a channel, which is no azimuth.
const CHANNEL: [&str; 7] = ["CHAN", "CHN", "CHA", "CHANNEL", "CANAL", "COLUMN", "COL"];

/// Second letters of the channel codes of accelerometers and seismometers, as in HNZ.
const INSTRUMENTS: &str = "NLGHMP";

impl Direction {
    /// Returns how a component lies by the words of its name: `UP`, `CHAN 1: 90 DEG`, `1 Up`, `N08W`, `V;+`, `HNZ`,
    /// `BHZ00`; `None` where no word is known.
    ///
    /// A word for up or down counts wherever it stands, other words from the last on. What stands in brackets is left out, and
    /// so is the number of a channel.
    pub fn of_component(name: &str) -> Option<Self> {
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
        let told = telling.filter_map(|index| Self::of_word(words[index]));
        told.reduce(|before, last| match before {
            Self::Vertical => before,
            Self::Horizontal => last,
        })
    }

    /// Returns how a component lies by the end of its file's name, and that end: vertical by `UP` of `RSN6_ELC-UP.AT2`, `UD` of
    /// `ABC001.UD` and of `NIGH11UD.AT2`, `BHZ` of `CCM.BHZ.00.AT2`; horizontal by `EW` of `ABC001.EW`.
    ///
    /// That is weaker than what a file says itself: a name may end so by chance.
    pub fn of_file_name(file_name: &str) -> Option<(Self, &str)> {
        let (stem, ending) = file_name.rsplit_once('.').unwrap_or((file_name, ""));
        let mut pieces = stem.rsplit(['-', '_', '.', ' ']);
        let last = pieces.next().unwrap_or_default();
        // Behind a channel code may stand that of a location.
        let is_location = last.len() == 2 && last.bytes().all(|byte| byte.is_ascii_digit());
        let end = match pieces.next() {
            Some(code) if is_location && end_of_code(&code.to_ascii_uppercase()).is_some() => code,
            // A name of one word is not the end of one.
            _ if last == stem => "",
            _ => last,
        };
        let of_word = |word: &'_ str| {
            let capitals = word.to_ascii_uppercase();
            if is_upright_end(&capitals) {
                Some(Self::Vertical)
            } else {
                is_level_end(&capitals).then_some(Self::Horizontal)
            }
        };
        let told = [ending, end]
            .into_iter()
            .find_map(|word| Some((of_word(word)?, word)));
        told.or_else(|| {
            let word = behind_number(stem)?;
            match word.to_ascii_uppercase().as_str() {
                "UD" => Some((Self::Vertical, word)),
                "NS" | "EW" => Some((Self::Horizontal, word)),
                _ => None,
            }
        })
    }

    fn of_word(word: &str) -> Option<Self> {
        let code = end_of_code(word);
        // Sensors are counted: V2, UP1.
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

/// Whether a channel code such as BHE, in any case, is that of a seismometer, which measures velocity.
pub(crate) fn is_seismometer(code: &str) -> bool {
    let code = code.to_ascii_uppercase();
    let instrument = code.chars().nth(1);
    end_of_code(&code).is_some() && instrument.is_some_and(|letter| "HLMP".contains(letter))
}

/// The direction of a channel code such as HNZ, in capitals: its last letter. The code of a location may stand behind: HNZ00.
fn end_of_code(word: &str) -> Option<char> {
    let word = word.strip_suffix("--").unwrap_or(word);
    let letters: Vec<char> = word.chars().collect();
    let (band, instrument, end) = match letters[..] {
        [band, instrument, end] => (band, instrument, end),
        [band, instrument, end, tens, ones] if tens.is_ascii_digit() && ones.is_ascii_digit() => {
            (band, instrument, end)
        }
        _ => return None,
    };
    let is_code = band.is_ascii_uppercase()
        && INSTRUMENTS.contains(instrument)
        && "ZNE123RTUVWXYABC".contains(end);
    is_code.then_some(end)
}

/// Degrees, 0 to 360, or degrees from a compass point to another, `N08W`.
fn is_azimuth(word: &str) -> bool {
    let between = word
        .strip_prefix(['N', 'S'])
        .and_then(|word| word.strip_suffix(['E', 'W']));
    let (degrees, most) = between.map_or((word, 360), |degrees| (degrees, 90));
    let digits = (1..=3).contains(&degrees.len()) && degrees.bytes().all(|b| b.is_ascii_digit());
    digits && degrees.parse().is_ok_and(|degrees: u32| degrees <= most)
}

/// The direction behind the code of a station that ends in a number, `UD` of `NIGH11UD`.
fn behind_number(stem: &str) -> Option<&str> {
    let code = stem.trim_end_matches(|letter: char| letter.is_ascii_alphabetic());
    let letters = code.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let is_code = letters.len() < code.len()
        && letters.ends_with(|letter: char| letter.is_ascii_alphabetic());
    is_code.then(|| &stem[code.len()..])
}

fn is_upright_end(word: &str) -> bool {
    // KiK-net ends its files in UD1 and UD2, below and above.
    let is_pair = matches!(word, "UD1" | "UD2");
    UPRIGHT_IN_FILES.contains(&word) || is_pair || is_channel_end(word, "Z")
}

fn is_level_end(word: &str) -> bool {
    LEVEL_IN_FILES.contains(&word) || is_channel_end(word, "NE12")
}

/// Whether a word is the channel code of an instrument that measures in one of these directions.
pub(crate) fn is_channel_end(word: &str, ends: &str) -> bool {
    let instrument = word.chars().nth(1);
    instrument.is_some_and(|letter| "NLGH".contains(letter))
        && end_of_code(word).is_some_and(|end| ends.contains(end))
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
            "", " ", "Chan", "361", "1234", "N99W", "S 100", "ß", "STATION", "CHAN 2", "column 3",
            "(UP)",
        ] {
            let horizontal = name == "S 100";
            let expected = horizontal.then_some(Direction::Horizontal);
            assert_eq!(Direction::of_component(name), expected, "{name}");
        }
    }

    #[test]
    fn reference_ends_of_file_names() {
        for (name, end) in [
            ("RSN6_IMPVALL.I_I-ELC-UP.AT2", "UP"),
            ("RSN1244_CHICHI_CHY101-V.AT2", "V"),
            ("quake_z.txt", "z"),
            ("A-ELC-DWN.AT2", "DWN"),
            ("I-VERT.AT2", "VERT"),
            ("ABC0010102030405.UD", "UD"),
            ("ABCH010102030405.UD2", "UD2"),
            ("RSN4228_NIIGATA_NIGH11UD.AT2", "UD"),
            ("20190706.CJ.T001230.HNZ.sac", "HNZ"),
            ("RSN10590_ComalTX_IU.CCM.BHZ.00.AT2", "BHZ"),
            ("3528839_LPCC_HN_20.ver", "ver"),
        ] {
            let found = Direction::of_file_name(name);
            assert_eq!(found, Some((Direction::Vertical, end)), "{name}");
        }
        for (name, end) in [
            ("20190706.CJ.T001230.HNE.sac", "HNE"),
            ("ABC0010102030405.EW", "EW"),
            ("RSN4228_NIIGATA_NIGH11NS.AT2", "NS"),
        ] {
            let found = Direction::of_file_name(name);
            assert_eq!(found, Some((Direction::Horizontal, end)), "{name}");
        }
        for name in [
            "RSN6_IMPVALL.I_I-ELC180.AT2",
            "up.csv",
            "Z",
            "group.txt",
            "cloud.txt",
            "v2.txt",
            "quake_u.txt",
            "A-UP-filtered.AT2",
            "a-biz.txt",
            "a-20.txt",
            // A number at the end counts files as often as it is an azimuth.
            "ACAC8903.101",
            "",
            ".",
        ] {
            assert_eq!(Direction::of_file_name(name), None, "{name}");
        }
    }
}
