//! The runs that effects are told from.

use pounding_motion::Record;
use pounding_solver::SimultaneousImpacts;
use pounding_text::Refused;

use super::super::peaks::{FloorPeaks, peaks};
use crate::{Error, Method, RunResult, Scene, Simulation};

/// A change of the record, and how exactly the run follows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Case {
    reversed: bool,
    /// By which accelerations are multiplied.
    scale: f64,
    /// By which the time between samples is multiplied.
    stretch: f64,
    tolerance: f64,
}

/// What hits a floor from either side.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Hits {
    /// Their number.
    pub(super) collisions: f64,
    /// Their sum \[N·s\].
    pub(super) impulse: f64,
    /// \[N·s\]
    pub(super) largest_impulse: f64,
}

/// What a case says of one floor.
#[derive(Debug)]
pub(super) struct OfFloor {
    /// Alone and beside neighbours.
    pub(super) peaks: [FloorPeaks; 2],
    pub(super) hits: Hits,
}

/// What a case says of all floors.
#[derive(Debug)]
pub(super) struct Answer {
    pub(super) floors: Vec<OfFloor>,
}

/// One per cent.
const CHANGE: f64 = 0.01;
/// What the record of the check is changed by, far above rounding.
const SLIGHT: f64 = 1e-12;
/// Tolerances of the exact method, and of the check.
const TOLERANCES: [f64; 2] = [1e-16, 1e-12];

/// All cases, those of the direction of the scene first, both directions in the same order.
pub(super) fn cases() -> Vec<Case> {
    let both = [false, true].into_iter();
    both.flat_map(|reversed| {
        let as_it_is = Case {
            reversed,
            scale: 1.0,
            stretch: 1.0,
            tolerance: TOLERANCES[0],
        };
        let check = Case {
            scale: 1.0 + SLIGHT,
            tolerance: TOLERANCES[1],
            ..as_it_is
        };
        let scaled = [1.0 - CHANGE, 1.0 + CHANGE].map(|scale| Case { scale, ..as_it_is });
        let stretched = [1.0 - CHANGE, 1.0 + CHANGE].map(|stretch| Case { stretch, ..as_it_is });
        [as_it_is, check].into_iter().chain(scaled).chain(stretched)
    })
    .collect()
}

impl Case {
    /// Where the record as it is stands among the cases of one direction.
    pub(super) const AS_IT_IS: usize = 0;
    /// Where the check does; changes of one per cent follow it.
    pub(super) const CHECK: usize = 1;

    pub(super) fn answer(self, prepared: &Simulation) -> Result<Answer, Error> {
        let changed = prepared.under(|record| self.change(record))?;
        let scene = Scene {
            name: format!("{}{}", changed.scene().name, self.words()),
            // A slower record takes longer; a run that ends before it would compare another part of it.
            duration_s: Some(prepared.duration() * self.stretch.max(1.0)),
            method: Method::Exact {
                tolerance: self.tolerance,
                simultaneous_impacts: simultaneous_impacts(prepared.method()),
            },
            ..changed.scene().clone()
        };
        let beside = changed.variant(&scene, changed.record().clone())?;
        let apart = beside.apart()?;
        let alone = peaks(&apart, &apart.run(None)?);
        let outcome = beside.run(None)?;
        let found = peaks(&beside, &outcome);
        let floors = alone.into_iter().zip(found).enumerate();
        let of_floor = |(floor, (alone, found)): (usize, (FloorPeaks, FloorPeaks))| OfFloor {
            peaks: [alone, found],
            hits: Hits::of(&beside, &outcome, floor),
        };
        Ok(Answer {
            floors: floors.map(of_floor).collect(),
        })
    }

    /// What the case changes, for the message of a run that fails.
    fn words(self) -> String {
        let per_cent = |factor: f64, words: [&str; 2]| {
            let change = 100.0 * (factor - 1.0);
            let word = words[usize::from(change > 0.0)];
            (change.abs() > 0.5).then(|| format!(", {:.0} % {word}", change.abs()))
        };
        let reversed = self.reversed.then(|| ", the other way round".to_string());
        let changes = [
            reversed,
            per_cent(self.scale, ["weaker", "stronger"]),
            per_cent(self.stretch, ["faster", "slower"]),
        ];
        changes.into_iter().flatten().collect()
    }

    fn change(self, record: &Record) -> Result<Record, Refused> {
        let direction = if self.reversed { -1.0 } else { 1.0 };
        let scaled = record.scaled(direction * self.scale)?;
        scaled.stretched(self.stretch)
    }
}

impl Hits {
    fn of(prepared: &Simulation, outcome: &RunResult, floor: usize) -> Self {
        let facing = prepared.floors().facing();
        let own = |pair: usize| facing[pair].left == floor || facing[pair].right == floor;
        let all = outcome.collisions.all().iter().filter(|one| own(one.pair));
        all.fold(Self::default(), |hits, one| Self {
            collisions: hits.collisions + 1.0,
            impulse: hits.impulse + one.impulse,
            largest_impulse: hits.largest_impulse.max(one.impulse),
        })
    }
}

/// The rule of a scene for impacts at one instant; other methods than the exact one have but the usual one.
fn simultaneous_impacts(method: Method) -> SimultaneousImpacts {
    match method {
        Method::Exact { simultaneous_impacts, .. } => simultaneous_impacts,
        Method::CentralDifference { .. }
        | Method::Newmark { .. }
        | Method::Hht { .. }
        | Method::VelocityVerlet { .. }
        | Method::Rk4 { .. }
        | Method::MoreauJean { .. }
        | Method::Accuracy(_) => SimultaneousImpacts::Together,
    }
}
