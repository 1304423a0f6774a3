//! The floors of a scene: what the nodes of its row are called, and which of them face each other.

use pounding_solver::Levels;

use crate::{Columns, Scene, SceneError, Structure};

/// Heights of floors that differ by no more are equal \[m\].
pub(crate) const EQUAL_HEIGHTS: f64 = 1e-3;

/// The floors and walls of a scene, as its row numbers them: those of the lowest level from left to right, then those of
/// the next, and so on. In a row of structures of one storey they are the structures.
#[derive(Debug, Clone, PartialEq)]
pub struct Floors {
    n_structures: usize,
    levels: Levels,
    all: Vec<Floor>,
    facing: Vec<Facing>,
}

/// A floor of a building, the only one of a structure of one storey, or a wall where it faces a floor.
#[derive(Debug, Clone, PartialEq)]
pub struct Floor {
    /// Index of its structure, from the left.
    pub structure: usize,
    /// Storey below it, counted from 1; nothing for a structure of one storey and a wall.
    pub storey: Option<usize>,
    /// Name for tables: that of the structure, and the storey.
    pub name: String,
    /// Height above the ground \[m\], where it is known.
    pub elevation_m: Option<f64>,
    /// What it is made of; nothing of a wall.
    pub made_of: Option<Made>,
}

/// What a floor and the storey below it are made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Made {
    /// Mass of the floor \[kg\].
    pub mass_kg: f64,
    /// Columns of the storey.
    pub columns: Columns,
    /// Height of the storey \[m\], where it is known.
    pub height_m: Option<f64>,
    /// Displacement and velocity of the floor at t = 0 \[m\], \[m/s\].
    pub initial: (f64, f64),
}

/// Two floors that can touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Facing {
    /// Index of the contact of the scene.
    pub contact: usize,
    /// Index of the left floor.
    pub left: usize,
    /// Index of the right floor.
    pub right: usize,
}

impl Floor {
    /// Whether it is a wall.
    pub fn is_wall(&self) -> bool {
        self.made_of.is_none()
    }

    /// Natural period \[s\] and damping ratio of its structure, of a building in the first mode; nothing of a wall.
    pub fn oscillation(&self, scene: &Scene) -> Option<(f64, f64)> {
        let structure = &scene.structures[self.structure];
        structure.period().zip(structure.damping_ratio())
    }

    /// Whether its columns can yield.
    pub fn can_yield(&self) -> bool {
        let force = |made: Made| made.columns.yield_force_n;
        self.made_of.and_then(force).is_some()
    }

    /// Ductility demand \[–\] of a drift \[m\], of columns that can yield.
    pub fn ductility(&self, drift: f64) -> Option<f64> {
        let columns = self.made_of?.columns;
        let yield_force = columns.yield_force_n?;
        Some(drift.abs() * columns.stiffness_n_per_m / yield_force)
    }

    /// Part of the height of the storey that a drift is \[–\], where the height is known.
    pub fn drift_ratio(&self, drift: f64) -> Option<f64> {
        Some(drift.abs() / self.made_of?.height_m?)
    }
}

impl Floors {
    /// Of a scene whose structures were checked.
    ///
    /// # Errors
    /// [`SceneError::LevelsDiffer`] where a floor would hit the columns of a neighbour.
    pub(crate) fn of(scene: &Scene) -> Result<Self, SceneError> {
        let elevations: Vec<_> = scene.structures.iter().map(elevations).collect();
        let known = Heights::of(scene, &elevations);
        if known == Heights::Known {
            check_levels(scene, &elevations)?;
        }
        let levels = Levels::at(&levels_of(scene, &elevations, known));
        let floor = |node: usize| {
            let (structure, storey) = levels.place(node);
            floor(&scene.structures[structure], (structure, storey))
        };
        let contacts = scene.contacts.iter().flatten().enumerate();
        let mut facing = Vec::new();
        for (contact, one) in contacts {
            let chosen = |node: &(usize, usize)| {
                let level = levels.level(node.0) + 1;
                one.levels
                    .as_ref()
                    .is_none_or(|levels| levels.contains(&level))
            };
            let at_levels = levels.facing(contact).filter(chosen);
            facing.extend(at_levels.map(|(left, right)| Facing {
                contact,
                left,
                right,
            }));
        }
        facing.sort_by_key(|one: &Facing| one.left);
        Ok(Self {
            n_structures: scene.structures.len(),
            all: (0..levels.n_nodes()).map(floor).collect(),
            facing,
            levels,
        })
    }

