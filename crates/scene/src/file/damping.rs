//! Viscous damping of a structure, as files give it.

use pounding_solver::Damping as SolverDamping;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice::Choice;
use super::method::is_default;

/// Viscous damping of a structure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Damping {
    /// Damping ratio ζ \[–\], ≥ 0; 0.05 is 5 %.
    Ratio(f64),
    /// Rayleigh damping c = α m + β k.
    Rayleigh {
        /// Mass coefficient α \[1/s\], ≥ 0.
        alpha_per_s: f64,
        /// Stiffness coefficient β \[s\], ≥ 0.
        beta_s: f64,
        /// Stiffness that β multiplies.
        #[serde(default, skip_serializing_if = "is_default")]
        stiffness: DampedStiffness,
    },
    /// Rayleigh damping that has these ratios at two frequencies.
    TwoFrequencies {
        /// The frequencies \[Hz\], 0 < first < second.
        frequencies_hz: [f64; 2],
        /// The damping ratio at each frequency \[–\], ≥ 0.
        ratios: [f64; 2],
        /// Stiffness that β multiplies.
        #[serde(default, skip_serializing_if = "is_default")]
        stiffness: DampedStiffness,
    },
    /// Rayleigh damping that has these ratios in two modes of a building.
    Modes {
        /// Numbers of the modes, counted from 1 for the slowest; 0 < first < second.
        modes: [usize; 2],
        /// The damping ratio in each \[–\], ≥ 0.
        ratios: [f64; 2],
        /// Stiffness that β multiplies.
        #[serde(default, skip_serializing_if = "is_default")]
        stiffness: DampedStiffness,
    },
}

/// The stiffness that β of Rayleigh damping multiplies.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DampedStiffness {
    /// That of the elastic columns, always.
    #[default]
    Initial,
    /// That of the present branch: columns that yield lose damping.
    Tangent,
}

impl Choice for Damping {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"ratio": 0.05}"#,
        r#"{"rayleigh": {"alpha_per_s": 0.57, "beta_s": 0.0014}}"#,
        r#"{"modes": {"modes": [1, 3], "ratios": [0.05, 0.05]}}"#,
        r#"{"two_frequencies": {"frequencies_hz": [1.0, 10.0], "ratios": [0.05, 0.05]}}"#,
    ];
}

impl Damping {
    /// The stiffness that β multiplies.
    pub fn stiffness(self) -> DampedStiffness {
        match self {
            Self::Ratio(_) => DampedStiffness::Initial,
            Self::Rayleigh { stiffness, .. } | Self::TwoFrequencies { stiffness, .. } | Self::Modes { stiffness, .. } => stiffness,
        }
    }

    /// Name of the choice in files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Ratio(_) => "ratio",
            Self::Rayleigh { .. } => "rayleigh",
            Self::TwoFrequencies { .. } => "two_frequencies",
            Self::Modes { .. } => "modes",
        }
    }

    /// Converts the damping for the solver. If two frequencies are out of range, which the check of a scene refuses, the structure is
    /// undamped.
    pub(super) fn to_solver(self) -> SolverDamping {
        match self {
            Self::Ratio(ratio) => SolverDamping::Ratio(ratio),
            Self::Rayleigh { alpha_per_s, beta_s, .. } => SolverDamping::Rayleigh {
                alpha: alpha_per_s,
                beta: beta_s,
            },
            Self::TwoFrequencies {
                frequencies_hz, ratios, ..
            } => SolverDamping::rayleigh_from_ratios(frequencies_hz, ratios).unwrap_or(SolverDamping::Ratio(0.0)),
            // The check of a scene refuses this for a structure of one storey, and a building finds its own coefficients.
            Self::Modes { .. } => SolverDamping::Ratio(0.0),
        }
    }
}
