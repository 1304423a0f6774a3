//! Collapse of a storey under gravity, which ends a run, and the drift beyond which gravity alone would bring it down.

use pounding_solver::Leaning;

use super::Simulation;
use crate::{Floor, Scene, StoreyProperties};

/// A storey that collapses under gravity: the run ends there, with everything until then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collapse {
    /// Index of the floor above the storey, in the order of the row.
    pub floor: usize,
    /// Index of the structure, from the left.
    pub structure: usize,
    /// Number of the storey, from 1.
    pub storey: usize,
    /// Instant at which its drift passes [`Scene::collapse_drift_ratio`] of its height \[s\].
    pub time_s: f64,
}

impl Scene {
    /// Drift over the height of a storey at which it counts as collapsed, unless the scene says otherwise \[–\]. A convention: no column
    /// stands there.
    pub const COLLAPSE_DRIFT: f64 = 0.2;

    /// Drift over the height of a storey under gravity at which it counts as collapsed \[–\].
    pub fn collapse_drift(&self) -> f64 {
        self.collapse_drift_ratio.unwrap_or(Self::COLLAPSE_DRIFT)
    }
}

impl StoreyProperties {
    /// Drift beyond which gravity pulls more than the columns can hold \[m\]; `None` if they always hold it, as elastic columns and a k ≥ P/h
    /// do.
    ///
    /// After yielding the columns give at most (1 − a) `f_y` + a k d, and gravity takes P/h d.
    pub fn unstable_drift_m(&self) -> Option<f64> {
        let columns = self.columns;
        let hardening = columns.hardening_ratio.unwrap_or(0.0);
        let lost = self.gravity_n_per_m - hardening * columns.stiffness_n_per_m;
        columns
            .yield_force_n
            .filter(|_| lost > 0.0)
            .map(|force| (1.0 - hardening) * force / lost)
    }
}

impl Simulation {
    /// Drift at which the storey below a floor of the row counts as collapsed \[m\]; infinite if it never does.
    pub fn collapse_drift_m(&self, floor: usize) -> f64 {
        self.leaning(&self.floors.all()[floor]).falls_at
    }

    /// Gravity on the storey below a floor.
    pub(super) fn leaning(&self, floor: &Floor) -> Leaning {
        let Some(made) = floor.made_of.filter(|made| made.gravity_n_per_m > 0.0) else {
            return Leaning::default();
        };
        let unstable = made.unstable_drift_m();
        // Isolators that hold their weight may move as far as they like.
        let falls = made.height_m.filter(|_| unstable.is_some() || !floor.is_isolation_layer());
        Leaning {
            lost: made.gravity_n_per_m,
            unstable_at: unstable.unwrap_or(f64::INFINITY),
            falls_at: falls.map_or(f64::INFINITY, |height| self.scene.collapse_drift() * height),
        }
    }

    /// The collapse of a floor's storey at an instant \[s\].
    pub(super) fn collapse(&self, (floor, time_s): (usize, f64)) -> Collapse {
        Collapse {
            floor,
            structure: self.floors.all()[floor].structure,
            storey: self.floors.storey_of(floor),
            time_s,
        }
    }
}
