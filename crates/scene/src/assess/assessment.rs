//! A row under many motions: is the gap enough, what does touching do, how sure is that.

use std::collections::{BTreeMap, BTreeSet};

use super::distribution::Distribution;
use super::peaks::FloorPeaks;
use super::run::{AssessedFloor, AssessedPair, AssessedRun};
use super::separation::{Rule, Separation};
use crate::{Error, Floors, Scene};

/// Steps in which gaps are built \[m\].
pub const BUILT_IN_STEPS_OF: f64 = 0.01;

/// Amplification from which on a storey counts as worse \[–\].
pub const WORSE: f64 = 1.1;

/// Rounding of a sum of displacements \[m\], by which a proposal is not a step wider.
const ROUNDING: f64 = 1e-9;

/// What a row does under several motions.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// Number of runs: motions times directions.
    pub runs: usize,
    /// Number of events that the motions are of.
    pub events: usize,
    /// What the stiffness of contact changes; `None` if no two runs with several stiffnesses touch.
    pub by_stiffness: Option<StiffnessEffect>,
    /// Of every gap between two neighbours, from the left.
    pub gaps: Vec<GapAssessment>,
    /// Of every floor in the order of the row; `None` of a wall.
    pub floors: Vec<Option<FloorAssessment>>,
    /// Of every pair in the order of the row.
    pub pairs: Vec<PairAssessment>,
}

/// Whether a gap is enough.
#[derive(Debug, Clone, PartialEq)]
pub struct GapAssessment {
    /// Index of the structure on the left.
    pub left: usize,
    /// Gap of the scene \[m\]; `None` if the scene has no contacts.
    pub own: Option<f64>,
    /// Number of runs in which its neighbours touch.
    pub touching: usize,
    /// Number of events in which they touch, under some component in some direction.
    pub touching_events: usize,
    /// Width that keeps its neighbours apart \[m\].
    pub required: Distribution,
    /// The largest of each event \[m\].
    pub required_of_events: Distribution,
    /// What rules ask for.
    pub rules: Vec<RuleAssessment>,
}

/// The largest value over the stiffness of contact over the least one \[–\], of every storey or pair that touches and every run.
#[derive(Debug, Clone, PartialEq)]
pub struct StiffnessEffect {
    /// Of peak drifts.
    pub drift: Distribution,
    /// Of peak absolute accelerations of floors.
    pub acceleration: Distribution,
    /// Of the largest impulse of a collision.
    pub impulse: Distribution,
}

/// How a rule does for a gap.
#[derive(Debug, Clone, PartialEq)]
pub struct RuleAssessment {
    /// The rule.
    pub rule: Rule,
    /// Its width \[m\].
    pub width: Distribution,
    /// Number of runs in which it is too narrow.
    pub too_narrow: usize,
    /// Least ratio of its width to the one required \[–\]; 1 if it is never too narrow.
    pub least_share: f64,
}

/// What touching does to a floor and the storey below it: beside its neighbours over alone \[–\], in every run in which something
/// touches its building, or in all if nothing ever does.
#[derive(Debug, Clone, PartialEq)]
pub struct FloorAssessment {
    /// Of the peak drift of the storey.
    pub drift: Distribution,
    /// Of its peak shear force.
    pub shear: Distribution,
    /// Of the peak absolute acceleration of the floor.
    pub acceleration: Distribution,
    /// Of the same, the least and the largest over the stiffness of contact, which decides it as it does forces.
    pub acceleration_range: [Distribution; 2],
    /// Largest drift beside its neighbours \[m\].
    pub largest_drift: f64,
}

/// How a pair hits, over the runs in which it touches and over the stiffness of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct PairAssessment {
    /// Number of runs in which it touches.
    pub touching: usize,
    /// Largest pounding force of every run \[N\], with the softest and the stiffest contact in effect; `None` of a law without force.
    pub peak_force: Option<[Distribution; 2]>,
    /// Largest impulse of every run \[N·s\] likewise.
    pub largest_impulse: Option<[Distribution; 2]>,
    /// Largest speed of approach \[m/s\].
    pub approach_speed: Option<f64>,
}

/// A run and the event that it is of.
pub type RunOfEvent<'r> = (usize, &'r AssessedRun);

