//! Contact laws of structural pounding: the force or impulse between two neighbours that touch.
//!
//! A law is a value with its parameters. It knows no time step, no row and no record. *Impulsive* laws change velocities at an instant
//! ([`Stereomechanical`]). *Compliant* laws give a force that depends on the [`Overlap`]. Every compliant law is a [`Form`], F = K δ^n + C
//! δ^κ δ̇ ≥ 0.
//!
//! ```
//! use pounding_contact::{Calibration, FreeImpact, FreePair, LawName, reduced_mass};
//!
//! // 75 t hit 3000 t at 0.5 m/s. Impact stiffness 2.75e9 N/m^1.5; the requested coefficient of restitution is e = 0.65.
//! let pair = FreePair { reduced_mass: reduced_mass(1.0 / 75e3, 1.0 / 3e6), approach_speed: 0.5 };
//! let law = |calibration| LawName::HertzDamp.calibrated(2.75e9, 0.65, calibration, &pair);
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
//! Each law is a file of `laws`, with its parameters, its force and its sources. The paper's laws are its equation (4) and Table 3. Table 3
//! prints the power as 3 and another root; the published forces follow from the form above, which is Jankowski's (2005).
//!
//! Not in this crate: finding contacts, time stepping and more than two bodies (`pounding-solver`); laws in scene files (`pounding-scene`).
//!
//! Where to start: [`ContactLaw`], the law of a pair; [`LawName`], the list with sources and calibrations; [`FreePair`] and [`FreeImpact`],
//! two bodies that collide freely; [`Slab`], the impact stiffness of slabs.

pub mod approach_damper;
mod contact_law;
mod form;
mod free_impact;
mod free_pair;
mod law;
mod law_name;
mod laws;
mod number;
mod oscillator;
pub mod parameter;
mod search;
mod slab;
mod words;

pub use approach_damper::SLOWEST_APPROACH;
pub use contact_law::{Clamp, Overlap, reduced_mass};
pub use form::{Action, ContactForce, Form, Power, Slope, Term};
pub use free_impact::FreeImpact;
pub use free_pair::FreePair;
pub use law::{About, Exact, Formula, Law, Name};
pub use law_name::{Calibration, CalibrationError};
pub use laws::*;
pub use number::Number;
pub use parameter::{Parameter, ParameterError, Range};
pub use slab::Slab;
