//! The answer in a few sentences: whether floors touch, how often, how hard, and how accurate these results are.

use pounding_scene::{Errors, PairQuantity, QuantityGroup, Review};
use pounding_text::{Manner, NONE, Unit, percent, short};

use crate::summary::{CollisionSummary, PairSummary, Summary};

/// More pairs than this are counted, not named.
const MOST: usize = 5;

/// Returns the pairs that touch. Pairs with a larger impulse come first.
fn touching(summary: &Summary) -> Vec<(&PairSummary, &CollisionSummary)> {
    let pairs = summary.pairs.iter();
    let mut touching: Vec<_> = pairs.filter_map(|pair| Some((pair, pair.largest.as_ref()?))).collect();
    touching.sort_by(|one, other| other.1.impulse_n_s.total_cmp(&one.1.impulse_n_s));
    touching
}

/// The box at the top of the page.
pub(super) fn manner(summary: &Summary) -> Manner {
    Manner::Verdict {
        before: 0,
        touch: !touching(summary).is_empty() || exact_collisions(summary).is_some_and(|exact| exact > 0),
    }
}

/// Returns the answer, its assumptions, and how accurate it is.
pub(super) fn lines(summary: &Summary, review: &Review) -> Vec<String> {
    let (touching, exact) = (touching(summary), exact_collisions(summary));
    let mut lines = if touching.is_empty() {
        match exact {
            Some(exact) if exact > 0 => missed(summary),
            _ => apart(summary, review),
        }
    } else {
        let n: usize = touching.iter().map(|one| one.0.collisions()).sum();
        let pairs = match summary.pairs.len() {
            1 => String::new(),
            all => format!(" at {} of {all} pairs of floors", touching.len()),
        };
        let first = format!("They touch {}{pairs}{}.", times(n), against(n, exact));
        let hardest = touching.iter().take(MOST).map(|(pair, largest)| collisions(pair, largest));
        let more = touching.len().saturating_sub(MOST);
        let more = (more > 0).then(|| format!("{more} further pairs touch; see the table of pairs"));
        std::iter::once(first).chain(hardest).chain(more).collect()
    };
    lines.push(certainty(review));
    lines
}

fn times(n: usize) -> String {
    match n {
        1 => "once".into(),
        n => format!("{n} times"),
    }
}

/// Returns the number of collisions in the exact run. It is `None` if it was not measured, or if a pair rests: such a pair has as many
/// impacts as steps.
fn exact_collisions(summary: &Summary) -> Option<usize> {
    let pairs = summary.pairs.iter();
    let exact = pairs.map(|pair| {
        let errors = pair.errors.as_ref().filter(|errors| !errors.rests)?;
        Some(errors.exact_collisions)
    });
    exact.sum()
}

/// Names the number of touches in exact motion. The text is empty if the number does not differ.
fn against(n: usize, exact: Option<usize>) -> String {
    match exact {
        Some(0) => " in this run; exact motion has no touch".into(),
        Some(exact) if exact != n => format!(" in this run, {} in exact motion", times(exact)),
        Some(_) | None => String::new(),
    }
}

/// Returns the sentences for a run without a touch whose exact motion has one.
fn missed(summary: &Summary) -> Vec<String> {
    let pairs = summary.pairs.iter().filter_map(|pair| {
        let exact = pair.errors.as_ref()?.exact_collisions;
        let collisions = if exact == 1 { "collision" } else { "collisions" };
        let said = || {
            format!(
                "{} – {}: exact motion has {exact} {collisions}, this run none",
                pair.left, pair.right
            )
        };
        (exact > 0).then(said)
    });
    let first = "The steps of this run miss the touches that exact motion has.".to_owned();
    std::iter::once(first).chain(pairs).collect()
}

/// Returns the sentences for a run in which nothing touches.
fn apart(summary: &Summary, review: &Review) -> Vec<String> {
    let pairs = summary.pairs.iter();
    let nearest = pairs.min_by(|one, other| one.least_opening().total_cmp(&other.least_opening()));
    let Some(pair) = nearest else {
        return vec![
            "Contact was not asked for.".into(),
            "The scene gives no gaps: each structure moves by itself.".into(),
        ];
    };
    let gravity = summary.scene.record.gravity_m_per_s2;
    let text = |quantity: PairQuantity| {
        let value = pair.number(quantity);
        value.map_or_else(|| NONE.into(), |value| quantity.about().text_of(value, gravity))
    };
    let mut excesses = review.excesses.iter();
    let apart = if excesses.any(|one| one.kind.is_unwatched()) {
        "No floors that were looked at touch."
    } else {
        "They do not touch."
    };
    vec![
        apart.into(),
        format!(
            "The narrowest place: of the {} mm between {} and {} at least {} mm stay open, at {} s.",
            text(PairQuantity::GapM),
            pair.left,
            pair.right,
            text(PairQuantity::LeastOpeningM),
            text(PairQuantity::LeastOpeningTimeS)
        ),
    ]
}

/// Describes the collisions of a pair.
fn collisions(pair: &PairSummary, largest: &CollisionSummary) -> String {
    let times = match pair.collisions() {
        1 => "one collision".into(),
        n => format!("{n} collisions"),
    };
    let first = pair.first.map_or(largest.start_s, |first| first.start_s);
    let errors = pair.errors.as_ref();
    let impulse = with_error(
        format!("{} kN·s", short(largest.impulse_n_s / 1e3)),
        errors.and_then(|errors| errors.errors.get(PairQuantity::LargestImpulseNS)),
    );
    let force = pair.number(PairQuantity::PeakForceN).map_or_else(String::new, |force| {
        let force = format!("{} kN", Unit::POUNDING_FORCE.text_of(force, 1.0));
        let error = errors.and_then(|errors| errors.errors.get(PairQuantity::PeakForceN));
        let at = pair.number(PairQuantity::PeakForceTimeS);
        let at = at.map_or_else(String::new, |time| format!(" at {} s", short(time)));
        format!(", the largest force {}{at}", with_error(force, error))
    });
    format!(
        "{} – {}: {times}, the first at {} s; the largest impulse is {impulse} at {} s{force}",
        pair.left,
        pair.right,
        short(first),
        short(largest.start_s)
    )
}

fn with_error(text: String, error: Option<f64>) -> String {
    match error {
        Some(error) => format!("{text} (error {})", percent(error)),
        None => text,
    }
}

/// How far the numbers are from the exact run.
fn certainty(review: &Review) -> String {
    match &review.errors {
        Errors::Exact => {
            "The method is exact: it adds no error beyond rounding and its tolerance. What the model leaves out is not part of that.".into()
        }
        Errors::Doubtful => {
            "The method is exact, but this run has gone wrong by what its energies tell (see the warnings): how far its numbers \
             are off is not known."
                .into()
        }
        Errors::NotMeasured => "How far the numbers are from an exact run of the same scene was not measured.".into(),
        Errors::Unknown(_) => "How far the numbers are from an exact run of the same scene is not known: that run fails.".into(),
        Errors::Measured(errors, _) => {
            let (largest, of) = errors.largest(QuantityGroup::All);
            if largest == 0.0 {
                "Every number equals that of an exact run of the same scene.".into()
            } else if largest.is_finite() {
                format!(
                    "Every number is within {} of an exact run of the same scene; farthest off is the {of}.",
                    percent(largest)
                )
            } else {
                "Some numbers are not those of an exact run of the same scene; the tables say which.".into()
            }
        }
    }
}
