//! The floors of a scene: names of the nodes of its row, and which floors face each other.

mod beside;
mod gravity;
mod levels;
mod unwatched;

use pounding_solver::{Levels, Point};
use pounding_text::{Refused, percent};

pub use beside::ColumnBeside;
use levels::elevations;
pub use unwatched::UnwatchedFloor;

use crate::{Capacities, ColumnShape, Columns, Contact, Error, Property, Scene, Sdof, Structure};

/// Largest difference between heights of floors that count as equal \[m\].
pub(crate) const EQUAL_HEIGHTS: f64 = 1e-3;

/// Sentence for a scene in which nothing can touch.
const NO_CONTACT: &str = "no contact is modelled, so that nothing is said about pounding";

/// The floors and walls of a scene in the order of its row: those of the lowest level from left to right, then those of the next level, and
/// so on. A row of structures of one storey has one floor for each structure.
#[derive(Debug, Clone, PartialEq)]
pub struct Floors {
    /// Names of the structures.
    structures: Vec<String>,
    levels: Levels,
    all: Vec<Floor>,
    facing: Vec<FloorPair>,
    /// Floors beside columns of their neighbours, gap by gap from the left.
    beside: Vec<ColumnBeside>,
    /// Whether the scene says that storeys of one number are level.
    told_level: bool,
    /// Owners of the ground at every contact.
    properties: Vec<Property>,
    /// Whether they are decks of a bridge.
    bridge: bool,
}

/// A floor of a building, the only floor of a structure of one storey, or a wall at the level of a floor.
#[derive(Debug, Clone, PartialEq)]
pub struct Floor {
    /// Index of its structure, from the left.
    pub structure: usize,
    /// Storey below it, counted from 1; `None` for a structure of one storey and for a wall.
    pub storey: Option<usize>,
    /// Name for tables: the structure and the number of the floor, or the level of a wall that faces several floors. Drifts and forces of
    /// columns belong to its storey ([`Floors::storey_name`]).
    pub name: String,
    /// Height above the ground \[m\], where it is known.
    pub elevation_m: Option<f64>,
    /// Mass and columns; `None` for a wall.
    pub made_of: Option<StoreyProperties>,
}

/// Properties of a floor and the storey below it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StoreyProperties {
    /// Mass of the floor \[kg\].
    pub mass_kg: f64,
    /// Columns of the storey.
    pub columns: Columns,
    /// Height of the storey \[m\], where it is known.
    pub height_m: Option<f64>,
    /// What the scene says of the limits of the storey.
    pub capacities: Capacities,
    /// Weight above over the height of the storey, P/h \[N/m\]; 0 if gravity does not act.
    pub gravity_n_per_m: f64,
    /// Displacement of the floor at t = 0 \[m\].
    pub initial_displacement_m: f64,
    /// Velocity of the floor at t = 0 \[m/s\].
    pub initial_velocity_m_per_s: f64,
}

/// Two floors that can touch, or a floor and a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FloorPair {
    /// Index of the contact of the scene.
    pub contact: usize,
    /// Index of the left floor; of a column the floor that it follows most.
    pub left: usize,
    /// Index of the right floor; of a column the floor that it follows most.
    pub right: usize,
    /// Index in [`Floors::beside_all_columns`] if one of both is a column.
    pub column: Option<usize>,
}

impl Floor {
    /// Whether it is a wall.
    pub fn is_wall(&self) -> bool {
        self.made_of.is_none()
    }

    /// Whether its storey stands on another floor.
    pub fn is_upper(&self) -> bool {
        self.storey.is_some_and(|storey| storey > 1)
    }

    /// Natural period \[s\] and damping ratio of its structure; for a building those of the first mode, for a wall `None`.
    pub fn oscillation(&self, scene: &Scene) -> Option<(f64, f64)> {
        let structure = &scene.structures[self.structure];
        structure.period().zip(structure.damping_ratio())
    }

    /// Whether its columns can yield.
    pub fn can_yield(&self) -> bool {
        let force = |made: StoreyProperties| made.columns.yield_force_n;
        self.made_of.and_then(force).is_some()
    }

    /// Whether its storey is told to stand for isolators.
    pub fn is_isolation_layer(&self) -> bool {
        self.made_of.is_some_and(|made| made.capacities.isolation_layer == Some(true))
    }

