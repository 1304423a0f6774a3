//! Energy that the columns of a storey store and dissipate.

use crate::{Flight, Hysteresis, Knee, Motion, Path, Series, Span};

/// The columns of a storey: f = a k d + h under a drift d; only h yields.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LedgerColumns {
    stiffness: f64,
    yield_force: f64,
    /// Stiffness a k of the elastic part \[N/m\].
    lasting: f64,
    /// Stiffness (1 − a) k of the yielding part \[N/m\].
    yielding: f64,
    /// Largest |h|, (1 − a) `f_y` \[N\].
    limit: f64,
    knee: Knee,
}

/// Rounding tolerance of dissipation, relative to the energies of the columns.
const ROUNDING: f64 = 1e-12;
/// Number of operations whose rounding is in a force h computed from f and d, and in a drift computed from two displacements.
const OPERATIONS: f64 = 8.0;

impl LedgerColumns {
    pub(super) fn new(loops: Hysteresis) -> Self {
        let part = 1.0 - loops.hardening;
        Self {
            stiffness: loops.stiffness,
            yield_force: loops.yield_force,
            lasting: loops.hardening * loops.stiffness,
            yielding: part * loops.stiffness,
            limit: part * loops.yield_force,
            // Columns that never yield have no knee: the rounding of their slip must not count.
            knee: if loops.yield_force.is_finite() { loops.knee } else { Knee::Sharp },
        }
    }

    /// The part h of a force \[N\] at a drift \[m\]; f itself without hardening.
    fn hysteretic(&self, force: f64, drift: f64) -> f64 {
        force - self.lasting * drift
    }

    /// Strain energy ½ a k d² + h²/2(1 − a)k \[J\] under a force at a drift.
    pub(super) fn strain(&self, force: f64, drift: f64) -> f64 {
        let h = self.hysteretic(force, drift);
        // Free masses have no stiffness.
        let bent = if self.yielding > 0.0 { 0.5 * h * h / self.yielding } else { 0.0 };
        bent + 0.5 * self.lasting * (drift * drift)
    }

    /// Drift over a span, and h at both of its ends.
    fn ends(&self, span: &Span<'_>, drifts: [Motion; 2]) -> (f64, [f64; 2]) {
        let [start, end] = drifts.map(|drift| drift.displacement);
        let h = [
            self.hysteretic(span.start.restoring_force, start),
            self.hysteretic(span.end.restoring_force, end),
        ];
        (end - start, h)
    }

    /// Work of h in yielding over a span, ∫ h (dd − dh/(1 − a)k) \[J\].
    #[inline]
    pub(super) fn flow(&self, span: &Span<'_>, drifts: [Motion; 2]) -> f64 {
        match self.knee {
            Knee::Sharp => self.flow_at_limit(span, drifts),
            // It has no elastic part. While it sticks, it does not move.
            Knee::Rigid => {
                let (moved, [_, last]) = self.ends(span, drifts);
                last * moved
            }
            Knee::Smooth(_) => match span.path {
                // Only the ends of a step are known.
                Path::Cubic(_) => {
                    let (_, [first, last]) = self.ends(span, drifts);
                    0.5 * (first + last) * self.slip(span, drifts)
                }
                Path::Series(_) | Path::Flight(_) => self.bending(span),
            },
        }
    }

    /// Work of h in yielding over a span for a sharp knee, at the limit \[J\].
    #[inline]
    fn flow_at_limit(&self, span: &Span<'_>, drifts: [Motion; 2]) -> f64 {
        match span.path {
            // A step yields at the limit, and only if it ends there.
            Path::Cubic(_) => {
                let [_, end] = drifts;
                let last = self.hysteretic(span.end.restoring_force, end.displacement);
                if last.abs() + self.blur(span, end) < self.limit {
                    return 0.0;
                }
                last * self.slip(span, drifts)
            }
            Path::Series(_) | Path::Flight(_) => {
                if self.yields(span) {
                    let (moved, [first, _]) = self.ends(span, drifts);
                    first * moved
                } else {
                    0.0
                }
            }
        }
    }

    /// Whether columns with a sharp knee yield in a span; unknown, and no, for a step.
    pub(super) fn yields(&self, span: &Span<'_>) -> bool {
        match span.path {
            Path::Cubic(_) => false,
            Path::Series(Series {
                restoring_force: (_, tangent),
                ..
            })
            | Path::Flight(Flight { stiffness: tangent, .. }) => tangent < self.stiffness,
        }
    }

