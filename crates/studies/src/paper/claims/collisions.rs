//! Claims about two structures: when, how hard and how often they collide (sections 3 and 5).

use super::{Finding, Law, NOTHING, Outcome, Runs, change, first_collision, is_slight, momentum, peak_force};
use crate::StudyError;
use pounding_text::digits;

/// Largest difference between two instants that still counts as almost simultaneous \[s\].
const SAME_TIME: f64 = 0.05;

/// Describes the first collisions of two structures, elastic and nonlinear, and judges whether they are nearly equal.
fn side_by_side(first: [Option<(f64, f64)>; 2], unit: &str, decimals: usize) -> (String, Finding) {
    let words = |first: Option<(f64, f64)>| match first {
        Some((time, value)) => format!("{time:.2} s and {value:.decimals$} {unit}"),
        None => NOTHING.into(),
    };
    let both = format!("elastic {}; nonlinear {}", words(first[0]), words(first[1]));
    match first {
        [None, None] => (NOTHING.into(), Finding::DoesNotApply),
        [Some((t0, v0)), Some((t1, v1))] => (
            format!("{both} ({:+.1} %)", change(v0, v1)),
            Finding::of((t1 - t0).abs() <= SAME_TIME && is_slight(v0, v1), true),
        ),
        [Some(_), None] | [None, Some(_)] => (both, Finding::DoesNotHold),
    }
}

pub(super) fn same_first_impact(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let pair = runs.two_structures(Law::Stereomechanical)?;
    // The paper's force of an impact is an impulse over the time step. A method without a time step compares impulses.
    let step = pair[0].scene.method.time_step();
    let first = |run| {
        let (time, impulse) = first_collision(run)?;
        Some((time, impulse / step.unwrap_or(1.0)))
    };
    let unit = if step.is_some() { "kN" } else { "kN·s" };
    Ok(side_by_side(pair.map(first), unit, 0))
}

pub(super) fn same_first_momentum(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let pair = runs.two_structures(Law::Viscoelastic)?;
    Ok(side_by_side(pair.map(first_collision), "kN·s", 2))
}

pub(super) fn four_models(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let mut impulses = Vec::new();
    for law in Law::ALL {
        for run in runs.two_structures(law)? {
            impulses.extend(first_collision(run).map(|(_, impulse)| impulse));
        }
    }
    let low = impulses.iter().copied().fold(f64::INFINITY, f64::min);
    let high = impulses.iter().copied().fold(0.0, f64::max);
    Ok(match impulses.len() {
        0 => (NOTHING.into(), Finding::DoesNotApply),
        4 => (
            format!("{low:.2} to {high:.2} kN·s; the largest is {:.2} times the smallest", high / low),
            Finding::of(high <= 2.0 * low, true),
        ),
        some => (
            format!("{low:.2} to {high:.2} kN·s in {some} models; {NOTHING} in the others"),
            Finding::DoesNotHold,
        ),
    })
}

pub(super) fn as_newmark(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let explicit = runs.scene("table-5", "viscoelastic elastic")?;
    let newmark = runs.scene("claims", "Newmark, viscoelastic elastic")?;
    let counts = [explicit, newmark].map(|run| run.outcome.collisions.all().len());
    let pairs = explicit.outcome.collisions.all().iter().zip(newmark.outcome.collisions.all());
    let apart = pairs.map(|(a, b)| (a.start - b.start).abs()).fold(0.0, f64::max);
    Ok((
        format!(
            "Newmark's method with the inputs of this paper: {} collisions against {}; they begin at most {:.0} ms \
             apart; largest force {:.0} kN against {:.0} kN",
            counts[1],
            counts[0],
            1e3 * apart,
            peak_force(newmark),
            peak_force(explicit)
        ),
        Finding::of(counts[0] == counts[1] && apart <= SAME_TIME, true),
    ))
}

