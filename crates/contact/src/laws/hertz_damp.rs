use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{FACTOR, HERTZ};
use crate::{Parameter, approach_damper};

/// The Hertz-damp law multiplies the force of a Hertz spring by a factor that grows with the deformation rate.
///
/// The force is F = max(0, β̄ δ^1.5 (1 + a δ̇/v₀)), and v₀ is the approach speed.
///
/// This crate has four formulas for a, each under its own name. In a free impact 1 + a δ̇/v₀ stays above 0. The max(0, …) matters only if
/// other forces drive the pair apart faster than v₀/a. A touch at less than 1 mm/s is computed with v₀ = 1 mm/s.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct HertzDamp {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping factor a \[–\], ≥ 0.
    pub impact_damping_factor: f64,
}

impl Law for HertzDamp {
    const ABOUT: About = About {
        names: &[
            Name {
                name: "hertz_damp",
                label: "Hertz-damp",
                formula: Some(("a = 3(1−e²)/4", |e| 0.75 * (1.0 - e * e))),
                citation: "Muthukumar & DesRoches, EESD 35 (2006) 811; Lankarani & Nikravesh, J. Mech. Des. 112 (1990) 369",
            },
            Name {
                name: "corrected_hertz_damp",
                label: "Corrected Hertz-damp",
                formula: Some(("a = 8(1−e)/(5e)", |e| 1.6 * (1.0 - e) / e)),
                citation: "Ye, Li & Zhu, EESD 38 (2009) 1135; Flores et al., Multibody Syst. Dyn. 25 (2011) 357",
            },
            Name {
                name: "hunt_crossley",
                label: "Hunt–Crossley",
                formula: Some(("a = 3(1−e)/2", |e| 1.5 * (1.0 - e))),
                citation: "Hunt & Crossley, J. Appl. Mech. 42 (1975) 440",
            },
            Name {
                name: "gonthier",
                label: "Gonthier",
                formula: Some(("a = (1−e²)/e", |e| (1.0 - e * e) / e)),
                citation: "Gonthier et al., Multibody Syst. Dyn. 11 (2004) 209",
            },
        ],
        force: "max(0, βδ^1.5 (1 + aδ̇/v₀))",
        relation: Some("a(1+e) = ln[(1+a)/(1−ea)]"),
        exact: Exact::Any(approach_damper::factor),
        knows_approach_speed: true,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&HERTZ, &mut self.impact_stiffness), (&FACTOR, &mut self.impact_damping_factor)]
    }

    fn form(&self, _reduced_mass: f64, approach_speed: f64) -> Option<Form> {
        let spring = Term::new(self.impact_stiffness, Power::ThreeHalves);
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
