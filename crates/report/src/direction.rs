//! Both directions of shaking in the first lines of a run: nobody knows from which side an earthquake comes.

use std::mem::discriminant;

use pounding_scene::{Error, Excess, ExcessKind, Extras, PairOutcome, RecordUse, Review, RunResult, Simulation, Warning};

use pounding_text::{Unit, millimetres, short};

use super::Blow;
use crate::page::sentence;

/// The results of both directions of shaking.
#[derive(Debug)]
pub struct BothDirections {
    /// A sentence for each direction. The direction that is worse for the buildings comes first, unless the other run failed.
    pub sentences: [String; 2],
    /// Excesses and warnings of both runs, the most harmful first.
    pub notices: Vec<String>,
    /// The run in the direction opposite to the scene's. It is `None` if that run failed.
    pub other: Option<RunResult>,
}

/// Share of a limit that stands for a deck off its seat; a collapse is above it.
const UNSEATED: f64 = 1e12;

/// Two responses count as equal if they differ by less than this part of their size \[–\].
const SAME: f64 = 1e-9;

/// Runs the scene under the reversed record, by its own method.
///
/// # Errors
/// Those of [`Simulation::run`].
pub fn other_direction(prepared: &Simulation) -> Result<RunResult, Error> {
    prepared.under(|record| record.scaled(-1.0))?.run_with(Extras {
        closings: true,
        reversed_closings: true,
        drift_rates: true,
        ..Extras::default()
    })
}

/// Runs the scene under the reversed record, by the exact method.
///
/// # Errors
/// Those of [`Simulation::run`].
pub fn other_direction_exact(prepared: &Simulation) -> Result<RunResult, Error> {
    other_direction(&prepared.exact()?)
}

impl BothDirections {
    /// Compares a run and the run in the other direction.
    pub fn of(prepared: &Simulation, review: &Review, other: Result<RunResult, Error>) -> Self {
        let reversed = prepared.scene().record.reversed;
        let names = [reversed, !reversed].map(RecordUse::direction_of);
        let given = &review.outcome;
        match other {
            Ok(other) => Self {
                sentences: sentences(prepared, [(names[0], given), (names[1], &other)]),
                notices: notices(prepared, review, &other, names),
                other: Some(other),
            },
            Err(error) => Self {
                sentences: [
                    shaken(names[0], prepared, given),
                    sentence(&format!("{}: this run fails: {}", names[1], error.reason())),
                ],
                notices: review.notices(),
                other: None,
            },
        }
    }
}

/// Returns a sentence for each direction. The direction that strains the buildings more comes first. If both strain them equally, the one
/// that hits harder comes first.
fn sentences(prepared: &Simulation, mut both: [(&str, &RunResult); 2]) -> [String; 2] {
    let strain = |result: &RunResult| {
        let strain = prepared.strain(result);
        let (share, worst) = strain.map_or((0.0, String::new()), |(share, worst)| (share, worst.brief()));
        // Nothing that a building suffers is as bad as a deck that falls.
        match OffSeat::first(prepared, result) {
            Some(_) if share < UNSEATED => (UNSEATED + share, "a deck leaves its seat".into()),
            _ => (share, worst),
        }
    };
    let harm = |result: &RunResult| {
        let blow = Blow::all(result).into_iter().next();
        (touching(prepared, result), blow)
    };
    let mut strains = both.map(|(_, result)| strain(result));
    let [one, other] = [strains[0].0, strains[1].0];
    let differ = (one - other).abs() > SAME * one.max(other);
    let is_other = if differ { other > one } else { harm(both[1].1) > harm(both[0].1) };
    if is_other {
        both.reverse();
        strains.reverse();
    }
    let said = |side: usize| {
        let ((name, result), (_, worst)) = (both[side], &strains[side]);
        let said = shaken(name, prepared, result);
        match (differ, side) {
            (true, 0) => format!(
                "{said} This direction is worse for the {}s ({worst}).",
                prepared.scene().words().building
            ),
            (true, _) => format!("{said} Worst here: {worst}."),
            (false, 0) if !worst.is_empty() => format!("{said} Worst in either direction: {worst}."),
            (false, _) => said,
        }
    };
    [said(0), said(1)]
}

/// A run in a direction, in a sentence.
fn shaken(direction: &str, prepared: &Simulation, result: &RunResult) -> String {
    let comma = if prepared.floors().says_no_contact().is_some() { ':' } else { ',' };
    sentence(&format!("shaken {direction}{comma} {}", run_sentence(prepared, result)))
}

