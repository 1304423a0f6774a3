use strum::EnumCount;

use crate::{
    Calibration, ContactLaw, FreePair, Hertz, HertzDamp, HertzDampFormula, KelvinVoigt,
    KuwabaraKono, LinearSpring, ModifiedKelvin, ModifiedLinearViscoelastic, NonlinearViscoelastic,
    PantWijeyewickrema, ParameterError, Stereomechanical,
};

/// The laws of the literature by name: a force, and a formula that chooses its damping for an e.
///
/// Four names share the force of [`HertzDamp`] and differ in the formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
pub enum LawName {
    /// See [`Stereomechanical`].
    Stereomechanical,
    /// See [`LinearSpring`].
    LinearSpring,
    /// See [`Hertz`].
    Hertz,
    /// See [`KelvinVoigt`].
    KelvinVoigt,
    /// See [`ModifiedLinearViscoelastic`].
    ModifiedLinearViscoelastic,
    /// See [`NonlinearViscoelastic`].
    NonlinearViscoelastic,
    /// [`HertzDamp`] by [`HertzDampFormula::HertzDamp`].
    HertzDamp,
    /// [`HertzDamp`] by [`HertzDampFormula::CorrectedHertzDamp`].
    CorrectedHertzDamp,
    /// [`HertzDamp`] by [`HertzDampFormula::HuntCrossley`].
    HuntCrossley,
    /// [`HertzDamp`] by [`HertzDampFormula::Gonthier`].
    Gonthier,
    /// See [`ModifiedKelvin`].
    ModifiedKelvin,
    /// See [`PantWijeyewickrema`].
    PantWijeyewickrema,
    /// See [`KuwabaraKono`].
    KuwabaraKono,
}

/// What a reader wants to know of a law before he chooses it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Description {
    /// Name, as commands spell it.
    pub name: &'static str,
    /// Force or impulse; δ the deformation, v₀ the approach speed, m the reduced mass.
    pub force: &'static str,
    /// Parameters as scene files spell them, under the name of [`ContactLaw::name`].
    pub parameters: &'static [&'static str],
    /// The literature's formula for the damping, where it gives one.
    pub formula: Option<&'static str>,
    /// Exact relation to the e delivered, where one is known.
    pub relation: Option<&'static str>,
    /// Source.
    pub citation: &'static str,
}

/// A law that cannot be calibrated as asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// A stiffness or an e out of range.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The literature gives no formula for this law.
    #[error("{law}: the literature gives no damping for an e; allowed is the exact calibration")]
    NoFormula {
        /// Name of the law.
        law: &'static str,
    },
}

const K: &str = "impact_stiffness_n_per_m";
const BETA: &str = "impact_stiffness_n_per_m1_5";
const RATIO: &str = "impact_damping_ratio";
const FACTOR: &str = "impact_damping_factor";
const BOTH_PHASES: &str = "a(1+e) = ln[(1+a)/(1−ea)]";

