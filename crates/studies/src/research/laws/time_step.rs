//! The e that stepping methods deliver to the free pair, over the time step.

use pounding_contact::LawName;

use super::entry::{Entry, N_LAWS, by_name, label};
use crate::drivers::each;
use crate::lines::line_of;
use crate::study::laws::AtlasSettings;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel};
use pounding_scene::{DeliveredRestitution, StepMethod};
use pounding_text::{Cell, Table};

/// The results of a method under one law at every time step.
#[derive(Debug)]
pub(super) struct MethodLadder {
    /// Index of the law.
    entry: usize,
    method: StepMethod,
    rungs: Vec<LadderRung>,
}

/// The result at one time step.
#[derive(Debug)]
struct LadderRung {
    steps_per_contact: f64,
    time_step: f64,
    /// The delivered e, or the reason why the run failed.
    outcome: Result<DeliveredRestitution, String>,
}

/// Runs every method with every law. Calls `done` after each combination.
pub(super) fn climb(entries: &[Entry], settings: &AtlasSettings, done: &(dyn Fn() + Sync)) -> Vec<MethodLadder> {
    // An impulsive contact has no duration: its time steps are those of the first law with a duration.
    let durations = || entries.iter().filter_map(|entry| Some(entry.certificate.impact?.duration));
    let usual = durations().next().unwrap_or(1.0);
    let of_entry = |(index, entry): (usize, &Entry)| StepMethod::differing(!entry.is_compliant()).map(move |method| (index, method));
    let races: Vec<_> = entries.iter().enumerate().flat_map(of_entry).collect();
    let ladder = |&(index, method): &(usize, StepMethod)| {
        let certificate = &entries[index].certificate;
        let duration = certificate.impact.map_or(usual, |impact| impact.duration);
        let rung = |steps: &f64| {
            let time_step = duration / steps;
            let delivered = certificate.by(&settings.collision(), &method.at(time_step));
            LadderRung {
                steps_per_contact: *steps,
                time_step,
                outcome: delivered.map_err(|error| error.to_string()),
            }
        };
        MethodLadder {
            entry: index,
            method,
            rungs: settings.steps_per_contact.iter().map(rung).collect(),
        }
    };
    each(&races, done, ladder)
}

/// Number of calls of `done` by [`climb`].
pub(super) fn n_ladders() -> usize {
    let [impulsive, compliant] = [true, false].map(|kind| StepMethod::differing(kind).count());
    impulsive + (N_LAWS - 1) * compliant
}

/// Table of the least and the largest e of every method at every time step.
pub(super) fn table(entries: &[Entry], ladders: &[MethodLadder]) -> String {
    let of_entry = |(index, entry)| {
        let own = ladders.iter().filter(move |ladder| ladder.entry == index);
        by_name(
            entry,
            own.flat_map(|ladder| ladder.rungs.iter().map(move |rung| (ladder.method, rung))),
        )
    };
    let found = |rung: &LadderRung| rung.outcome.as_ref().ok().map(|found| (found.range, found.error));
    Table::of(entries.iter().enumerate().flat_map(of_entry))
        .column("law", |(name, ..)| name.name())
        .column("method", |(.., (method, _))| method.name())
        .column("steps_per_contact", |(_, entry, (_, rung))| {
            entry.is_compliant().then_some(rung.steps_per_contact)
        })
        .column("time_step_s", |(.., (_, rung))| rung.time_step)
        .column("least_delivered", |(.., (_, rung))| found(rung).map(|(range, _)| range[0]))
        .column("largest_delivered", |(.., (_, rung))| found(rung).map(|(range, _)| range[1]))
        .column("largest_error", |(.., (_, rung))| {
            Cell::number(found(rung).map(|found| found.1), |error| format!("{error:.2e}"))
        })
        .column("failed", |(.., (_, rung))| rung.outcome.as_ref().err().cloned())
        .csv()
}

/// Laws of the figure, one per kind of damper.
const SHOWN: [LawName; 4] = [
    LawName::KelvinVoigt,
    LawName::NonlinearViscoelastic,
    LawName::HertzDamp,
    LawName::PantWijeyewickrema,
];

/// Smaller errors are drawn at the edge \[–\].
const LEAST: f64 = 1e-8;

/// Figure of the delivered e at the phase with the largest error, and of that error.
pub(super) fn figure(entries: &[Entry], ladders: &[MethodLadder], settings: &AtlasSettings) -> Figure {
    let mut panels = Vec::new();
    for law in SHOWN {
        let Some(index) = entries.iter().position(|entry| entry.names.contains(&law)) else {
            continue;
        };
        let wanted = entries[index].certificate.by_exact;
        let furthest = |found: &DeliveredRestitution| {
            let [least, largest] = found.range;
            if wanted - least > largest - wanted { least } else { largest }
        };
        let e = Axis::over("Restitution", 0.0, 1.2);
        panels.push(Panel::shared(label(law), e, curves(ladders, index, &furthest)).with_level(settings.restitution));
        let error = Axis::over("Largest error", LEAST, 3.0).log();
        panels.push(Panel::shared("", error, curves(ladders, index, &|found| found.error.max(LEAST))));
    }
    Figure::grid(8.6, 2, Axis::auto("Time steps per contact").log(), panels)
}

fn curves(ladders: &[MethodLadder], entry: usize, point: &dyn Fn(&DeliveredRestitution) -> f64) -> Vec<Curve> {
    let own = ladders.iter().filter(|ladder| ladder.entry == entry);
    let curve = |ladder: &MethodLadder| {
        let (shade, kind, mark) = line_of(ladder.method.name())?;
        let at = |rung: &LadderRung| Some((rung.steps_per_contact, point(rung.outcome.as_ref().ok()?)));
        let points = ladder.rungs.iter().filter_map(at).collect();
        let curve = Curve::new(kind, shade, points).marked(mark);
        Some(curve.named(ladder.method.label()))
    };
    let mut curves: Vec<_> = own.filter_map(curve).collect();
    // Hollow marks are drawn over solid ones, so both stay visible.
    curves.sort_by_key(|curve| curve.kind == CurveKind::Dashed);
    curves
}
