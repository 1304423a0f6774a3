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
    /// Number of cases: events, each beside every neighbour that a row may have. All runs of a case are one sample: it counts with the
    /// largest of each number.
    pub cases: usize,
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
    /// Number of cases in which its neighbours touch, under some component in some direction.
    pub touching: usize,
    /// Number of runs in which they touch.
    pub touching_runs: usize,
    /// Width that keeps its neighbours apart in a case \[m\].
    pub required: Distribution,
    /// Width that keeps floors from columns of the neighbour, too, in every run \[m\], by the sum of both peaks; `None` if no floor faces
    /// a column, or if it is not more.
    pub beside_columns: Option<f64>,
    /// What rules ask for.
    pub rules: Vec<RuleAssessment>,
}

/// What a gap needs in several cases, and what rules ask for.
#[derive(Debug, Clone, PartialEq)]
pub struct RequiredGap {
    /// Width that keeps its neighbours apart in a case \[m\].
    pub required: Distribution,
    /// Width that keeps floors from columns of the neighbour, too, in every run \[m\], by the sum of both peaks; `None` if no floor faces
    /// a column, or if it is not more.
    pub beside_columns: Option<f64>,
    /// What rules ask for.
    pub rules: Vec<RuleAssessment>,
}

impl RequiredGap {
    /// Of what one gap needs in runs, each with its case; `None` without a run.
    pub fn of(all: &[([usize; 2], &Separation)]) -> Option<Self> {
        let required = all.iter().map(|(case, one)| (*case, one.required));
        let required = largest_of_cases(required)?;
        let beside = all.iter().filter_map(|(_, one)| one.beside_columns);
        let beside = beside.reduce(f64::max);
        let rules = Rule::ALL.iter();
        Some(Self {
            beside_columns: beside.filter(|width| *width > required.largest()),
            required,
            rules: rules.filter_map(|rule| ruled(*rule, all)).collect(),
        })
    }
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
    /// Number of cases in which it is too narrow.
    pub too_narrow: usize,
    /// Least ratio of its width to the one required \[–\]; 1 if it is never too narrow.
    pub least_share: f64,
}

/// What touching does to a floor and the storey below it: beside its neighbours over alone \[–\], in every case in which something
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

/// How a pair hits, over the cases in which it touches and over the stiffness of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct PairAssessment {
    /// Number of cases in which it touches.
    pub touching: usize,
    /// Largest pounding force of every case \[N\], with the softest and the stiffest contact in effect; `None` of a law without force.
    pub peak_force: Option<[Distribution; 2]>,
    /// Largest impulse of every case \[N·s\] likewise.
    pub largest_impulse: Option<[Distribution; 2]>,
    /// Largest speed of approach \[m/s\].
    pub approach_speed: Option<f64>,
}

/// A run, and of which case it is.
#[derive(Debug, Clone, Copy)]
pub struct RunOfCase<'r> {
    /// Number of the event.
    pub event: usize,
    /// Number of the neighbour, where a row may have several.
    pub neighbour: usize,
    /// What the motion does.
    pub run: &'r AssessedRun,
}

impl RunOfCase<'_> {
    fn case(&self) -> [usize; 2] {
        [self.event, self.neighbour]
    }
}

/// The largest of some numbers in each case; `None` without one.
fn largest_of_cases(numbers: impl Iterator<Item = ([usize; 2], f64)>) -> Option<Distribution> {
    let mut largest: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for (case, number) in numbers {
        let so_far = largest.entry(case).or_insert(number);
        *so_far = so_far.max(number);
    }
    Distribution::of(largest.into_values())
}

/// Number of different ones.
fn count<T: Ord>(all: impl Iterator<Item = T>) -> usize {
    all.collect::<BTreeSet<T>>().len()
}

