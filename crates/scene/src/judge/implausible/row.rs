//! Implausible values between neighbours: gaps, contact that is too soft, and arrivals of the ground motion.

use pounding_contact::{ContactLaw, FreeImpact, FreePair, reduced_mass};

use super::Doubts;
use crate::{ColumnBeside, Contact, FloorPair, Simulation};
use pounding_text::{digits, short};

/// Widest usual gap \[m\]: the moat of an isolated building, or the seismic joint of tall ones.
const WIDEST: f64 = 2.0;
/// Thinnest usual slab \[m\].
const THINNEST: f64 = 0.1;
/// Longest usual collision at that speed \[s\].
const LONGEST: f64 = 0.25;
/// Longest usual delay between neighbours \[s\]: a hundred metres at an apparent velocity of 100 m/s.
const LATEST: f64 = 1.0;

pub(super) fn doubt(prepared: &Simulation, doubts: &mut Doubts) {
    let scene = prepared.scene();
    let mut facing = vec![None; scene.contacts.iter().flatten().count()];
    for one in prepared.floors().facing() {
        facing[one.contact].get_or_insert(*one);
    }
    let mut lasted = None;
    for (index, contact) in scene.contacts.iter().flatten().enumerate() {
        doubts.unless_far(
            contact.gap_m <= WIDEST,
            contact.gap_m,
            format!("contacts[{index}].gap_m"),
            format!("{} m", digits(contact.gap_m)),
            "up to 2 m; it is in metres",
        );
        if let Some(facing) = facing[index] {
            doubt_the_law(prepared, facing, contact, &mut lasted, doubts);
        }
    }
    doubt_the_slabs(prepared, doubts);
    let arrivals = scene.arrivals_s.as_deref().unwrap_or_default();
    for (index, two) in arrivals.windows(2).enumerate() {
        let apart = (two[1] - two[0]).abs();
        doubts.unless(
            apart <= LATEST,
            format!("arrivals_s[{}]", index + 1),
            format!("{} s apart from that of the neighbour", digits(apart)),
            "up to 1 s between neighbours: their distance over the apparent velocity, some hundred metres per second",
        );
    }
}

/// Notes slabs without a depth beside the slabs of a neighbour at nearly the same height: they would meet, and no column would be hit.
fn doubt_the_slabs(prepared: &Simulation, doubts: &mut Doubts) {
    let floors = prepared.floors();
    let is_thin = |floor: usize| {
        let made_of = floors.all()[floor].made_of;
        made_of.is_some_and(|made| made.capacities.slab_depth_m.is_none())
    };
    let columns = floors
        .beside_all_columns()
        .iter()
        .filter(|one| !one.is_slab() && !one.is_at_ground());
    // Below the floor at the head of the column, whose slab would reach down; or above the one at its foot, by its own slab.
    let apart = |one: &ColumnBeside| {
        let head = is_thin(one.above).then_some((1.0 - one.along) * one.height_m);
        let foot = (one.below.is_some() && is_thin(one.floor)).then_some(one.along * one.height_m);
        let nearest = head.into_iter().chain(foot).reduce(f64::min)?;
        Some((nearest, one.floor)).filter(|(nearest, _)| *nearest < THINNEST * (1.0 - 1e-9))
    };
    let Some((apart, floor)) = columns.filter_map(apart).max_by(|one, other| one.0.total_cmp(&other.0)) else {
        return;
    };
    doubts.unless(
        apart >= THINNEST,
        format!("structures[{}]", floors.all()[floor].structure),
        format!(
            "slabs without a depth, whose tops are up to {} mm from those of the neighbour, so that they hit columns",
            short(1e3 * apart)
        ),
        "a depth of 100 mm and more, by which they meet slabs: give slab_depth_m",
    );
}

/// Notes a compliant law so soft that collisions last as long as vibrations.
fn doubt_the_law(
    prepared: &Simulation,
    facing: FloorPair,
    contact: &Contact,
    lasted: &mut Option<(ContactLaw, FreePair, f64)>,
    doubts: &mut Doubts,
) {
    let (floors, index) = (prepared.floors(), facing.contact);
    let inverse = |floor: usize| floors.all()[floor].made_of.map_or(0.0, |made| 1.0 / made.mass_kg);
    let pair = FreePair {
        reduced_mass: reduced_mass(inverse(facing.left), inverse(facing.right)),
        approach_speed: Simulation::USUAL_APPROACH,
    };
    // Most contacts of a long row are equal.
    let known = lasted.filter(|(law, of, _)| (law, of) == (&contact.law, &pair));
    let duration = known.map_or_else(
        || FreeImpact::of(&contact.law, &pair).map_or(0.0, |free| free.force_duration),
        |(_, _, duration)| duration,
    );
    *lasted = Some((contact.law, pair, duration));
    doubts.unless_far(
        duration <= LONGEST,
        duration / LONGEST,
        format!("contacts[{index}].law.{}", contact.law.name()),
        format!("a collision at {} m/s that lasts {} s", Simulation::USUAL_APPROACH, short(duration)),
        "up to 0.25 s; its impact stiffness and damping decide it",
    );
}