    /// Ductility demand \[–\] of a drift \[m\]; `None` for columns that stay elastic.
    pub fn ductility(&self, drift: f64) -> Option<f64> {
        let columns = self.made_of?.columns;
        let yield_force = columns.yield_force_n?;
        Some(drift.abs() * columns.stiffness_n_per_m / yield_force)
    }

    /// Ratio of a drift to the height of the storey \[–\]; `None` if the height is unknown.
    pub fn drift_ratio(&self, drift: f64) -> Option<f64> {
        Some(drift.abs() / self.made_of?.height_m?)
    }
}

impl StoreyProperties {
    fn of(scene: &Scene, sdof: &Sdof) -> Self {
        let own = gravity::weight(scene, sdof.mass_kg, &sdof.capacities);
        Self {
            gravity_n_per_m: gravity::over(own, sdof.height_m),
            mass_kg: sdof.mass_kg,
            columns: sdof.columns(),
            height_m: sdof.height_m,
            capacities: sdof.capacities,
            initial_displacement_m: sdof.initial_displacement_m,
            initial_velocity_m_per_s: sdof.initial_velocity_m_per_s,
        }
    }
}

impl Floors {
    /// Finds the floors of a scene whose structures were checked.
    ///
    /// # Errors
    /// [`Refused`] if a floor would hit the columns of a neighbour, or if a contact names levels at which nothing can touch.
    pub fn of(scene: &Scene) -> Result<Self, Refused> {
        let levels = levels::of(scene)?;
        gravity::check(scene)?;
        let contacts = scene.contacts.as_deref().unwrap_or_default();
        let mut floors = Self {
            structures: scene.structures.iter().map(|one| one.name().into()).collect(),
            all: (0..levels.n_nodes()).map(|node| floor(scene, &levels, node)).collect(),
            facing: Vec::new(),
            beside: Vec::new(),
            levels,
            told_level: scene.floors.is_some(),
            properties: contacts.iter().map(|one| one.property).collect(),
            bridge: scene.is_bridge(),
        };
        for gap in 1..floors.structures.len() {
            let contact = contacts.get(gap - 1);
            let shape = contact.map_or_else(ColumnShape::default, |one| one.column_shape);
            let beside = floors.beside_columns(gap - 1, shape);
            floors.beside.extend(beside);
        }
        for (contact, one) in contacts.iter().enumerate() {
            let facing = floors.facing_in(contact, one);
            floors.check_heights(contact, one, &facing)?;
            floors.facing.extend(facing);
        }
        floors.facing.sort_by_key(|one: &FloorPair| one.left);
        Ok(floors)
    }

    /// What a contact lets touch: floors at one level, and floors and columns.
    fn facing_in(&self, contact: usize, one: &Contact) -> Vec<FloorPair> {
        let lets_touch = |floor: usize| levels::lets_touch(one, self.levels.level(floor)) && beside::is_at_height(one, &self.all[floor]);
        let level = self
            .levels
            .facing(contact)
            .filter(|(left, right)| lets_touch(*left) && lets_touch(*right));
        let level = level.map(|(left, right)| FloorPair {
            contact,
            left,
            right,
            column: None,
        });
        let columns = self.beside.iter().enumerate();
        let columns = columns.filter(|(_, column)| column.gap == contact && !column.is_at_ground());
        let columns = columns.filter(|(_, column)| one.levels.is_none() && beside::is_at_height(one, &self.all[column.floor]));
        let columns = columns.map(|(index, column)| {
            let [left, right] = self.sides(column).map(Point::floor);
            FloorPair {
                contact,
                left,
                right,
                column: Some(index),
            }
        });
        level.chain(columns).collect()
    }

    /// Checks that a row can be modelled, whatever shakes it.
    ///
    /// # Errors
    /// Refuses its first field that cannot be used, and what [`Self::of`] refuses.
    pub fn check(scene: &Scene) -> Result<(), Error> {
        let floors = scene.check().and_then(|()| Self::of(scene));
        floors.map(|_| ()).map_err(|refused| Error::in_scene(&scene.name, refused))
    }