impl Assessment {
    /// Sums runs of a scene up; `None` without a run.
    ///
    /// # Errors
    /// Those of [`Floors::of`].
    pub fn of(scene: &Scene, runs: &[RunOfCase<'_>]) -> Result<Option<Self>, Error> {
        let floors = Floors::of(scene).map_err(|source| crate::in_scene(scene, source))?;
        let Some(RunOfCase { run: first, .. }) = runs.first() else {
            return Ok(None);
        };
        let row = Row {
            scene,
            floors: &floors,
            runs,
        };
        Ok(Some(Self {
            runs: runs.len(),
            events: count(runs.iter().map(|one| one.event)),
            cases: count(runs.iter().map(RunOfCase::case)),
            by_stiffness: row.by_stiffness(),
            gaps: (0..first.separations.len()).filter_map(|index| row.gap(index)).collect(),
            floors: (0..first.floors.len()).map(|floor| row.floor(floor)).collect(),
            pairs: (0..first.pairs.len())
                .map(|pair| {
                    let all = runs.iter().map(|one| (one.case(), &one.run.pairs[pair]));
                    assessed_pair(&all.collect::<Vec<_>>())
                })
                .collect(),
        }))
    }
}

/// A row and its runs.
struct Row<'r> {
    scene: &'r Scene,
    floors: &'r Floors,
    runs: &'r [RunOfCase<'r>],
}

impl<'r> Row<'r> {
    fn gap(&self, index: usize) -> Option<GapAssessment> {
        let of = |one: &RunOfCase<'r>| (one.case(), &one.run.separations[index]);
        let all: Vec<([usize; 2], &Separation)> = self.runs.iter().map(of).collect();
        let left = all.first()?.1.left;
        let own = self.scene.contacts.as_ref().and_then(|all| all.get(left));
        let facing = self.floors.facing();
        let pairs: Vec<usize> = (0..facing.len()).filter(|pair| facing[*pair].contact == left).collect();
        let touches = |run: &AssessedRun| pairs.iter().any(|pair| run.pairs[*pair].collisions > 0);
        let touching = self.runs.iter().filter(|one| touches(one.run));
        let RequiredGap {
            required,
            beside_columns,
            rules,
        } = RequiredGap::of(&all)?;
        Some(GapAssessment {
            left,
            own: own.map(|contact| contact.gap_m),
            touching: count(touching.clone().map(RunOfCase::case)),
            touching_runs: touching.count(),
            required,
            beside_columns,
            rules,
        })
    }

    /// A floor in the runs in which something touches its building, or in all if nothing ever does; `None` of a wall.
    fn floor(&self, floor: usize) -> Option<FloorAssessment> {
        if self.floors.all()[floor].is_wall() {
            return None;
        }
        let hit = self.hits(floor);
        if hit.is_empty() {
            let all = self.runs.iter();
            let all: Vec<_> = all.map(|one| (one.case(), &one.run.floors[floor])).collect();
            assessed_floor(&all)
        } else {
            assessed_floor(&hit)
        }
    }

    /// A floor in the runs in which something touches its building, each with its case.
    fn hits(&self, floor: usize) -> Vec<([usize; 2], &AssessedFloor)> {
        let building = self.floors.all()[floor].structure;
        let hit = self.runs.iter();
        let hit = hit.filter(|one| one.run.hits(self.floors, building));
        hit.map(|one| (one.case(), &one.run.floors[floor])).collect()
    }

    fn by_stiffness(&self) -> Option<StiffnessEffect> {
        let moving = (0..self.floors.all().len()).filter(|floor| !self.floors.all()[*floor].is_wall());
        let hits = moving.flat_map(|floor| self.hits(floor));
        let floors: Vec<&AssessedFloor> = hits.map(|(_, floor)| floor).collect();
        let ratio = |[least, largest]: [f64; 2]| largest / least;
        let of = |peak: fn(&FloorPeaks) -> f64| {
            let ratios = floors.iter().map(|one| ratio(one.over_stiffness.each_ref().map(peak)));
            Distribution::of(ratios.filter(|ratio| ratio.is_finite()))
        };
        let pairs = self.runs.iter().flat_map(|one| &one.run.pairs);
        let impulses = pairs.filter_map(|pair| Some(ratio(pair.peak_force.and(pair.largest_impulse)?)));
        Some(StiffnessEffect {
            drift: of(|peaks| peaks.drift)?,
            acceleration: of(|peaks| peaks.acceleration)?,
            impulse: Distribution::of(impulses.filter(|ratio| ratio.is_finite()))?,
        })
    }
}

