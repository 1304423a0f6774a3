//! What a user writes: a row of structures under a record, with its settings.
//!
//! The types are the words of a scene file, TOML or JSON. [`read`] and [`parse`] read any file of this form, such as a sweep, and
//! [`schema`] tells editors what a scene may hold.

pub(crate) mod budget;
mod building;
pub(crate) mod check;
mod choice;
mod columns;
mod damped;
mod damping;
pub(crate) mod error;
pub(crate) mod fault;
mod generated;
mod isolator;
pub(crate) mod link;
mod method;
mod neighbour;
pub(crate) mod position;
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
pub use columns::{BoucWen, Capacities, Columns};
pub use damping::{DampedStiffness, Damping};
pub use generated::{Generated, Ground, Stochastic};
pub use link::{End, Law, Link, OfRow, Side, Standing};
pub use method::{Jumps, Method, Start};
pub use neighbour::{DrawnNeighbour, Neighbour, UnknownNeighbour};
pub use processing::{Detrend, FilterBand, Interpolation, ScaleTo};
pub use reading::{bytes, bytes_of, in_file, is_json, parse, read, record_bytes};
pub use record::{FileUse, RecordUse, STANDARD_GRAVITY, Source, Unit};
pub use schema::{schema, schema_of};
pub use structure::{Sdof, SdofFile, SetNumber, Structure};

/// A gap that no usual initial displacement closes, and that is not implausible \[m\].
const WIDE: f64 = 2.0;

/// One row of structures under one record, with the method that integrates it.
///
/// Structures stand left to right. A scene is checked when it is [prepared](crate::Simulation).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Name, unique within its study.
    pub name: String,
    /// The record and how it is used.
    pub record: RecordUse,
    /// Duration of the run \[s\], a whole number of time steps. By default the run lasts two of the longest natural periods after the end
    /// of the record at the last structure, rounded up to a whole number of steps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub duration_s: Option<f64>,
    /// The structures and walls, from left to right.
    pub structures: Vec<Structure>,
    /// Which floors face each other if heights are not given: `"level"` for storeys of one number at one height. Given heights decide
    /// themselves.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "choice::maybe")]
    pub floors: Option<FloorHeights>,
    /// Whether the weight of the masses acts on leaning storeys (P-Δ), besides `gravity_load_n` of storeys, which always does.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "choice::maybe")]
    pub p_delta: Option<PDelta>,
    /// Drift over the height of a storey \[–\], > 0 and ≤ 1, at which it counts as collapsed under gravity, and the run ends; 0.2 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub collapse_drift_ratio: Option<f64>,
    /// One contact between each structure and its right neighbour; absent if the structures stand apart.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contacts: Option<Vec<Contact>>,
    /// Springs, dampers and restrainers between floors, or between a floor and the ground or a wall.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub links: Vec<Link>,
    /// The neighbour to the right of the last structure, if it is unknown; only `assess` accepts it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub neighbour: Option<Neighbour>,
    /// Instants at which the ground motion arrives at each structure and wall \[s\], ≥ 0, from left to right; absent if it arrives
    /// everywhere at once. A wave of apparent velocity v arrives at a base a distance x further along its way x/v later.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arrivals_s: Option<Vec<f64>>,
    /// The method of time integration; the exact method by default.
    #[serde(default = "exact", deserialize_with = "choice::one")]
    pub method: Method,
    /// Limits on the work of a run.
    #[serde(default, skip_serializing_if = "RunBudget::is_usual")]
    pub budget: RunBudget,
    /// Whether heights are asked for without contacts, too, since gaps need them; [`Scene::seeking_gaps`] sets it.
    #[serde(skip)]
    pub seeks_gaps: bool,
}

/// Which floors face each other without heights.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FloorHeights {
    /// Storeys of one number are at one height.
    Level,
}

impl choice::Choice for FloorHeights {}

/// Weights that act on leaning storeys.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PDelta {
    /// Those of the masses, besides the gravity loads of storeys.
    FromMasses,
}

impl choice::Choice for PDelta {}

/// Shape of a column between its floors, which shares a blow among them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ColumnShape {
    /// Fixed to both floors: at the part s of its height it follows the floor above by 3s² − 2s³.
    #[default]
    Fixed,
    /// Straight between hinges: it follows the floor above by s.
    Straight,
}

impl choice::Choice for ColumnShape {}

impl ColumnShape {
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
    fn is_fixed(&self) -> bool {
        *self == Self::Fixed
    }

    /// Part of the upper floor in the motion of the column at the part s of its height \[–\], 0 to 1.
    pub fn upper_part(self, s: f64) -> f64 {
        match self {
            Self::Fixed => s * s * (3.0 - 2.0 * s),
            Self::Straight => s,
        }
    }

