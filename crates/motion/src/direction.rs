//! Whether a component is vertical, by what formats and file names call it.

/// A `Direction` is how a component lies, as far as its name tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the ground: an azimuth, a compass point, a channel code such as HNE.
    Horizontal,
    /// Up or down.
    Vertical,
}

/// Words for up and down, in capitals.
const UPRIGHT: [&str; 13] = [
    "UP", "U", "UD", "U-D", "V", "VER", "VRT", "VERT", "VERTICAL", "Z", "DOWN", "DWN", "DN",
];

/// Words for directions along the ground, in capitals.
const LEVEL: [&str; 14] = [
    "N", "S", "E", "W", "NS", "EW", "N-S", "E-W", "NORTH", "SOUTH", "EAST", "WEST", "H1", "H2",
];

/// Words at the end of a file name for up and down, in capitals: `U` may stand for uncorrected there.
const UPRIGHT_IN_FILES: [&str; 11] = [
    "UP", "UD", "V", "VER", "VRT", "VERT", "VERTICAL", "Z", "DOWN", "DWN", "DN",
];

/// Second letters of the channel codes of accelerometers and seismometers, as in HNZ.
const INSTRUMENTS: &str = "NLGH";

impl Direction {
    /// Returns how a component lies by the last word of its name: `UP`, `CHAN 1: 90 DEG`, `N08W`, `HNZ`; none where the
    /// word is not known.
    pub fn of_component(name: &str) -> Option<Self> {
        let name = name.to_ascii_uppercase();
        let mut words = name
            .rsplit([' ', ':', '.'])
            .filter(|word| !word.is_empty() && !word.starts_with("DEG"));
        Self::of_word(words.next()?)
    }

    /// Returns the end of a file name that says vertical: `UP` of `RSN6_ELC-UP.AT2`, `UD` of `ABC001.UD` and of
    /// `NIGH11UD.AT2`.
    ///
    /// That is weaker than what a file says itself: a name may end so by chance.
    pub fn upright_end(file_name: &str) -> Option<&str> {
        let (stem, ending) = file_name.rsplit_once('.').unwrap_or((file_name, ""));
        let end = stem.rsplit(['-', '_', '.', ' ']).next().unwrap_or_default();
        // A name of one word is not the end of one.
        let end = if end == stem { "" } else { end };
        let word = [ending, end].into_iter().find(|word| is_upright_end(word));
        word.or_else(|| behind_number(stem).filter(|word| word.eq_ignore_ascii_case("UD")))
    }

    fn of_word(word: &str) -> Option<Self> {
        let code = end_of_code(word);
        if UPRIGHT.contains(&word) || code == Some('Z') {
            Some(Self::Vertical)
        } else if LEVEL.contains(&word)
            || code.is_some_and(|end| "NE12".contains(end))
            || is_azimuth(word)
        {
            Some(Self::Horizontal)
        } else {
            None
        }
    }
}

/// The direction of a channel code such as HNZ, in capitals: its last letter.
fn end_of_code(word: &str) -> Option<char> {
    let letters: Vec<char> = word.chars().collect();
    let &[_, instrument, end] = &letters[..] else {
        return None;
    };
    INSTRUMENTS.contains(instrument).then_some(end)
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
    let word = word.to_ascii_uppercase();
    // KiK-net ends its files in UD1 and UD2, below and above.
    let is_pair = matches!(word.as_str(), "UD1" | "UD2");
    let is_code = end_of_code(&word) == Some('Z');
    UPRIGHT_IN_FILES.contains(&word.as_str()) || is_pair || is_code
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
        ] {
            let found = Direction::of_component(name);
            assert_eq!(found, Some(Direction::Horizontal), "{name}");
        }
    }

    #[test]
    fn extreme_names_that_tell_no_direction() {
        for name in [
            "", " ", "Chan", "361", "1234", "N99W", "S 100", "ß", "STATION",
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
        ] {
            assert_eq!(Direction::upright_end(name), Some(end), "{name}");
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
            "20190706.CJ.T001230.HNE.sac",
            "a-biz.txt",
            "",
            ".",
        ] {
            assert_eq!(Direction::upright_end(name), None, "{name}");
        }
    }
}
