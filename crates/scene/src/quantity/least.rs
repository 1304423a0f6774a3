//! What the magnitude of a number counts as at least, where an error is relative to it.

use crate::{FloorQuantity, Quantity, QuantityKind, Values};

/// Least magnitude of a residual or a least opening in a relative error, as a part of the peak \[–\]: alone it may be next to nothing.
pub const LEAST_PART: f64 = 0.05;

/// Least magnitude of a transferred momentum in a relative error, as a part of the row's largest \[–\]: forces from both sides cancel up to
/// rounding.
pub const ZERO: f64 = 1e-9;

/// A first touch before this instant \[s\] is at the start: its error is relative to 1 s.
pub const AT_ONCE: f64 = 1e-9;

/// The least magnitude of a number that may be next to nothing beside a peak.
pub(crate) fn part_of(run: &Values<'_>, peak: FloorQuantity, floor: usize) -> f64 {
    LEAST_PART * run.of(peak, floor).unwrap_or(0.0).abs()
}

/// The least magnitude of a transferred momentum.
pub(crate) fn rounding_of_momenta(run: &Values<'_>) -> f64 {
    let floors = 0..run.simulation.floors().all().len();
    let momenta = floors.map(|floor| run.result.momentum.of(floor));
    ZERO * momenta.fold(0.0, f64::max)
}

impl Values<'_> {
    /// What the magnitude of a number counts as at least where an error is relative to it; 0 for most.
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn least(&self, quantity: impl Into<Quantity>, place: usize) -> f64 {
        let about = quantity.into().about();
        if let QuantityKind::Residual(peak) = about.kind {
            part_of(self, peak, place)
        } else {
            (about.least)(self, place)
        }
    }
}
