//! What the caller says of a file that the file does not say itself.

use crate::AccelerationUnit;

/// `Declared` is what the caller knows of a file; nothing by default.
///
/// What a file says itself may be repeated, but not contradicted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Declared {
    /// Unit of the accelerations.
    pub unit: Option<AccelerationUnit>,
    /// Time between two samples \[s\], above zero.
    ///
    /// Of pairs of time and value whose times are uneven it is the step to which they are resampled, linear between pairs.
    pub time_step: Option<f64>,
    /// Which of several components is taken: its name, see [`components`](crate::components), a part of it that no other
    /// has, or its number from 1; capitals do not matter.
    pub component: Option<String>,
    /// What one count of a digitiser is worth, in [`unit`](Self::unit); not zero.
    pub per_count: Option<f64>,
    /// Whether the values are accelerations although the file suggests otherwise: a seismometer's channel or a header with
    /// `cm/s` suggests velocities, values that never change sign suggest a spectrum.
    pub acceleration: bool,
    /// Whether several numbers to a line without names are consecutive values of one component.
    pub in_rows: bool,
}
