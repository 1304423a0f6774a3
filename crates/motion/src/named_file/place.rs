//! Positions in a name at which a word for a direction may be.

use std::borrow::Cow;

use super::pieces::{is_number, is_parted, pieces, uncounted, without_marks};
use super::quantity::Quantity;
use super::way::{COMPASS, Way, is_of_kiknet};
use crate::Direction;

/// Words in front of the number of a channel, in capitals: `Comp1` and `Comp2` belong to one record.
const CHANNELS: &str = "COMP COMPONENT CH CHAN CHANNEL DIR DIRECTION";

/// Words in front of the number of a record, in capitals: `rec010` and `rec100` are two records.
const COUNTED: &str = "R GM EQ REC RECORD NO RUN MOTION QUAKE SAMPLE TEST CASE SIM FILE";

/// Words in front of `up` and `down`, in capitals, that describe an action: `scaled_up`, `BackUp`.
const DONE: &str = "SCALE SCALED SET BACK RAMP START BUILD";

/// A word for a direction in a name. It may also be a letter or number that shows that others only count.
pub(super) struct DirectionWord {
    /// The name with `*` for the word.
    pub(super) stem: String,
    /// The word in capitals.
    pub(super) word: String,
    pub(super) way: Option<Way>,
    pub(super) azimuth: Option<u16>,
    /// Whether the word tells the direction without other names.
    pub(super) tells: bool,
    /// Whether the word may be part of a town's name: `North_Hollywood`.
    may_be_town: bool,
}

impl DirectionWord {
    /// The places of a name, last pieces first; after them those of the name without the marks of copies.
    pub(super) fn all_of(name: &str) -> Vec<Self> {
        let mut places = Name::of(name).places();
        if let Cow::Owned(bare) = without_marks(name) {
            places.extend(Name::of(&bare).places());
        }
        places
    }

    pub(super) fn direction(&self) -> Option<Direction> {
        match self.way? {
            Way::Upright(_) => Some(Direction::Vertical),
            Way::Level(..) if self.azimuth.is_none() => Some(Direction::Horizontal),
            Way::Level(..) | Way::Channel => None,
        }
    }

    /// Whether letters or numbers at this position in other names show that they only count files.
    pub(super) fn is_listed(&self, group: &[&Self]) -> bool {
        let is_digit = |word: &str| word.starts_with(|letter: char| letter.is_ascii_digit());
        let mut others = group.iter();
        if is_of_kiknet(&self.word) {
            return others.any(|other| other.word.ends_with('3'));
        }
        (self.word.len() == 1 || is_digit(&self.word))
            && others.any(|other| other.way.is_none() && is_digit(&other.word) == is_digit(&self.word))
    }

    /// Whether another name with this stem has a word for another direction, and no name shows that these are different places.
    pub(super) fn is_paired(&self, group: &[&Self]) -> bool {
        let both =
            |one: &Self, other: &Self, are: fn(Way, Way) -> bool| (one.way.zip(other.way)).is_some_and(|(one, other)| are(one, other));
        let clashes = |one: &Self| group.iter().any(|other| both(one, other, Way::clashes));
        let pairs = |other: &&Self| {
            other.word != self.word
                && both(self, other, Way::pairs)
                && (!self.may_be_town || other.direction() == Some(Direction::Vertical))
                && !clashes(other)
        };
        !self.is_listed(group) && !clashes(self) && group.iter().any(pairs)
    }

    /// Whether the word belongs to the lower sensor of a KiK-net station.
    pub(super) fn is_lower(&self, name: &str, group: &[&Self]) -> bool {
        let has_code = name.as_bytes().get(..6).is_some_and(|code| {
            let is_word = code[..3].iter().all(u8::is_ascii_uppercase) && code[3] == b'H';
            is_word && code[4..].iter().all(u8::is_ascii_digit)
        });
        let is_upper = |other: &&Self| is_of_kiknet(&other.word) && other.word.ends_with('2');
        is_of_kiknet(&self.word) && self.word.ends_with('1') && (has_code || group.iter().any(is_upper)) && !self.is_listed(group)
    }
}

