//! Contact laws of structural pounding: what two neighbours do to each other while they touch.
//!
//! A law is a value with its parameters. It knows no time step, no row and no record. *Impulsive* laws change velocities at an
//! instant ([`Stereomechanical`]). *Compliant* laws give a force that depends on the [`Overlap`]. Every compliant law is one
//! [`Form`], F = K δ^n + C δ^κ δ̇ ≥ 0.
//!
//! ```
//! use pounding_contact::{Calibration, FreeImpact, FreePair, LawName, reduced_mass};
//!
//! // 75 t hit 3000 t at 0.5 m/s. Impact stiffness 2.75e9 N/m^1.5; a coefficient of restitution e = 0.65 is asked for.
//! let pair = FreePair { reduced_mass: reduced_mass(1.0 / 75e3, 1.0 / 3e6), approach_speed: 0.5 };
//! let law = |calibration| LawName::HertzDamp.calibrated(2.75e9, (0.65, calibration), &pair);
//!
//! // Calibrated exactly, the law delivers this e, and H = m (1+e) v₀ = 73 170.7 kg · 1.65 · 0.5 m/s = 60 366 N·s.
//! let impact = FreeImpact::of(&law(Calibration::Exact)?, &pair).expect("a compliant law has a force");
//! assert!((impact.impulse - 60_366.0).abs() < 0.5);
//!
//! // The literature's a = ¾(1−e²) = 0.4331 delivers the e of a(1+e) = ln[(1+a)/(1−ea)], which is 0.7748.
//! let delivered = law(Calibration::Literature)?.restitution().expect("it has a closed form");
//! assert!((delivered - 0.7748).abs() < 5e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
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
//! The paper's laws are its equation (4) and Table 3. That table prints the power as 3 and the root otherwise; the published forces
//! follow from the form above, which is Jankowski's (2005).
//!
//! Left out: finding contacts, time stepping and more than two bodies (`pounding-solver`); how a file gives a law (`pounding-scene`).
//!
//! Where to start: [`ContactLaw`], the law of a pair; [`LawName`], the list with sources and calibrations; [`FreePair`] and
//! [`FreeImpact`], two bodies that collide and nothing else.

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
