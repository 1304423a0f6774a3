//! Tests of all laws at once: what they deliver, what they give as forces.

mod calibration;
mod delivered;
mod force;
mod given;

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName};

/// The reduced mass of the paper's left and middle structures, nearly, at a usual speed.
const PAIR: FreePair = FreePair {
    reduced_mass: 73_170.0,
    approach_speed: 0.3,
};

/// The usual stiffness of a law.
fn stiffness(name: LawName) -> f64 {
    match name.stiffness_unit() {
        Some("N/m") => 9.35e7,
        _ => 2.75e9,
    }
}

/// A law calibrated to an e, where it can be.
fn law(name: LawName, restitution: f64, calibration: Calibration) -> Option<ContactLaw> {
    name.calibrated(stiffness(name), (restitution, calibration), &PAIR)
        .ok()
}

/// The compliant laws whose damping follows from e.
fn damped() -> impl Iterator<Item = LawName> {
    LawName::ALL.into_iter().filter(|name| {
        let law = law(*name, 0.5, Calibration::Exact);
        law.is_some_and(|law| law.is_compliant())
    })
}

/// e = 0.05, 0.10 … 1.
fn restitutions() -> impl Iterator<Item = f64> {
    (1..=20).map(|n| 0.05 * f64::from(n)).map(|e| e.min(1.0))
}
