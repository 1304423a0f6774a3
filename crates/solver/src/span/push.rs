//! Action of pairs on floors.

/// Action of a pair on a floor over a span of the floor.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Push<'a> {
    /// Index of the pair.
    pub pair: usize,
    /// Whether the floor carries the left point, and is pushed to the left.
    pub on_left: bool,
    /// Part of the force that the floor carries \[–\], 0 < part ≤ 1.
    pub part: f64,
    /// Force of the pair at the start and at the end of the span \[N\], ≥ 0.
    pub forces: [f64; 2],
    /// Impulse of the pair over the span \[N·s\], ≥ 0.
    pub impulse: f64,
    /// Coefficients of the force \[N\] in the variable of a [`Series`](crate::Series); empty for other paths.
    pub series: &'a [f64],
}

impl Push<'_> {
    /// Share of the floor in a force of the pair \[N\], or in its impulse \[N·s\]: positive to the right.
    #[inline]
    pub fn given(&self, force: f64) -> f64 {
        let part = self.part * force;
        if self.on_left { -part } else { part }
    }

    /// Whether the pair has no effect on the floor.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.forces == [0.0, 0.0] && self.impulse == 0.0
    }
}
