//! What a user writes: a row of structures under a record, with its settings.

pub(crate) mod budget;
mod building;
pub(crate) mod check;
mod choice;
mod columns;
mod damping;
pub(crate) mod error;
pub(crate) mod fault;
mod generated;
mod method;
mod neighbour;
mod numbers;
pub(crate) mod position;
pub(crate) mod processed;
mod processing;
pub(crate) mod reading;
mod record;
pub(crate) mod schema;
mod structure;
mod tree;
mod unfit;

use pounding_contact::ContactLaw;
use pounding_text::Refused;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use budget::Patience;

pub use budget::RunBudget;
pub use building::{Building, Storey};
pub use columns::{BoucWen, Columns};
pub use damping::Damping;
pub use generated::{Generated, Ground, Stochastic};
pub use method::{Jumps, Method, Start};
pub use neighbour::{DrawnNeighbour, Neighbour, UnknownNeighbour};
pub use numbers::{SetNumber, set_number};
pub use processing::{Detrend, FilterBand, ScaleTo};
pub use record::{FileUse, RecordUse, STANDARD_GRAVITY, Source, Unit, direction};
pub use structure::SdofFile;
pub use structure::{Sdof, Structure};

/// One row of structures under one record, with the method that integrates it.
///
/// Structures stand left to right. Checking happens when the scene is [prepared](crate::Simulation).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Name, unique within its study.
    pub name: String,
    /// The record and how it is used.
    pub record: RecordUse,
    /// Duration of the run \[s\], a whole number of time steps; without it that of the record, from its last arrival on, and
    /// two of the longest natural periods after it, made a whole number of steps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub duration_s: Option<f64>,
    /// The structures and walls, from left to right.
    pub structures: Vec<Structure>,
    /// One contact between each structure and its right neighbour; absent when the structures stand apart.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contacts: Option<Vec<Contact>>,
    /// What stands on the right of the last structure, if nobody knows it; only `assess` takes it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub neighbour: Option<Neighbour>,
    /// When the ground motion arrives at each structure and wall \[s\], ≥ 0, from left to right; absent where all are shaken at
    /// once. A wave of apparent velocity v arrives at a base a distance x further along its way x/v later.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arrivals_s: Option<Vec<f64>>,
    /// The method of time integration; without it the exact one.
    #[serde(default = "exact", deserialize_with = "choice::one")]
    pub method: Method,
    /// What a run may cost before it is given up.
    #[serde(default, skip_serializing_if = "RunBudget::is_usual")]
    pub budget: RunBudget,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

fn exact() -> Method {
    Method::EXACT
}

/// Periods of free vibration after a record where a scene does not say how long it lasts: the second one is there to see
/// that the first has the peak.
const PERIODS_AFTER_RECORD: f64 = 2.0;

impl Scene {
    /// Duration of the run \[s\] under a record of some duration \[s\].
    ///
    /// # Panics
    /// Never: only who has a deadline gives up.
    pub fn duration_under(&self, record: f64) -> f64 {
        let found = self.duration_within(record, Patience::ENDLESS);
        found.expect("there is no deadline")
    }

    /// The same, as long as somebody waits.
    pub(crate) fn duration_within(&self, record: f64, patience: Patience) -> Result<f64, Refused> {
        if let Some(duration) = self.duration_s {
            return Ok(duration);
        }
        let mut longest: f64 = 0.0;
        for structure in &self.structures {
            longest = longest.max(structure.period().unwrap_or(0.0));
            patience.look()?;
        }
        let arrivals = self.arrivals_s.iter().flatten();
        let last = arrivals.copied().fold(0.0, f64::max);
        let least = record + last + PERIODS_AFTER_RECORD * longest;
        Ok(match self.method.time_step() {
            Some(step) => (least / step - 1e-6).ceil() * step,
            None => least,
        })
    }

    /// Whether some contact is impulsive.
    pub fn is_impulsive(&self) -> bool {
        let contacts = self.contacts.iter().flatten();
        contacts.into_iter().any(|contact| !contact.law.is_compliant())
    }

    /// Duration of the run \[s\] of a scene that was prepared.
    ///
    /// # Panics
    /// If the scene was not prepared and names no duration.
    pub fn duration(&self) -> f64 {
        let known = "preparing a scene finds its duration";
        self.duration_s.expect(known)
    }

    /// Of every structure and wall the time step \[s\] from which on it grows without bound, though it touch nobody;
    /// nothing for a wall, and for a method without such a limit.
    pub(crate) fn critical_time_steps(&self) -> impl Iterator<Item = Option<f64>> {
        let integrator = self.method.time_step().map(|_| self.method.integrator());
        self.structures.iter().map(move |structure| match structure {
            Structure::Sdof(sdof) => integrator?.critical_time_step(&sdof.oscillation()),
            Structure::Building(building) => integrator?.critical_time_step_of(&building.modes()),
            Structure::Wall => None,
        })
    }

    /// The least of them and its structure.
    pub(crate) fn critical_time_step(&self) -> Option<(usize, f64)> {
        let limits = self.critical_time_steps().enumerate();
        limits
            .filter_map(|(index, limit)| Some((index, limit?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

/// What lies between two neighbours.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Gap at rest \[m\], ≥ 0; at every level.
    pub gap_m: f64,
    /// The contact law.
    #[serde(deserialize_with = "choice::one")]
    pub law: ContactLaw,
    /// Levels at which floors can touch, counted from 1 for the lowest, at least one; absent where all that face each other can.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 1), inner(range(min = 1)))]
    pub levels: Option<Vec<usize>>,
}
