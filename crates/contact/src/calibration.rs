use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the damping of a law is chosen from the coefficient of restitution asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Calibration {
    /// By the formula that the law's authors give: most are approximations, and the law then delivers another e.
    Literature,
    /// By the relation that holds exactly for a free pair: the law delivers the e asked for.
    Exact,
}