impl Assessment {
    /// Sums runs of a scene up; `None` without a run.
    ///
    /// # Errors
    /// Those of [`Floors::of`].
    pub fn of(scene: &Scene, runs: &[RunOfEvent<'_>]) -> Result<Option<Self>, Error> {
        let floors = Floors::of(scene).map_err(|source| crate::in_scene(scene, source))?;
        let Some((_, first)) = runs.first() else {
            return Ok(None);
        };
        let row = Row {
            scene,
            floors: &floors,
            runs,
        };
        Ok(Some(Self {
            runs: runs.len(),
            events: count_events(runs.iter().map(|(event, _)| *event)),
            by_stiffness: row.by_stiffness(),
            gaps: (0..first.separations.len())
                .filter_map(|index| row.gap(index))
                .collect(),
            floors: (0..first.floors.len())
                .map(|floor| row.floor(floor))
                .collect(),
            pairs: (0..first.pairs.len())
                .map(|pair| {
                    let all: Vec<_> = runs.iter().map(|(_, run)| &run.pairs[pair]).collect();
                    assessed_pair(&all)
                })
                .collect(),
        }))
    }
}

/// A row and its runs.
struct Row<'r> {
    scene: &'r Scene,
    floors: &'r Floors,
    runs: &'r [RunOfEvent<'r>],
}

impl Row<'_> {
    fn gap(&self, index: usize) -> Option<GapAssessment> {
        let all: Vec<&Separation> = self
            .runs
            .iter()
            .map(|(_, run)| &run.separations[index])
            .collect();
        let left = all.first()?.left;
        let own = self.scene.contacts.as_ref().and_then(|all| all.get(left));
        let facing = self.floors.facing();
        let pairs: Vec<usize> = (0..facing.len())
            .filter(|pair| facing[*pair].contact == left)
            .collect();
        let touches = |run: &AssessedRun| pairs.iter().any(|pair| run.pairs[*pair].collisions > 0);
        let touching = self.runs.iter().filter(|(_, run)| touches(run));
        let mut largest: BTreeMap<usize, f64> = BTreeMap::new();
        for ((event, _), one) in self.runs.iter().zip(&all) {
            let so_far = largest.entry(*event).or_insert(one.required);
            *so_far = so_far.max(one.required);
        }
        Some(GapAssessment {
            left,
            own: own.map(|contact| contact.gap_m),
            touching: touching.clone().count(),
            touching_events: count_events(touching.map(|(event, _)| *event)),
            required: Distribution::of(all.iter().map(|one| one.required))?,
            required_of_events: Distribution::of(largest.into_values())?,
            rules: Rule::ALL
                .iter()
                .filter_map(|rule| ruled(*rule, &all))
                .collect(),
        })
    }

    /// A floor in the runs in which something touches its building, or in all if nothing ever does; `None` of a wall.
    fn floor(&self, floor: usize) -> Option<FloorAssessment> {
        if self.floors.all()[floor].is_wall() {
            return None;
        }
        let hit = self.hits(floor);
        if hit.is_empty() {
            assessed_floor(
                &self
                    .runs
                    .iter()
                    .map(|(_, run)| &run.floors[floor])
                    .collect::<Vec<_>>(),
            )
        } else {
            assessed_floor(&hit)
        }
    }

    /// A floor in the runs in which something touches its building.
    fn hits(&self, floor: usize) -> Vec<&AssessedFloor> {
        let building = self.floors.all()[floor].structure;
        let hit = self.runs.iter();
        let hit = hit.filter(|(_, run)| run.hits(self.floors, building));
        hit.map(|(_, run)| &run.floors[floor]).collect()
    }

    fn by_stiffness(&self) -> Option<StiffnessEffect> {
        let moving =
            (0..self.floors.all().len()).filter(|floor| !self.floors.all()[*floor].is_wall());
        let floors: Vec<&AssessedFloor> = moving.flat_map(|floor| self.hits(floor)).collect();
        let ratio = |[least, largest]: [f64; 2]| largest / least;
        let of = |peak: fn(&FloorPeaks) -> f64| {
            let ratios = floors
                .iter()
                .map(|one| ratio(one.over_stiffness.each_ref().map(peak)));
            Distribution::of(ratios.filter(|ratio| ratio.is_finite()))
        };
        let pairs = self.runs.iter().flat_map(|(_, run)| &run.pairs);
        let impulses =
            pairs.filter_map(|pair| Some(ratio(pair.peak_force.and(pair.largest_impulse)?)));
        Some(StiffnessEffect {
            drift: of(|peaks| peaks.drift)?,
            acceleration: of(|peaks| peaks.acceleration)?,
            impulse: Distribution::of(impulses.filter(|ratio| ratio.is_finite()))?,
        })
    }
}

