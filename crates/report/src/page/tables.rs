//! The tables of the page.

use super::markup::{Cell, digits, escaped, facts, short, table};
use crate::summary::{PairSummary, RecordSummary, StructureSummary, Summary};
use pounding_scene::{Errors, Floors, Review};
use pounding_solver::Collision;
use pounding_text::{instant, milliseconds, percent, rounded_down};
use serde_json::Value;

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
pub(super) fn structures(summary: &Summary, floors: &Floors) -> String {
    let header = [
        "Structure",
        "Peak displacement [mm]",
        "at [s]",
        "Residual, at the end [mm]",
        "Peak acceleration [g]",
        "at [s]",
        "Peak shear force [kN]",
        "at [s]",
        "Transferred momentum [kN·s]",
    ];
    let gravity = summary.scene.record.gravity_m_per_s2;
    let in_order = floors.by_structure();
    let in_order: Vec<_> = in_order.map(|index| &summary.structures[index]).collect();
    let rows: Vec<_> = in_order.iter().map(|one| structure(one, gravity)).collect();
    format!(
        "{}{}<p class=\"soft\">Accelerations are absolute, that of the ground included, impulsive impacts left out. Residual is the displacement at the end of the run, at {} s; \
         free vibration that has not died away by then is still in it.</p>\n",
        table(&header, &rows),
        storeys(&in_order),
        digits(summary.method.duration_s)
    )
}

/// Drifts of storeys; nothing where no structure says more of them than its displacement.
fn storeys(structures: &[&StructureSummary]) -> String {
    let header = [
        "Columns of",
        "Peak drift [mm]",
        "at [s]",
        "Residual, at the end [mm]",
        "Drift ratio",
        "Ductility",
    ];
    let tells = |one: &StructureSummary| {
        let drift = one.peak_drift_m.or(one.drift_ratio).or(one.ductility);
        drift.is_some() || one.storey.is_some()
    };
    let telling = structures.iter().filter(|one| tells(one));
    let rows: Vec<_> = telling.map(|one| storey(one)).collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header, &rows)
}

fn storey(one: &StructureSummary) -> Vec<Cell> {
    // On the ground the drift is the displacement.
    let upper = one.peak_drift_m.is_some();
    let of = |drift: Option<f64>, displacement| if upper { drift } else { displacement };
    let drift = of(one.peak_drift_m, one.peak_displacement_m);
    let time = of(one.peak_drift_time_s, one.peak_displacement_time_s);
    let last = of(one.residual_drift_at_end_m, one.residual_displacement_at_end_m);
    let off_at_end = off(one.errors.as_ref(), |errors| {
        let of_drift = errors.residual_drift_at_end;
        of_drift.or(errors.residual_displacement_at_end)
    });
    let off = off(one.errors.as_ref(), |errors| errors.peak_drift.or(errors.peak_displacement));
    let millimetres = |value: Option<f64>| Cell::known(value.map(|value| short(1e3 * value)));
    vec![
        Cell::new(&one.name),
        millimetres(drift).over(off.clone()),
        Cell::known(time.map(instant)),
        millimetres(last).over(off_at_end),
        Cell::known(one.drift_ratio.map(percent)).over(off.clone().filter(|_| one.drift_ratio.is_some())),
        Cell::known(one.ductility.map(short)).over(off.filter(|_| one.ductility.is_some())),
    ]
}

fn structure(one: &StructureSummary, gravity: f64) -> Vec<Cell> {
    let errors = one.errors.as_ref();
    // A wall has no peaks, and so no errors of them.
    let errors_of_peaks = errors.filter(|_| one.period_s.is_some());
    let displaced = off(errors_of_peaks, |errors| errors.peak_displacement);
    let time = errors_of_peaks.and_then(|errors| errors.peak_displacement_time_s);
    let momentum = Cell::new(short(one.transferred_momentum_n_s / 1e3));
    vec![
        Cell::new(&one.name),
        Cell::known(one.peak_displacement_m.map(|value| short(1e3 * value))).over(displaced),
        Cell::known(one.peak_displacement_time_s.map(instant)).over(time.map(|time| format!("error {}", milliseconds(time)))),
        Cell::known(one.residual_displacement_at_end_m.map(|value| short(1e3 * value)))
            .over(off(errors_of_peaks, |errors| errors.residual_displacement_at_end)),
        Cell::known(one.peak_acceleration_m_per_s2.map(|value| short(value / gravity)))
            .over(off(errors_of_peaks, |errors| errors.peak_acceleration)),
        Cell::known(one.peak_acceleration_time_s.map(instant)),
        Cell::known(thousandths(one.peak_shear_force_n)).over(off(errors_of_peaks, |errors| errors.peak_shear_force)),
        Cell::known(one.peak_shear_force_time_s.map(instant)),
        momentum.over(off(errors, |errors| errors.transferred_momentum)),
    ]
}

