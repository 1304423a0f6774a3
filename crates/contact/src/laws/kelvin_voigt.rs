use std::f64::consts::PI;

use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{LINEAR, RATIO};
use crate::{FreePair, Parameter, oscillator};

/// Kelvin–Voigt element: a linear spring beside a linear dashpot, clamped so that it never pulls.
///
/// F = max(0, kδ + cδ̇) with c = 2ξ̄ √(k m), m the reduced mass. Without the clamp the dashpot would pull at the end of every collision;
/// with the clamp the law delivers a larger e than the literature's formula states. Source: S. A. Anagnostopoulos, *Earthquake Engng
/// Struct. Dyn.* 16 (1988) 443.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct KelvinVoigt {
    /// Impact stiffness k \[N/m\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping ratio ξ̄ \[–\], ≥ 0.
    pub impact_damping_ratio: f64,
}

impl Law for KelvinVoigt {
    const ABOUT: About = About {
        names: &[Name {
            name: "kelvin_voigt",
            label: "Kelvin–Voigt",
            formula: Some(("ξ = −ln e/√(π² + ln²e)", |e| {
                let decrement = libm::log(e).abs();
                decrement / (PI * PI + decrement * decrement).sqrt()
            })),
            citation: "Anagnostopoulos, EESD 16 (1988) 443",
        }],
        force: "max(0, kδ + cδ̇), c = 2ξ√(km)",
        relation: Some("e = exp(−2ξ acos ξ/√(1−ξ²))"),
        exact: Exact::Any(|e| oscillator::ratio(e.sqrt())),
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&LINEAR, &mut self.impact_stiffness), (&RATIO, &mut self.impact_damping_ratio)]
    }

    fn form(&self, reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let critical = 2.0 * (self.impact_stiffness * reduced_mass).sqrt();
        let dashpot = Term::new(self.impact_damping_ratio * critical, Power::Zero);
        let spring = Term::new(self.impact_stiffness, Power::One);
        Some(Form::new(spring, dashpot, Action::Both))
    }

    /// The force falls to zero at twice the time of the largest deformation, and is clamped from there to the parting.
    fn restitution(&self) -> Option<f64> {
        let given_back = oscillator::given_back(self.impact_damping_ratio);
        Some(given_back * given_back)
    }

    fn stored(&self) -> Option<f64> {
        self.restitution()
    }

    fn peak_force(&self, pair: &FreePair) -> Option<f64> {
        let ratio = self.impact_damping_ratio;
        Some(oscillator::peak_force(self.impact_stiffness, ratio, pair))
    }
}