/// A name cut into pieces.
struct Name<'n> {
    name: &'n str,
    pieces: Vec<(usize, &'n str)>,
}

impl<'n> Name<'n> {
    fn of(name: &'n str) -> Self {
        Self {
            name,
            pieces: pieces(name).collect(),
        }
    }

    /// The words of each piece, last piece first: the ends of the piece, longest first, with and without a number.
    fn places(&self) -> Vec<DirectionWord> {
        let mut places = Vec::new();
        for (index, (_, piece)) in self.pieces.iter().enumerate().rev() {
            let letters = uncounted(piece).len();
            let is_counted = (1..=2).contains(&(piece.len() - letters));
            for (start, _) in piece.char_indices() {
                places.extend(self.place(index, start, piece.len()));
                if start == 0 {
                    places.extend(self.pair(index));
                }
                if is_counted && start < letters {
                    let place = self.place(index, start, letters);
                    places.extend(place.filter(|place| place.way.is_some()));
                }
            }
        }
        places
    }

    fn made(&self, start: usize, end: usize, way: Option<Way>) -> DirectionWord {
        let before = self.name[..start].trim_end_matches(['-', '_', ' ']);
        DirectionWord {
            // `A-ELC180` and `A-ELC-UP` belong to one record.
            stem: format!("{before}*{}", &self.name[end..]),
            word: self.name[start..end].to_ascii_uppercase(),
            way,
            azimuth: None,
            tells: false,
            may_be_town: false,
        }
    }

    /// A word in two pieces: `N-S`.
    fn pair(&self, index: usize) -> Option<DirectionWord> {
        let (at, piece) = self.pieces[index];
        let (next_at, next) = self.pieces.get(index + 1)?;
        let way = Way::of(&format!("{piece}-{next}").to_ascii_uppercase())?;
        let mut place = self.made(at, next_at + next.len(), Some(way));
        place.tells = true;
        Some(place)
    }

    /// The word between two positions of a piece, if it is one.
    fn place(&self, index: usize, start: usize, end: usize) -> Option<DirectionWord> {
        let (at, piece) = self.pieces[index];
        let mut place = self.made(at + start, at + end, None);
        let inner = &piece[..start];
        let before = if start == 0 { self.piece(index.wrapping_sub(1)) } else { inner };
        if let Some(digits) = number_of(inner, &place.word) {
            (place.way, place.azimuth) = of_number(digits, &before.to_ascii_uppercase(), inner);
            return Some(place);
        }
        if self.is_channel(index, inner, &place.word) {
            place.way = Some(Way::Channel);
            return Some(place);
        }
        let is_apart = start == 0 || is_parted(piece, start);
        place.way = Way::of(&place.word);
        let is_known = if place.way.is_some() {
            is_apart || place.word.len() > 1 || "XYZ".contains(&place.word)
        } else {
            let is_roman = start == 0 && place.word.bytes().all(|letter| b"IVX".contains(&letter));
            is_apart && (place.word.len() == 1 || is_roman)
        };
        place.tells = is_apart && self.tells(index, start, end, &before.to_ascii_uppercase());
        let mut next = self.piece(index + 1).chars();
        let is_name = next.next().is_some_and(char::is_uppercase) && next.next().is_some_and(char::is_lowercase);
        place.may_be_town = index == 0 && is_name && ["NORTH", "EAST", "SOUTH", "WEST"].contains(&&*place.word);
        is_known.then_some(place)
    }

