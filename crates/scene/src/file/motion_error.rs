//! Why a ground motion cannot be made or used as a scene asks, by the fields of the scene.

use pounding_motion::{Record, RecordError};
use pounding_text::plain;

use crate::SpectrumError;

/// A ground motion that cannot be made or used as a scene asks.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A field outside its valid range.
    #[error("{place}: found {}, allowed {allowed}", plain(*found))]
    OutOfRange {
        /// The field, for example `record.band_pass.order`.
        place: String,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A frequency that the samples do not hold.
    #[error(
        "{place}: found {} Hz, allowed is below {} Hz, half of one over the time step; lower it",
        plain(*found),
        plain(*highest)
    )]
    Frequency {
        /// The field.
        place: String,
        /// The frequency \[Hz\].
        found: f64,
        /// Half of one over the time step \[Hz\].
        highest: f64,
    },
    /// Corners of a filter that leave no band between them.
    #[error(
        "{place}: found {place}.low_hz (below it the motion is taken away) {} Hz and {place}.high_hz (above it) {} Hz, \
         allowed is the first below the second; {}",
        plain(*low),
        plain(*high),
        if low > high { "exchange them" } else { "part them" }
    )]
    Corners {
        /// The filter.
        place: String,
        /// Low corner \[Hz\].
        low: f64,
        /// High corner \[Hz\].
        high: f64,
    },
    /// A record too short for a filter that runs both ways.
    #[error(
        "{place}: found a record of {found} samples, allowed are {allowed} or more to filter forward and backward at order \
         {order}; lower {place}.order, or set {place}.causal"
    )]
    TooShort {
        /// The filter.
        place: String,
        /// Samples of the record.
        found: usize,
        /// Fewest samples that suffice.
        allowed: usize,
        /// Order of the filter.
        order: u32,
    },
    /// A time step that makes too many samples.
    #[error(
        "{place}: found {found:?}, which over {} s makes more than {most} samples, allowed is a longer step",
        plain(*duration)
    )]
    TooManySamples {
        /// The field.
        place: String,
        /// The time step \[s\].
        found: f64,
        /// Duration of the motion \[s\].
        duration: f64,
        /// Largest number of samples.
        most: usize,
    },
    /// A motion at rest that is to be scaled to a target.
    #[error("{place}: found a motion without any acceleration, allowed is one that a factor can scale; take another")]
    AtRest {
        /// What it is to be scaled to.
        place: String,
    },
    /// A target that is too far for a finite factor.
    #[error(
        "{place}: found a target that takes a factor of {}, allowed is a finite one; take a lower target, or a stronger \
         motion",
        plain(*factor)
    )]
    Factor {
        /// The target.
        place: String,
        /// The factor \[–\].
        factor: f64,
    },
    /// A sample that is no longer finite.
    #[error(
        "{place}: makes the acceleration of sample {index} (the first is 0) {} m/s², allowed are up to {:e} m/s² either way; \
         correct a unit or take a smaller number",
        plain(*found),
        Record::STRONGEST
    )]
    NotFinite {
        /// The field that does it.
        place: String,
        /// Index of the sample, from 0.
        index: usize,
        /// Its acceleration \[m/s²\].
        found: f64,
    },
    /// A motion without a sample.
    #[error("{place}: found no sample, allowed is one or more")]
    Empty {
        /// The field.
        place: String,
    },
    /// A response spectrum that is not found.
    #[error("{place}: {fault}")]
    Spectrum {
        /// The field.
        place: String,
        /// What happened.
        fault: SpectrumError,
    },
}

impl MotionError {
    /// What is wrong with a field, or a table of settings, of a scene.
    pub(crate) fn of(place: &str, error: &RecordError) -> Self {
        let place = place.to_owned();
        match *error {
            RecordError::Empty => Self::Empty { place },
            RecordError::TimeStep { found } => Self::OutOfRange {
                place: time_step(&place),
                found,
                allowed: "a finite number > 0",
            },
            RecordError::TooManySamples {
                time_step: found,
                duration,
                allowed: most,
            } => Self::TooManySamples {
                place: time_step(&place),
                found,
                duration,
                most,
            },
            RecordError::Setting { setting, found, allowed } => Self::OutOfRange {
                place: format!("{place}.{}", field(setting)),
                found,
                allowed,
            },
            RecordError::Frequency {
                setting,
                found,
                nyquist: highest,
            } => Self::Frequency {
                place: format!("{place}.{}", field(setting)),
                found,
                highest,
            },
            RecordError::Corners { low, high } => Self::Corners { place, low, high },
            RecordError::TooShort { found, allowed, order } => Self::TooShort {
                place,
                found,
                allowed,
                order,
            },
            RecordError::AllZero { .. } => Self::AtRest { place },
            RecordError::Factor { found: factor } => Self::Factor { place, factor },
            RecordError::Sample { index, found } => Self::NotFinite { place, index, found },
            RecordError::Gravity { found } => Self::OutOfRange {
                place,
                found,
                allowed: "a finite number > 0",
            },
        }
    }

    /// What is wrong with the spectral acceleration that a motion is scaled to.
    pub(crate) fn of_spectrum(place: &str, error: SpectrumError) -> Self {
        match error {
            SpectrumError::OutOfRange {
                place: setting,
                found,
                allowed,
            } => Self::OutOfRange {
                place: format!("{place}.{}", field(&setting)),
                found,
                allowed,
            },
            SpectrumError::Record(error) => Self::of(place, &error),
            fault @ (SpectrumError::Model(_) | SpectrumError::TooMany { .. } | SpectrumError::Run { .. }) => Self::Spectrum {
                place: place.to_owned(),
                fault,
            },
        }
    }
}

/// The field of the time step of a generated motion; resampling is that field itself.
fn time_step(place: &str) -> String {
    if place.ends_with("_s") {
        place.into()
    } else {
        format!("{place}.time_step_s")
    }
}

/// The field of a scene behind a setting of a filter, a formula or a spectrum.
fn field(setting: &str) -> &str {
    match setting {
        "low_corner" => "low_hz",
        "high_corner" => "high_hz",
        "amplitude" => "amplitude_m_per_s2",
        "frequency" => "frequency_hz",
        "phase" => "phase_rad",
        "duration" => "duration_s",
        "peak" => "pga_m_per_s2",
        "envelope.strong_from" => "strong_from_s",
        "envelope.strong_until" => "strong_until_s",
        "envelope.decay" => "decay_per_s",
        "cutoff" => "cutoff_hz",
        "ground.angular_frequency" => "ground.filters.angular_frequency_rad_per_s",
        "ground.damping_ratio" => "ground.filters.damping_ratio",
        "ground.high_pass_angular_frequency" => "ground.filters.high_pass_angular_frequency_rad_per_s",
        "ground.high_pass_damping_ratio" => "ground.filters.high_pass_damping_ratio",
        "periods[0]" => "period_s",
        own => own,
    }
}
