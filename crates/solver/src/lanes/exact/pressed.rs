//! Two neighbours that press against each other: their equations, and a step of Dormand and Prince's method of order 5.

use pounding_contact::{Action, Form};

use super::Interval;
use super::pair::Side;

/// Weights of the slopes so far at every stage; the last row is the solution of order 5.
const SECOND: [f64; 1] = [1.0 / 5.0];
const THIRD: [f64; 2] = [3.0 / 40.0, 9.0 / 40.0];
const FOURTH: [f64; 3] = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];
const FIFTH: [f64; 4] = [
    19_372.0 / 6561.0,
    -25_360.0 / 2187.0,
    64_448.0 / 6561.0,
    -212.0 / 729.0,
];
const SIXTH: [f64; 5] = [
    9017.0 / 3168.0,
    -355.0 / 33.0,
    46_732.0 / 5247.0,
    49.0 / 176.0,
    -5103.0 / 18_656.0,
];
const LAST: [f64; 6] = [
    35.0 / 384.0,
    0.0,
    500.0 / 1113.0,
    125.0 / 192.0,
    -2187.0 / 6784.0,
    11.0 / 84.0,
];
/// Difference of the solutions of orders 5 and 4.
const ERROR: [f64; 7] = [
    71.0 / 57_600.0,
    0.0,
    -71.0 / 16_695.0,
    71.0 / 1920.0,
    -17_253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Steps of a search; none that was looked at needs a tenth.
const MOST_SEARCH: usize = 60;
/// Part of a step to which an instant is found whose square counts: kinks and largest values.
pub(super) const ROUGHLY: f64 = 1e-6;
/// The same for a parting.
const FULLY: f64 = 1e-13;
/// Part of a step to which the cubic through its ends is searched.
const PROBE: f64 = 1e-3;
/// What a branch of the force is away from its end at least, for its end to be looked for.
const SLOWLY: f64 = 1e-5;

/// Displacements and velocities of both sides, and the impulse so far.
pub(super) type State = [f64; 5];

/// A state with its derivative in s.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) s: f64,
    pub(super) state: State,
    pub(super) slope: State,
}

/// What moves in contact.
pub(super) struct Pressed {
    pub(super) sides: [Side; 2],
    pub(super) gap: f64,
    pub(super) form: Form,
    /// Approach rate at the touch \[m/s\].
    pub(super) speed: f64,
    pub(super) ground: Interval,
    /// Time since the touch at the start of `ground` \[s\].
    pub(super) since: f64,
}

/// A step that may be taken.
pub(super) struct Ahead {
    pub(super) next: Point,
    pub(super) step: f64,
    pub(super) error: f64,
    /// Whether neighbours part at its end.
    pub(super) parts: bool,
}

impl Pressed {
    /// A step, no longer than to where the force bends sharply (dampers let go or act again) or neighbours part.
    pub(super) fn ahead(&self, here: &Point, step: f64) -> Ahead {
        let (mut next, mut error) = self.step(here, step);
        let mut step = step;
        if self.bends(here, &next) {
            let away = -self.branch(here).signum();
            step = self.rise((here, &next), ROUGHLY, |point| away * self.branch(point));
            (next, error) = self.step(here, step);
        }
        // What would bend behind a parting bends nothing; who has just touched is together to rounding, and parts where the rate says so.
        let overlapped = self.deformation(&here.state) > 0.0;
        let parts = self.deformation(&next.state) < 0.0 && (overlapped || next.rate() < 0.0);
        if parts && here.s == 0.0 {
            // The first step went through the whole contact.
            error = f64::INFINITY;
        } else if parts {
            step = self.rise((here, &next), FULLY, |point| {
                -self.deformation(&point.state)
            });
            (next, error) = self.step(here, step);
        }
        Ahead {
            next,
            step,
            error,
            parts,
        }
    }

    pub(super) fn deformation(&self, state: &State) -> f64 {
        state[0] - state[2] - self.gap
    }

    pub(super) fn force(&self, state: &State) -> f64 {
        let deformation = self.deformation(state);
        if deformation > 0.0 {
            self.form.force(deformation, state[1] - state[3])
        } else {
            0.0
        }
    }

    /// How fast the force changes \[N/s\]; 1 at the very start. Where a step ends at a reversal, as it does before.
    pub(super) fn climb(&self, point: &Point, approaches: bool) -> f64 {
        let deformation = self.deformation(&point.state);
        if point.s == 0.0 {
            return 1.0;
        }
        if deformation <= 0.0 {
            return -1.0;
        }
        let rate = if approaches {
            point.rate().max(f64::MIN_POSITIVE)
        } else {
            point.rate()
        };
        let response = self.form.respond(deformation, rate);
        let time = 4.0 * point.s * point.s * point.s;
        let change = (point.slope[1] - point.slope[3]) / time;
        response.stiffness * rate + response.damping * change
    }

    /// The point of a state.
    pub(super) fn at(&self, s: f64, state: State) -> Point {
        let [u, v, w, z, _] = state;
        let time = fourth_power(s) - self.since;
        let ground = self.ground.value + self.ground.slope * time;
        let force = self.force(&state);
        let [left, right] = &self.sides;
        let rates = [
            v,
            left.acceleration([u, v], (-force, ground)),
            z,
            right.acceleration([w, z], (force, ground)),
            force,
        ];
        let factor = 4.0 * s * s * s;
        Point {
            s,
            state,
            slope: rates.map(|rate| factor * rate),
        }
    }

