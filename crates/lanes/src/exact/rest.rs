//! Neighbours that come to rest against each other by an impulsive law, and move together while they press.

use super::Interval;
use super::pair::{Bounces, Link, Opening, Scene, Side};
use pounding_solver::Flight;
use pounding_solver::formulas::{BURST, CHATTER, ROUNDING_OF_COEFFICIENTS, bounces_are_over};
use pounding_solver::formulas::{CAPACITY, quick_first_root};
use pounding_solver::formulas::{Expansion, value};

/// A coefficient below [`ROUNDING_OF_COEFFICIENTS`] times its terms is zero; above this part of its terms its sign is certain. In between
/// the scene is given up.
const CERTAIN: f64 = 1e-9;

/// Behaviour of neighbours that touch without a rate.
enum Decision {
    /// Their gap opens, or they press; all coefficients of the free deformation below this order are zero.
    Parts(usize),
    Presses(usize),
    /// They move alike.
    Alike,
}

impl Scene {
    /// An impact at a rate \[m/s\], under this ground acceleration \[m/s²\]. If its bounces would end at once, it is the last.
    pub(super) fn strike(&mut self, rate: f64, restitution: f64, ground: f64) {
        let [left, right] = &self.sides;
        let momentum = self.reduced_mass * rate;
        let bounced = (1.0 + restitution) * momentum;
        let closing = left.acceleration(left.velocity - left.inverse_mass * bounced, ground)
            - right.acceleration(right.velocity + right.inverse_mass * bounced, ground);
        let at_once = self.at - self.bounces.last < CHATTER;
        let over = bounces_are_over(-restitution * rate, closing, restitution) || at_once && self.bounces.burst >= BURST;
        let (impulse, rate) = if over || restitution == 0.0 {
            (momentum, 0.0)
        } else {
            (bounced, -restitution * rate)
        };
        let [left, right] = &mut self.sides;
        left.velocity -= left.inverse_mass * impulse;
        right.velocity += right.inverse_mass * impulse;
        self.tally.collisions += 1.0;
        self.struck = 0.0;
        self.push(impulse);
        self.bounces = Bounces {
            last: self.at,
            burst: if at_once { self.bounces.burst + 1 } else { 0 },
        };
        self.link = if rate < 0.0 {
            Link::Parting(Opening::At(0.0, rate))
        } else {
            Link::Closed { is_struck: true }
        };
    }

    /// Adds the impulse of a rest to that of the last impact \[N·s\].
    fn push(&mut self, impulse: f64) {
        self.struck += impulse;
        self.tally.impulse += impulse;
        self.tally.largest_impulse = self.tally.largest_impulse.max(self.struck);
    }

    /// Puts the pair at rest or parts it, by the first coefficient of the free deformation that is not rounding.
    pub(super) fn settle(&mut self, ahead: &Interval, is_struck: bool) {
        match self.decide(ahead) {
            Some(Decision::Parts(order)) => self.link = Link::Parting(Opening::Order(order)),
            // Rest without an impact has a peak force, which is not computed here. The start of pressing of compliant neighbours is not
            // computed either.
            Some(Decision::Presses(order)) if is_struck => self.rest(order - 2),
            Some(Decision::Alike) if self.law.impulsive().is_some() => self.rest(usize::MAX),
            Some(Decision::Presses(_) | Decision::Alike) | None => self.give_up(),
        }
    }

    /// Gives the lighter side the velocity of the heavier side.
    fn rest(&mut self, zero_orders: usize) {
        let (base, apart) = self.base();
        let Side {
            displacement, velocity, ..
        } = self.sides[base];
        let lighter = &mut self.sides[1 - base];
        (lighter.displacement, lighter.velocity) = (displacement + apart, velocity);
        self.link = Link::Resting { zero_orders };
    }

    /// Decides between rest and parting; `None` if the deciding coefficient may be rounding.
    fn decide(&self, ahead: &Interval) -> Option<Decision> {
        let mut rooms = [Expansion::default(), Expansion::default()];
        let ground = [ahead.value, ahead.slope];
        for (side, room) in self.sides.iter().zip(&mut rooms) {
            side.expand(ground, room);
        }
        let [left, right] = &self.sides;
        let len = left.len.min(right.len);
        let series = rooms.each_ref().map(|room| room.displacement(len));
        let alike = (2..len).all(|order| series[0][order] - series[1][order] == 0.0);
        if alike {
            return Some(Decision::Alike);
        }
        // Displacements within the rounding of larger ones do not count.
        let mut sizes = self.sides.each_ref().map(|side| {
            let [least, largest] = side.extremes;
            let force = side.damping * side.velocity.abs() + side.stiffness * largest.max(-least);
            side.inverse_mass * force + side.mobile * ground[0].abs()
        });
        for order in 2..len {
            let known = (order * (order - 1)) as f64;
            let [one, other] = series.map(|series| series[order]);
            let size = one.abs() + other.abs() + (sizes[0] + sizes[1]) / known;
            let difference = one - other;
            if difference.abs() > CERTAIN * size {
                return Some(if difference > 0.0 {
                    Decision::Presses(order)
                } else {
                    Decision::Parts(order)
                });
            }
            if difference.abs() > ROUNDING_OF_COEFFICIENTS * size {
                return None;
            }
            for (size, side) in sizes.iter_mut().zip(&self.sides) {
                *size *= side.fastest_rate() / (order - 1) as f64;
                if order == 2 {
                    *size += side.mobile * ground[1].abs();
                }
            }
        }
        None
    }

