//! One scene by both routes.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::class::{Class, rests};
use super::compared::{ALLOWED, Compared, NumberPlace, Stage, Two};
use super::condition::{Condition, Data, allowed, stopped_by};
use super::numbers::Numbers;
use super::touch::SAME;
use crate::listed::listed;
use crate::second_route::second_route_until;
use pounding_reference::Fineness;
use pounding_scene::{AuditedRun, Collapse, Error, Scene, Simulation};
use pounding_solver::{Pair, RunError};

/// Energy residual of an exact run that is always allowed \[–\].
pub const RESIDUAL: f64 = 1e-11;

/// Other settings of the second route: they change its rounding, and when bounces are over.
const OTHERWISE: [Fineness; 4] = [
    fine(1e-14, 7, 1e-12),
    fine(1e-13, 5, 1e-13),
    fine(1e-14, 4, 1e-12),
    fine(1e-13, 9, 1e-13),
];

const fn fine(tolerance: f64, steps_per_sample: u32, shortest: f64) -> Fineness {
    Fineness {
        tolerance,
        steps_per_sample,
        shortest,
    }
}

/// Factor on the largest difference between the tried settings of the second route. A smaller distance counts as its rounding.
const OWN: f64 = 3.0;

listed! {
    /// Verdict on a scene.
    pub enum Verdict { words: &'static str;
        /// All numbers are as close as allowed.
        Agrees = "agree",
        /// Some numbers are further apart than allowed.
        Disagrees = "disagree",
        /// Some numbers are further apart than allowed, but the second route differs from itself as much with other steps. The exact run
        /// may be right.
        SecondRouteRounds = "second rounds",
        /// Some numbers are further apart than allowed, but changes of the data as small as rounding move the exact run as much. Its
        /// rounding adds up over many touches.
        ExactRounds = "exact rounds",
        /// Some numbers are further apart than allowed, but the scene is so ill-conditioned that touches come and go with the last digits
        /// of its record.
        Unknowable = "ill-conditioned",
        /// The exact run fails in a way that is [documented](super::LIMITS).
        Named = "named limit",
        /// The exact run fails in any other way.
        ExactFails = "exact fails",
        /// The second route fails on a scene that the exact method runs.
        SecondRouteFails = "second fails",
        /// The scene cannot be prepared.
        Refused = "refused",
        /// A run does not end in time.
        Hangs = "hang",
        /// The program panicked.
        Panics = "panic",
    }
}

/// Reason why a scene has no numbers to compare.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// Name of the kind of error, as in the library; or the part of the work that hangs or panics.
    pub kind: String,
    /// The error message; may be empty.
    pub message: String,
}

/// A number that is further off than allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disagreement {
    /// The number by the exact method and by the second route.
    pub two: Two,
    /// The distance that the condition of the number allows.
    pub allowed: f64,
    /// The distance that is explained if the rounding of the exact run counts too.
    pub explained: f64,
    /// Largest distance of the second route from itself with other steps: relative \[–\], for instants \[s\].
    pub own: f64,
}

/// A scene after both routes.
#[derive(Debug, Clone)]
pub struct Checked {
    /// Number of the scene in the campaign.
    pub index: usize,
    /// Features of the scene.
    pub classes: Vec<Class>,
    /// The verdict.
    pub verdict: Verdict,
    /// For every kind of number the one that is furthest off, if it is further off than allowed; the worst kind is first.
    pub disagreements: Vec<Disagreement>,
    /// Reason why there are no numbers; `None` if no run failed.
    pub failure: Option<Failure>,
    /// Energy residual of the exact run \[–\]; `None` if the run did not end.
    pub residual: Option<f64>,
    /// Largest distance of every kind of number, in the order of [`Compared::ALL`]; meaningful if both runs ended and agree.
    pub largest: [f64; Compared::ALL.len()],
    /// Number of touches that only one of the routes has because rounding decides about them.
    pub grazes: usize,
    /// Number of touches of the exact run.
    pub touches: usize,
    /// Lines about the first touch that differs, with nearby touches of that pair by each route.
    pub story: Vec<String>,
}

/// A scene that ends at a collapse, which the second route does not know: both are compared until then.
fn until(scene: &Scene, collapse: Collapse) -> Scene {
    Scene {
        duration_s: Some(collapse.time_s),
        collapse_drift_ratio: Some(1.0),
        ..scene.clone()
    }
}

impl Checked {
    /// A scene without numbers; they may be added later.
    pub(super) fn new(index: usize, scene: &Scene, verdict: Verdict, failure: Option<Failure>) -> Self {
        Self {
            index,
            classes: Class::of(scene),
            verdict,
            disagreements: Vec::new(),
            failure,
            residual: None,
            largest: [0.0; Compared::ALL.len()],
            grazes: 0,
            touches: 0,
            story: Vec::new(),
        }
    }

