//! One run of an assessment: a row under one motion in one direction, alone, beside its neighbours, and with softer and stiffer
//! contact.

use pounding_scene::{Error, Excess, ExcessKind, Extras, Floors, Implausible, PairQuantity, RunResult, Scene, Simulation, parallel};
use pounding_text::{digits, percent};
use serde::Serialize;

use crate::alone::Alone;
use crate::peaks::FloorPeaks;
use crate::separation::Separation;

/// Factors on the impact stiffness: soft, as the scene has it, and stiff.
pub type StiffnessFactors = [f64; 3];

/// Response of a row to one motion in one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct AssessedRun {
    /// Factor by which the source of the record was multiplied \[–\].
    pub scale: f64,
    /// Required width of every gap.
    pub separations: Vec<Separation>,
    /// Every floor in the order of the row.
    pub floors: Vec<AssessedFloor>,
    /// Every pair in the order of the row.
    pub pairs: Vec<AssessedPair>,
    /// Responses beside the neighbours that exceed the model or the limits of codes. Drifts and forces of columns are the largest over the
    /// contact stiffness.
    pub excesses: Vec<Excess>,
    /// Drifts and forces of the columns of buildings that stand alone, as far as they exceed their limits.
    pub excesses_alone: Vec<Excess>,
    /// The drift or force of every building that stands alone and exceeds a capacity of the scene: no width of a gap helps against it.
    pub over_capacity_alone: Vec<Excess>,
    /// The response of the buildings alone that is farthest beyond belief; `None` if they are believed.
    pub disbelieved_alone: Option<Excess>,
    /// The response beside the neighbours that is farthest beyond belief; `None` if it is believed.
    pub disbelieved_beside: Option<Excess>,
    /// Whether a storey collapses under gravity, alone or beside the neighbours: nothing after it is known.
    pub collapsed: bool,
    /// Implausible values of the scene and of its record.
    pub unusual: Vec<Implausible>,
}

/// Peaks of a floor alone and beside its neighbours; 0 for a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssessedFloor {
    /// Peaks of the building alone.
    pub alone: FloorPeaks,
    /// Peaks beside its neighbours, with the contact stiffness of the scene.
    pub beside: FloorPeaks,
    /// Least and largest peaks beside its neighbours over the contact stiffness.
    pub over_stiffness: [FloorPeaks; 2],
}

/// Collisions of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AssessedPair {
    /// Number of collisions, with the contact stiffness of the scene.
    pub collisions: usize,
    /// Least and largest peak force over the contact stiffness \[N\]; `None` if the pair does not touch, or if its law is impulsive.
    pub peak_force: Option<[f64; 2]>,
    /// Peak force with the contact stiffness of the scene \[N\]; `None` if the pair does not touch, or if its law is impulsive.
    pub own_force: Option<f64>,
    /// Least and largest of the runs' largest impulses of a blow over the contact stiffness \[N·s\]; `None` if the pair does not touch, or only
    /// leans.
    pub largest_impulse: Option<[f64; 2]>,
    /// Largest speed of approach at the start of a collision \[m/s\], with the contact stiffness of the scene.
    pub approach_speed: Option<f64>,
    /// Instant at which the right floor leaves its seat \[s\]; `None` if it does not, or if there is no seat.
    pub unseated: Option<f64>,
}

impl AssessedRun {
    /// Range of the contact stiffness by default. The stiffness of an impact is known to an order of magnitude at best, and that of two slabs
    /// which meet face to face is some thirty times that of the usual laws.
    pub const STIFFNESS_FACTORS: StiffnessFactors = [0.1, 1.0, 30.0];

    /// Range of the contact stiffness of a scene by default, as factors on its own \[–\]. It ends at [`Self::STIFFNESS_FACTORS`] times the usual
    /// stiffness, which is that of two slabs, or at the stiffness of the scene if that is more.
    pub fn stiffness_range(scene: &Scene) -> [f64; 2] {
        let [from, _, most] = Self::STIFFNESS_FACTORS;
        let own = scene.contacts.iter().flatten().filter_map(|one| one.law.stiffness_over_usual());
        [from, own.map(|over| most / over).fold(most, f64::min).max(1.0)]
    }

