use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{FACTOR, LINEAR};
use crate::{Parameter, approach_damper};

/// Element of Pant and Wijeyewickrema: a linear spring, times a factor of the rate on approach.
///
/// Approach (δ̇ > 0): F = kδ (1 + a δ̇/v₀), v₀ the approach speed; restitution: F = kδ. The force never pulls. Slower touches than 1 mm/s
/// count as touches at 1 mm/s. Source: D. R. Pant and A. C. Wijeyewickrema, *Earthquake Engng Struct. Dyn.* 41 (2012) 1709.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct PantWijeyewickrema {
    /// Impact stiffness k \[N/m\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping factor a \[–\], ≥ 0.
    pub impact_damping_factor: f64,
}

impl Law for PantWijeyewickrema {
    const ABOUT: About = About {
        names: &[Name {
            name: "pant_wijeyewickrema",
            label: "Pant–Wijeyewickrema",
            formula: Some(("a = 3(1−e²)/(2e²)", |e| 1.5 * (1.0 - e * e) / (e * e))),
            citation: "Pant & Wijeyewickrema, EESD 41 (2012) 1709",
        }],
        force: "approach kδ(1 + aδ̇/v₀); return kδ",
        relation: Some("e² = 2[1/a − ln(1+a)/a²]"),
        exact: Exact::Any(approach_damper::factor_on_approach),
        knows_approach_speed: true,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&LINEAR, &mut self.impact_stiffness), (&FACTOR, &mut self.impact_damping_factor)]
    }

    fn form(&self, _reduced_mass: f64, approach_speed: f64) -> Option<Form> {
        let spring = Term::new(self.impact_stiffness, Power::One);
        let factor = self.impact_damping_factor;
        Some(approach_damper::form(spring, factor, approach_speed, Action::Approach))
    }

    fn restitution(&self) -> Option<f64> {
        self.stored().map(f64::sqrt)
    }

    fn stored(&self) -> Option<f64> {
        Some(approach_damper::stored(self.impact_damping_factor))
    }
}
