//! An oscillation that a step has to follow.

/// A linear oscillation that a step has to follow: of a structure, or of a pair while it touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillation {
    /// Circular frequency ω without damping \[rad/s\], > 0.
    pub angular_frequency: f64,
    /// Damping ratio ζ \[–\], ≥ 0.
    pub damping_ratio: f64,
}
