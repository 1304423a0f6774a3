//! Floors whose touches no contact models: floors beside columns of a neighbour, and levels that `levels` leaves out.

use super::{ColumnBeside, Floors};

/// What a floor faces if no contact models their touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum UnwatchedFloor {
    /// A column of the neighbour, by its index in [`Floors::beside_all_columns`].
    Column(usize),
    /// The floor of the same level.
    Level {
        /// Index of the gap between both, from the left.
        gap: usize,
        /// Left and right floor.
        floors: [usize; 2],
    },
}

impl UnwatchedFloor {
    /// Whether it faces a floor instead of a column.
    pub fn is_level(&self) -> bool {
        matches!(self, Self::Level { .. })
    }
}

impl Floors {
    /// Finds floors beside columns, up to the lower roof of two neighbours with given heights, and floors of levels, that no contact lets
    /// touch. A wall stands only at the levels of its contact.
    pub fn unwatched(&self) -> Vec<UnwatchedFloor> {
        let gaps = 0..self.structures.len().saturating_sub(1);
        gaps.flat_map(|gap| self.unwatched_in(gap)).collect()
    }

    fn unwatched_in(&self, gap: usize) -> Vec<UnwatchedFloor> {
        let columns = (0..self.beside.len()).filter(|column| self.beside[*column].gap == gap);
        let columns = columns.filter(|column| !self.facing.iter().any(|pair| pair.column == Some(*column)));
        let moves = |floor: usize| !self.all[floor].is_wall();
        let is_watched = |left: usize, right: usize| {
            let mut facing = self.facing.iter();
            self.facing.is_empty() || facing.any(|one| one.column.is_none() && [one.left, one.right] == [left, right])
        };
        let left_out = self.levels.facing(gap);
        let left_out = left_out.filter(|(left, right)| moves(*left) && moves(*right) && !is_watched(*left, *right));
        let left_out = left_out.map(|(left, right)| UnwatchedFloor::Level {
            gap,
            floors: [left, right],
        });
        columns.map(UnwatchedFloor::Column).chain(left_out).collect()
    }

    /// The floor that is meant; of two floors of a level the left one.
    pub(crate) fn unwatched_floor(&self, one: &UnwatchedFloor) -> usize {
        match one {
            UnwatchedFloor::Column(column) => self.beside[*column].floor,
            UnwatchedFloor::Level { floors, .. } => floors[0],
        }
    }

    /// Sentences about floors whose touches no contact models, even if they stay out of reach.
    pub fn says_unwatched(&self) -> Option<String> {
        let all = self.unwatched();
        let first = &self.all[self.unwatched_floor(all.first()?)].name;
        Some(format!(
            "floors that face a column, or a floor that `levels` leaves out: {}, the first {first}; neither is modelled",
            all.len()
        ))
    }

    /// Writes "levels 2 to 4 of A and B" if the contact in a gap leaves levels out.
    pub fn left_out(&self, gap: usize) -> Option<String> {
        let all = self.unwatched_in(gap).into_iter();
        let all = all.filter(UnwatchedFloor::is_level);
        let levels: Vec<usize> = all.map(|one| self.levels.level(self.unwatched_floor(&one)) + 1).collect();
        let [left, right] = [gap, gap + 1].map(|one| &self.structures[one]);
        let levels = match levels[..] {
            [] => return None,
            [one] => format!("level {one}"),
            [first, .., last] if last - first + 1 == levels.len() => {
                format!("levels {first} to {last}")
            }
            _ => {
                let all: Vec<String> = levels.iter().map(ToString::to_string).collect();
                format!("levels {}", all.join(", "))
            }
        };
        Some(format!("{levels} of {left} and {right}"))
    }

    /// A sentence about the floors of a gap that face columns; `None` if there are none.
    pub fn says_columns(&self, gap: usize) -> Option<String> {
        let all = self.beside.iter().filter(|one| one.gap == gap);
        let names: Vec<&str> = all
            .filter(|one| !one.is_slab() && !one.is_at_ground())
            .map(|one| self.all[one.floor].name.as_str())
            .collect();
        let first = names.first()?;
        let floors = match names.len() {
            1 => format!("{first} faces a column of its neighbour"),
            n => format!("{n} floors face columns of the neighbour (\"{first}\" and others)"),
        };
        Some(format!("{floors}: a floor that hits a column can bring the building down."))
    }

    /// Whether floors on both sides of a gap are level up to the lower roof, by the heights of their storeys or by the field `floors`. A single
    /// mass does not tell the floors of its building.
    pub fn are_level(&self, gap: usize) -> bool {
        let sides = [gap, gap + 1];
        let are_walls = sides.map(|one| self.of_structure(one).iter().any(|floor| self.all[*floor].is_wall()));
        let is_building = |floor: &usize| self.all[*floor].storey.is_some();
        let known = sides.map(|one| self.heights_of(one).is_some() && self.of_structure(one).iter().all(is_building));
        let mut beside = self.beside.iter().filter(|one| one.gap == gap);
        let faces_none = beside.all(ColumnBeside::is_at_ground);
        (known == [true; 2] || self.told_level) && are_walls == [false; 2] && faces_none
    }

    /// Heights of the floors of a structure, from the ground up; `None` if some are unknown, and for a wall.
    pub(super) fn heights_of(&self, structure: usize) -> Option<Vec<f64>> {
        let floors = self.of_structure(structure).iter();
        floors.map(|floor| self.all[*floor].elevation_m).collect()
    }
}
