use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::HERTZ;
use crate::{FreePair, Parameter};

/// Hertz spring, F = β̄ δ^1.5: every collision gives all energy back.
///
/// Source: H. Hertz, *J. reine angew. Math.* 92 (1881) 156; for pounding K. T. Chau and X. X. Wei, *Earthquake Engng
/// Struct. Dyn.* 30 (2001) 633.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct Hertz {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    pub impact_stiffness: f64,
}

impl Law for Hertz {
    const ABOUT: About = About {
        names: &[Name {
            name: "hertz",
            label: "Hertz spring",
            formula: None,
            citation: "Hertz, J. reine angew. Math. 92 (1881) 156",
        }],
        force: "βδ^1.5",
        relation: Some("e = 1"),
        exact: Exact::Elastic,
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&HERTZ, &mut self.impact_stiffness)]
    }

    fn form(&self, _reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let spring = Term::new(self.impact_stiffness, Power::ThreeHalves);
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
