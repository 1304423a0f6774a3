use crate::Parameter;
use crate::form::Form;
use crate::law::{About, Exact, Law, Name};
use crate::parameter::RESTITUTION;

/// Stereomechanical impact: momentum is kept, and the relative velocity is reversed and multiplied by e.
///
/// Source: the paper, equation (4); W. Goldsmith, *Impact* (1960). The law delivers exactly its e.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct Stereomechanical {
    /// Coefficient of restitution e \[–\], 0 (plastic) ..= 1 (elastic).
    pub restitution: f64,
}

impl Law for Stereomechanical {
    const ABOUT: About = About {
        names: &[Name {
            name: "stereomechanical",
            label: "Stereomechanical",
            formula: None,
            citation: "W. Goldsmith, Impact (1960)",
        }],
        force: "impulse (1+e) m v₀",
        relation: Some("e"),
        exact: Exact::Parameter,
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&RESTITUTION, &mut self.restitution)]
    }

    fn form(&self, _reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        None
    }

    fn restitution(&self) -> Option<f64> {
        Some(self.restitution)
    }
}

impl Stereomechanical {
    /// Impulse \[N·s\] that turns an approach at `rate` δ̇ \[m/s\] into a separation at e·δ̇.
    ///
    /// Precondition: `rate` > 0; a pair that separates does not collide.
    pub fn impulse(&self, rate: f64, reduced_mass: f64) -> f64 {
        (1.0 + self.restitution) * reduced_mass * rate
    }
}
