//! Words for the direction of a component.

use super::pieces::is_number;
use crate::direction::is_channel_end;

/// The direction of a component according to a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// Up or down. If it needs another word next to it, that word's kind.
    Upright(Option<char>),
    /// Along the ground: the kind of the word, and its degrees.
    Level(char, u16),
    /// One of several channels of a record.
    Channel,
}

/// The kind of compass points and azimuths.
pub(crate) const COMPASS: char = 'N';

/// Words for directions, in capitals.
const WORDS: [(&str, Way); 14] = {
    use Way::{Level, Upright};
    [
        (
            "UP UD U-D UP-DOWN UPDOWN V VER VRT VERT VERTIC VERTICAL Z ZUP DOWN DWN DN",
            Upright(None),
        ),
        ("U", Upright(Some(COMPASS))),
        ("N NS N-S NORTH NORTH-SOUTH NORTE", Level(COMPASS, 0)),
        ("E EW E-W EAST EAST-WEST ESTE", Level(COMPASS, 90)),
        ("S SOUTH", Level(COMPASS, 180)),
        ("W WEST", Level(COMPASS, 270)),
        ("X XTE", Level('X', 0)),
        ("Y YLN", Level('X', 90)),
        ("H H1", Level('H', 0)),
        ("H2", Level('H', 90)),
        ("L LN LON LONG LONGITUDINAL R RAD RADIAL", Level('L', 0)),
        ("T TR TRA TRAN TRANS TRANSVERSE TRANSVERSAL TANGENTIAL", Level('L', 90)),
        ("FN SN NORMAL", Level('F', 0)),
        ("FP SP PARALLEL", Level('F', 90)),
    ]
};

/// Largest deviation from a right angle between two components \[°\]: Lucerne 1992 has 260 and 345.
const SLACK: u16 = 5;

impl Way {
    /// The way of a word in capitals: `UP`, `HNE`, `N21E`, `NS2`.
    pub(crate) fn of(word: &str) -> Option<Self> {
        let known = |word: &str| {
            let is = |(known, _): &&(&str, Self)| known.split(' ').any(|known| known == word);
            WORDS.iter().find(is).map(|(_, way)| *way)
        };
        let of_code = || {
            let is_code = word.starts_with(|band| "BCDEFGHLMS".contains(band));
            let end = word.get(2..3).filter(|_| is_code && is_channel_end(word, "ZNE12"));
            end.and_then(|end| known(end).or_else(|| known(&format!("H{end}"))))
        };
        let counted = is_of_kiknet(word).then(|| &word[..2]);
        known(counted.unwrap_or(word)).or_else(|| bearing(word)).or_else(of_code)
    }

    /// Whether two words are those of two components of one record.
    pub(crate) fn pairs(self, other: Self) -> bool {
        match (self, other) {
            (Self::Channel, Self::Channel) => true,
            (Self::Level(kind, one), Self::Level(of_other, other)) => kind == of_other && is_right(one, other),
            (Self::Upright(beside), Self::Level(kind, _)) | (Self::Level(kind, _), Self::Upright(beside)) => {
                beside.is_none_or(|beside| beside == kind)
            }
            _ => false,
        }
    }

    /// Whether two words mean two places: `E` and `W`.
    pub(super) fn clashes(self, other: Self) -> bool {
        let are_alike = matches!((self, other), (Self::Level(kind, _), Self::Level(of_other, _)) if kind == of_other);
        are_alike && self != other && !self.pairs(other)
    }
}

/// The degrees from one compass point to another: `N21E`.
fn bearing(word: &str) -> Option<Way> {
    let degrees = word.strip_prefix(['N', 'S'])?.strip_suffix(['E', 'W'])?;
    let degrees: u16 = degrees.parse().ok().filter(|degrees| *degrees <= 90)?;
    let from_north = match (word.starts_with('N'), word.ends_with('E')) {
        (true, true) => degrees,
        (false, true) => 180 - degrees,
        (false, false) => 180 + degrees,
        (true, false) => 360 - degrees,
    };
    Some(Way::Level(COMPASS, from_north % 360))
}

/// Whether two azimuths differ by one or three right angles.
fn is_right(one: u16, other: u16) -> bool {
    let apart = one.abs_diff(other);
    let is = |right: u16| apart.abs_diff(right) <= SLACK;
    is(90) || is(270)
}

/// Whether a word is a component of KiK-net, which numbers its sensors: `NS1` is the lower one, `NS2` the upper one.
pub(super) fn is_of_kiknet(word: &str) -> bool {
    let words = ["NS", "EW", "UD"];
    let digit = words.iter().find_map(|start| word.strip_prefix(start));
    digit.is_some_and(|digit| digit.len() == 1 && is_number(digit))
}
