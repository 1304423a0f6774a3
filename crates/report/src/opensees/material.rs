//! Contact laws as uniaxial materials of OpenSees.

use pounding_contact::ContactLaw;
use pounding_solver::Pair;

/// A uniaxial material of OpenSees.
pub(super) struct Material {
    /// Its name.
    pub(super) name: &'static str,
    /// Its parameters after the tag.
    pub(super) parameters: Vec<f64>,
    /// A word after the parameters.
    pub(super) option: Option<&'static str>,
    /// Where it differs from the law.
    pub(super) note: Option<&'static str>,
}

/// Deformation at which the spring of a gap yields \[m\]: never.
const FAR: f64 = 1e6;

/// Powers of the deformation in impact materials.
const HERTZ: f64 = 1.5;
const LINEAR: f64 = 1.0;

/// The reason why a law has no equal.
const ALLOWED: &str = "which OpenSees does not have; allowed are linear_spring, hertz, nonlinear_viscoelastic, \
                       hertz_damp, modified_kelvin: choose one of them for the check";

const KELVIN: &str = "whose clamp OpenSees does not have; --approximate takes ViscoelasticGap, which pulls at the end of \
                      every collision";

const NOT_CLAMPED: &str = "not clamped at 0 where something drives the neighbours apart faster than they met";

impl Material {
    /// The material of a pair with this reduced mass \[kg\].
    ///
    /// Its strain is the displacement of the right neighbour less that of the left one: gaps are negative.
    ///
    /// # Errors
    /// The refusal of a law without an equal names the laws that are allowed.
    #[expect(
        clippy::wildcard_enum_match_arm,
        reason = "a law is none of OpenSees until somebody finds its material"
    )]
    pub(super) fn of(pair: &Pair, reduced_mass: f64, approximate: bool) -> Result<Self, &'static str> {
        let gap = -pair.gap();
        let material = |name, parameters| Self {
            name,
            parameters,
            option: None,
            note: None,
        };
        let hertz_damp = |stiffness, factor, power| Self {
            note: (factor > 0.0).then_some(NOT_CLAMPED),
            ..material("Hertzdamp", vec![stiffness, factor, gap, power])
        };
        match pair.law {
            ContactLaw::LinearSpring(law) => {
                let k = law.impact_stiffness;
                Ok(Self {
                    option: Some("noDamage"),
                    ..material("ElasticPPGap", vec![k, -k * FAR, gap, 0.0])
                })
            }
            ContactLaw::Hertz(law) => Ok(hertz_damp(law.impact_stiffness, 0.0, HERTZ)),
            ContactLaw::NonlinearViscoelastic(law) => {
                let (stiffness, ratio) = (law.impact_stiffness, law.impact_damping_ratio);
                let parameters = vec![stiffness, ratio, reduced_mass, gap, HERTZ];
                Ok(material("JankowskiImpact", parameters))
            }
            ContactLaw::HertzDamp(law) => Ok(hertz_damp(law.impact_stiffness, law.impact_damping_factor, HERTZ)),
            ContactLaw::ModifiedKelvin(law) => Ok(hertz_damp(law.impact_stiffness, law.impact_damping_factor, LINEAR)),
            ContactLaw::KelvinVoigt(law) if approximate => {
                let critical = 2.0 * (law.impact_stiffness * reduced_mass).sqrt();
                let damping = law.impact_damping_ratio * critical;
                Ok(Self {
                    note: Some("an approximation of kelvin_voigt: it pulls at the end of every collision"),
                    ..material("ViscoelasticGap", vec![law.impact_stiffness, damping, gap])
                })
            }
            ContactLaw::KelvinVoigt(_) => Err(KELVIN),
            _ => Err(ALLOWED),
        }
    }
}