impl GapAssessment {
    /// The least gap that is known to keep the neighbours apart in every run \[m\], also floors from columns.
    pub fn largest(&self) -> f64 {
        self.beside_columns.unwrap_or(self.required.largest())
    }

    /// The same in [steps](BUILT_IN_STEPS_OF) \[m\].
    pub fn proposal(&self) -> f64 {
        self.built(self.largest())
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

fn ruled(rule: Rule, all: &[([usize; 2], &Separation)]) -> Option<RuleAssessment> {
    let widths: Option<Vec<f64>> = all.iter().map(|(_, one)| rule.width(one)).collect();
    let widths = widths?;
    let mut narrow = BTreeSet::new();
    let mut least_share: f64 = 1.0;
    for ((case, one), width) in all.iter().zip(&widths) {
        if one.asks_for_more(*width) {
            narrow.insert(case);
            least_share = least_share.min(width / one.required);
        }
    }
    let of_cases = all.iter().zip(widths).map(|((case, _), width)| (*case, width));
    Some(RuleAssessment {
        rule,
        width: largest_of_cases(of_cases)?,
        too_narrow: narrow.len(),
        least_share,
    })
}

fn assessed_floor(all: &[([usize; 2], &AssessedFloor)]) -> Option<FloorAssessment> {
    let drifts = all.iter().map(|(_, one)| one.beside.drift);
    let largest = drifts.fold(0.0, f64::max);
    let beside = |peak: fn(&FloorPeaks) -> f64| {
        let both = all.iter();
        amplification(both.map(|(case, one)| (*case, [peak(&one.alone), peak(&one.beside)])))
    };
    let range = |end: usize| {
        let both = |one: &AssessedFloor| [&one.alone, &one.over_stiffness[end]].map(|one| one.acceleration);
        amplification(all.iter().map(|(case, one)| (*case, both(one))))
    };
    Some(FloorAssessment {
        drift: beside(|peaks| peaks.drift)?,
        shear: beside(|peaks| peaks.shear)?,
        acceleration: beside(|peaks| peaks.acceleration)?,
        acceleration_range: [range(0)?, range(1)?],
        largest_drift: largest,
    })
}

/// The largest in each case of peaks beside neighbours over those alone, of pairs of both; without a floor that only its
/// neighbours move.
fn amplification(all: impl Iterator<Item = ([usize; 2], [f64; 2])>) -> Option<Distribution> {
    let ratio = |(case, [alone, beside]): ([usize; 2], [f64; 2])| {
        // What nothing moves is as well off beside its neighbours as alone.
        if beside.to_bits() == alone.to_bits() {
            (case, 1.0)
        } else {
            (case, beside / alone)
        }
    };
    largest_of_cases(all.map(ratio).filter(|(_, ratio)| ratio.is_finite()))
}

fn assessed_pair(all: &[([usize; 2], &AssessedPair)]) -> PairAssessment {
    let touching = all.iter().filter(|(_, one)| one.collisions > 0);
    let over = |range: fn(&AssessedPair) -> Option<[f64; 2]>| {
        let ranges = touching.clone();
        let ranges = ranges.filter_map(|(case, one)| Some((*case, range(one)?)));
        let end = |end: usize| largest_of_cases(ranges.clone().map(|(case, both)| (case, both[end])));
        Some([end(0)?, end(1)?])
    };
    PairAssessment {
        touching: count(touching.clone().map(|(case, _)| *case)),
        peak_force: over(|one| one.peak_force),
        largest_impulse: over(|one| one.largest_impulse),
        approach_speed: touching.clone().filter_map(|(_, one)| one.approach_speed).reduce(f64::max),
    }
}
