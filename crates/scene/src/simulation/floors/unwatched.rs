//! Floors whose touches no contact models: floors beside columns of a neighbour, and levels that `levels` leaves out.

use super::{EQUAL_HEIGHTS, Floors};

/// A floor, and the column or floor beside it in the neighbouring building, if no contact models their touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnwatchedFloor {
    /// Index of the gap between both, from the left.
    pub gap: usize,
    /// Index of the floor in the row; of two floors of a level the left one.
    pub floor: usize,
    /// Floor at the foot of the column; `None` if the column stands on the ground.
    pub below: Option<usize>,
    /// Floor at the head of the column, or the floor of the same level.
    pub above: usize,
    /// Position of the floor along the column \[–\]: 0 at the foot, 1 at the head and for a floor of the same level.
    pub along: f64,
}

impl UnwatchedFloor {
    /// Whether it faces a floor instead of a column.
    pub fn is_level(&self) -> bool {
        self.along >= 1.0
    }

    /// Whether it is a base slab at the ground, which faces the foot of its neighbour.
    pub(crate) fn is_at_ground(&self) -> bool {
        self.along <= 0.0
    }
}

impl Floors {
    /// Finds floors beside columns, up to the lower roof of two neighbours with given heights, and floors of levels that contacts leave
    /// out. A wall stands only at the levels of its contact.
    pub fn unwatched(&self) -> Vec<UnwatchedFloor> {
        let gaps = 0..self.structures.len().saturating_sub(1);
        gaps.flat_map(|gap| self.unwatched_in(gap)).collect()
    }

    fn unwatched_in(&self, gap: usize) -> Vec<UnwatchedFloor> {
        let facing: Vec<_> = self.levels.facing(gap).collect();
        let meets = |one: &UnwatchedFloor| facing.iter().any(|(l, r)| [*l, *r].contains(&one.floor));
        let mut all: Vec<_> = self.beside_columns(gap);
        all.retain(|one| !meets(one));
        let moves = |floor: usize| !self.all[floor].is_wall();
        let is_watched = |left: usize| {
            let found = self.facing.binary_search_by_key(&left, |one| one.left);
            found.is_ok() || self.facing.is_empty()
        };
        let left_out = facing
            .iter()
            .filter(|_| !self.is_unmodelled(gap))
            .filter(|(left, right)| moves(*left) && moves(*right) && !is_watched(*left));
        all.extend(left_out.map(|(left, right)| UnwatchedFloor {
            gap,
            floor: *left,
            below: None,
            above: *right,
            along: 1.0,
        }));
        all
    }

    /// Sentences about floors whose touches no contact models, even if they stay out of reach.
    pub fn says_unwatched(&self) -> Option<String> {
        let all = self.unwatched();
        let first = &self.all[all.first()?.floor].name;
        Some(format!(
            "floors that face a column, or a floor that `levels` leaves out: {}, the first {first}; neither is modelled",
            all.len()
        ))
    }

    /// Writes "levels 2 to 4 of A and B" if the contact in a gap leaves levels out.
    pub fn left_out(&self, gap: usize) -> Option<String> {
        let all = self.unwatched_in(gap).into_iter();
        let all = all.filter(UnwatchedFloor::is_level);
        let levels: Vec<usize> = all.map(|one| self.levels.level(one.floor) + 1).collect();
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

    /// Floors beside columns, of every gap from the left.
    pub fn beside_all_columns(&self) -> Vec<UnwatchedFloor> {
        let mut all = self.unwatched();
        all.retain(|one| !one.is_level());
        all
    }

    /// A sentence about the floors of a gap that face columns; `None` if there are none.
    pub fn says_columns(&self, gap: usize) -> Option<String> {
        let all = self.unwatched_in(gap);
        let names: Vec<&str> = all
            .iter()
            .filter(|one| !one.is_level() && !one.is_at_ground())
            .map(|one| self.all[one.floor].name.as_str())
            .collect();
        let first = names.first()?;
        let floors = match names.len() {
            1 => format!("{first} faces a column of its neighbour"),
            n => format!("{n} floors face columns of the neighbour, the first {first}"),
        };
        Some(format!(
            "{floors}: a floor that hits a column can bring the building down, and that contact is not modelled."
        ))
    }

    /// Whether floors on both sides of a gap are level up to the lower roof, by the heights in the scene or by its field `floors`.
    pub fn are_level(&self, gap: usize) -> bool {
        let sides = [gap, gap + 1];
        let are_walls = sides.map(|one| self.of_structure(one).iter().any(|floor| self.all[*floor].is_wall()));
        let known = sides.map(|one| self.heights_of(one).is_some());
        let faces_none = self.beside_columns(gap).iter().all(UnwatchedFloor::is_at_ground);
        (known == [true; 2] || self.told_level) && are_walls == [false; 2] && faces_none
    }

    /// Heights of the floors of a structure, from the ground up; `None` if some are unknown, and for a wall.
    fn heights_of(&self, structure: usize) -> Option<Vec<f64>> {
        let floors = self.of_structure(structure).iter();
        floors.map(|floor| self.all[*floor].elevation_m).collect()
    }

    /// Floors on both sides of a gap that are level with no floor of the other side.
    fn beside_columns(&self, gap: usize) -> Vec<UnwatchedFloor> {
        let of = |own, other| self.beside_columns_of(gap, own, other);
        [of(gap, gap + 1), of(gap + 1, gap)].concat()
    }

    fn beside_columns_of(&self, gap: usize, own: usize, other: usize) -> Vec<UnwatchedFloor> {
        let (Some(heights), Some(others)) = (self.heights_of(own), self.heights_of(other)) else {
            return Vec::new();
        };
        let beside = |(floor, height): (&usize, &f64)| {
            let next = others.iter().position(|one| *one >= height - EQUAL_HEIGHTS)?;
            let foot = next.checked_sub(1);
            let low = foot.map_or(0.0, |foot| others[foot]);
            (others[next] > height + EQUAL_HEIGHTS).then(|| UnwatchedFloor {
                gap,
                floor: *floor,
                below: foot.map(|foot| self.of_structure(other)[foot]),
                above: self.of_structure(other)[next],
                along: (height - low) / (others[next] - low),
            })
        };
        let own = self.of_structure(own).iter().zip(&heights);
        own.filter_map(beside).collect()
    }
}