    /// Inelastic part of the drift of a span \[m\].
    fn slip(&self, span: &Span<'_>, drifts: [Motion; 2]) -> f64 {
        let (moved, [first, last]) = self.ends(span, drifts);
        moved - (last - first) / self.yielding
    }

    /// Work of h in yielding for a motion known between its ends, from the law of the knee: h ḋ (1 − dz/dd) over time \[J\].
    ///
    /// The work of the force is not used, so that a force that violates the law leaves a residual.
    fn bending(&self, span: &Span<'_>) -> f64 {
        let Knee::Smooth(smoothness) = self.knee else {
            return 0.0;
        };
        let [taken] = span.integrate_between(span.start_time, span.end_time, |_, state, drift| {
            let h = self.hysteretic(state.restoring_force, drift.displacement);
            let direction = if drift.velocity < 0.0 { -1.0 } else { 1.0 };
            let slip = 1.0 - smoothness.slope(h / self.limit, direction);
            [h * drift.velocity * slip]
        });
        taken
    }

    /// Rounding of h at the end of a span \[N\]; 0 if f is h.
    fn blur(&self, span: &Span<'_>, end: Motion) -> f64 {
        if self.lasting > 0.0 {
            let lasting = (self.lasting * end.displacement).abs();
            OPERATIONS * f64::EPSILON * (span.end.restoring_force.abs() + lasting)
        } else {
            0.0
        }
    }

    /// Energy \[J\] that columns may give in a span after they took `earlier`.
    ///
    /// Infinite for a smooth knee with β < 1/2. It unloads softer than along the elastic line and stores more than h²/2(1 − a)k, so that it
    /// may give back energy that was booked as dissipated.
    pub(super) fn forgiven(&self, earlier: f64, span: &Span<'_>) -> f64 {
        let elastic = 0.5 * self.yield_force * self.yield_force / self.stiffness;
        ROUNDING * (earlier + elastic) + self.unknown(span)
    }