    /// A step, and its error relative to the approach speed.
    pub(super) fn step(&self, from: &Point, step: f64) -> (Point, f64) {
        let mut slopes = [from.slope; 7];
        let at = |node: f64, state: State| self.at(from.s + node * step, state);
        slopes[1] = at(0.2, from.moved(step, &slopes, SECOND)).slope;
        slopes[2] = at(0.3, from.moved(step, &slopes, THIRD)).slope;
        slopes[3] = at(0.8, from.moved(step, &slopes, FOURTH)).slope;
        slopes[4] = at(8.0 / 9.0, from.moved(step, &slopes, FIFTH)).slope;
        slopes[5] = at(1.0, from.moved(step, &slopes, SIXTH)).slope;
        let point = at(1.0, from.moved(step, &slopes, LAST));
        slopes[6] = point.slope;
        let nothing = Point {
            state: [0.0; 5],
            ..point
        };
        let error = nothing.moved(step, &slopes, ERROR);
        let [left, right] = &self.sides;
        let velocity = error[1].abs().max(error[3].abs());
        let impulse = left.inverse_mass.max(right.inverse_mass) * error[4].abs();
        // A deformation is an approach speed times the time since the touch.
        let deformation = (error[0] - error[2]).abs() / fourth_power(point.s);
        (point, velocity.max(impulse).max(deformation) / self.speed)
    }

    /// A number whose sign says on which of its smooth branches the force is: with or without a damper that acts on approach
    /// alone; pushing, or clamped where the formula would pull. Its magnitude is 1 in the ordinary.
    fn branch(&self, point: &Point) -> f64 {
        let rate = point.rate();
        match self.form.action {
            Action::Approach => rate / self.speed,
            Action::Both => {
                let deformation = self.deformation(&point.state);
                self.form.unclamped(deformation, rate) / self.form.spring.at(deformation)
            }
        }
    }

    /// Whether the force changes its branch in a step; not where it has just done so, nor where neighbours part.
    fn bends(&self, here: &Point, next: &Point) -> bool {
        let [before, after] = [here, next].map(|point| self.branch(point));
        before.abs() > SLOWLY && before * after < 0.0
    }

    /// The step after which a number has risen to zero, which is negative now and not after a longer step that is known; found to a
    /// part of the longer step.
    ///
    /// The cubic between both points says where about; steps of the method itself and the slope of the cubic say the rest.
    pub(super) fn rise(
        &self,
        (here, next): (&Point, &Point),
        part: f64,
        number: impl Fn(&Point) -> f64,
    ) -> f64 {
        let whole = next.s - here.s;
        let between = |part: f64| {
            let state = here.between(next, part);
            number(&self.at(here.s + part * whole, state))
        };
        let mut x = first_zero(between, [number(here), number(next)]);
        let [before, after] = [(x - PROBE).max(0.0), (x + PROBE).min(1.0)];
        let slope = (between(after) - between(before)) / (after - before);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..MOST_SEARCH {
            let value = number(&self.step(here, x * whole).0);
            if value < 0.0 {
                low = x;
            } else {
                high = x;
            }
            let straight = x - value / slope;
            let next = if (low..=high).contains(&straight) {
                straight
            } else {
                0.5 * (low + high)
            };
            let change = (next - x).abs();
            x = next;
            if change <= part {
                break;
            }
        }
        x * whole
    }
}

/// Where a number that is negative at 0 and not at 1 is about zero.
fn first_zero(number: impl Fn(f64) -> f64, [start, end]: [f64; 2]) -> f64 {
    let (mut low, mut high) = ((0.0, start), (1.0, end));
    // Illinois: the secant, with the value at an end that stays halved.
    let mut side = 0;
    let mut x = 1.0;
    for _ in 0..MOST_SEARCH {
        if high.0 - low.0 < PROBE || high.1 == 0.0 {
            break;
        }
        let secant = high.0 - high.1 * (high.0 - low.0) / (high.1 - low.1);
        // Behind a parting a branch may be no number.
        let next = if (low.0..=high.0).contains(&secant) {
            secant
        } else {
            0.5 * (low.0 + high.0)
        };
        let near = (next - x).abs() < PROBE;
        x = next;
        if near {
            break;
        }
        let value = number(x);
        if value < 0.0 {
            low = (x, value);
            high.1 *= if side == -1 { 0.5 } else { 1.0 };
            side = -1;
        } else {
            high = (x, value);
            low.1 *= if side == 1 { 0.5 } else { 1.0 };
            side = 1;
        }
    }
    x
}

impl Point {
    /// The state on the cubic to another point, at a part of the way.
    fn between(&self, next: &Self, part: f64) -> State {
        let (step, rest) = (next.s - self.s, 1.0 - part);
        std::array::from_fn(|index| {
            let [from, to] = [self, next].map(|point| point.state[index]);
            let [first, last] = [self, next].map(|point| step * point.slope[index]);
            let bow = rest * (first - (to - from)) - part * (last - (to - from));
            from + part * (to - from) + part * rest * bow
        })
    }

    /// Approach rate \[m/s\].
    pub(super) fn rate(&self) -> f64 {
        self.state[1] - self.state[3]
    }

    /// The state a step on, with these weights of slopes.
    #[inline]
    fn moved<const N: usize>(&self, step: f64, slopes: &[State; 7], weights: [f64; N]) -> State {
        std::array::from_fn(|index| {
            let mut sum = weights[0] * slopes[0][index];
            for stage in 1..N {
                sum += weights[stage] * slopes[stage][index];
            }
            self.state[index] + step * sum
        })
    }
}

pub(super) fn fourth_power(s: f64) -> f64 {
    (s * s) * (s * s)
}
