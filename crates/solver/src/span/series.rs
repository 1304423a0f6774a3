//! Power series of the exact method: a motion that is known between the ends of its span.

use super::{Motion, State};
use crate::quadrature::{self, Rule, Sides};

/// A motion as power series in x, with t = origin + x^power.
///
/// The power is 1, except just after the first touch of a compliant pair, where forces are series in the fourth root of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series<'a> {
    pub(crate) origin: f64,
    pub(crate) power: Power,
    /// x at the end of a span shorter than the resolution of time, whose duration instants cannot give; infinite for longer spans.
    pub(crate) end: f64,
    pub(crate) displacement: &'a [f64],
    pub(crate) velocity: &'a [f64],
    pub(crate) acceleration: &'a [f64],
    /// Displacement and velocity of the floor below; `None` for a floor on the ground.
    pub(crate) below: Option<[&'a [f64]; 2]>,
    /// Restoring force at the first coefficient of the displacement \[N\], and its tangent \[N/m\].
    pub(crate) restoring_force: (f64, f64),
    /// For columns that yield smoothly, the part of the force that is not linear in the drift, (1 − a) k z \[N\]. `restoring_force`
    /// contains its start, too. Empty for all other columns.
    pub(crate) bent: &'a [f64],
    /// Magnitude of the pounding force from the left \[N\].
    pub(crate) force_from_left: &'a [f64],
    pub(crate) force_from_right: &'a [f64],
}

/// The power p in t = origin + x^p.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Power {
    One,
    Four,
}

impl Power {
    /// x at a time after the origin \[s\], ≥ 0 for the power four.
    pub(crate) fn root(self, time: f64) -> f64 {
        match self {
            Self::One => time,
            Self::Four => time.sqrt().sqrt(),
        }
    }

    /// Time after the origin at x.
    pub(crate) fn time(self, x: f64) -> f64 {
        match self {
            Self::One => x,
            Self::Four => (x * x) * (x * x),
        }
    }

    /// dt/dx.
    pub(crate) fn rate(self, x: f64) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Four => 4.0 * (x * x) * x,
        }
    }

    /// The power as a number.
    pub(crate) fn order(self) -> usize {
        match self {
            Self::One => 1,
            Self::Four => 4,
        }
    }
}

/// Value of a polynomial with these coefficients, the lowest power first.
#[inline]
pub fn value(coefficients: &[f64], x: f64) -> f64 {
    let sum = |sum, coefficient: &f64| sum * x + coefficient;
    coefficients.iter().rev().fold(0.0, sum)
}

/// Increase of a polynomial since x = 0.
#[inline]
pub(crate) fn rise(coefficients: &[f64], x: f64) -> f64 {
    x * value(coefficients.get(1..).unwrap_or_default(), x)
}

/// [Values](value) at all nodes of a rule together. Each has the bits of a separate evaluation, and none waits for another.
#[inline]
fn values<const HALF: usize>(coefficients: &[f64], nodes: &Sides<HALF>) -> Sides<HALF> {
    let mut sums = [[0.0; HALF]; 2];
    for coefficient in coefficients.iter().rev() {
        let sums = sums.as_flattened_mut().iter_mut();
        for (sum, x) in sums.zip(nodes.as_flattened()) {
            *sum = *sum * x + coefficient;
        }
    }
    sums
}

/// [Rises](rise) at all nodes of a rule together.
#[inline]
fn rises<const HALF: usize>(coefficients: &[f64], nodes: &Sides<HALF>) -> Sides<HALF> {
    let mut rises = values(coefficients.get(1..).unwrap_or_default(), nodes);
    let all = rises.as_flattened_mut().iter_mut();
    for (rise, x) in all.zip(nodes.as_flattened()) {
        *rise *= x;
    }
    rises
}