impl LawName {
    /// All laws, in the order in which lists print them.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Stereomechanical,
        Self::LinearSpring,
        Self::Hertz,
        Self::KelvinVoigt,
        Self::ModifiedLinearViscoelastic,
        Self::NonlinearViscoelastic,
        Self::HertzDamp,
        Self::CorrectedHertzDamp,
        Self::HuntCrossley,
        Self::Gonthier,
        Self::ModifiedKelvin,
        Self::PantWijeyewickrema,
        Self::KuwabaraKono,
    ];

    /// The law of this name, as commands spell it.
    pub fn from_name(name: &str) -> Option<Self> {
        let is_named = |law: &Self| law.description().name == name;
        Self::ALL.into_iter().find(is_named)
    }

    /// Unit of the law's stiffness; nothing for the impulsive law, which has none.
    pub fn stiffness_unit(self) -> Option<&'static str> {
        match self.description().parameters.first().copied() {
            Some(K) => Some("N/m"),
            Some(BETA) => Some("N/m^1.5"),
            _ => None,
        }
    }

    /// The law with a stiffness (in [`LawName::stiffness_unit`]) and the damping for an e in (0, 1\].
    ///
    /// The pair is looked at for [`KuwabaraKono`] alone, whose e depends on it; the stiffness is not for the impulsive law,
    /// which takes e = 0 as well. Springs without damping take e = 1 alone.
    ///
    /// # Errors
    /// [`CalibrationError`] for a stiffness or an e out of range, and where the literature has no formula.
    pub fn calibrated(
        self,
        stiffness: f64,
        (restitution, calibration): (f64, Calibration),
        pair: &FreePair,
    ) -> Result<ContactLaw, CalibrationError> {
        use ContactLaw as Law;
        let (k, e) = (stiffness, restitution);
        let law = match self {
            Self::Stereomechanical => Law::Stereomechanical(Stereomechanical { restitution }),
            Self::LinearSpring => Law::LinearSpring(LinearSpring::elastic(k, e)?),
            Self::Hertz => Law::Hertz(Hertz::elastic(k, e)?),
            Self::KelvinVoigt => Law::KelvinVoigt(KelvinVoigt::calibrated(k, e, calibration)?),
            Self::ModifiedLinearViscoelastic => Law::ModifiedLinearViscoelastic(
                ModifiedLinearViscoelastic::calibrated(k, e, calibration)?,
            ),
            Self::NonlinearViscoelastic => {
                Law::NonlinearViscoelastic(NonlinearViscoelastic::calibrated(k, e, calibration)?)
            }
            Self::HertzDamp => hertz_damp(HertzDampFormula::HertzDamp, k, e, calibration)?,
            Self::CorrectedHertzDamp => {
                hertz_damp(HertzDampFormula::CorrectedHertzDamp, k, e, calibration)?
            }
            Self::HuntCrossley => hertz_damp(HertzDampFormula::HuntCrossley, k, e, calibration)?,
            Self::Gonthier => hertz_damp(HertzDampFormula::Gonthier, k, e, calibration)?,
            Self::ModifiedKelvin => {
                Law::ModifiedKelvin(ModifiedKelvin::calibrated(k, e, calibration)?)
            }
            Self::PantWijeyewickrema => {
                Law::PantWijeyewickrema(PantWijeyewickrema::calibrated(k, e, calibration)?)
            }
            Self::KuwabaraKono => match calibration {
                Calibration::Exact => Law::KuwabaraKono(KuwabaraKono::calibrated(k, e, pair)?),
                Calibration::Literature => {
                    let law = self.description().name;
                    return Err(CalibrationError::NoFormula { law });
                }
            },
        };
        law.check()?;
        Ok(law)
    }

    /// What the law is.
    pub const fn description(self) -> Description {
        match self {
            Self::Stereomechanical => STEREOMECHANICAL,
            Self::LinearSpring => LINEAR_SPRING,
            Self::Hertz => HERTZ,
            Self::KelvinVoigt => KELVIN_VOIGT,
            Self::ModifiedLinearViscoelastic => MODIFIED_LINEAR_VISCOELASTIC,
            Self::NonlinearViscoelastic => NONLINEAR_VISCOELASTIC,
            Self::HertzDamp => HERTZ_DAMP,
            Self::CorrectedHertzDamp => CORRECTED_HERTZ_DAMP,
            Self::HuntCrossley => HUNT_CROSSLEY,
            Self::Gonthier => GONTHIER,
            Self::ModifiedKelvin => MODIFIED_KELVIN,
            Self::PantWijeyewickrema => PANT_WIJEYEWICKREMA,
            Self::KuwabaraKono => KUWABARA_KONO,
        }
    }
}

fn hertz_damp(
    formula: HertzDampFormula,
    stiffness: f64,
    restitution: f64,
    calibration: Calibration,
) -> Result<ContactLaw, ParameterError> {
    HertzDamp::calibrated(stiffness, restitution, (calibration, formula)).map(ContactLaw::HertzDamp)
}

