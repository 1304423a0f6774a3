//! What looks wrong in a file and can yet be right.

use std::fmt;
use std::ops::RangeInclusive;

/// Usual time steps of strong motion \[s\].
pub(crate) const USUAL_STEPS: RangeInclusive<f64> = 1e-4..=0.1;

/// Largest usual peak \[g\]: the largest on record are near 4 g.
pub(crate) const USUAL_PEAK: f64 = 5.0;

/// An `Unusual` is something that looks wrong in a file and can yet be right.
#[derive(Clone, Debug, PartialEq)]
pub enum Unusual {
    /// A time step below 10⁻⁴ s or above 0.1 s.
    TimeStep {
        /// The time step \[s\].
        found: f64,
    },
    /// A peak above 5 g.
    Peak {
        /// Largest magnitude, in multiples of 9.80665 m/s² \[g\].
        found: f64,
    },
    /// Values that are declared to be accelerations, where the file speaks for velocities.
    Velocity {
        /// What the file says.
        found: String,
    },
}

impl Unusual {
    /// Returns what was found, in words.
    pub fn found(&self) -> String {
        match self {
            Self::TimeStep { found } => format!("a time step of {found} s in the file"),
            Self::Peak { found } => format!("a peak of {found:.1} g in the file"),
            Self::Velocity { found } => {
                format!(
                    "{found:?} in the file, which speaks for velocities, declared to be accelerations"
                )
            }
        }
    }

    /// Returns what is usual, in words.
    pub fn usual(&self) -> &'static str {
        match self {
            Self::TimeStep { .. } => "0.0001 to 0.1 s",
            Self::Peak { .. } => "up to 5 g; its unit decides it",
            Self::Velocity { .. } => "the record of an accelerometer, such as channel HNE",
        }
    }
}

impl fmt::Display for Unusual {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "found {}, usual is {}", self.found(), self.usual())
    }
}
