use crate::roots::CAPACITY;
use crate::span::Expansion;
use crate::turning::{reach, sign_changes};
use crate::{Impact, Path, Recorder, Series, Span, State};

/// The value of largest magnitude, and its instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Peak {
    /// The value, with its sign.
    pub value: f64,
    /// First instant of the value \[s\].
    pub time: f64,
}

impl Peak {
    pub(super) fn take(&mut self, value: f64, time: f64) {
        if value.abs() > self.value.abs() {
            *self = Self { value, time };
        }
    }
}

/// Peaks of a floor and its storey.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StructurePeaks {
    /// Displacement \[m\].
    pub displacement: Peak,
    /// Drift of the storey below the floor \[m\]; `None` if the storey stands on the ground, so that its drift is the displacement.
    pub storey_drift: Option<Peak>,
    /// Restoring force (shear force of the storey) \[N\].
    pub restoring_force: Peak,
    /// Net pounding force \[N\]; 0 for impulsive contact.
    pub pounding_force: Peak,
    /// Gravity on the storey, which the restoring force has taken off.
    leaning: Leaning,
    /// Restoring force plus P/h times the drift \[N\].
    with_gravity: Peak,
    /// First instant at which the drift passes the unstable equilibrium \[s\]; `None` if it never does, or if there is none.
    pub unstable: Option<f64>,
}

/// Gravity on a storey.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leaning {
    /// Weight over the height of the storey P/h \[N/m\], ≥ 0.
    pub lost: f64,
    /// Drift beyond which gravity pulls more than the columns can hold \[m\], > 0; infinite if they can always hold it.
    pub unstable_at: f64,
    /// Drift at which the storey counts as fallen, which ends the run \[m\], > 0; infinite if it never does.
    pub falls_at: f64,
}

impl Default for Leaning {
    /// A storey without gravity.
    fn default() -> Self {
        Self {
            lost: 0.0,
            unstable_at: f64::INFINITY,
            falls_at: f64::INFINITY,
        }
    }
}

impl StructurePeaks {
    /// Drift of the storey below the floor \[m\], on the ground or on another floor.
    pub fn drift(&self) -> Peak {
        self.storey_drift.unwrap_or(self.displacement)
    }

    /// Force of the columns \[N\]: the restoring force without what gravity takes off.
    pub fn column_force(&self) -> Peak {
        if self.leaning.lost > 0.0 {
            self.with_gravity
        } else {
            self.restoring_force
        }
    }

    fn take(&mut self, state: &State, drift: f64, time: f64) {
        if self.leaning.lost > 0.0 {
            self.with_gravity.take(state.restoring_force + self.leaning.lost * drift, time);
        }
        self.displacement.take(state.displacement, time);
        self.restoring_force.take(state.restoring_force, time);
        self.pounding_force.take(state.pounding_force(), time);
    }

    /// Looks at the drift of a storey under gravity, with the peaks of the span; returns the instant at which the storey falls.
    fn lean(&mut self, span: &Span<'_>) -> Option<f64> {
        let Leaning { unstable_at, falls_at, .. } = self.leaning;
        let peak = self.drift();
        let reached = peak.value.abs();
        let first = |drift: f64| (reached >= (1.0 - ROUNDING) * drift).then(|| span.first_beyond(drift.min(reached), peak.time));
        if self.unstable.is_none() {
            self.unstable = first(unstable_at);
        }
        first(falls_at)
    }

    /// Updates the peaks with the drifts of a storey on another floor.
    fn take_drifts(&mut self, span: &Span<'_>) {
        let [start, end] = span.drifts().map(|drift| drift.displacement);
        let peak = self.storey_drift.get_or_insert_default();
        peak.take(start, span.start_time);
        peak.take(end, span.end_time);
    }

    /// Updates the peaks inside a span whose motion is known: at turns of the floor and of the storey, and where columns under gravity soften.
    fn take_inside(&mut self, span: &Span<'_>, series: &Series<'_>) {
        let range = [series.x(span.start_time), span.x(*series, span.end_time)];
        if !self.could_rise(series, range[1]) {
            return;
        }
        sign_changes(series.velocity, range, |x| self.take_turn(span, series, x));
        if let Some([_, below]) = series.below {
            let mut rate = [0.0; CAPACITY];
            let rate = &mut rate[..series.velocity.len()];
            rate.copy_from_slice(series.velocity);
            for (rate, below) in rate.iter_mut().zip(below) {
                *rate -= below;
            }
            sign_changes(rate, range, |x| self.take_turn(span, series, x));
        }
        if series.restoring_force.1 < 0.0 && !series.bent.is_empty() {
            self.take_softening(span, series, range);
        }
    }

