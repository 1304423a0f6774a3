//! Largest values over time.

/// Largest values over time, of sums over structures.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Largest {
    pub(super) scale: f64,
    pub(super) identity: f64,
    pub(super) residual: f64,
    pub(super) momentum_scale: f64,
    pub(super) momentum: f64,
}

impl Largest {
    /// The larger one of each.
    pub(super) fn max(self, other: Self) -> Self {
        Self {
            scale: self.scale.max(other.scale),
            identity: self.identity.max(other.identity),
            residual: self.residual.max(other.residual),
            momentum_scale: self.momentum_scale.max(other.momentum_scale),
            momentum: self.momentum.max(other.momentum),
        }
    }
}
