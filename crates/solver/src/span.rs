mod flight;
mod push;
mod series;

use crate::quadrature::{self, EIGHT, SIXTEEN};
pub use flight::Expansion;
pub use flight::Flight;
pub use push::Push;
pub use series::Series;
pub use series::value;
pub(crate) use series::{Power, rise};

/// State of a structure at an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct State {
    /// Displacement u relative to the ground \[m\], positive to the right.
    pub displacement: f64,
    /// Velocity u̇ \[m/s\].
    pub velocity: f64,
    /// Acceleration ü relative to the ground \[m/s²\].
    pub acceleration: f64,
    /// Restoring force `f_s` \[N\].
    pub restoring_force: f64,
    /// Pounding force from the left neighbour \[N\], ≥ 0 (it pushes to the right).
    pub force_from_left: f64,
    /// Pounding force from the right neighbour \[N\], ≤ 0 (it pushes to the left).
    pub force_from_right: f64,
}

impl State {
    /// Net pounding force \[N\], positive to the right.
    #[inline]
    pub fn pounding_force(&self) -> f64 {
        self.force_from_left + self.force_from_right
    }
}

/// The motion of one structure between two instants.
///
/// Spans of a structure follow each other without a gap from t = 0 on; the end of one and the start of the next
/// differ only in velocity and acceleration, and only where an [`Impact`](crate::Impact) was reported.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span<'a> {
    /// Index of the structure, from the left.
    pub structure: usize,
    /// Start \[s\].
    pub start_time: f64,
    /// End \[s\].
    pub end_time: f64,
    /// State at the start.
    pub start: State,
    /// State at the end.
    pub end: State,
    /// Impulse of the pounding force from the left neighbour over the span \[N·s\], ≥ 0.
    pub impulse_from_left: f64,
    /// Impulse of the pounding force from the right neighbour over the span \[N·s\], ≤ 0.
    pub impulse_from_right: f64,
    /// Displacement and velocity of the floor below at both ends; nothing for a floor that stands on the ground.
    pub below: Option<[Motion; 2]>,
    /// What is known between the ends.
    pub path: Path<'a>,
    /// What every pair at the floor does to it; their sums are in the states and impulses.
    pub pushes: &'a [Push<'a>],
}

/// Displacement and velocity: of a floor relative to the ground, or of a storey, whose drift it then is.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Motion {
    /// Displacement \[m\], positive to the right.
    pub displacement: f64,
    /// Velocity \[m/s\].
    pub velocity: f64,
}

impl Motion {
    /// The motion of what moves like this over a ground that moves.
    pub(crate) fn over(self, ground: Self) -> Self {
        Self {
            displacement: self.displacement + ground.displacement,
            velocity: self.velocity + ground.velocity,
        }
    }

    pub(crate) fn since(self, below: Self) -> Self {
        Self {
            displacement: self.displacement - below.displacement,
            velocity: self.velocity - below.velocity,
        }
    }
}

impl From<&State> for Motion {
    fn from(state: &State) -> Self {
        Self {
            displacement: state.displacement,
            velocity: state.velocity,
        }
    }
}

/// What is known of a motion between the ends of its span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path<'a> {
    /// Nothing but the ends and what the method made of the forces, as in a step of a stepping method; a cubic between
    /// the ends.
    Cubic(Weighed),
    /// The motion itself.
    Series(Series<'a>),
    /// The motion itself, of a structure that flies freely and does not turn but at the ends.
    Flight(Flight),
}

/// What acts on a floor besides its neighbours, over a step, as the method weighed it: forces of the storey below it and
/// of the one above.
///
/// With the impulses of the pounding forces it is the step's own balance of momentum: m·Δu̇ equals the sum of the
/// impulses, less m times the change of the ground's velocity, to rounding. All are 0 unless a recorder
/// [reads](crate::Recorder::reads_weighed) them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Weighed {
    /// Impulse of the restoring force, −∫`f_s` dt \[N·s\].
    pub restoring: f64,
    /// Impulse of the viscous damping, −∫c·u̇ dt \[N·s\].
    pub damping: f64,
    /// Change of the ground's velocity, ∫`a_g` dt \[m/s\]; of a wall it says nothing.
    pub ground_velocity: f64,
}

/// What acts on a structure at an instant, as it enters a method's equation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load {
    pub(crate) restoring: f64,
    pub(crate) damping: f64,
    pub(crate) ground: f64,
    pub(crate) from_left: f64,
    pub(crate) from_right: f64,
}

