//! Largest imbalances over time.

use std::ops::AddAssign;

/// Imbalances of a floor or of a building.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Balances {
    /// Change of kinetic energy minus the works \[J\].
    pub(super) identity: f64,
    /// Residual of the energy terms \[J\].
    pub(super) residual: f64,
    /// Change of momentum minus the impulses \[N·s\].
    pub(super) momentum: f64,
}

impl AddAssign for Balances {
    fn add_assign(&mut self, other: Self) {
        self.identity += other.identity;
        self.residual += other.residual;
        self.momentum += other.momentum;
    }
}

/// Largest values over time of sums over buildings.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Largest {
    pub(super) scale: f64,
    pub(super) identity: f64,
    pub(super) residual: f64,
    pub(super) momentum_scale: f64,
    pub(super) momentum: f64,
}

impl Largest {
    /// Adds the imbalances of a building and the magnitude of its momentum.
    #[inline]
    pub(super) fn add(&mut self, left: Balances, momentum_magnitude: f64) {
        self.identity += left.identity.abs();
        self.residual += left.residual.abs();
        self.momentum += left.momentum.abs();
        self.momentum_scale += momentum_magnitude;
    }

    /// The larger value of each; NaN stays NaN.
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

/// The larger of two values; unlike [`f64::max`] it keeps NaN, so that a verdict sees it.
fn larger(one: f64, other: f64) -> f64 {
    if other > one || other.is_nan() { other } else { one }
}
