use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{FACTOR, LINEAR};
use crate::{Parameter, approach_damper};

/// Modified Kelvin element: a linear spring times a factor of the rate, F = max(0, kδ (1 + a δ̇/v₀)), v₀ the approach
/// speed.
///
/// In a free impact the factor stays above 0. The clamp acts only if other forces drive the pair apart faster than v₀/a. Slower touches
/// than 1 mm/s count as touches at 1 mm/s. Source: K. Ye, L. Li and H. Zhu, *Earthq. Eng. Eng. Vib.* 8 (2009) 433.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct ModifiedKelvin {
    /// Impact stiffness k \[N/m\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping factor a \[–\], ≥ 0.
    pub impact_damping_factor: f64,
}

impl Law for ModifiedKelvin {
    const ABOUT: About = About {
        names: &[Name {
            name: "modified_kelvin",
            label: "Modified Kelvin",
            formula: Some(("a = 3(1−e)/(2e)", |e| 1.5 * (1.0 - e) / e)),
            citation: "Ye, Li & Zhu, Earthq. Eng. Eng. Vib. 8 (2009) 433",
        }],
        force: "max(0, kδ(1 + aδ̇/v₀))",
        relation: Some("a(1+e) = ln[(1+a)/(1−ea)]"),
        exact: Exact::Any(approach_damper::factor),
        knows_approach_speed: true,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&LINEAR, &mut self.impact_stiffness), (&FACTOR, &mut self.impact_damping_factor)]
    }

    fn form(&self, _reduced_mass: f64, approach_speed: f64) -> Option<Form> {
        let spring = Term::new(self.impact_stiffness, Power::One);
        let factor = self.impact_damping_factor;
        Some(approach_damper::form(spring, factor, approach_speed, Action::Both))
    }

    fn restitution(&self) -> Option<f64> {
        Some(approach_damper::restitution(self.impact_damping_factor))
    }

    fn stored(&self) -> Option<f64> {
        Some(approach_damper::stored(self.impact_damping_factor))
    }
}
