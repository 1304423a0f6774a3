use crate::parameter::{HERTZ, Parameter, Range};
use crate::{About, Action, Exact, Form, Law, Name, Power, Term, approach_damper};

/// Hertz spring with a damper of the material, F = max(0, β̄ δ^1.5 (1 + 1.5 α δ̇)).
///
/// Source: D. W. Marhefka and D. E. Orin, *IEEE Trans. Syst. Man Cybern. A* 29 (1999) 566.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct MarhefkaOrin {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping α \[s/m\], ≥ 0.
    pub impact_damping: f64,
}

const DAMPING: Parameter = Parameter {
    name: "impact_damping_s_per_m",
    unit: "s/m",
    meaning: "damping α of Marhefka and Orin",
    allowed: Range::NOT_NEGATIVE,
    stiffens: false,
    usual: 1.5,
};

impl Law for MarhefkaOrin {
    const ABOUT: About = About {
        names: &[Name {
            name: "marhefka_orin",
            label: "Marhefka–Orin",
            formula: None,
            citation: "Marhefka & Orin, IEEE Trans. Syst. Man Cybern. A 29 (1999) 566",
        }],
        force: "max(0, βδ^1.5 (1 + 1.5αδ̇))",
        relation: None,
        exact: Exact::Pair(
            |_, e, pair| approach_damper::factor(e) / (1.5 * pair.approach_speed),
            Exact::ABOVE_0,
        ),
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&HERTZ, &mut self.impact_stiffness), (&DAMPING, &mut self.impact_damping)]
    }

    fn form(&self, _reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let damper = 1.5 * self.impact_damping * self.impact_stiffness;
        let spring = Term::new(self.impact_stiffness, Power::ThreeHalves);
        Some(Form::new(spring, Term::new(damper, Power::ThreeHalves), Action::Both))
    }
}
