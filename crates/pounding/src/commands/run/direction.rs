//! Both directions of shaking in the first lines of a run: nobody knows from which side an earthquake comes.

use pounding::scene::{Error, PairOutcome, RunResult, Simulation};

use crate::text::{paragraph, short};

/// Runs the scene under the reversed record, by its own method.
pub(super) fn other(prepared: &Simulation) -> Result<RunResult, Error> {
    prepared.under(|record| record.scaled(-1.0))?.run(None)
}

/// What each direction does, the worse one first.
pub(super) fn text(
    prepared: &Simulation,
    given: &RunResult,
    other: &Result<RunResult, Error>,
) -> String {
    let reversed = prepared.scene().record.reversed;
    let names = if reversed {
        ["reversed, as in the scene", "as recorded"]
    } else {
        ["as recorded", "reversed"]
    };
    let other = match other {
        Ok(other) => other,
        Err(error) => {
            let lines = [
                format!("{}: {}", names[0], said(prepared, given)),
                format!("{}: this run fails: {}", names[1], error.reason()),
            ];
            return paragraph("Answer", &lines.join("\n"));
        }
    };
    let mut both = [(names[0], given), (names[1], other)];
    let harm = |result: &RunResult| (touching(prepared, result), impulse(result));
    if harm(other) > harm(given) {
        both.reverse();
    }
    let lines = both.map(|(name, result)| format!("{name}: {}", said(prepared, result)));
    paragraph("Answer", &lines.join("\n"))
}

/// Number of pairs that touch.
fn touching(prepared: &Simulation, result: &RunResult) -> usize {
    let pairs = 0..prepared.pairs().len();
    pairs
        .filter(|pair| result.of_pair(*pair).collisions > 0)
        .count()
}

/// Largest impulse of a collision \[N·s\].
fn impulse(result: &RunResult) -> f64 {
    let all = PairOutcome::of(result.collisions.all());
    all.largest.map_or(0.0, |largest| largest.impulse)
}

fn said(prepared: &Simulation, result: &RunResult) -> String {
    let all = PairOutcome::of(result.collisions.all());
    let pairs = prepared.pairs().len();
    let Some(largest) = all.largest else {
        return "nothing touches".into();
    };
    let [left, right] = prepared.floors().names(largest.pair);
    let forces = result
        .collisions
        .all()
        .iter()
        .filter_map(|one| one.peak_force);
    let force = forces.reduce(f64::max).map_or(String::new(), |force| {
        format!(
            ", up to {} kN with the contact stiffness of the scene",
            short(1e-3 * force)
        )
    });
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
    format!(
        "they touch {times}{at}{force}; largest impulse {} kN·s, {left} – {right}",
        short(1e-3 * largest.impulse)
    )
}
