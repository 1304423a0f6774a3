//! The columns of a storey: their branch, and the constants of their loop.

use crate::exact::bend::Bend;
use crate::{Hysteresis, Knee};

/// The branch of a piecewise-linear restoring force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Branch {
    Elastic,
    /// Yielding to the right. Without hardening the force is > 0.
    Right,
    /// Yielding to the left.
    Left,
}

/// The line on which the force of columns lies while they do not yield.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LoadingLine {
    /// The line through zero: nothing has yielded.
    FirstLoading,
    /// The line shifted by the plastic displacement.
    Shifted,
}

impl LoadingLine {
    /// The line of a force h that yields at a limit \[N\].
    pub(super) fn of(force: f64, limit: f64) -> Self {
        if force.abs() < limit { Self::FirstLoading } else { Self::Shifted }
    }
}

/// The constants of a loop, as a member stores them.
pub(super) struct LoopConstants {
    pub(super) stiffness: f64,
    pub(super) hardened_stiffness: f64,
    pub(super) hysteretic_stiffness: f64,
    pub(super) limit: f64,
    pub(super) bend: Option<Box<Bend>>,
}

impl LoopConstants {
    pub(super) fn new(hysteresis: Hysteresis) -> Self {
        let Hysteresis {
            stiffness,
            mut hardening,
            yield_force,
            knee,
        } = hysteresis;
        // Columns that never yield are elastic.
        if yield_force.is_infinite() && knee != Knee::Rigid {
            hardening = 0.0;
        }
        let hysteretic_stiffness = (1.0 - hardening) * stiffness;
        let limit = if knee == Knee::Rigid {
            yield_force
        } else {
            (1.0 - hardening) * yield_force
        };
        let bend = match knee {
            Knee::Smooth(smoothness) if yield_force.is_finite() => Some(Box::new(Bend::new(smoothness, hysteretic_stiffness, limit))),
            Knee::Smooth(_) | Knee::Sharp | Knee::Rigid => None,
        };
        Self {
            stiffness,
            hardened_stiffness: hardening * stiffness,
            hysteretic_stiffness,
            limit,
            bend,
        }
    }

    /// The hysteretic part h of the force at a drift \[m\].
    pub(super) fn hysteretic_force(&self, force: f64, drift: f64) -> f64 {
        if self.hardened_stiffness.abs() > 0.0 {
            force - self.hardened_stiffness * drift
        } else {
            force
        }
    }
}
