use crate::form::{Action, Form, Power, Term};
use crate::free_impact::restitution;
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{HERTZ, Range};
use crate::{FreePair, Parameter, search};

/// Viscoelastic Hertz contact of Kuwabara and Kono, F = max(0, β̄ δ^1.5 + A √δ δ̇).
///
/// Without the clamp the force would pull at the end of every collision. The restitution depends on the approach speed: slow collisions are
/// more elastic, and 1 − e falls like v₀^(1/5). Source: G. Kuwabara and K. Kono, *Jpn. J. Appl. Phys.* 26 (1987) 1230.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct KuwabaraKono {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping A \[N·s/m^1.5\], ≥ 0.
    pub impact_damping: f64,
}

const DAMPING: Parameter = Parameter {
    name: "impact_damping_n_s_per_m1_5",
    unit: "N·s/m^1.5",
    meaning: "damping A of Kuwabara and Kono",
    allowed: Range::NOT_NEGATIVE,
    stiffens: true,
    usual: 1e6,
};
/// Largest damping of a calibration, in units of the free pair; it delivers e = 1.3e-4.
const MOST: f64 = 256.0;

impl Law for KuwabaraKono {
    const ABOUT: About = About {
        names: &[Name {
            name: "kuwabara_kono",
            label: "Kuwabara–Kono",
            formula: None,
            citation: "Kuwabara & Kono, Jpn. J. Appl. Phys. 26 (1987) 1230",
        }],
        force: "max(0, βδ^1.5 + A√δ δ̇)",
        relation: None,
        exact: Exact::Pair(
            damping,
            Range {
                words: "0.001 to 1",
                holds: |e| (0.001..=1.0).contains(&e),
            },
        ),
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&HERTZ, &mut self.impact_stiffness), (&DAMPING, &mut self.impact_damping)]
    }

    fn form(&self, _reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let spring = Term::new(self.impact_stiffness, Power::ThreeHalves);
        Some(Form::new(spring, Term::new(self.impact_damping, Power::Half), Action::Both))
    }
}

/// Damping A \[N·s/m^1.5\] for a stiffness \[N/m^1.5\] and an e of 0.001 to 1, found numerically in some milliseconds.
///
/// The literature derives A from the material, not from e.
fn damping(impact_stiffness: f64, asked: f64, pair: &FreePair) -> f64 {
    // Unit of A for this pair: β̄ L/v₀ with m v₀² = β̄ L^2.5. e depends on A/unit only.
    let speed = pair.approach_speed;
    let length = libm::pow(pair.reduced_mass * speed * speed / impact_stiffness, 0.4);
    let unit = impact_stiffness * length / speed;
    let delivered = |damping: f64| {
        let law = KuwabaraKono {
            impact_stiffness,
            impact_damping: damping * unit,
        };
        let form = law.form(pair.reduced_mass, speed);
        form.and_then(|form| restitution(&form, pair)).unwrap_or(0.0)
    };
    // The undamped impact is integrated in the same way as the damped one, so that e = 1 needs exactly no damping.
    let elastic = delivered(0.0);
    let lacking = |damping: f64| asked * elastic - delivered(damping);
    let mut most = 1.0;
    while lacking(most) < 0.0 && most < MOST {
        most *= 2.0;
    }
    unit * search::root(0.0, most, lacking)
}