    /// Index of the heavier side, or of the wall, and the displacement at rest of the other side relative to it \[m\].
    fn base(&self) -> (usize, f64) {
        let [left, right] = &self.sides;
        if left.inverse_mass <= right.inverse_mass {
            (0, -self.gap)
        } else {
            (1, self.gap)
        }
    }

    /// The common motion of both sides, as that of the heavier side.
    fn as_one(&self, ahead: &Interval) -> Flight {
        let (base, apart) = self.base();
        let [heavier, lighter] = [&self.sides[base], &self.sides[1 - base]];
        let of_lighter = lighter.stiffness * (heavier.displacement + apart);
        let inverse_mass = if heavier.inverse_mass == 0.0 {
            0.0
        } else {
            1.0 / (1.0 / heavier.inverse_mass + 1.0 / lighter.inverse_mass)
        };
        Flight {
            origin: 0.0,
            displacement: heavier.displacement,
            velocity: heavier.velocity,
            restoring_force: heavier.stiffness * heavier.displacement + of_lighter,
            stiffness: heavier.stiffness + lighter.stiffness,
            damping: heavier.damping + lighter.damping,
            inverse_mass,
            ground: [ahead.value, ahead.slope].map(|number| heavier.mobile * number),
            len: heavier.len.max(lighter.len),
        }
    }

    /// Moves both together until the force fades, either side turns, or the sample arrives. `zero_orders` coefficients of the force are
    /// zero at first.
    pub(super) fn rest_on(&mut self, ahead: &Interval, zero_orders: usize) {
        let (base, apart) = self.base();
        let flight = self.as_one(ahead);
        let len = flight.len;
        let mut room = Expansion::default();
        flight.expand(&mut room);
        let [displacement, rates] = [room.displacement(len), room.velocity(len)];
        let lighter = &self.sides[1 - base];
        // Minus the contact force [N]: the force fades where this rises through zero.
        let mut series = [0.0; CAPACITY];
        let minus_force = &mut series[..len];
        // A force pushes the lighter side to the right if it is the right side.
        let toward = if base == 0 { -1.0 } else { 1.0 };
        for (order, force) in minus_force.iter_mut().enumerate().skip(zero_orders) {
            let ground = [ahead.value, ahead.slope].get(order).copied();
            let ground = lighter.mobile * ground.unwrap_or(0.0);
            let start = if order == 0 { apart } else { 0.0 };
            let inertia = (room.acceleration(len)[order] + ground) / lighter.inverse_mass;
            let column = lighter.stiffness * (displacement[order] + start);
            *force = toward * (inertia + lighter.damping * rates[order] + column);
        }
        let mut length = ahead.length;
        let fades = quick_first_root(minus_force, length);
        length = fades.unwrap_or(length);
        let mut turned = false;
        for side in &self.sides {
            if let Some(turn) = side.turn([displacement, rates], length) {
                (length, turned) = (turn, true);
            }
        }
        self.push(-integral(minus_force, length));
        let pushes = minus_force.iter().any(|force| *force != 0.0);
        let end = [value(displacement, length), value(rates, length)];
        self.sides[base].displacement = end[0];
        self.sides[1 - base].displacement = end[0] + apart;
        for side in &mut self.sides {
            side.velocity = if turned { 0.0 } else { end[1] };
            side.reach(side.displacement);
        }
        self.at += length;
        self.link = if (fades.is_some() && !turned) || !pushes {
            // A collision ends with its force: a later force without an impact is another collision.
            Link::Closed { is_struck: pushes }
        } else {
            Link::Resting { zero_orders: 0 }
        };
        if fades.is_none() && !turned {
            self.arrive();
        }
    }
}

/// Integral of a series from 0 to x.
fn integral(coefficients: &[f64], x: f64) -> f64 {
    let terms = coefficients.iter().enumerate().rev();
    x * terms.fold(0.0, |sum, (order, coefficient)| sum * x + coefficient / (order + 1) as f64)
}

impl Side {
    /// Acceleration relative to the ground \[m/s²\] of the free side at this velocity.
    fn acceleration(&self, velocity: f64, ground: f64) -> f64 {
        let force = self.damping * velocity + self.stiffness * self.displacement;
        -self.inverse_mass * force - self.mobile * ground
    }
}
