//! Claims about three structures (sections 4 and 5).

use super::{Finding, Law, NOTHING, Outcome, Runs, SceneRun, change, is_slight, momentum, peak_force};
use crate::StudyError;

const LAYOUTS: [&str; 3] = ["A", "B", "C"];

/// The elastic layout C at time steps of 10 ms and 5 ms; 5 ms is the paper's.
fn coarse_and_fine<'a>(runs: &Runs<'a>) -> Result<[SceneRun<'a>; 2], StudyError> {
    Ok([
        runs.scene("claims", "layout C elastic, stereomechanical, 10 ms")?,
        runs.scene("figure-11a", "layout C elastic")?,
    ])
}

pub(super) fn tangling_in_layout_c(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let overlaps = coarse_and_fine(runs)?.map(|run| 1e3 * largest_overlap(run));
    Ok((
        format!("largest overlap {:.1} mm at 10 ms, {:.1} mm at 5 ms", overlaps[0], overlaps[1]),
        Finding::of(overlaps[0] > overlaps[1], true),
    ))
}

pub(super) fn half_step_raises_the_force(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let forces = coarse_and_fine(runs)?.map(peak_force);
    Ok((
        format!("{:.0} kN at 10 ms, {:.0} kN at 5 ms (impulse over time step)", forces[0], forces[1]),
        Finding::of(forces[1] > forces[0], true),
    ))
}

pub(super) fn half_step_keeps_the_momentum(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let [coarse, fine] = coarse_and_fine(runs)?;
    let mut same = true;
    let mut computed = Vec::new();
    for (structure, name) in ["left", "middle", "right"].into_iter().enumerate() {
        let totals = [coarse, fine].map(|run| momentum(run, structure));
        same &= is_slight(totals[0], totals[1]);
        computed.push(format!(
            "{name} {:.0} and {:.0} kN·s ({:+.0} %)",
            totals[0],
            totals[1],
            change(totals[0], totals[1])
        ));
    }
    Ok((format!("at 10 and 5 ms: {}", computed.join(", ")), Finding::of(same, true)))
}

/// Largest deformation of any pair over the history \[m\].
fn largest_overlap(run: SceneRun<'_>) -> f64 {
    let histories = run.outcome.histories.as_ref().expect("the studies used here keep histories");
    let mut largest = 0.0_f64;
    for (left, contact) in run.scene.contacts.iter().flatten().enumerate() {
        let pairs = histories.of(left).states.iter().zip(&histories.of(left + 1).states);
        largest = pairs
            .map(|(left, right)| left.displacement - right.displacement - contact.gap_m)
            .fold(largest, f64::max);
    }
    largest
}

/// Counts the transferred momenta, over layouts and structures, for which a comparison of two runs is true. `is_true` returns `None` if the
/// claim is not about the two momenta.
fn counted(runs: &Runs<'_>, sides: &[[(&str, Law); 2]], is_true: impl Fn(f64, f64) -> Option<bool>) -> Result<Outcome, StudyError> {
    // `[true, compared]` at the paper's time step, and at half of it if the method has a time step.
    let (mut counts, mut touch) = (Vec::new(), false);
    for layout in LAYOUTS {
        for [a, b] in sides {
            let (a, b) = (runs.layout(layout, a.0, a.1)?, runs.layout(layout, b.0, b.1)?);
            counts.resize(a.len(), [0; 2]);
            for ((a, b), [stated, of]) in a.into_iter().zip(b).zip(&mut counts) {
                touch |= a.touches() || b.touches();
                for structure in 0..a.scene.structures.len() {
                    let truth = is_true(momentum(a, structure), momentum(b, structure));
                    *stated += usize::from(truth == Some(true));
                    *of += usize::from(truth.is_some());
                }
            }
        }
    }
    if !touch {
        return Ok((NOTHING.into(), Finding::DoesNotApply));
    }
    let words = if let [[stated, of], [half, of_half]] = counts[..] {
        format!("true of {stated} of {of} transferred momenta at the paper's time steps, of {half} of {of_half} at half of them")
    } else {
        let [stated, of] = counts.first().copied().unwrap_or_default();
        format!("true of {stated} of {of} transferred momenta")
    };
    let all = |[stated, of]: &[usize; 2]| stated == of;
    Ok((words, Finding::of(counts.iter().take(1).all(all), counts.iter().all(all))))
}

/// The result of a comparison; `None` if neither structure is touched, because two zeros are neither more nor less.
fn compared(one: f64, other: f64, truth: bool) -> Option<bool> {
    (one > 0.0 || other > 0.0).then_some(truth)
}