/// The pairs; nothing where structures stand apart.
pub(super) fn pairs(summary: &Summary, floors: &Floors) -> String {
    if summary.pairs.is_empty() {
        return "<p>None: no contact is modelled.</p>\n".into();
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
        "at [s]",
    ];
    let pairs = floors.pairs_by_contact().into_iter();
    let pairs: Vec<&PairSummary> = pairs.map(|index| &summary.pairs[index]).collect();
    let rows: Vec<_> = pairs.iter().map(|one| pair(one)).collect();
    format!("{}{}", table(&header, &rows), leaning(&pairs))
}

/// Pairs that lean on each other; nothing where none does.
fn leaning(pairs: &[&PairSummary]) -> String {
    let said = |pair: &&PairSummary| {
        let one = pair.leaning?;
        Some(format!(
            "{} – {} for {} s from {} s on",
            pair.left,
            pair.right,
            short(one.end_s - one.start_s),
            instant(one.start_s)
        ))
    };
    let said: Vec<String> = pairs.iter().filter_map(said).collect();
    if said.is_empty() {
        return String::new();
    }
    format!(
        "<p class=\"soft\">Neighbours that touch for longer than 0.25 s lean on each other; the impulse is then that of a push, and \
         says little about how hard they hit: {}.</p>\n",
        escaped(&said.join("; "))
    )
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
        Cell::new(opening(one.least_opening_m)).over(off(errors, |errors| errors.least_opening)),
        Cell::new(one.collisions.to_string()).over(counted),
        Cell::known(first.map(|first| digits(first.start_s))).over(time.map(|time| format!("error {}", milliseconds(time)))),
        Cell::known(thousandths(first.map(|first| first.impulse_n_s))).over(off(compared, |errors| errors.first_impulse)),
        Cell::known(thousandths(one.largest.map(|largest| largest.impulse_n_s))).over(off(compared, |errors| errors.largest_impulse)),
        force,
        Cell::known(one.peak_force_time_s.map(instant)),
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
        "at [s]",
    ];
    let rows: Vec<_> = all.iter().take(FIRST).map(|one| collision(summary, one)).collect();
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
        Cell::known(one.peak_force_time.map(instant)),
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
            processed(one)
        },
    ));
    if let Some(hash) = &one.sha256 {
        rows.push(("SHA-256 of the file".into(), hash.clone()));
    }
    if !one.provenance.is_empty() {
        rows.push(("its file says".into(), one.provenance.clone()));
    }
    for reading in &one.readings {
        let line = reading.line.map_or_else(String::new, |line| format!(", line {line}"));
        rows.push((format!("read: {}{line}", reading.what), reading.found.clone()));
    }
    facts(&rows)
}

/// What was done to the ground motion, and the factor that came of it.
fn processed(record: &RecordSummary) -> String {
    let mut all = record.processing.clone();
    if record.scale_factor.to_bits() != 1.0_f64.to_bits() {
        all.push(format!("in all × {}", short(record.scale_factor)));
    }
    all.join("; ")
}

/// Method, settings, errors and work.
pub(super) fn method(summary: &Summary, review: &Review, sampling: &str) -> String {
    let method = &summary.method;
    let mut rows = vec![(
        "method".into(),
        format!("{}, {} s", method.name.replace('_', " "), digits(method.duration_s)),
    )];
    let settings = serde_json::to_value(summary.scene.method).unwrap_or_default();
    rows.extend(entries(&settings[&method.name]));
    if let Some(goal) = method.chosen_for_error {
        let chosen = format!("the cheapest that keeps all errors below {}", percent(goal));
        rows.push(("chosen".into(), chosen));
    }
    let interval = format!("every {} s: {sampling}", digits(method.history_interval_s));
    rows.push(("histories".into(), interval));
    if let Errors::Unknown(reason) = &review.errors {
        rows.push(("errors".into(), format!("not known, the exact run fails: {reason}")));
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
