//! Points of the row between which a pair or a link acts.

use pounding_solver::{Point, Relation, Share};

use super::storey::{StoreyColumns, Structure};

/// A point with a part `lean` of the far floor's motion and the rest of the near floor's motion. On a floor both are this floor.
#[derive(Debug, Clone, Copy)]
struct Spot {
    near: usize,
    far: usize,
    lean: f64,
}

impl Spot {
    /// Value at the point of a quantity of floors; exactly that of the floors if they agree.
    fn of(self, quantity: impl Fn(usize) -> f64) -> f64 {
        let near = quantity(self.near);
        near + self.lean * (quantity(self.far) - near)
    }

    /// Parts of a force on the point that the floors carry.
    fn parts(self) -> impl Iterator<Item = (usize, f64)> {
        let parts = [(self.near, 1.0 - self.lean), (self.far, self.lean)];
        parts.into_iter().filter(|(_, part)| *part > 0.0)
    }
}

/// Two points: the ends of a link, or the sides of a pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ends {
    left: Spot,
    right: Spot,
}

impl Ends {
    /// The points of a relation; grounds that they share become walls.
    pub(super) fn new(relation: Relation, structures: &mut Vec<Structure>) -> Self {
        let [left, right] = [relation.left, relation.right].map(|point| spot(point, structures));
        Self { left, right }
    }

    /// Left point minus right point, in a quantity of floors.
    pub(super) fn ahead(&self, quantity: impl Fn(usize) -> f64) -> f64 {
        self.left.of(&quantity) - self.right.of(&quantity)
    }

    /// Parts of floors and walls in the rate of deformation. A force pushes each by its part, with opposite sign.
    pub(super) fn parts(&self) -> impl Iterator<Item = (usize, f64)> {
        let right = self.right.parts().map(|(floor, part)| (floor, -part));
        self.left.parts().chain(right)
    }

    /// The part of a floor; 0 if they do not meet it.
    pub(super) fn part(&self, floor: usize) -> f64 {
        let parts = self.parts().filter(|(met, _)| *met == floor);
        parts.fold(0.0, |sum, (_, part)| sum + part)
    }

    /// Size of the terms of the difference, from the sizes of the quantity at floors.
    pub(super) fn size(&self, sizes: impl Fn(usize) -> f64) -> f64 {
        self.parts().map(|(floor, part)| part.abs() * sizes(floor)).sum()
    }

    /// A floor or wall on the ground of the left point, and another on that of the right point.
    pub(super) fn grounds(&self) -> [usize; 2] {
        [self.left.near, self.right.near]
    }
}

/// A point of the row; a ground that it shares becomes another wall.
fn spot(point: Point, structures: &mut Vec<Structure>) -> Spot {
    let (near, far, lean) = match point {
        Point::Floor(floor) => (Some(floor), Some(floor), 0.0),
        Point::Share(Share { base, other, lean }) => (base, other, lean),
        Point::Ground(_) => (None, None, 0.0),
    };
    let floor = point.floor();
    let mut or_ground = |met: Option<usize>| {
        met.unwrap_or_else(|| {
            let carried = structures[floor];
            structures.push(Structure {
                inverse_mass: 0.0,
                friction: None,
                below: None,
                body: structures.len(),
                columns: StoreyColumns {
                    smooth: None,
                    ..carried.columns
                },
                initial_displacement: 0.0,
                initial_velocity: 0.0,
                ..carried
            });
            structures.len() - 1
        })
    };
    Spot {
        near: or_ground(near),
        far: or_ground(far),
        lean,
    }
}
