//! The kinds of numbers that are compared, and two of a kind.

use strum::EnumCount;

/// A kind of number that is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, EnumCount)]
pub enum Compared {
    /// Peak displacement of a floor, relative to it.
    Displacement,
    /// Peak drift of a storey, relative to it.
    Drift,
    /// Peak restoring force of a storey, relative to it.
    RestoringForce,
    /// Displacement of a floor at the end, relative to its peak.
    LastDisplacement,
    /// Transferred momentum of a floor, relative to it.
    Momentum,
    /// Instant at which a touch begins \[s\].
    Start,
    /// Instant at which it ends \[s\]; not of laws that let go before neighbours part.
    End,
    /// Impulse of a touch, relative to the largest of its pair; of the first touch, relative to itself where it is not slight.
    Impulse,
    /// Peak force of a touch, by the same rule.
    PoundingForce,
    /// How many touches a pair has; the distance of unlike numbers is infinite.
    Touches,
    /// What the ledger of the exact run leaves unexplained \[–\].
    Residual,
}

impl Compared {
    /// All of them.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Displacement,
        Self::Drift,
        Self::RestoringForce,
        Self::LastDisplacement,
        Self::Momentum,
        Self::Start,
        Self::End,
        Self::Impulse,
        Self::PoundingForce,
        Self::Touches,
        Self::Residual,
    ];

    /// Its name in text.
    pub fn words(self) -> &'static str {
        match self {
            Self::Displacement => "peak displacement",
            Self::Drift => "peak drift",
            Self::RestoringForce => "peak restoring force",
            Self::LastDisplacement => "last displacement",
            Self::Momentum => "transferred momentum",
            Self::Start => "start of a touch (s)",
            Self::End => "end of a touch (s)",
            Self::Impulse => "impulse",
            Self::PoundingForce => "pounding force",
            Self::Touches => "number of touches",
            Self::Residual => "residual of the energy",
        }
    }
}

/// Where a number is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// A floor, by its place in the row.
    Floor(usize),
    /// A touch of a pair, by its number from 0.
    Touch {
        /// Index of the pair.
        pair: usize,
        /// Number of the touch.
        touch: usize,
    },
    /// A pair.
    Pair(usize),
    /// The run.
    Run,
}

/// A number of two runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Two {
    /// What it is.
    pub what: Compared,
    /// Where.
    pub place: Place,
    /// Its value in the first run, SI.
    pub first: f64,
    /// Its value in the second one.
    pub second: f64,
    /// How far apart they are: relative \[–\], of instants absolute \[s\]; infinite where only one run has the number.
    pub distance: f64,
}
