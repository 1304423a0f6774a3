//! Processing of a ground motion before it shakes a row.

use pounding_motion::{BandPass, Passes, Trend};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice::Choice;

/// What a ground motion is between its samples.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Interpolation {
    /// Straight lines between samples: a frequency f keeps sinc²(fΔt) of its amplitude.
    #[default]
    Linear,
    /// The motion without frequencies above half the sampling rate, as if zero beyond the record.
    BandLimited,
}

impl Interpolation {
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands a reference")]
    pub(crate) fn is_linear(&self) -> bool {
        *self == Self::Linear
    }
}

/// Straight line that is subtracted from a ground motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Detrend {
    /// The mean of all samples.
    Constant,
    /// The straight line of least squares.
    Linear,
}

impl Detrend {
    pub(crate) fn to_motion(self) -> Trend {
        match self {
            Self::Constant => Trend::Constant,
            Self::Linear => Trend::Linear,
        }
    }
}

/// A Butterworth band-pass filter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FilterBand {
    /// Lower corner frequency \[Hz\], > 0.
    pub low_hz: f64,
    /// Upper corner frequency \[Hz\].
    pub high_hz: f64,
    /// Order of the low-pass filter from which the band-pass is made, 1 to 10.
    #[serde(default = "four")]
    pub order: u32,
    /// Whether the filter runs only forward, from rest. By default it runs forward and backward, without delay.
    #[serde(default)]
    pub causal: bool,
}

fn four() -> u32 {
    4
}

impl FilterBand {
    pub(crate) fn to_motion(self) -> BandPass {
        BandPass {
            order: self.order,
            low_corner: self.low_hz,
            high_corner: self.high_hz,
            passes: if self.causal { Passes::Forward } else { Passes::ForwardAndBackward },
        }
    }
}

/// Target to which a ground motion is scaled.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum ScaleTo {
    /// A peak ground acceleration \[g\], ≥ 0.
    PgaG(f64),
    /// A spectral acceleration at one period.
    Sa {
        /// Period \[s\], 0 (the ground itself) or 1e-6 to 1e6.
        period_s: f64,
        /// Damping ratio \[–\]; 0.05 by default.
        #[serde(default = "five_per_cent")]
        damping_ratio: f64,
        /// Pseudo-spectral acceleration ω²·Sd \[g\], > 0.
        sa_g: f64,
    },
}

impl Choice for ScaleTo {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"pga_g": 0.4}"#,
        r#"{"sa": {"period_s": 1.0, "damping_ratio": 0.05, "sa_g": 0.35}}"#,
    ];
}

fn five_per_cent() -> f64 {
    0.05
}
