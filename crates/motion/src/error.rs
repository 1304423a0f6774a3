//! What can go wrong, one variant for each thing the user can put right.

/// A `ReadError` says why a text was not read as a ground motion.
///
/// Lines, fields and columns are counted from 1. `found` is the start of the offending text.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReadError {
    /// The text holds nothing but blank lines and comments.
    #[error(
        "the text holds nothing but blank lines and comments; give a header followed by numbers"
    )]
    Empty,
    /// The text looks like none of the formats known.
    #[error(
        "line {line} reads {found:?}, which begins none of the formats known: \
         CSV (header `time_s,acceleration_g` or `time_s,acceleration_m_per_s2`, comments after `#`) \
         and PEER AT2 (line 4 such as `NPTS= 4000, DT= .01000 SEC`)"
    )]
    UnknownFormat {
        /// Line that is neither blank nor a comment, the first of them.
        line: usize,
        /// What that line holds.
        found: String,
    },
    /// The header of a CSV is absent or names a column that is not known.
    #[error(
        "line {line} reads {found:?}, but the header of a CSV must be `time_s,acceleration_g` \
         or `time_s,acceleration_m_per_s2`; put the one that gives the unit above the numbers"
    )]
    Columns {
        /// Line where the header should stand.
        line: usize,
        /// What stands there.
        found: String,
    },
    /// A line of a CSV does not have one time and one acceleration.
    #[error(
        "line {line} has {found} field(s), allowed are 2, the time and the acceleration; \
         write one sample to a line, with a comma between"
    )]
    FieldCount {
        /// Line of the sample.
        line: usize,
        /// Fields in that line.
        found: usize,
    },
    /// A field is not a number.
    #[error(
        "line {line}, field {field}: {found:?} is not a number; write it like -0.00640 or -.6403182E-02"
    )]
    NotANumber {
        /// Line of the field.
        line: usize,
        /// Which field of the line.
        field: usize,
        /// What the field holds.
        found: String,
    },
    /// A field is NaN or infinite, or a number too large for 64 bits.
    #[error(
        "line {line}, field {field}: {found:?} is not finite, and every number must be; \
         put a measured value there or cut the record before it"
    )]
    NotFinite {
        /// Line of the field.
        line: usize,
        /// Which field of the line.
        field: usize,
        /// What the field holds.
        found: String,
    },
    /// A CSV has too few samples to tell its time step.
    #[error(
        "{found} sample(s) found, but the time step is taken from the time column and needs at least 2"
    )]
    TooFewSamples {
        /// Samples in the file.
        found: usize,
    },
    /// A time of a CSV is not after the one before.
    #[error(
        "line {line}: the time is {found} s, allowed are times after the {allowed} s of the line before; \
         sort the lines by time and keep one of each"
    )]
    TimeOrder {
        /// Line whose time is too early.
        line: usize,
        /// Its time \[s\].
        found: f64,
        /// Time of the line before \[s\].
        allowed: f64,
    },
    /// The times of a CSV do not rise in equal steps.
    #[error(
        "line {line}: the time changes by {found} s from the line before, allowed is the {allowed} s of the other \
         lines; resample the record to equal steps or print its times with more decimals"
    )]
    UnevenTime {
        /// Line whose step stands out most.
        line: usize,
        /// Step from the line before \[s\].
        found: f64,
        /// Median step of the file \[s\].
        allowed: f64,
    },
    /// A CSV starts neither at t = 0 nor one time step later.
    #[error(
        "line {line}: the first time is {found} s, allowed are 0 s and one time step, {time_step} s; \
         shift the time column so that the record begins there"
    )]
    StartTime {
        /// Line of the first sample.
        line: usize,
        /// Its time \[s\].
        found: f64,
        /// Time step of the file \[s\].
        time_step: f64,
    },
    /// The time step is not a finite number above zero.
    #[error(
        "line {line}: the time step is {found} s, and must be finite and above 0 s; correct it there"
    )]
    TimeStep {
        /// Line that gives the time step; in a CSV the last one.
        line: usize,
        /// Time step found \[s\].
        found: f64,
    },
    /// No line of an AT2 header gives the number of samples and the time step.
    #[error(
        "no line among the first {searched} gives the number of samples and the time step; \
         write line 4 as `NPTS= 4000, DT= .01000 SEC`"
    )]
    NoCountLine {
        /// Lines that were searched.
        searched: usize,
    },
    /// The line of an AT2 header with NPTS and DT is not understood.
    #[error(
        "line {line} reads {found:?}, but must give a whole number of samples above 0 and the time step in seconds, \
         and no other number; write it as `NPTS= 4000, DT= .01000 SEC`"
    )]
    CountLine {
        /// Line with NPTS and DT.
        line: usize,
        /// What it holds.
        found: String,
    },
    /// An AT2 header names another quantity or unit than acceleration in g.
    #[error(
        "line {line} reads {found:?}, but only acceleration in units of g is read; \
         take the .AT2 file of the record"
    )]
    Quantity {
        /// Line that names the quantity or its unit.
        line: usize,
        /// What it holds.
        found: String,
    },
    /// An AT2 header names no unit.
    #[error(
        "no line above line {line} says in which unit the values are; \
         if they are in g, let line 3 read `ACCELERATION TIME HISTORY IN UNITS OF G`"
    )]
    NoUnit {
        /// Line with NPTS and DT, which ends the header.
        line: usize,
    },
    /// An AT2 file holds more or fewer values than its header declares.
    #[error(
        "the values end on line {line} after {found} of them, but the header declares {allowed}; \
         fetch the file again, or correct NPTS if the values are complete"
    )]
    SampleCount {
        /// Line with the last value, or the header's last line where there is none.
        line: usize,
        /// Values in the file.
        found: usize,
        /// Values declared by NPTS.
        allowed: usize,
    },
}

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
