//! A row under many motions: whether its gaps are enough, what touching does, and how certain both are.

use std::collections::BTreeSet;

use pounding_scene::{Error, ExcessKind, Floors, Scene};

use crate::distribution::{Case, Distribution, ratios_of_cases};
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
    /// Number of cases that are [not believed while the buildings stand alone](AssessedRun::disbelieved_alone). No width comes from them,
    /// unless all are.
    pub disbelieved_alone: usize,
    /// Number of cases that are not believed, alone or [beside the neighbours](AssessedRun::disbelieved_beside). No effect of touching comes
    /// from them, unless all are.
    pub disbelieved: usize,
    /// Number of cases in which a storey collapses under gravity; they are among those that are not believed.
    pub collapsed: usize,
    /// Number of cases in which a storey collapses while the buildings stand alone: no width of a gap helps against it.
    pub collapsed_alone: usize,
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
    pub fn of(all: &[(Case, &Separation)]) -> Option<Self> {
        let required = all.iter().map(|(case, one)| (*case, one.required));
        let required = Distribution::of_cases(required)?;
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

/// Ratio of the largest to the least value over the contact stiffness \[–\], each the largest of the runs of a case: the largest of every storey
/// or pair that touches, for each case.
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

/// Effect of touching on a floor and the storey below it: responses beside the neighbours over responses alone \[–\], each the largest of the
/// runs of a case that touch. It covers every case in which something touches the building, or all cases if nothing ever does.
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
    /// Least and largest of these drifts over the contact stiffness \[m\].
    pub largest_drift_range: [f64; 2],
    /// Largest drift of the building alone in these runs \[m\].
    pub largest_drift_alone: f64,
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
    /// Number of cases in which the right floor leaves its seat; `None` if there is no seat.
    pub unseated: Option<usize>,
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
    /// Its case.
    pub fn case(&self) -> Case {
        [self.event, self.neighbour]
    }

    fn is_doubted_alone(&self) -> bool {
        self.run.disbelieved_alone.is_some()
    }

    /// Whether a storey collapses while the buildings stand alone. A collapse is always what is farthest beyond belief.
    fn falls_alone(&self) -> bool {
        let doubted = self.run.disbelieved_alone.as_ref();
        doubted.is_some_and(|one| one.kind == ExcessKind::Collapse)
    }

    fn is_doubted(&self) -> bool {
        self.is_doubted_alone() || self.run.disbelieved_beside.is_some()
    }

    /// The runs that widths come from: those of the cases that are believed while the buildings stand alone, or all runs if no case is.
    pub fn believed_alone(runs: &[Self]) -> Vec<Self> {
        believed(runs, Self::is_doubted_alone).0
    }

    /// The runs that effects of touching come from: those of the cases that are believed, or all runs if no case is.
    pub fn believed(runs: &[Self]) -> Vec<Self> {
        believed(runs, Self::is_doubted).0
    }
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
        let (believed_alone, disbelieved_alone) = believed(runs, RunOfCase::is_doubted_alone);
        let (believed, disbelieved) = believed(runs, RunOfCase::is_doubted);
        let row = AssessedRow {
            scene,
            floors: &floors,
            all: runs,
            alone: &believed_alone,
            runs: &believed,
        };
        Ok(Some(Self {
            runs: runs.len(),
            events: count(runs.iter().map(|one| one.event)),
            cases: count(runs.iter().map(RunOfCase::case)),
            disbelieved_alone,
            disbelieved,
            collapsed: count(runs.iter().filter(|one| one.run.collapsed).map(RunOfCase::case)),
            collapsed_alone: count(runs.iter().filter(|one| one.falls_alone()).map(RunOfCase::case)),
            by_stiffness: row.by_stiffness(),
            gaps: (0..first.separations.len()).filter_map(|index| row.gap(index)).collect(),
            floors: (0..first.floors.len()).map(|floor| row.floor(floor)).collect(),
            pairs: (0..first.pairs.len()).map(|pair| row.pair(pair)).collect(),
        }))
    }

    /// Number of cases that widths come from; 0 if no case is believed.
    pub fn believed_alone(&self) -> usize {
        self.cases - self.disbelieved_alone
    }
}

/// Returns the runs of all cases that are believed, or all runs if no case is, and the number of cases that are not.
fn believed<'r>(runs: &[RunOfCase<'r>], is_doubted: impl Fn(&RunOfCase<'r>) -> bool) -> (Vec<RunOfCase<'r>>, usize) {
    let doubted = runs.iter().filter(|one| is_doubted(one));
    let doubted: BTreeSet<Case> = doubted.map(RunOfCase::case).collect();
    let others = runs.iter().filter(|one| !doubted.contains(&one.case()));
    let others: Vec<RunOfCase<'r>> = others.copied().collect();
    (if others.is_empty() { runs.to_vec() } else { others }, doubted.len())
}

/// A row and its runs.
struct AssessedRow<'r> {
    scene: &'r Scene,
    floors: &'r Floors,
    /// All runs, which tell what touches.
    all: &'r [RunOfCase<'r>],
    /// The runs that widths come from: those that are believed alone, or all if none is.
    alone: &'r [RunOfCase<'r>],
    /// The runs that effects of touching come from: those that are believed, or all if none is.
    runs: &'r [RunOfCase<'r>],
}

