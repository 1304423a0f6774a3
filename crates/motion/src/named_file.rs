//! Names of files: direction, quantity and number of the record, and which files belong to one record.

use std::collections::BTreeMap;
use std::ffi::OsStr;

use crate::Direction;
use crate::direction::is_channel_end;

/// A `NamedFile` holds the facts that the name of a file tells.
///
/// They are weaker than the header of the file: a name may end so by chance. [`of_all`](Self::of_all) compares the names of a
/// folder and tells more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFile {
    /// The name with `*` for the direction: components of one record share it.
    pub stem: String,
    /// The word for the direction, in capitals: `UP`, `180`, `HNE`.
    pub word: Option<String>,
    /// How the component lies; `None` if the word is an azimuth, or a letter that may stand for something else.
    pub direction: Option<Direction>,
    /// Azimuth, up to 360 \[°\]; or a number that looks like one.
    pub azimuth: Option<u16>,
    /// What the values are.
    pub quantity: Option<Quantity>,
    /// Number of the record in PEER's data bases.
    pub rsn: Option<u32>,
}

/// A `Quantity` is what a file holds, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Accelerations.
    Acceleration,
    /// Velocities.
    Velocity,
    /// Displacements.
    Displacement,
    /// A response spectrum.
    Spectrum,
}

/// Words of quantities, in capitals; the last in a name holds.
const QUANTITIES: [(&str, Quantity); 22] = {
    use Quantity::{Acceleration, Displacement, Spectrum, Velocity};
    [
        ("ACC", Acceleration),
        ("ACCEL", Acceleration),
        ("ACCELERATION", Acceleration),
        ("AT2", Acceleration),
        ("VEL", Velocity),
        ("VELO", Velocity),
        ("VELOCITY", Velocity),
        ("VT2", Velocity),
        ("DIS", Displacement),
        ("DISP", Displacement),
        ("DISPL", Displacement),
        ("DISPLACEMENT", Displacement),
        ("DSP", Displacement),
        ("DT2", Displacement),
        ("PSA", Spectrum),
        ("PSV", Spectrum),
        ("SA", Spectrum),
        ("SD", Spectrum),
        ("SPEC", Spectrum),
        ("SPECTRA", Spectrum),
        ("SPECTRUM", Spectrum),
        ("RESPONSE", Spectrum),
    ]
};

/// Words for up and down, in capitals.
const UPRIGHT: [&str; 13] = [
    "UP", "UD", "V", "VER", "VRT", "VERT", "VERTICAL", "Z", "DOWN", "DWN", "DN", "UD1", "UD2",
];

/// Words for directions along the ground, in capitals.
const LEVEL: [&str; 28] = [
    "N", "S", "E", "W", "NS", "EW", "NS1", "EW1", "NS2", "EW2", "NORTH", "SOUTH", "EAST", "WEST",
    "H1", "H2", "FN", "FP", "L", "T", "LN", "TR", "LONG", "TRAN", "TRANS", "X", "Y", "H",
];

/// Ends of a word behind the code of a station: `FA030XTE`, `NIGH11UD`, `CHY080E`. What is one letter tells a direction only
/// beside others.
const BEHIND_CODES: [&str; 12] = [
    "XTE", "YLN", "ZUP", "NS", "EW", "UD", "E", "N", "W", "S", "V", "U",
];

/// Degrees by which two components may miss a right angle: of Lucerne 1992 there are 260 and 345.
const SLACK: u16 = 5;

/// A word for a direction in a name.
struct Found<'n> {
    /// What stands before and behind it.
    around: [&'n str; 2],
    word: String,
    direction: Option<Direction>,
    azimuth: Option<u16>,
}

