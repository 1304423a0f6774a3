//! `summary.json`: a run, its results and their errors, for programs.

mod numbers;
mod of_run;

pub use numbers::{ErrorSummary, Numbers};

use pounding_solver::{Terms, Work};
use serde::{Deserialize, Serialize};

use pounding_assess::Effects;
use pounding_scene::{BetweenSamples, Implausible, Scene};

/// Version of the form of results: `summary.json`, `runs.json`, `assess.json`, the tables beside them, and the file
/// beside a converted record. A new field or column keeps it; one that goes, or changes its meaning, raises it.
pub const SCHEMA_VERSION: u32 = 2;

/// A run, its results and their errors; the names of fields end with their units.
///
/// A field that is absent does not apply. Fields are added in later versions, never renamed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Version of the form of this file, [`SCHEMA_VERSION`]; 0 of one that was written before there were versions.
    #[serde(default)]
    pub schema_version: u32,
    /// Version of the program.
    pub version: String,
    /// The scene as it ran: with its duration, and with the method that was found if it asks for an accuracy.
    pub scene: Scene,
    /// How it was integrated.
    pub method: MethodSummary,
    /// The ground motion.
    pub record: RecordSummary,
    /// The structures and walls, from left to right.
    pub structures: Vec<StructureSummary>,
    /// The pairs of neighbours that can touch, from left to right.
    pub pairs: Vec<PairSummary>,
    /// The links, in the order of the scene.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub links: Vec<LinkSummary>,
    /// The effects of pounding on every storey, in the order of the structures, if they were asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub effects: Option<Effects>,
    /// The collapse that ended the run before its duration, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub collapse: Option<CollapseSummary>,
    /// How far the numbers move if the record is band-limited between its samples, if that was measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub between_samples: Option<BetweenSamples>,
    /// Where the energy went.
    pub ledger: LedgerSummary,
    /// What the run cost.
    pub work: WorkSummary,
    /// What looks wrong in the scene, though it can be modelled.
    #[serde(default)]
    pub unusual: Vec<Implausible>,
    /// What to know before believing the numbers, in words.
    pub warnings: Vec<String>,
}

/// The collapse of a storey under gravity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CollapseSummary {
    /// Name of the structure.
    pub structure: String,
    /// Number of the storey, from 1.
    pub storey: usize,
    /// Instant \[s\].
    pub time_s: f64,
}

/// How a scene was integrated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodSummary {
    /// Name, as scene files spell it.
    pub name: String,
    /// Time step \[s\]; absent for the exact method.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time_step_s: Option<f64>,
    /// Duration of the run \[s\].
    pub duration_s: f64,
    /// Interval of the histories \[s\].
    pub history_interval_s: f64,
    /// Largest relative error that the scene allows \[–\], if it asks for an accuracy.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chosen_for_error: Option<f64>,
    /// How errors are known: `exact` (there are none beyond rounding and the tolerance), `measured` (against the exact
    /// run), `not_measured` (not asked for) or `unknown` (the exact run fails, or breaks a law of mechanics).
    pub errors: String,
    /// Largest relative error of all that were measured \[–\]; `null` if a number exists in one run only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub largest_error: Option<f64>,
}

/// The ground motion of a scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecordSummary {
    /// File as the scene names it; absent for a motion from a formula.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// SHA-256 of the file, in hexadecimal digits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
    /// Format of the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub format: Option<String>,
    /// Unit of the values in the file, in the word of a scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Product of all scales of the record \[–\]; 1 if it was not scaled.
    #[serde(default = "one")]
    pub scale_factor: f64,
    /// Number of samples, as used.
    pub n_samples: usize,
    /// Time between them \[s\].
    pub time_step_s: f64,
    /// Ground acceleration of largest magnitude, as used \[m/s²\].
    pub peak_m_per_s2: f64,
    /// Its instant \[s\].
    pub pga_time_s: f64,
    /// The description that the file holds.
    pub provenance: String,
    /// Readings of the file, with their lines.
    pub readings: Vec<ReadingSummary>,
    /// What was done to it before it shook the row, in words, in this order.
    pub processing: Vec<String>,
}

fn one() -> f64 {
    1.0
}

/// One thing that was read of a file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ReadingSummary {
    /// Kind of the reading, such as `component`.
    pub what: String,
    /// Line of the file, from 1; absent for a binary file and for a declaration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// What was found, with its unit.
    pub found: String,
}

/// What happened to a structure or a wall.
///
/// A wall has its name and its transferred momentum only.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct StructureSummary {
    /// Its name; of a floor of a building that of the building and the number of the floor.
    pub name: String,
    /// Storey below the floor, counted from 1; absent for a structure of one storey and a wall.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub storey: Option<usize>,
    /// Its numbers, each in a field of its name.
    #[serde(flatten)]
    pub numbers: Numbers,
    /// Distances of these numbers from the exact run, if they were measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub errors: Option<ErrorSummary>,
}

