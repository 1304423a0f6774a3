//! What rounding leaves of coefficients that are zero: what a pair at rest is judged by.

use crate::exact::contact::{Contact, Link};
use crate::exact::member::Member;
use crate::excitation::Segment;

/// Orders in time of a force at rest that are looked at for rounding.
const ORDERS: usize = 8;
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
    members: &mut [Member],
    contacts: &mut [Contact],
    (ground, time): (Segment, f64),
    p: usize,
) {
    let mut first = 0;
    while first < members.len() {
        let mut last = first;
        while last < contacts.len() && contacts[last].link == Link::Resting {
            last += 1;
        }
        let outside =
            |contact: Option<&Contact>| contact.map_or(0.0, |contact| contact.force[0].abs());
        let pushed =
            outside(first.checked_sub(1).map(|left| &contacts[left])) + outside(contacts.get(last));
        let block = &mut members[first..=last];
        let own: f64 = block.iter().map(Member::magnitude).sum();
        let mass: f64 = block.iter().map(|member| member.mass).sum();
        let rate = block.iter().map(Member::fastest_rate).fold(0.0, f64::max);
        for member in block.iter_mut() {
            member.terms = Terms {
                acceleration: if mass.is_finite() {
                    (own + pushed) / mass + ground.value.abs()
                } else {
                    0.0
                },
                ground: (ground.value.abs(), ground.slope.abs()),
                rate,
                time,
            };
        }
        for (index, contact) in contacts[first..last].iter_mut().enumerate() {
            contact.clear_rounding(block, index, p);
        }
        first = last + 1;
    }
}

/// What the first coefficients of an acceleration are sums of.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Terms {
    /// Sum of the magnitudes of the terms of the acceleration \[m/s²\].
    acceleration: f64,
    /// Magnitude of the ground acceleration and its slope.
    ground: (f64, f64),
    /// The fastest rate of the structures that share the acceleration \[1/s\].
    rate: f64,
    /// Now \[s\].
    time: f64,
}

impl Member {
    /// Magnitude of the terms of the own forces \[N\]; a restoring force near zero has the rounding of the amplitude.
    fn magnitude(&self) -> f64 {
        let (speed, rate) = (self.state.velocity.abs(), self.fastest_rate());
        let amplitude = if rate > 0.0 { speed / rate } else { 0.0 };
        self.damping * speed + self.state.restoring_force.abs() + self.tangent() * amplitude
    }

    /// What rounding of the acceleration's coefficient of this order in time is a part of: its terms, and what it
    /// changes by in the time that has passed, whose rounding is that of every instant.
    fn noise(&self, order: usize) -> f64 {
        let next = (order + 1) as f64 * self.magnitude_of(order + 1);
        self.magnitude_of(order) + self.terms.time * next
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
        let mut noise = terms.acceleration;
        for n in 1..=order {
            noise *= terms.rate / n as f64;
            if n == 1 {
                noise += terms.ground.1;
            }
        }
        noise
    }
}

impl Contact {
    /// Clears the first coefficients of a force at rest that are rounding, and all when the first ones are.
    fn clear_rounding(&mut self, block: &[Member], index: usize, p: usize) {
        let (before, after) = block.split_at(index + 1);
        let mut rounding = true;
        for order in 0..ORDERS {
            let need = |side: &[Member]| {
                let need = |member: &Member| {
                    let ground = if order == 0 {
                        member.terms.ground.0
                    } else {
                        0.0
                    };
                    member.mass * (member.noise(order) + ground)
                        + if order == 0 { member.magnitude() } else { 0.0 }
                };
                side.iter().map(need).sum::<f64>()
            };
            let force = &mut self.force[order * p];
            if force.abs() <= ROUNDING * need(before).min(need(after)) {
                *force = 0.0;
            } else {
                rounding = false;
            }
        }
        if rounding {
            self.force.fill(0.0);
        }
    }
}