    /// Runs a scene by both routes. `base` is the folder that the name of its record is relative to. `begin` is called at the start of each
    /// part of the work, and `stop` ends the runs.
    pub(super) fn run(index: usize, scene: &Scene, base: &Path, begin: &dyn Fn(Stage), stop: &'static AtomicBool) -> Self {
        let failed = |verdict, failure| Self::new(index, scene, verdict, Some(failure));
        begin(Stage::Exact);
        let prepared = match Simulation::new(scene, stopped_by(base, stop)) {
            Ok(prepared) => prepared,
            Err(error) => return failed(Verdict::Refused, Failure::of(&error)),
        };
        let AuditedRun { outcome, broken, balance } = match prepared.audited(None) {
            Ok(audited) => audited,
            Err(error) => {
                let mut failure = Failure::of(&error);
                if !room_explains(&prepared, &error) {
                    failure.kind += ", with room left";
                }
                return failed(failure.verdict(), failure);
            }
        };
        if let Some(collapse) = outcome.collapse {
            return Self::run(index, &until(scene, collapse), base, begin, stop);
        }
        begin(Stage::SecondRoute);
        let second = second_route_until(&prepared, Fineness::FINE, stop);
        let residual = residual(balance.residual);
        let failure = match (&broken, &second) {
            (Some(error), _) => Some(Failure::of(error)),
            (None, Err(error)) if residual.is_none() => Some(Failure::new(variant(error), error.to_string())),
            (None, _) => None,
        };
        let verdict = match (&broken, &failure) {
            (Some(_), Some(failure)) => failure.verdict(),
            (None, Some(_)) => Verdict::SecondRouteFails,
            (_, None) => Verdict::Disagrees,
        };
        let mut checked = Self {
            residual: Some(balance.residual),
            touches: outcome.collisions.all().len(),
            ..Self::new(index, scene, verdict, failure)
        };
        if rests(&prepared, &outcome) {
            checked.classes.push(Class::Rests);
        }
        match second {
            Ok(second) if broken.is_none() => {
                let exact = Numbers::of_exact(&prepared, &outcome);
                let second = Numbers::of_second_route(&prepared, &second);
                let data = Data {
                    prepared: &prepared,
                    scene,
                    base,
                    stop,
                };
                checked.compare(&data, exact, second, residual, begin);
            }
            Ok(_) => {}
            Err(_) => checked.disagreements = residual.into_iter().filter(|_| broken.is_none()).collect(),
        }
        checked
    }

    fn compare(&mut self, data: &Data<'_>, mut exact: Numbers, mut second: Numbers, residual: Option<Disagreement>, begin: &dyn Fn(Stage)) {
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
            own_rounding(data, &exact, &mut judged);
        }
        self.story = story(data.prepared, &exact, &second, &judged);
        judged.extend(residual);
        for (largest, what) in self.largest.iter_mut().zip(Compared::ALL) {
            let own = judged.iter().filter(|one| one.two.what == what);
            let held = own.filter(|one| !one.is_wrong() && one.two.distance.is_finite());
            *largest = held.map(|one| one.two.distance).fold(0.0, f64::max);
        }
        let of = |test: &dyn Fn(&Disagreement) -> bool| worst(&judged.iter().filter(|one| test(one)).copied().collect::<Vec<_>>());
        let wrong = of(&Disagreement::is_wrong);
        // Each route has its own uncertainty.
        let firm = wrong.iter().any(|one| one.two.distance > one.explained + OWN * one.own);
        let kinds = [
            (if firm { Verdict::Disagrees } else { Verdict::SecondRouteRounds }, wrong),
            (
                Verdict::Unknowable,
                of(&|one| one.two.distance > ALLOWED && one.explained.is_infinite()),
            ),
            (Verdict::ExactRounds, of(&|one| one.two.distance > one.allowed)),
        ];
        let found = kinds.into_iter().find(|(_, found)| !found.is_empty());
        (self.verdict, self.disagreements) = found.unwrap_or((Verdict::Agrees, Vec::new()));
    }
}

impl Disagreement {
    fn is_wrong(&self) -> bool {
        self.two.distance > self.explained
    }
}

/// Excuses touches that only one route has and whose start is uncertain by more than [`SAME`], and the number of touches of such a pair.
fn excuse_what_cannot_be_told(judged: &mut [Disagreement]) {
    let moves = |one: &&Disagreement| one.two.what == Compared::Start && one.explained > SAME;
    let mut untold: Vec<_> = judged.iter().filter(moves).map(|one| one.two.place).collect();
    let pairs: Vec<_> = untold
        .iter()
        .filter_map(|place| Some(NumberPlace::Pair(place.touch()?.0)))
        .collect();
    untold.extend(pairs);
    for one in judged {
        if one.two.distance.is_infinite() && untold.contains(&one.two.place) {
            one.explained = f64::INFINITY;
        }
    }
}

