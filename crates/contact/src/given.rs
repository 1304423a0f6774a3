//! Laws as files give them: by their damping, or by the e that they are to deliver.

use crate::{Calibration, ParameterError};

/// The damping of a law in a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Given {
    /// The damping itself.
    Damping(f64),
    /// The damping for an e, by a calibration.
    Restitution(f64, Calibration),
}

/// A law that a file gives in too few or too many words.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum GivenError {
    #[error("found neither `{0}` nor `restitution`, allowed one of them")]
    Neither(&'static str),
    #[error("found both `{0}` and `restitution`, allowed one of them")]
    Both(&'static str),
    #[error("found `calibration` without `restitution`, allowed only with it")]
    CalibrationAlone,
    #[error(transparent)]
    Parameter(#[from] ParameterError),
}

impl Given {
    /// The one choice that a file makes, for the damping of this `name`; e is delivered exactly unless it says otherwise.
    pub(crate) fn new(
        name: &'static str,
        damping: Option<f64>,
        restitution: Option<f64>,
        calibration: Option<Calibration>,
    ) -> Result<Self, GivenError> {
        match (damping, restitution) {
            (None, None) => Err(GivenError::Neither(name)),
            (Some(_), Some(_)) => Err(GivenError::Both(name)),
            (Some(_), None) if calibration.is_some() => Err(GivenError::CalibrationAlone),
            (Some(damping), None) => Ok(Self::Damping(damping)),
            (None, Some(restitution)) => Ok(Self::Restitution(
                restitution,
                calibration.unwrap_or(Calibration::Exact),
            )),
        }
    }
}

/// Reads a law of an `impact_stiffness` of this spelling and a damping, or an e for `$calibrated`.
macro_rules! given {
    ($law:ident, $stiffness:literal, $damping:ident, $calibrated:expr) => {
        #[derive(serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        #[schemars(inline)]
        struct Words {
            /// Impact stiffness in the unit that its name says, > 0.
            #[serde(rename = $stiffness)]
            impact_stiffness: f64,
            /// Impact damping, >= 0; or `restitution`.
            $damping: Option<f64>,
            /// Coefficient of restitution that the law is to deliver, more than 0, up to 1; or the damping.
            restitution: Option<f64>,
            /// How the damping follows from the restitution; without it exactly.
            calibration: Option<crate::Calibration>,
        }

        impl TryFrom<Words> for $law {
            type Error = crate::given::GivenError;

            fn try_from(words: Words) -> Result<Self, Self::Error> {
                let Words {
                    impact_stiffness,
                    $damping,
                    restitution,
                    calibration,
                } = words;
                let name = stringify!($damping);
                match crate::given::Given::new(name, $damping, restitution, calibration)? {
                    crate::given::Given::Damping($damping) => Ok(Self {
                        impact_stiffness,
                        $damping,
                    }),
                    crate::given::Given::Restitution(e, calibration) => {
                        Ok($calibrated(impact_stiffness, e, calibration)?)
                    }
                }
            }
        }
    };
}
pub(crate) use given;