/// Returns the excesses of both directions, each kind at its worst, and the warnings.
fn notices(prepared: &Simulation, review: &Review, other: &RunResult, names: [&str; 2]) -> Vec<String> {
    let both = [review.excesses.clone(), prepared.excesses(other)];
    let of_kind = |one: &Excess| (one.kind, one.capacity.is_some());
    let mut kinds: Vec<(ExcessKind, bool)> = both.iter().flatten().map(of_kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let of = |side: usize, kind| both[side].iter().find(|one| of_kind(one) == kind);
    let excess = |kind: (ExcessKind, bool)| {
        let said = |side: usize, one: &Excess| format!("{}: {one}", names[side]);
        match (of(0, kind), of(1, kind)) {
            (Some(one), Some(other)) if (one.found - other.found).abs() <= SAME * one.found => Some(format!("both directions: {one}")),
            (Some(one), Some(other)) => {
                let (side, worse) = if other.share() > one.share() { (1, other) } else { (0, one) };
                Some(format!("both directions, worse {}", said(side, worse)))
            }
            (Some(one), None) => Some(said(0, one)),
            (None, Some(other)) => Some(said(1, other)),
            (None, None) => None,
        }
    };
    let excesses = kinds.into_iter().filter_map(excess);
    let warnings = review.warnings.iter().map(ToString::to_string);
    let mut of_other = prepared.passed(other);
    of_other.extend(prepared.warnings_before(other));
    let is_new = |one: &&Warning| {
        let mut known = review.warnings.iter();
        known.all(|known| discriminant(known) != discriminant(*one))
    };
    let of_other = of_other.iter().filter(is_new);
    let of_other = of_other.map(|one| format!("{}: {one}", names[1]));
    excesses.chain(warnings).chain(of_other).collect()
}

/// Number of pairs that touch.
fn touching(prepared: &Simulation, result: &RunResult) -> usize {
    let pairs = 0..prepared.pairs().len();
    pairs.filter(|pair| result.of_pair(*pair).collisions > 0).count()
}

/// Describes a run of a scene in a sentence: whether a storey collapses, how often floors touch, and how hard.
pub fn run_sentence(prepared: &Simulation, result: &RunResult) -> String {
    let touches = touch_sentence(prepared, result);
    let touches = match OffSeat::first(prepared, result) {
        Some(off) => format!("{}; {touches}", off.says()),
        None => touches,
    };
    match prepared.says_collapse(result) {
        Some(collapse) => format!("{collapse}; until then {touches}"),
        None => touches,
    }
}

/// The first deck of a run that leaves its seat.
#[derive(Debug)]
pub struct OffSeat {
    /// Instant \[s\].
    pub time: f64,
    /// Width of the seat \[m\].
    pub width: f64,
    /// What the seat belongs to, and the deck on it.
    pub names: [String; 2],
}

impl OffSeat {
    /// Looks for it; `None` if none does.
    pub fn first(prepared: &Simulation, result: &RunResult) -> Option<Self> {
        let passed = prepared.passed(result).into_iter();
        let off = passed.filter_map(|one| {
            if let Warning::Unseated { names, width, time, .. } = one {
                Some(Self { time, width, names })
            } else {
                None
            }
        });
        off.min_by(|one, other| one.time.total_cmp(&other.time))
    }

    fn says(&self) -> String {
        let [support, deck] = &self.names;
        let (width, time) = (millimetres(self.width), short(self.time));
        format!("{deck} leaves its seat of {width} mm on {support} at {time} s")
    }
}

fn touch_sentence(prepared: &Simulation, result: &RunResult) -> String {
    let all = PairOutcome::of(result.collisions.all());
    let pairs = prepared.pairs().len();
    let excesses = prepared.excesses(result);
    let unwatched = excesses.iter().filter(|one| one.kind.is_unwatched());
    let unwatched: Vec<String> = unwatched.map(|one| format!("; {}", one.brief())).collect();
    let unwatched = unwatched.concat();
    if let Some(said) = prepared.floors().says_no_contact() {
        return format!("{said}{unwatched}");
    }
    let Some(hardest) = Blow::all(result).into_iter().next() else {
        return if unwatched.is_empty() {
            "no floors touch".into()
        } else {
            format!("no floors that were looked at touch{unwatched}")
        };
    };
    let how = how_hard(prepared, result, &hardest);
    let times = match all.collisions {
        1 => "once".into(),
        2 => "twice".into(),
        n => format!("{n} times"),
    };
    let at = match pairs {
        1 => String::new(),
        _ if prepared.floors().facing().iter().any(|one| one.column.is_some()) => {
            format!(", at {} of {pairs} places", touching(prepared, result))
        }
        _ => format!(", at {} of {pairs} pairs of floors", touching(prepared, result)),
    };
    format!("floors touch {times}{at}, {how}{unwatched}")
}

/// How hard a pair touches, and where: with which force, or how fast.
fn how_hard(prepared: &Simulation, result: &RunResult, hardest: &Blow) -> String {
    let [left, right] = prepared.floors().names(hardest.pair);
    let place = if prepared.pairs().len() > 1 {
        format!(" ({left} – {right})")
    } else {
        String::new()
    };
    let in_kn = |force: f64| Unit::POUNDING_FORCE.text_of(force, 1.0);
    let is_compliant = prepared.pairs()[hardest.pair].law.is_compliant();
    let how = match *hardest {
        // Of impulsive contact a force is that of rest.
        Blow { force: Some(force), .. } if !is_compliant => format!("pressing with up to {} kN{place}", in_kn(force)),
        Blow { force: Some(force), .. } => format!(
            "with up to {} kN{place}, several times more or less with another contact stiffness",
            in_kn(force)
        ),
        Blow { speed: Some(speed), .. } => format!("at up to {} m/s{place}", short(speed)),
        Blow { impulse, .. } => format!("with up to {} kN·s{place}", short(1e-3 * impulse)),
    };
    // The ground or a residual drift may press two buildings together without a hard hit.
    let found = result.of_pair(hardest.pair);
    let largest = found.largest.map(|largest| largest.start.to_bits());
    let push = result
        .leaning(prepared, hardest.pair)
        .filter(|longest| largest == Some(longest.start.to_bits()));
    let push = push.map_or_else(String::new, |push| {
        format!(
            "; the largest impulse is that of a push of {} s, no blow",
            short(push.end - push.start)
        )
    });
    format!("{how}{push}")
}