    /// Updates the peak of the restoring force where gravity takes off as much as columns that yield smoothly gain, before the drift turns.
    fn take_softening(&mut self, span: &Span<'_>, series: &Series<'_>, range: [f64; 2]) {
        let coefficient = |all: &[f64], n: usize| *all.get(n).unwrap_or(&0.0);
        let force = |n: usize| {
            let below = series.below.map_or(0.0, |[below, _]| coefficient(below, n));
            series.restoring_force.1 * (coefficient(series.displacement, n) - below) + coefficient(series.bent, n)
        };
        let mut rate = [0.0; CAPACITY];
        let len = series.displacement.len().max(series.bent.len()) - 1;
        for (n, rate) in rate[..len].iter_mut().enumerate() {
            *rate = (n + 1) as f64 * force(n + 1);
        }
        sign_changes(&rate[..len], range, |x| {
            let force = series.at(x).restoring_force;
            if beyond(force, [span.start.restoring_force, span.end.restoring_force]) {
                self.restoring_force.take(force, series.time(x));
            }
        });
    }

    /// Whether a motion could exceed these peaks up to x.
    fn could_rise(&self, series: &Series<'_>, x: f64) -> bool {
        let displacement = |n: usize| *series.displacement.get(n).unwrap_or(&0.0);
        let drift = |n: usize| {
            let below = series.below.and_then(|[below, _]| below.get(n));
            displacement(n) - below.unwrap_or(&0.0)
        };
        let terms = 1..series.displacement.len();
        let changes = reach(terms.clone().map(drift), x);
        let (force, tangent) = series.restoring_force;
        let bent = reach(series.bent.iter().skip(1).copied(), x);
        let beyond = |start: f64, change: f64, peak: Peak| (1.0 + BEYOND) * (start.abs() + change) > peak.value.abs();
        beyond(displacement(0), reach(terms.map(displacement), x), self.displacement)
            || beyond(drift(0), changes, self.drift())
            || beyond(force, tangent.abs() * changes + bent, self.restoring_force)
            || (self.leaning.lost > 0.0
                && beyond(
                    force + self.leaning.lost * drift(0),
                    (tangent.abs() + self.leaning.lost) * changes + bent,
                    self.with_gravity,
                ))
    }

    /// Updates the peaks at x, a turn of the floor or of the storey, if its value is beyond both ends.
    fn take_turn(&mut self, span: &Span<'_>, series: &Series<'_>, x: f64) {
        let state = series.at(x);
        let (drift, time) = (series.drift((&state).into(), x), series.time(x));
        let ends = [span.start.displacement, span.end.displacement];
        if beyond(state.displacement, ends) {
            self.displacement.take(state.displacement, time);
        }
        // Columns that have yielded under gravity may turn at their largest force and a small drift.
        if beyond(state.restoring_force, [span.start.restoring_force, span.end.restoring_force]) {
            self.restoring_force.take(state.restoring_force, time);
        }
        let ends = span.drifts().map(|drift| drift.displacement);
        if beyond(drift.displacement, ends) {
            if self.leaning.lost > 0.0 {
                self.with_gravity
                    .take(state.restoring_force + self.leaning.lost * drift.displacement, time);
            }
            if span.below.is_some() {
                let peak = self.storey_drift.get_or_insert_default();
                peak.take(drift.displacement, time);
            }
        }
    }
}

/// Relative distance by which a turn inside a span must be beyond both ends. A turn at an end is not inside.
const BEYOND: f64 = 1e-12;

fn beyond(value: f64, ends: [f64; 2]) -> bool {
    value.abs() > (1.0 + BEYOND) * ends[0].abs().max(ends[1].abs())
}

/// Records the peaks of every floor at the ends of spans, and at turns inside spans whose motion is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Peaks {
    structures: Vec<StructurePeaks>,
    /// The first floor whose storey has fallen, and the instant \[s\].
    fallen: Option<(usize, f64)>,
}

impl Peaks {
    /// A recorder for a row of `n_structures` nodes, walls included.
    pub fn new(n_structures: usize) -> Self {
        Self {
            structures: vec![StructurePeaks::default(); n_structures],
            fallen: None,
        }
    }

    /// Also records what gravity does to the storey of every node, and ends the run when a storey has fallen.
    #[must_use]
    pub fn under_gravity(mut self, storeys: impl IntoIterator<Item = Leaning>) -> Self {
        for (peaks, leaning) in self.structures.iter_mut().zip(storeys) {
            peaks.leaning = leaning;
        }
        self
    }

    /// Peaks of a floor, by its node.
    pub fn of(&self, structure: usize) -> &StructurePeaks {
        &self.structures[structure]
    }
}

