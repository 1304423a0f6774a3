//! Points of a row that can meet, and the law of their contact.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::{ContactLaw, Number};

use crate::{Node, PointFault};

/// A point of a building on a floor, or between two floors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Point {
    /// On a floor, or on a wall.
    Floor(usize),
    /// On the columns between two floors.
    Share(Share),
    /// On the ground under a node; for links only.
    Ground(usize),
}

/// A point on the columns between two floors; [`Point::between`] makes it.
///
/// Its displacement is that of the base plus `lean` times the difference to the other floor. If both floors move alike, the point moves
/// exactly with them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share<N = f64> {
    /// The nearer floor; `None` is the ground.
    pub base: Option<usize>,
    /// The other floor; `None` is the ground.
    pub other: Option<usize>,
    /// Part of the other floor \[–\], 0 < lean ≤ 1/2.
    pub lean: N,
}

impl<N: Number> Share<N> {
    /// The value at the point of a quantity of floors, which is 0 on the ground.
    #[inline(always)]
    pub fn of(self, quantity: impl Fn(usize) -> N) -> N {
        let mut ends = [self.lean.like(0.0); 2];
        for (end, floor) in ends.iter_mut().zip([self.base, self.other]) {
            if let Some(floor) = floor {
                *end = quantity(floor);
            }
        }
        let [base, other] = ends;
        base + self.lean * (other - base)
    }

    /// Distributes a force \[N\] or an impulse \[N·s\] on the point to its floors.
    #[inline(always)]
    pub fn spread(self, force: N, mut give: impl FnMut(usize, N)) {
        let to_other = self.lean * force;
        if let Some(base) = self.base {
            give(base, force - to_other);
        }
        if let Some(other) = self.other {
            give(other, to_other);
        }
    }
}

/// Two points that can meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relation {
    /// The point on the left.
    pub left: Point,
    /// The point on the right.
    pub right: Point,
    /// Distance at rest \[m\].
    pub offset: f64,
}

/// Two points that can touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// The points; their distance at rest is the gap g \[m\], ≥ 0.
    pub relation: Relation,
    /// The law of their contact.
    pub law: ContactLaw,
}

impl Pair {
    /// A pair of two points with a gap g \[m\], ≥ 0. The left point comes first; this is not checked.
    pub fn new(left: Point, right: Point, gap: f64, law: ContactLaw) -> Self {
        let relation = Relation { left, right, offset: gap };
        Self { relation, law }
    }

    /// A pair of two floors, or of a floor and a wall, by their nodes, with a gap g \[m\], ≥ 0. The left one comes first.
    pub fn of_floors(left: usize, right: usize, gap: f64, law: ContactLaw) -> Self {
        Self::new(left.into(), right.into(), gap, law)
    }

    /// The floor on the left; for a point on columns, the nearer floor.
    pub fn left(&self) -> usize {
        self.relation.left.floor()
    }

    /// The floor on the right; for a point on columns, the nearer floor.
    pub fn right(&self) -> usize {
        self.relation.right.floor()
    }

    /// Gap at rest g \[m\], ≥ 0.
    pub fn gap(&self) -> f64 {
        self.relation.offset
    }
}

impl From<usize> for Point {
    fn from(floor: usize) -> Self {
        Self::Floor(floor)
    }
}

impl Point {
    /// The point between two floors of a building, by their nodes. It has the part `upper_part` \[–\], 0 to 1, of the upper floor's
    /// displacement and the rest of the lower floor's. `lower` is `None` for the ground.
    ///
    /// Returns `None` if the part is not a number from 0 to 1, or if the point is on the ground.
    pub fn between(lower: Option<usize>, upper: usize, upper_part: f64) -> Option<Self> {
        if !(0.0..=1.0).contains(&upper_part) {
            return None;
        }
        if upper_part >= 1.0 {
            return Some(Self::Floor(upper));
        }
        if upper_part <= 0.0 {
            return lower.map(Self::Floor);
        }
        let (base, other, lean) = if upper_part >= 0.5 {
            (Some(upper), lower, 1.0 - upper_part)
        } else {
            (lower, Some(upper), upper_part)
        };
        Some(Self::Share(Share { base, other, lean }))
    }

