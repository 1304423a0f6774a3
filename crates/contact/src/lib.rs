//! Contact laws of structural pounding: what two neighbours do to each other while they touch.
//!
//! One file per law. A law is a value with its parameters; it knows no time step, no row and no record.
//! Two kinds exist: *impulsive* laws change velocities at an instant ([`Stereomechanical`]), *compliant* laws give a
//! force that depends on the [`Overlap`]. Every compliant law is one [`Form`], F = K δ^n + C δ^κ δ̇ ≥ 0.
//!
//! | Law | While touching (v₀ the approach speed, m the reduced mass) |
//! |---|---|
//! | [`Stereomechanical`] | impulse P = (1+e) m δ̇; once per impact |
//! | [`LinearSpring`], [`Hertz`] | kδ, β̄ δ^1.5 |
//! | [`KelvinVoigt`] | kδ + cδ̇, c = 2ξ̄ √(km), clamped |
//! | [`ModifiedLinearViscoelastic`] | the same on approach (δ̇ > 0), else kδ |
//! | [`NonlinearViscoelastic`] | β̄ δ^1.5 + cδ̇, c = 2ξ̄ √(β̄ √δ m) on approach, else β̄ δ^1.5 |
//! | [`HertzDamp`], by four formulas | β̄ δ^1.5 (1 + aδ̇/v₀), clamped |
//! | [`ModifiedKelvin`] | kδ (1 + aδ̇/v₀), clamped |
//! | [`PantWijeyewickrema`] | the same on approach, else kδ |
//! | [`KuwabaraKono`] | β̄ δ^1.5 + A √δ δ̇, clamped |
//!
//! What a law delivers to a [`FreePair`] is known three ways: [`ContactLaw::restitution`] and the other closed forms,
//! [`FreeImpact`] by numerical integration, and the solver. [`LawName`] lists the laws with their sources and
//! calibrates them ([`Calibration`]).
//!
//! The paper's laws are its equation (4) and Table 3. That table prints the power as 3 and the root otherwise; the
//! published forces follow from the form above, which is Jankowski's (2005).
//!
//! Files give a law by its damping, or by the `restitution` that it is to deliver and a `calibration`, `exact` (the
//! default) or `literature`.
//!
//! Left out: finding contacts, time stepping, anything with more than two bodies.

mod approach_damper;
mod calibration;
mod error;
mod form;
mod free_impact;
mod free_pair;
mod given;
mod hertz;
mod hertz_damp;
mod kelvin_voigt;
mod kuwabara_kono;
mod law;
mod law_name;
mod linear_spring;
mod modified_kelvin;
mod modified_linear_viscoelastic;
mod nonlinear_viscoelastic;
mod number;
mod oscillator;
mod overlap;
mod pant_wijeyewickrema;
mod search;
mod stereomechanical;

pub use approach_damper::SLOWEST_APPROACH;
pub use calibration::Calibration;
pub use error::ParameterError;
pub use form::{Action, Form, Power, Term};
pub use free_impact::FreeImpact;
pub use free_pair::FreePair;
pub use hertz::Hertz;
pub use hertz_damp::{HertzDamp, HertzDampFormula};
pub use kelvin_voigt::KelvinVoigt;
pub use kuwabara_kono::KuwabaraKono;
pub use law::{Clamp, ContactLaw};
pub use law_name::{CalibrationError, Description, LawName};
pub use linear_spring::LinearSpring;
pub use modified_kelvin::ModifiedKelvin;
pub use modified_linear_viscoelastic::ModifiedLinearViscoelastic;
pub use nonlinear_viscoelastic::{NonlinearViscoelastic, ViscoelasticPair};
pub use number::Number;
pub use overlap::{ContactForce, Overlap, reduced_mass};
pub use pant_wijeyewickrema::PantWijeyewickrema;
pub use stereomechanical::Stereomechanical;
