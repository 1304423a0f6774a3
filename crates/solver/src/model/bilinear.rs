//! Columns that harden after yielding.

use crate::model::column::yielding;
use crate::{Hysteresis, Hysteretic, Knee, Response, RestoringForce};

/// Bilinear columns with kinematic hardening. Their memory is the plastic displacement \[m\].
///
/// f = a k d + h. Here h is the force of elastic-perfectly plastic columns of stiffness (1 − a) k that yield at (1 − a) `f_y`. The loop
/// keeps the width 2 `f_y` (A. K. Chopra, *Dynamics of Structures*, 7.1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bilinear {
    /// Stiffness before yielding k \[N/m\], > 0.
    pub stiffness: f64,
    /// Yield force `f_y` \[N\], > 0; infinite for columns that never yield.
    pub yield_force: f64,
    /// Ratio of the stiffness after yielding to that before \[–\], 0 ≤ a < 1.
    pub hardening: f64,
}

impl Bilinear {
    /// Stiffness after yielding \[N/m\].
    pub fn elastic(&self) -> f64 {
        self.hardening * self.stiffness
    }

    /// Stiffness \[N/m\] and yield force \[N\] of the perfectly plastic part.
    pub fn plastic(&self) -> [f64; 2] {
        let part = 1.0 - self.hardening;
        [part * self.stiffness, part * self.yield_force]
    }
}

impl RestoringForce for Bilinear {
    type Memory = f64;

    fn untouched(&self) -> f64 {
        0.0
    }

    fn respond(&self, displacement: f64, plastic_displacement: f64) -> Response<f64> {
        let elastic = self.elastic();
        let at_yield = || self.yield_force / self.stiffness;
        let tangents = [self.stiffness, elastic];
        let plastic = yielding(displacement, plastic_displacement, self.plastic(), at_yield, tangents);
        Response {
            force: elastic * displacement + plastic.force,
            ..plastic
        }
    }
}

impl Hysteretic for Bilinear {
    fn hysteresis(&self) -> Hysteresis {
        Hysteresis {
            stiffness: self.stiffness,
            hardening: self.hardening,
            yield_force: self.yield_force,
            knee: Knee::Sharp,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_a_loop_by_hand() {
        // k = 100 kN/m, u_y = 10 mm, a = 0.1.
        let column = Bilinear {
            stiffness: 1e5,
            yield_force: 1e3,
            hardening: 0.1,
        };
        let mut memory = 0.0;
        // To 30 mm: 1000 + 0.1·100e3·0.02 = 1200 N. Back: yields after 2 u_y, at 10 mm and −800 N. At −30 mm: −1200 N.
        for (displacement, force, tangent) in [
            (0.005, 500.0, 1e5),
            (0.03, 1200.0, 1e4),
            (0.02, 200.0, 1e5),
            (0.01, -800.0, 1e5),
            (-0.03, -1200.0, 1e4),
            (-0.02, -200.0, 1e5),
        ] {
            let response = column.respond(displacement, memory);
            assert!((response.force - force).abs() < 1e-9, "{displacement}: {response:?}");
            // 10 mm is at the knee: either tangent is right there.
            let knee = (displacement - 0.01).abs() < 1e-12;
            assert!(knee || (response.tangent - tangent).abs() < 1e-9, "{displacement}: {response:?}");
            memory = response.memory;
        }
    }
}
