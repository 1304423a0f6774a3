//! What of a scene cannot be modelled: place, found, allowed, and the field to change.

use pounding_motion::RecordError;
use pounding_solver::ModelError;

use crate::MotionError;

/// A scene with a value that cannot be modelled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A value outside its valid range.
    #[error("{place}: found {}, allowed {allowed}", pounding_text::plain(*found))]
    OutOfRange {
        /// The field, for example `structures[1].sdof.mass_kg`.
        place: String,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A name of nothing.
    #[error("{place}: found an empty name, allowed is {allowed}")]
    NoName {
        /// The field.
        place: String,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// A row that takes longer to prepare than its run may take.
    #[error(
        "budget.seconds: found {}, which was over before the run began, allowed is what it takes to prepare the row; make `budget.seconds` more, \
         or take fewer structures or storeys",
        pounding_text::plain(*seconds)
    )]
    PreparedTooLong {
        /// The budget \[s\].
        seconds: f64,
    },
    /// A number of contacts that does not fit the number of structures.
    #[error(
        "contacts: found {found} for {n_structures} structures, allowed {allowed} (one between each structure and its \
         right neighbour), or no field `contacts` when they stand apart"
    )]
    ContactCount {
        /// Number of contacts.
        found: usize,
        /// Number of contacts that would fit.
        allowed: usize,
        /// Number of structures.
        n_structures: usize,
    },
    /// Another number of arrivals of the ground motion than of structures.
    #[error(
        "arrivals_s: found {found}, allowed {n_structures} (one for each of {n_structures} structures and walls), or no field \
         `arrivals_s` when all are shaken at once"
    )]
    ArrivalCount {
        /// Number of arrivals.
        found: usize,
        /// Number of structures.
        n_structures: usize,
    },
    /// A neighbour that is not known, where a row has to be.
    #[error(
        "neighbour.unknown: found a neighbour that is not known, which `pounding assess` alone takes; describe it as the last of \
         `structures` instead"
    )]
    UnknownNeighbour,
    /// An unknown neighbour beside a wall.
    #[error(
        "neighbour.unknown: found a wall as the last of `structures`, allowed is a structure that moves: the mass of the neighbour is \
         a multiple of its; or masses and periods so far from the usual that no building has them"
    )]
    NeighbourOfWall,
    /// A contact of an unknown neighbour that does not fit those of the row.
    #[error(
        "neighbour.unknown.contact: found {found}, allowed is one if the scene has `contacts` or has one structure, and none if it has \
         none: gaps are given for all neighbours or for no one"
    )]
    NeighbourContact {
        /// Whether there is one.
        found: &'static str,
    },
    /// A time step with which the method is unstable even without contact.
    #[error(
        "method.{method}.time_step_s: found {}, allowed less than {} (structures[{structure}], \"{name}\", grows \
         without bound from there on); contact can ask for less",
        pounding_text::plain(*time_step),
        pounding_text::digits(*limit)
    )]
    Unstable {
        /// Name of the method.
        method: &'static str,
        /// Time step found \[s\].
        time_step: f64,
        /// Critical time step \[s\].
        limit: f64,
        /// Index of the structure that sets it.
        structure: usize,
        /// Its name.
        name: String,
    },
    /// More time steps than the budget has.
    #[error(
        "duration_s: found {}, of which the run would take {needed:.1e} time steps times floors{}, allowed {allowed:e} \
         (`budget.steps`): shorten it, take a longer time_step_s{}, or make the budget more",
        pounding_text::digits(*duration),
        with_substeps(*substeps),
        if *substeps > 1 { " or fewer contact_substeps" } else { "" }
    )]
    TooManySteps {
        /// Duration found \[s\].
        duration: f64,
        /// Steps times floors, with sub-steps.
        needed: f64,
        /// Most of them that are allowed.
        allowed: f64,
        /// Sub-steps of a step while structures touch.
        substeps: u32,
    },
    /// A run so long that the exact method would need too many pieces, though those of the record's duration are few.
    #[error(
        "duration_s: found {}, allowed up to about {} by the exact method, which would need {pieces:.1e} pieces of the motion of \
         structures[{structure}], \"{name}\", of {allowed:e} at most (`budget.pieces`): use a shorter duration_s, or leave it out for \
         that of the record and two periods",
        pounding_text::digits(*duration),
        pounding_text::short(duration / pieces * allowed)
    )]
    TooLong {
        /// Duration found \[s\].
        duration: f64,
        /// Index of the structure with the most pieces.
        structure: usize,
        /// Its name.
        name: String,
        /// Pieces that it would need.
        pieces: f64,
        /// Most pieces that are allowed.
        allowed: f64,
    },
    /// A floor that would hit the columns of a neighbour.
    #[error(
        "contacts[{contact}]: found a floor of \"{}\" at {} m, beside the columns of \"{}\", whose floors are at {} m; \
         allowed are floors that face floors, up to the lower roof: {}change height_m of a storey. A floor that hits \
         columns between floors can bring a building down, and is not modelled: no gap from here is safe for it",
        names[0],
        pounding_text::digits(*height),
        names[1],
        heights(others),
        those_that_face(facing)
    )]
    LevelsDiffer {
        /// Index of the contact.
        contact: usize,
        /// Names of the structure whose floor it is, and of its neighbour.
        names: Box<[String; 2]>,
        /// Height of the floor above the ground \[m\].
        height: f64,
        /// Heights of the neighbour's floors \[m\].
        others: Vec<f64>,
        /// Levels, counted from 1, at which floors of both face each other.
        facing: Vec<usize>,
    },
    /// A level at which no floor faces the neighbour.
    #[error(
        "contacts[{contact}].levels[{place}]: found {found}, allowed {}: the levels at which floors of \"{}\" and \"{}\" face each \
         other, counted from 1 for the lowest; leave out `levels` for all of them",
        list(allowed),
        names[0],
        names[1]
    )]
    NotFacing {
        /// Index of the contact.
        contact: usize,
        /// Index in the list of its levels.
        place: usize,
        /// Level found.
        found: usize,
        /// Names of the neighbours.
        names: Box<[String; 2]>,
        /// Levels at which they face each other.
        allowed: Vec<usize>,
    },
    /// A list of levels without one.
    #[error(
        "contacts[{contact}].levels: found none, allowed one or more of {}, at which floors of \"{}\" and \"{}\" face each other; \
         leave out `levels` for all of them; neighbours that never touch take a wide gap_m",
        list(allowed),
        names[0],
        names[1]
    )]
    NoLevels {
        /// Index of the contact.
        contact: usize,
        /// Names of the neighbours.
        names: Box<[String; 2]>,
        /// Levels at which they face each other.
        allowed: Vec<usize>,
    },
    /// A scene without structures.
    #[error("structures: found none, allowed one or more")]
    NoStructures,
    /// Neighbours that already overlap at t = 0.
    #[error(
        "contacts[{contact}].gap_m: found {}, but the initial displacements of structures[{contact}] and [{}] close \
         that gap and overlap by {} m; allowed is a gap that they leave open, or other initial_displacement_m",
        pounding_text::plain(*gap),
        contact + 1,
        pounding_text::digits(*overlap)
    )]
    OverlapsAtStart {
        /// Index of the contact.
        contact: usize,
        /// Gap found \[m\].
        gap: f64,
        /// Deformation at t = 0 \[m\].
        overlap: f64,
    },
    /// A contact between two walls.
    #[error("contacts[{contact}]: found a wall on either side, allowed at most one wall per contact")]
    BetweenWalls {
        /// Index of the contact.
        contact: usize,
    },
    /// A row that the solver refuses.
    #[error(transparent)]
    Model(ModelError),
    /// A ground motion that cannot be made or used as asked.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A record that was changed, to measure what that does, and is no longer one.
    #[error("record: {0}")]
    Record(#[from] RecordError),
}

/// Counts in a list.
fn list(counts: &[usize]) -> String {
    let counts: Vec<_> = counts.iter().map(ToString::to_string).collect();
    counts.join(", ")
}

/// How to let those floors alone touch that face each other, where there are any.
fn those_that_face(levels: &[usize]) -> String {
    if levels.is_empty() {
        String::new()
    } else {
        format!("levels = [{}] lets those touch that do, and no others; or ", list(levels))
    }
}

/// How many sub-steps a step has, where it has several.
fn with_substeps(substeps: u32) -> String {
    if substeps > 1 {
        format!(" with {substeps} sub-steps in contact")
    } else {
        String::new()
    }
}

/// Heights in a list.
fn heights(heights: &[f64]) -> String {
    let heights: Vec<_> = heights.iter().map(|height| pounding_text::digits(*height)).collect();
    heights.join(", ")
}