impl NamedFile {
    /// Reads one name, without its folder.
    pub fn of(name: impl AsRef<OsStr>) -> Self {
        let name = name.as_ref().to_string_lossy();
        let found = find(&name);
        let stem = found.as_ref().map_or_else(
            || name.clone().into_owned(),
            |found| {
                let [before, behind] = found.around;
                // `A-ELC180` and `A-ELC-UP` are of one record.
                format!("{}*{behind}", before.trim_end_matches(['-', '_', ' ']))
            },
        );
        Self {
            stem,
            quantity: quantity(&name),
            rsn: rsn(&name),
            direction: found.as_ref().and_then(|found| found.direction),
            azimuth: found.as_ref().and_then(|found| found.azimuth),
            word: found.map(|found| found.word),
        }
    }

    /// Reads the names of one folder together, and keeps their order.
    ///
    /// A number is an azimuth only where one other of the same stem is a right angle apart, or a vertical component stands beside
    /// it: `r001`, `r002`, `r091` are three records. A letter such as `U` is up beside `E` or `N`.
    pub fn of_all<N: AsRef<OsStr>>(names: &[N]) -> Vec<Self> {
        let mut files: Vec<Self> = names.iter().map(Self::of).collect();
        let mut azimuths: BTreeMap<String, Vec<u16>> = BTreeMap::new();
        let mut words: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for file in &files {
            let all = azimuths.entry(file.stem.clone()).or_default();
            all.extend(file.azimuth.filter(|azimuth| !all.contains(azimuth)));
            words
                .entry(file.stem.clone())
                .or_default()
                .extend(file.word.clone());
        }
        for (file, name) in files.iter_mut().zip(names) {
            let beside = |known: &[&str]| {
                words[&file.stem]
                    .iter()
                    .any(|word| known.contains(&word.as_str()))
            };
            let is_azimuth = match azimuths[&file.stem][..] {
                [one, other] => is_right(one, other),
                [_] => beside(&UPRIGHT),
                _ => false,
            };
            if file.azimuth.is_some() && !is_azimuth && file.rsn.is_none() {
                *file = Self {
                    stem: name.as_ref().to_string_lossy().into_owned(),
                    word: None,
                    azimuth: None,
                    ..file.clone()
                };
                continue;
            }
            if file.direction.is_none()
                && let Some(word) = &file.word
                && beside(&["E", "N", "W", "S", "NS", "EW"])
            {
                file.direction = match word.as_str() {
                    "U" | "V" | "Z" => Some(Direction::Vertical),
                    "E" | "N" | "W" | "S" => Some(Direction::Horizontal),
                    _ => None,
                };
            }
        }
        files
    }

    /// Returns whether two files are components of one record by their names.
    ///
    /// They are if they share PEER's number of the record. Without numbers they must share the stem and have different words for
    /// the direction; azimuths must be a right angle apart. Call it on the result of [`of_all`](Self::of_all).
    pub fn same_record(&self, other: &Self) -> bool {
        if let (Some(one), Some(other)) = (self.rsn, other.rsn) {
            return one == other;
        }
        let (Some(word), Some(of_other)) = (&self.word, &other.word) else {
            return false;
        };
        let are_apart = match (self.azimuth, other.azimuth) {
            (Some(one), Some(other)) => is_right(one, other),
            _ => word != of_other,
        };
        self.stem == other.stem && self.rsn == other.rsn && are_apart
    }
}

/// Whether two azimuths are a right angle apart, or three.
fn is_right(one: u16, other: u16) -> bool {
    let apart = one.abs_diff(other);
    [90, 270]
        .iter()
        .any(|right| apart.abs_diff(*right) <= SLACK)
}

/// The pieces of a name between its separators, each with its place.
fn pieces(name: &str) -> Vec<(usize, &str)> {
    let mut pieces = Vec::new();
    let mut at = 0;
    for piece in name.split(['-', '_', '.', ' ']) {
        pieces.push((at, piece));
        at += piece.len() + 1;
    }
    pieces
}

/// The quantity of the last piece that is a word for one; that of a name of one word is none.
fn quantity(name: &str) -> Option<Quantity> {
    let pieces = pieces(name);
    let ending = name.rsplit_once('.').map(|(_, ending)| ending);
    // `.d` beside `.a` and `.v`.
    if ending.is_some_and(|ending| ending.eq_ignore_ascii_case("d")) {
        return Some(Quantity::Displacement);
    }
    pieces
        .iter()
        .rev()
        .find_map(|(_, piece)| quantity_of(piece))
}

