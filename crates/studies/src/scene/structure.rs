//! The structures of a row, as files give them.

use std::f64::consts::PI;

use pounding_solver::Oscillation;
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::json;

use super::choice::{self, Choice, also};
use crate::Damping;

/// A structure or a wall of a row.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(transform = or_empty_wall)]
pub enum Structure {
    /// A structure of one storey (single degree of freedom).
    Sdof(Sdof),
    /// A fixed wall; it moves with the ground.
    Wall,
}

/// A wall is a word, or a table of nothing: in TOML a list has tables.
fn or_empty_wall(schema: &mut schemars::Schema) {
    let nothing = json!({"type": "object", "additionalProperties": false});
    let table = json!({
        "description": "A fixed wall; it moves with the ground.",
        "type": "object",
        "properties": {"wall": nothing},
        "additionalProperties": false,
        "required": ["wall"],
    });
    also(schema, table);
}

/// A structure or a wall in the words of a file.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Named {
    Sdof(Sdof),
    Wall {},
}

impl Choice for Named {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"sdof": {"name": "tower", "mass_kg": 3e5, "period_s": 0.8, "damping": {"ratio": 0.05}}}"#,
    ];
}

impl<'de> Deserialize<'de> for Structure {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        choice::one(from).map(|named| match named {
            Named::Sdof(sdof) => Self::Sdof(sdof),
            Named::Wall {} => Self::Wall,
        })
    }
}

impl Structure {
    /// Name for tables and figures.
    pub fn name(&self) -> &str {
        match self {
            Self::Sdof(structure) => &structure.name,
            Self::Wall => "wall",
        }
    }

    /// Natural period \[s\]; nothing for a wall.
    pub fn period(&self) -> Option<f64> {
        match self {
            Self::Sdof(structure) => Some(structure.period()),
            Self::Wall => None,
        }
    }
}

/// A structure of one storey.
///
/// A file may give the period instead of the stiffness, and the yield displacement or drift ratio instead of the yield
/// force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words")]
#[schemars(with = "Words")]
pub struct Sdof {
    /// Name for tables and figures.
    pub name: String,
    /// Mass m \[kg\], > 0.
    pub mass_kg: f64,
    /// Elastic stiffness k \[N/m\], > 0.
    pub stiffness_n_per_m: f64,
    /// Viscous damping; it stays that of the elastic structure when the columns yield.
    pub damping: Damping,
    /// Yield force \[N\], > 0; absent for elastic columns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub yield_force_n: Option<f64>,
    /// Height of the mass over the ground \[m\], > 0: for drift ratios, and for Eurocode 8, which takes 0.7 of the width of a
    /// gap between neighbours of the same height.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height_m: Option<f64>,
    /// Displacement at t = 0 \[m\].
    #[serde(skip_serializing_if = "is_zero")]
    pub initial_displacement_m: f64,
    /// Velocity at t = 0 \[m/s\].
    #[serde(skip_serializing_if = "is_zero")]
    pub initial_velocity_m_per_s: f64,
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes a reference"
)]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// A structure of one storey in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct Words {
    /// Name for tables and figures.
    name: String,
    /// Mass \[kg\], > 0.
    mass_kg: f64,
    /// Elastic stiffness \[N/m\], > 0; or `period_s`.
    stiffness_n_per_m: Option<f64>,
    /// Natural period \[s\], > 0; or `stiffness_n_per_m`.
    period_s: Option<f64>,
    /// Viscous damping.
    #[serde(deserialize_with = "choice::one")]
    damping: Damping,
    /// Yield force \[N\], > 0; without it, and without a yield displacement or drift ratio, the columns stay elastic.
    yield_force_n: Option<f64>,
    /// Displacement at which the columns yield \[m\], > 0.
    yield_displacement_m: Option<f64>,
    /// The same divided by `height_m` \[–\], > 0.
    yield_drift_ratio: Option<f64>,
    /// Height of the mass over the ground \[m\], > 0: for drift ratios, and for Eurocode 8, which takes 0.7 of the width of a
    /// gap between neighbours of the same height.
    height_m: Option<f64>,
    /// Displacement at t = 0 \[m\].
    #[serde(default)]
    initial_displacement_m: f64,
    /// Velocity at t = 0 \[m/s\].
    #[serde(default)]
    initial_velocity_m_per_s: f64,
}

