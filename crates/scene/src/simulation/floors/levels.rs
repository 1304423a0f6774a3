//! Levels of the floors and walls of a scene, and whether contacts let floors touch that face each other.

use pounding_solver::Levels;
use pounding_text::{Refused, digits};

use super::EQUAL_HEIGHTS;
use crate::{Contact, Scene, Structure};

/// Finds the levels of a scene whose structures were checked.
///
/// # Errors
/// [`Refused`] if heights are missing or contradict `floors`, or if a contact names levels at which nothing can touch.
pub(super) fn of(scene: &Scene) -> Result<Levels, Refused> {
    let elevations: Vec<_> = scene.structures.iter().map(elevations).collect();
    let known = Heights::of(scene, &elevations);
    if known == Heights::Counted {
        check_told(scene, &elevations)?;
    }
    let mut levels = levels_of(scene, &elevations, known);
    for (contact, one) in scene.contacts.iter().flatten().enumerate() {
        let facing = facing(scene, &levels, contact);
        match &one.levels {
            Some(chosen) if !facing.is_empty() => check_chosen(scene, contact, chosen, &facing)?,
            _ if known == Heights::Known && scene.floors.is_some() => check_level(scene, &elevations, contact)?,
            _ => {}
        }
    }
    for (wall, structure) in scene.structures.iter().enumerate() {
        if matches!(structure, Structure::Wall) {
            levels[wall] = levels_of_wall(scene, &levels, wall);
        }
    }
    Ok(Levels::at(&levels))
}

/// Refuses a building of several storeys beside another structure if nothing tells which of their floors face each other.
fn check_told(scene: &Scene, elevations: &[Option<Vec<f64>>]) -> Result<(), Refused> {
    let is_asked = scene.seeks_gaps || scene.contacts.is_some();
    if scene.floors.is_some() || !is_asked {
        return Ok(());
    }
    let has_storeys = |one: &Structure| matches!(one, Structure::Building(building) if building.storeys.len() > 1);
    let is_wall = |one: &Structure| matches!(one, Structure::Wall);
    let mut neighbours = scene.structures.windows(2);
    if !neighbours.any(|two| two.iter().any(has_storeys) && !two.iter().any(is_wall)) {
        return Ok(());
    }
    let unknown = |(one, heights): (&Structure, &Option<Vec<f64>>)| heights.is_none() && !is_wall(one);
    let mut all = scene.structures.iter().zip(elevations);
    let Some(index) = all.position(unknown) else {
        return Ok(());
    };
    let field = match &scene.structures[index] {
        Structure::Building(building) => {
            let without = building.storeys.iter().position(|one| one.height_m.is_none());
            format!("building.storeys[{}].height_m", without.unwrap_or(0))
        }
        Structure::Sdof(_) | Structure::Wall => "sdof.height_m".into(),
    };
    let found = Refused::at(format!("structures[{index}].{field}")).found("none, so that nothing tells which floors face floors");
    let found = found.allowed_is("the height of every storey of the row");
    Err(found.help(
        "or write floors = \"level\" in the scene if storeys of one number are at one height. A floor that faces a column can bring a building \
         down",
    ))
}

/// Whether a contact lets floors touch at a level, counted from 0.
pub(super) fn lets_touch(contact: &Contact, level: usize) -> bool {
    let levels = contact.levels.as_ref();
    levels.is_none_or(|levels| levels.contains(&(level + 1)))
}

/// How floors are assigned to levels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Heights {
    /// By height: all heights are given, and some structure has several storeys.
    Known,
    /// By number: storeys with the same number count as level.
    Counted,
}

impl Heights {
    fn of(scene: &Scene, elevations: &[Option<Vec<f64>>]) -> Self {
        let storeys = |one: &Structure| matches!(one, Structure::Building(_));
        let given = |(one, heights): (&Structure, &Option<Vec<f64>>)| heights.is_some() || matches!(one, Structure::Wall);
        let all = scene.structures.iter().zip(elevations).all(given);
        if all && scene.structures.iter().any(storeys) {
            Self::Known
        } else {
            Self::Counted
        }
    }
}

/// Heights of the floors of a structure above the ground \[m\]; `None` if some are unknown, and for a wall.
pub(super) fn elevations(structure: &Structure) -> Option<Vec<f64>> {
    match structure {
        Structure::Sdof(sdof) => sdof.height_m.map(|height| vec![height]),
        Structure::Building(building) => {
            let mut top = 0.0;
            let heights = building.storeys.iter().map(|storey| {
                // Without a height isolators have their base slab at the ground.
                let at_ground = || (storey.capacities.isolation_layer == Some(true)).then_some(0.0);
                top += storey.height_m.or_else(at_ground)?;
                Some(top)
            });
            heights.collect()
        }
        Structure::Wall => None,
    }
}

/// Levels, counted from 1, at which both neighbours of a contact have floors; beside a wall the levels of the other one. Empty between two
/// walls, which are refused elsewhere.
fn facing(scene: &Scene, levels: &[Vec<usize>], contact: usize) -> Vec<usize> {
    let is_wall = |one: usize| matches!(scene.structures[one], Structure::Wall);
    let [left, right] = [contact, contact + 1].map(|one| &levels[one]);
    let both: Vec<usize> = match (is_wall(contact), is_wall(contact + 1)) {
        (true, _) => right.clone(),
        (false, true) => left.clone(),
        (false, false) => {
            let shared = left.iter().filter(|level| right.contains(level));
            shared.copied().collect()
        }
    };
    both.into_iter().map(|level| level + 1).collect()
}

