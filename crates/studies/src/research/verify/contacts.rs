//! Contacts of random rows: gaps, laws and levels.

use crate::study::laws::{free_pair, is_linear};
use pounding_contact::{Calibration, ContactLaw, LawName, Stereomechanical};

use super::random::Random;
use pounding_scene::{ColumnShape, Contact, Property, Structure};

/// Approach speed for the calibration of laws that need one \[m/s\].
const SPEED: f64 = 0.3;

/// The property that the laws of a row share.
#[derive(Debug, Clone, Copy)]
enum Style {
    Impulsive,
    Compliant,
    Mixed,
}

/// A contact for each structure with its right neighbour.
pub(super) fn all(random: &mut Random, structures: &[Structure]) -> Vec<Contact> {
    use Style::{Compliant, Impulsive, Mixed};
    let style = random.one_of(&[Impulsive, Impulsive, Impulsive, Compliant, Compliant, Mixed]);
    let alike = random.chance(0.3);
    let some_levels = random.chance(0.2);
    let mut contacts: Vec<Contact> = Vec::new();
    for two in structures.windows(2) {
        let (gap_m, law) = (gap(random), law(random, style, two));
        let levels = some_levels.then(|| levels(random, two)).flatten();
        contacts.push(match contacts.first() {
            Some(first) if alike => Contact { levels, ..first.clone() },
            _ => Contact {
                gap_m,
                law,
                levels,
                heights_m: None,
                seat_width_m: None,
                column_shape: ColumnShape::default(),
                property: Property::default(),
            },
        });
    }
    contacts
}

fn gap(random: &mut Random) -> f64 {
    match random.below(7) {
        0 => 0.0,
        1 => random.log_within(1e-6, 1e-3),
        2 => random.one_of(&[0.01, 0.02, 0.03, 0.05]),
        _ => random.log_within(1e-3, 0.1),
    }
}

/// Levels at which a pair can touch: the highest common one, or some of them. `None` if all levels can touch.
fn levels(random: &mut Random, two: &[Structure]) -> Option<Vec<usize>> {
    let storeys = two.iter().filter_map(|one| match one {
        Structure::Sdof(_) => Some(1),
        Structure::Building(building) => Some(building.storeys.len()),
        Structure::Wall => None,
    });
    let common = storeys.min()?;
    let some: Vec<usize> = (1..common).filter(|_| random.chance(0.3)).collect();
    Some(some.into_iter().chain([common]).collect())
}

fn law(random: &mut Random, style: Style, two: &[Structure]) -> ContactLaw {
    let impulsive = match style {
        Style::Impulsive => true,
        Style::Compliant => false,
        Style::Mixed => random.chance(0.5),
    };
    if impulsive {
        let restitution = match random.below(8) {
            0 => 0.0,
            1 if random.chance(0.5) => 1.0,
            2 => 0.65,
            _ => random.within(0.0, 1.0),
        };
        return ContactLaw::Stereomechanical(Stereomechanical { restitution });
    }
    // The first law of the list is the impulsive one.
    let name = random.one_of(&LawName::ALL[1..]);
    let (low, high) = if is_linear(name) { (1e7, 2e9) } else { (1e8, 1e10) };
    let stiffness = random.log_within(low, high);
    let pair = free_pair(two, SPEED);
    let restitution = random.within(0.1, 1.0);
    let calibrated = |e: f64| name.calibrated(stiffness, e, Calibration::Exact, &pair);
    // Springs without damping can only have e = 1.
    calibrated(restitution)
        .or_else(|_| calibrated(1.0))
        .expect("stiffness and restitution are in range")
}
