//! What was modelled: the tables of structures and contacts that a reader checks against drawings.

use super::markup::{Cell, digits, short, table};
use crate::summary::Summary;
use pounding_scene::{Columns, Contact, Damping, Floor, Floors, Scene, StoreyProperties, Structure};

/// The structures and the contacts between them.
pub(super) fn scene(summary: &Summary, floors: &Floors) -> String {
    let contacts = contacts(&summary.scene);
    format!("{}{contacts}", structures(&summary.scene, floors))
}

/// A row per floor, building by building from the ground up.
fn structures(scene: &Scene, floors: &Floors) -> String {
    let header = [
        "Structure",
        "Mass [t]",
        "Stiffness [MN/m]",
        "Height [m]",
        "Yields at [kN]",
        "Columns",
        "Period [s]",
        "Damping ratio",
    ];
    let structures = scene.structures.iter().enumerate();
    let rows = structures.flat_map(|(index, structure)| {
        let own = floors.of_structure(index).iter();
        let own = own.map(|floor| &floors.all()[*floor]);
        let own = own.filter_map(|floor| Some((floor, floor.made_of?)));
        let rows: Vec<_> = own.map(|one| row(structure, one)).collect();
        if rows.is_empty() {
            vec![wall(structure, header.len())]
        } else {
            rows
        }
    });
    table(&header, &rows.collect::<Vec<_>>())
}

fn wall(structure: &Structure, n_columns: usize) -> Vec<Cell> {
    let mut row = vec![Cell::new(structure.name()).over(Some("fixed".into()))];
    row.resize(n_columns, Cell::known(None));
    row
}

fn row(structure: &Structure, (floor, made): (&Floor, StoreyProperties)) -> Vec<Cell> {
    let scaled = |value: f64, factor: f64| short(factor * value);
    let columns = made.columns;
    // Period and damping are the building's, and stand beside its first storey.
    let first = floor.storey.is_none_or(|storey| storey == 1);
    let of_structure = |value: Option<f64>| match value.filter(|_| first) {
        Some(value) => Cell::new(short(value)),
        None => Cell::new(""),
    };
    let given = given(structure).filter(|_| first);
    vec![
        Cell::new(&floor.name).over(start(made.initial_displacement_m, made.initial_velocity_m_per_s)),
        Cell::new(scaled(made.mass_kg, 1e-3)),
        Cell::new(scaled(columns.stiffness_n_per_m, 1e-6)),
        Cell::known(made.height_m.map(digits)),
        Cell::known(columns.yield_force_n.map(|force| scaled(force, 1e-3))),
        Cell::new(kind(&columns)).over(shape(&columns)),
        of_structure(structure.period()),
        of_structure(structure.damping_ratio()).over(given),
    ]
}

/// How a floor starts, where it is not at rest.
fn start(displacement: f64, velocity: f64) -> Option<String> {
    (displacement != 0.0 || velocity != 0.0).then(|| {
        let (displacement, velocity) = (digits(1e3 * displacement), digits(velocity));
        format!("starts at {displacement} mm, {velocity} m/s")
    })
}

fn kind(columns: &Columns) -> &'static str {
    match (columns.yield_force_n, columns.bouc_wen) {
        (None, _) => "elastic",
        (Some(_), Some(_)) => "Bouc–Wen",
        (Some(_), None) if columns.hardening_ratio.is_some_and(|ratio| ratio > 0.0) => "bilinear",
        (Some(_), None) => "perfectly plastic",
    }
}

/// What the loop of yielding columns looks like.
fn shape(columns: &Columns) -> Option<String> {
    columns.yield_force_n?;
    let hardening = columns.hardening_ratio.filter(|ratio| *ratio > 0.0);
    let hardening = hardening.map(|ratio| format!("hardening {}", digits(ratio)));
    let smooth = columns.bouc_wen;
    let smooth = smooth.map(|one| format!("n = {}, β = {}", one.exponent, digits(one.beta)));
    let parts: Vec<String> = smooth.into_iter().chain(hardening).collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// How the damping was given, where it is not the ratio that stands above.
fn given(structure: &Structure) -> Option<String> {
    let (damping, storeys) = match structure {
        Structure::Sdof(sdof) => (sdof.damping, 1),
        Structure::Building(building) => (building.damping, building.storeys.len()),
        Structure::Wall => return None,
    };
    let two = |[one, other]: [f64; 2]| format!("{} and {}", digits(one), digits(other));
    match damping {
        Damping::Ratio(_) => (storeys > 1).then(|| "in modes 1 and 2".into()),
        Damping::Rayleigh { alpha_per_s, beta_s } => Some(format!("α = {} /s, β = {} s", digits(alpha_per_s), digits(beta_s))),
        Damping::TwoFrequencies { frequencies_hz, ratios } => Some(format!("{} at {} Hz", two(ratios), two(frequencies_hz))),
        Damping::Modes { modes, ratios } => Some(format!("{} in modes {} and {}", two(ratios), modes[0], modes[1])),
    }
}

/// A row per contact; nothing where structures stand apart.
fn contacts(scene: &Scene) -> String {
    let header = ["Contact", "Gap [mm]", "Law", "Delivers e", "Parameters"];
    let contacts = scene.contacts.iter().flatten();
    let between = scene.structures.windows(2).zip(contacts);
    let rows: Vec<_> = between.map(|(neighbours, contact)| contact_row(neighbours, contact)).collect();
    if rows.is_empty() {
        return "<p>No contact between structures was asked for.</p>\n".into();
    }
    table(&header, &rows)
}

fn contact_row(neighbours: &[Structure], contact: &Contact) -> Vec<Cell> {
    let name = contact.law.name();
    let law = serde_json::to_value(contact.law).unwrap_or_default();
    let parameter = |(name, value): (&String, &serde_json::Value)| {
        let value = value.as_f64().map_or_else(|| value.to_string(), short);
        format!("{name} = {value}")
    };
    let parameters = law[name].as_object().into_iter().flatten();
    let parameters: Vec<String> = parameters.map(parameter).collect();
    let levels = contact.levels.as_ref().map(|levels| {
        let levels: Vec<String> = levels.iter().map(ToString::to_string).collect();
        format!("at levels {}", levels.join(", "))
    });
    let names: Vec<&str> = neighbours.iter().map(Structure::name).collect();
    vec![
        Cell::new(names.join(" – ")).over(levels),
        Cell::new(digits(1e3 * contact.gap_m)),
        Cell::new(name.replace('_', " ")),
        Cell::known(contact.law.restitution().map(short)),
        Cell::new(parameters.join(", ")).wrapped(),
    ]
}