    /// With the ground acceleration of the site \[g\] in place of the record's, if it is known.
    #[must_use]
    pub fn at_site(mut self, ground_acceleration: Option<f64>) -> Self {
        for one in &mut self.separations {
            one.pga_g = ground_acceleration.unwrap_or(one.pga_g);
        }
        self
    }

    /// Runs the row of a simulation alone and beside its neighbours, by the exact method. The record is not scaled again.
    ///
    /// `alone` is the response of the buildings alone to the motion in either direction; `None` if it is not known. The range over the
    /// contact stiffness takes two further runs if a compliant pair touches.
    ///
    /// # Errors
    /// [`Error::Run`] if a run ends early, [`Error::Broken`] if one breaks a law of mechanics.
    pub fn of(simulation: &Simulation, alone: Option<&Alone>, factors: StiffnessFactors) -> Result<Self, Error> {
        let exact = simulation.exact()?;
        let reversed = simulation.scene().record.reversed;
        let of_this;
        let known = alone.filter(|alone| alone.separations(reversed).is_some());
        let alone = if let Some(known) = known {
            known
        } else {
            of_this = Alone::of(simulation)?;
            &of_this
        };
        let before = &alone.floors;
        let separations = alone.separations(reversed).unwrap_or_default().to_vec();
        // Closings tell how near floors come to columns that they face, and openings which floors leave their seats.
        let has_seats = exact.scene().has_seats();
        let beside = exact.run_with(Extras {
            closings: has_seats || !exact.floors().beside_all_columns().is_empty(),
            reversed_closings: has_seats,
            drift_rates: true,
            ..Extras::default()
        })?;
        let mut excesses = exact.all_excesses(&beside);
        let disbelieved_beside = beyond_belief(&excesses).cloned();
        let mut pushes = beside.collisions.all().iter();
        let (mut variants, mut stiffnesses) = (Vec::new(), Vec::new());
        if pushes.any(|one| one.peak_force.is_some()) {
            let others = factors.map(|factor| ((factor - 1.0).abs() > 0.0).then_some(factor));
            let others: Vec<f64> = others.into_iter().flatten().collect();
            // Both at once, so that the last motion of a folder does not leave processors idle.
            variants = parallel::try_each(&others, |factor| stiffened(&exact, *factor)?.run(None))?;
            stiffnesses = others;
        }
        for one in &variants {
            let judged = |one: &Excess| one.kind.strains() || one.kind == ExcessKind::BaseShear;
            excesses.extend(exact.all_excesses(one).into_iter().filter(judged));
        }
        let mut judged = excesses.iter().chain(&alone.excesses);
        let collapsed = judged.any(|one| one.kind == ExcessKind::Collapse);
        variants.push(beside);
        stiffnesses.push(1.0);
        let pairs = 0..simulation.pairs().len();
        let after: Vec<_> = variants.iter().map(|one| FloorPeaks::all(&exact, one)).collect();
        let floor = |index: usize| AssessedFloor {
            alone: before[index],
            beside: after[after.len() - 1][index],
            over_stiffness: [f64::min, f64::max].map(|end| {
                let all = after.iter().map(|one| one[index]);
                all.reduce(|one, other| one.each(other, end)).unwrap_or(before[index])
            }),
        };
        Ok(Self {
            scale: simulation.scale(),
            separations,
            floors: (0..before.len()).map(floor).collect(),
            pairs: pairs.map(|pair| assessed_pair(&exact, &variants, &stiffnesses, pair)).collect(),
            disbelieved_alone: beyond_belief(&alone.excesses).cloned(),
            disbelieved_beside,
            excesses,
            excesses_alone: those_alone(&alone.excesses, simulation.scene().words().alone),
            over_capacity_alone: alone.over_capacity.clone(),
            collapsed,
            unusual: simulation.doubts(),
        })
    }

    /// Widest required gap \[m\].
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

    /// Number of collisions of all pairs.
    pub fn collisions(&self) -> usize {
        self.pairs.iter().map(|pair| pair.collisions).sum()
    }
}

/// Responses above which no result of the model is believed: twice the drift and the ductility that codes allow, and a twentieth of 12 m for
/// a storey of unknown height. At the stability coefficient gravity takes all of the strength of a storey. No collapse is believed.
const MOST_BELIEVED: [(ExcessKind, f64); 5] = [
    (ExcessKind::Collapse, 0.0),
    (ExcessKind::Drift, 0.05),
    (ExcessKind::Displacement, 0.6),
    (ExcessKind::Ductility, 12.0),
    (ExcessKind::Stability, 1.0),
];