pub(super) fn less_momentum_when_nonlinear(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let sides = Law::ALL.map(|law| [("elastic", law), ("nonlinear", law)]);
    counted(runs, &sides, |elastic, nonlinear| compared(elastic, nonlinear, nonlinear < elastic))
}

pub(super) fn more_momentum_stereomechanical(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let sides = [Law::ALL.map(|law| ("elastic", law))];
    counted(runs, &sides, |stereo, visco| compared(stereo, visco, stereo > visco))
}

pub(super) fn same_momentum_nonlinear(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let sides = [Law::ALL.map(|law| ("nonlinear", law))];
    // Two equal momenta count as the same, zeros too.
    let same = |stereo: f64, visco: f64| Some((stereo - visco).abs() == 0.0 || is_slight(stereo, visco));
    counted(runs, &sides, same)
}

pub(super) fn fewer_incursions(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    // Rounding of u − f/k is far below this bound, yielding far above it.
    const YIELDS: f64 = 1e-9;
    let travelled = |scene: &str, weak: usize| -> Result<(f64, usize), StudyError> {
        let (mut travel, mut incursions) = (0.0, 0);
        for history in runs.scene("figure-15", scene)?.plastic_drifts(weak) {
            let steps = history.windows(2).map(|pair| (pair[1] - pair[0]).abs());
            let steps: Vec<f64> = steps.collect();
            let begins = |pair: &&[f64]| pair[0] <= YIELDS && pair[1] > YIELDS;
            incursions += steps.windows(2).filter(begins).count();
            let yields = steps.iter().filter(|step| **step > YIELDS);
            travel += yields.fold(0.0, |sum, step| sum + step);
        }
        Ok((1e3 * travel, incursions))
    };
    let free = travelled("no pounding", 0)?;
    let stereo = travelled("layout C, stereomechanical", 1)?;
    let visco = travelled("layout C, viscoelastic", 1)?;
    let words = |(travel, incursions): (f64, usize)| format!("{incursions} incursions of {travel:.0} mm in all");
    let mut touch = false;
    for scene in ["layout C, stereomechanical", "layout C, viscoelastic"] {
        touch |= runs.scene("figure-15", scene)?.touches();
    }
    // Columns that do not yield without pounding cannot yield less with it.
    Ok((
        format!(
            "alone {}; in layout C {} (stereomechanical), {} (viscoelastic)",
            words(free),
            words(stereo),
            words(visco)
        ),
        Finding::where_touching(
            touch && free.1 > 0,
            stereo.0 < free.0 && visco.0 < free.0,
            stereo.1 < free.1 && visco.1 < free.1,
        ),
    ))
}

pub(super) fn least_favourable(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let peak = |run: SceneRun<'_>| {
        let displacement = |index| 1e3 * run.peak_displacement(index).abs();
        (0..run.scene.structures.len()).map(displacement).fold(0.0, f64::max)
    };
    let (mut largest_in_b, mut cases, mut computed) = (Vec::new(), 0, Vec::new());
    for law in Law::ALL {
        for behaviour in ["elastic", "nonlinear"] {
            let of_layout = |layout| runs.layout(layout, behaviour, law);
            let [a, b, c] = LAYOUTS.map(of_layout);
            let [a, b, c] = [a?, b?, c?];
            // Without any touch the layouts do not differ.
            if !a.iter().chain(&b).chain(&c).any(|run| run.touches()) {
                continue;
            }
            cases += 1;
            let [a, b, c] = [a, b, c].map(|runs| runs.into_iter().map(peak).collect::<Vec<_>>());
            largest_in_b.resize(b.len(), 0);
            for (step, largest) in largest_in_b.iter_mut().enumerate() {
                *largest += usize::from(b[step] > a[step] && b[step] > c[step]);
            }
            computed.push(format!("{} {behaviour} {:.0}, {:.0}, {:.0} mm", law.name(), a[0], b[0], c[0]));
        }
    }
    let half = |largest: &usize| format!(", at half the time steps in {largest} of {cases}");
    let at_half = largest_in_b.get(1).map(half);
    Ok(match largest_in_b.first() {
        None => (NOTHING.into(), Finding::DoesNotApply),
        Some(largest) => (
            format!(
                "layouts A, B, C: {}; true in {largest} of {cases} cases{}",
                computed.join("; "),
                at_half.unwrap_or_default()
            ),
            Finding::of(*largest == cases, largest_in_b.iter().all(|largest| *largest == cases)),
        ),
    })
}
