//! What rounding leaves of coefficients that are zero: what a pair at rest is judged by.

use crate::exact::contact::Contact;
use crate::exact::groups::{Block, Group, Lighter, Side};
use crate::exact::member::Member;
use crate::exact::storey::magnitude;

/// Orders in time of a force at rest that are looked at for rounding.
const ORDERS: usize = 8;
/// The same between floors of buildings of several storeys, which feel each other two orders later from floor to floor.
const ORDERS_OF_FLOORS: usize = 13;
/// Rounding of a coefficient as a part of the sum of its terms' magnitudes.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Rounding of coefficient `n` of the deformation of a pair whose displacements and velocities are equal, from the
/// coefficients of both sides.
pub(super) fn noise(sides: &[Member], values: [f64; 2], p: usize, n: usize) -> f64 {
    let terms = if n >= 2 * p && n.is_multiple_of(p) {
        let order = n / p - 2;
        let weight = ((order + 1) * (order + 2)) as f64;
        (sides[0].noise(order) + sides[1].noise(order)) / weight
    } else {
        0.0
    };
    ROUNDING * (values[0].abs() + values[1].abs() + terms)
}

/// Finds what rounding of the coefficients of a body is measured by; clears forces at rest that are rounding.
pub(super) fn clean(
    group: Group<'_>,
    (members, contacts): (&mut [Member], &mut [Contact]),
    time: f64,
    p: usize,
) {
    for block in group.blocks() {
        let outside = |pair: Option<usize>| pair.map_or(0.0, |pair| contacts[pair].force[0].abs());
        let pushed = outside(block.left) + outside(block.right);
        for node in block.first..=block.last {
            members[node].terms.own = magnitude(members, node);
        }
        let nodes = &mut members[block.first..=block.last];
        let own: f64 = nodes.iter().map(|member| member.terms.own).sum();
        let mass: f64 = nodes.iter().map(|member| member.mass).sum();
        let fastest = |rate: f64, member: &Member| rate.max(member.fastest_rate);
        let rate = nodes.iter().fold(0.0, fastest);
        let first = nodes[0].arrival;
        let grounds = nodes.iter().map(|member| member.ground.value.abs());
        let acceleration = if mass.is_finite() {
            (own + pushed) / mass + grounds.fold(0.0, f64::max)
        } else if nodes
            .iter()
            .any(|member| member.arrival.total_cmp(&first).is_ne())
        {
            // The wall's ground carries them, and their own is taken off.
            grounds.sum()
        } else {
            0.0
        };
        for member in nodes {
            member.terms = Terms {
                own: member.terms.own,
                acceleration,
                around: acceleration,
                ground: (member.ground.value.abs(), member.ground.slope.abs()),
                rate,
                time,
            };
        }
    }
    share(group, members);
    for block in group.blocks() {
        clear_rounding(block, (members, contacts), p);
    }
}

/// Clears the first coefficients of the forces at rest of a block that are rounding, of each pair all when the first ones are.
fn clear_rounding(block: &Block, (members, contacts): (&[Member], &mut [Contact]), p: usize) {
    let tied = members[block.first..=block.last]
        .iter()
        .any(Member::is_tied);
    let orders = if tied { ORDERS_OF_FLOORS } else { ORDERS };
    for order in 0..orders {
        let side = |node: usize| {
            // Of a wall it may be no number: it is never the lighter side.
            let need = Some(members[node].need_of_noise(order, p));
            let need = need.filter(|need| !need.is_nan()).unwrap_or(f64::INFINITY);
            Side { weight: need, need }
        };
        block.tell_lighter_sides(side, |index, least| {
            let (Lighter::Left(least) | Lighter::Right(least)) = least;
            let force = &mut contacts[block.within + index].force[order * p];
            if force.abs() <= ROUNDING * least {
                *force = 0.0;
            }
        });
    }
    for contact in &mut contacts[block.within..block.within + (block.last - block.first)] {
        let mut first = contact.force.iter().step_by(p).take(orders);
        if first.all(|force| *force == 0.0) {
            contact.force.fill(0.0);
        }
    }
}

/// What storeys join rounds by the largest of its accelerations, from the next coefficient on.
fn share(group: Group<'_>, members: &mut [Member]) {
    if group.followed().is_empty() {
        return;
    }
    let largest = |value: fn(&Member) -> f64| {
        let nodes = group.nodes().iter();
        nodes.fold(0.0, |largest: f64, node| {
            largest.max(value(&members[*node]))
        })
    };
    let (around, rate) = (
        largest(|member| member.terms.acceleration),
        largest(|member| member.terms.rate),
    );
    for node in group.nodes() {
        let member = &mut members[*node];
        if member.is_tied() {
            (member.terms.around, member.terms.rate) = (around, rate);
        }
    }
}

/// What the first coefficients of an acceleration are sums of.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Terms {
    /// Magnitude of the terms of the own forces \[N\].
    own: f64,
    /// Sum of the magnitudes of the terms of the acceleration \[m/s²\].
    acceleration: f64,
    /// The largest of those that storeys join with it.
    around: f64,
    /// Magnitude of the ground acceleration and its slope.
    ground: (f64, f64),
    /// The fastest rate of those that share the acceleration, or that storeys join, \[1/s\].
    rate: f64,
    /// Now \[s\].
    time: f64,
}

impl Member {
    /// What rounding of the acceleration's coefficient of this order in time is a part of: its terms, and what it
    /// changes by in the time that has passed, whose rounding is that of every instant.
    fn noise(&self, order: usize) -> f64 {
        let next = (order + 1) as f64 * self.magnitude_of(order + 1);
        self.magnitude_of(order) + self.terms.time * next
    }

    /// What rounding of a force that moves it is a part of; columns that yield smoothly have coefficients that grow faster than the
    /// terms tell.
    fn need_of_noise(&self, order: usize, p: usize) -> f64 {
        if order == 0 {
            self.mass * (self.noise(order) + self.terms.ground.0) + self.terms.own
        } else {
            let found = self.acceleration[order * p].abs();
            self.mass * self.noise(order).max(found)
        }
    }

    /// Rounding of coefficient `n` of the velocity.
    pub(super) fn noise_of_velocity(&self, p: usize, n: usize) -> f64 {
        if n >= p && n.is_multiple_of(p) {
            let order = n / p - 1;
            ROUNDING * self.noise(order) / (order + 1) as f64
        } else {
            0.0
        }
    }

    fn magnitude_of(&self, order: usize) -> f64 {
        let terms = &self.terms;
        if order == 0 {
            return terms.acceleration;
        }
        let mut noise = terms.around;
        for n in 1..=order {
            noise *= terms.rate / n as f64;
            if n == 1 {
                noise += terms.ground.1;
            }
        }
        noise
    }
}
