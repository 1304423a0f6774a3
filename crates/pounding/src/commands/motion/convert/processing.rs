//! The processing of a record on its way into a CSV: the options of a scene's `record`.

use clap::ValueEnum;
use pounding::scene::file::{Detrend, FilterBand, Interpolation, ScaleTo};
use pounding::text::Refused;

use crate::commands::{part_of_one, positive};

/// Three words of a target: a period, a damping ratio that may be per cent, an acceleration.
const TARGET: &str = "allowed are T in s, Z such as 0.05 or 5%, and SA in g: finite numbers >= 0";

/// The processing of a record, in this order.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(next_help_heading = "Processing")]
pub(super) struct Processing {
    /// Take away the mean or a line: constant, linear.
    #[arg(long, value_enum, value_name = "LINE", hide_possible_values = true)]
    detrend: Option<Trend>,
    /// Keep a band of frequencies [Hz], Butterworth.
    #[arg(long, num_args = 2, value_names = ["LOW", "HIGH"], allow_negative_numbers = true, value_parser = positive)]
    band_pass: Vec<f64>,
    /// Order of the filter, 1 to 10.
    #[arg(long, value_name = "N", default_value_t = 4, allow_negative_numbers = true, requires = "band_pass")]
    order: u32,
    /// Filter forward only; both ways delay nothing.
    #[arg(long, requires = "band_pass")]
    causal: bool,
    /// Band-limited between samples, with more of them.
    #[arg(long)]
    band_limited: bool,
    /// New time between samples [s].
    #[arg(long, value_name = "DT", allow_negative_numbers = true, value_parser = positive)]
    pub(super) resample: Option<f64>,
    /// Scale to a peak ground acceleration [g].
    #[arg(long, value_name = "PGA", allow_negative_numbers = true, value_parser = positive)]
    scale_to_pga: Option<f64>,
    /// Scale to Sa [g] at T [s], damping Z such as 5%.
    #[arg(long, num_args = 3, value_names = ["T", "Z", "SA"], allow_negative_numbers = true, conflicts_with = "scale_to_pga")]
    scale_to_sa: Vec<String>,
    /// Multiply.
    #[arg(
        long,
        value_name = "FACTOR",
        default_value_t = 1.0,
        allow_negative_numbers = true,
        hide_default_value = true
    )]
    pub(super) scale: f64,
    /// Change the sign: left becomes right.
    #[arg(long)]
    pub(super) reverse: bool,
}

/// A trend that is taken away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Trend {
    /// The mean of all samples.
    Constant,
    /// The straight line of least squares.
    Linear,
}

impl Processing {
    /// Whether nothing is done.
    pub(super) fn is_empty(&self) -> bool {
        let nothing = Self {
            detrend: None,
            band_pass: Vec::new(),
            order: self.order,
            causal: false,
            band_limited: false,
            resample: None,
            scale_to_pga: None,
            scale_to_sa: Vec::new(),
            scale: 1.0,
            reverse: false,
        };
        *self == nothing
    }

    pub(super) fn detrend(&self) -> Option<Detrend> {
        self.detrend.map(|trend| match trend {
            Trend::Constant => Detrend::Constant,
            Trend::Linear => Detrend::Linear,
        })
    }

    pub(super) fn interpolation(&self) -> Interpolation {
        if self.band_limited {
            Interpolation::BandLimited
        } else {
            Interpolation::Linear
        }
    }

    pub(super) fn band_pass(&self) -> Option<FilterBand> {
        let &[low_hz, high_hz] = &self.band_pass[..] else {
            return None;
        };
        Some(FilterBand {
            low_hz,
            high_hz,
            order: self.order,
            causal: self.causal,
        })
    }

    /// The target to scale to.
    ///
    /// # Errors
    /// Refuses a word that is not the number it should be: only a damping ratio may be per cent.
    pub(super) fn scale_to(&self) -> Result<Option<ScaleTo>, Refused> {
        if let Some(peak) = self.scale_to_pga {
            return Ok(Some(ScaleTo::PgaG(peak)));
        }
        let [period, damping, acceleration] = &self.scale_to_sa[..] else {
            return Ok(None);
        };
        let refused = |name: &str, word: &str| format!("--scale-to-sa: found {word:?} as {name}, {TARGET}");
        let plain = |name, word: &String| {
            let is_plain = !word.contains('%');
            let number = part_of_one(word).ok().filter(|_| is_plain);
            number.ok_or_else(|| refused(name, word))
        };
        Ok(Some(ScaleTo::Sa {
            period_s: plain("T", period)?,
            damping_ratio: part_of_one(damping).map_err(|_| refused("Z", damping))?,
            sa_g: plain("SA", acceleration)?,
        }))
    }
}