pub(super) fn fewer_when_nonlinear(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let count = |run: super::SceneRun<'_>| run.outcome.collisions.all().len();
    let (mut stated, mut touch, mut computed) = (true, false, Vec::new());
    for law in Law::ALL {
        let [elastic, nonlinear] = runs.two_structures(law)?.map(count);
        stated &= elastic > nonlinear;
        touch |= elastic + nonlinear > 0;
        computed.push(format!("{} {elastic} against {nonlinear}", law.name()));
    }
    let (mut beyond, mut cases, mut halved) = (0, 0, false);
    for law in Law::ALL {
        for layout in ["A", "B", "C"] {
            let elastic = runs.layout(layout, "elastic", law)?;
            let nonlinear = runs.layout(layout, "nonlinear", law)?;
            halved |= elastic.len() > 1;
            for (elastic, nonlinear) in elastic.into_iter().zip(nonlinear) {
                let [elastic, nonlinear] = [elastic, nonlinear].map(count);
                // Two structures that never touch have equal counts: neither collides more often.
                cases += usize::from(elastic + nonlinear > 0);
                beyond += usize::from(elastic > nonlinear);
            }
        }
    }
    Ok((
        format!(
            "impulses or contacts of two structures: {}; layouts A, B, C{}: in {beyond} of {cases} cases",
            computed.join(", "),
            if halved { " at the paper's time step and half of it" } else { "" }
        ),
        Finding::where_touching(touch, stated, beyond == cases),
    ))
}

pub(super) fn displacement_not_recovered(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let (mut holds, mut touch, mut computed) = (true, false, Vec::new());
    for law in Law::ALL {
        let pair = runs.two_structures(law)?;
        touch |= pair.into_iter().any(super::SceneRun::touches);
        let [elastic, nonlinear] = pair;
        let peaks = [elastic, nonlinear].map(|run| 1e3 * run.peak_displacement(0));
        let plastic = 1e3 * nonlinear.residual(0).unwrap_or(0.0);
        holds &= peaks[1].abs() > peaks[0].abs() && plastic.abs() > 0.5 * peaks[1].abs();
        computed.push(format!(
            "{}: peak {:.0} mm elastic, {:.0} mm nonlinear, of which {:.0} mm stay at {} s",
            law.name(),
            peaks[0],
            peaks[1],
            // A rounded negative zero loses its sign.
            plastic.round() + 0.0,
            digits(nonlinear.scene.duration())
        ));
    }
    Ok((computed.join("; "), Finding::where_touching(touch, holds, true)))
}

pub(super) fn order_of_magnitude(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let (stereo, visco) = (runs.two_structures(Law::Stereomechanical)?, runs.two_structures(Law::Viscoelastic)?);
    let ratios = [0, 1].map(|index| peak_force(stereo[index]) / peak_force(visco[index]));
    let fine = runs.scene("claims", "two structures elastic, 1.25 ms")?;
    Ok((
        format!(
            "by a factor of {:.1} elastic, {:.1} nonlinear; the stereomechanical force is an impulse over the time \
             step and grows without bound ({:.0} kN at 10 ms, {:.0} kN at 1.25 ms)",
            ratios[0],
            ratios[1],
            peak_force(stereo[0]),
            peak_force(fine)
        ),
        Finding::of(ratios.iter().all(|ratio| *ratio >= 5.0), false),
    ))
}

pub(super) fn slight_reduction(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let (stereo, visco) = (runs.two_structures(Law::Stereomechanical)?, runs.two_structures(Law::Viscoelastic)?);
    let (mut first, mut total) = (Vec::new(), Vec::new());
    for (index, name) in ["elastic", "nonlinear"].into_iter().enumerate() {
        let pair = [stereo[index], visco[index]];
        // The contact model does nothing before the first touch: either both runs touch or neither does.
        let [Some((_, hard)), Some((_, soft))] = pair.map(first_collision) else {
            continue;
        };
        first.push((change(hard, soft), name));
        let [hard, soft] = pair.map(|run| momentum(run, 0));
        total.push((change(hard, soft), name));
    }
    let words = |changes: &[(f64, &str)]| {
        let words = changes.iter().map(|(change, name)| format!("{change:+.1} % {name}"));
        words.collect::<Vec<_>>().join(", ")
    };
    let about_twenty = |(change, _): &(f64, &str)| (-25.0..=-15.0).contains(change);
    Ok(if first.is_empty() {
        (NOTHING.into(), Finding::DoesNotApply)
    } else {
        (
            format!("first collision {}; of all {}", words(&first), words(&total)),
            Finding::of(first.iter().all(about_twenty), total.iter().all(about_twenty)),
        )
    })
}
