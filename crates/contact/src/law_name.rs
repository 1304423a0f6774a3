use pounding_text::{Refused, plain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::law::{About, Exact, Name};
use crate::parameter::RESTITUTION;
use crate::{ContactLaw, FreePair, LawName, Parameter, ParameterError};

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

impl LawName {
    /// The law with this name in commands.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|law| law.name() == name)
    }

    /// Facts about the force.
    pub fn about(self) -> &'static About {
        self.blank().about()
    }

    /// Name, formula and source.
    pub fn named(self) -> &'static Name {
        &self.about().names[self.place()]
    }

    /// Name in commands.
    pub fn name(self) -> &'static str {
        self.named().name
    }

    /// Parameters as scene files spell them, below the name of [`ContactLaw::name`].
    pub fn parameters(self) -> Vec<&'static Parameter> {
        let mut law = self.blank();
        law.parameters().into_iter().map(|(row, _)| row).collect()
    }

    /// The law's stiffness; `None` if the law is impulsive.
    pub fn stiffness(self) -> Option<&'static Parameter> {
        let is_impulsive = matches!(self.about().exact, Exact::Parameter);
        self.parameters().first().copied().filter(|_| !is_impulsive)
    }

    /// Unit of the law's stiffness.
    pub fn stiffness_unit(self) -> Option<&'static str> {
        self.stiffness().map(|stiffness| stiffness.unit)
    }

    /// Whether the law has no damping, so that its e is 1.
    pub fn is_elastic(self) -> bool {
        matches!(self.about().exact, Exact::Elastic)
    }

    /// The law with a stiffness (in [`LawName::stiffness_unit`]) and the damping for an e in (0, 1\].
    ///
    /// The pair matters only for laws whose e depends on it. The impulsive law ignores the stiffness and also accepts e = 0. Springs
    /// without damping accept only e = 1. Their other numbers are usual ones, of a law that is as stiff.
    ///
    /// # Errors
    /// [`CalibrationError`] if a stiffness or an e is out of range, or if the literature has no formula.
    pub fn calibrated(self, stiffness: f64, e: f64, calibration: Calibration, pair: &FreePair) -> Result<ContactLaw, CalibrationError> {
        let (exact, law) = (self.about().exact, self.name());
        let is_damped = matches!(exact, Exact::Any(_) | Exact::Pair(..));
        let formula = (is_damped && calibration == Calibration::Literature).then(|| {
            let formula = self.named().formula;
            formula.ok_or(CalibrationError::NoFormula { law })
        });
        let formula = formula.transpose()?;
        exact.allowed().check(RESTITUTION.name, e)?;
        let damping = match (formula, exact) {
            (Some((_, damping)), _) | (None, Exact::Any(damping)) => damping(e),
            (None, Exact::Pair(damping, _)) => damping(stiffness, e, pair),
            (None, Exact::Parameter) => e,
            (None, Exact::Elastic) => 0.0,
        };
        let law = match (self.stiffness(), exact) {
            // Numbers beside the stiffness are usual ones, of a law that is as stiff.
            (Some(usual), Exact::Elastic) => {
                let mut law = self.with(self.parameters().into_iter().map(|row| row.usual));
                law = law.stiffened(stiffness / usual.usual);
                if let Some((_, first)) = law.parameters().into_iter().next() {
                    *first = stiffness;
                }
                law
            }
            (first, _) => self.with(first.map(|_| stiffness).into_iter().chain([damping])),
        };
        law.check()?;
        Ok(law)
    }

    /// The law with these values, in the order of its parameters.
    pub(crate) fn with(self, numbers: impl IntoIterator<Item = f64>) -> ContactLaw {
        let mut law = self.blank();
        for ((_, place), number) in law.parameters().into_iter().zip(numbers) {
            *place = number;
        }
        law
    }
}