impl Load {
    /// The pounding forces of a state, restoring and damping force \[N\] of the storeys below and above, and the ground
    /// acceleration \[m/s²\].
    #[inline]
    pub(crate) fn at(state: &State, (restoring, damping): (f64, f64), ground: f64) -> Self {
        Self {
            restoring,
            damping,
            ground,
            from_left: state.force_from_left,
            from_right: state.force_from_right,
        }
    }
}

/// Terms of a series up to which products of two are integrated to rounding by the rule of eight nodes.
const FEW: usize = 15;

impl Span<'_> {
    /// Drift of the storey below the floor, and its rate, at both ends of the span.
    pub fn drifts(&self) -> [Motion; 2] {
        let ends = [Motion::from(&self.start), Motion::from(&self.end)];
        match self.below {
            None => ends,
            Some(below) => [ends[0].since(below[0]), ends[1].since(below[1])],
        }
    }

    /// Drift of the storey below the floor, and its rate, at an instant inside the span.
    pub fn drift(&self, time: f64) -> Motion {
        let floor = Motion::from(&self.at(time));
        match (self.below, self.path) {
            (None, _) | (Some(_), Path::Flight(_)) => floor,
            (Some(ends), Path::Cubic(_)) => floor.since(self.cubic_between(ends, time)),
            (Some(_), Path::Series(series)) => series.drift(floor, self.x(series, time)),
        }
    }

    /// Duration \[s\].
    pub fn duration(&self) -> f64 {
        self.end_time - self.start_time
    }

    /// State at an instant inside the span.
    ///
    /// Of [`Path::Cubic`], displacement and velocity are the cubic through displacements and velocities of both ends;
    /// forces and acceleration are linear.
    pub fn at(&self, time: f64) -> State {
        match self.path {
            Path::Cubic(_) => self.cubic(time),
            Path::Series(series) => series.at(self.x(series, time)),
            Path::Flight(_) => self.expanded(&mut Expansion::default()).at(time),
        }
    }

    /// Integrals over time of N functions of instant \[s\] and state, by a Gauss–Legendre rule of 8 or 16 nodes.
    ///
    /// In the variable of a [`Path::Series`], in which its forces are smooth, and so to rounding where the functions
    /// are smooth too.
    pub fn integrate<const N: usize>(&self, integrand: impl Fn(f64, &State) -> [f64; N]) -> [f64; N] {
        self.integrate_between(self.start_time, self.end_time, |time, state, _| integrand(time, state))
    }

    /// The same integrals between two instants of the span, of functions of the drift of the storey below, too.
    pub(crate) fn integrate_between<const N: usize>(
        &self,
        from: f64,
        to: f64,
        integrand: impl Fn(f64, &State, Motion) -> [f64; N],
    ) -> [f64; N] {
        match self.path {
            Path::Cubic(_) => quadrature::integrate(SIXTEEN, from, to, |time| {
                let state = self.cubic(time);
                let drift = match self.below {
                    None => Motion::from(&state),
                    Some(_) => self.drift(time),
                };
                integrand(time, &state, drift)
            }),
            Path::Series(series) => {
                let few = series.displacement.len() <= FEW && series.power == Power::One;
                // Of a span shorter than instants tell apart, start and end are one instant, which is the end to `x`.
                let first = if from > self.start_time {
                    self.x(series, from)
                } else {
                    series.x(self.start_time)
                };
                let last = self.x(series, to);
                if few {
                    series.integrate(EIGHT, [first, last], integrand)
                } else {
                    series.integrate(SIXTEEN, [first, last], integrand)
                }
            }
            Path::Flight(_) => {
                let mut room = Expansion::default();
                self.expanded(&mut room).integrate_between(from, to, integrand)
            }
        }
    }

    /// x of its series at an instant; at the end of the span what the series says, not the clock.
    pub(crate) fn x(&self, series: Series<'_>, time: f64) -> f64 {
        if time >= self.end_time && series.end.is_finite() {
            series.end
        } else {
            series.x(time)
        }
    }

    fn cubic(&self, time: f64) -> State {
        let h = self.duration();
        let s = (time - self.start_time) / h;
        let r = 1.0 - s;
        let linear = |a: f64, b: f64| r * a + s * b;
        let (a, b) = (&self.start, &self.end);
        let Motion { displacement, velocity } = self.cubic_between([a.into(), b.into()], time);
        State {
            displacement,
            velocity,
            acceleration: linear(a.acceleration, b.acceleration),
            restoring_force: linear(a.restoring_force, b.restoring_force),
            force_from_left: linear(a.force_from_left, b.force_from_left),
            force_from_right: linear(a.force_from_right, b.force_from_right),
        }
    }

    /// The cubic through displacements and velocities at both ends.
    fn cubic_between(&self, [a, b]: [Motion; 2], time: f64) -> Motion {
        let h = self.duration();
        let s = (time - self.start_time) / h;
        let r = 1.0 - s;
        let rise = b.displacement - a.displacement;
        Motion {
            displacement: r * a.displacement + s * b.displacement + s * r * (r * (a.velocity * h - rise) - s * (b.velocity * h - rise)),
            velocity: 6.0 * s * r * rise / h + r * (r - 2.0 * s) * a.velocity + s * (s - 2.0 * r) * b.velocity,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_a_cubic_is_followed_exactly() {
        let path = |t: f64| State {
            displacement: 1.0 - 2.0 * t + 3.0 * t * t - 0.5 * t * t * t,
            velocity: -2.0 + 6.0 * t - 1.5 * t * t,
            acceleration: 6.0 - 3.0 * t,
            ..State::default()
        };
        let ends = [path(0.5), path(2.5)];
        let loads = ends.map(|state| Load::at(&state, (0.0, 0.0), 0.0));
        let span = Span::step(false, 0, (0.5, 2.5), ends, (1.0, [1.0, 1.0]), loads);
        for time in [0.5, 0.7, 1.3, 2.2, 2.5] {
            let (found, wanted) = (span.at(time), path(time));
            assert!((found.displacement - wanted.displacement).abs() < 1e-14, "{time}: {found:?}");
            assert!((found.velocity - wanted.velocity).abs() < 1e-14, "{time}: {found:?}");
            assert!((found.acceleration - wanted.acceleration).abs() < 1e-14, "{time}: {found:?}");
        }
    }

    /// Rounding made a piece of 1e-18 s a thousand times longer, and its ledger with it.
    #[test]
    fn issue_a_span_shorter_than_instants_tell_lasts_as_long_as_its_series() {
        let mut span = Span::step(
            false,
            0,
            (5.0, 5.0_f64.next_up()),
            [State::default(); 2],
            (1.0, [1.0]),
            [Load::at(&State::default(), (0.0, 0.0), 0.0)],
        );
        let displacement = [1.0, 2.0];
        span.path = Path::Series(Series {
            origin: 5.0,
            power: Power::One,
            end: 1e-18,
            displacement: &displacement,
            velocity: &[2.0],
            acceleration: &[],
            below: None,
            restoring_force: (0.0, 0.0),
            bent: &[],
            force_from_left: &[],
            force_from_right: &[],
        });
        let [duration] = span.integrate(|_, _| [1.0]);
        assert!((duration / 1e-18 - 1.0).abs() < 1e-14, "{duration:e}");
    }

    #[test]
    fn reference_integrals_over_a_span() {
        // u = 1 + 2x + 3x⁴ with t = 2 + x⁴, so ∫u dt over T = h is h + 8/5 h^(5/4) + 3/2 h².
        let displacement = [1.0, 2.0, 0.0, 0.0, 3.0];
        let mut span = Span::step(
            false,
            0,
            (2.0, 2.0625),
            [State::default(); 2],
            (1.0, [1.0]),
            [Load::at(&State::default(), (0.0, 0.0), 0.0)],
        );
        span.path = Path::Series(Series {
            origin: 2.0,
            power: Power::Four,
            end: f64::INFINITY,
            displacement: &displacement,
            velocity: &[],
            acceleration: &[],
            below: None,
            restoring_force: (0.0, 0.0),
            bent: &[],
            force_from_left: &[],
            force_from_right: &[],
        });
        let h: f64 = 0.0625;
        let [integral, duration] = span.integrate(|_, state| [state.displacement, 1.0]);
        let wanted = h + 1.6 * h * h.sqrt().sqrt() + 1.5 * h * h;
        assert!((integral / wanted - 1.0).abs() < 1e-14, "{integral} {wanted}");
        assert!((duration / h - 1.0).abs() < 1e-14, "{duration}");
        // A cubic from rest to rest over 1 m: ∫u dt is half the duration.
        let end = State {
            displacement: 1.0,
            ..State::default()
        };
        let ends = [State::default(), end];
        let loads = ends.map(|state| Load::at(&state, (0.0, 0.0), 0.0));
        let step = Span::step(false, 0, (0.0, 0.5), ends, (0.25, [1.0, 1.0]), loads);
        let [integral] = step.integrate(|_, state| [state.displacement]);
        assert!((integral - 0.25).abs() < 1e-15, "{integral}");
    }
}
