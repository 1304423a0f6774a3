//! Columns that yield smoothly.

use crate::{Hysteresis, Hysteretic, Knee, Response, RestoringForce, Smoothness};

/// Bouc–Wen columns. Their memory is the drift and its elastic part.
///
/// f = a k d + (1 − a) k z, dz/dd = 1 − |z k/`f_y`|ⁿ (γ + β sgn(z ḋ)), γ = 1 − β (R. Bouc, *Proc. 4th Conf. Nonlinear Oscillations*, Prague
/// (1967) 315; Y. K. Wen, *J. Engng Mech. Div. ASCE* 102 (1976) 249). The loop does not depend on the rate: between two drifts it is
/// integrated over the drift, along the direct path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoucWen {
    /// Stiffness k at z = 0 \[N/m\], > 0.
    pub stiffness: f64,
    /// Yield force `f_y` \[N\], > 0; infinite for columns that never yield. (1 − a) k z tends to (1 − a) `f_y`.
    pub yield_force: f64,
    /// Ratio of the stiffness after yielding to that before \[–\], 0 ≤ a < 1.
    pub hardening: f64,
    /// Shape of the knee.
    pub smoothness: Smoothness,
}

/// Memory of Bouc–Wen columns.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Bent {
    /// Drift \[m\].
    pub drift: f64,
    /// Elastic part z of the drift \[m\].
    pub elastic: f64,
}

/// Pieces per yield displacement of drift over which the loop is integrated, for n = 1; n times as many for n.
///
/// The error falls with the fourth power: 16 pieces leave 2.2e-8 of the yield force (n = 1; against studies/opensees/loops.csv).
const PIECES: f64 = 16.0;
/// Pieces per yield displacement of the first drift, on which all later ones depend: an error of 1e-15.
const FIRST_PIECES: f64 = 1024.0;
/// Relative change of y that counts as zero.
const NOTHING: f64 = 1e-22;
/// Drifts beyond this many yield displacements no longer change z.
const ENOUGH: f64 = 60.0;

impl Smoothness {
    /// dy/ds of y = z k/`f_y` over s = drift k/`f_y`, in a direction of ±1.
    pub(crate) fn slope(&self, y: f64, direction: f64) -> f64 {
        let mut power = 1.0;
        for _ in 0..self.exponent {
            power *= y.abs();
        }
        let turn = if y * direction < 0.0 { -1.0 } else { 1.0 };
        1.0 - power * (1.0 - self.unloading + self.unloading * turn)
    }

    /// y after a drift of s.
    fn follow(&self, mut y: f64, s: f64) -> f64 {
        let way = Way::new(s, PIECES * f64::from(self.exponent));
        // Counted in floating-point numbers: a NaN drift also makes y NaN and stops the run.
        let mut piece = 0.0;
        while piece < way.pieces {
            let end = y + self.piece(y, way.direction, way.h);
            // |y|ⁿ has a kink at 0 that would lower the order of the method: the piece is split there.
            y = if y * end < 0.0 {
                self.piece(0.0, way.direction, way.h - self.way_to_zero(y, way.direction))
            } else {
                end
            };
            piece += 1.0;
        }
        if s.is_nan() { s } else { y }
    }

    /// y after a first drift of s, to rounding: the sum near 1 keeps the digits that each piece loses.
    fn first(&self, s: f64) -> f64 {
        let way = Way::new(s, FIRST_PIECES * f64::from(self.exponent));
        let (mut y, mut rest, mut piece) = (0.0, 0.0, 0.0);
        while piece < way.pieces {
            let more = self.piece(y, way.direction, way.h) + rest;
            let end = y + more;
            rest = more - (end - y);
            if more.abs() < NOTHING * y.abs() {
                break;
            }
            y = end;
            piece += 1.0;
        }
        if s.is_nan() { s } else { y }
    }

    /// Change of y over a piece of length h, by the classical Runge–Kutta method.
    fn piece(&self, y: f64, direction: f64, h: f64) -> f64 {
        let first = self.slope(y, direction);
        let second = self.slope(y + 0.5 * h * first, direction);
        let third = self.slope(y + 0.5 * h * second, direction);
        let fourth = self.slope(y + h * third, direction);
        h / 6.0 * (first + 2.0 * (second + third) + fourth)
    }

    /// The distance in s to y = 0, less than a piece away: ∫ds/dy dy by Simpson's rule, which needs no root.
    fn way_to_zero(&self, y: f64, direction: f64) -> f64 {
        let (there, middle) = (self.slope(y, direction), self.slope(0.5 * y, direction));
        -y / 6.0 * (1.0 / there + 4.0 / middle + 1.0)
    }
}

/// A drift s in pieces.
struct Way {
    direction: f64,
    pieces: f64,
    /// Length of a piece with sign.
    h: f64,
}

impl Way {
    fn new(s: f64, per_unit: f64) -> Self {
        let length = s.abs().min(ENOUGH);
        let direction = if s < 0.0 { -1.0 } else { 1.0 };
        let pieces = (length * per_unit).ceil();
        Self {
            direction,
            pieces,
            h: direction * length / pieces,
        }
    }
}

impl RestoringForce for BoucWen {
    type Memory = Bent;

    fn untouched(&self) -> Bent {
        Bent::default()
    }

