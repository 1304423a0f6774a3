//! Floors that stand beside the columns of a neighbour, between its floors.

use super::{EQUAL_HEIGHTS, Floors};

/// A floor beside a column of the neighbouring building.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloorAtColumn {
    /// Index of the gap between both, from the left.
    pub gap: usize,
    /// The floor, by its place in the row.
    pub floor: usize,
    /// The floor below the column; `None` if the column stands on the ground.
    pub below: Option<usize>,
    /// The floor above the column.
    pub above: usize,
    /// Where along the column the floor is \[–\], from 0 at its foot to 1 at its head.
    pub along: f64,
}

impl Floors {
    /// Every floor that faces no floor of a neighbour, up to the lower roof of the two, where heights are given; whatever contacts say.
    pub fn at_columns(&self) -> Vec<FloorAtColumn> {
        let gaps = 0..self.structures.len().saturating_sub(1);
        gaps.flat_map(|gap| [(gap, gap, gap + 1), (gap, gap + 1, gap)])
            .flat_map(|(gap, own, other)| self.at_columns_of(gap, own, other))
            .collect()
    }

    /// Whether floors of both sides of a gap stand equally high up to the lower roof, by the heights that the scene gives.
    pub(crate) fn are_level(&self, gap: usize) -> bool {
        let known = [gap, gap + 1].map(|one| self.heights_of(one).is_some());
        known == [true; 2] && self.at_columns().iter().all(|one| one.gap != gap)
    }

    /// Heights of the floors of a structure, from the ground up; `None` if some are not known, and of a wall.
    fn heights_of(&self, structure: usize) -> Option<Vec<f64>> {
        let floors = self.of_structure(structure).iter();
        floors.map(|floor| self.all[*floor].elevation_m).collect()
    }

    fn at_columns_of(&self, gap: usize, own: usize, other: usize) -> Vec<FloorAtColumn> {
        let (Some(heights), Some(others)) = (self.heights_of(own), self.heights_of(other)) else {
            return Vec::new();
        };
        let beside = |(floor, height): (&usize, &f64)| {
            let next = others
                .iter()
                .position(|one| *one >= height - EQUAL_HEIGHTS)?;
            let foot = next.checked_sub(1);
            let low = foot.map_or(0.0, |foot| others[foot]);
            (others[next] > height + EQUAL_HEIGHTS).then(|| FloorAtColumn {
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