const STEREOMECHANICAL: Description = Description {
    name: "stereomechanical",
    force: "impulse (1+e) m v₀",
    parameters: &["restitution"],
    formula: None,
    relation: Some("e"),
    citation: "W. Goldsmith, Impact (1960)",
};
const LINEAR_SPRING: Description = Description {
    name: "linear_spring",
    force: "kδ",
    parameters: &[K],
    formula: None,
    relation: Some("e = 1"),
    citation: "the elastic part of Anagnostopoulos, EESD 16 (1988) 443",
};
const HERTZ: Description = Description {
    name: "hertz",
    force: "βδ^1.5",
    parameters: &[BETA],
    formula: None,
    relation: Some("e = 1"),
    citation: "Hertz, J. reine angew. Math. 92 (1881) 156",
};
const KELVIN_VOIGT: Description = Description {
    name: "kelvin_voigt",
    force: "max(0, kδ + cδ̇), c = 2ξ√(km)",
    parameters: &[K, RATIO],
    formula: Some("ξ = −ln e/√(π² + ln²e)"),
    relation: Some("e = exp(−2ξ acos ξ/√(1−ξ²))"),
    citation: "Anagnostopoulos, EESD 16 (1988) 443",
};
const MODIFIED_LINEAR_VISCOELASTIC: Description = Description {
    name: "modified_linear_viscoelastic",
    force: "approach kδ + cδ̇, c = 2ξ√(km); return kδ",
    parameters: &[K, RATIO],
    formula: Some("ξ = (1−e²)/(e(e(π−2)+2))"),
    relation: Some("e = exp(−ξ acos ξ/√(1−ξ²))"),
    citation: "Mahmoud & Jankowski, Iran. J. Sci. Technol. 35 (2011) 51",
};
const NONLINEAR_VISCOELASTIC: Description = Description {
    name: "nonlinear_viscoelastic",
    force: "approach βδ^1.5 + cδ̇, c = 2ξ√(β√δ m); return βδ^1.5",
    parameters: &[BETA, RATIO],
    formula: Some("ξ = (9√5/2)(1−e²)/(e(e(9π−16)+16))"),
    relation: Some("e = exp(−ζ acos ζ/√(1−ζ²)), ζ = 2ξ/√5"),
    citation: "Jankowski, EESD 34 (2005) 595 and 35 (2006) 517",
};
const HERTZ_DAMP: Description = Description {
    name: "hertz_damp",
    force: "max(0, βδ^1.5 (1 + aδ̇/v₀))",
    parameters: &[BETA, FACTOR],
    formula: Some("a = 3(1−e²)/4"),
    relation: Some(BOTH_PHASES),
    citation: "Muthukumar & DesRoches, EESD 35 (2006) 811; Lankarani & Nikravesh, J. Mech. Des. 112 (1990) 369",
};
const CORRECTED_HERTZ_DAMP: Description = Description {
    name: "corrected_hertz_damp",
    formula: Some("a = 8(1−e)/(5e)"),
    citation: "Ye, Li & Zhu, EESD 38 (2009) 1135; Flores et al., Multibody Syst. Dyn. 25 (2011) 357",
    ..HERTZ_DAMP
};
const HUNT_CROSSLEY: Description = Description {
    name: "hunt_crossley",
    formula: Some("a = 3(1−e)/2"),
    citation: "Hunt & Crossley, J. Appl. Mech. 42 (1975) 440",
    ..HERTZ_DAMP
};
const GONTHIER: Description = Description {
    name: "gonthier",
    formula: Some("a = (1−e²)/e"),
    citation: "Gonthier et al., Multibody Syst. Dyn. 11 (2004) 209",
    ..HERTZ_DAMP
};
const MODIFIED_KELVIN: Description = Description {
    name: "modified_kelvin",
    force: "max(0, kδ(1 + aδ̇/v₀))",
    parameters: &[K, FACTOR],
    formula: Some("a = 3(1−e)/(2e)"),
    relation: Some(BOTH_PHASES),
    citation: "Ye, Li & Zhu, EESD 38 (2009) 1135",
};
const PANT_WIJEYEWICKREMA: Description = Description {
    name: "pant_wijeyewickrema",
    force: "approach kδ(1 + aδ̇/v₀); return kδ",
    parameters: &[K, FACTOR],
    formula: Some("a = 3(1−e²)/(2e²)"),
    relation: Some("e² = 2[1/a − ln(1+a)/a²]"),
    citation: "Pant & Wijeyewickrema, EESD 41 (2012) 1709",
};
const KUWABARA_KONO: Description = Description {
    name: "kuwabara_kono",
    force: "max(0, βδ^1.5 + A√δ δ̇)",
    parameters: &[BETA, "impact_damping_n_s_per_m1_5"],
    formula: None,
    relation: None,
    citation: "Kuwabara & Kono, Jpn. J. Appl. Phys. 26 (1987) 1230",
};
