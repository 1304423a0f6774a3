//! The approach as a quarter swing of a damped oscillator, for laws with a damping ratio.
//!
//! An oscillator of damping ratio ζ that starts at its rest position with velocity v₀ first comes to rest at ωt = acos ζ/√(1−ζ²). It then
//! stores the energy of the velocity v₀ D(ζ), D = exp(−ζ acos ζ/√(1−ζ²)). For ζ > 1, acosh takes the place of acos.

use crate::FreePair;
use crate::search::root;

/// D(ζ) \[–\]: the part of the approach speed that the spring can give back at the largest deformation.
pub(crate) fn given_back(ratio: f64) -> f64 {
    libm::exp(-ratio * arc_over_chord(ratio))
}

/// Damping ratio ζ with D(ζ) = `given_back`, for `given_back` in (0, 1].
pub(crate) fn ratio(given_back: f64) -> f64 {
    let exponent = libm::log(given_back);
    // D(ζ) < 1/ζ: the root lies below 1/D.
    root(0.0, 1.0 / given_back, |ratio| ratio * arc_over_chord(ratio) + exponent)
}

/// Peak of the damped force kδ + cδ̇ during the approach of a pair \[N\].
///
/// The force swings like the deformation, ahead of it by the phase 2 acos ζ. It peaks at ωt√(1−ζ²) = 3 acos ζ − π; for ζ ≥ 1/2 this is the
/// first touch.
pub(crate) fn peak_force(stiffness: f64, ratio: f64, pair: &FreePair) -> f64 {
    let undamped = (stiffness * pair.reduced_mass).sqrt() * pair.approach_speed;
    let part = if ratio >= 0.5 {
        2.0 * ratio
    } else {
        let arc = libm::acos(ratio);
        let chord = (1.0 - ratio * ratio).sqrt();
        libm::exp(-ratio / chord * (3.0 * arc - std::f64::consts::PI))
    };
    undamped * part
}

/// acos ζ/√(1−ζ²), continued through ζ = 1 (where it is 0/0 and equals 1) as acosh ζ/√(ζ²−1).
fn arc_over_chord(zeta: f64) -> f64 {
    let below = 1.0 - zeta;
    if below.abs() < 1e-3 {
        // Σ n!/(2n+1)!! (1−ζ)^n: the first omitted term is below 1e-18 here.
        let mut sum = 0.0;
        for n in (1..=6).rev() {
            let n = f64::from(n);
            sum = (1.0 + sum) * below * n / (2.0 * n + 1.0);
        }
        1.0 + sum
    } else if below > 0.0 {
        libm::acos(zeta) / (below * (1.0 + zeta)).sqrt()
    } else {
        libm::acosh(zeta) / (-below * (1.0 + zeta)).sqrt()
    }
}
