//! Points of structures in lanes: on a floor, or on the columns between two floors.

use fearless_simd::Simd;

use super::number::{Lanes, MOST_LANES};
use pounding_solver::{Point, Relation, Share};

/// Two points that can meet, or the ends of a link, by the places of their structures.
pub(super) enum LaneRelation<S: Simd> {
    /// On floors: most pairs, which need no numbers.
    Floors([usize; 2]),
    Points(Box<Points<S>>),
}

pub(super) struct Points<S: Simd> {
    points: [LanePoint<S>; 2],
    zero: Lanes<S>,
}

enum LanePoint<S: Simd> {
    Floor(usize),
    Share(Share<Lanes<S>>),
    Ground,
}

impl<S: Simd> LaneRelation<S> {
    /// Relations of rows of a common shape; `place` gives the place of a node's structure.
    #[inline(always)]
    pub(super) fn new(simd: S, relations: &[Relation; MOST_LANES], place: impl Fn(usize) -> usize) -> Self {
        if let [Point::Floor(left), Point::Floor(right)] = relations[0].points() {
            return Self::Floors([left, right].map(place));
        }
        let lean = |side: usize| {
            let lean = |relation: &Relation| match relation.points()[side] {
                Point::Share(share) => share.lean,
                Point::Floor(_) | Point::Ground(_) => 0.0,
            };
            Lanes::new(simd, &relations.each_ref().map(lean))
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
        Self::Points(Box::new(Points {
            points: [point(0), point(1)],
            zero: Lanes::splat(simd, 0.0),
        }))
    }

    /// Left point minus right point, in a quantity of structures.
    #[inline(always)]
    pub(super) fn ahead(&self, quantity: impl Fn(usize) -> Lanes<S>) -> Lanes<S> {
        match self {
            Self::Floors([left, right]) => quantity(*left) - quantity(*right),
            Self::Points(points) => {
                let [left, right] = points.points.each_ref().map(|point| match point {
                    LanePoint::Floor(floor) => quantity(*floor),
                    LanePoint::Share(share) => share.of(&quantity),
                    LanePoint::Ground => points.zero,
                });
                left - right
            }
        }
    }

    /// Distributes to the structures a force \[N\] that pushes both points apart. `give` also receives whether the structure carries the
    /// left point; its force is to be subtracted then.
    #[inline(always)]
    pub(super) fn spread(&self, force: Lanes<S>, mut give: impl FnMut(usize, bool, Lanes<S>)) {
        match self {
            Self::Floors([left, right]) => {
                give(*left, true, force);
                give(*right, false, force);
            }
            Self::Points(points) => {
                for (point, on_left) in points.points.iter().zip([true, false]) {
                    match point {
                        LanePoint::Floor(floor) => give(*floor, on_left, force),
                        LanePoint::Share(share) => share.spread(force, |floor, force| give(floor, on_left, force)),
                        LanePoint::Ground => {}
                    }
                }
            }
        }
    }

    /// Visits the places of the structures that carry the points.
    #[inline(always)]
    pub(super) fn each_place(&self, mut visit: impl FnMut(usize)) {
        match self {
            Self::Floors(places) => places.iter().for_each(|place| visit(*place)),
            Self::Points(points) => {
                for point in &points.points {
                    match point {
                        LanePoint::Floor(floor) => visit(*floor),
                        LanePoint::Share(Share { base, other, .. }) => base.iter().chain(other).for_each(|place| visit(*place)),
                        LanePoint::Ground => {}
                    }
                }
            }
        }
    }
}
