//! Claims about two structures: when, how hard and how often they collide (sections 3 and 5).

use super::{Claim, Finding, Law, Runs, change, first_collision, is_slight, momentum, peak_force};
use crate::StudyError;

/// Largest difference of two instants that counts as almost the same time \[s\].
const SAME_TIME: f64 = 0.05;

pub(super) fn same_first_impact(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let pair = runs.two_structures(Law::Stereomechanical)?;
    // The force is an impulse over the time step; without one the impulses are compared.
    let first = |run: super::Run<'_>| {
        let (time, impulse) = first_collision(run)?;
        Ok(match run.0.method.time_step() {
            Some(step) => (time, impulse / step, "kN"),
            None => (time, impulse, "kN·s"),
        })
    };
    let [(t0, f0, unit), (t1, f1, _)] = [first(pair[0])?, first(pair[1])?];
    let same = (t1 - t0).abs() <= SAME_TIME && is_slight(f0, f1);
    Ok(Claim {
        claim: "Stereomechanical impact: elastic or nonlinear, the structures first meet at nearly one time and with \
                nearly one force",
        place: "3.1",
        computed: format!(
            "elastic {t0:.2} s and {f0:.0} {unit}; nonlinear {t1:.2} s and {f1:.0} {unit} ({:+.1} %)",
            change(f0, f1)
        ),
        finding: Finding::of(same, true),
    })
}

pub(super) fn same_first_momentum(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let pair = runs.two_structures(Law::Viscoelastic)?;
    let [(t0, p0), (t1, p1)] = [first_collision(pair[0])?, first_collision(pair[1])?];
    let same = (t1 - t0).abs() <= SAME_TIME && is_slight(p0, p1);
    Ok(Claim {
        claim: "Viscoelastic element: elastic or nonlinear, the structures first meet at nearly one time and with \
                nearly one transferred momentum",
        place: "3.2",
        computed: format!(
            "elastic {t0:.2} s and {p0:.2} kN·s; nonlinear {t1:.2} s and {p1:.2} kN·s ({:+.1} %)",
            change(p0, p1)
        ),
        finding: Finding::of(same, true),
    })
}

pub(super) fn four_models(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let mut impulses = Vec::new();
    for law in Law::BOTH {
        for run in runs.two_structures(law)? {
            impulses.push(first_collision(run)?.1);
        }
    }
    let low = impulses.iter().copied().fold(f64::INFINITY, f64::min);
    let high = impulses.iter().copied().fold(0.0, f64::max);
    Ok(Claim {
        claim: "The transferred momentum of the first collision is comparable in all four models",
        place: "3.3",
        computed: format!(
            "{low:.2} to {high:.2} kN·s; the largest is {:.2} times the smallest",
            high / low
        ),
        finding: Finding::of(high <= 2.0 * low, true),
    })
}

pub(super) fn as_newmark(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let explicit = runs.scene("table-5", "viscoelastic elastic")?;
    let newmark = runs.scene("claims", "Newmark, viscoelastic elastic")?;
    let counts = [explicit, newmark].map(|run| run.1.collisions.all().len());
    let pairs = explicit
        .1
        .collisions
        .all()
        .iter()
        .zip(newmark.1.collisions.all());
    let apart = pairs
        .map(|(a, b)| (a.start - b.start).abs())
        .fold(0.0, f64::max);
    Ok(Claim {
        claim: "The explicit method gives as many collisions, at the same times, as Newmark's method at 0.005 s (tested \
                against our own run of it)",
        place: "3.3",
        computed: format!(
            "Newmark's method with the inputs of this paper: {} collisions against {}; they begin at most {:.0} ms \
             apart; largest force {:.0} kN against {:.0} kN",
            counts[1],
            counts[0],
            1e3 * apart,
            peak_force(newmark),
            peak_force(explicit)
        ),
        finding: Finding::of(counts[0] == counts[1] && apart <= SAME_TIME, true),
    })
}

