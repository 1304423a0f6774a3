//! Floors beside columns of their neighbours: slabs that stand at no floor of the other building.

use pounding_solver::Point;
use pounding_text::{Refused, digits};

use super::{EQUAL_HEIGHTS, Floor, FloorPair, Floors};
use crate::{ColumnShape, Contact};

/// A floor beside a column of its neighbour, or beside a slab of it at another height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColumnBeside {
    /// Index of the gap between both, from the left.
    pub gap: usize,
    /// Index of the floor in the row.
    pub floor: usize,
    /// Floor at the foot of the column; `None` if the column stands on the ground.
    pub below: Option<usize>,
    /// Floor at the head of the column, or the slab.
    pub above: usize,
    /// Position of the floor along the column \[–\], 0 at the foot; 1 beside a slab, which the floor then meets as a floor.
    pub along: f64,
    /// Shape of the column.
    pub shape: ColumnShape,
    /// Height of the storey with the column \[m\].
    pub height_m: f64,
}

impl ColumnBeside {
    /// Part of the head in the motion of the column beside the floor \[–\], 0 to 1.
    pub fn upper_part(&self) -> f64 {
        self.shape.upper_part(self.along)
    }

    /// Whether the floor meets a slab.
    pub fn is_slab(&self) -> bool {
        self.along >= 1.0
    }

    /// Whether the floor is a base slab at the ground, which faces the foot of its neighbour.
    pub fn is_at_ground(&self) -> bool {
        self.along <= 0.0
    }

    /// Largest shear force \[N\] and bending moment \[N·m\] in the column under 1 N from the floor; `None` beside a slab.
    pub fn forces(&self) -> Option<[f64; 2]> {
        (!self.is_slab()).then(|| self.shape.forces(self.height_m, self.along))
    }

    /// Stiffness of one column of the storey under a force from the floor \[N/m\], fixed at both ends: 3EI/(H³s³(1 − s)³), where a storey of n
    /// columns has k = 12nEI/H³. `None` if the scene does not count the columns, for a column between hinges, and beside a slab.
    pub fn bending_stiffness(&self, floors: &Floors) -> Option<f64> {
        let made_of = floors.all()[self.above].made_of?;
        let columns = f64::from(made_of.capacities.columns?);
        let arms = self.along * (1.0 - self.along);
        let bends = self.shape == ColumnShape::Fixed && !self.is_slab();
        bends.then(|| made_of.columns.stiffness_n_per_m / (4.0 * columns * arms * arms * arms))
    }
}

/// Whether a contact lets a floor touch, by the heights that it names.
pub(super) fn is_at_height(contact: &Contact, floor: &Floor) -> bool {
    let heights = contact.heights_m.as_ref();
    let is_named = |height: f64| heights.is_none_or(|all| all.iter().any(|one| (one - height).abs() <= EQUAL_HEIGHTS));
    floor.elevation_m.map_or(floor.is_wall() || heights.is_none(), is_named)
}

impl Floors {
    /// Floors beside columns, of every gap from the left, up to the lower roof of two neighbours with given heights.
    pub fn beside_all_columns(&self) -> &[ColumnBeside] {
        &self.beside
    }

    /// Refuses a height at which nothing can touch: a slab that is meant would go unseen.
    pub(super) fn check_heights(&self, contact: usize, one: &Contact, facing: &[FloorPair]) -> Result<(), Refused> {
        let slabs = |pair: &FloorPair| match pair.column {
            Some(column) => vec![self.beside[column].floor],
            None => vec![pair.left, pair.right],
        };
        let slabs: Vec<f64> = facing
            .iter()
            .flat_map(slabs)
            .filter_map(|floor| self.all[floor].elevation_m)
            .collect();
        let meets = |height: &f64| slabs.iter().any(|slab| (slab - height).abs() <= EQUAL_HEIGHTS);
        let heights = one.heights_m.iter().flatten().enumerate();
        let none = heights.clone().find(|(_, height)| !meets(height));
        let (index, found) = match (none, &one.heights_m) {
            (Some((index, height)), _) => (format!("[{index}]"), digits(*height)),
            (None, Some(heights)) if heights.is_empty() => (String::new(), "none".into()),
            (None, _) => return Ok(()),
        };
        let found = Refused::at(format!("contacts[{contact}].heights_m{index}")).found(found);
        let found = found.allowed_are("heights of slabs up to the lower roof, to a millimetre");
        Err(found.help("leave out `heights_m` for all of them"))
    }