fn quantity_of(piece: &str) -> Option<Quantity> {
    let known = QUANTITIES
        .iter()
        .find(|(word, _)| word.eq_ignore_ascii_case(piece));
    known.map(|(_, quantity)| *quantity)
}

/// The number behind `RSN` or `NGA_no_` at the start of a name.
fn rsn(name: &str) -> Option<u32> {
    let behind = ["RSN", "NGA_NO_"].iter().find_map(|start| {
        let begin = name.get(..start.len())?;
        begin
            .eq_ignore_ascii_case(start)
            .then(|| &name[start.len()..])
    })?;
    let end = behind.find(|letter: char| !letter.is_ascii_digit());
    behind[..end.unwrap_or(behind.len())].parse().ok()
}

/// A word at a place of a name.
fn found<'n>(
    name: &'n str,
    at: usize,
    word: &str,
    direction: Option<Direction>,
    azimuth: Option<u16>,
) -> Found<'n> {
    Found {
        around: [&name[..at], &name[at + word.len()..]],
        word: word.to_ascii_uppercase(),
        direction,
        azimuth,
    }
}

/// The word for the direction: the code of a channel between points, the ending, or the end of what stands before it and before
/// words for a quantity.
fn find(name: &str) -> Option<Found<'_>> {
    let pieces = pieces(name);
    let between_points = |&&(at, piece): &&(usize, &str)| {
        let end = at + piece.len();
        let is_point = |letter: Option<char>| letter.is_none_or(|letter| letter == '.');
        at > 0 && is_point(name[..at].chars().next_back()) && is_point(name[end..].chars().next())
    };
    let mut codes = pieces.iter().rev().filter(between_points);
    let code =
        codes.find_map(|&(at, piece)| Some(found(name, at, piece, Some(of_code(piece)?), None)));
    if code.is_some() {
        return code;
    }
    let (&(at, ending), others) = pieces.split_last()?;
    let has_ending = name[..at].ends_with('.');
    if has_ending && let Some((start, word, direction)) = of_ending(ending) {
        let azimuth = azimuth(word).filter(|_| direction.is_none());
        return Some(found(name, at + start, word, direction, azimuth));
    }
    let before = if has_ending { others } else { &pieces[..] };
    let is_other = |(_, piece): &&(usize, &str)| quantity_of(piece).is_none();
    let &(at, piece) = before.iter().rev().find(is_other)?;
    let apart = of_piece(piece).filter(|_| at > 0);
    if let Some((word, direction, azimuth)) = apart {
        return Some(found(name, at, word, direction, azimuth));
    }
    let is_smc = has_ending && ending.eq_ignore_ascii_case("smc");
    let (start, word, direction) = glued(piece, is_smc)?;
    let degrees = azimuth(word.trim_start_matches(|letter: char| letter.is_ascii_alphabetic()));
    Some(found(name, at + start, word, direction, degrees))
}

/// A word for a direction that stands apart: `UP`, `N`, an azimuth of two digits or three, or a letter that is counted, as in
/// `FER-L1` and `FER-T1`.
fn of_piece(piece: &str) -> Option<(&str, Option<Direction>, Option<u16>)> {
    if let Some(direction) = of_word(piece) {
        return Some((piece, Some(direction), None));
    }
    if piece.eq_ignore_ascii_case("U") {
        return Some((piece, None, None));
    }
    if let Some(azimuth) = azimuth(piece) {
        return Some((piece, None, Some(azimuth)));
    }
    let (letter, number) = piece.split_at_checked(1)?;
    let is_counted = number.len() == 1 && number.as_bytes()[0].is_ascii_digit();
    let is_letter = ["L", "T"]
        .iter()
        .any(|known| known.eq_ignore_ascii_case(letter));
    (is_counted && is_letter).then_some((letter, Some(Direction::Horizontal), None))
}