impl Series<'_> {
    /// x at an instant \[s\].
    pub(crate) fn x(&self, time: f64) -> f64 {
        self.power.root((time - self.origin).max(0.0)).min(self.end)
    }

    /// The instant at x \[s\].
    pub(crate) fn time(&self, x: f64) -> f64 {
        self.origin + self.power.time(x)
    }

    /// Drift of the storey below a floor with this motion at x.
    #[inline]
    pub(crate) fn drift(&self, floor: Motion, x: f64) -> Motion {
        match self.below {
            None => floor,
            Some([displacement, velocity]) => floor.since(Motion {
                displacement: value(displacement, x),
                velocity: value(velocity, x),
            }),
        }
    }

    /// Integrals over time of N functions of instant, state and drift of the storey below, between two values of x.
    #[inline]
    pub(super) fn integrate<const N: usize, const HALF: usize>(
        &self,
        rule: &Rule<HALF>,
        [first, last]: [f64; 2],
        integrand: impl Fn(f64, &State, Motion) -> [f64; N],
    ) -> [f64; N] {
        quadrature::integrate_at_once(rule, first, last, |nodes| {
            let (state, integrand) = (self.states(nodes), &integrand);
            move |side: usize, number: usize| {
                let x = nodes[side][number];
                let (state, drift) = state(side, number);
                let time = self.time(x);
                let rate = self.power.rate(x);
                integrand(time, &state, drift).map(|value| rate * value)
            }
        })
    }

    /// [States](Self::at) and [drifts](Self::drift) of the storey below at the nodes of a rule, by side and number.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "an integrand that asks for no acceleration does not pay for it")]
    fn states<const HALF: usize>(&self, nodes: Sides<HALF>) -> impl Fn(usize, usize) -> (State, Motion) {
        let nodes = &nodes;
        let rise = rises(self.displacement, nodes);
        let velocity = values(self.velocity, nodes);
        let acceleration = values(self.acceleration, nodes);
        let bent = rises(self.bent, nodes);
        let force_from_left = values(self.force_from_left, nodes);
        let force_from_right = values(self.force_from_right, nodes);
        let first = |coefficients: &[f64]| *coefficients.first().unwrap_or(&0.0);
        let below = self.below.map(|[displacement, velocity]| {
            let rises = rises(displacement, nodes);
            (first(displacement), rises, values(velocity, nodes))
        });
        let first = first(self.displacement);
        let (force, tangent) = self.restoring_force;
        let bends = !self.bent.is_empty();
        move |side, node| {
            let of = |all: &Sides<HALF>| all[side][node];
            let drift = match &below {
                None => of(&rise),
                Some((_, below, _)) => of(&rise) - of(below),
            };
            let line = force + tangent * drift;
            let state = State {
                displacement: first + of(&rise),
                velocity: of(&velocity),
                acceleration: of(&acceleration),
                restoring_force: if bends { line + of(&bent) } else { line },
                force_from_left: of(&force_from_left),
                force_from_right: -of(&force_from_right),
            };
            let floor = Motion::from(&state);
            let drift = below.as_ref().map_or(floor, |(first, rise, velocity)| {
                floor.since(Motion {
                    displacement: first + of(rise),
                    velocity: of(velocity),
                })
            });
            (state, drift)
        }
    }

    /// State at x.
    #[inline]
    pub(crate) fn at(&self, x: f64) -> State {
        let rise = rise(self.displacement, x);
        let drift = match self.below {
            None => rise,
            Some([below, _]) => rise - self::rise(below, x),
        };
        let line = self.restoring_force.0 + self.restoring_force.1 * drift;
        State {
            displacement: self.displacement.first().unwrap_or(&0.0) + rise,
            velocity: value(self.velocity, x),
            acceleration: value(self.acceleration, x),
            restoring_force: if self.bent.is_empty() {
                line
            } else {
                line + self::rise(self.bent, x)
            },
            force_from_left: value(self.force_from_left, x),
            force_from_right: -value(self.force_from_right, x),
        }
    }
}
