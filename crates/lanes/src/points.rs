//! Points of structures in lanes: on a floor, or on the columns between two floors.

use fearless_simd::Simd;

use super::number::{Lanes, MOST_LANES};
use pounding_solver::{Point, Relation, Share};

/// Two points that can meet, or the ends of a link, by the places of their structures.
#[derive(Clone, Copy)]
pub(super) struct LaneRelation<S: Simd> {
    points: [LanePoint<S>; 2],
    zero: Lanes<S>,
}

#[derive(Clone, Copy)]
enum LanePoint<S: Simd> {
    Floor(usize),
    Share(Share<Lanes<S>>),
    Ground,
}

impl<S: Simd> LaneRelation<S> {
    /// Relations of rows of a common shape; `place` gives the place of a node's structure.
    #[inline(always)]
    pub(super) fn new(simd: S, relations: [Relation; MOST_LANES], place: impl Fn(usize) -> usize) -> Self {
        let lean = |side: usize| {
            let lean = |relation: Relation| match relation.points()[side] {
                Point::Share(share) => share.lean,
                Point::Floor(_) | Point::Ground(_) => 0.0,
            };
            Lanes::new(simd, &relations.map(lean))
        };
        let point = |side: usize| match relations[0].points()[side] {
            Point::Floor(floor) => LanePoint::Floor(place(floor)),
            Point::Ground(_) => LanePoint::Ground,
            Point::Share(Share { base, other, .. }) => LanePoint::Share(Share {
                base: base.map(&place),
                other: other.map(&place),
                lean: lean(side),
            }),
        };
        Self {
            points: [point(0), point(1)],
            zero: Lanes::splat(simd, 0.0),
        }
    }

    /// Left point minus right point, in a quantity of structures.
    #[inline(always)]
    pub(super) fn ahead(&self, quantity: impl Fn(usize) -> Lanes<S>) -> Lanes<S> {
        let [left, right] = &self.points;
        self.of(left, &quantity) - self.of(right, &quantity)
    }

    #[inline(always)]
    fn of(&self, point: &LanePoint<S>, quantity: impl Fn(usize) -> Lanes<S>) -> Lanes<S> {
        match *point {
            LanePoint::Floor(floor) => quantity(floor),
            LanePoint::Share(share) => share.of(quantity),
            LanePoint::Ground => self.zero,
        }
    }

    /// Distributes to the structures a force \[N\] that pushes both points apart. `give` also receives whether the structure carries the
    /// left point; its force is to be subtracted then.
    #[inline(always)]
    pub(super) fn spread(&self, force: Lanes<S>, mut give: impl FnMut(usize, bool, Lanes<S>)) {
        for (point, on_left) in self.points.iter().zip([true, false]) {
            match *point {
                LanePoint::Floor(floor) => give(floor, on_left, force),
                LanePoint::Share(share) => share.spread(force, |floor, force| give(floor, on_left, force)),
                LanePoint::Ground => {}
            }
        }
    }

    /// Places of the structures that carry the points.
    #[inline(always)]
    pub(super) fn places(&self) -> impl Iterator<Item = usize> + use<S> {
        let carriers = self.points.map(|point| match point {
            LanePoint::Floor(floor) => [Some(floor), None],
            LanePoint::Share(share) => [share.base, share.other],
            LanePoint::Ground => [None; 2],
        });
        carriers.into_iter().flatten().flatten()
    }
}
