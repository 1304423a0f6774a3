use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::LINEAR;
use crate::{FreePair, Parameter};

/// Linear spring, F = kδ: every collision gives all energy back.
///
/// Source: the elastic part of S. A. Anagnostopoulos, *Earthquake Engng Struct. Dyn.* 16 (1988) 443.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct LinearSpring {
    /// Impact stiffness k \[N/m\], > 0.
    pub impact_stiffness: f64,
}

impl Law for LinearSpring {
    const ABOUT: About = About {
        names: &[Name {
            name: "linear_spring",
            label: "Linear spring",
            formula: None,
            citation: "the elastic part of Anagnostopoulos, EESD 16 (1988) 443",
        }],
        force: "kδ",
        relation: Some("e = 1"),
        exact: Exact::Elastic,
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&LINEAR, &mut self.impact_stiffness)]
    }

    fn form(&self, _reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let spring = Term::new(self.impact_stiffness, Power::One);
        Some(Form::new(spring, Term::NONE, Action::Approach))
    }

    fn restitution(&self) -> Option<f64> {
        Some(1.0)
    }

    fn stored(&self) -> Option<f64> {
        Some(1.0)
    }

    fn peak_force(&self, pair: &FreePair) -> Option<f64> {
        let form = self.form(pair.reduced_mass, pair.approach_speed)?;
        Some(form.spring.at(pair.deformation(&form, 1.0)))
    }
}
