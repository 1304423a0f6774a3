use std::f64::consts::PI;

use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{LINEAR, RATIO};
use crate::{FreePair, Parameter, oscillator};

/// Modified linear viscoelastic element: a linear spring, and a dashpot that acts on approach only.
///
/// Approach (δ̇ > 0): F = kδ + cδ̇ with c = 2ξ̄ √(k m), m the reduced mass; restitution: F = kδ. The force never pulls.
/// Source: S. Mahmoud and R. Jankowski, *Iran. J. Sci. Technol.* 35 (2011) 51.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct ModifiedLinearViscoelastic {
    /// Impact stiffness k \[N/m\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping ratio ξ̄ \[–\], ≥ 0.
    pub impact_damping_ratio: f64,
}

impl Law for ModifiedLinearViscoelastic {
    const ABOUT: About = About {
        names: &[Name {
            name: "modified_linear_viscoelastic",
            label: "Modified linear viscoelastic",
            formula: Some(("ξ = (1−e²)/(e(e(π−2)+2))", |e| (1.0 - e * e) / (e * (e * (PI - 2.0) + 2.0)))),
            citation: "Mahmoud & Jankowski, Iran. J. Sci. Technol. 35 (2011) 51",
        }],
        force: "approach kδ + cδ̇, c = 2ξ√(km); return kδ",
        relation: Some("e = exp(−ξ acos ξ/√(1−ξ²))"),
        exact: Exact::Any(oscillator::ratio),
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&LINEAR, &mut self.impact_stiffness), (&RATIO, &mut self.impact_damping_ratio)]
    }

    fn form(&self, reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let critical = 2.0 * (self.impact_stiffness * reduced_mass).sqrt();
        let dashpot = Term::new(self.impact_damping_ratio * critical, Power::Zero);
        let spring = Term::new(self.impact_stiffness, Power::One);
        Some(Form::new(spring, dashpot, Action::Approach))
    }

    fn restitution(&self) -> Option<f64> {
        Some(oscillator::given_back(self.impact_damping_ratio))
    }

    fn stored(&self) -> Option<f64> {
        self.restitution().map(|e| e * e)
    }

    fn peak_force(&self, pair: &FreePair) -> Option<f64> {
        let ratio = self.impact_damping_ratio;
        Some(oscillator::peak_force(self.impact_stiffness, ratio, pair))
    }
}