/// Number of events among these.
fn count_events(events: impl Iterator<Item = usize>) -> usize {
    events.collect::<BTreeSet<usize>>().len()
}

impl GapAssessment {
    /// The least gap in [steps](BUILT_IN_STEPS_OF) that keeps the neighbours apart in every run \[m\].
    pub fn proposal(&self) -> f64 {
        self.built(self.required.largest())
    }

    /// A width rounded up to what is built \[m\].
    pub fn built(&self, width: f64) -> f64 {
        let steps = ((width - ROUNDING).max(0.0) / BUILT_IN_STEPS_OF).ceil();
        steps * BUILT_IN_STEPS_OF
    }
}

impl FloorAssessment {
    /// Whether a response is more than [`WORSE`] times that alone in more than 16 % of the runs.
    pub fn is_worse(&self) -> bool {
        let all = [&self.drift, &self.shear, &self.acceleration];
        all.iter().any(|one| one.p84() > WORSE)
    }
}

fn ruled(rule: Rule, all: &[&Separation]) -> Option<RuleAssessment> {
    let widths: Option<Vec<f64>> = all.iter().map(|one| rule.width(one)).collect();
    let widths = widths?;
    let narrow = widths
        .iter()
        .zip(all)
        .filter(|(width, one)| one.asks_for_more(**width));
    let narrow: Vec<f64> = narrow.map(|(width, one)| width / one.required).collect();
    Some(RuleAssessment {
        rule,
        width: Distribution::of(widths)?,
        too_narrow: narrow.len(),
        least_share: narrow.into_iter().fold(1.0, f64::min),
    })
}

fn assessed_floor(all: &[&AssessedFloor]) -> Option<FloorAssessment> {
    let largest = all.iter().map(|one| one.beside.drift).fold(0.0, f64::max);
    let beside = |peak: fn(&FloorPeaks) -> f64| {
        let both = |one: &&AssessedFloor| [peak(&one.alone), peak(&one.beside)];
        amplification(all.iter().map(both))
    };
    let range = |end: usize| {
        let both = |one: &&AssessedFloor| {
            [&one.alone, &one.over_stiffness[end]].map(|one| one.acceleration)
        };
        amplification(all.iter().map(both))
    };
    Some(FloorAssessment {
        drift: beside(|peaks| peaks.drift)?,
        shear: beside(|peaks| peaks.shear)?,
        acceleration: beside(|peaks| peaks.acceleration)?,
        acceleration_range: [range(0)?, range(1)?],
        largest_drift: largest,
    })
}

/// Peaks beside neighbours over those alone, of pairs of both; without a floor that only its neighbours move.
fn amplification(all: impl Iterator<Item = [f64; 2]>) -> Option<Distribution> {
    let ratio = |[alone, beside]: [f64; 2]| {
        // What nothing moves is as well off beside its neighbours as alone.
        if beside.to_bits() == alone.to_bits() {
            1.0
        } else {
            beside / alone
        }
    };
    Distribution::of(all.map(ratio).filter(|ratio| ratio.is_finite()))
}

fn assessed_pair(all: &[&AssessedPair]) -> PairAssessment {
    let touching: Vec<&AssessedPair> = all
        .iter()
        .copied()
        .filter(|one| one.collisions > 0)
        .collect();
    let over = |range: fn(&AssessedPair) -> Option<[f64; 2]>| {
        let ranges: Vec<[f64; 2]> = touching.iter().filter_map(|one| range(one)).collect();
        let [low, high] = [0, 1].map(|end| Distribution::of(ranges.iter().map(|range| range[end])));
        Some([low?, high?])
    };
    PairAssessment {
        touching: touching.len(),
        peak_force: over(|one| one.peak_force),
        largest_impulse: over(|one| one.largest_impulse),
        approach_speed: touching
            .iter()
            .filter_map(|one| one.approach_speed)
            .reduce(f64::max),
    }
}
