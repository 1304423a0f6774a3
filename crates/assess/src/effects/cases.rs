//! Makes the runs that show the effects of pounding.

use pounding_motion::Record;
use pounding_scene::{Error, Method, RunResult, Scene, Simulation};
use pounding_solver::SimultaneousImpacts;
use pounding_text::Refused;

use crate::peaks::FloorPeaks;

/// A case: how it changes the record, and the tolerance of its run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EffectCase {
    reversed: bool,
    /// Factor on accelerations \[–\].
    scale: f64,
    /// Factor on the time between samples \[–\].
    stretch: f64,
    tolerance: f64,
}

/// Collisions of a floor with its left and right neighbours together.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct FloorHits {
    /// Number of collisions.
    pub(super) collisions: f64,
    /// Sum of their impulses \[N·s\].
    pub(super) impulse: f64,
    /// Largest impulse \[N·s\].
    pub(super) largest_impulse: f64,
}

/// Answer of a case for one floor.
#[derive(Debug)]
pub(super) struct FloorAnswer {
    /// Peaks of the floor without its neighbours, and with them.
    pub(super) peaks: [FloorPeaks; 2],
    pub(super) hits: FloorHits,
}

/// Answer of a case for all floors.
#[derive(Debug)]
pub(super) struct CaseAnswer {
    pub(super) floors: Vec<FloorAnswer>,
}

/// Change of the record: one per cent.
const CHANGE: f64 = 0.01;
/// Relative change of the record in the check run, which estimates the error \[–\]. It is far larger than rounding errors.
const SLIGHT: f64 = 1e-12;
/// Tolerances of the exact method: the second in the check run, the first in all other runs.
const TOLERANCES: [f64; 2] = [1e-16, 1e-12];

/// Returns all cases. The first half has the direction of the scene; the second half repeats it with reversed shaking.
pub(super) fn cases() -> Vec<EffectCase> {
    let both = [false, true].into_iter();
    both.flat_map(|reversed| {
        let as_it_is = EffectCase {
            reversed,
            scale: 1.0,
            stretch: 1.0,
            tolerance: TOLERANCES[0],
        };
        let check = EffectCase {
            scale: 1.0 + SLIGHT,
            tolerance: TOLERANCES[1],
            ..as_it_is
        };
        let scaled = [1.0 - CHANGE, 1.0 + CHANGE].map(|scale| EffectCase { scale, ..as_it_is });
        let stretched = [1.0 - CHANGE, 1.0 + CHANGE].map(|stretch| EffectCase { stretch, ..as_it_is });
        [as_it_is, check].into_iter().chain(scaled).chain(stretched)
    })
    .collect()
}

impl EffectCase {
    /// Index of the unchanged record among the cases of one direction.
    pub(super) const AS_IT_IS: usize = 0;
    /// Index of the check run among the cases of one direction. The cases after it change the record by one per cent.
    pub(super) const CHECK: usize = 1;

    pub(super) fn answer(self, prepared: &Simulation) -> Result<CaseAnswer, Error> {
        let changed = prepared.under(|record| self.change(record))?;
        let scene = Scene {
            name: format!("{}{}", changed.scene().name, self.words()),
            // A slower record lasts longer. The run must last as long, or it would miss the end of the record.
            duration_s: Some(prepared.duration() * self.stretch.max(1.0)),
            method: Method::Exact {
                tolerance: self.tolerance,
                simultaneous_impacts: simultaneous_impacts(prepared.method()),
            },
            ..changed.scene().clone()
        };
        let beside = changed.variant(&scene, changed.record().clone())?;
        let apart = beside.apart()?.unlinked()?;
        let alone = FloorPeaks::all(&apart, &apart.run(None)?);
        let outcome = beside.run(None)?;
        let found = FloorPeaks::all(&beside, &outcome);
        let floors = alone.into_iter().zip(found).enumerate();
        let of_floor = |(floor, (alone, found)): (usize, (FloorPeaks, FloorPeaks))| FloorAnswer {
            peaks: [alone, found],
            hits: FloorHits::of(&beside, &outcome, floor),
        };
        Ok(CaseAnswer {
            floors: floors.map(of_floor).collect(),
        })
    }

    /// Describes the change of the record, for the error message of a failed run.
    fn words(self) -> String {
        let per_cent = |factor: f64, words: [&str; 2]| {
            let change = 100.0 * (factor - 1.0);
            let word = words[usize::from(change > 0.0)];
            (change.abs() > 0.5).then(|| format!(", {:.0} % {word}", change.abs()))
        };
        let reversed = self.reversed.then(|| ", reversed".to_string());
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

impl FloorHits {
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

/// Returns how the scene treats several impacts at the same instant. Only the exact method has a choice; all others solve them together.
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
