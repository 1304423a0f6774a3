mod flight;
mod series;

use crate::quadrature::{self, EIGHT, SIXTEEN};
pub use flight::Expansion;
pub use flight::Flight;
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

/// The motion of a structure between two instants.
///
/// The spans of a structure follow each other without a gap from t = 0. The end of a span and the start of the next span differ only in
/// velocity and acceleration, and only at a reported [`Impact`](crate::Impact).
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
    /// Displacement and velocity of the floor below at both ends; `None` for a floor on the ground.
    pub below: Option<[Motion; 2]>,
    /// Motion between the ends.
    pub path: Path<'a>,
    /// Action of every pair on the floor. The states and impulses contain their sums.
    pub pushes: &'a [Push<'a>],
    /// Action of every link on the floor. A push contains the index of the link in place of a pair. The forces of links may be negative,
    /// and neither states nor impulses contain them.
    pub links: &'a [Push<'a>],
}

/// Displacement and velocity: of a floor relative to the ground, or the drift and its rate of a storey.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Motion {
    /// Displacement \[m\], positive to the right.
    pub displacement: f64,
    /// Velocity \[m/s\].
    pub velocity: f64,
}

impl Motion {
    /// The sum of this motion and the motion of the ground below.
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

/// Motion between the ends of a span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path<'a> {
    /// A step of a stepping method: only the ends and the weighed forces are known. Between the ends the motion counts as a cubic.
    Cubic(Weighed),
    /// The motion as power series.
    Series(Series<'a>),
    /// The motion of a structure that flies freely and turns only at the ends.
    Flight(Flight),
}

/// Forces on a floor other than those of its neighbours, over a step, as weighed by the method: those of the storeys below and above.
///
/// Together with the impulses of the pounding forces they are the balance of momentum of the step. To rounding, m·Δu̇ equals the sum of the
/// impulses minus m times the change of the ground's velocity. All are 0 unless a recorder [reads](crate::Recorder::reads_weighed) them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Weighed {
    /// Impulse of the restoring force, −∫`f_s` dt \[N·s\].
    pub restoring: f64,
    /// Impulse of the viscous damping, −∫c·u̇ dt \[N·s\].
    pub damping: f64,
    /// Change of the ground's velocity, ∫`a_g` dt \[m/s\]; meaningless for a wall.
    pub ground_velocity: f64,
}

/// Force of the columns and of the dashpots \[N\] against the motion of a floor, from the storeys below and above it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct StoreyForces {
    pub(crate) restoring: f64,
    pub(crate) damping: f64,
}

/// How a method weighs the loads of a step: impulses are `scale` times the weighted sum of the loads.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Weights<const N: usize> {
    /// Time \[s\]; in the trapezoidal rule Δt/2.
    pub(crate) scale: f64,
    /// Weight of every load \[–\]; in the trapezoidal rule 1 at both ends.
    pub(crate) of_loads: [f64; N],
}

impl Weights<2> {
    /// The trapezoidal rule for half a step of this length \[s\].
    #[inline]
    pub(crate) fn trapezoidal(half: f64) -> Self {
        Self {
            scale: half,
            of_loads: [1.0; 2],
        }
    }
}

/// Forces on a structure at an instant, as they enter a method's equation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load {
    pub(crate) restoring: f64,
    pub(crate) damping: f64,
    pub(crate) ground: f64,
    pub(crate) from_left: f64,
    pub(crate) from_right: f64,
    /// Net force of links; 0 in methods that take none.
    pub(crate) links: f64,
}

impl Load {
    /// The load from the pounding forces of a state, the forces of storeys, and the ground acceleration \[m/s²\].
    #[inline]
    pub(crate) fn at(state: &State, storeys: StoreyForces, ground: f64) -> Self {
        Self {
            restoring: storeys.restoring,
            damping: storeys.damping,
            ground,
            from_left: state.force_from_left,
            from_right: state.force_from_right,
            links: 0.0,
        }
    }
}

/// Largest number of terms of series whose products the 8-node rule integrates to rounding.
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

    /// First instant at which the magnitude of the drift reaches a value \[m\] that it has at a later instant of the span.
    pub(crate) fn first_beyond(&self, drift: f64, later: f64) -> f64 {
        let (mut before, mut after) = (self.start_time, later.min(self.end_time));
        // Each half of the interval is half as long: more halves than a number has bits change nothing.
        for _ in 0..f64::MANTISSA_DIGITS {
            let middle = 0.5 * (before + after);
            if self.drift(middle).displacement.abs() < drift {
                before = middle;
            } else {
                after = middle;
            }
        }
        after
    }

    /// Duration \[s\].
    pub fn duration(&self) -> f64 {
        self.end_time - self.start_time
    }

    /// State at an instant inside the span.
    ///
    /// For [`Path::Cubic`], displacement and velocity follow the cubic through displacements and velocities at both ends; forces and
    /// acceleration are linear.
    pub fn at(&self, time: f64) -> State {
        match self.path {
            Path::Cubic(_) => self.cubic(time),
            Path::Series(series) => series.at(self.x(series, time)),
            Path::Flight(_) => self.expanded(&mut Expansion::default()).at(time),
        }
    }

    /// Integrals over time of N functions of instant \[s\] and state, by a Gauss–Legendre rule of 8 or 16 nodes.
    ///
    /// The variable is that of the [`Path::Series`], in which its forces are smooth. The integrals of smooth functions are then exact to
    /// rounding.
    pub fn integrate<const N: usize>(&self, integrand: impl Fn(f64, &State) -> [f64; N]) -> [f64; N] {
        self.integrate_between(self.start_time, self.end_time, |time, state, _| integrand(time, state))
    }

    /// Integrals between two instants of the span, of functions of instant, state and drift of the storey below.
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
                // If a span is shorter than the resolution of time, its start and end are a single instant, which is the end for `x`.
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

    /// x of its series at an instant. At the end of the span the series decides, not the clock.
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
        let loads = ends.map(|state| Load::at(&state, StoreyForces::default(), 0.0));
        let span = Span::step(false, 0, [0.5, 2.5], ends, Weights::trapezoidal(1.0), loads);
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
            [5.0, 5.0_f64.next_up()],
            [State::default(); 2],
            Weights::trapezoidal(1.0),
            [Load::at(&State::default(), StoreyForces::default(), 0.0); 2],
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
            [2.0, 2.0625],
            [State::default(); 2],
            Weights::trapezoidal(1.0),
            [Load::at(&State::default(), StoreyForces::default(), 0.0); 2],
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
        let loads = ends.map(|state| Load::at(&state, StoreyForces::default(), 0.0));
        let step = Span::step(false, 0, [0.0, 0.5], ends, Weights::trapezoidal(0.25), loads);
        let [integral] = step.integrate(|_, state| [state.displacement]);
        assert!((integral - 0.25).abs() < 1e-15, "{integral}");
    }
}
