//! What can go wrong with numbers, one variant for each thing the user can put right.

/// A `RecordError` says why numbers do not make a record.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RecordError {
    /// There are no samples.
    #[error("a record needs at least one sample, none was given")]
    Empty,
    /// The time step is not a finite number above zero.
    #[error("the time step is {found} s, and must be finite and above 0 s")]
    TimeStep {
        /// Time step given \[s\].
        found: f64,
    },
    /// A sample is not finite, as given or after multiplication.
    #[error(
        "the acceleration of sample {index} (the first is 0) is {found} m/s², and must be finite"
    )]
    Sample {
        /// Index of the sample, from 0.
        index: usize,
        /// Its acceleration \[m/s²\].
        found: f64,
    },
    /// The acceleration of gravity is not a finite number above zero.
    #[error(
        "the acceleration of gravity is {found} m/s², and must be finite and above 0, such as 9.81"
    )]
    Gravity {
        /// Acceleration of gravity given \[m/s²\].
        found: f64,
    },
    /// The factor of a record is not finite.
    #[error("the factor of the record is {found}, and must be finite")]
    Factor {
        /// Factor given.
        found: f64,
    },
    /// A time step asks for more samples than fit in memory.
    #[error(
        "a time step of {time_step:?} s over {duration} s needs more than {allowed} samples; take a longer step"
    )]
    TooManySamples {
        /// Time step asked for \[s\].
        time_step: f64,
        /// Duration of the record \[s\].
        duration: f64,
        /// Largest number of samples.
        allowed: u32,
    },
}
