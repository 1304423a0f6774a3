//! What can go wrong with a file, one variant for each thing the user can put right.

mod row;
mod words;

use pounding_text::plain;

pub use row::RowError;

use crate::{AccelerationUnit, Format, Place};
use words::{before, choice, listed, numbered, several};

/// A `ReadError` says why a text was not read as a ground motion.
///
/// Lines, fields and columns are counted from 1. `found` is the start of the offending text.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReadError {
    /// The text holds nothing but blank lines and comments.
    #[error("the text holds nothing but blank lines and comments; give a header followed by numbers")]
    Empty,
    /// The file is of another kind altogether.
    #[error("the file is {what}, allowed is a record as text, SAC or miniSEED; {advice}")]
    Foreign {
        /// What it is, such as `packed by gzip`.
        what: &'static str,
        /// What to do.
        advice: &'static str,
    },
    /// The file holds bytes that no text has, and is none of the binary formats known.
    #[error(
        "the file is binary (byte {byte} is {found:#04x}) and neither SAC nor miniSEED, the binary formats that are read; \
         fetch the record as text or in one of them"
    )]
    Binary {
        /// Place of the first such byte, counted from 1.
        byte: usize,
        /// The byte.
        found: u8,
    },
    /// The text has more lines than a record.
    #[error("found {found} lines, allowed are {allowed}; cut the record to the shaking that matters")]
    TooManyLines {
        /// Its lines.
        found: usize,
        /// Most that are read.
        allowed: usize,
    },
    /// The record has more samples than can be used.
    #[error("found more samples than the {allowed} allowed; cut the record to the shaking that matters, or resample it")]
    TooManySamples {
        /// Most that are read.
        allowed: usize,
    },
    /// The text looks like none of the formats known. It is not repeated: it may be none of anybody else's business.
    #[error(
        "line {line} begins none of the formats known: {}; \
         fetch the file again in one of them, or write one number to a line",
        Format::names()
    )]
    UnknownFormat {
        /// Line that is neither blank nor a comment, the first of them.
        line: usize,
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
    /// A row of numbers is not what it should be.
    #[error(transparent)]
    Row(#[from] RowError),
    /// A CSV has too few samples to tell its time step.
    #[error("{found} sample(s) found, but the time step is taken from the time column and needs at least 2")]
    TooFewSamples {
        /// Samples in the file.
        found: usize,
    },
    /// A time of a CSV is not after the one before.
    #[error(
        "line {line}: the time is {} s, allowed are times after the {} s of the line before; \
         sort the lines by time and keep one of each",
        plain(*found),
        plain(*allowed)
    )]
    TimeOrder {
        /// Line whose time is too early.
        line: usize,
        /// Its time \[s\].
        found: f64,
        /// Time of the line before \[s\].
        allowed: f64,
    },
    /// Times do not rise in equal steps.
    #[error(
        "the times rise in uneven steps, from {} to {} s: at line {line} by {} s, where {} s are the \
         median; declare the step to which they are to be resampled, linear between them, as `time_step`, \
         or print them with more decimals",
        plain(range[0]),
        plain(range[1]),
        plain(*found),
        plain(*allowed)
    )]
    UnevenTime {
        /// Line whose step stands out most.
        line: usize,
        /// Step from the line before \[s\].
        found: f64,
        /// Median step of the file \[s\].
        allowed: f64,
        /// Shortest and longest step of the file \[s\].
        range: [f64; 2],
    },
    /// Uneven times are to be resampled to many more values than there are.
    #[error(
        "the declared `time_step` of {declared} s resamples the uneven times of the file to more than 8 values for each \
         there is; allowed is {allowed} s and more"
    )]
    FineResampling {
        /// Time step declared \[s\].
        declared: f64,
        /// Shortest time step allowed \[s\].
        allowed: f64,
    },
    /// A CSV starts neither at t = 0 nor one time step later.
    #[error(
        "line {line}: the first time is {} s, allowed are 0 s and one time step, {} s; \
         shift the time column so that the record begins there",
        plain(*found),
        plain(*time_step)
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
        "{place}: the time step is {} s, and must be finite and above 0 s; correct it there",
        plain(*found)
    )]
    TimeStep {
        /// Place that gives the time step; in a CSV the last line.
        place: Place,
        /// Time step found \[s\].
        found: f64,
    },
    /// The time step is one that no record has.
    #[error(
        "{place} gives a time step of {found:?} s, allowed are 1e-6 to 10 s: the header lacks it, or is damaged; \
         if it is right, declare the same as `time_step`"
    )]
    ImpossibleStep {
        /// Place that gives the time step.
        place: Place,
        /// Time step found \[s\].
        found: f64,
    },
    /// Times rise by whole numbers in no named unit: seconds would be a long step, milliseconds may be meant.
    #[error(
        "{place}: the times rise by {found}, and nothing states their unit; name the column `time_s` or `time_ms`, or declare \
         `time_step` as {found} or {} s",
        found / 1000.0
    )]
    TimeUnit {
        /// Place of the first time.
        place: Place,
        /// Step of the times, in their unit.
        found: f64,
    },
    /// A file says several things of its values that differ.
    #[error(
        "the file gives more than one {what}: {}; declare the right one as `{field}`, or correct the file",
        several(said)
    )]
    Several {
        /// What it is.
        what: &'static str,
        /// How a caller declares it.
        field: &'static str,
        /// What is said in which places.
        said: Vec<(Place, String)>,
    },
    /// Values never change their sign, or only rise, and nothing says that they are accelerations.
    #[error(
        "the {found} values that end at {place} {}, like a spectrum and unlike shaking, and the file does not call them \
         accelerations; take the record itself, or declare `acceleration` if they are accelerations",
        if *rises { "only rise" } else { "never change sign" }
    )]
    OneSigned {
        /// Place of the last value.
        place: Place,
        /// Number of values.
        found: usize,
        /// Whether none is below the one before.
        rises: bool,
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
    /// A file holds more or fewer values than its header declares.
    #[error(
        "the values end at {place} after {found} of them{}, but the header declares {allowed}; \
         fetch the file again, or correct the header if the values are complete",
        before(next.as_ref())
    )]
    SampleCount {
        /// Place of the last value, or the header's last line where there is none.
        place: Place,
        /// Values in the file.
        found: usize,
        /// Values declared by the header.
        allowed: usize,
        /// The line at which they end, and what it reads; nothing where there is none.
        next: Option<(usize, String)>,
    },
    /// The largest value is not the peak that the header states.
    #[error(
        "{place} states a peak of {stated:?}, but the largest value read is {} {}; \
         one of them is damaged or in another unit: fetch the file again",
        plain(*found),
        unit.symbol()
    )]
    Peak {
        /// Place of the peak in the header.
        place: Place,
        /// The peak as the header has it.
        stated: String,
        /// Largest value of the file, without its sign.
        found: f64,
        /// Unit of the values.
        unit: AccelerationUnit,
    },
    /// A part of a header is not what the format asks for.
    #[error("{place} reads {found:?}, but {allowed} should stand there; fetch the file again")]
    Header {
        /// Where it stands.
        place: Place,
        /// What stands there.
        found: String,
        /// What should stand there.
        allowed: &'static str,
    },
    /// No line of a header begins with a key that is needed.
    #[error("no line of the header begins with {key:?}; fetch the file again")]
    NoKey {
        /// The key.
        key: &'static str,
    },
    /// A file ends before what must follow.
    #[error("the file ends at {place}, before {allowed}; fetch it again")]
    Truncated {
        /// Last place of the file.
        place: Place,
        /// What should follow.
        allowed: &'static str,
    },
    /// A file holds something else than a history of accelerations.
    #[error("{place} reads {found:?}, but only histories of acceleration are read; take {instead}")]
    NotAcceleration {
        /// Where the file says what it holds.
        place: Place,
        /// What it says.
        found: String,
        /// What to take instead.
        instead: &'static str,
    },
    /// A file speaks for velocities: by the code of a seismometer's channel, or by a unit in its header.
    #[error(
        "{place} reads {found:?}, which speaks for velocities, and only histories of acceleration are read; take the \
         record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into \
         accelerations"
    )]
    Velocity {
        /// Where the file says so.
        place: Place,
        /// What it says.
        found: String,
    },
    /// A file names a unit that is none of an acceleration that is known.
    #[error(
        "{place} reads {found:?} and names no unit of an acceleration that is known, \
         such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"
    )]
    UnknownUnit {
        /// Where the unit stands.
        place: Place,
        /// What it reads.
        found: String,
    },
    /// A file does not state its unit, and none is declared.
    #[error(
        "the file does not say in which unit its values are; declare it as `unit`, one of {}",
        AccelerationUnit::names()
    )]
    UnitNotStated,
    /// A declared unit is not that of the file.
    #[error(
        "{place} says that the values are in {}, but {} is declared as `unit`; leave the declaration away",
        found.name(), declared.name()
    )]
    UnitContradiction {
        /// Where the file states its unit.
        place: Place,
        /// Unit of the file.
        found: AccelerationUnit,
        /// Unit declared.
        declared: AccelerationUnit,
    },
    /// A file does not state its time step, and none is declared.
    #[error("the file does not say how far apart its values are; declare it as `time_step` in seconds")]
    TimeStepNotStated,
    /// A declared time step is not that of the file.
    #[error(
        "{place} gives a time step of {} s, but {} s is declared as `time_step`; \
         leave the declaration away",
        plain(*found),
        plain(*declared)
    )]
    TimeStepContradiction {
        /// Where the file states its time step.
        place: Place,
        /// Time step of the file \[s\].
        found: f64,
        /// Time step declared \[s\].
        declared: f64,
    },
    /// A declared time step is not a finite number above zero.
    #[error(
        "the declared `time_step` is {} s, and must be finite and above 0 s",
        plain(*found)
    )]
    DeclaredTimeStep {
        /// Time step declared \[s\].
        found: f64,
    },
    /// The values are counts of a digitiser, and it is not declared what one is worth.
    #[error(
        "{place} reads {found:?}: the values are counts of a digitiser; \
         declare what one is worth as `per_count`, and in which `unit`"
    )]
    Counts {
        /// Where the file says so.
        place: Place,
        /// What it says.
        found: String,
    },
    /// A worth of counts is declared for values that have a unit.
    #[error(
        "{place} says that the values are in {}, but `per_count` is declared as {}; \
         leave it away, there are no counts to scale",
        found.name(),
        plain(*declared)
    )]
    NoCounts {
        /// Where the file states its unit.
        place: Place,
        /// Unit of the file.
        found: AccelerationUnit,
        /// Worth of a count declared.
        declared: f64,
    },
    /// A declared worth of a count cannot scale the values.
    #[error("the declared `per_count` is {found:?}, and must be finite, not 0, and keep every value finite")]
    DeclaredPerCount {
        /// Worth of a count declared.
        found: f64,
    },
    /// A file holds several components, and none is chosen.
    #[error(
        "the file holds {} components: {}; choose one by its name or its number as `component`",
        names.len(), listed(names)
    )]
    ComponentNeeded {
        /// Names of the components in their order.
        names: Vec<String>,
    },
    /// Several components have the declared one as a part of their names.
    #[error(
        "{found:?} is declared as `component` and fits {} components: {}; give more of the name, or the number",
        fitting.len(), numbered(fitting)
    )]
    AmbiguousComponent {
        /// Component declared.
        found: String,
        /// Numbers, from 1, and names of the components that it fits.
        fitting: Vec<(usize, String)>,
    },
    /// The declared component is none of the file's.
    #[error("{found:?} is declared as `component`, but the file holds {}", choice(names))]
    UnknownComponent {
        /// Component declared.
        found: String,
        /// Names of the components in their order.
        names: Vec<String>,
    },
}
