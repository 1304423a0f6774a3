use super::Peak;
use crate::roots::CAPACITY;
use crate::span::{Expansion, value};
use crate::turning::{reach, sign_changes};
use crate::{Excitation, Impact, Path, Recorder, Series, Span, Travel};

/// Part of a span after which its acceleration has begun to rise or fall.
const BEGUN: f64 = 1e-6;
/// Rounding factor of a value between two samples, relative to the larger of them.
const ROUNDED: f64 = 1.0 + 1e-12;

/// Records the peak absolute acceleration of every floor, ü + `a_g` \[m/s²\], which acts on contents of the floor.
///
/// Spans contain the motion relative to the ground, so that the ground acceleration is given separately. An impulsive impact has unbounded
/// acceleration and is excluded; its measure is the jump of velocity. Under compliant contact the peak is as realistic as the law's force.
/// Both ends of a span count, because accelerations jump where forces begin, and so does the largest value in between if the motion is
/// known there.
#[derive(Debug, Clone, PartialEq)]
pub struct FloorAccelerations<'a> {
    excitation: Excitation<'a>,
    /// Bound of the ground acceleration \[m/s²\]. It rules out most states without an evaluation of the ground.
    most: f64,
    /// Arrival of the ground motion at every node \[s\].
    arrivals: Vec<f64>,
    peaks: Vec<Peak>,
}

impl<'a> FloorAccelerations<'a> {
    /// A recorder for a row of `n_nodes`, walls included, on ground that follows the `excitation`.
    pub fn new(n_nodes: usize, excitation: Excitation<'a>) -> Self {
        let magnitudes = excitation.samples().iter().map(|sample| sample.abs());
        Self {
            excitation,
            most: ROUNDED * magnitudes.fold(0.0, f64::max),
            arrivals: vec![0.0; n_nodes],
            peaks: vec![Peak::default(); n_nodes],
        }
    }

    /// Records on ground along which the excitation [travels](crate::Row::travel).
    #[must_use]
    pub fn travelled(self, travel: Option<&Travel>) -> Self {
        let arrival = |node: usize| travel.map_or(0.0, |travel| travel.arrival(node));
        Self {
            arrivals: (0..self.peaks.len()).map(arrival).collect(),
            ..self
        }
    }

    /// Peak of a floor, by its node; for a wall, that of the ground.
    pub fn of(&self, node: usize) -> Peak {
        self.peaks[node]
    }

    /// Peaks of all floors, by their nodes, without a borrow of the ground motion.
    pub fn into_peaks(self) -> Vec<Peak> {
        self.peaks
    }
}

impl Recorder for FloorAccelerations<'_> {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        let (from, to) = (span.start_time, span.end_time);
        let peak = &mut self.peaks[span.structure];
        let arrival = self.arrivals[span.structure];
        match span.path {
            Path::Cubic(_) => {
                for (state, time) in [(&span.start, from), (&span.end, to)] {
                    if state.acceleration.abs() + self.most > peak.value.abs() {
                        peak.take(state.acceleration + self.excitation.at(time, arrival), time);
                    }
                }
            }
            Path::Flight(_) => self.span(&span.expanded(&mut Expansion::default())),
            // Such a span is between two samples.
            Path::Series(series) => {
                let segment = self.excitation.segment(from, arrival);
                let ground = |time: f64| segment.value + segment.slope * (time - from);
                peak.take(span.start.acceleration + ground(from), from);
                let last = span.x(series, to);
                let own = span.start.acceleration.abs();
                let most = own + reach(series.acceleration.iter().skip(1).copied(), last);
                if ROUNDED * (most + self.most) > peak.value.abs() {
                    // Just after a touch nothing changes yet in the fourth root of time.
                    let first = series.x(from + BEGUN * (to - from));
                    let (jerk, len) = jerk(&series, segment.slope);
                    sign_changes(&jerk[..len], [first, last], |x| {
                        let time = series.time(x);
                        peak.take(value(series.acceleration, x) + ground(time), time);
                    });
                }
                peak.take(span.end.acceleration + ground(to), to);
            }
        }
    }

    fn impact(&mut self, _: &Impact) {}
}

/// Coefficients in x of the rate of the absolute acceleration, on ground whose acceleration changes at `slope` \[m/s³\], and their number.
fn jerk(series: &Series<'_>, slope: f64) -> ([f64; CAPACITY], usize) {
    let mut rates = [0.0; CAPACITY];
    let own = series.acceleration.iter().enumerate().skip(1);
    for (n, coefficient) in own {
        rates[n - 1] = n as f64 * coefficient;
    }
    let order = series.power.order();
    rates[order - 1] += order as f64 * slope;
    (rates, order.max(series.acceleration.len().saturating_sub(1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::span::Power;
    use crate::{State, Weighed};

    /// Ends of a span of one second, and its path.
    fn span(accelerations: [f64; 2], path: Path<'_>) -> Span<'_> {
        let state = |acceleration| State {
            acceleration,
            ..State::default()
        };
        let [start, end] = accelerations.map(state);
        Span {
            structure: 0,
            start_time: 1.0,
            end_time: 2.0,
            start,
            end,
            impulse_from_left: 0.0,
            impulse_from_right: 0.0,
            below: None,
            pushes: &[],
            links: &[],
            path,
        }
    }

    const GROUND: [f64; 4] = [9.0, 0.5, 1.5, 0.0];

    #[test]
    fn reference_the_ground_is_added_at_both_ends() {
        let excitation = Excitation::new(1.0, &GROUND).unwrap();
        for (accelerations, value, time) in [([1.0, 0.5], 2.0, 2.0), ([-3.0, 0.5], -2.5, 1.0)] {
            let mut peaks = FloorAccelerations::new(1, excitation);
            peaks.span(&span(accelerations, Path::Cubic(Weighed::default())));
            assert_eq!(peaks.of(0), Peak { value, time });
        }
    }

    #[test]
    fn reference_the_largest_value_inside_a_span() {
        // ü = 3τ − 4τ² on ground at 0.5 + τ: 0.5 + 4τ − 4τ² has its maximum 1.5 at 0.5. In x with τ = x⁴ the result must be equal.
        let excitation = Excitation::new(1.0, &GROUND).unwrap();
        let plain: &[f64] = &[0.0, 3.0, -4.0];
        let mut rooted = [0.0; 9];
        (rooted[4], rooted[8]) = (3.0, -4.0);
        for (power, acceleration) in [(Power::One, plain), (Power::Four, &rooted[..])] {
            let path = Path::Series(Series {
                origin: 1.0,
                power,
                end: f64::INFINITY,
                displacement: &[],
                velocity: &[],
                acceleration,
                below: None,
                restoring_force: (0.0, 0.0),
                bent: &[],
                force_from_left: &[],
                force_from_right: &[],
            });
            let mut peaks = FloorAccelerations::new(1, excitation);
            peaks.span(&span([0.0, -1.0], path));
            let Peak { value, time } = peaks.of(0);
            assert!((value - 1.5).abs() < 1e-14, "{value}");
            assert!((time - 1.5).abs() < 1e-14, "{power:?}: {time}");
        }
    }
}