    /// All of them, in the order of the row.
    pub fn all(&self) -> &[Floor] {
        &self.all
    }

    /// The floors of a structure, from the ground up, by their places in the row.
    pub fn of_structure(&self, structure: usize) -> &[usize] {
        self.levels.of(structure)
    }

    /// All of them, structure by structure from the left, each from the ground up, by their places in the row.
    pub fn by_structure(&self) -> impl Iterator<Item = usize> {
        (0..self.n_structures).flat_map(|structure| self.levels.of(structure).iter().copied())
    }

    /// Number of the storey below a floor, from 1; of a wall that of the level at which it stands.
    pub(crate) fn level_of(&self, floor: usize) -> String {
        let storey = self.all[floor].storey;
        let level = if self.all[floor].is_wall() {
            self.levels.level(floor) + 1
        } else {
            storey.unwrap_or(1)
        };
        level.to_string()
    }

    /// The floor below, in the same building; nothing for one that stands on the ground.
    pub fn below(&self, floor: usize) -> Option<usize> {
        let (structure, storey) = self.levels.place(floor);
        let lower = storey.checked_sub(1)?;
        (!self.all[floor].is_wall()).then(|| self.levels.of(structure)[lower])
    }

    /// Floors that can touch, in the order of the row's pairs.
    pub fn facing(&self) -> &[Facing] {
        &self.facing
    }

    /// Names of the left and the right floor of a pair.
    pub fn names(&self, pair: usize) -> [String; 2] {
        let Facing { left, right, .. } = self.facing[pair];
        [left, right].map(|floor| self.all[floor].name.clone())
    }

    /// Floors that need a gap between them: those that contacts let touch, or all that face each other where a scene has no
    /// contacts; index of the left structure, left and right floor.
    pub(crate) fn neighbours(&self) -> Vec<(usize, usize, usize)> {
        if self.facing.is_empty() {
            return self.all_facing();
        }
        let facing = self.facing.iter();
        facing
            .map(|one| (one.contact, one.left, one.right))
            .collect()
    }

    /// The same floors, none of which can touch another.
    pub(crate) fn apart(&self) -> Self {
        Self {
            facing: Vec::new(),
            ..self.clone()
        }
    }

    /// Pairs of all floors that face each other, contacts or not: index of the left structure, left and right floor.
    pub(crate) fn all_facing(&self) -> Vec<(usize, usize, usize)> {
        let facing = |left: usize| {
            let facing = self.levels.facing(left);
            facing.map(move |(one, other)| (left, one, other))
        };
        let mut all: Vec<_> = (1..self.n_structures)
            .flat_map(|right| facing(right - 1))
            .collect();
        all.sort_unstable_by_key(|one| one.1);
        all
    }

    /// How floors stand in the row.
    pub(crate) fn levels(&self) -> &Levels {
        &self.levels
    }
}

/// Whether floors are told apart by their heights or counted from the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Heights {
    /// All heights are given, and some structure has several storeys.
    Known,
    /// Storeys of one number are taken to be level.
    Counted,
}

impl Heights {
    fn of(scene: &Scene, elevations: &[Option<Vec<f64>>]) -> Self {
        let storeys = |one: &Structure| matches!(one, Structure::Building(_));
        let given = |(one, heights): (&Structure, &Option<Vec<f64>>)| {
            heights.is_some() || matches!(one, Structure::Wall)
        };
        let all = scene.structures.iter().zip(elevations).all(given);
        if all && scene.structures.iter().any(storeys) {
            Self::Known
        } else {
            Self::Counted
        }
    }
}

/// Heights of the floors of a structure above the ground \[m\], where all are known; nothing for a wall.
fn elevations(structure: &Structure) -> Option<Vec<f64>> {
    match structure {
        Structure::Sdof(sdof) => sdof.height_m.map(|height| vec![height]),
        Structure::Building(building) => {
            let mut top = 0.0;
            let heights = building.storeys.iter().map(|storey| {
                top += storey.height_m?;
                Some(top)
            });
            heights.collect()
        }
        Structure::Wall => None,
    }
}

