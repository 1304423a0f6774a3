use crate::form::{Action, Form, Power, Slope, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{LINEAR, Parameter, Range};
use crate::{FreeImpact, FreePair};

/// Elastic bumper of two slopes: F = k₁δ up to the deformation d₁, then k₁d₁ + k₂(δ − d₁).
///
/// Rubber and foam between buildings first deform softly and become stiff once their pores close (densification). Every collision gives
/// all energy back. Source: the two branches of a compressed cellular solid, L. J. Gibson and M. F. Ashby, *Cellular Solids*, 2nd ed.,
/// Cambridge University Press (1997), chapter 5.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct TwoSlopes {
    /// Impact stiffness k₁ of the first slope \[N/m\], > 0.
    pub impact_stiffness: f64,
    /// Impact stiffness k₂ of the second slope \[N/m\], > 0.
    pub second_stiffness: f64,
    /// Deformation d₁ at which the second slope begins \[m\], > 0.
    pub second_from: f64,
}

const SECOND_STIFFNESS: Parameter = Parameter {
    name: "second_stiffness_n_per_m",
    unit: "N/m",
    meaning: "stiffness k₂ of the second slope",
    allowed: Range::POSITIVE,
    stiffens: true,
    usual: 9.35e8,
};
const SECOND_FROM: Parameter = Parameter {
    name: "second_from_m",
    unit: "m",
    meaning: "deformation d₁ at which the second slope begins",
    allowed: Range::POSITIVE,
    stiffens: false,
    usual: 0.005,
};

impl Law for TwoSlopes {
    const ABOUT: About = About {
        names: &[Name {
            name: "two_slopes",
            label: "Two slopes",
            formula: None,
            citation: "the branches of Gibson & Ashby, Cellular Solids (1997), chapter 5",
        }],
        force: "k₁δ up to d₁, then k₁d₁ + k₂(δ−d₁)",
        relation: Some("e = 1"),
        exact: Exact::Elastic,
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![
            (&LINEAR, &mut self.impact_stiffness),
            (&SECOND_STIFFNESS, &mut self.second_stiffness),
            (&SECOND_FROM, &mut self.second_from),
        ]
    }

    fn form(&self, _reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let spring = Term::new(self.impact_stiffness, Power::One);
        let second = Slope {
            from: self.second_from,
            added: self.second_stiffness - self.impact_stiffness,
        };
        Some(Form {
            second: Some(second),
            ..Form::new(spring, Term::NONE, Action::Approach)
        })
    }

    fn restitution(&self) -> Option<f64> {
        Some(1.0)
    }

    fn stored(&self) -> Option<f64> {
        Some(1.0)
    }

    fn peak_force(&self, pair: &FreePair) -> Option<f64> {
        let form = self.form(pair.reduced_mass, pair.approach_speed)?;
        FreeImpact::of_form(&form, pair).map(|impact| impact.peak_force)
    }
}
