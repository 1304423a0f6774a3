//! Contact laws of structural pounding: what two neighbours do to each other while they touch.
//!
//! One file per law. A law is a value with its parameters; it knows no time step, no row and no record.
//! Two kinds exist: *impulsive* laws change velocities at an instant ([`Stereomechanical`]), *compliant* laws
//! give a force that depends on the [`Overlap`] ([`NonlinearViscoelastic`]).
//!
//! # The laws of the paper (its equation (4) and Table 3)
//!
//! | Law | While touching |
//! |---|---|
//! | Stereomechanical impact | impulse P = (1+e) · m₁m₂/(m₁+m₂) · δ̇, δ̇ the rate of approach; once per impact |
//! | Nonlinear viscoelastic, approach (δ̇ > 0) | F = β̄ δ^1.5 + c̄ δ̇ with c̄ = 2 ξ̄ √(β̄ √δ · m₁m₂/(m₁+m₂)) |
//! | Nonlinear viscoelastic, restitution (δ̇ ≤ 0) | F = β̄ δ^1.5 |
//!
//! Table 3 prints the power as 3 and the root otherwise; the published forces follow from the form above,
//! which is Jankowski's (2005).
//!
//! Left out: finding contacts, time stepping, anything with more than two bodies.

mod error;
mod nonlinear_viscoelastic;
mod overlap;
mod stereomechanical;

pub use error::ParameterError;
pub use nonlinear_viscoelastic::NonlinearViscoelastic;
pub use overlap::{ContactForce, Overlap, reduced_mass};
pub use stereomechanical::Stereomechanical;

use serde::{Deserialize, Serialize};

/// A contact law with its parameters, as a scene names it.
///
/// It is matched only while a pair touches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ContactLaw {
    /// Velocity jump at an instant; see [`Stereomechanical`].
    Stereomechanical(Stereomechanical),
    /// Hertz spring with a damper that acts on approach; see [`NonlinearViscoelastic`].
    NonlinearViscoelastic(NonlinearViscoelastic),
}

impl ContactLaw {
    /// Checks the parameters against their valid range.
    ///
    /// # Errors
    /// [`ParameterError`] names the parameter, what was found and what is allowed.
    pub fn check(&self) -> Result<(), ParameterError> {
        match self {
            Self::Stereomechanical(law) => law.check(),
            Self::NonlinearViscoelastic(law) => law.check(),
        }
    }

    /// Coefficient of restitution that the law delivers to a free pair, exactly \[–\].
    pub fn restitution(&self) -> f64 {
        match self {
            Self::Stereomechanical(law) => law.restitution,
            Self::NonlinearViscoelastic(law) => law.restitution(),
        }
    }
}
