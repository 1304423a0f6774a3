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
    /// Whether the values are accelerations although the file speaks against it: for velocities, by the code of a
    /// seismometer's channel or a header with `cm/s`; or for no shaking, by values that never change their sign.
    pub acceleration: bool,
    /// Whether numbers that stand several to a line, without names, follow one another.
    pub in_rows: bool,
}
