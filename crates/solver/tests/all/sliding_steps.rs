//! A tower that sticks, slides and pounds, by steps of Runge and Kutta that are written here.

use pounding_solver::{Mixed, Node, Pair, Row, Sliding};

use crate::common::ground;
use crate::sliding::{elastic, on, run, soft};

/// A tower of two floors on a base that slides, beside a mass on a spring, by Runge–Kutta steps between events that are found by halving.
struct Stepped {
    /// Displacements of base, floor and neighbour, then their velocities.
    state: [f64; 6],
    time: f64,
    /// Direction in which the base slides; 0 while it sticks.
    slides: f64,
}

const MASSES: [f64; 3] = [3e5, 2e5, 1e5];
const BASE_SPRING: f64 = 1e6;
const FRICTION: f64 = 3e5;
const STOREY: f64 = 2e8;
const STOREY_DAMPER: f64 = 3e5;
const BESIDE: f64 = 5e7;
const BESIDE_DAMPER: f64 = 1e5;
const GAP: f64 = 0.01;
const CONTACT: f64 = 2e8;

impl Stepped {
    /// What holds the base back from the right, without friction \[N\], and accelerations of the others.
    fn forces(state: &[f64; 6], ground: f64) -> [f64; 3] {
        let [u, w, x, v, s, r] = *state;
        let storey = STOREY * (w - u) + STOREY_DAMPER * (s - v);
        let contact = CONTACT * (u - x - GAP).max(0.0);
        [
            storey - BASE_SPRING * u - contact - MASSES[0] * ground,
            -storey / MASSES[1] - ground,
            (contact - BESIDE * x - BESIDE_DAMPER * r) / MASSES[2] - ground,
        ]
    }

    fn slope(&self, state: &[f64; 6], ground: f64) -> [f64; 6] {
        let [pull, floor, beside] = Self::forces(state, ground);
        let base = if self.slides == 0.0 {
            0.0
        } else {
            (pull - self.slides * FRICTION) / MASSES[0]
        };
        [state[3], state[4], state[5], base, floor, beside]
    }

    fn after(&self, step: f64, ground: impl Fn(f64) -> f64) -> [f64; 6] {
        let add = |slope: &[f64; 6], step: f64| std::array::from_fn::<f64, 6, _>(|n| self.state[n] + step * slope[n]);
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|part| ground(self.time + part * step));
        let first = self.slope(&self.state, start);
        let second = self.slope(&add(&first, 0.5 * step), middle);
        let third = self.slope(&add(&second, 0.5 * step), middle);
        let fourth = self.slope(&add(&third, step), end);
        std::array::from_fn(|n| self.state[n] + step / 6.0 * (first[n] + 2.0 * (second[n] + third[n]) + fourth[n]))
    }

    /// Positive once the base turns, lets go, or touches or leaves its neighbour.
    fn passes(&self, state: &[f64; 6], ground: f64, touches: bool) -> bool {
        let pull = Self::forces(state, ground)[0];
        let friction = if self.slides == 0.0 {
            pull.abs() > FRICTION
        } else {
            self.slides * state[3] < 0.0
        };
        friction || (state[0] - state[2] > GAP) != touches
    }

    /// Steps to the end of an interval, and settles what happens on the way.
    fn step(&mut self, end: f64, ground: impl Fn(f64) -> f64) {
        while end - self.time > 1e-14 {
            let touches = self.state[0] - self.state[2] > GAP;
            let (mut low, mut high) = (0.0, end - self.time);
            if self.passes(&self.after(high, &ground), ground(end), touches) {
                while high - low > 1e-15 {
                    let middle = 0.5 * (low + high);
                    let there = self.after(middle, &ground);
                    let passed = self.passes(&there, ground(self.time + middle), touches);
                    *(if passed { &mut high } else { &mut low }) = middle;
                }
            }
            self.state = self.after(high, &ground);
            self.time += high;
            let pull = Self::forces(&self.state, ground(self.time))[0];
            if self.slides * self.state[3] < 0.0 {
                (self.slides, self.state[3]) = (0.0, 0.0);
            }
            if self.slides == 0.0 && pull.abs() > FRICTION {
                self.slides = pull.signum();
            }
        }
    }
}

/// The exact run of a tower that sticks, slides and pounds, by a second route of a few lines.
#[test]
fn reference_a_tower_that_slides_and_pounds_by_steps() {
    let samples = ground();
    let at = |time: f64| {
        let place = (100.0 * time).min(999.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
        let index = (place + 1e-9) as usize;
        samples[index] + (place - index as f64) * (samples[index + 1] - samples[index])
    };
    let column = Sliding {
        stiffness: BASE_SPRING,
        friction: FRICTION,
    };
    let nodes = vec![
        Node::structure(MASSES[0], 0.0, Mixed::Sliding(column)),
        Node::structure(MASSES[2], BESIDE_DAMPER, elastic(BESIDE)),
        Node::structure(MASSES[1], STOREY_DAMPER, elastic(STOREY)).on_floor(on(0)),
    ];
    let row = Row::new(nodes, vec![Pair::of_floors(0, 1, GAP, soft(CONTACT))]).expect("a row");
    let exact = run(&row, (0.01, &samples), 3.0);
    let mut stepped = Stepped {
        state: [0.0; 6],
        time: 0.0,
        slides: 0.0,
    };
    let mut worst = 0.0_f64;
    for (n, wanted) in exact.histories.of(0).states.iter().enumerate().skip(1) {
        for part in 1..=40 {
            stepped.step(0.01 * (n as f64 - 1.0) + 0.000_25 * f64::from(part), at);
        }
        worst = worst.max((stepped.state[0] - wanted.displacement).abs());
    }
    assert!(exact.seen.stops(0).len() > 5);
    assert!(worst < 1e-9, "{worst:e}");
}
