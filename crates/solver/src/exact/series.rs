//! The motion of the structures of one body as power series: the recurrence of their equations of motion.
//!
//! With t = origin + x^p the equations m ü + c u̇ + f = F − m `a_g` give, power by power, the acceleration from forces
//! that are already known, and from it velocity and displacement p powers further on. One formula serves c = 0, k = 0,
//! critical damping and the plastic branch; structures at rest against each other share their acceleration.

use crate::exact::contact::{Contact, Link};
use crate::exact::member::Member;
use crate::excitation::Segment;
use crate::span::Power;

/// Expands the motion of the members of a body, and the forces between them, to `len` coefficients.
pub(super) fn expand(
    members: &mut [Member],
    contacts: &mut [Contact],
    ground: Segment,
    power: Power,
    len: usize,
) {
    let p = power.order();
    for member in members.iter_mut() {
        member.displacement[..2 * p].fill(0.0);
        member.velocity[..p].fill(0.0);
        member.displacement[0] = member.state.displacement;
        member.velocity[0] = member.state.velocity;
        member.displacement[p] = member.state.velocity;
    }
    for n in 0..len {
        for (index, contact) in contacts.iter_mut().enumerate() {
            if matches!(contact.link, Link::Touching(_)) {
                contact.find_force(&members[index..index + 2], power, n);
            }
        }
        let ground = if n == 0 {
            ground.value
        } else if n == p {
            ground.slope
        } else {
            0.0
        };
        // Off the chain of dependent operations, where a division would be the longest.
        let [once, twice] = [n + p, n + 2 * p].map(|order| p as f64 / order as f64);
        let mut first = 0;
        while first < members.len() {
            let mut last = first;
            while last < contacts.len() && contacts[last].link == Link::Resting {
                last += 1;
            }
            let left = if first == 0 {
                0.0
            } else {
                contacts[first - 1].force[n]
            };
            let right = if last == contacts.len() {
                0.0
            } else {
                contacts[last].force[n]
            };
            let block = &mut members[first..=last];
            accelerate(block, left - right, ground, n);
            for member in block.iter_mut() {
                member.velocity[n + p] = member.acceleration[n] * once;
                member.displacement[n + 2 * p] = member.velocity[n + p] * twice;
            }
            resting_forces(block, &mut contacts[first..last], (left, right), ground, n);
            first = last + 1;
        }
    }
}

/// Coefficient `n` of the acceleration that members at rest against each other share under a net force from outside.
fn accelerate(block: &mut [Member], force: f64, ground: f64, n: usize) {
    let acceleration = match &*block {
        [alone] if alone.is_wall() => 0.0,
        [alone] => {
            let own = alone.damping * alone.velocity[n] + alone.restoring_force(n);
            alone.inverse_mass * (force - own) - ground
        }
        several if several.iter().any(Member::is_wall) => 0.0,
        several => {
            let own =
                |member: &Member| member.damping * member.velocity[n] + member.restoring_force(n);
            let sum: f64 = several.iter().map(own).sum();
            let mass: f64 = several.iter().map(|member| member.mass).sum();
            (force - sum) / mass - ground
        }
    };
    for member in block {
        member.acceleration[n] = acceleration;
    }
}

/// Coefficient `n` of the forces between members at rest against each other, each from its lighter side.
fn resting_forces(
    block: &[Member],
    contacts: &mut [Contact],
    (left, right): (f64, f64),
    ground: f64,
    n: usize,
) {
    for (index, contact) in contacts.iter_mut().enumerate() {
        let mass = |members: &[Member]| members.iter().map(|member| member.mass).sum::<f64>();
        let (before, after) = block.split_at(index + 1);
        let needs = |members: &[Member]| {
            let need = |member: &Member| {
                member.mass * (member.acceleration[n] + ground)
                    + member.damping * member.velocity[n]
                    + member.restoring_force(n)
            };
            members.iter().map(need).sum::<f64>()
        };
        contact.force[n] = if mass(before) <= mass(after) {
            left - needs(before)
        } else {
            right + needs(after)
        };
    }
}

/// Largest length of a piece so that the last coefficients are below rounding, whatever branch its members take.
pub(super) fn radius(members: &[Member]) -> f64 {
    let fastest = members.iter().map(Member::fastest_rate).fold(0.0, f64::max);
    1.0 / fastest
}