    /// Takes other numbers for a row of structures of one storey and walls.
    ///
    /// # Errors
    /// [`Refused`] if a weight would bring a structure down.
    pub(crate) fn renumber(&mut self, scene: &Scene) -> Result<(), Refused> {
        gravity::check(scene)?;
        for floor in &mut self.all {
            if let Structure::Sdof(sdof) = &scene.structures[floor.structure] {
                floor.elevation_m = sdof.height_m;
                floor.made_of = Some(StoreyProperties::of(scene, sdof));
            }
        }
        Ok(())
    }

    /// Every floor, in the order of the row.
    pub fn all(&self) -> &[Floor] {
        &self.all
    }

    /// Names of the structures, from the left.
    pub fn structures(&self) -> &[String] {
        &self.structures
    }

    /// Indices of the floors of a structure, from the ground up.
    pub fn of_structure(&self, structure: usize) -> &[usize] {
        self.levels.of(structure)
    }

    /// Whether a structure is told to stand on isolators.
    pub fn is_isolated(&self, structure: usize) -> bool {
        let mut own = self.of_structure(structure).iter();
        own.any(|floor| self.all[*floor].is_isolation_layer())
    }

    /// Whether they are decks of a bridge, by seats or restrainers: limits for the storeys of buildings do not hold.
    pub fn is_bridge(&self) -> bool {
        self.bridge
    }

    /// Whether gravity acts on some leaning storey.
    pub fn has_gravity(&self) -> bool {
        self.all
            .iter()
            .any(|one| one.made_of.is_some_and(|made| made.gravity_n_per_m > 0.0))
    }

    /// Says on how many storeys gravity acts, and the largest part of their stiffness that it takes; `None` if it acts on none.
    pub fn says_gravity(&self) -> Option<String> {
        let made = self.all.iter().filter_map(|one| one.made_of);
        let parts = made.map(|made| made.gravity_n_per_m / made.columns.stiffness_n_per_m);
        let parts: Vec<f64> = parts.filter(|part| *part > 0.0).collect();
        let largest = parts.iter().copied().reduce(f64::max)?;
        let s = if parts.len() == 1 { "" } else { "s" };
        Some(format!(
            "P-Δ on {} storey{s}, up to {} of the stiffness of the columns",
            parts.len(),
            percent(largest)
        ))
    }

    /// Indices of every floor, structure by structure from the left, each from the ground up.
    pub fn by_structure(&self) -> impl Iterator<Item = usize> {
        (0..self.structures.len()).flat_map(|structure| self.levels.of(structure).iter().copied())
    }

    /// Number of the storey below a floor, from 1; for a wall the number of its level.
    pub fn storey_of(&self, floor: usize) -> usize {
        let Floor { storey, .. } = self.all[floor];
        if self.all[floor].is_wall() {
            self.levels.level(floor) + 1
        } else {
            storey.unwrap_or(1)
        }
    }

    /// Name of the storey below a floor: the building and the number of the storey; of a structure of one storey and a wall its own.
    pub fn storey_name(&self, floor: usize) -> String {
        let one = &self.all[floor];
        let building = &self.structures[one.structure];
        one.storey
            .map_or_else(|| one.name.clone(), |storey| format!("{building}, storey {storey}"))
    }

    /// Floor below in the same building; `None` for a floor on the ground storey.
    pub fn below(&self, floor: usize) -> Option<usize> {
        let (structure, storey) = self.levels.place(floor);
        let lower = storey.checked_sub(1)?;
        (!self.all[floor].is_wall()).then(|| self.levels.of(structure)[lower])
    }

