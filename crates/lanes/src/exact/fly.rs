//! Free flight in lanes: the state of a structure of every scene at the next sample, and whether it could turn before.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::pair::Side;
use crate::number::{Lanes, MOST_LANES, Mask};
use pounding_solver::Flight;

/// Newton steps to the turn of a cubic, and terms of a series that reach rounding within a flight.
const NEWTON: usize = 3;
const TERMS: usize = 22;
/// Part of the time to a turn within which the third derivative gives the rest.
const NEAR: f64 = 1e-3;

/// A structure of every scene, or its wall.
pub(super) struct Flyer<S: Simd> {
    /// Change of displacement, and velocity at the next sample, per unit of: velocity; constant load over mass; load over mass that grows
    /// by one per second.
    change: [Lanes<S>; 3],
    end: [Lanes<S>; 3],
    /// c/m \[1/s\], k/m \[1/s²\], and mobility: 1, or 0 for a wall.
    damping: Lanes<S>,
    stiffness: Lanes<S>,
    mobile: Lanes<S>,
    /// Bound of the acceleration during a flight, relative to its values at both ends and the load.
    growth: Lanes<S>,
    pub(super) displacement: Lanes<S>,
    velocity: Lanes<S>,
    /// Smallest and largest displacement so far \[m\].
    pub(super) extremes: [Lanes<S>; 2],
}

/// The way to the next sample.
#[derive(Clone, Copy)]
pub(super) struct Ahead<S: Simd> {
    /// Time to the sample \[s\].
    pub(super) length: f64,
    /// Acceleration of the ground \[m/s²\], and its slope \[m/s³\].
    pub(super) ground: Lanes<S>,
    pub(super) slope: Lanes<S>,
}

/// State of a structure at the next sample.
#[derive(Clone, Copy)]
pub(super) struct Landing<S: Simd> {
    pub(super) displacement: Lanes<S>,
    velocity: Lanes<S>,
    /// Largest distance during the flight from the line between the ends \[m\].
    pub(super) bow: Lanes<S>,
    /// Displacement at a turn during the flight, if it exceeds the extremes \[m\].
    turned: Lanes<S>,
}

