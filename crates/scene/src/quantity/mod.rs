//! The numbers of a run. The tables [`FloorQuantity`], [`PairQuantity`] and
//! [`LinkQuantity`] have an entry for each; every file, page and language takes
//! names, units and values from them.

mod floor;
mod link;
mod pair;
mod values;

pub use floor::FloorQuantity;
pub use link::LinkQuantity;
pub use pair::PairQuantity;
pub use values::RunValues;

use pounding_text::Unit;

use crate::QuantityGroup;

/// A number of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// A number of every floor.
    Floor(FloorQuantity),
    /// A number of every pair.
    Pair(PairQuantity),
    /// A number of every link.
    Link(LinkQuantity),
}

/// An entry of the table: the description of a number.
#[derive(Debug, Clone, Copy)]
pub struct QuantityEntry {
    /// Name in files.
    pub name: &'static str,
    /// Meaning, in a sentence.
    pub meaning: &'static str,
    /// Unit.
    pub unit: &'static Unit,
    /// Name above a column.
    pub heading: &'static str,
    /// Name in sentences about its error.
    pub words: &'static str,
    /// Kind of the number.
    pub kind: QuantityKind,
    /// Value \[SI\] at a floor or a pair.
    pub(crate) of: Take<Option<f64>>,
    /// Group in which its relative error counts; `None` if this error is not measured.
    pub group: Option<QuantityGroup>,
    /// Least magnitude that a relative error is divided by.
    pub(crate) least: Take<f64>,
    /// Name of its absolute error in files; `None` if errors in files are relative, or not measured.
    pub absolute: Option<&'static str>,
    /// Number whose error stands for its own error.
    pub error_of: Option<FloorQuantity>,
    /// Number that replaces it for a storey on the ground; `None` if that storey has it, too.
    pub on_ground: Option<FloorQuantity>,
    /// Collision in `summary.json` with this number as a field.
    pub collision: Option<&'static str>,
    /// Text for people, in the unit that they read.
    text: fn(f64) -> String,
}

/// A function that takes a value from a run, at a floor or a pair.
type Take<T> = fn(&RunValues<'_>, usize) -> T;

/// Kinds of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum QuantityKind {
    /// Property of the model, independent of the run.
    Model,
    /// Value of largest magnitude with its sign, of something that goes to both sides.
    Peak,
    /// Instant of another number.
    Instant,
    /// Instant of the first event: the earlier, the severer.
    First,
    /// Remainder of a peak, usually much smaller than the peak.
    Residual(FloorQuantity),
    /// Largest value of something that is not negative.
    Largest,
    /// Sum.
    Total,
    /// Whole number.
    Count,
    /// Least value: the smaller, the severer.
    Least,
}

