//! A row under many motions: whether its gaps are enough, what touching does, and how certain both are.

use std::collections::{BTreeMap, BTreeSet};

use pounding_scene::{Error, Floors, Scene};

use crate::distribution::Distribution;
use crate::peaks::FloorPeaks;
use crate::rule::Rule;
use crate::run::{AssessedFloor, AssessedPair, AssessedRun};
use crate::separation::Separation;

/// Rounding error of a sum of displacements \[m\]. It must not make a proposed gap one step wider.
const ROUNDING: f64 = 1e-9;

/// Response of a row to several motions.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// Number of runs: motions times directions.
    pub runs: usize,
    /// Number of events among the motions.
    pub events: usize,
    /// Number of cases. A case is an event beside one of the neighbours that the row may have. All runs of a case are one sample: the
    /// largest value of each number counts.
    pub cases: usize,
    /// Effect of the contact stiffness; `None` if no run that touches has several stiffnesses.
    pub by_stiffness: Option<StiffnessEffect>,
    /// Every gap between two neighbours, from the left.
    pub gaps: Vec<GapAssessment>,
    /// Every floor in the order of the row; `None` for a wall.
    pub floors: Vec<Option<FloorAssessment>>,
    /// Every pair in the order of the row.
    pub pairs: Vec<PairAssessment>,
}

/// Whether a gap is enough.
#[derive(Debug, Clone, PartialEq)]
pub struct GapAssessment {
    /// Index of the structure on the left.
    pub left: usize,
    /// Gap of the scene \[m\]; `None` if the scene has no contacts.
    pub own: Option<f64>,
    /// Number of cases in which the neighbours touch, for any component in any direction.
    pub touching: usize,
    /// Number of runs in which the neighbours touch.
    pub touching_runs: usize,
    /// Width that keeps the neighbours apart, one value for each case \[m\].
    pub required: Distribution,
    /// Width below which floors hit columns of the neighbour in some run \[m\]; `None` if no floor faces a column.
    pub beside_columns: Option<f64>,
    /// Widths by the rules of codes and literature.
    pub rules: Vec<RuleAssessment>,
}

/// Required width of a gap in several cases, and its width by rules.
#[derive(Debug, Clone, PartialEq)]
pub struct RequiredGap {
    /// Width that keeps the neighbours apart, one value for each case \[m\].
    pub required: Distribution,
    /// Width below which floors hit columns of the neighbour in some run \[m\]; `None` if no floor faces a column.
    pub beside_columns: Option<f64>,
    /// Widths by the rules of codes and literature.
    pub rules: Vec<RuleAssessment>,
}

impl RequiredGap {
    /// Sums up the required widths of one gap in runs, each with its case; `None` if there are no runs.
    pub fn of(all: &[([usize; 2], &Separation)]) -> Option<Self> {
        let required = all.iter().map(|(case, one)| (*case, one.required));
        let required = largest_of_cases(required)?;
        let beside = all.iter().filter_map(|(_, one)| one.beside_columns);
        let beside = beside.reduce(f64::max);
        let rules = Rule::ALL.iter();
        Some(Self {
            beside_columns: beside,
            required,
            rules: rules.filter_map(|rule| ruled(*rule, all)).collect(),
        })
    }
}

/// Ratio of the largest to the least value over the contact stiffness \[–\], for every storey or pair that touches, in every run.
#[derive(Debug, Clone, PartialEq)]
pub struct StiffnessEffect {
    /// Ratio of peak drifts.
    pub drift: Distribution,
    /// Ratio of peak absolute accelerations of floors.
    pub acceleration: Distribution,
    /// Ratio of the largest impulses of a collision.
    pub impulse: Distribution,
}

/// Width of a gap by a rule, compared with the required width.
#[derive(Debug, Clone, PartialEq)]
pub struct RuleAssessment {
    /// The rule.
    pub rule: Rule,
    /// Width by the rule \[m\].
    pub width: Distribution,
    /// Number of cases in which the rule's width is too narrow.
    pub too_narrow: usize,
    /// Least ratio of the rule's width to the required width \[–\]; 1 if the rule is never too narrow.
    pub least_share: f64,
    /// Whether all floors are level, for which some codes accept that slabs meet.
    pub level: bool,
}

impl RuleAssessment {
    /// Width that the code asks for under all events \[m\], and whether it is their mean: the code takes the mean of enough events, and the
    /// largest of fewer.
    pub fn asked(&self) -> (f64, bool) {
        let n = self.width.sorted().len();
        match self.rule.words().mean_from {
            Some(least) if n >= least => (self.width.mean(), true),
            _ => (self.width.largest(), false),
        }
    }

    /// Factor by which the code narrows the gap of level floors; `None` if it does not.
    pub fn narrowed(&self) -> Option<f64> {
        let factor = self.rule.words().when_level;
        (self.level && factor < 1.0).then_some(factor)
    }
}

/// Effect of touching on a floor and the storey below it: responses beside the neighbours over responses alone \[–\]. It covers every case
/// in which something touches the building, or all cases if nothing ever does.
#[derive(Debug, Clone, PartialEq)]
pub struct FloorAssessment {
    /// Ratio of peak drifts of the storey.
    pub drift: Distribution,
    /// Ratio of peak shear forces of the storey.
    pub shear: Distribution,
    /// Ratio of peak absolute accelerations of the floor.
    pub acceleration: Distribution,
    /// Least and largest ratio of accelerations over the contact stiffness, which governs accelerations as it governs forces.
    pub acceleration_range: [Distribution; 2],
    /// Largest drift beside the neighbours \[m\].
    pub largest_drift: f64,
}

