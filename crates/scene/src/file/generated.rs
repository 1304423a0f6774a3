//! Ground motions from formulas, as scenes give them.

use std::fmt;

use pounding_motion::{Envelope, GroundFilter, HalfSinePulse, Harmonic, Record, RickerPulse, StochasticMotion};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice::{self, Choice};
use crate::settings::in_setting;
use crate::settings::out_of_range;
use pounding_text::Refused;

/// A ground motion from a formula.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Generated {
    /// Harmonic shaking a(t) = A sin(2πft + φ).
    Harmonic {
        /// Amplitude A \[m/s²\].
        amplitude_m_per_s2: f64,
        /// Frequency f \[Hz\], > 0.
        frequency_hz: f64,
        /// Phase φ \[rad\].
        #[serde(default)]
        phase_rad: f64,
        /// Number of periods over which the amplitude grows from 0, and over which it falls to 0 at the end.
        #[serde(default)]
        ramp_periods: f64,
        /// Duration \[s\], ≥ 0.
        duration_s: f64,
        /// Time between samples \[s\], > 0.
        time_step_s: f64,
    },
    /// Ricker pulse.
    Ricker {
        /// Amplitude at its middle \[m/s²\].
        amplitude_m_per_s2: f64,
        /// Frequency of the largest value of its spectrum \[Hz\], > 0.
        frequency_hz: f64,
        /// Time between samples \[s\], > 0.
        time_step_s: f64,
    },
    /// Half a sine.
    HalfSine {
        /// Amplitude \[m/s²\].
        amplitude_m_per_s2: f64,
        /// Duration of the pulse \[s\], > 0.
        duration_s: f64,
        /// Time between samples \[s\], > 0.
        time_step_s: f64,
    },
    /// Random shaking with the spectrum of the ground; a seed always gives the same motion.
    Stochastic(Stochastic),
}

/// Random shaking: noise filtered by the ground (Kanai and Tajimi, Clough and Penzien), under an envelope.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stochastic {
    /// The ground.
    #[serde(deserialize_with = "choice::one")]
    pub ground: Ground,
    /// Peak ground acceleration \[m/s²\], ≥ 0.
    pub pga_m_per_s2: f64,
    /// Start of the strong shaking \[s\], > 0; before it the motion grows like t².
    pub strong_from_s: f64,
    /// End of the strong shaking \[s\].
    pub strong_until_s: f64,
    /// Rate of decay after the strong shaking \[1/s\], > 0.
    pub decay_per_s: f64,
    /// Highest frequency \[Hz\], less than 1/(2 `time_step_s`); by default 25, or 0.8 times that limit if this is less.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cutoff_hz: Option<f64>,
    /// Duration \[s\], > 0.
    pub duration_s: f64,
    /// Time between samples \[s\], > 0.
    pub time_step_s: f64,
    /// Seed; another seed gives another motion of the same kind.
    pub seed: u64,
}

/// Default of the highest frequency \[Hz\]: what structures respond to, and its part of the highest frequency of the samples.
const USUAL_CUTOFF: f64 = 25.0;
const PART_HELD: f64 = 0.8;

/// Filters that the ground applies to white noise.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Ground {
    /// Firm ground.
    Firm,
    /// Medium ground.
    Medium,
    /// Soft ground.
    Soft,
    /// Its filters.
    Filters {
        /// Natural circular frequency of the ground \[rad/s\], > 0.
        angular_frequency_rad_per_s: f64,
        /// Damping ratio of the ground \[–\], > 0.
        damping_ratio: f64,
        /// Natural circular frequency of the high-pass filter \[rad/s\], > 0.
        high_pass_angular_frequency_rad_per_s: f64,
        /// Damping ratio of the high-pass filter \[–\], > 0.
        high_pass_damping_ratio: f64,
    },
}

impl Choice for Ground {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"filters": {"angular_frequency_rad_per_s": 15.0, "damping_ratio": 0.6, "high_pass_angular_frequency_rad_per_s": 1.5, "high_pass_damping_ratio": 0.6}}"#,
    ];
}

