//! Both directions of shaking in the first lines of a run: nobody knows from which side an earthquake comes.

use pounding_scene::{Error, PairOutcome, RunResult, Simulation};

use pounding_text::short;

use super::Blow;

/// Runs the scene under the reversed record, by its own method.
///
/// # Errors
/// Those of [`Simulation::run`].
pub fn other_direction(prepared: &Simulation) -> Result<RunResult, Error> {
    prepared.under(|record| record.scaled(-1.0))?.run(None)
}

/// The same by the exact method.
///
/// # Errors
/// Those of [`Simulation::run`].
pub fn other_direction_exact(prepared: &Simulation) -> Result<RunResult, Error> {
    other_direction(&prepared.exact()?)
}

/// What each direction does, the worse one first.
pub fn direction_sentences(
    prepared: &Simulation,
    given: &RunResult,
    other: &Result<RunResult, Error>,
) -> [String; 2] {
    let reversed = prepared.scene().record.reversed;
    let names = if reversed {
        ["reversed, as in the scene", "as recorded"]
    } else {
        ["as recorded", "reversed"]
    };
    let other = match other {
        Ok(other) => other,
        Err(error) => {
            return [
                format!("{}: {}", names[0], run_sentence(prepared, given)),
                format!("{}: this run fails: {}", names[1], error.reason()),
            ];
        }
    };
    let mut both = [(names[0], given), (names[1], other)];
    let harm = |result: &RunResult| {
        (
            touching(prepared, result),
            Blow::all(result).into_iter().next(),
        )
    };
    if harm(other) > harm(given) {
        both.reverse();
    }
    both.map(|(name, result)| format!("{name}: {}", run_sentence(prepared, result)))
}

/// Number of pairs that touch.
fn touching(prepared: &Simulation, result: &RunResult) -> usize {
    let pairs = 0..prepared.pairs().len();
    pairs
        .filter(|pair| result.of_pair(*pair).collisions > 0)
        .count()
}

/// What a run of a scene comes to, in a sentence: how often floors touch, and how hard.
pub fn run_sentence(prepared: &Simulation, result: &RunResult) -> String {
    let all = PairOutcome::of(result.collisions.all());
    let pairs = prepared.pairs().len();
    let Some(hardest) = Blow::all(result).into_iter().next() else {
        return "nothing touches".into();
    };
    let [left, right] = prepared.floors().names(hardest.pair);
    let is_compliant = prepared.pairs()[hardest.pair].law.is_compliant();
    let how = match hardest {
        // Of impulsive contact a force is that of rest.
        Blow {
            force: Some(force), ..
        } if !is_compliant => format!("pressing with up to {} kN", short(1e-3 * force)),
        Blow {
            force: Some(force), ..
        } => format!(
            "with up to {} kN by the contact stiffness of the scene",
            short(1e-3 * force)
        ),
        Blow {
            speed: Some(speed), ..
        } => format!("at up to {} m/s", short(speed)),
        Blow { impulse, .. } => format!("with up to {} kN·s", short(1e-3 * impulse)),
    };
    let times = match all.collisions {
        1 => "once".into(),
        2 => "twice".into(),
        n => format!("{n} times"),
    };
    let at = match pairs {
        1 => String::new(),
        _ => format!(
            ", at {} of {pairs} pairs of floors",
            touching(prepared, result)
        ),
    };
    let place = if pairs > 1 {
        format!(" ({left} – {right})")
    } else {
        String::new()
    };
    format!("they touch {times}{at}, {how}{place}")
}
