//! The kinds of numbers that are compared, two of a kind, and the parts of the work on a scene.

use crate::listed::listed;

/// Distance of the routes that is always allowed: relative \[–\], of instants \[s\].
pub const ALLOWED: f64 = 1e-12;

listed! {
    /// A part of the work on a scene.
    pub enum Stage { words: &'static str;
        /// The exact run.
        Exact = "the exact run",
        /// The second route.
        SecondRoute = "the second route",
        /// Exact runs under records near the scene's.
        Condition = "the exact runs for the condition",
    }
}

listed! {
    /// A kind of number that is compared.
    pub enum Compared { words: &'static str;
        /// Peak displacement of a floor, relative to it.
        Displacement = "peak displacement",
        /// Peak drift of a storey, relative to it.
        Drift = "peak drift",
        /// Peak restoring force of a storey, relative to it.
        RestoringForce = "peak restoring force",
        /// Displacement of a floor at the end, relative to its peak.
        LastDisplacement = "last displacement",
        /// Transferred momentum of a floor, relative to it.
        Momentum = "transferred momentum",
        /// Instant at which a touch begins \[s\].
        Start = "start of a touch (s)",
        /// Instant at which it ends \[s\]; not of laws that let go before neighbours part.
        End = "end of a touch (s)",
        /// Impulse of a touch, relative to the largest of its pair; of the first touch, relative to itself where it is not slight.
        Impulse = "impulse",
        /// Peak force of a touch, by the same rule.
        PoundingForce = "pounding force",
        /// How many touches a pair has; the distance of unlike numbers is infinite.
        Touches = "number of touches",
        /// What the ledger of the exact run leaves unexplained \[–\].
        Residual = "residual of the energy",
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

impl Place {
    /// The pair, and the number of the touch, if it is one.
    pub(super) fn touch(self) -> Option<(usize, usize)> {
        match self {
            Self::Touch { pair, touch } => Some((pair, touch)),
            Self::Floor(_) | Self::Pair(_) | Self::Run => None,
        }
    }
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