impl<S: Simd> Flyer<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, sides: &[Side; MOST_LANES], step: f64) -> Self {
        let gather = |number: &dyn Fn(&Side) -> f64| {
            let mut values = [0.0; MOST_LANES];
            for (value, side) in values.iter_mut().zip(sides) {
                *value = number(side);
            }
            Lanes::new(simd, &values)
        };
        let weights = sides.map(|side| weights(&side, step));
        let weight = |place: usize, part: usize| Lanes::new(simd, &weights.map(|weights| weights[place][part]));
        let over_mass = |side: &Side| {
            let [damping, stiffness] = [side.damping, side.stiffness];
            [damping * side.inverse_mass, stiffness * side.inverse_mass]
        };
        let growth = |side: &Side| {
            let [damping, stiffness] = over_mass(side);
            // Every instant is at most half a step from one of the ends.
            1.0 / (1.0 - 0.5 * step * (damping + 0.5 * step * stiffness))
        };
        Self {
            change: std::array::from_fn(|part| weight(0, part)),
            end: std::array::from_fn(|part| weight(1, part)),
            damping: gather(&|side| over_mass(side)[0]),
            stiffness: gather(&|side| over_mass(side)[1]),
            mobile: gather(&|side| side.mobile),
            growth: gather(&growth),
            displacement: gather(&|side| side.displacement),
            velocity: gather(&|side| side.velocity),
            extremes: [gather(&|side| side.extremes[0]), gather(&|side| side.extremes[1])],
        }
    }

    /// The state at the next sample, and the lanes in which the structure could turn beyond its extremes at a turn that [`Self::turn`] has
    /// not located.
    #[inline(always)]
    pub(super) fn ahead(&self, Ahead { length, ground, slope }: Ahead<S>) -> (Landing<S>, Mask<S>) {
        let (u, v) = (self.displacement, self.velocity);
        let zero = u.like(0.0);
        let [ground, slope] = [ground, slope].map(|number| self.mobile * number);
        let last = ground + slope * u.like(length);
        let load = ground + self.stiffness * u;
        let by = |[velocity, constant, growing]: [Lanes<S>; 3]| velocity * v + constant * load + growing * slope;
        let (displacement, velocity) = (u + by(self.change), by(self.end));
        let before = zero - (self.damping * v + load);
        let after = zero - (self.damping * velocity + self.stiffness * displacement + last);
        let half = u.like(0.5 * length);
        let arc = half * half * u.like(0.5);
        let fastest = v.abs().max(velocity.abs());
        let push = self.stiffness * fastest + slope.abs();
        let most = self.growth * (before.abs().max(after.abs()) + half * push);
        let bow = arc * most;
        let mut landing = Landing {
            displacement,
            velocity,
            bow,
            turned: u,
        };
        let farther = (u.max(displacement) + bow).exceeds(self.extremes[1]);
        let farther = farther | self.extremes[0].exceeds(u.min(displacement) - bow);
        if !Lanes::any(farther) {
            return (landing, farther);
        }
        let jerk = self.damping * most + self.stiffness * (fastest + half * most) + slope.abs();
        let slowest = v.abs().min(velocity.abs());
        let on = v * velocity;
        let straight = on.exceeds(zero) & slowest.exceeds(arc * jerk);
        let turns = farther & !straight;
        if !Lanes::any(turns) {
            return (landing, turns);
        }
        let least = before.abs().min(after.abs());
        let bent = arc * (self.damping * jerk + self.stiffness * most);
        let one_way = (before * after).exceeds(zero) & least.exceeds(bent);
        let once = turns & zero.exceeds(on) & one_way;
        if Lanes::any(once) {
            let ends = [v, before, velocity, after];
            let (turned, found) = self.turn(slope, length, ends);
            let known = once & found;
            landing.turned = Number::select(known, turned, u);
            return (landing, turns & !known);
        }
        (landing, turns)
    }

    /// Displacement at the only zero of the velocity, and the lanes in which the zero is found to rounding. The velocity has these values
    /// and slopes at the ends of an interval.
    #[inline(always)]
    fn turn(&self, slope: Lanes<S>, length: f64, [v, a, velocity, acceleration]: [Lanes<S>; 4]) -> (Lanes<S>, Mask<S>) {
        let like = |number: f64| v.like(number);
        // The cubic through the ends; its zero by Newton's method from the secant.
        let (rise, first, last) = (velocity - v, like(length) * a, like(length) * acceleration);
        let cubic = first + last - rise - rise;
        let square = rise - first - cubic;
        let mut x = (like(0.0) - v) / rise;
        for _ in 0..NEWTON {
            let at = v + x * (first + x * (square + x * cubic));
            let change = first + x * (square + square + x * (cubic + cubic + cubic));
            x = x - at / change;
        }
        let time = x * like(length);
        // The series of the motion there, term by term.
        let (damping, stiffness) = (self.damping * time, self.stiffness * time * time);
        let mut terms = [self.displacement, v * time, a * time * time];
        let mut sums = terms;
        let mut growing = slope * time * time * time;
        for n in 1..TERMS {
            let part = like(1.0 / n as f64);
            let (u, v) = (terms[1] * part, terms[2] * part);
            let force = damping * v + stiffness * u + growing;
            growing = like(0.0);
            terms = [u, v, like(0.0) - force];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum = *sum + term;
            }
        }
        let [u, v, a] = sums;
        // The remaining time to the zero, as a part of this time: after the third derivative only rounding is left.
        let [half, sixth, zero] = [0.5, 1.0 / 6.0, 0.0].map(like);
        let jerk = zero - (stiffness * v + damping * a + slope * time * time * time);
        let straight = (zero - v) / a;
        let way = straight - half * (jerk / a) * straight * straight;
        let turned = u + way * (v + way * (half * a + way * sixth * jerk));
        (turned, like(NEAR).exceeds(way.abs()))
    }

    #[inline(always)]
    pub(super) fn land(&mut self, landing: Landing<S>) {
        self.displacement = landing.displacement;
        self.velocity = landing.velocity;
        let [least, largest] = self.extremes;
        self.extremes = [
            least.min(landing.displacement).min(landing.turned),
            largest.max(landing.displacement).max(landing.turned),
        ];
    }

    /// Copies the motion of a lane to a scene.
    #[inline(always)]
    pub(super) fn put(&self, lane: usize, side: &mut Side) {
        side.displacement = self.displacement.lane(lane);
        side.velocity = self.velocity.lane(lane);
        side.extremes = [self.extremes[0].lane(lane), self.extremes[1].lane(lane)];
    }

    /// Copies the motion of a scene to its lane.
    #[inline(always)]
    pub(super) fn take(&mut self, lane: usize, side: &Side) {
        self.displacement.set(lane, side.displacement);
        self.velocity.set(lane, side.velocity);
        self.extremes[0].set(lane, side.extremes[0]);
        self.extremes[1].set(lane, side.extremes[1]);
    }
}

impl<S: Simd> Flyer<S> {
    /// Whether it never moved.
    #[inline(always)]
    pub(super) fn rests(&self, lane: usize) -> bool {
        let [least, largest] = self.extremes.map(|extreme| extreme.lane(lane));
        least.total_cmp(&largest).is_eq()
    }
}

/// Displacement and velocity after an interval per unit of velocity, of load over mass and of its slope.
fn weights(side: &Side, step: f64) -> [[f64; 3]; 2] {
    let by = |velocity: f64, ground: [f64; 2]| {
        let flight = Flight {
            origin: 0.0,
            displacement: 0.0,
            velocity,
            restoring_force: 0.0,
            stiffness: side.stiffness,
            damping: side.damping,
            inverse_mass: side.inverse_mass,
            ground,
            len: side.len,
        };
        flight.ends(step)
    };
    let columns = [by(1.0, [0.0; 2]), by(0.0, [1.0, 0.0]), by(0.0, [0.0, 1.0])];
    [0, 1].map(|place| columns.map(|column| side.mobile * column[place]))
}
