//! Forces of storeys on the floors above and below them, coefficient by coefficient.

use crate::exact::member::{Member, Upper};
use crate::roots::CAPACITY;

/// Clears the drifts of these nodes.
pub(super) fn begin(members: &mut [Member], nodes: &[usize]) {
    for node in nodes {
        let member = &mut members[*node];
        if let Some(linked) = &mut member.linked {
            (linked.against, linked.magnitude) = ([0.0; CAPACITY], 0.0);
        }
        if let Some(storey) = &mut member.storey {
            (storey.drift, storey.rate) = ([0.0; CAPACITY], [0.0; CAPACITY]);
        }
        if let Some(bend) = &mut member.bend {
            bend.begin(member.hysteretic_force);
        }
    }
}

/// Finds coefficient `n` of the drifts of these nodes, and of their smooth columns, from that of the motion.
pub(super) fn follow(members: &mut [Member], nodes: &[usize], p: usize, n: usize) {
    for node in nodes {
        let (lower, upper) = members.split_at_mut(*node);
        let Some(member) = upper.first_mut() else {
            continue;
        };
        if let Some(storey) = &mut member.storey {
            let below = &lower[storey.below];
            let drift = member.displacement[n] - below.displacement[n];
            let rate = member.velocity[n] - below.velocity[n];
            storey.find(drift, rate, p, n);
        }
        let drift = member.storey.as_ref().map_or(&member.displacement, |storey| &storey.drift);
        if let Some(bend) = &mut member.bend {
            bend.find(drift, n);
        }
    }
}

impl Upper {
    fn find(&mut self, drift: f64, rate: f64, p: usize, n: usize) {
        self.drift[n] = if self.still && n == p { 0.0 } else { drift };
        self.rate[n] = if self.still && n == 0 { 0.0 } else { rate };
    }
}

/// Coefficient `n` of the force of dampers and columns against the motion of a node.
#[inline]
pub(super) fn own_force(members: &[Member], node: usize, n: usize) -> f64 {
    let member = &members[node];
    if member.plain {
        return member.damping * member.velocity[n] + member.force_of(member.displacement[n], n);
    }
    let own = member.damping * member.drift_rate()[n] + member.restoring_force(n);
    if member.is_tied() { own + tie(members, member, n) } else { own }
}

/// Coefficient `n` of the force that a node needs for its motion.
pub(super) fn need(members: &[Member], node: usize, p: usize, n: usize) -> f64 {
    let member = &members[node];
    let ground = member.ground.coefficient(n, p);
    let inertia = member.mass * (member.acceleration[n] + ground);
    if member.plain {
        return inertia + member.damping * member.velocity[n] + member.force_of(member.displacement[n], n);
    }
    inertia + own_force(members, node, n)
}

/// Force of the ground damper, of the storey above and of links, which adds to that of a floor's storey.
fn tie(members: &[Member], member: &Member, n: usize) -> f64 {
    let ground = member.ground_damping * member.velocity[n];
    let storeys = member.above.map_or(ground, |above| {
        let above = &members[above];
        ground - (above.damping * above.drift_rate()[n] + above.restoring_force(n))
    });
    member.linked.as_ref().map_or(storeys, |linked| storeys + linked.against[n])
}

/// Magnitude of the terms of damping and column forces on a node \[N\]. A restoring force near zero has the rounding of its amplitude.
pub(super) fn magnitude(members: &[Member], node: usize) -> f64 {
    let member = &members[node];
    let linked = member.linked.as_ref().map_or(0.0, |linked| linked.magnitude);
    let own = storey_magnitude(members, member) + linked;
    let Some(above) = member.above else {
        return own;
    };
    own + storey_magnitude(members, &members[above])
}

fn storey_magnitude(members: &[Member], member: &Member) -> f64 {
    let speed = |member: &Member| member.state.velocity.abs();
    let (floor, rate) = (speed(member), member.fastest_rate);
    let (drift, ground) = match &member.storey {
        None => (floor, 0.0),
        Some(storey) => (floor + speed(&members[storey.below]), member.ground_damping * floor),
    };
    let amplitude = if rate > 0.0 { drift / rate } else { 0.0 };
    member.damping * drift + member.state.restoring_force.abs() + member.tangent().abs() * amplitude + ground
}

/// Present rate of the drift of a node's storey \[m/s\].
pub(super) fn rate_of_drift(members: &[Member], node: usize) -> f64 {
    let member = &members[node];
    match &member.storey {
        None => member.state.velocity,
        Some(storey) if storey.still => 0.0,
        Some(storey) => member.state.velocity - members[storey.below].state.velocity,
    }
}