/// Drifts and forces of the buildings alone: widths come from these runs, and a wider gap leaves the buildings to them.
fn those_alone(excesses: &[Excess], alone: &str) -> Vec<Excess> {
    let strains = excesses.iter().filter(|one| one.kind.strains());
    let named = strains.map(|one| Excess {
        name: format!("{} {alone}", one.name),
        ..one.clone()
    });
    named.collect()
}

/// The limit of belief behind a response of a kind, in words; empty if every such response is beyond it.
pub fn says_believed(kind: ExcessKind) -> String {
    let mut limits = MOST_BELIEVED.iter();
    let limit = limits.find(|(one, most)| *one == kind && *most > 0.0);
    let words = |most: f64| {
        if kind == ExcessKind::Drift {
            percent(most)
        } else if kind == ExcessKind::Displacement {
            format!("{} mm", digits(1e3 * most))
        } else {
            digits(most)
        }
    };
    limit.map_or_else(String::new, |(_, most)| {
        format!(", above {}, the most that is believed", words(*most))
    })
}

/// Returns the response that is farthest beyond belief: a building with it would hardly stand. `None` if all are believed.
pub fn beyond_belief<'e>(excesses: impl IntoIterator<Item = &'e Excess>) -> Option<&'e Excess> {
    let share = |one: &Excess| {
        // A capacity of the scene drops no event: it would make widths narrower for weaker buildings. Isolators are made to move far.
        if one.kind == ExcessKind::Displacement && one.capacity.is_some() {
            return 0.0;
        }
        let mut limits = MOST_BELIEVED.iter();
        let limit = limits.find(|(kind, _)| *kind == one.kind);
        limit.map_or(0.0, |(_, most)| one.found / most)
    };
    let beyond = excesses.into_iter().filter(|one| share(one) > 1.0);
    beyond.max_by(|one, other| share(one).total_cmp(&share(other)))
}

/// Returns the simulation with every contact `factor` times as stiff and with the same restitution.
fn stiffened(simulation: &Simulation, factor: f64) -> Result<Simulation, Error> {
    let mut scene: Scene = simulation.scene().clone();
    for contact in scene.contacts.iter_mut().flatten() {
        contact.law = contact.law.stiffened(factor);
    }
    simulation.variant(&scene, simulation.record().clone())
}

/// Assesses a pair under contacts of several stiffnesses; the last run has that of the scene.
fn assessed_pair(simulation: &Simulation, runs: &[RunResult], stiffnesses: &[f64], pair: usize) -> AssessedPair {
    let own = &runs[runs.len() - 1];
    let over = |quantity: PairQuantity| range(runs.iter().filter_map(|run| run.values(simulation).of(quantity, pair)));
    let blows = runs.iter().zip(stiffnesses);
    let speeds = own.collisions_of(pair).filter_map(|one| one.approach_speed);
    AssessedPair {
        collisions: own.collisions_of(pair).count(),
        peak_force: over(PairQuantity::PeakForceN),
        own_force: own.values(simulation).of(PairQuantity::PeakForceN, pair),
        largest_impulse: range(blows.filter_map(|(run, stiffness)| largest_blow(simulation, run, *stiffness, pair))),
        approach_speed: speeds.reduce(f64::max),
        unseated: own.values(simulation).of(PairQuantity::UnseatedS, pair),
    }
}

/// Largest impulse of a pair in a collision that is a blow \[N·s\]: a building that leans on its neighbour pushes for as long as it leans.
fn largest_blow(simulation: &Simulation, run: &RunResult, stiffness: f64, pair: usize) -> Option<f64> {
    let blows = run.collisions_of(pair).filter(|one| !simulation.is_push(one, stiffness));
    blows.map(|one| one.impulse).reduce(f64::max)
}

/// Least and largest of the finite numbers; `None` if there are none.
fn range(numbers: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let finite = numbers.filter(|number| number.is_finite());
    finite
        .map(|number| [number; 2])
        .reduce(|range, one| [range[0].min(one[0]), range[1].max(one[1])])
}