    /// Uncertainty of the dissipated energy \[J\], from the rounding of drifts and from the bend of a smooth knee within a step.
    fn unknown(&self, span: &Span<'_>) -> f64 {
        let drifts = span.drifts();
        let (_, [first, last]) = self.ends(span, drifts);
        let bend = match (self.knee, span.path) {
            (Knee::Smooth(smoothness), _) if smoothness.unloading < 0.5 => f64::INFINITY,
            // The force at which the columns slip is between those at the ends; near zero its sign is unknown.
            (Knee::Smooth(_), Path::Cubic(_)) => 0.5 * ((last - first) * self.slip(span, drifts)).abs(),
            (Knee::Smooth(_), Path::Series(_) | Path::Flight(_)) | (Knee::Sharp | Knee::Rigid, _) => 0.0,
        };
        let exact = self.lasting <= 0.0 && span.below.is_none() && self.knee == Knee::Sharp;
        if exact {
            return bend;
        }
        let drifts = drifts.map(|drift| drift.displacement.abs());
        let floor = span.start.displacement.abs() + span.end.displacement.abs();
        let reach = drifts[0] + drifts[1] + floor;
        let inelastic = if self.yielding > 0.0 { self.stiffness / self.yielding } else { 1.0 };
        let force = first.abs().max(last.abs()) * inelastic;
        bend + OPERATIONS * f64::EPSILON * force * reach
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::span::Power;
    use crate::{Bilinear, BoucWen, Hysteretic, Smoothness, State, Weighed};

    /// A span without a floor below, between two displacements, under these forces.
    fn span(drifts: [f64; 2], forces: [f64; 2], path: Path<'_>) -> Span<'_> {
        let state = |index: usize| State {
            displacement: drifts[index],
            restoring_force: forces[index],
            ..State::default()
        };
        Span {
            structure: 0,
            start_time: 0.0,
            end_time: 1.0,
            start: state(0),
            end: state(1),
            impulse_from_left: 0.0,
            impulse_from_right: 0.0,
            below: None,
            pushes: &[],
            links: &[],
            path,
        }
    }

    /// Strain energy and dissipation of columns along a path of drifts, in steps, and the work on them by the trapezoidal rule.
    fn led<Column: Hysteretic>(column: Column, drifts: impl Iterator<Item = f64>) -> [f64; 3] {
        let columns = LedgerColumns::new(column.hysteresis());
        let (mut memory, mut at) = (column.untouched(), [0.0, 0.0]);
        let (mut flow, mut work) = (0.0, 0.0);
        for drift in drifts {
            let response = column.respond(drift, memory);
            memory = response.memory;
            let span = span([at[0], drift], [at[1], response.force], Path::Cubic(Weighed::default()));
            let taken = columns.flow(&span, span.drifts());
            assert!(-taken <= columns.forgiven(flow, &span), "{drift}: {taken:e}");
            flow += taken;
            work += 0.5 * (at[1] + response.force) * (drift - at[0]);
            at = [drift, response.force];
        }
        [columns.strain(at[1], at[0]), flow, work]
    }

    /// To 30 mm, back to −30 mm and to 30 mm again, in steps of 1/n mm.
    fn there_and_back(n: i32) -> impl Iterator<Item = f64> {
        let out = (1..=30 * n).chain((-30 * n..30 * n).rev());
        out.chain(-30 * n + 1..=30 * n)
            .map(move |step| 1e-3 * f64::from(step) / f64::from(n))
    }

    #[test]
    fn reference_the_area_of_a_bilinear_loop() {
        // u_y = 10 mm: each half cycle of 60 mm slips by 40 mm at (1 − a) f_y = 900 N, and the first loading by 20 mm.
        let column = Bilinear {
            stiffness: 1e5,
            yield_force: 1e3,
            hardening: 0.1,
        };
        let [strain, flow, work] = led(column, there_and_back(1));
        assert!((flow - 900.0 * 0.1).abs() < 1e-9, "{flow}");
        let wanted = 0.5 * 1e4 * 0.03 * 0.03 + 0.5 * 900.0 * 900.0 / 9e4;
        assert!((strain - wanted).abs() < 1e-9, "{strain} {wanted}");
        assert!((work - strain - flow).abs() < 1e-9, "{work}");
    }

    #[test]
    fn order_the_steps_of_a_smooth_knee() {
        let column = |unloading| BoucWen {
            stiffness: 1e5,
            yield_force: 1e3,
            hardening: 0.1,
            smoothness: Smoothness { exponent: 2, unloading },
        };
        for unloading in [0.5, 0.8, 1.0] {
            let [_, coarse, _] = led(column(unloading), there_and_back(2));
            let [_, middle, _] = led(column(unloading), there_and_back(4));
            let [strain, fine, work] = led(column(unloading), there_and_back(8));
            let ratio = (coarse - middle) / (middle - fine);
            assert!((ratio - 4.0).abs() < 0.2, "{unloading}: {ratio}");
            // The trapezoidal rule is used on both sides, except for the part that is linear in d.
            assert!((work - strain - fine).abs() < 1e-9, "{work} {strain}");
        }
    }

    #[test]
    fn reference_flow_of_a_smooth_knee_by_its_law() {
        // A force that violates the law: h = 900 t, ḋ = 0.02, n = 2, loading: ∫ h ḋ y² dt = 900·0.02/4.
        let columns = LedgerColumns::new(Hysteresis {
            stiffness: 1e5,
            hardening: 0.0,
            yield_force: 900.0,
            knee: Knee::Smooth(Smoothness {
                exponent: 2,
                unloading: 0.7,
            }),
        });
        let path = |velocity: &'static [f64], displacement: &'static [f64], force| {
            Path::Series(Series {
                origin: 0.0,
                power: Power::One,
                end: f64::INFINITY,
                displacement,
                velocity,
                acceleration: &[],
                below: None,
                restoring_force: force,
                bent: &[],
                force_from_left: &[],
                force_from_right: &[],
            })
        };
        let loading = span([0.0, 0.02], [0.0, 900.0], path(&[0.02], &[0.0, 0.02], (0.0, 45e3)));
        let flow = columns.flow(&loading, loading.drifts());
        assert!((flow - 4.5).abs() < 1e-12, "{flow}");
        // Back along the same line, γ − β = −0.4 replaces 1, and the drift falls.
        let unloading = span([0.02, 0.0], [900.0, 0.0], path(&[-0.02], &[0.02, -0.02], (900.0, 45e3)));
        let flow = columns.flow(&unloading, unloading.drifts());
        assert!((flow - 0.4 * 4.5).abs() < 1e-12, "{flow}");
    }
}
