//! One run of an assessment: a row under one motion in one direction, alone, beside its neighbours, and with softer and stiffer
//! contact.

use serde::Serialize;

use super::alone::Alone;
use super::peaks::{FloorPeaks, peaks};
use super::separation::Separation;
use crate::{Error, Excess, Floors, Implausible, PairQuantity, RunResult, Scene, Simulation, parallel};

/// Factors on the impact stiffness: soft, as the scene has it, and stiff.
pub type StiffnessFactors = [f64; 3];

/// From a tenth to ten times: the stiffness of an impact is known to an order of magnitude at best.
pub const STIFFNESS_FACTORS: StiffnessFactors = [0.1, 1.0, 10.0];

/// What one motion in one direction does to a row.
#[derive(Debug, Clone, PartialEq)]
pub struct AssessedRun {
    /// What the source of the record was multiplied by \[–\].
    pub scale: f64,
    /// What every gap needs.
    pub separations: Vec<Separation>,
    /// Of every floor in the order of the row.
    pub floors: Vec<AssessedFloor>,
    /// Of every pair in the order of the row.
    pub pairs: Vec<AssessedPair>,
    /// Responses beyond the model or beyond codes, beside its neighbours.
    pub excesses: Vec<Excess>,
    /// What looks wrong in the scene and in this record.
    pub unusual: Vec<Implausible>,
}

/// Peaks of a floor alone and beside its neighbours; of a wall they are 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssessedFloor {
    /// Of the building alone.
    pub alone: FloorPeaks,
    /// Beside its neighbours, with the contact stiffness of the scene.
    pub beside: FloorPeaks,
    /// Beside its neighbours, the least and the largest of each over the contact stiffness.
    pub over_stiffness: [FloorPeaks; 2],
}

/// What happens to a pair.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AssessedPair {
    /// Number of collisions, with the contact stiffness of the scene.
    pub collisions: usize,
    /// Least and largest peak force over the contact stiffness \[N\]; `None` if they do not touch, or if the law is impulsive.
    pub peak_force: Option<[f64; 2]>,
    /// Peak force with the contact stiffness of the scene \[N\]; `None` likewise.
    pub own_force: Option<f64>,
    /// Least and largest impulse of a collision over the contact stiffness, the largest of each run \[N·s\]; `None` if they do not
    /// touch.
    pub largest_impulse: Option<[f64; 2]>,
    /// Largest speed of approach at the start of a collision \[m/s\], with the contact stiffness of the scene.
    pub approach_speed: Option<f64>,
}

impl AssessedRun {
    /// The widest of the gaps that it needs \[m\].
    pub fn widest_gap(&self) -> f64 {
        let widths = self.separations.iter().map(|gap| gap.required);
        widths.fold(0.0, f64::max)
    }

    /// Whether something touches a building.
    pub fn hits(&self, floors: &Floors, building: usize) -> bool {
        let facing = floors.facing().iter().zip(&self.pairs);
        let touching = facing.filter(|(_, pair)| pair.collisions > 0);
        let mut sides = touching.flat_map(|(one, _)| [one.left, one.right]);
        sides.any(|side| floors.all()[side].structure == building)
    }

    /// Number of collisions at all pairs.
    pub fn collisions(&self) -> usize {
        self.pairs.iter().map(|pair| pair.collisions).sum()
    }
}

impl Simulation {
    /// What this motion in this direction does to the row, by the exact method; the record is used as it is.
    ///
    /// `alone` is what the motion does to its buildings [alone](Self::alone), in either direction; `None` if that is not known.
    /// The range over the contact stiffness takes two further runs where a compliant pair touches.
    ///
    /// # Errors
    /// [`Error::Run`] if a run ends early, [`Error::Broken`] if one breaks a law of mechanics.
    pub fn assessed(&self, alone: Option<&Alone>, factors: StiffnessFactors) -> Result<AssessedRun, Error> {
        let exact = self.exact()?;
        let known = alone.and_then(|alone| Some((alone, alone.separations(self.is_reversed())?)));
        let (before, separations) = if let Some((alone, separations)) = known {
            (alone.floors.clone(), separations.to_vec())
        } else {
            let alone = self.alone()?;
            let own = alone.separations(self.is_reversed());
            (alone.floors.clone(), own.unwrap_or_default().to_vec())
        };
        let beside = exact.run(None)?;
        let excesses = exact.excesses(&beside);
        let mut pushes = beside.collisions.all().iter();
        let mut variants = Vec::new();
        if pushes.any(|one| one.peak_force.is_some()) {
            let others = factors.map(|factor| ((factor - 1.0).abs() > 0.0).then_some(factor));
            let others: Vec<f64> = others.into_iter().flatten().collect();
            // Side by side, so that the last motion of a folder does not leave processors idle.
            variants = parallel::try_each(&others, |factor| exact.stiffened(*factor)?.run(None))?;
        }
        variants.push(beside);
        let pairs = 0..self.pairs().len();
        let after: Vec<_> = variants.iter().map(|one| peaks(&exact, one)).collect();
        let floor = |index: usize| AssessedFloor {
            alone: before[index],
            beside: after[after.len() - 1][index],
            over_stiffness: [f64::min, f64::max].map(|end| {
                let all = after.iter().map(|one| one[index]);
                all.reduce(|one, other| one.each(other, end)).unwrap_or(before[index])
            }),
        };
        Ok(AssessedRun {
            scale: self.scale(),
            separations,
            floors: (0..before.len()).map(floor).collect(),
            pairs: pairs.map(|pair| assessed_pair(&exact, &variants, pair)).collect(),
            excesses,
            unusual: self.doubts(),
        })
    }

    /// The same motion under another row of structures, as it shakes this one, and for as long as that row asks for.
    ///
    /// # Errors
    /// Refuses a value of the row that cannot be modelled.
    pub fn under_row(&self, row: &Scene) -> Result<Self, Error> {
        let row = Scene {
            record: self.scene().record.clone(),
            duration_s: None,
            ..row.clone()
        };
        let duration_s = Some(row.duration_under(self.record().duration()));
        self.variant(&Scene { duration_s, ..row }, self.record().clone())
    }

    /// The same with every contact so many times as stiff, and as much restitution.
    fn stiffened(&self, factor: f64) -> Result<Self, Error> {
        let mut scene: Scene = self.scene().clone();
        for contact in scene.contacts.iter_mut().flatten() {
            contact.law = contact.law.stiffened(factor);
        }
        self.variant(&scene, self.record().clone())
    }
}

/// Of a pair; the last run is the one with the stiffness of the scene.
fn assessed_pair(simulation: &Simulation, runs: &[RunResult], pair: usize) -> AssessedPair {
    let own = &runs[runs.len() - 1];
    let over = |quantity: PairQuantity| range(runs.iter().filter_map(|run| run.values(simulation).of(quantity, pair)));
    let speeds = own.collisions_of(pair).filter_map(|one| one.approach_speed);
    AssessedPair {
        collisions: own.collisions_of(pair).count(),
        peak_force: over(PairQuantity::PeakForceN),
        own_force: own.values(simulation).of(PairQuantity::PeakForceN, pair),
        largest_impulse: over(PairQuantity::LargestImpulseNS),
        approach_speed: speeds.reduce(f64::max),
    }
}

/// Least and largest of some finite numbers.
fn range(numbers: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let finite = numbers.filter(|number| number.is_finite());
    finite
        .map(|number| [number; 2])
        .reduce(|range, one| [range[0].min(one[0]), range[1].max(one[1])])
}
