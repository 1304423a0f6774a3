//! Why the solver refuses a row, in the words of the scene.

use pounding_solver::ModelError;

use crate::simulation::floors::{Floor, Floors};
use crate::{Scene, SceneError, Structure};

impl SceneError {
    /// Says in the words of the scene why the solver refuses its row.
    pub(crate) fn of_model(error: ModelError, scene: &Scene, floors: &Floors) -> Self {
        let contact = |pair: usize| floors.facing().get(pair).map_or(0, |one| one.contact);
        if let ModelError::OverlapsAtStart { pair, overlap } = error {
            let index = contact(pair);
            let contact = scene.contacts.iter().flatten().nth(index);
            Self::OverlapsAtStart {
                contact: index,
                gap: contact.map_or(0.0, |contact| contact.gap_m),
                overlap,
            }
        } else if let ModelError::NotNeighbours { pair, .. } = error {
            // Contacts join neighbours in order: what remains is a wall on either side.
            Self::BetweenWalls { contact: contact(pair) }
        } else if let ModelError::Node { node, field, .. } = error {
            Self::of_node(&floors.all()[node], scene, field, error)
        } else if let ModelError::Pair {
            pair,
            field,
            found,
            allowed,
        } = error
        {
            let index = contact(pair);
            let law = scene.contacts.iter().flatten().nth(index);
            let law = law.map_or("", |contact| contact.law.name());
            let place = match field {
                "gap" => format!("contacts[{index}].gap_m"),
                parameter => format!("contacts[{index}].law.{law}.{parameter}"),
            };
            Self::OutOfRange { place, found, allowed }
        } else {
            Self::Model(error)
        }
    }

    /// What is wrong with a floor, by the field of the scene that it comes from.
    fn of_node(floor: &Floor, scene: &Scene, field: &str, error: ModelError) -> Self {
        let (ModelError::Node { found, .. }, Some(made)) = (&error, floor.made_of) else {
            return Self::Model(error);
        };
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
                made.mass_kg,
                "a mass whose inverse is a finite number",
            ),
            "initial_displacement" => (format!("{of_floor}.initial_displacement_m"), *found, "a finite number"),
            "initial_velocity" => (format!("{of_floor}.initial_velocity_m_per_s"), *found, "a finite number"),
            _ => (
                format!("{of_structure}.damping"),
                *found,
                "damping of which the coefficients [N s/m] are finite and not negative",
            ),
        };
        Self::OutOfRange { place, found, allowed }
    }
}