/// Part of its drift that a storey may lack when it counts as fallen \[–\]: the exact method ends a piece at this drift up to rounding.
const ROUNDING: f64 = 1e-12;

impl Recorder for Peaks {
    fn fallen(&self) -> Option<(usize, f64)> {
        self.fallen
    }

    fn falls_at(&self, structure: usize) -> f64 {
        self.structures[structure].leaning.falls_at
    }

    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        let peaks = &mut self.structures[span.structure];
        let [first, last] = span.drifts().map(|drift| drift.displacement);
        if span.start_time == 0.0 {
            peaks.take(&span.start, first, 0.0);
        } else {
            // A pounding force jumps if another neighbour hits a floor that presses a damped neighbour. So does the friction that holds a
            // floor, when a damper on it jumps: of the storey above, a contact or a link. No other quantity jumps.
            let force = span.start.pounding_force();
            peaks.pounding_force.take(force, span.start_time);
            let force = span.start.restoring_force;
            if beyond(force, [peaks.restoring_force.value; 2]) {
                peaks.restoring_force.take(force, span.start_time);
            }
        }
        match &span.path {
            Path::Series(series) => peaks.take_inside(span, series),
            // A flight turns at most once.
            Path::Flight(_) if span.start.velocity * span.end.velocity < 0.0 => {
                let mut room = Expansion::default();
                if let Path::Series(series) = &span.expanded(&mut room).path {
                    peaks.take_inside(span, series);
                }
            }
            Path::Cubic(_) | Path::Flight(_) => {}
        }
        peaks.take(&span.end, last, span.end_time);
        if span.below.is_some() {
            peaks.take_drifts(span);
        }
        if peaks.leaning.lost > 0.0 {
            let falls = peaks.lean(span);
            self.fallen = self.fallen.or(falls.map(|time| (span.structure, time)));
        }
    }

    fn impact(&mut self, _: &Impact) {}
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Motion;
    use crate::span::Power;

    /// A floor at t² − t above a floor at −0.5 m/s, for 2 s from `start`. The floor turns at 0.5 s with −0.25 m, the storey at 0.25 s with
    /// −0.0625 m.
    fn span(path: Path<'_>) -> Span<'_> {
        let motion = |displacement, velocity| Motion { displacement, velocity };
        let state = |displacement, velocity, restoring_force| State {
            displacement,
            velocity,
            restoring_force,
            ..State::default()
        };
        Span {
            structure: 0,
            start_time: 0.0,
            end_time: 0.55,
            start: state(0.0, -1.0, 0.0),
            end: state(0.55 * 0.55 - 0.55, 0.1, 10.0 * 0.55 * (0.55 - 0.5)),
            impulse_from_left: 0.0,
            impulse_from_right: 0.0,
            pushes: &[],
            links: &[],
            below: Some([motion(0.0, -0.5), motion(-0.275, -0.5)]),
            path,
        }
    }

    #[test]
    fn reference_turns_inside_a_span() {
        let mut peaks = Peaks::new(1);
        let series = Series {
            origin: 0.0,
            power: Power::One,
            end: f64::INFINITY,
            displacement: &[0.0, -1.0, 1.0],
            velocity: &[-1.0, 2.0],
            acceleration: &[2.0],
            below: Some([&[0.0, -0.5], &[-0.5]]),
            restoring_force: (0.0, 10.0),
            bent: &[],
            force_from_left: &[],
            force_from_right: &[],
        };
        peaks.span(&span(Path::Series(series)));
        let found = peaks.of(0);
        let close = |peak: Peak, value: f64, time: f64| {
            let near = (peak.value - value).abs() < 1e-15 && (peak.time - time).abs() < 1e-12;
            assert!(near, "{peak:?}, {value} at {time}");
        };
        close(found.displacement, -0.25, 0.5);
        close(found.drift(), -0.0625, 0.25);
        close(found.restoring_force, -0.625, 0.25);
    }

    #[test]
    fn limit_a_step_has_its_ends_and_the_ground_floor_its_displacement() {
        let mut peaks = Peaks::new(1);
        let step = span(Path::Cubic(crate::Weighed::default()));
        peaks.span(&step);
        let drift = 0.55 * 0.55 - 0.55 + 0.275;
        assert_eq!(peaks.of(0).drift().value.to_bits(), f64::to_bits(drift));
        let mut peaks = Peaks::new(1);
        peaks.span(&Span {
            below: None,
            pushes: &[],
            links: &[],
            ..step
        });
        assert_eq!(peaks.of(0).storey_drift, None);
        assert_eq!(peaks.of(0).drift(), peaks.of(0).displacement);
    }
}
