//! The formulas of a span, of one scene or of several side by side.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

/// The length of a span, for one structure.
#[derive(Clone, Copy)]
pub(crate) struct Length<N = f64> {
    /// h \[s\].
    pub(crate) whole: N,
    pub(crate) half: N,
    /// 1/(1 + h c/(2m)): the damping at the end is that of the velocity there.
    solve: N,
}

impl<N: Number> Length<N> {
    /// Of a span \[s\], with c/m of the structure \[1/s\].
    #[inline(always)]
    pub(crate) fn new(whole: N, damping: N) -> Self {
        let (half, one) = (whole.like(0.5) * whole, whole.like(1.0));
        Self {
            whole,
            half,
            solve: one / (one + half * damping),
        }
    }

    /// Displacement at the end \[m\], and velocity half way to it \[m/s\].
    #[inline(always)]
    pub(crate) fn predict(&self, [displacement, velocity, acceleration]: [N; 3]) -> [N; 2] {
        let half_way = velocity + self.half * acceleration;
        [displacement + self.whole * half_way, half_way]
    }

    /// Velocity at the end \[m/s\], from the velocity half way \[m/s\], the acceleration by column and ground at the end \[m/s²\],
    /// and what the pounding force at the end adds \[m/s\].
    #[inline(always)]
    pub(crate) fn velocity(&self, half_way: N, smooth: N, pushed: N) -> N {
        self.solve * (half_way + self.half * smooth + pushed)
    }

    /// The same where nothing pushes.
    #[inline(always)]
    pub(crate) fn free_velocity(&self, half_way: N, smooth: N) -> N {
        self.solve * (half_way + self.half * smooth)
    }
}

/// Two structures that move by quadratics.
pub(crate) struct Closing<N = f64> {
    /// Distance between them \[m\].
    pub(crate) gap: N,
    /// Rate at which it closes \[m/s\].
    pub(crate) rate: N,
    /// Half of what that gains in a second \[m/s²\].
    pub(crate) curvature: N,
}

impl<N: Number> Closing<N> {
    /// The x ≥ 0 at which rate·x + curvature·x² rises through gap ≥ 0 \[s\]; infinite where there is none.
    #[inline(always)]
    pub(crate) fn instant(&self) -> N {
        let Self {
            gap,
            rate,
            curvature,
        } = *self;
        let zero = gap.like(0.0);
        let never = gap.like(f64::INFINITY);
        let discriminant = rate * rate + gap.like(4.0) * curvature * gap;
        let misses = zero.exceeds(discriminant);
        if !N::any(!misses) {
            return never;
        }
        let root = discriminant.sqrt();
        // Of the two forms of the root, the one without cancellation. Both are 0/0 only for a path that stays in the gap.
        let rises = rate.exceeds(zero);
        let turns = curvature.exceeds(zero) & !rises;
        let mut instant = never;
        if N::any(turns) {
            let late = (root - rate) / (gap.like(2.0) * curvature);
            instant = N::select(turns, late, instant);
        }
        if N::any(rises) {
            let soon = gap.like(2.0) * gap / (rate + root);
            instant = N::select(rises, soon, instant);
        }
        N::select(misses, never, instant)
    }
}
