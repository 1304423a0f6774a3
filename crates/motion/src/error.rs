//! What can go wrong with numbers, one variant for each thing the user can put right.

use pounding_text::plain;

/// Longest time step of a record \[s\].
pub(crate) const LONGEST_STEP: f64 = 1e6;
/// Largest acceleration of a record \[m/s²\], either way.
pub(crate) const STRONGEST: f64 = 1e9;

/// A `RecordError` says why numbers do not make a record.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RecordError {
    /// There are no samples.
    #[error("a record needs at least one sample, none was given")]
    Empty,
    /// The time step is not above zero, or longer than any record.
    #[error(
        "the time step is {} s, allowed are more than 0 s and up to {:e} s; correct it",
        plain(*found),
        LONGEST_STEP
    )]
    TimeStep {
        /// Time step given \[s\].
        found: f64,
    },
    /// A sample is not finite, or stronger than any ground, as given or after multiplication.
    #[error(
        "the acceleration of sample {index} (the first is 0) is {} m/s², allowed are up to {:e} m/s² either way; correct its \
         unit or its factor",
        plain(*found),
        STRONGEST
    )]
    Sample {
        /// Index of the sample, from 0.
        index: usize,
        /// Its acceleration \[m/s²\].
        found: f64,
    },
    /// The acceleration of gravity is not a finite number above zero.
    #[error(
        "the acceleration of gravity is {} m/s², and must be finite and above 0, such as 9.81",
        plain(*found)
    )]
    Gravity {
        /// Acceleration of gravity given \[m/s²\].
        found: f64,
    },
    /// The factor of a record is not finite.
    #[error("the factor of the record is {}, and must be finite", plain(*found))]
    Factor {
        /// Factor given.
        found: f64,
    },
    /// A time step asks for more samples than fit in memory.
    #[error(
        "a time step of {time_step:?} s over {} s needs more than {allowed} samples; take a longer step",
        plain(*duration)
    )]
    TooManySamples {
        /// Time step asked for \[s\].
        time_step: f64,
        /// Duration of the record \[s\].
        duration: f64,
        /// Largest number of samples.
        allowed: usize,
    },
    /// A setting of a filter or of a generated motion is out of its range.
    #[error("{setting} is {}, allowed is {allowed}", plain(*found))]
    Setting {
        /// Name of the setting.
        setting: &'static str,
        /// Its value.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A frequency is too high for the time step of the samples.
    #[error(
        "{setting} is {} Hz, allowed is below {} Hz, the highest frequency that samples of this time step \
         hold; lower it, or shorten the time step",
        plain(*found),
        plain(*nyquist)
    )]
    Frequency {
        /// Name of the setting.
        setting: &'static str,
        /// The frequency \[Hz\].
        found: f64,
        /// Half of one over the time step \[Hz\].
        nyquist: f64,
    },
    /// The corners of a band-pass filter leave no band between them.
    #[error(
        "low_corner is {} Hz and high_corner is {} Hz, allowed is a low corner below the high one; exchange or \
         part them",
        plain(*low),
        plain(*high)
    )]
    Corners {
        /// Low corner \[Hz\].
        low: f64,
        /// High corner \[Hz\].
        high: f64,
    },
    /// A record is too short for the samples that a filter reflects at its ends.
    #[error(
        "the record has {found} samples, but filtering forward and backward needs {allowed} or more at order {order}; \
         lower the order, or filter forward only"
    )]
    TooShort {
        /// Samples of the record.
        found: usize,
        /// Fewest samples that suffice.
        allowed: usize,
        /// Order of the filter.
        order: u32,
    },
    /// A record without any acceleration cannot be scaled to one.
    #[error(
        "every acceleration of the record is 0 m/s², and no factor makes {} m/s² of that",
        plain(*target)
    )]
    AllZero {
        /// Peak asked for \[m/s²\].
        target: f64,
    },
}
