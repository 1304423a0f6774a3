//! The lines of a folder of records for programs: CSV and JSON, SI units.

use pounding::report::{PairSummary, SCHEMA_VERSION, StructureSummary};
use pounding::scene::{Scene, Suite};
use pounding::text::{Cell, csv_text, json_text};
use serde_json::json;

use super::{Found, Line};

/// Numbers of a structure with their names, SI units: those of its summary, nothing where there is none.
fn of_structure(one: &StructureSummary) -> Vec<(&'static str, f64)> {
    let numbers = [
        ("peak_displacement_m", one.peak_displacement_m),
        ("peak_displacement_time_s", one.peak_displacement_time_s),
        ("peak_shear_force_n", one.peak_shear_force_n),
        ("peak_shear_force_time_s", one.peak_shear_force_time_s),
        ("peak_drift_m", one.peak_drift_m),
        ("peak_drift_time_s", one.peak_drift_time_s),
        ("residual_displacement_at_end_m", one.residual_displacement_at_end_m),
        ("residual_drift_at_end_m", one.residual_drift_at_end_m),
        ("peak_acceleration_m_per_s2", one.peak_acceleration_m_per_s2),
        ("peak_acceleration_time_s", one.peak_acceleration_time_s),
        ("ductility", one.ductility),
        ("drift_ratio", one.drift_ratio),
        ("transferred_momentum_n_s", Some(one.transferred_momentum_n_s)),
    ];
    let numbers = numbers.into_iter();
    numbers.filter_map(|(name, value)| Some((name, value?))).collect()
}

/// Numbers of a pair with their names, SI units: fields of its summary, those of a collision after its name.
fn of_pair(one: &PairSummary) -> [(&'static str, Option<f64>); 11] {
    let (first, largest) = (one.first, one.largest);
    [
        ("collisions", Some(one.collisions as f64)),
        ("first_start_s", first.map(|first| first.start_s)),
        ("first_impulse_n_s", first.map(|first| first.impulse_n_s)),
        ("largest_start_s", largest.map(|largest| largest.start_s)),
        ("largest_impulse_n_s", largest.map(|largest| largest.impulse_n_s)),
        ("peak_force_n", one.peak_force_n),
        ("peak_force_time_s", one.peak_force_time_s),
        ("total_impulse_n_s", Some(one.total_impulse_n_s)),
        ("touching_s", Some(one.touching_s)),
        ("least_opening_m", Some(one.least_opening_m)),
        ("least_opening_time_s", Some(one.least_opening_time_s)),
    ]
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
        let numbers = of_structure(structure).into_iter();
        rows.extend(numbers.map(|(quantity, value)| own(alone(floor), quantity, Some(value))));
    }
    for (facing, pair) in found.floors.facing().iter().zip(&found.pairs) {
        let ([left, left_floor], [right, right_floor]) = (at(facing.left), at(facing.right));
        let place = [left, left_floor, right, right_floor];
        rows.extend(of_pair(pair).map(|(quantity, value)| own(place.clone(), quantity, value)));
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