/// Collisions of a pair, over the cases in which it touches and over the contact stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct PairAssessment {
    /// Number of cases in which the pair touches.
    pub touching: usize,
    /// Largest pounding force of every case \[N\], for the contact stiffness with the least force and for the one with the largest; `None`
    /// for a law without force.
    pub peak_force: Option<[Distribution; 2]>,
    /// Largest impulse of every case \[N·s\], for the least and the largest effect of the contact stiffness.
    pub largest_impulse: Option<[Distribution; 2]>,
    /// Largest speed of approach \[m/s\].
    pub approach_speed: Option<f64>,
}

/// A run and its case.
#[derive(Debug, Clone, Copy)]
pub struct RunOfCase<'r> {
    /// Number of the event.
    pub event: usize,
    /// Number of the neighbour; 0 if only one neighbour is possible.
    pub neighbour: usize,
    /// Response to the motion.
    pub run: &'r AssessedRun,
}

impl RunOfCase<'_> {
    fn case(&self) -> [usize; 2] {
        [self.event, self.neighbour]
    }
}

/// Largest number of each case; `None` if there are no numbers.
fn largest_of_cases(numbers: impl Iterator<Item = ([usize; 2], f64)>) -> Option<Distribution> {
    let mut largest: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for (case, number) in numbers {
        let so_far = largest.entry(case).or_insert(number);
        *so_far = so_far.max(number);
    }
    Distribution::of(largest.into_values())
}

/// Number of distinct items.
fn count<T: Ord>(all: impl Iterator<Item = T>) -> usize {
    all.collect::<BTreeSet<T>>().len()
}

impl Assessment {
    /// Sums up runs of a scene; `None` if there are no runs.
    ///
    /// # Errors
    /// Errors of [`Floors::of`].
    pub fn of(scene: &Scene, runs: &[RunOfCase<'_>]) -> Result<Option<Self>, Error> {
        let floors = Floors::of(scene).map_err(|refused| Error::in_scene(&scene.name, refused))?;
        let Some(RunOfCase { run: first, .. }) = runs.first() else {
            return Ok(None);
        };
        let row = AssessedRow {
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
struct AssessedRow<'r> {
    scene: &'r Scene,
    floors: &'r Floors,
    runs: &'r [RunOfCase<'r>],
}

impl<'r> AssessedRow<'r> {
    fn gap(&self, index: usize) -> Option<GapAssessment> {
        let of = |one: &RunOfCase<'r>| (one.case(), &one.run.separations[index]);
        let all: Vec<([usize; 2], &Separation)> = self.runs.iter().map(of).collect();
        let left = all.first()?.1.left;
        let own = self.scene.contacts.as_ref().and_then(|all| all.get(left));
        let facing = self.floors.facing();
        let pairs: Vec<usize> = (0..facing.len()).filter(|pair| facing[*pair].contact == left).collect();
        let is_unmodelled = self.floors.is_unmodelled(left);
        // Where floors face columns, the buildings alone tell whether they would touch.
        let touches = |run: &AssessedRun| match own {
            Some(own) if is_unmodelled => run.separations[index].asks_for_more(own.gap_m),
            _ => pairs.iter().any(|pair| run.pairs[*pair].collisions > 0),
        };
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

    /// Assesses a floor in the runs in which something touches its building, or in all runs if nothing ever does; `None` for a wall.
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

    /// Returns a floor in the runs in which something touches its building, each with its case.
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
    /// Gaps are built in multiples of this width \[m\].
    pub const BUILT_IN_STEPS_OF: f64 = 0.01;

    /// Least gap that keeps the neighbours apart in every run \[m\], floors and columns included.
    pub fn largest(&self) -> f64 {
        self.required.largest()
    }

    /// Least known gap, rounded up to a multiple of [`Self::BUILT_IN_STEPS_OF`] \[m\].
    pub fn proposal(&self) -> f64 {
        self.built(self.largest())
    }

    /// Rounds a width up to a multiple of [`Self::BUILT_IN_STEPS_OF`] \[m\].
    pub fn built(&self, width: f64) -> f64 {
        let steps = ((width - ROUNDING).max(0.0) / Self::BUILT_IN_STEPS_OF).ceil();
        steps * Self::BUILT_IN_STEPS_OF
    }
}

impl FloorAssessment {
    /// Amplification above which a storey counts as worse \[–\].
    pub const WORSE: f64 = 1.1;

    /// Whether a response is more than [`Self::WORSE`] times the response alone in more than 16 % of the cases.
    pub fn is_worse(&self) -> bool {
        let all = [&self.drift, &self.shear, &self.acceleration];
        all.iter().any(|one| one.p84() > Self::WORSE)
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
        level: all.iter().any(|(_, one)| one.level),
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

/// Largest ratio of each case: peaks beside the neighbours over peaks alone. Leaves out a floor that only its neighbours move.
fn amplification(all: impl Iterator<Item = ([usize; 2], [f64; 2])>) -> Option<Distribution> {
    let ratio = |(case, [alone, beside]): ([usize; 2], [f64; 2])| {
        // A floor that never moves responds beside its neighbours as it does alone.
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
