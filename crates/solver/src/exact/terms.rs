//! What rounding of an acceleration is measured by.

/// What the first coefficients of an acceleration are sums of.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Terms {
    /// Magnitude of the terms of the own forces \[N\].
    pub(super) own: f64,
    /// Sum of the magnitudes of the terms of the acceleration \[m/s²\].
    pub(super) acceleration: f64,
    /// The largest of those that storeys join with it.
    pub(super) around: f64,
    /// Magnitude of the ground acceleration and its slope.
    pub(super) ground: (f64, f64),
    /// The fastest rate of those that share the acceleration, or that storeys join, \[1/s\].
    pub(super) rate: f64,
    /// Now \[s\].
    pub(super) time: f64,
}
