use pounding_text::{Refused, plain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::ParameterError;

/// How the damping of a law is chosen from the coefficient of restitution asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Calibration {
    /// By the formula that the law's authors give: most are approximations, and the law then delivers another e.
    Literature,
    /// By the relation that holds exactly for a free pair: the law delivers the e asked for.
    Exact,
}

/// A law that cannot be calibrated as requested.
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

impl From<CalibrationError> for Refused {
    fn from(error: CalibrationError) -> Self {
        match error {
            CalibrationError::Parameter(error) => Self::at(error.parameter).found(plain(error.found)).allowed(error.allowed),
            CalibrationError::NoFormula { law } => {
                let none = Self::at(law).is("the literature gives no damping for an e");
                none.but("; allowed is ", "the exact calibration")
            }
        }
    }
}