    /// Whether the floor is on the left of the column.
    pub fn is_on_left(&self, column: &ColumnBeside) -> bool {
        self.all[column.floor].structure == column.gap
    }

    /// The points that meet, from the left.
    ///
    /// # Panics
    /// Never: the foot of a column is left out where it stands on the ground.
    pub(super) fn sides(&self, column: &ColumnBeside) -> [Point; 2] {
        let floor = Point::Floor(column.floor);
        let beside = Point::between(column.below, column.above, column.upper_part());
        let beside = beside.expect("a floor above the ground faces no ground");
        if self.is_on_left(column) {
            [floor, beside]
        } else {
            [beside, floor]
        }
    }

    /// Name of the column for tables: its building and the number of its storey.
    pub fn column_name(&self, column: &ColumnBeside) -> String {
        let above = &self.all[column.above];
        let building = &self.structures[above.structure];
        match above.storey {
            Some(storey) => format!("{building}, column of storey {storey}"),
            None => format!("{building}, column"),
        }
    }

    /// Floors on both sides of a gap that are level with no floor of the other side.
    pub(super) fn beside_columns(&self, gap: usize, shape: ColumnShape) -> Vec<ColumnBeside> {
        let of = |own, other| self.beside_columns_of(gap, [own, other], shape);
        let mut all = [of(gap, gap + 1), of(gap + 1, gap)].concat();
        // In a row of single masses two of them meet at any heights.
        let facing: Vec<_> = self.levels.facing(gap).collect();
        all.retain(|one| !facing.iter().any(|(left, right)| [*left, *right].contains(&one.floor)));
        all
    }

    fn beside_columns_of(&self, gap: usize, [own, other]: [usize; 2], shape: ColumnShape) -> Vec<ColumnBeside> {
        let (Some(heights), Some(others)) = (self.heights_of(own), self.heights_of(other)) else {
            return Vec::new();
        };
        let floors = self.of_structure(other);
        let beside = |(floor, height): (&usize, &f64)| {
            let is_level = |one: &f64| (one - height).abs() <= EQUAL_HEIGHTS;
            if others.iter().any(is_level) {
                return None;
            }
            let meets = floors.iter().position(|one| self.overlap(*floor, *one));
            // Of two slabs that overlap the lower one is the floor.
            let slab = meets.filter(|slab| others[*slab] > *height);
            let next = slab.or_else(|| others.iter().position(|one| one > height).filter(|_| meets.is_none()))?;
            let foot = next.checked_sub(1);
            let low = foot.map_or(0.0, |foot| others[foot]);
            let storey = others[next] - low;
            Some(ColumnBeside {
                gap,
                floor: *floor,
                below: foot.map(|foot| floors[foot]),
                above: floors[next],
                along: if slab.is_some() { 1.0 } else { (height - low) / storey },
                shape,
                height_m: storey,
            })
        };
        let own = self.of_structure(own).iter().zip(&heights);
        own.filter_map(beside).collect()
    }

    /// Whether the depths of two slabs overlap.
    fn overlap(&self, one: usize, other: usize) -> bool {
        let [one, other] = [one, other].map(|floor| {
            let floor = &self.all[floor];
            let top = floor.elevation_m?;
            Some([top - floor.made_of?.capacities.slab_depth_m?, top])
        });
        one.zip(other).is_some_and(|(one, other)| one[0] < other[1] && other[0] < one[1])
    }
}
