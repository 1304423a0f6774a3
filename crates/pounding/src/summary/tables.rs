//! The tables of a run: structures, what is left of their motion, storeys, pairs.

use pounding::report::{Shown, tables};
use pounding::scene::{Floors, Quantity, RunResult, Simulation};
use pounding::text::instant;

use crate::text::{NONE, paragraph, short, table};

/// Words that are too long for a column.
const ABBREVIATIONS: [(&str, &str); 4] = [
    ("displacement", "displ."),
    ("acceleration", "accel."),
    ("Transferred", "Transf."),
    ("Collisions", "Colli- sions"),
];

/// A name for a column of places, and those of some numbers.
fn header<Q: Into<Quantity> + Copy>(places: &str, quantities: &[Q]) -> Vec<[String; 3]> {
    let of = |quantity: &Q| {
        let about = (*quantity).into().about();
        let mut heading = about.heading.to_string();
        for (long, brief) in ABBREVIATIONS {
            heading = heading.replace(long, brief);
        }
        let unit = about.shown_unit();
        let [first, second] = heading.split_once(' ').map_or([&heading, ""], |(first, second)| [first, second]);
        if second.is_empty() {
            [first, &unit, ""]
        } else {
            [first, second, &unit]
        }
        .map(String::from)
    };
    let first = [places, "", ""].map(String::from);
    std::iter::once(first).chain(quantities.iter().map(of)).collect()
}

/// The lines of a place: its numbers, and below them their errors if these were measured.
fn lines<Q: Into<Quantity> + Copy>(shown: &Shown<'_>, name: String, (quantities, place): (&[Q], usize)) -> Vec<Vec<String>> {
    let texts = quantities.iter().map(|one| shown.text(*one, place).unwrap_or_else(|| NONE.into()));
    let numbers = std::iter::once(name).chain(texts).collect();
    let errors = quantities.iter().map(|one| shown.error(*one, place).unwrap_or_default());
    let errors = shown
        .is_measured()
        .then(|| std::iter::once("  error".into()).chain(errors).collect());
    std::iter::once(numbers).chain(errors).collect()
}

/// Peaks of every floor and wall.
pub(super) fn structures(floors: &Floors, shown: &Shown<'_>) -> String {
    let of = |floor: usize| lines(shown, floors.all()[floor].name.clone(), (tables::STRUCTURES, floor));
    let rows: Vec<_> = floors.by_structure().flat_map(of).collect();
    table(&header("Structure", tables::STRUCTURES), &rows)
}

/// What is left of the motion at the end, and what stands on the floors felt of it; nothing of walls.
pub(super) fn motions(floors: &Floors, shown: &Shown<'_>) -> String {
    let moving = floors.by_structure().filter(|floor| !floors.all()[*floor].is_wall());
    let of = |floor: usize| lines(shown, floors.all()[floor].name.clone(), (tables::MOTIONS, floor));
    let rows: Vec<_> = moving.flat_map(of).collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header("Structure", tables::MOTIONS), &rows)
}

/// Drifts of the storeys of buildings, from the ground up; nothing where every structure has one storey.
pub(super) fn storeys(floors: &Floors, shown: &Shown<'_>) -> String {
    let storeys = floors.by_structure().filter(|floor| floors.all()[*floor].storey.is_some());
    let rows = storeys.flat_map(|floor| {
        let own: Vec<_> = tables::STOREYS.iter().map(|one| shown.of_storey(*one, floor)).collect();
        lines(shown, floors.all()[floor].name.clone(), (&own, floor))
    });
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header("Storey", tables::STOREYS), &rows)
}

/// Collisions of every pair.
pub(super) fn pairs(prepared: &Simulation, outcome: &RunResult, shown: &Shown<'_>) -> String {
    let floors = prepared.floors();
    if floors.facing().is_empty() {
        return paragraph("Pairs", "none: no contact is modelled");
    }
    let rows = floors.pairs_by_contact().into_iter().flat_map(|pair| {
        let [left, right] = floors.names(pair);
        lines(shown, format!("{left} – {right}"), (tables::PAIRS, pair))
    });
    let table = table(&header("Pair", tables::PAIRS), &rows.collect::<Vec<_>>());
    let leaning = leaning(floors, outcome);
    if leaning.is_empty() {
        return table;
    }
    format!("{table}\n{leaning}")
}

/// Pairs that lean on each other; nothing where none does.
pub(super) fn leaning(floors: &Floors, outcome: &RunResult) -> String {
    let said = |pair: usize| {
        let one = outcome.of_pair(pair).leaning()?;
        let [left, right] = floors.names(pair);
        Some(format!(
            "{left} – {right} for {} s from {} s on",
            short(one.end - one.start),
            instant(one.start)
        ))
    };
    let pairs = floors.pairs_by_contact().into_iter();
    let said: Vec<String> = pairs.filter_map(said).collect();
    if said.is_empty() {
        return String::new();
    }
    paragraph(
        "Leaning",
        &format!(
            "touches of more than 0.25 s are pushes, and their impulses no measure of a blow: {}",
            said.join("; ")
        ),
    )
}
