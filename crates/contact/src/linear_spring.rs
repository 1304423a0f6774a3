use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require, require_stiffness};
use crate::form::{Action, Form, Power, Term};

/// Linear spring, F = kδ: every collision gives all energy back.
///
/// Source: the elastic part of S. A. Anagnostopoulos, *Earthquake Engng Struct. Dyn.* 16 (1988) 443.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearSpring {
    /// Impact stiffness k \[N/m\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m")]
    pub impact_stiffness: f64,
}

impl LinearSpring {
    /// The spring of this stiffness \[N/m\] for the only e it has.
    ///
    /// # Errors
    /// [`ParameterError`] for an e other than 1 or a stiffness out of range.
    pub fn elastic(impact_stiffness: f64, restitution: f64) -> Result<Self, ParameterError> {
        let valid = (1.0..=1.0).contains(&restitution);
        require(
            valid,
            "restitution",
            restitution,
            "1: this law has no damping",
        )?;
        let law = Self { impact_stiffness };
        law.check().map(|()| law)
    }

    /// The force as a form.
    pub fn form(&self) -> Form {
        linear(self.impact_stiffness, 0.0, Action::Approach)
    }

    /// Checks k > 0, finite.
    ///
    /// # Errors
    /// [`ParameterError`] for a k out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require_stiffness("impact_stiffness_n_per_m", self.impact_stiffness)
    }
}

/// A linear spring with a linear damper: kδ + cδ̇.
pub(crate) fn linear(stiffness: f64, damping: f64, action: Action) -> Form {
    Form {
        spring: Term {
            coefficient: stiffness,
            power: Power::One,
        },
        damper: Term {
            coefficient: damping,
            power: Power::Zero,
        },
        action,
    }
}
