//! A row under many motions: is the gap enough, what does touching do, how sure is that.

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
    /// Width that keeps its neighbours apart \[m\].
    pub required: Distribution,
    /// What rules ask for.
    pub rules: Vec<RuleAssessment>,
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

impl Assessment {
    /// Sums runs of a scene up; `None` without a run.
    ///
    /// # Errors
    /// Those of [`Floors::of`].
    pub fn of<'r>(scene: &Scene, runs: &[&'r AssessedRun]) -> Result<Option<Self>, Error> {
        let floors = Floors::of(scene).map_err(|source| crate::in_scene(scene, source))?;
        let Some(first) = runs.first() else {
            return Ok(None);
        };
        let gap = |index: usize| {
            let all: Vec<&Separation> = runs.iter().map(|run| &run.separations[index]).collect();
            let left = all[0].left;
            let own = scene.contacts.as_ref().and_then(|all| all.get(left));
            let pairs: Vec<usize> = (0..floors.facing().len())
                .filter(|pair| floors.facing()[*pair].contact == left)
                .collect();
            let touches =
                |run: &&&AssessedRun| pairs.iter().any(|pair| run.pairs[*pair].collisions > 0);
            Some(GapAssessment {
                left,
                own: own.map(|contact| contact.gap_m),
                touching: runs.iter().filter(touches).count(),
                required: Distribution::of(all.iter().map(|one| one.required))?,
                rules: Rule::ALL
                    .iter()
                    .filter_map(|rule| ruled(*rule, &all))
                    .collect(),
            })
        };
        Ok(Some(Self {
            runs: runs.len(),
            gaps: (0..first.separations.len()).filter_map(gap).collect(),
            floors: (0..first.floors.len())
                .map(|floor| {
                    let moves = !floors.all()[floor].is_wall();
                    moves.then(|| {
                        let building = floors.all()[floor].structure;
                        let hits = |run: &&&AssessedRun| {
                            let facing = floors.facing().iter().zip(&run.pairs);
                            let touching = facing.filter(|(_, pair)| pair.collisions > 0);
                            let mut sides = touching.flat_map(|(one, _)| [one.left, one.right]);
                            sides.any(|side| floors.all()[side].structure == building)
                        };
                        let of = |run: &&'r AssessedRun| &run.floors[floor];
                        let hit: Vec<_> = runs.iter().filter(hits).map(of).collect();
                        if hit.is_empty() {
                            assessed_floor(&runs.iter().map(of).collect::<Vec<_>>())
                        } else {
                            assessed_floor(&hit)
                        }
                    })?
                })
                .collect(),
            pairs: (0..first.pairs.len())
                .map(|pair| {
                    let all: Vec<_> = runs.iter().map(|run| &run.pairs[pair]).collect();
                    assessed_pair(&all)
                })
                .collect(),
        }))
    }
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
    let shares = widths
        .iter()
        .zip(all)
        .map(|(width, one)| width / one.required);
    let narrow: Vec<f64> = shares.filter(|share| *share < 1.0).collect();
    Some(RuleAssessment {
        rule,
        width: Distribution::of(widths)?,
        too_narrow: narrow.len(),
        least_share: narrow.into_iter().fold(1.0, f64::min),
    })
}

fn assessed_floor(all: &[&AssessedFloor]) -> Option<FloorAssessment> {
    let largest = all.iter().map(|one| one.beside.drift).fold(0.0, f64::max);
    Some(FloorAssessment {
        drift: amplification(all, |peaks| peaks.drift)?,
        shear: amplification(all, |peaks| peaks.shear)?,
        acceleration: amplification(all, |peaks| peaks.acceleration)?,
        largest_drift: largest,
    })
}

/// A peak beside neighbours over that alone, in every run; without a floor that only its neighbours move.
fn amplification(all: &[&AssessedFloor], peak: fn(&FloorPeaks) -> f64) -> Option<Distribution> {
    let ratio = |one: &&AssessedFloor| {
        let (alone, beside) = (peak(&one.alone), peak(&one.beside));
        // What nothing moves is as well off beside its neighbours as alone.
        if beside.to_bits() == alone.to_bits() {
            1.0
        } else {
            beside / alone
        }
    };
    Distribution::of(all.iter().map(ratio).filter(|ratio| ratio.is_finite()))
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
