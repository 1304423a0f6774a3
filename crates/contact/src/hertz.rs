use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require, require_stiffness};
use crate::form::{Action, Form, Power, Term};

/// Hertz spring, F = β̄ δ^1.5: every collision gives all energy back.
///
/// Source: H. Hertz, *J. reine angew. Math.* 92 (1881) 156; for pounding K. T. Chau and X. X. Wei, *Earthquake Engng
/// Struct. Dyn.* 30 (2001) 633.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hertz {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m1_5")]
    pub impact_stiffness: f64,
}

impl Hertz {
    /// The spring of this stiffness \[N/m^1.5\] for the only e it has.
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
        Form {
            spring: Term {
                coefficient: self.impact_stiffness,
                power: Power::ThreeHalves,
            },
            damper: Term {
                coefficient: 0.0,
                power: Power::Zero,
            },
            action: Action::Approach,
        }
    }

    /// Checks β̄ > 0, finite.
    ///
    /// # Errors
    /// [`ParameterError`] for a β̄ out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require_stiffness("impact_stiffness_n_per_m1_5", self.impact_stiffness)
    }
}
