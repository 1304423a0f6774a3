//! Where a number stands in a row of buildings, as columns of tables with a line for each number.

use pounding_scene::{FloorPair, Floors, Scene};
use pounding_text::{Cell, Table};

/// Where a number stands: in a row as a whole, at a floor, or between two neighbours.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Site {
    building: Cell,
    floor: Cell,
    neighbour: Cell,
    neighbour_floor: Cell,
}

impl Site {
    /// A floor of a row, by its place.
    pub fn floor(scene: &Scene, floors: &Floors, floor: usize) -> Self {
        let structure = floors.all()[floor].structure;
        Self {
            building: scene.structures[structure].name().into(),
            floor: floors.storey_of(floor).into(),
            ..Self::default()
        }
    }

    /// Two floors that face each other, or a floor and a column.
    pub fn pair(scene: &Scene, floors: &Floors, facing: &FloorPair) -> Self {
        let [mut left, mut right] = [facing.left, facing.right].map(|floor| Self::floor(scene, floors, floor));
        if let Some(column) = floors.column_of(facing).filter(|column| !column.is_slab()) {
            let side = if floors.is_on_left(column) { &mut right } else { &mut left };
            side.floor = format!("column of storey {}", floors.storey_of(column.above)).into();
        }
        Self {
            neighbour: right.building,
            neighbour_floor: right.floor,
            ..left
        }
    }

    /// A structure and its right neighbour, by the place of the structure.
    pub fn gap(scene: &Scene, left: usize) -> Self {
        let [building, neighbour] = [left, left + 1].map(|index| scene.structures[index].name().into());
        Self {
            building,
            neighbour,
            ..Self::default()
        }
    }

    /// A table with the columns of a site.
    pub fn columns<'a, Row: 'a>(table: Table<'a, Row>, site: fn(&Row) -> &Self) -> Table<'a, Row> {
        table
            .column("building", move |row| site(row).building.clone())
            .column("floor", move |row| site(row).floor.clone())
            .column("neighbour", move |row| site(row).neighbour.clone())
            .column("neighbour_floor", move |row| site(row).neighbour_floor.clone())
    }
}

/// A number, and where it stands.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SitedNumber {
    /// Where it stands.
    pub site: Site,
    /// Its name, with its unit.
    pub quantity: String,
    /// Its value \[SI\].
    pub value: Option<f64>,
}

impl SitedNumber {
    /// A number at a site.
    pub fn at(site: &Site, quantity: impl Into<String>, value: impl Into<Option<f64>>) -> Self {
        Self {
            site: site.clone(),
            quantity: quantity.into(),
            value: value.into(),
        }
    }
}
