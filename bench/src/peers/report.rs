//! Tables of the comparison: every setting, error levels, the smallest error of each entrant, and the figure.

use super::figure::{Competitor, WorkPrecision};

use super::race::{EntrantRun, Raced};
use super::work;

/// Error levels of the comparison \[–\].
const LEVELS: [f64; 6] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8];

type Points<'a> = Vec<(&'a EntrantRun, Vec<(f64, f64)>)>;

/// CPU times and errors of selected runs.
fn points(raced: &Raced, meant: impl Fn(&EntrantRun) -> bool) -> Points<'_> {
    let runs = raced.runs.iter().filter(|run| meant(run));
    runs.map(|run| (run, run.points())).collect()
}

/// A ratio in a table: three digits.
fn ratio(value: f64) -> String {
    if value < 100.0 {
        format!("{value:.3}")
    } else {
        format!("{value:.0}")
    }
}

/// Every setting of every entrant: error, CPU time over the unit, and over that of our cheapest method with this error.
pub(super) fn settings(all: &[Raced]) -> Vec<String> {
    let mut lines = Vec::new();
    for raced in all {
        let ours = points(raced, EntrantRun::is_ours);
        for run in &raced.runs {
            for rung in &run.rungs {
                let seconds = rung.seconds();
                let over = work::cheapest(&ours, rung.error).map(|(_, own)| ratio(seconds / own));
                let over = over.filter(|_| rung.error.is_finite()).unwrap_or_default();
                let entrant = &run.entrant;
                lines.push(format!(
                    "{},{},{},{},{:.1e},{},{over}",
                    raced.law,
                    entrant.tool,
                    entrant.method,
                    entrant.knob.words(rung.setting),
                    rung.error,
                    ratio(seconds / raced.unit),
                ));
            }
        }
    }
    lines
}

/// For every error level, our cheapest method, and the best package and the best compiled loop relative to it.
///
/// A ratio has a `>` if no entrant reaches the error: it is that of the finest settings. It has a `<` if the coarsest setting is as
/// accurate: a coarser setting might suffice.
pub(super) fn levels(all: &[Raced]) -> Vec<String> {
    let mut lines = Vec::new();
    for raced in all {
        let ours = points(raced, EntrantRun::is_ours);
        let packages = points(raced, |run| !run.is_ours() && run.entrant.competitor != Competitor::Loop);
        let loops = points(raced, |run| run.entrant.competitor == Competitor::Loop);
        for level in LEVELS {
            let Some((own, seconds)) = work::cheapest(&ours, level) else {
                continue;
            };
            let cells = [&packages, &loops].map(|points| beside(points, level, seconds));
            lines.push(format!("{},{level:e},{},{}", raced.law, own.entrant.method, cells.join(",")));
        }
    }
    lines
}

/// The best entrant at an error, and its CPU time over ours.
fn beside(points: &[(&EntrantRun, Vec<(f64, f64)>)], level: f64, ours: f64) -> String {
    if let Some((run, seconds)) = work::cheapest(points, level) {
        let name = format!("{} {}", run.entrant.tool, run.entrant.method);
        let bound = if work::is_bound(&run.points(), level) { "<" } else { "" };
        return format!("{name},{bound}{}", ratio(seconds / ours));
    }
    let bound = work::spent_in_vain(points);
    bound.map_or_else(|| String::from(","), |seconds| format!("none,>{}", ratio(seconds / ours)))
}

/// Prints the smallest error of each entrant, which shows whether all agree.
pub(super) fn check(all: &[Raced]) {
    println!("\nLeast error against the exact method, over all settings:");
    for raced in all {
        for run in &raced.runs {
            let errors = run.rungs.iter().map(|rung| rung.error);
            let least = errors.fold(f64::INFINITY, f64::min);
            println!("  {}: {}: {least:.1e}", raced.law, run.entrant.label);
        }
    }
}

/// A panel of the figure.
pub(super) fn panel(raced: &Raced) -> (&'static str, Vec<WorkPrecision>) {
    let curve = |run: &EntrantRun| {
        let points = run.points().into_iter();
        WorkPrecision {
            competitor: run.entrant.competitor,
            label: run.entrant.label.into(),
            points: points.map(|(seconds, error)| (seconds / raced.unit, error)).collect(),
        }
    };
    (raced.title, raced.runs.iter().map(curve).collect())
}
