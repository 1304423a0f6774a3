//! A run as data for a page that plays it: where floors stand, how they move, and when they touch.

use pounding_scene::{Error, Extras, FloorPair, Floors, Link, RunResult, Simulation, Standing};
use pounding_solver::Collision;
use serde::Serialize;

use crate::figures::elevation;
use crate::{HistoryQuantity, Report, history_of, sketch};

/// Most states of a floor: finer ones are not seen on a screen.
const MOST_STATES: f64 = 4000.0;
/// Most collisions of a run; those with the largest impulses are kept.
const MOST_COLLISIONS: usize = 2000;

/// A run to be played. Its histories are for pictures: whole micrometres at equal instants, between which a peak may lie. Numbers are in
/// [`Summary`](crate::Summary).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Player {
    /// Time between two states \[s\].
    interval_s: f64,
    /// Names of the structures and walls, from the left.
    structures: Vec<String>,
    /// Floors and walls, in the order of the row.
    floors: Vec<PlayedFloor>,
    /// Pairs that can touch.
    pairs: Vec<PlayedPair>,
    /// Both ends of every link, the left one first.
    links: Vec<[PlayedEnd; 2]>,
    /// Collisions, in the order of their beginning.
    collisions: Vec<PlayedCollision>,
    /// Number of collisions that are left out.
    left_out: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct PlayedFloor {
    name: String,
    /// Index of its structure.
    structure: usize,
    /// Height above the ground \[m\].
    elevation_m: f64,
    is_wall: bool,
    /// Displacement relative to the ground \[µm\], positive to the right.
    displacement_um: Vec<i64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct PlayedPair {
    name: String,
    /// Index of its contact in the scene.
    contact: usize,
    /// Index of the slab at which the touch is seen.
    floor: usize,
    /// Whether the touch is at the right side of that slab.
    at_right: bool,
    /// Open width of the gap \[µm\]; negative while the floors overlap.
    opening_um: Vec<i64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct PlayedEnd {
    /// Index of its structure.
    structure: usize,
    /// Index of its floor; absent at the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    floor: Option<usize>,
    /// Height above the ground \[m\].
    elevation_m: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct PlayedCollision {
    pair: usize,
    start_s: f64,
    end_s: f64,
    impulse_n_s: f64,
    /// Absent for an impulsive impact.
    #[serde(skip_serializing_if = "Option::is_none")]
    peak_force_n: Option<f64>,
}

impl Player {
    /// Time between two states that a run to be played keeps \[s\]: a multiple of that of a report.
    pub fn interval(prepared: &Simulation) -> f64 {
        let finest = Report::interval(prepared);
        finest * (prepared.duration() / finest / MOST_STATES - 1e-9).ceil().max(1.0)
    }

    /// The data of a run that kept its histories every [`interval`](Self::interval).
    pub fn of(prepared: &Simulation, outcome: &RunResult) -> Self {
        let floors = prepared.floors();
        let all = floors
            .all()
            .iter()
            .enumerate()
            .zip(micrometres(prepared, outcome, HistoryQuantity::Displacement));
        let all = all.map(|((index, floor), displacement_um)| PlayedFloor {
            name: floor.name.clone(),
            structure: floor.structure,
            elevation_m: elevation(floors, index),
            is_wall: floor.is_wall(),
            displacement_um,
        });
        let pairs = floors.facing().iter().enumerate();
        let pairs = pairs.zip(micrometres(prepared, outcome, HistoryQuantity::Opening));
        let pairs = pairs.map(|((index, pair), opening_um)| {
            let (floor, at_right) = seen_at(floors, pair);
            PlayedPair {
                name: floors.names(index).join(" – "),
                contact: pair.contact,
                floor,
                at_right,
                opening_um,
            }
        });
        let mut collisions = outcome.collisions.all().to_vec();
        let left_out = collisions.len().saturating_sub(MOST_COLLISIONS);
        if left_out > 0 {
            collisions.sort_by(|one, other| other.impulse.total_cmp(&one.impulse));
            collisions.truncate(MOST_COLLISIONS);
            collisions.sort_by(|one, other| one.start.total_cmp(&other.start));
        }
        Self {
            interval_s: Self::interval(prepared),
            structures: floors.structures().to_vec(),
            floors: all.collect(),
            pairs: pairs.collect(),
            links: prepared.scene().links.iter().filter_map(|link| ends(prepared, link)).collect(),
            collisions: collisions.iter().map(PlayedCollision::of).collect(),
            left_out,
        }
    }

    /// Displacements of every floor by the exact method \[µm\], beside those of a run with time steps; `None` for the exact method itself.
    ///
    /// # Errors
    /// Errors of [`Simulation::run_with`].
    pub fn exact_beside(prepared: &Simulation) -> Result<Option<Vec<Vec<i64>>>, Error> {
        if prepared.method().time_step().is_none() {
            return Ok(None);
        }
        let exact = prepared.exact()?;
        let run = exact.run_with(Extras {
            interval: Some(Self::interval(prepared)),
            ..Extras::default()
        })?;
        Ok(Some(micrometres(&exact, &run, HistoryQuantity::Displacement)))
    }
}

impl PlayedCollision {
    fn of(one: &Collision) -> Self {
        Self {
            pair: one.pair,
            start_s: one.start,
            end_s: one.end,
            impulse_n_s: one.impulse,
            peak_force_n: one.peak_force,
        }
    }
}

fn ends(prepared: &Simulation, link: &Link) -> Option<[PlayedEnd; 2]> {
    let (floors, ends) = (prepared.floors(), link.ends(prepared.scene()).ok()?);
    let heights = sketch::heights(floors, ends);
    let played = |(Standing { structure, floor }, elevation_m)| PlayedEnd {
        structure,
        floor: floor.and_then(|floor| floors.of_structure(structure).get(floor).copied()),
        elevation_m,
    };
    Some([(ends[0], heights[0]), (ends[1], heights[1])].map(played))
}

/// The slab of a pair beside a column or a wall, else the left one, and whether its right side touches.
fn seen_at(floors: &Floors, pair: &FloorPair) -> (usize, bool) {
    match floors.column_of(pair) {
        Some(column) => (column.floor, floors.is_on_left(column)),
        None if floors.all()[pair.left].is_wall() => (pair.right, false),
        None => (pair.left, true),
    }
}

/// A history in whole micrometres.
fn micrometres(prepared: &Simulation, outcome: &RunResult, quantity: HistoryQuantity) -> Vec<Vec<i64>> {
    #[expect(clippy::cast_possible_truncation, reason = "a motion beyond 1e12 m ends at the bound")]
    let whole = |metres: f64| (1e6 * metres).round() as i64;
    let all = history_of(prepared, outcome, quantity).into_iter();
    all.map(|history| history.into_iter().map(whole).collect()).collect()
}
