//! The lines of a folder of records for programs: CSV and JSON, SI units.

use pounding::assess::Suite;
use pounding::report::SCHEMA_VERSION;
use pounding::scene::{FloorQuantity, PairQuantity, Quantity, QuantityKind, Scene};
use pounding::text::{Cell, csv_text, json_text};
use serde_json::json;

use super::{Found, Line};

/// What a run does, of the numbers of a table.
fn measured<Q: Into<Quantity> + Copy>(all: &[Q]) -> impl Iterator<Item = (Q, &'static str)> {
    let named = all.iter().map(|one| (*one, (*one).into().about()));
    let measured = named.filter(|(_, about)| about.kind != QuantityKind::Model);
    measured.map(|(one, about)| (one, about.name))
}

/// Columns of the table.
const HEADER: [&str; 10] = [
    "record",
    "event",
    "reversed",
    "building",
    "floor",
    "neighbour",
    "neighbour_floor",
    "quantity",
    "value",
    "refused",
];

/// Building and floor of both sides; empty of a run.
type Place = [Cell; 4];

/// A row per number of every structure and pair of every run: of which, what, and its value; SI units.
pub(super) fn csv(records: &Suite, lines: &[Line]) -> String {
    let refused = |name: &str, [event, reversed]: [Cell; 2], reason: &str| {
        let mut row: [Cell; 10] = std::array::from_fn(|_| Cell::default());
        row[0] = name.into();
        [row[1], row[2]] = [event, reversed];
        row[9] = reason.into();
        row
    };
    let rows = lines.iter().flat_map(|line| match &line.found {
        Ok(found) => of_run(line, found),
        Err(reason) => {
            let run = [(line.event + 1).into(), line.reversed.into()];
            vec![refused(&line.motion, run, reason)]
        }
    });
    let none = || [Cell::default(), Cell::default()];
    let left_out = records.left_out.iter();
    let left_out = left_out.map(|one| refused(&one.name, none(), &one.reason.sentence()));
    csv_text(&HEADER, rows.chain(left_out))
}

fn row(line: &Line, reversed: bool, (place, quantity, value): (Place, &str, Option<f64>)) -> [Cell; 10] {
    let [building, floor, neighbour, neighbour_floor] = place;
    [
        line.motion.as_str().into(),
        (line.event + 1).into(),
        reversed.into(),
        building,
        floor,
        neighbour,
        neighbour_floor,
        quantity.into(),
        Cell::exact(value),
        Cell::default(),
    ]
}

fn of_run(line: &Line, found: &Found) -> Vec<[Cell; 10]> {
    let own = |place: Place, quantity: &str, value| row(line, line.reversed, (place, quantity, value));
    let at = |floor: usize| -> [Cell; 2] {
        let structure = found.floors.all()[floor].structure;
        let building = found.names[structure].as_str();
        [building.into(), found.floors.storey_of(floor).into()]
    };
    let alone = |floor: usize| {
        let [building, storey] = at(floor);
        [building, storey, Cell::default(), Cell::default()]
    };
    let mut rows = vec![
        own(Place::default(), "pga_m_per_s2", Some(found.pga)),
        own(Place::default(), "scale_factor", Some(found.scale)),
        own(Place::default(), "largest_error", found.error),
        own(Place::default(), "warnings", Some(found.warnings.len() as f64)),
    ];
    for (floor, structure) in found.structures.iter().enumerate() {
        let numbers = measured(FloorQuantity::ALL).map(|(one, name)| (name, structure.numbers.get(one)));
        rows.extend(
            numbers
                .filter(|one| one.1.is_some())
                .map(|(name, value)| own(alone(floor), name, value)),
        );
    }
    for (facing, pair) in found.floors.facing().iter().zip(&found.pairs) {
        let ([left, left_floor], [right, right_floor]) = (at(facing.left), at(facing.right));
        let place = [left, left_floor, right, right_floor];
        rows.extend(measured(PairQuantity::ALL).map(|(one, name)| own(place.clone(), name, pair.number(one))));
    }
    if let Some(effects) = &found.effects {
        let both = [(line.reversed, &effects.as_given), (!line.reversed, &effects.reversed)];
        for (reversed, all) in both {
            for (floor, effects) in all.iter().enumerate() {
                let facts = effects.facts().into_iter();
                rows.extend(
                    facts.map(|(quantity, value, _)| row(line, reversed, (alone(floor), &format!("effect_{quantity}"), Some(value)))),
                );
            }
        }
    }
    rows
}

/// The same with everything that a summary has of structures and pairs.
pub(super) fn json(scene: &Scene, records: &Suite, lines: &[Line]) -> String {
    let line = |line: &Line| match &line.found {
        Ok(found) => json!({
            "record": line.motion,
            "event": line.event + 1,
            "reversed": line.reversed,
            "pga_m_per_s2": found.pga,
            "scale_factor": found.scale,
            "largest_error": found.error,
            "unusual": found.unusual,
            "warnings": found.warnings,
            "structures": found.structures,
            "pairs": found.pairs,
            "effects": found.effects,
        }),
        Err(reason) => {
            json!({"record": line.motion, "event": line.event + 1, "reversed": line.reversed, "refused": reason})
        }
    };
    json_text(&json!({
        "schema_version": SCHEMA_VERSION,
        "scene": scene,
        "unusual": super::unusual(lines),
        "records": records.json(),
        "warnings": super::warnings(records, lines),
        "motions": lines.iter().map(line).collect::<Vec<_>>(),
        "left_out": records.left_out_json(),
    }))
}
