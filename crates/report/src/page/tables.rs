//! The tables of the page.

use super::markup::{Cell, digits, escaped, facts, short, signed, table};
use crate::shown::Shown;
use crate::shown::tables::{PAIRS_OF_PAGE, STOREYS_OF_PAGE, STRUCTURES_OF_PAGE};
use crate::summary::{PairSummary, RecordSummary, Summary};
use pounding_scene::{Errors, FloorQuantity, Floors, Quantity, QuantityKind, Review, Simulation};
use pounding_solver::Collision;
use pounding_text::{instant, percent};
use serde_json::Value;

/// Collisions beyond these are in `impacts.csv` only.
const FIRST: usize = 10;
/// Energies below this part of what they are measured by are none.
const ROUNDING: f64 = 1e-12;

fn thousandths(value: Option<f64>) -> Option<String> {
    value.map(|value| short(value / 1e3))
}

/// A name of the place, and a cell for each of these numbers.
fn row<Q: Into<Quantity> + Copy>(shown: &Shown<'_>, name: Cell, (quantities, place): (&[Q], usize)) -> Vec<Cell> {
    let cells = quantities.iter().map(|quantity| cell(shown, (*quantity).into(), place));
    std::iter::once(name).chain(cells).collect()
}

/// A number over its error; what cannot be compared says so.
fn cell(shown: &Shown<'_>, quantity: Quantity, place: usize) -> Cell {
    let text = shown.text(quantity, place);
    let error = shown.error(quantity, place).filter(|_| shown.value(quantity, place).is_some());
    let is_count = quantity.about().kind == QuantityKind::Count;
    let below = error.map(|error| match error.as_str() {
        "∞" => "not comparable".into(),
        _ if is_count => error,
        _ => format!("error {error}"),
    });
    Cell::known(text.map(|text| signed(&text))).over(below)
}

/// A name for a column of places, and those of some numbers.
fn header<Q: Into<Quantity> + Copy>(places: &str, quantities: &[Q]) -> Vec<String> {
    let titles = quantities.iter().map(|quantity| (*quantity).into().about().title());
    std::iter::once(places.into()).chain(titles).collect()
}

/// The structures.
pub(super) fn structures(prepared: &Simulation, review: &Review) -> String {
    let (shown, floors) = (Shown::of(prepared, review), prepared.floors());
    let name = |floor: usize| Cell::new(&floors.all()[floor].name);
    let rows: Vec<_> = floors
        .by_structure()
        .map(|floor| row(&shown, name(floor), (STRUCTURES_OF_PAGE, floor)))
        .collect();
    format!(
        "{}{}<p class=\"soft\">Accelerations are absolute, that of the ground included, impulsive impacts left out. Residual is the displacement at the end of the run, at {} s; \
         free vibration that has not died away by then is still in it.</p>\n",
        table(&header("Structure", STRUCTURES_OF_PAGE), &rows),
        storeys(&shown, floors),
        digits(prepared.duration())
    )
}

/// Drifts of storeys; nothing where no structure says more of them than its displacement.
fn storeys(shown: &Shown<'_>, floors: &Floors) -> String {
    let tells = |floor: &usize| {
        let own = [FloorQuantity::DriftRatio, FloorQuantity::Ductility];
        floors.all()[*floor].storey.is_some() || own.iter().any(|one| shown.value(*one, *floor).is_some())
    };
    let rows = floors.by_structure().filter(tells).map(|floor| {
        let own: Vec<_> = STOREYS_OF_PAGE.iter().map(|one| shown.of_storey(*one, floor)).collect();
        row(shown, Cell::new(&floors.all()[floor].name), (&own, floor))
    });
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header("Columns of", STOREYS_OF_PAGE), &rows)
}

/// The pairs; nothing where structures stand apart.
pub(super) fn pairs(summary: &Summary, prepared: &Simulation, review: &Review) -> String {
    if summary.pairs.is_empty() {
        return "<p>None: no contact is modelled.</p>\n".into();
    }
    let shown = Shown::of(prepared, review);
    let in_order = prepared.floors().pairs_by_contact();
    let pairs: Vec<&PairSummary> = in_order.iter().map(|index| &summary.pairs[*index]).collect();
    let rows = in_order.iter().zip(&pairs).map(|(index, one)| {
        let name = Cell::new(format!("{} – {}", one.left, one.right)).over(Some(one.law.replace('_', " ")));
        row(&shown, name, (PAIRS_OF_PAGE, *index))
    });
    format!(
        "{}{}",
        table(&header("Pair", PAIRS_OF_PAGE), &rows.collect::<Vec<_>>()),
        leaning(&pairs)
    )
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
