//! The tables of the page.

use pounding_solver::Collision;
use serde_json::Value;

use super::markup::{Cell, digits, facts, short, table};
use crate::report::summary::{PairSummary, StructureSummary, Summary};
use crate::{Errors, Review, milliseconds, percent, rounded_down};

/// Collisions beyond these are in `impacts.csv` only.
const FIRST: usize = 10;
/// Energies below this part of what they are measured by are none.
const ROUNDING: f64 = 1e-12;

fn thousandths(value: Option<f64>) -> Option<String> {
    value.map(|value| short(value / 1e3))
}

/// An error below its number; what cannot be compared says so.
fn off<E>(errors: Option<&E>, of: fn(&E) -> Option<f64>) -> Option<String> {
    errors.map(|errors| match of(errors) {
        Some(error) => format!("error {}", percent(error)),
        None => "not comparable".into(),
    })
}

/// The structures.
pub(super) fn structures(summary: &Summary) -> String {
    let header = [
        "Structure",
        "Period [s]",
        "Damping ratio",
        "Peak displacement [mm]",
        "at [s]",
        "Peak shear force [kN]",
        "Ductility",
        "Drift ratio",
        "Transferred momentum [kN·s]",
    ];
    let rows: Vec<_> = summary.structures.iter().map(structure).collect();
    table(&header, &rows)
}

fn structure(one: &StructureSummary) -> Vec<Cell> {
    let errors = one.errors.as_ref();
    // A wall has no peaks, and so no errors of them.
    let errors_of_peaks = errors.filter(|_| one.period_s.is_some());
    let displaced = off(errors_of_peaks, |errors| errors.peak_displacement);
    let time = errors_of_peaks.and_then(|errors| errors.peak_displacement_time_s);
    let momentum = Cell::new(short(one.transferred_momentum_n_s / 1e3));
    vec![
        Cell::new(&one.name),
        Cell::known(one.period_s.map(short)),
        Cell::known(one.damping_ratio.map(short)),
        Cell::known(one.peak_displacement_m.map(|value| short(1e3 * value)))
            .over(displaced.clone()),
        Cell::known(one.peak_displacement_time_s.map(digits))
            .over(time.map(|time| format!("error {}", milliseconds(time)))),
        Cell::known(thousandths(one.peak_shear_force_n))
            .over(off(errors_of_peaks, |errors| errors.peak_shear_force)),
        Cell::known(one.ductility.map(short))
            .over(displaced.clone().filter(|_| one.ductility.is_some())),
        Cell::known(one.drift_ratio.map(percent))
            .over(displaced.filter(|_| one.drift_ratio.is_some())),
        momentum.over(off(errors, |errors| errors.transferred_momentum)),
    ]
}

/// The pairs; nothing where structures stand apart.
pub(super) fn pairs(summary: &Summary) -> String {
    if summary.pairs.is_empty() {
        return "<p>None: no structure can touch another.</p>\n".into();
    }
    let header = [
        "Pair",
        "Gap [mm]",
        "Least opening [mm]",
        "Collisions",
        "First [s]",
        "First impulse [kN·s]",
        "Largest impulse [kN·s]",
        "Peak force [kN]",
    ];
    let rows: Vec<_> = summary.pairs.iter().map(pair).collect();
    table(&header, &rows)
}

fn pair(one: &PairSummary) -> Vec<Cell> {
    let errors = one.errors.as_ref();
    let compared = errors.filter(|errors| !errors.rests && one.collisions > 0);
    let counted = errors.map(|errors| {
        if errors.rests {
            "rests".into()
        } else {
            format!("exact run: {}", errors.exact_collisions)
        }
    });
    let first = one.first.as_ref();
    let time = errors.and_then(|errors| errors.first_time_s);
    let force = if one.collisions > 0 && one.peak_force_n.is_none() {
        Cell::new("impulsive")
    } else {
        Cell::known(thousandths(one.peak_force_n)).over(off(compared, |errors| errors.peak_force))
    };
    vec![
        Cell::new(format!("{} – {}", one.left, one.right)).over(Some(one.law.replace('_', " "))),
        Cell::new(short(1e3 * one.gap_m)),
        Cell::new(opening(one.least_opening_m)),
        Cell::new(one.collisions.to_string()).over(counted),
        Cell::known(first.map(|first| digits(first.start_s)))
            .over(time.map(|time| format!("error {}", milliseconds(time)))),
        Cell::known(thousandths(first.map(|first| first.impulse_n_s)))
            .over(off(compared, |errors| errors.first_impulse)),
        Cell::known(thousandths(one.largest.map(|largest| largest.impulse_n_s)))
            .over(off(compared, |errors| errors.largest_impulse)),
        force,
    ]
}

/// What stays open of a gap at least \[mm\], or by how much it is overrun.
pub(super) fn opening(metres: f64) -> String {
    let opening = 1e3 * metres;
    if opening > 0.0 {
        rounded_down(opening, if opening < 1.0 { 4 } else { 1 })
    } else {
        short(opening)
    }
}

/// The first collisions; nothing where there are none.
pub(super) fn collisions(summary: &Summary, review: &Review) -> String {
    let all = review.outcome.collisions.all();
    if all.is_empty() {
        return String::new();
    }
    let header = [
        "Pair",
        "Start [s]",
        "Duration [ms]",
        "Approach speed [m/s]",
        "Impulse [kN·s]",
        "Peak force [kN]",
    ];
    let rows: Vec<_> = all
        .iter()
        .take(FIRST)
        .map(|one| collision(summary, one))
        .collect();
    let title = if all.len() > FIRST {
        format!("The first {FIRST} of {} collisions", all.len())
    } else {
        "Collisions".into()
    };
    format!("<h2>{title}</h2>\n{}", table(&header, &rows))
}