    fn piece(&self, index: usize) -> &'n str {
        self.pieces.get(index).map_or("", |(_, piece)| piece)
    }

    /// Whether the word tells a direction at its position, for any file.
    fn tells(&self, index: usize, start: usize, end: usize, before: &str) -> bool {
        let (at, piece) = self.pieces[index];
        let word = piece[start..end].to_ascii_uppercase();
        let is_last = self.is_last(index);
        let is_whole = start == 0 && end == piece.len();
        let is_counted = is_number(&self.piece(index + 1).chars().take(1).collect::<String>());
        match (Way::of(&word), word.as_str()) {
            (None, _) => false,
            // `T045.00N`.
            (_, "E" | "N" | "U" | "Z") if start > 0 => self.is_ending(index) && start == 2 && is_number(&piece[..2]),
            (_, "U") => false,
            (_, "L" | "T") if end < piece.len() => is_last && at > 0,
            // Versions are `v2`, `v 2` and `ver 2`.
            (_, "V") => is_whole && (is_last || (index > 0 && !is_counted)),
            (_, "VER" | "DN") => is_whole && is_last,
            (_, "UP" | "DOWN") => DONE.split(' ').all(|done| done != before),
            _ if !is_whole => word.len() > 1,
            (Some(Way::Upright(_)), _) => true,
            _ => is_last || (2..=3).contains(&word.len()),
        }
    }

    /// Whether the word is the channel letter of the USGS or of the University of Southern California: `1895a.smc`, `.s0a`.
    fn is_channel(&self, index: usize, inner: &str, word: &str) -> bool {
        let digits = inner.strip_prefix(['s', 'S']).unwrap_or(inner);
        let is_smc = index + 2 == self.pieces.len() && self.piece(index + 1).eq_ignore_ascii_case("smc");
        let is_place = match (inner.len(), digits.len()) {
            (2, 1) => self.is_ending(index),
            (n, n_digits) => is_smc && n > 2 && n == n_digits,
        };
        is_place && is_number(digits) && word.len() == 1 && ("A"..="L").contains(&word)
    }

    fn is_ending(&self, index: usize) -> bool {
        index + 1 == self.pieces.len() && self.name[..self.pieces[index].0].ends_with('.')
    }

    /// Whether only words for a quantity and the extension follow a piece.
    fn is_last(&self, index: usize) -> bool {
        (index + 1..self.pieces.len()).all(|index| self.is_ending(index) || Quantity::of_word(self.piece(index)).is_some())
    }
}

/// The digits of a word that is a number: of `090`, of `090DEG`, of `A090` after a station's number, and the last three of `06140`.
fn number_of<'w>(inner: &str, word: &'w str) -> Option<&'w str> {
    let mut digits = word.strip_suffix("DEG").unwrap_or(word);
    let n_before = inner.len() - uncounted(inner).len();
    let is_end = digits.len() == 3 && n_before <= 2 && n_before < inner.len();
    let mut is_apart = n_before == 0 || is_end;
    // A channel letter follows the number of a station: `2009A090` and `2009B360`.
    if word.len() == 4 && n_before > 2 && n_before == inner.len() {
        (digits, is_apart) = (word.get(1..)?, true);
    }
    (is_apart && is_number(digits)).then_some(digits)
}

/// The way and the azimuth of a number: it is a channel, an azimuth, or counts files.
fn of_number(digits: &str, before: &str, inner: &str) -> (Option<Way>, Option<u16>) {
    let is_in = |words: &str| words.split(' ').any(|word| word == before);
    let number: Option<u16> = digits.parse().ok().filter(|number| *number <= 360);
    if is_in(CHANNELS) && (1..=3).contains(&number.unwrap_or(0)) {
        return (Some(Way::Channel), None);
    }
    let is_long = digits.len() == 3 || (digits.len() == 2 && inner.is_empty());
    let is_round = |number: u16| digits.len() <= 3 && number.is_multiple_of(90);
    let azimuth = number.filter(|number| is_round(*number) || (is_long && !before.is_empty() && !is_in(COUNTED)));
    let way = azimuth.map(|degrees| Way::Level(COMPASS, degrees % 360));
    (way, azimuth)
}
