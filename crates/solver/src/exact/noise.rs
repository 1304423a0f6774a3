//! Rounding of coefficients that should be zero. It decides whether a pair at rest has a force.

use crate::exact::contact::{Join, PairState};
use crate::exact::groups::{Block, Group, Lighter, Side};
use crate::exact::member::{Member, Terms};
use crate::exact::rounding::{OF_COEFFICIENTS, weighed};
use crate::exact::storey::magnitude;
use crate::exact::tie::Tie;
use crate::model::incidence::Incidence;

/// Orders in time of a force at rest that are checked for rounding.
const ORDERS: usize = 8;
/// Orders between floors of buildings of several storeys: each floor in between delays the effect by two orders.
const ORDERS_OF_FLOORS: usize = 13;

/// Finds the scale of the rounding of the coefficients of a body; clears forces at rest that are only rounding.
pub(super) fn clean(group: Group<'_>, members: &mut [Member], contacts: &mut [PairState], incidence: &Incidence, time: f64, p: usize) {
    if !group.is_of_chain() {
        for node in group.nodes() {
            measure(*node, members, contacts, incidence, time);
        }
        share(group, members);
        if let Some(tie) = group.tie() {
            clear_ties(tie, members, contacts, p);
        }
        return;
    }
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
        } else if nodes.iter().any(|member| member.arrival.total_cmp(&first).is_ne()) {
            // The ground of the wall carries the nodes, and their own ground is subtracted.
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
        clear_rounding(block, members, contacts, p);
    }
}

/// Finds the scale for a node of any row, from its forces and those of all its pairs.
fn measure(node: usize, members: &mut [Member], contacts: &[PairState], incidence: &Incidence, time: f64) {
    let own = magnitude(members, node);
    let pushes = incidence.at(node).iter();
    let pushed: f64 = pushes
        .filter(|at| contacts[at.pair].join != Join::Apart)
        .map(|at| at.part * contacts[at.pair].force[0].abs())
        .sum();
    let member = &mut members[node];
    let ground = (member.ground.value.abs(), member.ground.slope.abs());
    let acceleration = if member.is_still() {
        0.0
    } else {
        (own + pushed) * member.inverse_mass + ground.0
    };
    member.terms = Terms {
        own,
        acceleration,
        around: acceleration,
        ground,
        rate: member.fastest_rate,
        time,
    };
}

/// Clears the leading coefficients of forces at rest that are only rounding, for any row. A pair whose first coefficients are all rounding
/// loses all.
fn clear_ties(tie: &Tie, members: &[Member], contacts: &mut [PairState], p: usize) {
    for order in 0..ORDERS_OF_FLOORS {
        let noise = |node: usize| {
            let member = &members[node];
            let ground = if order == 0 { member.terms.ground.0 } else { 0.0 };
            member.noise(order) + ground
        };
        let of_pair = |pair: &usize| {
            let [left, right] = contacts[*pair].relation.points();
            OF_COEFFICIENTS * (weighed(left, noise) + weighed(right, noise))
        };
        let magnitudes: Vec<_> = tie.pairs.iter().map(of_pair).collect();
        for (place, pair) in tie.pairs.iter().enumerate() {
            let force = &mut contacts[*pair].force[order * p];
            if force.abs() <= tie.size(place, &magnitudes) {
                *force = 0.0;
            }
        }
    }
    for pair in &tie.pairs {
        forget_if_nothing(&mut contacts[*pair], ORDERS_OF_FLOORS, p);
    }
}

/// Clears a force at rest if its first coefficients, one per order in time, are zero.
fn forget_if_nothing(contact: &mut PairState, orders: usize, p: usize) {
    let mut first = contact.force.iter().step_by(p).take(orders);
    if first.all(|force| *force == 0.0) {
        contact.force.fill(0.0);
    }
}

/// Clears the leading coefficients of forces at rest of a block that are only rounding. A pair whose first coefficients are all rounding
/// loses all.
fn clear_rounding(block: &Block, members: &[Member], contacts: &mut [PairState], p: usize) {
    if block.first == block.last {
        return;
    }
    let tied = members[block.first..=block.last].iter().any(Member::is_tied);
    let orders = if tied { ORDERS_OF_FLOORS } else { ORDERS };
    for order in 0..orders {
        let side = |node: usize| {
            // The need of a wall may be NaN: a wall is never the lighter side.
            let need = Some(members[node].need_of_noise(order, p));
            let need = need.filter(|need| !need.is_nan()).unwrap_or(f64::INFINITY);
            Side { weight: need, need }
        };
        block.tell_lighter_sides(side, |index, least| {
            let (Lighter::Left(least) | Lighter::Right(least)) = least;
            let force = &mut contacts[block.within + index].force[order * p];
            if force.abs() <= OF_COEFFICIENTS * least {
                *force = 0.0;
            }
        });
    }
    for contact in &mut contacts[block.within..block.within + (block.last - block.first)] {
        forget_if_nothing(contact, orders, p);
    }
}

/// Gives joined floors, and floors at rest in a row that is no chain, the largest of their accelerations as scale of the rounding, from the
/// next coefficient on.
fn share(group: Group<'_>, members: &mut [Member]) {
    let rests = group.tie().is_some();
    if group.followed().is_empty() && !rests {
        return;
    }
    let largest = |value: fn(&Member) -> f64| {
        let nodes = group.nodes().iter();
        nodes.fold(0.0, |largest: f64, node| largest.max(value(&members[*node])))
    };
    let (around, rate) = (largest(|member| member.terms.acceleration), largest(|member| member.terms.rate));
    for node in group.nodes() {
        let member = &mut members[*node];
        if member.is_tied() || rests {
            (member.terms.around, member.terms.rate) = (around, rate);
        }
    }
}
