//! Largest values over time.

use std::ops::AddAssign;

/// What the balances of a floor, or of a building, leave over.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Balances {
    /// Change of kinetic energy less the works \[J\].
    pub(super) identity: f64,
    /// What the terms leave over \[J\].
    pub(super) residual: f64,
    /// Change of momentum less the impulses \[N·s\].
    pub(super) momentum: f64,
}

impl AddAssign for Balances {
    fn add_assign(&mut self, other: Self) {
        self.identity += other.identity;
        self.residual += other.residual;
        self.momentum += other.momentum;
    }
}

/// Largest values over time, of sums over buildings.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Largest {
    pub(super) scale: f64,
    pub(super) identity: f64,
    pub(super) residual: f64,
    pub(super) momentum_scale: f64,
    pub(super) momentum: f64,
}

impl Largest {
    /// Adds what the balances of a building leave, and the magnitude of its momentum.
    #[inline]
    pub(super) fn add(&mut self, left: Balances, momentum_magnitude: f64) {
        self.identity += left.identity.abs();
        self.residual += left.residual.abs();
        self.momentum += left.momentum.abs();
        self.momentum_scale += momentum_magnitude;
    }

    /// The larger one of each; what is no number stays.
    pub(super) fn max(self, other: Self) -> Self {
        Self {
            scale: larger(self.scale, other.scale),
            identity: larger(self.identity, other.identity),
            residual: larger(self.residual, other.residual),
            momentum_scale: larger(self.momentum_scale, other.momentum_scale),
            momentum: larger(self.momentum, other.momentum),
        }
    }
}

/// Of two values; unlike [`f64::max`] it keeps NaN, so that a verdict sees it.
fn larger(one: f64, other: f64) -> f64 {
    if other > one || other.is_nan() { other } else { one }
}
