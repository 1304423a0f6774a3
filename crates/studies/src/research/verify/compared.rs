//! Kinds of numbers to compare, a compared pair of numbers, and parts of the work on a scene.

use crate::listed::listed;

/// Distance of the routes that is always allowed: relative \[–\], for instants \[s\].
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
    /// A kind of number to compare.
    pub enum Compared { words: &'static str;
        /// Peak displacement of a floor; the distance is relative to it.
        Displacement = "peak displacement",
        /// Peak drift of a storey; the distance is relative to it.
        Drift = "peak drift",
        /// Peak restoring force of a storey; the distance is relative to it.
        RestoringForce = "peak restoring force",
        /// Displacement of a floor at the end; the distance is relative to its peak.
        LastDisplacement = "last displacement",
        /// Transferred momentum of a floor; the distance is relative to it.
        Momentum = "transferred momentum",
        /// Instant at which a touch begins \[s\].
        Start = "start of a touch (s)",
        /// Instant at which a touch ends \[s\]. Laws that let go before neighbours part do not have it.
        End = "end of a touch (s)",
        /// Impulse of a touch; the distance is relative to the largest impulse of the pair. A first touch that is not slight is relative to
        /// itself.
        Impulse = "impulse",
        /// Peak force of a touch, relative to a force chosen as for the impulse.
        PoundingForce = "pounding force",
        /// Number of touches of a pair; the distance of unequal numbers is infinite.
        Touches = "number of touches",
        /// Peak deformation of a link; the distance is relative to it.
        Deformation = "peak deformation of a link",
        /// Share of the energy that the ledger of the exact run does not explain \[–\].
        Residual = "residual of the energy",
    }
}

/// The place of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberPlace {
    /// The floor with this index in the row.
    Floor(usize),
    /// A touch of a pair.
    Touch {
        /// Index of the pair.
        pair: usize,
        /// Index of the touch, from 0.
        touch: usize,
    },
    /// The pair with this index.
    Pair(usize),
    /// The link with this index.
    Link(usize),
    /// The whole run.
    Run,
}

impl NumberPlace {
    /// The pair and the index of the touch, if the place is a touch.
    pub(super) fn touch(self) -> Option<(usize, usize)> {
        match self {
            Self::Touch { pair, touch } => Some((pair, touch)),
            Self::Floor(_) | Self::Pair(_) | Self::Link(_) | Self::Run => None,
        }
    }
}

/// A number of two runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Two {
    /// Kind of the number.
    pub what: Compared,
    /// Place of the number.
    pub place: NumberPlace,
    /// Value in the first run, in SI units.
    pub first: f64,
    /// Value in the second run, in SI units.
    pub second: f64,
    /// Distance of the values: relative \[–\], for instants absolute \[s\]; infinite if only one run has the number.
    pub distance: f64,
}
