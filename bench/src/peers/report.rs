//! Writes the results of the comparison: a table of all settings, a table by error level, the smallest error of each entrant, and the
//! panels of the figure.

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

/// Formats a ratio: three decimals below 100, otherwise none.
fn ratio(value: f64) -> String {
    if value < 100.0 {
        format!("{value:.3}")
    } else {
        format!("{value:.0}")
    }
}

/// Returns a line for every setting of every entrant. The first number is its error, the second its CPU time divided by the unit. The third
/// is its CPU time divided by the time that our cheapest method needs for the same error; it is empty if no method of ours reaches the
/// error.
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

/// Returns a line for every error level that one of our methods reaches. It names our cheapest method, and compares the fastest package and
/// the fastest compiled loop with it.
///
/// A `>` means that no entrant reaches the error. The ratio then uses the shortest time among the entrants' costliest settings, as a lower
/// bound. A `<` means that even the cheapest setting reaches the error. A coarser setting might be faster still.
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

/// Names the fastest entrant that reaches an error, and gives its CPU time divided by ours.
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
    println!("\nSmallest error of each entrant over all its settings, relative to the exact method:");
    for raced in all {
        for run in &raced.runs {
            let errors = run.rungs.iter().map(|rung| rung.error);
            let least = errors.fold(f64::INFINITY, f64::min);
            println!("  {}: {}: {least:.1e}", raced.law, run.entrant.label);
        }
    }
}

/// Returns the panel of the figure for one kind of scene.
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