/// A structure that a file gives in too few or too many words.
#[derive(Debug, thiserror::Error)]
enum WordsError {
    #[error(
        "found neither `stiffness_n_per_m` nor `period_s`, allowed is one of them; add the one that is known"
    )]
    NoStiffness,
    #[error(
        "found both `stiffness_n_per_m` and `period_s`, allowed is one of them; delete the other"
    )]
    TwoStiffnesses,
    #[error(
        "found several of `yield_force_n`, `yield_displacement_m` and `yield_drift_ratio`, allowed is at most one; delete \
         the others"
    )]
    SeveralYieldPoints,
    #[error(
        "found `yield_drift_ratio` without `height_m`, which it is a part of; add the height, or give `yield_displacement_m`"
    )]
    DriftWithoutHeight,
    #[error("{field}: found {found}, allowed a finite number > 0")]
    OutOfRange { field: &'static str, found: f64 },
}

impl TryFrom<Words> for Sdof {
    type Error = WordsError;

    fn try_from(words: Words) -> Result<Self, WordsError> {
        let stiffness = words.stiffness()?;
        Ok(Self {
            stiffness_n_per_m: stiffness,
            yield_force_n: words.yield_force(stiffness)?,
            name: words.name,
            mass_kg: words.mass_kg,
            damping: words.damping,
            height_m: words.height_m,
            initial_displacement_m: words.initial_displacement_m,
            initial_velocity_m_per_s: words.initial_velocity_m_per_s,
        })
    }
}

/// What is converted must be in range here: what comes of it would not tell which field is wrong.
fn positive(field: &'static str, found: f64) -> Result<f64, WordsError> {
    if found > 0.0 && found.is_finite() {
        Ok(found)
    } else {
        Err(WordsError::OutOfRange { field, found })
    }
}

impl Words {
    fn stiffness(&self) -> Result<f64, WordsError> {
        match (self.stiffness_n_per_m, self.period_s) {
            (None, None) => Err(WordsError::NoStiffness),
            (Some(_), Some(_)) => Err(WordsError::TwoStiffnesses),
            (Some(stiffness), None) => Ok(stiffness),
            (None, Some(period)) => {
                let omega = 2.0 * PI / positive("period_s", period)?;
                Ok(positive("mass_kg", self.mass_kg)? * omega * omega)
            }
        }
    }

    fn yield_force(&self, stiffness: f64) -> Result<Option<f64>, WordsError> {
        match (
            self.yield_force_n,
            self.yield_displacement_m,
            self.yield_drift_ratio,
        ) {
            (force, None, None) => Ok(force),
            (None, Some(displacement), None) => Ok(Some(
                stiffness * positive("yield_displacement_m", displacement)?,
            )),
            (None, None, Some(ratio)) => {
                let height = self.height_m.ok_or(WordsError::DriftWithoutHeight)?;
                let height = positive("height_m", height)?;
                let displacement = positive("yield_drift_ratio", ratio)? * height;
                Ok(Some(stiffness * displacement))
            }
            _ => Err(WordsError::SeveralYieldPoints),
        }
    }
}

impl Sdof {
    /// Damping coefficient c \[N·s/m\].
    pub fn damping_coefficient(&self) -> f64 {
        self.damping
            .to_solver()
            .coefficient(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Damping ratio ζ \[–\] of the elastic structure.
    pub fn damping_ratio(&self) -> f64 {
        self.damping
            .to_solver()
            .ratio(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Ductility demand |u|/`u_y` \[–\] of a displacement \[m\], of columns that can yield.
    pub fn ductility(&self, displacement: f64) -> Option<f64> {
        self.yield_force_n
            .map(|force| displacement.abs() * self.stiffness_n_per_m / force)
    }

    /// Its free oscillation.
    pub fn oscillation(&self) -> Oscillation {
        Oscillation {
            angular_frequency: (self.stiffness_n_per_m / self.mass_kg).sqrt(),
            damping_ratio: self.damping_ratio(),
        }
    }

    /// Natural period T = 2π√(m/k) \[s\].
    pub fn period(&self) -> f64 {
        2.0 * PI * (self.mass_kg / self.stiffness_n_per_m).sqrt()
    }
}
