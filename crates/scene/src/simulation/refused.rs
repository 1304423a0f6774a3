//! Refusals of a row by the solver, in the words of the scene.

use pounding_solver::ModelError;
use pounding_text::{RefusalKind, Refused, digits, plain};

use crate::settings::out_of_range;
use crate::simulation::floors::{Floor, Floors};
use crate::{Scene, Structure};

/// Converts the solver's refusal of a row to the fields of the scene.
pub(super) fn of_model(error: &ModelError, scene: &Scene, floors: &Floors) -> Refused {
    let contact = |pair: usize| floors.facing().get(pair).map_or(0, |one| one.contact);
    let given = |index: usize| scene.contacts.iter().flatten().nth(index);
    match *error {
        ModelError::OverlapsAtStart { pair, overlap } => {
            let index = contact(pair);
            let gap = plain(given(index).map_or(0.0, |contact| contact.gap_m));
            let found = format!(
                "{gap}, but the initial displacements of structures[{index}] and [{}] close that gap and overlap by {} m",
                index + 1,
                digits(overlap)
            );
            let found = Refused::at(format!("contacts[{index}].gap_m")).found(found);
            found
                .but("; allowed is ", "a gap that they leave open, or other initial_displacement_m")
                .kind(RefusalKind::Together)
        }
        // Contacts join neighbours in order, so that only a wall on either side is possible.
        ModelError::NotNeighbours { pair, .. } => {
            let place = format!("contacts[{}]", contact(pair));
            Refused::at(place)
                .found("a wall on either side")
                .allowed("at most one wall per contact")
        }
        ModelError::Node { node, field, found, .. } if floors.all()[node].made_of.is_some() => {
            of_node(&floors.all()[node], scene, field, found)
        }
        ModelError::Pair {
            pair,
            field,
            found,
            allowed,
        } => {
            let index = contact(pair);
            let law = given(index).map_or("", |contact| contact.law.name());
            let place = match field {
                "gap" => format!("contacts[{index}].gap_m"),
                parameter => format!("contacts[{index}].law.{law}.{parameter}"),
            };
            out_of_range(place, found, allowed)
        }
        ModelError::Link {
            link,
            field,
            found,
            allowed,
        } => {
            let law = scene.links.get(link).map_or("", |link| link.law.name());
            out_of_range(format!("links[{link}].law.{law}.{field}"), found, allowed)
        }
        ModelError::OutOfRange { .. }
        | ModelError::Node { .. }
        | ModelError::Point { .. }
        | ModelError::NotAFloor { .. }
        | ModelError::Arrivals { .. }
        | ModelError::NoSamples
        | _ => Refused::that(error.to_string()),
    }
}

/// Converts the refusal of a floor to its field in the scene.
fn of_node(floor: &Floor, scene: &Scene, field: &str, found: f64) -> Refused {
    let structure = floor.structure;
    let of_structure = match &scene.structures[structure] {
        Structure::Building(_) => format!("structures[{structure}].building"),
        Structure::Sdof(_) | Structure::Wall => format!("structures[{structure}].sdof"),
    };
    let of_floor = match floor.storey {
        Some(storey) => format!("{of_structure}.storeys[{}]", storey - 1),
        None => of_structure.clone(),
    };
    let (place, found, allowed) = match field {
        "inverse_mass" => (
            format!("{of_floor}.mass_kg"),
            floor.made_of.map_or(found, |made| made.mass_kg),
            "a mass whose inverse is a finite number",
        ),
        "initial_displacement" => (format!("{of_floor}.initial_displacement_m"), found, "a finite number"),
        "initial_velocity" => (format!("{of_floor}.initial_velocity_m_per_s"), found, "a finite number"),
        _ => (
            format!("{of_structure}.damping"),
            found,
            "damping of which the coefficients [N s/m] are finite and not negative, before and after yielding",
        ),
    };
    out_of_range(place, found, allowed)
}