    /// Largest shear force \[N\] and largest bending moment \[N·m\] in a column of this height \[m\] under 1 N at the part s of its height.
    pub fn forces(self, height: f64, s: f64) -> [f64; 2] {
        let (upper, far) = (self.upper_part(s), 1.0 - s);
        let moment = match self {
            // At the nearer end: where the force acts the moment is never larger.
            Self::Fixed => height * s * far * s.max(far),
            Self::Straight => height * s * far,
        };
        [upper.max(1.0 - upper), moment]
    }
}

/// Owner of the ground of two neighbours, on which rules of codes for gaps depend.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Property {
    /// Both stand on one property.
    Same,
    /// A property line runs between them: each keeps its own displacement to it.
    #[default]
    Other,
}

impl choice::Choice for Property {}

impl Property {
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
    fn is_other(&self) -> bool {
        *self == Self::Other
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

fn exact() -> Method {
    Method::EXACT
}

/// Number of periods of free vibration after a record by default. The second period shows that the first one had the peak.
const PERIODS_AFTER_RECORD: f64 = 2.0;

impl Scene {
    /// Duration of the run \[s\] under a record of this duration \[s\].
    ///
    /// # Panics
    /// Never: there is no deadline.
    pub fn duration_under(&self, record: f64) -> f64 {
        let found = self.duration_within(record, Patience::ENDLESS);
        found.expect("there is no deadline")
    }

    /// Duration of the run under a record; gives up at the deadline.
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

    /// Returns the scene for questions about gaps, which need the heights of floors without contacts, too.
    #[must_use]
    pub fn seeking_gaps(self) -> Self {
        Self { seeks_gaps: true, ..self }
    }

    /// Returns the row with wide gaps and the exact method, to find the gaps that it needs. Fields that do not matter then are neither
    /// refused nor searched for.
    #[must_use]
    pub fn apart(&self) -> Self {
        let wide = |one: &Contact| Contact {
            gap_m: one.gap_m.max(WIDE),
            ..one.clone()
        };
        let contacts = self.contacts.as_ref();
        Self {
            contacts: contacts.map(|all| all.iter().map(wide).collect()),
            method: Method::EXACT,
            ..self.clone()
        }
        .seeking_gaps()
    }

    /// Whether a contact of the scene has a force over time, and not only impulses.
    pub fn is_compliant(&self) -> bool {
        let mut contacts = self.contacts.iter().flatten();
        contacts.any(|contact| contact.law.is_compliant())
    }

    /// Whether some contact is impulsive.
    pub fn is_impulsive(&self) -> bool {
        let contacts = self.contacts.iter().flatten();
        contacts.into_iter().any(|contact| !contact.law.is_compliant())
    }

    /// Duration of the run of a prepared scene \[s\].
    ///
    /// # Panics
    /// If the scene was not prepared and has no duration.
    pub fn duration(&self) -> f64 {
        let known = "preparing a scene finds its duration";
        self.duration_s.expect(known)
    }

    /// Critical time step of every structure and wall \[s\], above which its response grows without bound even if nothing touches. `None`
    /// for a wall, and for a method without such a limit.
    pub(crate) fn critical_time_steps(&self) -> impl Iterator<Item = Option<f64>> {
        let integrator = self.method.time_step().map(|_| self.method.integrator());
        self.structures.iter().map(move |structure| match structure {
            Structure::Sdof(sdof) => integrator?.critical_time_step(&sdof.oscillation()),
            Structure::Building(building) => integrator?.critical_time_step_of(&building.modes()),
            Structure::Wall => None,
        })
    }

    /// Least critical time step \[s\] and the index of its structure.
    pub(crate) fn critical_time_step(&self) -> Option<(usize, f64)> {
        let limits = self.critical_time_steps().enumerate();
        limits
            .filter_map(|(index, limit)| Some((index, limit?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

/// Gap and contact law between two neighbours.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Gap at rest \[m\], ≥ 0; at every level.
    pub gap_m: f64,
    /// The contact law.
    #[serde(deserialize_with = "choice::one")]
    pub law: ContactLaw,
    /// Levels at which floors can touch, counted from 1 for the lowest, at least one; absent if all floors that face each other can touch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 1), inner(range(min = 1)))]
    pub levels: Option<Vec<usize>>,
    /// Heights at which slabs can touch what stands there \[m\], at least one; absent if they can at all heights.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 1))]
    pub heights_m: Option<Vec<f64>>,
    /// Width of the seat of the right floor on the left one \[m\], > 0: a floor that moves farther away is unseated. By default there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seat_width_m: Option<f64>,
    /// Shape of columns between floors, where a slab hits them.
    #[serde(default, skip_serializing_if = "ColumnShape::is_fixed", deserialize_with = "choice::one")]
    pub column_shape: ColumnShape,
    /// Whether both neighbours stand on the same property; rules of codes for gaps depend on it.
    #[serde(default, skip_serializing_if = "Property::is_other", deserialize_with = "choice::one")]
    pub property: Property,
}
