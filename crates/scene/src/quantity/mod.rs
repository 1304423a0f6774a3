//! The numbers of a run: an entry for each in the tables [`FloorQuantity`] and [`PairQuantity`], from which every file, page and
//! language takes names, units and values.

mod floor;
mod pair;
mod values;

pub use floor::FloorQuantity;
pub use pair::PairQuantity;
pub use values::{AT_ONCE, LEAST_PART, Values, ZERO};

use pounding_text::Unit;

use crate::QuantityGroup;

/// A number that a run gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// Of every floor.
    Floor(FloorQuantity),
    /// Of every pair.
    Pair(PairQuantity),
}

/// An entry of the table: what is known of a number.
#[derive(Debug, Clone, Copy)]
pub struct About {
    /// Its name in files.
    pub name: &'static str,
    /// What it is, in a sentence.
    pub meaning: &'static str,
    /// Its unit.
    pub unit: &'static Unit,
    /// Its name above a column.
    pub heading: &'static str,
    /// Its name in sentences about its error.
    pub words: &'static str,
    /// What kind of number it is.
    pub kind: QuantityKind,
    /// Its value \[SI\], by the place of the floor or the pair.
    pub(crate) of: Take<Option<f64>>,
    /// The group in which its relative error counts; `None` if that is not measured.
    pub group: Option<QuantityGroup>,
    /// What its magnitude counts as at least in a relative error.
    pub(crate) least: Take<f64>,
    /// Name of its absolute error in files; `None` if errors in files are relative, or not measured.
    pub absolute: Option<&'static str>,
    /// The number whose error it has.
    pub error_of: Option<FloorQuantity>,
    /// The number that it is for a storey on the ground, which itself has no such number.
    pub on_ground: Option<FloorQuantity>,
    /// The collision in `summary.json` of which it is a field.
    pub collision: Option<&'static str>,
    /// Its text for people, in the unit that they read.
    text: fn(f64) -> String,
}

/// How to take something from a run, by the place of the floor or the pair.
type Take<T> = fn(&Values<'_>, usize) -> T;

/// Kinds of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum QuantityKind {
    /// Of the model, whatever the run does.
    Model,
    /// Value of largest magnitude of something that goes to both sides, with its sign.
    Peak,
    /// Instant of another number.
    Instant,
    /// Instant of the first event: the earlier, the severer.
    First,
    /// What is left over of a peak, next to nothing beside it.
    Residual(FloorQuantity),
    /// Largest value of something that is not negative.
    Largest,
    /// Sum.
    Total,
    /// Whole number.
    Count,
    /// Least value: the less, the severer.
    Least,
}

/// A table of the numbers of a kind of place: a line for each with its variant, its name in files, its meaning and its entry. Lines stand
/// in the order of columns. A line with `#[serde(skip_deserializing)]` cannot be an output of a sweep.
macro_rules! quantities {
    ($(#[$of:meta])* $Quantity:ident, $Place:ident:
        $($(#[$sweep:meta])* $Variant:ident($name:tt, $meaning:tt) = $about:expr;)+) => {
        $(#[$of])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        pub enum $Quantity {
            $(#[doc = $meaning] $(#[$sweep])* #[serde(rename = $name)] $Variant,)+
        }

        impl $Quantity {
            /// All of them, in the order of columns.
            pub const ALL: &[Self] = &[$(Self::$Variant),+];

            /// Its entry of the table.
            pub fn about(self) -> &'static About {
                const TABLE: &[About] = &[$(About { name: $name, meaning: $meaning, ..$about }),+];
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

impl About {
    /// An entry without name and meaning, which the table adds: of a number with this unit, this name above a column and this value.
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

    /// An instant, which stands beside its number.
    const fn instant(of: Take<Option<f64>>) -> Self {
        Self::new(&Unit::SECOND, "at", of).kind(QuantityKind::Instant)
    }

    const fn kind(self, kind: QuantityKind) -> Self {
        Self { kind, ..self }
    }

    /// With a relative error, under this name in sentences.
    const fn measured(self, group: QuantityGroup, words: &'static str) -> Self {
        Self {
            group: Some(group),
            words,
            ..self
        }
    }

    /// Its name in the `errors` of `summary.json`: a relative error has no unit. `None` if it has none there.
    pub fn error_name(&self) -> Option<&'static str> {
        let is_relative = self.group.is_some() && self.kind != QuantityKind::Count;
        let relative = is_relative.then(|| self.name.strip_suffix(self.unit.suffix).unwrap_or(self.name));
        self.absolute.or(relative)
    }

    /// An SI value in words, in the unit that people read, by the acceleration of gravity \[m/s²\].
    pub fn text_of(&self, value: f64, gravity: f64) -> String {
        (self.text)(self.unit.of(value, gravity))
    }

    /// The unit that people read, in brackets; empty if they read none.
    pub fn shown_unit(&self) -> String {
        match self.unit.shown {
            "" => String::new(),
            unit => format!("[{unit}]"),
        }
    }

    /// Its name above a column with the unit that people read.
    pub fn title(&self) -> String {
        format!("{} {}", self.heading, self.shown_unit()).trim_end().into()
    }

    /// Whether it is an instant, of which no part is a change.
    pub fn is_instant(&self) -> bool {
        matches!(self.kind, QuantityKind::Instant | QuantityKind::First)
    }
}

impl Quantity {
    /// All numbers of floors, then those of pairs, in the order of columns.
    pub fn all() -> impl Iterator<Item = Self> {
        let floors = FloorQuantity::ALL.iter().map(|one| Self::Floor(*one));
        floors.chain(PairQuantity::ALL.iter().map(|one| Self::Pair(*one)))
    }

    /// Its entry of the table.
    pub fn about(self) -> &'static About {
        match self {
            Self::Floor(quantity) => quantity.about(),
            Self::Pair(quantity) => quantity.about(),
        }
    }

    /// The number of this name in files.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|one| one.about().name == name)
    }

    /// Every number whose relative error is measured: of floors group by group, then of pairs. Ductility and drift ratio have that of the
    /// drift. Instants of peaks have none: they jump if two peaks are nearly equal.
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

    /// Of a number of a storey on the ground, the number that it is.
    #[must_use]
    pub fn of_storey(self, is_upper: bool) -> Self {
        match self.about().on_ground {
            Some(on_ground) if !is_upper => on_ground.into(),
            _ => self,
        }
    }
}