impl<'r> AssessedRow<'r> {
    fn gap(&self, index: usize) -> Option<GapAssessment> {
        let of = |one: &RunOfCase<'r>| (one.case(), &one.run.separations[index]);
        let all: Vec<(Case, &Separation)> = self.alone.iter().map(of).collect();
        let left = all.first()?.1.left;
        let own = self.scene.contacts.as_ref().and_then(|all| all.get(left));
        let facing = self.floors.facing();
        let pairs: Vec<usize> = (0..facing.len()).filter(|pair| facing[*pair].contact == left).collect();
        let touches = |run: &AssessedRun| pairs.iter().any(|pair| run.pairs[*pair].collisions > 0);
        let touching = self.all.iter().filter(|one| touches(one.run));
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
    fn hits(&self, floor: usize) -> Vec<(Case, &AssessedFloor)> {
        let building = self.floors.all()[floor].structure;
        let hit = self.runs.iter();
        let hit = hit.filter(|one| one.run.hits(self.floors, building));
        hit.map(|one| (one.case(), &one.run.floors[floor])).collect()
    }

    /// Assesses a pair: its touches in all runs, and its numbers in those that count, or in all if it touches in no other.
    fn pair(&self, pair: usize) -> PairAssessment {
        let of = |runs: &'r [RunOfCase<'r>]| -> Vec<(Case, &'r AssessedPair)> {
            let own = runs.iter().map(|one| (one.case(), &one.run.pairs[pair]));
            own.filter(|(_, one)| one.collisions > 0).collect()
        };
        let (all, counted) = (of(self.all), of(self.runs));
        let unseated = self.all.iter().filter(|one| one.run.pairs[pair].unseated.is_some());
        let facing = &self.floors.facing()[pair];
        let contact = self.scene.contacts.as_ref().and_then(|all| all.get(facing.contact));
        let seat = contact.and_then(|one| one.seat_width_m).filter(|_| facing.column.is_none());
        PairAssessment {
            unseated: seat.map(|_| count(unseated.map(RunOfCase::case))),
            ..assessed_pair(
                if counted.is_empty() { &all } else { &counted },
                count(all.iter().map(|(case, _)| *case)),
            )
        }
    }

    fn by_stiffness(&self) -> Option<StiffnessEffect> {
        let moving = (0..self.floors.all().len()).filter(|floor| !self.floors.all()[*floor].is_wall());
        let floors: Vec<Vec<(Case, &AssessedFloor)>> = moving.map(|floor| self.hits(floor)).collect();
        let of = |peak: fn(&FloorPeaks) -> f64| {
            let ratios = floors.iter().flat_map(|hits| {
                let both = hits.iter().map(|(case, one)| (*case, one.over_stiffness.each_ref().map(peak)));
                ratios_of_cases(both)
            });
            Distribution::of_cases(ratios)
        };
        let pairs = 0..self.floors.facing().len();
        let impulses = pairs.flat_map(|pair| {
            let own = self.runs.iter().map(|one| (one.case(), &one.run.pairs[pair]));
            ratios_of_cases(own.filter_map(|(case, one)| Some((case, one.peak_force.and(one.largest_impulse)?))))
        });
        Some(StiffnessEffect {
            drift: of(|peaks| peaks.drift)?,
            acceleration: of(|peaks| peaks.acceleration)?,
            impulse: Distribution::of_cases(impulses)?,
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

    /// Whether a response is more than [`Self::WORSE`] times the response alone: in more than 16 % of the cases, or in any of few.
    pub fn is_worse(&self) -> bool {
        let all = [&self.drift, &self.shear, &self.acceleration];
        all.iter().any(|one| one.upper() > Self::WORSE)
    }
}

fn ruled(rule: Rule, all: &[(Case, &Separation)]) -> Option<RuleAssessment> {
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
        width: Distribution::of_cases(of_cases)?,
        too_narrow: narrow.len(),
        least_share,
        level: all.iter().any(|(_, one)| one.level),
    })
}

fn assessed_floor(all: &[(Case, &AssessedFloor)]) -> Option<FloorAssessment> {
    let largest = |of: fn(&AssessedFloor) -> f64| all.iter().map(|(_, one)| of(one)).fold(0.0, f64::max);
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
        largest_drift: largest(|one| one.beside.drift),
        largest_drift_range: [
            largest(|one| one.over_stiffness[0].drift),
            largest(|one| one.over_stiffness[1].drift),
        ],
        largest_drift_alone: largest(|one| one.alone.drift),
    })
}

/// Peaks beside the neighbours over peaks alone, case by case. Leaves out a floor that only its neighbours move.
fn amplification(all: impl Iterator<Item = (Case, [f64; 2])>) -> Option<Distribution> {
    Distribution::of_cases(ratios_of_cases(all))
}

/// Assesses a pair in runs in which it touches.
fn assessed_pair(all: &[(Case, &AssessedPair)], touching: usize) -> PairAssessment {
    let over = |range: fn(&AssessedPair) -> Option<[f64; 2]>| {
        let ranges = all.iter().filter_map(|(case, one)| Some((*case, range(one)?)));
        let end = |end: usize| Distribution::of_cases(ranges.clone().map(|(case, both)| (case, both[end])));
        Some([end(0)?, end(1)?])
    };
    PairAssessment {
        touching,
        peak_force: over(|one| one.peak_force),
        largest_impulse: over(|one| one.largest_impulse),
        approach_speed: all.iter().filter_map(|(_, one)| one.approach_speed).reduce(f64::max),
        unseated: None,
    }
}