impl Choice for Generated {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"harmonic": {"amplitude_m_per_s2": 2.0, "frequency_hz": 1.0, "duration_s": 10.0, "time_step_s": 0.01}}"#,
        r#"{"ricker": {"amplitude_m_per_s2": 2.0, "frequency_hz": 1.0, "time_step_s": 0.01}}"#,
        r#"{"half_sine": {"amplitude_m_per_s2": 2.0, "duration_s": 0.5, "time_step_s": 0.01}}"#,
        r#"{"stochastic": {"ground": "firm", "pga_m_per_s2": 3.0, "strong_from_s": 2.0, "strong_until_s": 10.0, "decay_per_s": 0.4, "duration_s": 20.0, "time_step_s": 0.01, "seed": 1}}"#,
    ];
}

impl Ground {
    fn to_motion(self) -> GroundFilter {
        match self {
            Self::Firm => GroundFilter::FIRM,
            Self::Medium => GroundFilter::MEDIUM,
            Self::Soft => GroundFilter::SOFT,
            Self::Filters {
                angular_frequency_rad_per_s,
                damping_ratio,
                high_pass_angular_frequency_rad_per_s,
                high_pass_damping_ratio,
            } => GroundFilter {
                angular_frequency: angular_frequency_rad_per_s,
                damping_ratio,
                high_pass_angular_frequency: high_pass_angular_frequency_rad_per_s,
                high_pass_damping_ratio,
            },
        }
    }
}

impl Generated {
    /// Returns the motion \[m/s²\].
    ///
    /// # Errors
    /// Refuses a setting out of range, with the place of its field.
    pub(crate) fn record(&self) -> Result<Record, Refused> {
        self.made().map_err(|error| {
            if let Self::Stochastic(motion) = self
                && let Some(error) = motion.too_short(&error)
            {
                return error;
            }
            in_setting(&format!("record.generated.{}", self.name()), error)
        })
    }

    fn made(&self) -> Result<Record, Refused> {
        match *self {
            Self::Harmonic {
                amplitude_m_per_s2: amplitude,
                frequency_hz: frequency,
                phase_rad: phase,
                ramp_periods,
                duration_s: duration,
                time_step_s: time_step,
            } => Harmonic {
                amplitude,
                frequency,
                phase,
                ramp_periods,
                duration,
                time_step,
            }
            .record(),
            Self::Ricker {
                amplitude_m_per_s2: amplitude,
                frequency_hz: frequency,
                time_step_s: time_step,
            } => RickerPulse {
                amplitude,
                frequency,
                time_step,
            }
            .record(),
            Self::HalfSine {
                amplitude_m_per_s2: amplitude,
                duration_s: duration,
                time_step_s: time_step,
            } => HalfSinePulse {
                amplitude,
                duration,
                time_step,
            }
            .record(),
            Self::Stochastic(ref motion) => motion.to_motion().record(),
        }
    }

    /// Name as scene files spell it.
    fn name(&self) -> &'static str {
        match self {
            Self::Harmonic { .. } => "harmonic",
            Self::Ricker { .. } => "ricker",
            Self::HalfSine { .. } => "half_sine",
            Self::Stochastic(_) => "stochastic",
        }
    }
}

impl fmt::Display for Generated {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "generated: {}", self.name())
    }
}

impl Stochastic {
    /// Names the duration if the refused highest frequency is the default.
    fn too_short(&self, refused: &Refused) -> Option<Refused> {
        let of_cutoff = refused.place().field.as_ref().is_some_and(|field| field.path() == "cutoff");
        let allowed = "at least 0.04 s and 2.5 times time_step_s, a period of the usual cutoff_hz";
        let place = "record.generated.stochastic.duration_s";
        (of_cutoff && self.cutoff_hz.is_none()).then(|| out_of_range(place, self.duration_s, allowed))
    }

    fn to_motion(&self) -> StochasticMotion {
        StochasticMotion {
            ground: self.ground.to_motion(),
            peak: self.pga_m_per_s2,
            envelope: Envelope {
                strong_from: self.strong_from_s,
                strong_until: self.strong_until_s,
                decay: self.decay_per_s,
            },
            cutoff: self.cutoff_hz.unwrap_or_else(|| {
                let held = 0.5 / self.time_step_s;
                USUAL_CUTOFF.min(PART_HELD * held)
            }),
            duration: self.duration_s,
            time_step: self.time_step_s,
            seed: self.seed,
        }
    }
}
