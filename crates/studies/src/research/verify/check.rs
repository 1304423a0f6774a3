//! One scene by both routes.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::class::{Class, rests};
use super::compared::{Compared, Place, Two};
use super::condition::{Condition, Data, allowed, stopped_by};
use super::meeting::SAME;
use super::numbers::Numbers;
use super::room;
use super::stage::{ALLOWED, Stage};
use pounding_reference::Fineness;
use pounding_scene::{Audited, Scene, Simulation};
use pounding_solver::Pair;

/// Residual of the energy of an exact run that is always allowed \[–\].
pub const RESIDUAL: f64 = 1e-11;

/// Other settings of the second route, under which its own rounding is another one.
const OTHERWISE: [Fineness; 4] = [
    Fineness {
        tolerance: 1e-14,
        steps_per_sample: 7,
    },
    Fineness {
        tolerance: 1e-13,
        steps_per_sample: 5,
    },
    Fineness {
        tolerance: 1e-14,
        steps_per_sample: 4,
    },
    Fineness {
        tolerance: 1e-13,
        steps_per_sample: 9,
    },
];
/// A distance up to so many times what a route differs from itself, in the few ways that are tried, is its own rounding.
const OWN: f64 = 3.0;

/// What becomes of a scene.
#[derive(Debug, Clone)]
pub enum Verdict {
    /// All numbers are as close as is allowed.
    Agrees,
    /// Some are not: of every kind the one that is furthest off, the worst kind first.
    Disagrees(Vec<Disagreement>),
    /// Some are not, but the second route differs from itself by as much where it takes other steps: the exact run may be right.
    SecondRouteRounds(Vec<Disagreement>),
    /// Some are not, but changes of the data as small as rounding move the exact run by as much: it rounds over many touches.
    ExactRounds(Vec<Disagreement>),
    /// They are not, but the scene is so ill-conditioned that their touches come and go with the last digits of its record.
    Unknowable(Vec<Disagreement>),
    /// The exact run fails.
    ExactFails(Failure),
    /// The second route fails on a scene that the exact method runs.
    SecondRouteFails(Failure),
    /// The scene cannot be prepared.
    Refused(Failure),
    /// It does not end in time; in which part of the work.
    Hangs(Stage),
    /// A fault of the program stopped it.
    Panics(Stage),
}

/// Why a run failed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// Name of the kind of error, as the library calls it.
    pub kind: String,
    /// The error in words.
    pub message: String,
}

/// A number that is further off than allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disagreement {
    /// The number by the exact method and by the second route.
    pub two: Two,
    /// The distance that its condition allows.
    pub allowed: f64,
    /// The distance that is explained where what the exact run rounds counts too.
    pub explained: f64,
    /// How far the second route is from itself where it takes other steps: relative \[–\], of instants \[s\].
    pub own: f64,
}

/// A scene by both routes.
#[derive(Debug, Clone)]
pub struct Checked {
    /// Its number in the campaign.
    pub index: usize,
    /// What is in it.
    pub classes: Vec<Class>,
    /// What becomes of it.
    pub verdict: Verdict,
    /// Residual of the energy of the exact run \[–\], where it ended.
    pub residual: Option<f64>,
    /// Largest distance of every kind of number, in the order of [`Compared::ALL`], where both runs ended and agree.
    pub largest: [f64; Compared::ALL.len()],
    /// Touches that one of the routes has and the other has not, which rounding decides.
    pub grazes: usize,
    /// Touches of the exact run.
    pub touches: usize,
    /// Where touches of the routes first differ, and the touches of that pair about then by each, a line for each.
    pub story: Vec<String>,
}

impl Checked {
    /// Of a scene of which nothing is known but its classes.
    pub(super) fn new(index: usize, scene: &Scene, verdict: Verdict) -> Self {
        Self {
            index,
            classes: Class::of(scene),
            verdict,
            residual: None,
            largest: [0.0; Compared::ALL.len()],
            grazes: 0,
            touches: 0,
            story: Vec::new(),
        }
    }