/// Describes the first touch that differs, by each route.
fn story(prepared: &Simulation, exact: &Numbers, second: &Numbers, judged: &[Disagreement]) -> Vec<String> {
    // A number that one route does not have says more than a number that is slightly off.
    let lacks = judged.iter().any(|one| one.two.distance.is_infinite());
    let wrong = judged
        .iter()
        .filter(|one| one.is_wrong() && one.two.distance.is_infinite() == lacks);
    let wrong = wrong.filter_map(|one| one.two.place.touch());
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

/// Repeats the second route with other steps and notes how far it differs from itself.
fn own_rounding(&Data { prepared, stop, .. }: &Data<'_>, exact: &Numbers, judged: &mut [Disagreement]) {
    for fineness in OTHERWISE {
        let Ok(response) = second_route_until(prepared, fineness, stop) else {
            continue;
        };
        let again = exact.beside(&Numbers::of_second_route(prepared, &response));
        for (one, again) in judged.iter_mut().zip(again) {
            let apart = (one.two.second - again.second).abs();
            let off = (one.two.second - one.two.first).abs();
            // Both differences are relative to one scale.
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

/// A disagreement for an energy residual above the allowed one.
fn residual(residual: f64) -> Option<Disagreement> {
    let large = residual.is_nan() || residual > RESIDUAL;
    large.then_some(Disagreement {
        two: Two {
            what: Compared::Residual,
            place: NumberPlace::Run,
            first: residual,
            second: 0.0,
            distance: residual,
        },
        allowed: RESIDUAL,
        explained: RESIDUAL,
        own: 0.0,
    })
}

/// For every kind the number that is furthest off, the worst kind first.
fn worst(all: &[Disagreement]) -> Vec<Disagreement> {
    let off = |one: &Disagreement| one.two.distance / one.allowed;
    let of = |what: Compared| {
        let own = all.iter().filter(|one| one.two.what == what).copied();
        own.reduce(|worst, next| if off(&next) > off(&worst) { next } else { worst })
    };
    let mut found: Vec<_> = Compared::ALL.into_iter().filter_map(of).collect();
    found.sort_by(|one, other| off(other).total_cmp(&off(one)));
    found
}

impl Failure {
    /// The failure for an error of the exact run.
    fn of(error: &Error) -> Self {
        let kind = if let Error::Run { source, .. } = error {
            variant(source)
        } else if let Error::Broken { source, .. } = error {
            variant(source)
        } else {
            variant(&error.refused().own_kind())
        };
        Self::new(kind, error.to_string())
    }

    pub(super) fn new(kind: String, message: String) -> Self {
        Self { kind, message }
    }

    /// The verdict on a scene whose exact run fails in this way.
    fn verdict(&self) -> Verdict {
        if self.is_known() { Verdict::Named } else { Verdict::ExactFails }
    }
}

/// Name of the variant of an error. New variants count separately without being listed here.
fn variant(error: &impl std::fmt::Debug) -> String {
    let text = format!("{error:?}");
    let end = text.find(|one: char| !one.is_alphanumeric());
    text[..end.unwrap_or(text.len())].into()
}

/// Rounding allowed in a distance between grounds \[m\].
const ROUNDING: f64 = 1e-9;

/// Whether a failing run is plausible. `false` if it ends because walls close in although gaps and grounds leave room for all structures
/// between them.
fn room_explains(prepared: &Simulation, error: &Error) -> bool {
    let Error::Run { source, .. } = error else {
        return true;
    };
    let RunError::ClosedIn { time, .. } = source else {
        return true;
    };
    let walls = prepared.walls();
    (0..walls.len()).any(|node| walls[node] && leaves_no_room(prepared, &walls, node, *time))
}

/// Whether a wall is as close to the next one on its right as the gaps of impulsive contacts between them allow.
fn leaves_no_room(prepared: &Simulation, walls: &[bool], wall: usize, time: f64) -> bool {
    let Some(travel) = prepared.travel() else {
        return false;
    };
    let (mut node, mut room) = (wall, 0.0);
    let right_of = |node: usize| {
        let mut pairs = prepared.pairs().iter();
        pairs.find(|pair| pair.left() == node && !pair.law.is_compliant())
    };
    while let Some(pair) = right_of(node) {
        (node, room) = (pair.right(), room + pair.gap());
        if walls[node] {
            return travel.opening([wall, node], time).displacement >= room - ROUNDING;
        }
    }
    false
}