fn collision(summary: &Summary, one: &Collision) -> Vec<Cell> {
    let pair = &summary.pairs[one.pair];
    vec![
        Cell::new(format!("{} – {}", pair.left, pair.right)),
        Cell::new(digits(one.start)),
        Cell::new(short(1e3 * (one.end - one.start))),
        Cell::known(one.approach_speed.map(short)),
        Cell::new(short(one.impulse / 1e3)),
        Cell::known(thousandths(one.peak_force)),
    ]
}

/// The ground motion: what it is, and what was read of its file.
pub(super) fn record(summary: &Summary) -> String {
    let one = &summary.record;
    let used = &summary.scene.record;
    let gravity = used.gravity_m_per_s2;
    let mut rows: Vec<(String, String)> = vec![
        ("source".into(), used.source.to_string()),
        (
            "as used".into(),
            format!(
                "{} samples, {} s apart; peak {} g = {} m/s² at {} s (g = {gravity} m/s²)",
                one.samples,
                digits(one.time_step_s),
                short(one.peak_m_per_s2 / gravity),
                short(one.peak_m_per_s2),
                digits(one.peak_time_s)
            ),
        ),
    ];
    rows.push((
        "processing".into(),
        if one.processing.is_empty() {
            "none: as its source has it".into()
        } else {
            one.processing.join("; ")
        },
    ));
    if let Some(hash) = &one.sha256 {
        rows.push(("SHA-256 of the file".into(), hash.clone()));
    }
    if !one.provenance.is_empty() {
        rows.push(("its file says".into(), one.provenance.clone()));
    }
    for reading in &one.readings {
        let line = reading
            .line
            .map_or_else(String::new, |line| format!(", line {line}"));
        rows.push((
            format!("read: {}{line}", reading.what),
            reading.found.clone(),
        ));
    }
    facts(&rows)
}

/// Method, settings, errors and work.
pub(super) fn method(summary: &Summary, review: &Review, sampling: &str) -> String {
    let method = &summary.method;
    let mut rows = vec![(
        "method".into(),
        format!(
            "{}, {} s",
            method.name.replace('_', " "),
            digits(method.duration_s)
        ),
    )];
    let settings = serde_json::to_value(summary.scene.method).unwrap_or_default();
    rows.extend(entries(&settings[&method.name]));
    if let Some(goal) = method.chosen_for_error {
        let chosen = format!("the cheapest that keeps all errors below {}", percent(goal));
        rows.push(("chosen".into(), chosen));
    }
    let contacts = summary.scene.contacts.iter().flatten();
    for (neighbours, contact) in summary.scene.structures.windows(2).zip(contacts) {
        let name = contact.law.name();
        let law = serde_json::to_value(contact.law).unwrap_or_default();
        let parameters = entries(&law[name]);
        let parameters = parameters.map(|(name, value)| format!("{name} = {value}"));
        let parameters: Vec<String> = parameters.collect();
        rows.push((
            format!(
                "contact {} – {}",
                neighbours[0].name(),
                neighbours[1].name()
            ),
            format!("{}: {}", name.replace('_', " "), parameters.join(", ")),
        ));
    }
    let interval = format!("every {} s: {sampling}", digits(method.history_interval_s));
    rows.push(("histories".into(), interval));
    if let Errors::Unknown(reason) = &review.errors {
        rows.push((
            "errors".into(),
            format!("not known, the exact run fails: {reason}"),
        ));
    }
    rows.push(("work".into(), work(summary)));
    facts(&rows)
}

/// Names and values of a JSON object.
fn entries(object: &Value) -> impl Iterator<Item = (String, String)> {
    let entries = object.as_object().into_iter().flatten();
    entries.map(|(name, value)| {
        let text = || {
            let text = value.as_str();
            text.map_or_else(|| value.to_string(), String::from)
        };
        let value = value.as_f64().map_or_else(text, digits);
        (name.clone(), value)
    })
}

fn work(summary: &Summary) -> String {
    let work = &summary.work;
    if summary.method.time_step_s.is_none() {
        return format!("{} pieces of motion, {} events", work.segments, work.events);
    }
    format!(
        "{} steps, {} force evaluations, {} Newton iterations, {} steps in contact",
        work.steps, work.force_evaluations, work.newton_iterations, work.touching_steps
    )
}

/// Where the energy went.
pub(super) fn ledger(summary: &Summary) -> String {
    let one = &summary.ledger;
    let terms = [
        ("energy at the start", one.initial_j),
        ("work of the shaking", one.input_j),
        ("work of bases that move towards each other", one.opening_j),
        ("kinetic energy at the end", one.kinetic_j),
        ("strain energy at the end", one.strain_j),
        ("taken by viscous damping", one.damping_j),
        ("taken by yielding", one.hysteretic_j),
        ("taken by impulsive impacts", one.impact_j),
        ("taken by compliant contact", one.contact_j),
    ];
    let mut rows: Vec<(String, String)> = terms
        .iter()
        .filter(|(_, value)| value.abs() > ROUNDING * one.scale_j)
        .map(|(what, value)| ((*what).into(), format!("{} kJ", short(value / 1e3))))
        .collect();
    rows.push((
        "left over by the balance".into(),
        format!(
            "{} of the {} kJ that energies are measured by",
            percent(one.residual),
            short(one.scale_j / 1e3)
        ),
    ));
    facts(&rows)
}