fn names(scene: &Scene, two: [usize; 2]) -> [String; 2] {
    two.map(|one| scene.structures[one].name().to_string())
}

/// Refuses levels at which no floor faces the neighbour.
fn check_chosen(scene: &Scene, contact: usize, chosen: &[usize], allowed: &[usize]) -> Result<(), Refused> {
    let [left, right] = names(scene, [contact, contact + 1]);
    let (facing, place) = (list(allowed), format!("contacts[{contact}].levels"));
    if chosen.is_empty() {
        let none = Refused::at(place).found("none");
        let allowed = format!("one or more of {facing}, at which floors of \"{left}\" and \"{right}\" face each other");
        return Err(none
            .allowed(allowed)
            .help("leave out `levels` for all of them; neighbours that never touch take a wide gap_m"));
    }
    match chosen.iter().position(|level| !allowed.contains(level)) {
        Some(index) => {
            let found = Refused::at(format!("{place}[{index}]")).found(chosen[index].to_string());
            let why = format!(
                "{facing}: the levels at which floors of \"{left}\" and \"{right}\" face each other, counted from 1 for the lowest"
            );
            Err(found.allowed(why).help("leave out `levels` for all of them"))
        }
        None => Ok(()),
    }
}

/// Writes counts as a list.
fn list(counts: &[usize]) -> String {
    let counts: Vec<_> = counts.iter().map(ToString::to_string).collect();
    counts.join(", ")
}

/// Refuses floors that face no floor of a neighbour, up to the lower of both roofs, though the scene says that floors are level.
fn check_level(scene: &Scene, elevations: &[Option<Vec<f64>>], contact: usize) -> Result<(), Refused> {
    let (Some(left), Some(right)) = (&elevations[contact], &elevations[contact + 1]) else {
        return Ok(());
    };
    let roof = |floors: &[f64]| floors.last().copied().unwrap_or(0.0);
    let lower = roof(left).min(roof(right)) + EQUAL_HEIGHTS;
    for (structure, own, others) in [(contact, left, right), (contact + 1, right, left)] {
        let faces = |height: &f64| {
            let mut others = others.iter();
            others.any(|other| (height - other).abs() <= EQUAL_HEIGHTS)
        };
        // What faces a base slab at the ground is the foot of its neighbour, no column.
        let mut below = own.iter().filter(|height| **height > 0.0 && **height <= lower);
        if let Some(height) = below.find(|height| !faces(height)) {
            let [own, other] = names(scene, [structure, 2 * contact + 1 - structure]);
            let heights: Vec<_> = others.iter().map(|height| digits(*height)).collect();
            let found = format!(
                "a floor of \"{own}\" at {} m, beside the columns of \"{other}\", whose floors are at {} m",
                digits(*height),
                heights.join(", ")
            );
            let found = Refused::at("floors").found(found);
            return Err(found
                .but("; allowed are ", "floors that face floors, up to the lower roof")
                .help("leave out `floors`: heights that are given decide themselves, and slabs then meet what stands at their height"));
        }
    }
    Ok(())
}

/// Levels of the floors of every structure, counted from 0. Those of walls follow from them.
fn levels_of(scene: &Scene, elevations: &[Option<Vec<f64>>], heights: Heights) -> Vec<Vec<usize>> {
    let mut all: Vec<f64> = elevations.iter().flatten().flatten().copied().collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|higher, lower| *higher - *lower <= EQUAL_HEIGHTS);
    let level = |height: &f64| all.partition_point(|other| *other < height - EQUAL_HEIGHTS);
    let own = |(structure, elevations): (&Structure, &Option<Vec<f64>>)| match (structure, elevations, heights) {
        (Structure::Wall, ..) => Vec::new(),
        (_, Some(elevations), Heights::Known) => elevations.iter().map(level).collect(),
        (Structure::Building(building), ..) => (0..building.storeys.len()).collect(),
        (Structure::Sdof(_), ..) => vec![0],
    };
    let structures = scene.structures.iter().zip(elevations);
    structures.map(own).collect()
}

/// A wall is at the level of every floor beside it that its contact lets touch it. A wall without such floors stands at the lowest level.
fn levels_of_wall(scene: &Scene, levels: &[Vec<usize>], wall: usize) -> Vec<usize> {
    let contacts = scene.contacts.as_deref().unwrap_or_default();
    // Contact i lies between structures i and i + 1.
    let sides = [wall.checked_sub(1).map(|left| (left, left)), Some((wall, wall + 1))];
    let mut faced = Vec::new();
    for (contact, neighbour) in sides.into_iter().flatten() {
        let Some(Structure::Sdof(_) | Structure::Building(_)) = scene.structures.get(neighbour) else {
            continue;
        };
        let contact = contacts.get(contact);
        let chosen = |level: &&usize| contact.is_none_or(|one| lets_touch(one, **level));
        faced.extend(levels[neighbour].iter().filter(chosen));
    }
    faced.sort_unstable();
    faced.dedup();
    if faced.is_empty() { vec![0] } else { faced }
}