/// How the instrument of a channel lies: HNZ, BHE, HN1.
fn of_code(piece: &str) -> Option<Direction> {
    let capitals = piece.to_ascii_uppercase();
    if is_channel_end(&capitals, "Z") {
        return Some(Direction::Vertical);
    }
    is_channel_end(&capitals, "NE12").then_some(Direction::Horizontal)
}

fn of_word(piece: &str) -> Option<Direction> {
    let capitals = piece.to_ascii_uppercase();
    if UPRIGHT.contains(&capitals.as_str()) {
        return Some(Direction::Vertical);
    }
    let is_level = LEVEL.contains(&capitals.as_str());
    is_level
        .then_some(Direction::Horizontal)
        .or_else(|| of_code(piece))
}

/// The word in the ending of a name, with its place: `.UD`, `.090`, `.00E`, `.s0a`.
fn of_ending(ending: &str) -> Option<(usize, &str, Option<Direction>)> {
    if let Some(direction) = of_word(ending) {
        return Some((0, ending, Some(direction)));
    }
    if ending.len() != 3 || !ending.is_ascii() {
        return None;
    }
    let (start, letter) = ending.split_at(2);
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if azimuth(ending).is_some() {
        return Some((0, ending, None));
    }
    if digits(start) {
        let direction = match letter.to_ascii_uppercase().as_str() {
            "U" | "Z" => Direction::Vertical,
            "E" | "N" => Direction::Horizontal,
            _ => return None,
        };
        return Some((2, letter, Some(direction)));
    }
    // Channels of the University of Southern California.
    let is_channel =
        start.starts_with(['s', 'S']) && digits(&start[1..]) && is_channel_letter(letter);
    is_channel.then_some((2, letter, None))
}

fn is_channel_letter(letter: &str) -> bool {
    letter.len() == 1 && ("a"..="l").contains(&letter.to_ascii_lowercase().as_str())
}

/// Degrees of up to three digits.
fn azimuth(digits: &str) -> Option<u16> {
    let is_number =
        (2..=3).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit());
    digits
        .parse()
        .ok()
        .filter(|degrees| is_number && *degrees <= 360)
}

/// The word at the end of a piece without a separator before it, with its place.
fn glued(piece: &str, is_smc: bool) -> Option<(usize, &str, Option<Direction>)> {
    if !piece.is_ascii() {
        return None;
    }
    let letters = piece.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let n_digits = piece.len() - letters.len();
    if n_digits >= 3 && !letters.is_empty() {
        let at = piece.len() - 3;
        azimuth(&piece[at..])?;
        // Behind the number of a station stands the letter of its channel: `2009A090` and `2009B360`.
        let before = letters[..letters.len() - 1].bytes();
        let is_number = before.len() > 2 && before.clone().all(|byte| byte.is_ascii_digit());
        let start = if n_digits == 3 && is_number {
            at - 1
        } else {
            at
        };
        return Some((start, &piece[start..], None));
    }
    let digits = piece.trim_end_matches(|letter: char| letter.is_ascii_alphabetic());
    let at = digits.len();
    let word = &piece[at..];
    if !digits.ends_with(|letter: char| letter.is_ascii_digit()) {
        return None;
    }
    let is_number = digits.len() > 2 && digits.bytes().all(|byte| byte.is_ascii_digit());
    if is_smc && is_number && is_channel_letter(word) {
        return Some((at, word, None));
    }
    let has_code = digits.starts_with(|letter: char| letter.is_ascii_alphabetic());
    let known = BEHIND_CODES
        .iter()
        .any(|known| known.eq_ignore_ascii_case(word));
    let direction = match word.to_ascii_uppercase().as_str() {
        "UD" | "ZUP" => Some(Direction::Vertical),
        "NS" | "EW" | "XTE" | "YLN" => Some(Direction::Horizontal),
        _ => None,
    };
    (known && has_code).then_some((at, word, direction))
}