/// Refuses floors that face no floor of a neighbour, up to the lower roof of the two.
fn check_levels(scene: &Scene, elevations: &[Option<Vec<f64>>]) -> Result<(), SceneError> {
    let n_contacts = scene.contacts.as_ref().map_or(0, Vec::len);
    for contact in 0..n_contacts {
        let (Some(left), Some(right)) = (&elevations[contact], &elevations[contact + 1]) else {
            continue;
        };
        let roof = |floors: &[f64]| floors.last().copied().unwrap_or(0.0);
        let lower = roof(left).min(roof(right)) + EQUAL_HEIGHTS;
        for (structure, own, others) in [(contact, left, right), (contact + 1, right, left)] {
            let faces = |height: &f64| {
                others
                    .iter()
                    .any(|other| (height - other).abs() <= EQUAL_HEIGHTS)
            };
            let below = own.iter().filter(|height| **height <= lower);
            if let Some(height) = below.clone().find(|height| !faces(height)) {
                return Err(SceneError::LevelsDiffer {
                    contact,
                    floor: scene.structures[structure].name().into(),
                    height: *height,
                    neighbour: scene.structures[2 * contact + 1 - structure].name().into(),
                    others: others.clone(),
                });
            }
        }
    }
    Ok(())
}

/// Levels of the floors of every structure.
fn levels_of(scene: &Scene, elevations: &[Option<Vec<f64>>], heights: Heights) -> Vec<Vec<usize>> {
    let mut all: Vec<f64> = elevations.iter().flatten().flatten().copied().collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|higher, lower| *higher - *lower <= EQUAL_HEIGHTS);
    let level = |height: &f64| all.partition_point(|other| *other < height - EQUAL_HEIGHTS);
    let own = |(structure, elevations): (&Structure, &Option<Vec<f64>>)| match (
        structure, elevations, heights,
    ) {
        (Structure::Wall, ..) => Vec::new(),
        (_, Some(elevations), Heights::Known) => elevations.iter().map(level).collect(),
        (Structure::Building(building), ..) => (0..building.storeys.len()).collect(),
        (Structure::Sdof(_), ..) => vec![0],
    };
    let structures = scene.structures.iter().zip(elevations);
    let mut levels: Vec<Vec<usize>> = structures.map(own).collect();
    for (wall, structure) in scene.structures.iter().enumerate() {
        if matches!(structure, Structure::Wall) {
            levels[wall] = levels_of_wall(scene, &levels, wall);
        }
    }
    levels
}

/// A wall faces every floor beside it, but those that its contact does not let it touch; one that faces none stands on the
/// ground.
fn levels_of_wall(scene: &Scene, levels: &[Vec<usize>], wall: usize) -> Vec<usize> {
    let contacts = scene.contacts.as_deref().unwrap_or_default();
    // Contact i lies between structures i and i + 1.
    let sides = [
        wall.checked_sub(1).map(|left| (left, left)),
        Some((wall, wall + 1)),
    ];
    let mut faced = Vec::new();
    for (contact, neighbour) in sides.into_iter().flatten() {
        let Some(Structure::Sdof(_) | Structure::Building(_)) = scene.structures.get(neighbour)
        else {
            continue;
        };
        let levels_of_contact = contacts.get(contact).and_then(|one| one.levels.as_ref());
        let chosen =
            |level: &&usize| levels_of_contact.is_none_or(|chosen| chosen.contains(&(**level + 1)));
        faced.extend(levels[neighbour].iter().filter(chosen));
    }
    faced.sort_unstable();
    faced.dedup();
    if faced.is_empty() { vec![0] } else { faced }
}

fn floor(structure: &Structure, (index, storey): (usize, usize)) -> Floor {
    let name = structure.name().to_string();
    match structure {
        Structure::Sdof(sdof) => Floor {
            structure: index,
            storey: None,
            name,
            elevation_m: sdof.height_m,
            made_of: Some(Made {
                mass_kg: sdof.mass_kg,
                columns: sdof.columns(),
                height_m: sdof.height_m,
                initial: (sdof.initial_displacement_m, sdof.initial_velocity_m_per_s),
            }),
        },
        Structure::Building(building) => {
            let one = &building.storeys[storey];
            Floor {
                structure: index,
                storey: Some(storey + 1),
                name: format!("{name} {}", storey + 1),
                elevation_m: elevations(structure).map(|heights| heights[storey]),
                made_of: Some(Made {
                    mass_kg: one.mass_kg,
                    columns: one.columns,
                    height_m: one.height_m,
                    initial: (one.initial_displacement_m, one.initial_velocity_m_per_s),
                }),
            }
        }
        Structure::Wall => Floor {
            structure: index,
            storey: None,
            name,
            elevation_m: None,
            made_of: None,
        },
    }
}