    fn respond(&self, displacement: f64, memory: Bent) -> Response<Bent> {
        let moved = displacement - memory.drift;
        let follow = |scale: f64| self.smoothness.follow(memory.elastic * scale, moved * scale);
        self.response(displacement, moved, memory.elastic, follow)
    }

    fn loaded(&self, displacement: f64) -> Response<Bent> {
        let first = |scale: f64| self.smoothness.first(displacement * scale);
        self.response(displacement, displacement, 0.0, first)
    }
}

impl BoucWen {
    /// The response at a drift, from the last change of drift and an elastic part; `follow` finds y from k/`f_y`.
    fn response(&self, drift: f64, moved: f64, elastic: f64, follow: impl Fn(f64) -> f64) -> Response<Bent> {
        let (elastic, bend) = if self.yield_force.is_finite() {
            let scale = self.stiffness / self.yield_force;
            let y = follow(scale);
            let direction = if moved < 0.0 { -1.0 } else { 1.0 };
            (y / scale, self.smoothness.slope(y, direction))
        } else {
            (elastic + moved, 1.0)
        };
        let (hard, soft) = (self.hardening * self.stiffness, (1.0 - self.hardening) * self.stiffness);
        Response {
            force: hard * drift + soft * elastic,
            tangent: hard + soft * bend,
            memory: Bent { drift, elastic },
        }
    }
}

impl Hysteretic for BoucWen {
    fn hysteresis(&self) -> Hysteresis {
        Hysteresis {
            stiffness: self.stiffness,
            hardening: self.hardening,
            yield_force: self.yield_force,
            knee: Knee::Smooth(self.smoothness),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(exponent: u32, unloading: f64) -> BoucWen {
        BoucWen {
            stiffness: 1e5,
            yield_force: 1e3,
            hardening: 0.1,
            smoothness: Smoothness { exponent, unloading },
        }
    }

    #[test]
    fn reference_first_loading_in_closed_form() {
        for (s, parts) in [(0.3, 1), (2.0, 7), (5.0, 3)] {
            // n = 1: 1 − e^(−s); n = 2: tanh s.
            for (exponent, wanted) in [(1, 1.0 - libm::exp(-s)), (2, libm::tanh(s))] {
                let column = column(exponent, 0.5);
                let mut memory = Bent::default();
                let mut force = 0.0;
                for part in 1..=parts {
                    let drift = 0.01 * s * f64::from(part) / f64::from(parts);
                    let response = column.respond(drift, memory);
                    (memory, force) = (response.memory, response.force);
                }
                let wanted = 1e4 * 0.01 * s + 900.0 * wanted;
                assert!((force - wanted).abs() < 1e-4, "n = {exponent}, s = {s}: {force} {wanted}");
            }
        }
    }

    #[test]
    fn issue_first_displacement_to_rounding() {
        // The exact method started with an error of 2.2e-8 of the yield force.
        for s in [-60.0_f64, -2.0, 1e-30, 1e-9, 0.3, 1.0, 5.0, 1e9] {
            for (exponent, wanted) in [(1, s.signum() * -libm::expm1(-s.abs())), (2, libm::tanh(s))] {
                let y = column(exponent, 0.5).loaded(0.01 * s).memory.elastic / 0.01;
                assert!((y / wanted - 1.0).abs() < 1e-14, "n = {exponent}, s = {s}: {y} {wanted}");
            }
        }
    }

    #[test]
    fn reference_unloading_in_closed_form() {
        // n = 1, β = 0.7: back from y₀ > 0, dy/ds = 1 − y (γ − β) with γ − β = −0.4.
        let column = column(1, 0.7);
        let loaded = column.respond(0.02, Bent::default());
        let y0: f64 = 1.0 - libm::exp(-2.0);
        let back = column.respond(0.015, loaded.memory);
        // y + 1/0.4 decays like e^(−0.4·(−0.5)) with ds = −0.5: y = (y₀ + 2.5) e^(−0.2) − 2.5.
        let y = (y0 + 2.5) * libm::exp(-0.2) - 2.5;
        let wanted = 1e4 * 0.015 + 900.0 * y;
        assert!((back.force - wanted).abs() < 1e-4, "{} {wanted}", back.force);
    }

    #[test]
    fn limit_a_sharp_knee_tends_to_bilinear() {
        let smooth = column(20, 0.5);
        let sharp = crate::Bilinear {
            stiffness: 1e5,
            yield_force: 1e3,
            hardening: 0.1,
        };
        let (mut bent, mut plastic) = (Bent::default(), 0.0);
        for step in 0..400 {
            let drift = 0.03 * libm::sin(f64::from(step) * 0.05);
            let (a, b) = (smooth.respond(drift, bent), sharp.respond(drift, plastic));
            (bent, plastic) = (a.memory, b.memory);
            assert!((a.force - b.force).abs() < 40.0, "{drift}: {a:?} {b:?}");
        }
    }

    #[test]
    fn extreme_no_number_stays_none() {
        let response = column(2, 0.5).respond(f64::NAN, Bent::default());
        assert!(response.force.is_nan(), "{response:?}");
        let far = column(20, 0.5).respond(1e9, Bent::default());
        assert!((far.memory.elastic - 0.01).abs() < 1e-9, "{far:?}");
    }
}
