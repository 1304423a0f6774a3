//! The e that stepping methods deliver to the free pair, over the time step.

use pounding_contact::LawName;

use super::entry::{Entry, N_LAWS, label};
use crate::lines::line_of;
use crate::study::laws::AtlasSettings;
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Panel};
use pounding_scene::{Delivered, StepMethod, parallel};
use pounding_text::digits;
use pounding_text::to_csv;

/// What a method delivers under a law at every time step.
#[derive(Debug)]
pub(super) struct Ladder {
    /// Which of the laws.
    entry: usize,
    method: StepMethod,
    rungs: Vec<Rung>,
}

/// What it delivers at one of them.
#[derive(Debug)]
struct Rung {
    steps_per_contact: f64,
    time_step: f64,
    /// What came out, or why nothing did.
    outcome: Result<Delivered, String>,
}

/// Runs every method with every law; `done` is called after each.
pub(super) fn climb(entries: &[Entry], settings: &AtlasSettings, done: &(dyn Fn() + Sync)) -> Vec<Ladder> {
    // An impulsive contact has no duration: its steps are those of the first law that has one.
    let durations = || entries.iter().filter_map(|entry| Some(entry.certificate.impact?.duration));
    let usual = durations().next().unwrap_or(1.0);
    let races: Vec<_> = entries
        .iter()
        .enumerate()
        .flat_map(|(index, entry)| StepMethod::differing(!entry.is_compliant()).map(move |method| (index, method)))
        .collect();
    let ladder = |&(index, method): &(usize, StepMethod)| {
        let certificate = &entries[index].certificate;
        let duration = certificate.impact.map_or(usual, |impact| impact.duration);
        let rung = |steps: &f64| {
            let time_step = duration / steps;
            let delivered = certificate.by(&settings.collision(), &method.at(time_step));
            Rung {
                steps_per_contact: *steps,
                time_step,
                outcome: delivered.map_err(|error| error.to_string()),
            }
        };
        let rungs = settings.steps_per_contact.iter().map(rung).collect();
        done();
        Ladder {
            entry: index,
            method,
            rungs,
        }
    };
    parallel::each(&races, ladder)
}

/// How often [`climb`] calls `done`.
pub(super) fn n_ladders() -> usize {
    let [impulsive, compliant] = [true, false].map(|kind| StepMethod::differing(kind).count());
    impulsive + (N_LAWS - 1) * compliant
}

/// Least and largest e of every method at every time step.
pub(super) fn table(entries: &[Entry], ladders: &[Ladder]) -> String {
    let header = [
        "law",
        "method",
        "steps_per_contact",
        "time_step_s",
        "least_delivered",
        "largest_delivered",
        "largest_error",
        "failed",
    ];
    let mut rows = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let own = ladders.iter().filter(|ladder| ladder.entry == index);
        let cells: Vec<_> = own.flat_map(|ladder| cells(entry, ladder)).collect();
        rows.extend(entry.rows(|name| {
            let row = |cells: &Vec<String>| {
                let mut row = vec![name.clone()];
                row.extend(cells.iter().cloned());
                row
            };
            cells.iter().map(row).collect()
        }));
    }
    to_csv(&header.map(String::from), &rows)
}

fn cells(entry: &Entry, ladder: &Ladder) -> Vec<Vec<String>> {
    let row = |rung: &Rung| {
        let steps = if entry.is_compliant() {
            digits(rung.steps_per_contact)
        } else {
            String::new()
        };
        let mut row = vec![ladder.method.name().into(), steps, digits(rung.time_step)];
        row.extend(match &rung.outcome {
            Ok(found) => {
                let [least, largest] = found.range.map(digits);
                [least, largest, format!("{:.2e}", found.error), String::new()]
            }
            Err(reason) => [String::new(), String::new(), String::new(), reason.clone()],
        });
        row
    };
    ladder.rungs.iter().map(row).collect()
}

/// Laws of the figure: one of each kind of damper.
const SHOWN: [LawName; 4] = [
    LawName::KelvinVoigt,
    LawName::NonlinearViscoelastic,
    LawName::HertzDamp,
    LawName::PantWijeyewickrema,
];

/// Errors below this are at the edge.
const LEAST: f64 = 1e-8;

/// e delivered at the phase where it is furthest off, and its error.
pub(super) fn figure(entries: &[Entry], ladders: &[Ladder], settings: &AtlasSettings) -> Figure {
    let mut panels = Vec::new();
    for law in SHOWN {
        let Some(index) = entries.iter().position(|entry| entry.names.contains(&law)) else {
            continue;
        };
        let wanted = entries[index].certificate.by_exact;
        let furthest = |found: &Delivered| {
            let [least, largest] = found.range;
            if wanted - least > largest - wanted { least } else { largest }
        };
        let panel = |title: &str, y, point: &dyn Fn(&Delivered) -> f64| Panel {
            title: title.into(),
            y,
            curves: curves(ladders, index, point),
            legend: Legend::Shared,
            ..Panel::default()
        };
        let e = Axis::over("Restitution", 0.0, 1.2);
        panels.push(Panel {
            levels: vec![settings.restitution],
            ..panel(label(law), e, &furthest)
        });
        let error = Axis::over("Largest error", LEAST, 3.0).log();
        panels.push(panel("", error, &|found| found.error.max(LEAST)));
    }
    Figure {
        height_in: 8.6,
        columns: 2,
        x: Axis::auto("Time steps per contact").log(),
        panels,
    }
}

fn curves(ladders: &[Ladder], entry: usize, point: &dyn Fn(&Delivered) -> f64) -> Vec<Curve> {
    let own = ladders.iter().filter(|ladder| ladder.entry == entry);
    let curve = |ladder: &Ladder| {
        let (shade, kind, mark) = line_of(ladder.method.name())?;
        let at = |rung: &Rung| Some((rung.steps_per_contact, point(rung.outcome.as_ref().ok()?)));
        let points = ladder.rungs.iter().filter_map(at).collect();
        let curve = Curve::new(kind, shade, points).marked(mark);
        Some(curve.named(ladder.method.label()))
    };
    let mut curves: Vec<_> = own.filter_map(curve).collect();
    // Hollow marks over solid ones, so that both are seen.
    curves.sort_by_key(|curve| curve.kind == Kind::Dashed);
    curves
}