/// What happened between two neighbours.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct PairSummary {
    /// Name of the left neighbour.
    pub left: String,
    /// Name of the right neighbour.
    pub right: String,
    /// Contact law, as scene files spell it.
    pub law: String,
    /// Its numbers, each in a field of its name; those of a collision stand in that.
    #[serde(flatten)]
    pub numbers: Numbers,
    /// The first collision.
    pub first: Option<CollisionSummary>,
    /// The one with the largest impulse.
    pub largest: Option<CollisionSummary>,
    /// The collision that lasts longest, where it lasts longer than a blow ([`Simulation::longest_blow`](pounding_scene::Simulation::longest_blow)):
    /// the neighbours lean on each other, and its impulse is that of a push.
    pub leaning: Option<CollisionSummary>,
    /// Distances of these numbers from the exact run, if they were measured.
    pub errors: Option<PairErrorSummary>,
}

/// What happened to a link.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LinkSummary {
    /// Name of its left end.
    pub left: String,
    /// Name of its right end.
    pub right: String,
    /// Law, as scene files spell it.
    pub law: String,
    /// Its numbers, each in a field of its name.
    #[serde(flatten)]
    pub numbers: Numbers,
}

/// One touching of two neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CollisionSummary {
    /// First instant \[s\].
    pub start_s: f64,
    /// Last instant \[s\].
    pub end_s: f64,
    /// Impulse \[N·s\].
    pub impulse_n_s: f64,
    /// Largest pounding force \[N\]; absent for an impulsive impact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_force_n: Option<f64>,
    /// Its first instant \[s\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_force_time_s: Option<f64>,
}

/// Distances of the numbers of a pair from the exact run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PairErrorSummary {
    /// Number of collisions in the exact run.
    pub exact_collisions: usize,
    /// Whether the pair comes to rest in the exact run, where this one has an impact in every step: then only the time of
    /// the first is compared.
    pub rests: bool,
    /// Of each number.
    #[serde(flatten)]
    pub errors: ErrorSummary,
}

/// Where the energy of the row went, at the end of the run; of the motion relative to the ground.
///
/// kinetic + strain + damping + hysteretic + impact + contact + link = initial + input + opening.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LedgerSummary {
    /// Energy at the start \[J\].
    pub initial_j: f64,
    /// Work of the shaking \[J\].
    pub input_j: f64,
    /// Work that bases which move towards each other do through contact and links \[J\]; left out where all are shaken at once.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub opening_j: f64,
    /// Kinetic energy \[J\].
    pub kinetic_j: f64,
    /// Energy stored in the columns \[J\].
    pub strain_j: f64,
    /// Energy that viscous damping took \[J\].
    pub damping_j: f64,
    /// Energy that yielding took \[J\].
    pub hysteretic_j: f64,
    /// Energy that impulsive impacts took \[J\].
    pub impact_j: f64,
    /// Energy that compliant contact took \[J\].
    pub contact_j: f64,
    /// Energy that links took, including what they still store \[J\]; left out where it is 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub link_j: f64,
    /// Largest residual of the balance over time, relative to the scale \[–\].
    pub residual: f64,
    /// Largest over time of the initial energy plus the magnitudes of the terms \[J\].
    pub scale_j: f64,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

impl LedgerSummary {
    pub(super) fn of(balance: &pounding_scene::EnergyBalance) -> Self {
        let Terms {
            initial,
            input,
            opening,
            kinetic,
            strain,
            damping,
            hysteretic,
            impact,
            contact,
            link,
        } = balance.terms;
        Self {
            initial_j: initial,
            input_j: input,
            opening_j: opening,
            kinetic_j: kinetic,
            strain_j: strain,
            damping_j: damping,
            hysteretic_j: hysteretic,
            impact_j: impact,
            contact_j: contact,
            link_j: link,
            residual: balance.residual,
            scale_j: balance.scale,
        }
    }
}

/// The cost of a run, in counts that are equal on every machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct WorkSummary {
    /// Time steps of the row.
    pub steps: u64,
    /// Evaluations of a restoring force.
    pub force_evaluations: u64,
    /// Newton iterations.
    pub newton_iterations: u64,
    /// Steps in contact.
    pub touching_steps: u64,
    /// Pieces of motion of the exact method.
    pub segments: u64,
    /// Events of the exact method.
    pub events: u64,
}

impl WorkSummary {
    pub(super) fn of(work: &Work) -> Self {
        Self {
            steps: work.steps,
            force_evaluations: work.force_evaluations,
            newton_iterations: work.newton_iterations,
            touching_steps: work.touching_steps,
            segments: work.segments,
            events: work.events,
        }
    }
}