/// A table of the numbers of floors or of pairs, in the order of columns. A line has the variant, its name in files, its meaning and its
/// entry. A line with `#[serde(skip_deserializing)]` cannot be an output of a sweep.
macro_rules! quantities {
    ($(#[$of:meta])* $Quantity:ident, $Place:ident:
        $($(#[$sweep:meta])* $Variant:ident($name:tt, $meaning:tt) = $about:expr;)+) => {
        $(#[$of])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        pub enum $Quantity {
            $(#[doc = $meaning] $(#[$sweep])* #[serde(rename = $name)] $Variant,)+
        }

        impl $Quantity {
            /// Every number, in the order of columns.
            pub const ALL: &[Self] = &[$(Self::$Variant),+];

            /// Entry of the table.
            pub fn about(self) -> &'static QuantityEntry {
                const TABLE: &[QuantityEntry] = &[$(QuantityEntry { name: $name, meaning: $meaning, ..$about }),+];
                &TABLE[self as usize]
            }
        }

        impl From<$Quantity> for crate::Quantity {
            fn from(quantity: $Quantity) -> Self {
                Self::$Place(quantity)
            }
        }
    };
}
use quantities;

impl QuantityEntry {
    /// An entry with this unit, name above a column and value. The table adds its name and its meaning.
    const fn new(unit: &'static Unit, heading: &'static str, of: Take<Option<f64>>) -> Self {
        Self {
            name: "",
            meaning: "",
            unit,
            heading,
            words: heading,
            kind: QuantityKind::Largest,
            of,
            group: None,
            least: |_, _| 0.0,
            absolute: None,
            error_of: None,
            on_ground: None,
            collision: None,
            text: unit.reader(),
        }
    }

    /// An instant, in a column beside its number.
    const fn instant(of: Take<Option<f64>>) -> Self {
        Self::new(&Unit::SECOND, "at", of).kind(QuantityKind::Instant)
    }

    const fn kind(self, kind: QuantityKind) -> Self {
        Self { kind, ..self }
    }

    /// Adds a relative error, with this name in sentences.
    const fn measured(self, group: QuantityGroup, words: &'static str) -> Self {
        Self {
            group: Some(group),
            words,
            ..self
        }
    }

    /// Name in the `errors` of `summary.json`, where a relative error has no unit; `None` if it has none there.
    pub fn error_name(&self) -> Option<&'static str> {
        let is_relative = self.group.is_some() && self.kind != QuantityKind::Count;
        let relative = is_relative.then(|| self.name.strip_suffix(self.unit.suffix).unwrap_or(self.name));
        self.absolute.or(relative)
    }

    /// Writes an SI value in the unit that people read, for an acceleration of gravity \[m/s²\].
    pub fn text_of(&self, value: f64, gravity: f64) -> String {
        (self.text)(self.unit.of(value, gravity))
    }

    /// Unit that people read, in brackets; empty if they read none.
    pub fn shown_unit(&self) -> String {
        match self.unit.shown {
            "" => String::new(),
            unit => format!("[{unit}]"),
        }
    }

    /// Whether it is an instant: a relative change of it has no meaning.
    pub fn is_instant(&self) -> bool {
        matches!(self.kind, QuantityKind::Instant | QuantityKind::First)
    }
}

impl Quantity {
    /// All numbers of floors, then those of pairs and of links, in the order of columns.
    pub fn all() -> impl Iterator<Item = Self> {
        let floors = FloorQuantity::ALL.iter().map(|one| Self::Floor(*one));
        let pairs = floors.chain(PairQuantity::ALL.iter().map(|one| Self::Pair(*one)));
        pairs.chain(LinkQuantity::ALL.iter().map(|one| Self::Link(*one)))
    }

    /// Entry of the table.
    pub fn about(self) -> &'static QuantityEntry {
        match self {
            Self::Floor(quantity) => quantity.about(),
            Self::Pair(quantity) => quantity.about(),
            Self::Link(quantity) => quantity.about(),
        }
    }

    /// Finds a number by its name in files.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|one| one.about().name == name)
    }

    /// Every number with a relative error: of floors group by group, then of pairs. Ductility and drift ratio share the error of the drift.
    /// Instants of peaks have none, because they jump if two peaks are nearly equal.
    pub fn compared() -> impl Iterator<Item = Self> {
        let measured = |one: &Self| one.about().group.is_some();
        let (mut floors, pairs): (Vec<_>, Vec<_>) = Self::all().filter(measured).partition(|one| matches!(one, Self::Floor(_)));
        floors.sort_by_key(|one| one.about().group);
        floors.into_iter().chain(pairs)
    }

    /// Whether it is a value of largest magnitude of something that goes to both sides.
    pub fn is_peak(self) -> bool {
        self.about().kind == QuantityKind::Peak
    }

    /// Returns the number that replaces it for a storey on the ground, else itself.
    #[must_use]
    pub fn of_storey(self, is_upper: bool) -> Self {
        match self.about().on_ground {
            Some(on_ground) if !is_upper => on_ground.into(),
            _ => self,
        }
    }
}
