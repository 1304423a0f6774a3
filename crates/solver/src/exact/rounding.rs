//! Rounding of the coefficients of a structure and of a pair.

use crate::exact::member::Member;
use crate::{Point, Relation};

/// Rounding of a coefficient, as a part of the sum of its terms' magnitudes.
pub const OF_COEFFICIENTS: f64 = 64.0 * f64::EPSILON;
/// Rounding of a sum of few numbers, of a deformation or of an instant, as a part of the largest term.
pub(super) const OF_SUMS: f64 = 8.0 * f64::EPSILON;

/// Rounding of coefficient `n` of the deformation of a pair with equal displacements and velocities, from the coefficients of both points.
pub(super) fn noise(members: &[Member], relation: Relation, values: [f64; 2], p: usize, n: usize) -> f64 {
    let terms = if n >= 2 * p && n.is_multiple_of(p) {
        let order = n / p - 2;
        let weight = ((order + 1) * (order + 2)) as f64;
        let [left, right] = relation.points().map(|point| weighed(point, |node| members[node].noise(order)));
        (left + right) / weight
    } else {
        0.0
    };
    OF_COEFFICIENTS * (values[0].abs() + values[1].abs() + terms)
}

/// Weighted sum of a magnitude over the floors of a point.
#[inline]
pub(super) fn weighed(point: Point, magnitude: impl Fn(usize) -> f64) -> f64 {
    match point {
        Point::Floor(floor) => magnitude(floor),
        Point::Share(_) | Point::Ground(_) => point.parts().map(|(floor, part)| part * magnitude(floor)).sum(),
    }
}

impl Member {
    /// Scale of the rounding of the acceleration's coefficient of this order in time: its terms, and its change over the elapsed time,
    /// because instants are rounded.
    pub(super) fn noise(&self, order: usize) -> f64 {
        let next = (order + 1) as f64 * self.magnitude_of(order + 1);
        self.magnitude_of(order) + self.terms.time * next
    }

    /// Scale of the rounding of a force that moves the member. Columns that yield smoothly have coefficients that grow faster than the
    /// terms show.
    pub(super) fn need_of_noise(&self, order: usize, p: usize) -> f64 {
        if order == 0 {
            self.mass * (self.noise(order) + self.terms.ground.0) + self.terms.own
        } else {
            let found = self.acceleration[order * p].abs();
            self.mass * self.noise(order).max(found)
        }
    }

    /// Rounding of coefficient `n` of the velocity.
    pub(super) fn noise_of_velocity(&self, p: usize, n: usize) -> f64 {
        if n >= p && n.is_multiple_of(p) {
            let order = n / p - 1;
            OF_COEFFICIENTS * self.noise(order) / (order + 1) as f64
        } else {
            0.0
        }
    }

    fn magnitude_of(&self, order: usize) -> f64 {
        let terms = &self.terms;
        if order == 0 {
            return terms.acceleration;
        }
        let mut noise = terms.around;
        for n in 1..=order {
            noise *= terms.rate / n as f64;
            if n == 1 {
                noise += terms.ground.1;
            }
        }
        noise
    }
}
