//! A step of Dormand and Prince's method of order 5 in contact, and the polynomial of order 4 between its ends.

use pounding_contact::Number;

use super::pressed::{Pressed, PressedPoint, State, fourth_power, larger};

/// Weights of the earlier slopes at the second stage. The constants below are those of the other stages; the last are the solution of order
/// 5.
const SECOND: [f64; 1] = [1.0 / 5.0];
const THIRD: [f64; 2] = [3.0 / 40.0, 9.0 / 40.0];
const FOURTH: [f64; 3] = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];
const FIFTH: [f64; 4] = [19_372.0 / 6561.0, -25_360.0 / 2187.0, 64_448.0 / 6561.0, -212.0 / 729.0];
const SIXTH: [f64; 5] = [9017.0 / 3168.0, -355.0 / 33.0, 46_732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18_656.0];
const LAST: [f64; 6] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
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
/// Weights of the slopes in the last term of the polynomial (L. F. Shampine, *Math. Comp.* 46 (1986) 135).
const BETWEEN: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// A trial step.
pub(super) struct Stepped<N> {
    pub(super) next: PressedPoint<N>,
    /// Estimated error relative to the approach speed.
    pub(super) error: N,
    slopes: [State<N>; 7],
}

/// The polynomial between the ends of a step.
pub(super) struct Way<N> {
    start: State<N>,
    change: State<N>,
    bows: [State<N>; 3],
}

impl<N: Number> Pressed<N> {
    #[inline(always)]
    pub(super) fn step(&self, from: &PressedPoint<N>, step: N) -> Stepped<N> {
        let at = |node: f64| from.s + step * step.like(node);
        let mut slopes = [from.slope; 7];
        slopes[1] = self.slope(at(0.2), &on_the_way(from, step, &slopes, SECOND));
        slopes[2] = self.slope(at(0.3), &on_the_way(from, step, &slopes, THIRD));
        slopes[3] = self.slope(at(0.8), &on_the_way(from, step, &slopes, FOURTH));
        slopes[4] = self.slope(at(8.0 / 9.0), &on_the_way(from, step, &slopes, FIFTH));
        slopes[5] = self.slope(at(1.0), &on_the_way(from, step, &slopes, SIXTH));
        let mut end = on_the_way(from, step, &slopes, LAST);
        end[4] = end[4] + step * weighted(&slopes, LAST, 4);
        let next = self.at(at(1.0), end);
        slopes[6] = next.slope;
        let mut error = end;
        for (index, error) in error.iter_mut().enumerate() {
            *error = weighted(&slopes, ERROR, index);
        }
        let velocity = larger(error[1].abs(), error[3].abs());
        let impulse = self.largest_inverse_mass * error[4].abs();
        // A deformation is at most the approach speed times the time since the touch.
        let deformation = (error[0] - error[2]).abs() / fourth_power(next.s);
        let error = step * larger(larger(velocity, impulse), deformation) / self.speed;
        Stepped { next, error, slopes }
    }
}

impl<N: Number> Stepped<N> {
    /// The polynomial from the start of the step.
    #[inline(always)]
    pub(super) fn way(&self, from: &PressedPoint<N>, step: N) -> Way<N> {
        let mut way = Way {
            start: from.state,
            change: from.state,
            bows: [from.state; 3],
        };
        for index in 0..from.state.len() {
            let change = self.next.state[index] - from.state[index];
            let bow = step * from.slope[index] - change;
            way.change[index] = change;
            let end = change - step * self.next.slope[index] - bow;
            (way.bows[0][index], way.bows[1][index]) = (bow, end);
            way.bows[2][index] = step * weighted(&self.slopes, BETWEEN, index);
        }
        way
    }
}

impl<N: Number> Way<N> {
    /// The state at a part of the step.
    #[inline(always)]
    pub(super) fn at(&self, part: N) -> State<N> {
        let rest = part.like(1.0) - part;
        let mut state = self.start;
        for (index, number) in state.iter_mut().enumerate() {
            let [first, second, third] = &self.bows;
            let bow = first[index] + part * (second[index] + rest * third[index]);
            *number = *number + part * (self.change[index] + rest * bow);
        }
        state
    }
}

/// The motions within a step, with these weights of slopes. The impulse is omitted, because nothing depends on it.
#[inline(always)]
fn on_the_way<N: Number, const STAGES: usize>(from: &PressedPoint<N>, step: N, slopes: &[State<N>; 7], weights: [f64; STAGES]) -> State<N> {
    let mut state = from.state;
    for index in 0..state.len() - 1 {
        state[index] = state[index] + step * weighted(slopes, weights, index);
    }
    state
}

/// Weighted sum of the slopes of a component; zero weights cost nothing.
#[inline(always)]
fn weighted<N: Number, const STAGES: usize>(slopes: &[State<N>; 7], weights: [f64; STAGES], index: usize) -> N {
    let first = slopes[0][index];
    let mut sum = first.like(weights[0]) * first;
    for stage in 1..STAGES {
        if weights[stage] != 0.0 {
            sum = sum + sum.like(weights[stage]) * slopes[stage][index];
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use pounding_contact::{Action, Form, Power, Term};

    use super::super::pressed::Half;
    use super::*;

    /// Two structures on soft columns that press by Hertz's law with a damper.
    fn pressed() -> Pressed<f64> {
        let half = |mass: f64, stiffness: f64| Half {
            inverse_mass: 1.0 / mass,
            damping: 0.1 * stiffness,
            stiffness,
            mobile: 1.0,
        };
        let term = |coefficient, power| Term { coefficient, power };
        Pressed {
            left: half(2.0, 30.0),
            right: half(3.0, 50.0),
            largest_inverse_mass: 0.5,
            gap: 0.02,
            form: Form {
                spring: term(900.0, Power::ThreeHalves),
                damper: term(20.0, Power::Quarter),
                action: Action::Both,
                second: None,
            },
            speed: 1.0,
            ground: [0.5, -2.0],
        }
    }

    fn start(pressed: &Pressed<f64>) -> PressedPoint<f64> {
        pressed.at(0.4, [0.05, 0.6, 0.01, -0.3, 0.0])
    }

    /// The end after this many steps over a length.
    fn end(steps: u32, length: f64) -> State<f64> {
        let pressed = pressed();
        let step = length / f64::from(steps);
        let mut point = start(&pressed);
        for _ in 0..steps {
            point = pressed.step(&point, step).next;
        }
        point.state
    }

    fn distance(one: State<f64>, other: State<f64>) -> f64 {
        let pairs = one.iter().zip(other);
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn order_of_steps_is_five() {
        let exact = end(512, 0.1);
        let [coarse, fine] = [8, 16].map(|steps| distance(end(steps, 0.1), exact));
        let order = libm::log2(coarse / fine);
        assert!((4.7..5.4).contains(&order), "{order}: {coarse:e} {fine:e}");
    }

    /// For a single step, an error of order 5 is that of a method of order 4.
    #[test]
    fn order_of_the_polynomial_between_ends_is_four() {
        let pressed = pressed();
        let start = start(&pressed);
        let error = |step: f64| {
            let early = pressed.step(&start, step).way(&start, step).at(0.3);
            distance(early, end(64, 0.3 * step))
        };
        let order = libm::log2(error(0.02) / error(0.01));
        assert!((4.6..5.6).contains(&order), "{order}: {:e}", error(0.01));
    }
}