    /// Checks that this is a point of a row with these nodes.
    pub(crate) fn check<Column>(self, nodes: &[Node<Column>]) -> Result<(), PointFault> {
        let known = |floor: usize| {
            let n_nodes = nodes.len();
            let fault = PointFault::NoNode { found: floor, n_nodes };
            nodes.get(floor).ok_or(fault)
        };
        let Share { base, other, lean } = match self {
            Self::Floor(floor) | Self::Ground(floor) => return known(floor).map(|_| ()),
            Self::Share(share) => share,
        };
        for floor in base.into_iter().chain(other) {
            known(floor)?;
        }
        // The ground is below all floors, and a floor comes before the floors above it.
        let (lower, upper) = (base.min(other), base.max(other));
        let upper = upper.ok_or(PointFault::NoFloor)?;
        let node = known(upper)?;
        if node.is_wall() || node.support.below() != lower {
            return Err(PointFault::NoStorey { lower, upper });
        }
        if !(lean > 0.0 && lean <= 0.5) {
            return Err(PointFault::Lean { found: lean });
        }
        Ok(())
    }

    /// The floor with which the point moves, wholly or most; for a point on the ground, the node above it.
    pub fn floor(self) -> usize {
        match self {
            Self::Floor(floor) | Self::Ground(floor) => floor,
            // A point between the ground and the ground is refused by every row.
            Self::Share(Share { base, other, .. }) => base.or(other).unwrap_or(usize::MAX),
        }
    }

    /// The value at the point of a quantity of floors, such as displacement, velocity or acceleration.
    #[inline]
    pub fn of(self, quantity: impl Fn(usize) -> f64) -> f64 {
        match self {
            Self::Floor(floor) => quantity(floor),
            Self::Ground(_) => 0.0,
            Self::Share(share) => share.of(quantity),
        }
    }

    /// The floors that carry the point, the nearer one first, and their parts of a force on it.
    #[inline]
    pub fn parts(self) -> impl Iterator<Item = (usize, f64)> + Clone {
        let parts = match self {
            Self::Floor(floor) => [Some((floor, 1.0)), None],
            Self::Ground(_) => [None, None],
            Self::Share(Share { base, other, lean }) => [base.map(|floor| (floor, 1.0 - lean)), other.map(|floor| (floor, lean))],
        };
        parts.into_iter().flatten()
    }

    /// Distributes a force \[N\] or an impulse \[N·s\] on the point to its floors.
    #[inline]
    pub fn spread(self, force: f64, mut give: impl FnMut(usize, f64)) {
        match self {
            Self::Floor(floor) => give(floor, force),
            Self::Ground(_) => {}
            Self::Share(share) => share.spread(force, give),
        }
    }

    /// Velocity of the point under a unit impulse on it \[1/kg\].
    #[inline]
    pub fn mobility(self, inverse_mass: impl Fn(usize) -> f64) -> f64 {
        match self {
            Self::Floor(floor) => inverse_mass(floor),
            Self::Share(_) | Self::Ground(_) => self.parts().map(|(floor, part)| part * part * inverse_mass(floor)).sum(),
        }
    }
}

impl Relation {
    /// Left point minus right point, in a quantity of floors.
    #[inline]
    pub fn ahead(&self, quantity: impl Fn(usize) -> f64) -> f64 {
        self.left.of(&quantity) - self.right.of(&quantity)
    }

    /// Distributes to the floors a force \[N\] or an impulse \[N·s\] that pushes both points apart; positive to the right.
    #[inline]
    pub fn spread(&self, force: f64, mut give: impl FnMut(usize, f64)) {
        self.left.spread(force, |floor, force| give(floor, -force));
        self.right.spread(force, give);
    }

    /// Both points.
    #[inline]
    pub fn points(&self) -> [Point; 2] {
        [self.left, self.right]
    }

    /// Whether both points are on floors.
    pub fn is_level(&self) -> bool {
        let mut points = self.points().into_iter();
        points.all(|point| matches!(point, Point::Floor(_)))
    }

    /// Its row of the matrix G: the effect on the floors of 1 N between both points. Floors on the left are pushed to the left.
    #[inline]
    pub fn pushes(&self) -> impl Iterator<Item = (usize, f64)> {
        let left = self.left.parts().map(|(floor, part)| (floor, -part));
        left.chain(self.right.parts())
    }
}
