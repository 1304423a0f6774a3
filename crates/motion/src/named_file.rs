//! Facts from file names: direction and number of the record, and the files that belong to one record.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ffi::OsStr;

mod pieces;
mod place;
mod quantity;
pub(crate) mod way;

use place::DirectionWord;
pub(crate) use way::Way;

pub use quantity::Quantity;

use crate::Direction;

/// A `NamedFile` holds the facts that the name of a file tells.
///
/// They are weaker than the header of the file, because a name may contain a word by chance. [`of_all`](Self::of_all) compares the names of
/// a folder and finds more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFile {
    /// The name with `*` for the direction: components of one record share it.
    pub stem: String,
    /// The word for the direction, in capitals: `UP`, `180`, `HNE`.
    pub word: Option<String>,
    /// Direction of the component; `None` if the word is an azimuth, or a letter that may mean something else.
    pub direction: Option<Direction>,
    /// Azimuth, up to 360 \[°\]; or a number that looks like one.
    pub azimuth: Option<u16>,
    /// Quantity of the values.
    pub quantity: Option<Quantity>,
    /// Number of the record in PEER's data bases.
    pub rsn: Option<u32>,
    /// Whether the sensor is the lower one of a station of KiK-net: `IWTH25.EW1`, or `NS1` beside `NS2`.
    pub in_borehole: bool,
    pub(crate) way: Option<Way>,
}

impl NamedFile {
    /// Reads one name, without its folder.
    pub fn of(name: impl AsRef<OsStr>) -> Self {
        Self::of_all(&[name]).remove(0)
    }

    /// Reads the names of one folder together, in their order.
    ///
    /// Names that differ only in a word for a direction belong to a common record, wherever the word is. A number is an azimuth only if
    /// another number is a right angle apart, or a vertical component is next to it: `r001`, `r002`, `r091` are three records. A letter
    /// such as `U` is up next to `E` or `N`; letters that count, as in `A`, `B`, `E`, have no meaning.
    pub fn of_all<N: AsRef<OsStr>>(names: &[N]) -> Vec<Self> {
        let names: Vec<_> = names.iter().map(|name| name.as_ref().to_string_lossy()).collect();
        let places: Vec<Vec<DirectionWord>> = names.iter().map(|name| DirectionWord::all_of(name)).collect();
        let mut groups: BTreeMap<&str, Vec<&DirectionWord>> = BTreeMap::new();
        for place in places.iter().flatten() {
            groups.entry(&place.stem).or_default().push(place);
        }
        let read = |(name, places): (&Cow<'_, str>, &Vec<DirectionWord>)| {
            let group = |place: &DirectionWord| &groups[place.stem.as_str()][..];
            let paired = places.iter().find(|place| place.is_paired(group(place)));
            let mut telling = places.iter().filter(|place| place.tells);
            let place = paired.or_else(|| telling.find(|place| !place.is_listed(group(place))));
            let mut places = places.iter();
            Self {
                stem: paired.map_or_else(|| name.to_string(), |place| place.stem.clone()),
                word: place.map(|place| place.word.clone()),
                direction: place.and_then(DirectionWord::direction),
                azimuth: place.and_then(|place| place.azimuth),
                quantity: Quantity::of_name(name),
                rsn: rsn(name),
                in_borehole: places.any(|place| place.is_lower(name, group(place))),
                way: place.and_then(|place| place.way),
            }
        };
        names.iter().zip(&places).map(read).collect()
    }

    /// Returns whether two files are components of one record by their names.
    ///
    /// They are if they share PEER's number of the record. Without numbers they must share the stem and have words for two
    /// directions, a right angle apart: `E` and `W` are two places. Call it on the result of [`of_all`](Self::of_all).
    pub fn same_record(&self, other: &Self) -> bool {
        if let (Some(one), Some(other)) = (self.rsn, other.rsn) {
            return one == other;
        }
        let are_apart = (self.way.zip(other.way)).is_some_and(|(one, other)| one.pairs(other));
        are_apart && self.stem == other.stem && self.rsn == other.rsn && self.word != other.word
    }
}

/// The number after `RSN` or `NGA_no_` at the start of a name.
fn rsn(name: &str) -> Option<u32> {
    let behind = ["RSN", "NGA_NO_"].iter().find_map(|start| {
        let begin = name.get(..start.len())?;
        begin.eq_ignore_ascii_case(start).then(|| &name[start.len()..])
    })?;
    let end = behind.find(|letter: char| !letter.is_ascii_digit());
    behind[..end.unwrap_or(behind.len())].parse().ok()
}