    /// Sentence for a scene without contacts; `None` if it has one.
    pub fn says_no_contact(&self) -> Option<&'static str> {
        (self.facing.is_empty()).then_some(NO_CONTACT)
    }

    /// Floors that can touch, in the order of the row's pairs.
    pub fn facing(&self) -> &[FloorPair] {
        &self.facing
    }

    /// The points of a pair, from the left.
    pub fn points(&self, pair: &FloorPair) -> [Point; 2] {
        match pair.column {
            None => [pair.left, pair.right].map(Point::Floor),
            Some(column) => self.sides(&self.beside[column]),
        }
    }

    /// Whether another pair acts on a floor of this pair from the same side, so that the floor does not tell the force of the pair.
    pub fn shares_floors(&self, pair: usize) -> bool {
        let own = self.points(&self.facing[pair]);
        let shares = |other: &FloorPair| {
            let sides = self.points(other).into_iter().zip(own);
            let mut sides =
                sides.flat_map(|(other, own)| other.parts().flat_map(move |(floor, _)| own.parts().map(move |one| one.0 == floor)));
            sides.any(|same| same)
        };
        let others = self.facing.iter().enumerate().filter(|(index, _)| *index != pair);
        self.facing[pair].column.is_some() || (!self.beside.is_empty() && others.map(|(_, other)| other).any(shares))
    }

    /// The column of a pair; `None` if both are floors.
    pub fn column_of(&self, pair: &FloorPair) -> Option<&ColumnBeside> {
        self.beside.get(pair.column?)
    }

    /// Whether both sides of a gap stand on one property; without contacts they do not.
    pub fn property(&self, gap: usize) -> Property {
        self.properties.get(gap).copied().unwrap_or_default()
    }

    /// Indices of the pairs, contact by contact from the left, each from the ground up.
    pub fn pairs_by_contact(&self) -> Vec<usize> {
        let mut pairs: Vec<usize> = (0..self.facing.len()).collect();
        pairs.sort_by_key(|pair| self.facing[*pair].contact);
        pairs
    }

    /// Names of the left and the right floor of a pair.
    pub fn names(&self, pair: usize) -> [String; 2] {
        self.names_of(&self.facing[pair])
    }

    /// Names of the left and the right side of a pair: a floor, or the columns of a storey.
    pub fn names_of(&self, pair: &FloorPair) -> [String; 2] {
        let mut names = [pair.left, pair.right].map(|floor| self.all[floor].name.clone());
        if let Some(column) = self.column_of(pair).filter(|column| !column.is_slab()) {
            let side = usize::from(self.is_on_left(column));
            names[side] = self.column_name(column);
        }
        names
    }

    /// Names of a pair with a seat: what the seat belongs to, and the deck on it, which is no wall.
    pub fn of_seat(&self, pair: usize) -> [String; 2] {
        let [left, right] = self.names(pair);
        if self.all[self.facing[pair].right].is_wall() {
            [right, left]
        } else {
            [left, right]
        }
    }

    /// Returns the same floors without any contact.
    pub(crate) fn apart(&self) -> Self {
        Self {
            facing: Vec::new(),
            ..self.clone()
        }
    }

    /// All floors that face each other, with or without a contact: index of the left structure, left floor and right floor.
    pub fn all_facing(&self) -> Vec<(usize, usize, usize)> {
        let facing = |left: usize| {
            let facing = self.levels.facing(left);
            facing.map(move |(one, other)| (left, one, other))
        };
        let mut all: Vec<_> = (1..self.structures.len()).flat_map(|right| facing(right - 1)).collect();
        all.sort_unstable_by_key(|one| one.1);
        all
    }

    /// Levels of the floors in the row.
    pub fn levels(&self) -> &Levels {
        &self.levels
    }
}

fn floor(scene: &Scene, levels: &Levels, node: usize) -> Floor {
    let (index, storey) = levels.place(node);
    let structure = &scene.structures[index];
    let name = structure.name().to_string();
    match structure {
        Structure::Sdof(sdof) => Floor {
            structure: index,
            storey: None,
            name,
            elevation_m: sdof.height_m,
            made_of: Some(StoreyProperties::of(scene, sdof)),
        },
        Structure::Building(building) => {
            let one = &building.storeys[storey];
            let above = building.storeys[storey..].iter();
            let above = above.map(|one| gravity::weight(scene, one.mass_kg, &one.capacities)).sum();
            Floor {
                structure: index,
                storey: Some(storey + 1),
                name: format!("{name}, floor {}", storey + 1),
                elevation_m: elevations(structure).map(|heights| heights[storey]),
                made_of: Some(StoreyProperties {
                    mass_kg: one.mass_kg,
                    columns: one.columns,
                    height_m: one.height_m,
                    capacities: one.capacities,
                    gravity_n_per_m: gravity::over(above, one.height_m),
                    initial_displacement_m: one.initial_displacement_m,
                    initial_velocity_m_per_s: one.initial_velocity_m_per_s,
                }),
            }
        }
        Structure::Wall => Floor {
            structure: index,
            storey: None,
            name: match levels.of(index) {
                [_] => name,
                _ => format!("{name}, level {}", levels.level(node) + 1),
            },
            elevation_m: None,
            made_of: None,
        },
    }
}