    /// Runs a scene by both routes; `base` is the folder that its record is looked for from, `begin` is told what begins, and `stop` ends
    /// its exact runs.
    pub(super) fn run((index, scene): (usize, &Scene), base: &Path, (begin, stop): (&dyn Fn(Stage), &'static AtomicBool)) -> Self {
        let ended = |verdict| Self::new(index, scene, verdict);
        begin(Stage::Exact);
        let prepared = match Simulation::new(scene, stopped_by(base, stop)) {
            Ok(prepared) => prepared,
            Err(error) => return ended(Verdict::Refused(Failure::of(&error))),
        };
        let Audited { outcome, broken, balance } = match prepared.audited(None) {
            Ok(audited) => audited,
            Err(error) => {
                let mut failure = Failure::of(&error);
                if !room::is_explained(&prepared, &error) {
                    failure.kind += ", with room left";
                }
                return ended(Verdict::ExactFails(failure));
            }
        };
        let mut checked = Self {
            residual: Some(balance.residual),
            touches: outcome.collisions.all().len(),
            ..ended(Verdict::Agrees)
        };
        if rests(&prepared, &outcome) {
            checked.classes.push(Class::Rests);
        }
        begin(Stage::SecondRoute);
        let second = crate::second_route(&prepared, Fineness::FINE);
        let residual = residual(balance.residual);
        checked.verdict = match (broken, second) {
            (Some(error), _) => Verdict::ExactFails(Failure::of(&error)),
            (None, Err(_)) if residual.is_some() => Verdict::Disagrees(residual.into_iter().collect()),
            (None, Err(error)) => Verdict::SecondRouteFails(Failure {
                kind: variant(&error),
                message: error.to_string(),
            }),
            (None, Ok(second)) => {
                let exact = Numbers::of_exact(&prepared, &outcome);
                let second = Numbers::of_second_route(&prepared, &second);
                let data = Data {
                    prepared: &prepared,
                    scene,
                    base,
                    stop,
                };
                checked.compare(&data, (exact, second, residual), begin)
            }
        };
        checked
    }

    fn compare(
        &mut self,
        data: &Data<'_>,
        (mut exact, mut second, residual): (Numbers, Numbers, Option<Disagreement>),
        begin: &dyn Fn(Stage),
    ) -> Verdict {
        self.grazes = exact.without_grazes(&mut second);
        let all = exact.beside(&second);
        let close = |two: &Two| two.distance <= ALLOWED;
        let conditions = if all.iter().all(close) {
            vec![Condition::default(); all.len()]
        } else {
            begin(Stage::Condition);
            data.conditions(&exact, &all, begin)
        };
        let judged = all.iter().zip(conditions);
        let judged = judged.map(|(two, condition)| Disagreement {
            two: *two,
            allowed: allowed(two, condition.of_data.unwrap_or_default()),
            explained: allowed(two, OWN * condition.with_rounding),
            own: 0.0,
        });
        let mut judged: Vec<_> = judged.collect();
        if judged.iter().any(Disagreement::is_wrong) {
            excuse_what_cannot_be_told(&mut judged);
        }
        if judged.iter().any(Disagreement::is_wrong) {
            begin(Stage::SecondRoute);
            own_rounding(data.prepared, &exact, &mut judged);
        }
        self.story = story(data.prepared, &exact, &second, &judged);
        judged.extend(residual);
        for (largest, what) in self.largest.iter_mut().zip(Compared::ALL) {
            let own = judged.iter().filter(|one| one.two.what == what);
            let held = own.filter(|one| !one.is_wrong() && one.two.distance.is_finite());
            *largest = held.map(|one| one.two.distance).fold(0.0, f64::max);
        }
        let wrong: Vec<_> = judged.iter().filter(|one| one.is_wrong()).collect();
        let wrong = worst(&wrong);
        let firm = wrong.iter().any(|one| one.two.distance > OWN * one.own);
        let unknown = judged
            .iter()
            .filter(|one| one.two.distance > ALLOWED && one.explained.is_infinite());
        let unknown = worst(&unknown.collect::<Vec<_>>());
        let rounded = judged.iter().filter(|one| one.two.distance > one.allowed);
        let rounded = worst(&rounded.collect::<Vec<_>>());
        if firm {
            Verdict::Disagrees(wrong)
        } else if !wrong.is_empty() {
            Verdict::SecondRouteRounds(wrong)
        } else if !unknown.is_empty() {
            Verdict::Unknowable(unknown)
        } else if !rounded.is_empty() {
            Verdict::ExactRounds(rounded)
        } else {
            Verdict::Agrees
        }
    }
}

impl Disagreement {
    fn is_wrong(&self) -> bool {
        self.two.distance > self.explained
    }
}

/// A touch whose start moves by more than tells it from others, and how many such a pair has, cannot be compared where one route lacks one.
fn excuse_what_cannot_be_told(judged: &mut [Disagreement]) {
    let moves = |one: &&Disagreement| one.two.what == Compared::Start && one.explained > SAME;
    let mut untold: Vec<_> = judged.iter().filter(moves).map(|one| one.two.place).collect();
    let pairs = untold.iter().filter_map(|place| match *place {
        Place::Touch { pair, .. } => Some(Place::Pair(pair)),
        Place::Floor(_) | Place::Pair(_) | Place::Run => None,
    });
    let pairs: Vec<_> = pairs.collect();
    untold.extend(pairs);
    for one in judged {
        if one.two.distance.is_infinite() && untold.contains(&one.two.place) {
            one.explained = f64::INFINITY;
        }
    }
}

/// Where touches first differ, and what each route says of them.
fn story(prepared: &Simulation, exact: &Numbers, second: &Numbers, judged: &[Disagreement]) -> Vec<String> {
    // A number that one route does not have says more than one that is a little off.
    let lacks = judged.iter().any(|one| one.two.distance.is_infinite());
    let wrong = judged
        .iter()
        .filter(|one| one.is_wrong() && one.two.distance.is_infinite() == lacks);
    let wrong = wrong.filter_map(|one| match one.two.place {
        Place::Touch { pair, touch } => Some((pair, touch)),
        Place::Floor(_) | Place::Pair(_) | Place::Run => None,
    });
    let Some((pair, time)) = exact.first_of(wrong, second) else {
        return Vec::new();
    };
    let Pair { relation, law } = &prepared.pairs()[pair];
    let gap = &relation.offset;
    let [left, right] = prepared.floors().names(pair);
    let first = format!("first at {time:.9} s, pair {pair}: {left} and {right}, {}, gap {gap} m", law.name());
    let of = |name: &str, numbers: &Numbers| {
        let near = numbers.near(pair, time).into_iter();
        let near = near.map(|words| format!("  {name} {words}"));
        near.collect::<Vec<_>>()
    };
    let lines = [vec![first], of("exact ", exact), of("second", second)];
    lines.concat()
}

/// Asks the second route again with other steps.
fn own_rounding(prepared: &Simulation, exact: &Numbers, judged: &mut [Disagreement]) {
    for fineness in OTHERWISE {
        let Ok(response) = crate::second_route(prepared, fineness) else {
            continue;
        };
        let again = exact.beside(&Numbers::of_second_route(prepared, &response));
        for (one, again) in judged.iter_mut().zip(again) {
            let apart = (one.two.second - again.second).abs();
            let off = (one.two.second - one.two.first).abs();
            // Both relative to the same scale.
            let own = if off.is_finite() && off > 0.0 && apart.is_finite() {
                one.two.distance * (apart / off)
            } else if one.two.distance.is_finite() == again.distance.is_finite() {
                0.0
            } else {
                f64::INFINITY
            };
            one.own = one.own.max(own);
        }
    }
}

/// A residual of the energy above the allowed one.
fn residual(residual: f64) -> Option<Disagreement> {
    let large = residual.is_nan() || residual > RESIDUAL;
    large.then_some(Disagreement {
        two: Two {
            what: Compared::Residual,
            place: Place::Run,
            first: residual,
            second: 0.0,
            distance: residual,
        },
        allowed: RESIDUAL,
        explained: RESIDUAL,
        own: 0.0,
    })
}

/// Of every kind the number that is furthest off, the worst kind first.
fn worst(all: &[&Disagreement]) -> Vec<Disagreement> {
    let off = |one: &Disagreement| one.two.distance / one.allowed;
    let of = |what: Compared| {
        let own = all.iter().filter(|one| one.two.what == what);
        own.map(|one| **one)
            .reduce(|worst, next| if off(&next) > off(&worst) { next } else { worst })
    };
    let mut found: Vec<_> = Compared::ALL.into_iter().filter_map(of).collect();
    found.sort_by(|one, other| off(other).total_cmp(&off(one)));
    found
}

impl Failure {
    fn of(error: &pounding_scene::Error) -> Self {
        let kind = if let pounding_scene::Error::Run { source, .. } = error {
            variant(source)
        } else if let pounding_scene::Error::Broken { source, .. } = error {
            variant(source)
        } else {
            variant(&error.refused().own_kind())
        };
        Self {
            kind,
            message: error.to_string(),
        }
    }
}

/// Name of the variant of an error: new ones are counted apart without being listed here.
fn variant(error: &impl std::fmt::Debug) -> String {
    let text = format!("{error:?}");
    let end = text.find(|one: char| !one.is_alphanumeric());
    text[..end.unwrap_or(text.len())].into()
}