pub(super) fn fewer_when_nonlinear(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let count = |run: super::Run<'_>| run.1.collisions.all().len();
    let mut stated = true;
    let mut computed = Vec::new();
    for law in Law::BOTH {
        let [elastic, nonlinear] = runs.two_structures(law)?.map(count);
        stated &= elastic > nonlinear;
        computed.push(format!("{} {elastic} against {nonlinear}", law.name()));
    }
    let (mut beyond, mut cases) = (0, 0);
    for law in Law::BOTH {
        for layout in ["A", "B", "C"] {
            let elastic = runs.layout(layout, "elastic", law)?;
            let nonlinear = runs.layout(layout, "nonlinear", law)?;
            cases += elastic.len();
            let more = |(elastic, nonlinear): &(super::Run<'_>, super::Run<'_>)| {
                count(*elastic) > count(*nonlinear)
            };
            beyond += elastic.into_iter().zip(nonlinear).filter(more).count();
        }
    }
    Ok(Claim {
        claim: "Elastic structures collide more often than nonlinear ones",
        place: "5",
        computed: format!(
            "impulses or contacts of two structures: {}; layouts A, B, C{}: in {beyond} of {cases} cases",
            computed.join(", "),
            if cases == 12 {
                " at the paper's time step and half of it"
            } else {
                ""
            }
        ),
        finding: Finding::of(stated, beyond == cases),
    })
}

pub(super) fn displacement_not_recovered(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let mut holds = true;
    let mut computed = Vec::new();
    for law in Law::BOTH {
        let [elastic, nonlinear] = runs.two_structures(law)?;
        let peaks = [elastic, nonlinear].map(|run| 1e3 * run.1.peaks.of(0).displacement.value);
        let plastic = 1e3
            * super::layouts::plastic_displacement(nonlinear, 0)
                .last()
                .copied()
                .unwrap_or(0.0);
        holds &= peaks[1].abs() > peaks[0].abs() && plastic.abs() > 0.5 * peaks[1].abs();
        computed.push(format!(
            "{}: peak {:.0} mm elastic, {:.0} mm nonlinear, of which {plastic:.0} mm stay at 10 s",
            law.name(),
            peaks[0],
            peaks[1]
        ));
    }
    Ok(Claim {
        claim: "After the first pounding the displacement of the weak structure is larger when nonlinear, and is not \
                recovered",
        place: "5",
        computed: computed.join("; "),
        finding: Finding::of(holds, true),
    })
}

pub(super) fn order_of_magnitude(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let (stereo, visco) = (
        runs.two_structures(Law::Stereomechanical)?,
        runs.two_structures(Law::Viscoelastic)?,
    );
    let ratios = [0, 1].map(|index| peak_force(stereo[index]) / peak_force(visco[index]));
    let fine = runs.scene("claims", "two structures elastic, 1.25 ms")?;
    Ok(Claim {
        claim: "The viscoelastic element lowers the peak pounding force by an order of magnitude",
        place: "5",
        computed: format!(
            "by a factor of {:.1} elastic, {:.1} nonlinear; the stereomechanical force is an impulse over the time \
             step and grows without bound ({:.0} kN at 10 ms, {:.0} kN at 1.25 ms)",
            ratios[0],
            ratios[1],
            peak_force(stereo[0]),
            peak_force(fine)
        ),
        finding: Finding::of(ratios.iter().all(|ratio| *ratio >= 5.0), false),
    })
}

pub(super) fn slight_reduction(runs: &Runs<'_>) -> Result<Claim, StudyError> {
    let (stereo, visco) = (
        runs.two_structures(Law::Stereomechanical)?,
        runs.two_structures(Law::Viscoelastic)?,
    );
    let mut first = [0.0; 2];
    for index in 0..2 {
        first[index] = change(
            first_collision(stereo[index])?.1,
            first_collision(visco[index])?.1,
        );
    }
    let total = [0, 1].map(|index| change(momentum(stereo[index], 0), momentum(visco[index], 0)));
    let about_twenty = |change: &f64| (-25.0..=-15.0).contains(change);
    Ok(Claim {
        claim: "The viscoelastic element lowers the transferred momentum by about 20 %",
        place: "5",
        computed: format!(
            "first collision {:+.1} % elastic, {:+.1} % nonlinear; all of 10 s {:+.1} % elastic, {:+.1} % nonlinear",
            first[0], first[1], total[0], total[1]
        ),
        finding: Finding::of(
            first.iter().all(about_twenty),
            total.iter().all(about_twenty),
        ),
    })
}
