//! Information from the caller that the file lacks.

use crate::AccelerationUnit;

/// `Declared` is the caller's knowledge about a file; empty by default.
///
/// The caller may repeat information of the file, but not contradict it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Declared {
    /// Unit of the accelerations.
    pub unit: Option<AccelerationUnit>,
    /// Time between two samples \[s\], above zero.
    ///
    /// For pairs of time and value with uneven times it is the step for resampling, linear between pairs.
    pub time_step: Option<f64>,
    /// The component to read: its name (see [`components`](crate::components)), a unique part of it, or its number from 1. Case does not
    /// matter.
    pub component: Option<String>,
    /// Value of a digitiser count, in [`unit`](Self::unit); not zero.
    pub per_count: Option<f64>,
    /// Whether the values are accelerations although the file suggests otherwise. A seismometer's channel or a header with `cm/s` suggests
    /// velocities; values of a single sign suggest a spectrum.
    pub acceleration: bool,
    /// Whether lines of several numbers without names are consecutive values of a single component.
    pub in_rows: bool,
}
