//! Columns that stick and slide under friction.

use crate::{Hysteresis, Hysteretic, Knee, Response, RestoringForce};

/// A spring beside Coulomb friction, as friction pendulums have: f = k d + h, with h = `friction` · sgn ḋ while they slide.
///
/// While they stick, h is what keeps the drift at rest, at most `friction`. It then follows from the forces on the floor and not from the
/// drift, so that only the exact method has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sliding {
    /// Stiffness k \[N/m\], ≥ 0.
    pub stiffness: f64,
    /// Largest friction force \[N\], > 0.
    pub friction: f64,
}

impl RestoringForce for Sliding {
    type Memory = ();

    fn untouched(&self) {}

    /// The force of the spring alone.
    fn respond(&self, displacement: f64, (): ()) -> Response<()> {
        Response {
            force: self.stiffness * displacement,
            tangent: self.stiffness,
            memory: (),
        }
    }
}

impl Hysteretic for Sliding {
    fn hysteresis(&self) -> Hysteresis {
        Hysteresis {
            stiffness: self.stiffness,
            hardening: 1.0,
            yield_force: self.friction,
            knee: Knee::Rigid,
        }
    }
}
