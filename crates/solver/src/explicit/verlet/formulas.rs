//! The formulas of a span.

/// The length of a span, for one structure.
#[derive(Clone, Copy)]
pub(super) struct Length {
    /// Half of it, h/2 \[s\].
    pub(super) half: f64,
    /// 1/(1 + h c/(2m)): the damping at the end belongs to the velocity at the end.
    solve: f64,
}

impl Length {
    /// The length of a span \[s\] for a structure with c/m \[1/s\].
    pub(super) fn new(whole: f64, damping: f64) -> Self {
        let half = 0.5 * whole;
        Self {
            half,
            solve: 1.0 / (1.0 + half * damping),
        }
    }

    /// Velocity at the end \[m/s\].
    ///
    /// It follows from the velocity at mid-span \[m/s\], the acceleration by column and ground at the end \[m/s²\], and the contribution of
    /// the pounding force at the end \[m/s\].
    pub(super) fn velocity(&self, half_way: f64, smooth: f64, pushed: f64) -> f64 {
        self.solve * (half_way + self.half * smooth + pushed)
    }
}

/// Two structures with quadratic motions.
pub(super) struct Closing {
    /// Distance between them \[m\], ≥ 0.
    pub(super) gap: f64,
    /// Rate at which it closes \[m/s\].
    pub(super) rate: f64,
    /// Half of the relative acceleration \[m/s²\].
    pub(super) curvature: f64,
}

impl Closing {
    /// Returns the x ≥ 0 at which rate·x + curvature·x² rises through the gap \[s\]; infinite if there is none.
    pub(super) fn instant(&self) -> f64 {
        let Self { gap, rate, curvature } = *self;
        let discriminant = rate * rate + 4.0 * curvature * gap;
        if discriminant < 0.0 {
            return f64::INFINITY;
        }
        let root = discriminant.sqrt();
        // The form of the root without cancellation. It is 0/0 only for a path that stays in the gap.
        if rate > 0.0 {
            2.0 * gap / (rate + root)
        } else if curvature > 0.0 {
            (root - rate) / (2.0 * curvature)
        } else {
            f64::INFINITY
        }
    }
}
