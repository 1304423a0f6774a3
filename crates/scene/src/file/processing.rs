//! Processing of a ground motion before it shakes a row.

use pounding_motion::{BandPass, Passes, Trend};
use pounding_text::digits;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice::Choice;
use super::record::RecordUse;

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

impl RecordUse {
    /// Lists the processing of the ground motion between its source and the row, in its order; steps that change nothing are left out.
    pub fn processing(&self) -> Vec<String> {
        let detrend = self.detrend.map(|line| match line {
            Detrend::Constant => "mean taken away".into(),
            Detrend::Linear => "straight line of least squares taken away".into(),
        });
        let band = self.band_pass.map(|band| {
            let passes = if band.causal { "forward" } else { "forward and backward" };
            format!(
                "band-pass {} to {} Hz, Butterworth, order {}, {passes}",
                digits(band.low_hz),
                digits(band.high_hz),
                band.order
            )
        });
        let resampled = self.resample_s.map(|step| format!("resampled every {step} s"));
        let target = self.scale_to.map(|target| match target {
            ScaleTo::PgaG(peak) => format!("scaled to a PGA of {peak} g"),
            ScaleTo::Sa {
                period_s,
                damping_ratio,
                sa_g,
            } => format!("scaled to Sa({period_s} s, damping {damping_ratio}) = {sa_g} g"),
        });
        let needs_g = target.is_some();
        let gravity = needs_g.then(|| format!("with g = {} m/s²", self.gravity_m_per_s2));
        let one = 1.0_f64.to_bits();
        let scale = (self.scale.to_bits() != one).then(|| format!("multiplied by {}", self.scale));
        let reversed = self.reversed.then(|| "reversed".into());
        let all = [detrend, band, resampled, target, gravity, scale, reversed];
        all.into_iter().flatten().collect()
    }
}
