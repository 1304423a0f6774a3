//! Shared relations of laws whose damper depends on the approach speed: F = S(δ)(1 + aδ̇/v₀).
//!
//! From m δ̇ dδ̇ = −F dδ the spring stores m v₀² [φ(a) − u² φ(au)] when the rate is u v₀, with φ(x) = (x − ln(1+x))/x². This holds for
//! every spring S. At parting the spring stores nothing: φ(a) = e² φ(−ea), which is a(1+e) = ln[(1+a)/(1−ea)]. If the damper acts on
//! approach only, all stored energy comes back: e² = 2φ(a).
//!
//! Near a = 0 these formulas subtract nearly equal numbers. The form φ(x) = ½ − xψ(x) avoids this.

use crate::form::{Action, Form, Term};
use crate::search::root;

/// Arguments below this value use the series.
const SMALL: f64 = 0.25;

/// Slower touches count as touches at this speed in laws with δ̇/v₀ \[m/s\].
///
/// As v₀ → 0 the damper of such a law grows without bound. If the ground pressed together neighbours that touched at 1 µm/s, they would
/// stick for minutes. The factor was fitted to collisions at 1 cm/s and more. A pair that falls together through 0.05 µm, which is less
/// than the roughness of any face, reaches this speed. With the bound, slower touches become more and more elastic, as in real bodies. The
/// force is continuous at the bound: methods that know v₀ only to the accuracy of a step must find nearly the same force.
pub const SLOWEST_APPROACH: f64 = 1e-3;

/// The force `spring` (1 + aδ̇/v₀), with v₀ at least [`SLOWEST_APPROACH`].
pub fn form(spring: Term, factor: f64, speed: f64, action: Action) -> Form {
    let coefficient = spring.coefficient * factor / speed.max(SLOWEST_APPROACH);
    Form::new(spring, Term::new(coefficient, spring.power), action)
}

/// 2φ(a): part of the kinetic energy \[–\] that the spring stores at the largest deformation.
pub fn stored(factor: f64) -> f64 {
    if factor < SMALL {
        1.0 - 2.0 * factor * psi(factor)
    } else {
        2.0 * (factor - libm::log1p(factor)) / (factor * factor)
    }
}

/// Restitution e that a damper of both phases delivers.
pub fn restitution(factor: f64) -> f64 {
    // 1 − ea > 0: the force of a free impact never falls to zero before the parting.
    let most = if factor > 1.0 { 1.0 / factor } else { 1.0 };
    root(0.0, most, |restitution| balance(factor, restitution))
}

/// Factor a with which a damper of both phases delivers e, for e in (0, 1].
pub fn factor(restitution: f64) -> f64 {
    root(0.0, 1.0 / restitution, |factor| balance(factor, restitution))
}

/// Factor a with which a damper that acts on approach only delivers e, for e in (0, 1].
pub fn factor_on_approach(restitution: f64) -> f64 {
    let lost = 0.5 * (1.0 - restitution) * (1.0 + restitution);
    // φ(a) < 1/a.
    let most = 2.0 / (restitution * restitution);
    root(0.0, most, |factor| factor * psi(factor) - lost)
}

/// e² φ(−ea) − φ(a), increasing in both arguments.
fn balance(factor: f64, restitution: f64) -> f64 {
    let cube = restitution * restitution * restitution;
    factor * (cube * psi(-restitution * factor) + psi(factor)) - 0.5 * (1.0 - restitution) * (1.0 + restitution)
}

/// ψ(x) = (ln(1+x) − x + x²/2)/x³. It is 1/3 at x = 0 and infinite at x = −1.
fn psi(x: f64) -> f64 {
    if x.abs() < SMALL {
        // Σ (−x)^n/(n+3): the first omitted term is below 1e-17 here.
        let mut sum = 0.0;
        for n in (0..28).rev() {
            sum = 1.0 / f64::from(n + 3) - x * sum;
        }
        sum
    } else {
        (libm::log1p(x) - x + 0.5 * x * x) / (x * x * x)
    }
}
