//! The motion of the floors of one body as power series: the recurrence of their equations of motion.
//!
//! With t = origin + x^p, the equations m ü + c u̇ + f = F − m `a_g` give the acceleration power by power from known forces. Velocity and
//! displacement follow p powers further on. The same formula covers c = 0, k = 0, critical damping and the plastic branch. Structures at
//! rest against each other share their acceleration. Storeys couple floors in the same way, by drifts and rates whose coefficients are
//! known.

use crate::exact::contact::{Join, PairState};
use crate::exact::friction;
use crate::exact::groups::{Block, Group, Lighter, Side};
use crate::exact::links::LinkState;
use crate::exact::member::Member;
use crate::exact::rounding::OF_COEFFICIENTS;
use crate::exact::storey::{self, own_force};
use crate::exact::tie::Tie;
use crate::model::incidence::Incidence;
use crate::span::Power;

/// Expands the motion of a body, and the forces between its members, to `len` coefficients.
pub(super) fn expand(
    group: Group<'_>,
    members: &mut [Member],
    contacts: &mut [PairState],
    links: &mut [LinkState],
    incidence: &Incidence,
    (power, len): (Power, usize),
) {
    let p = power.order();
    let (nodes, followed, pairs) = (group.nodes(), group.followed(), group.pairs());
    for node in nodes {
        let member = &mut members[*node];
        member.displacement[..2 * p].fill(0.0);
        member.velocity[..p].fill(0.0);
        member.displacement[0] = member.state.displacement;
        member.velocity[0] = member.state.velocity;
        member.displacement[p] = member.state.velocity;
    }
    storey::begin(members, followed);
    for n in 0..len {
        if !followed.is_empty() {
            storey::follow(members, followed, p, n);
        }
        for link in group.links() {
            links[*link].find(members, p, n);
        }
        for pair in pairs {
            let contact = &mut contacts[*pair];
            if matches!(contact.join, Join::Touching(_)) {
                contact.find_force(members, power, n);
            }
        }
        if group.is_of_chain() {
            move_blocks(group.blocks(), members, contacts, p, n);
        } else {
            move_freely(nodes, members, contacts, incidence, p, n);
            if let Some(tie) = group.tie() {
                hold(tie, members, contacts, p, n);
            }
            for node in nodes {
                let member = &mut members[*node];
                if member.stands(n) {
                    member.acceleration[n] = 0.0;
                }
                follow(member, p, n);
            }
        }
        friction::hold(nodes, members, contacts, incidence, p, n);
    }
}

/// Finds the coefficients of velocity and displacement that follow from an acceleration.
fn follow(member: &mut Member, p: usize, n: usize) {
    member.velocity[n + p] = member.acceleration[n] * (p as f64 / (n + p) as f64);
    member.displacement[n + 2 * p] = member.velocity[n + p] * (p as f64 / (n + 2 * p) as f64);
}

/// Coefficient `n` of the motion of a chain, and of the forces between members at rest.
fn move_blocks(blocks: &[Block], members: &mut [Member], contacts: &mut [PairState], p: usize, n: usize) {
    // Computed outside the chain of dependent operations, in which a division would take longest.
    let [once, twice] = [n + p, n + 2 * p].map(|order| p as f64 / order as f64);
    for block in blocks {
        let force = |pair: Option<usize>| pair.map_or(0.0, |pair| contacts[pair].force[n]);
        let outside = [force(block.left), force(block.right)];
        accelerate(members, block, outside[0] - outside[1], p, n);
        for member in &mut members[block.first..=block.last] {
            member.velocity[n + p] = member.acceleration[n] * once;
            member.displacement[n + 2 * p] = member.velocity[n + p] * twice;
        }
        if block.first < block.last {
            resting_forces(members, contacts, block, outside, p, n);
        }
    }
}

/// Coefficient `n` of the accelerations of members of any row under the forces of compliant contact.
fn move_freely(nodes: &[usize], members: &mut [Member], contacts: &[PairState], incidence: &Incidence, p: usize, n: usize) {
    let pushed = |node: usize, on_left: bool| {
        let at = incidence.at(node).iter();
        at.filter(|at| at.on_left == on_left && is_touching(&contacts[at.pair]))
            .map(|at| at.part * contacts[at.pair].force[n])
            .reduce(|sum, force| sum + force)
            .unwrap_or(0.0)
    };
    for &node in nodes {
        let ground = members[node].ground.coefficient(n, p);
        members[node].acceleration[n] = if members[node].is_still() {
            0.0
        } else {
            let force = pushed(node, false) - pushed(node, true);
            members[node].inverse_mass * (force - own_force(members, node, n)) - ground
        };
    }
}

fn is_touching(contact: &PairState) -> bool {
    matches!(contact.join, Join::Touching(_))
}

/// Coefficient `n` of the forces at rest of any row, and their effect on the accelerations.
fn hold(tie: &Tie, members: &mut [Member], contacts: &mut [PairState], p: usize, n: usize) {
    let closing = |pair: &usize| {
        let contact = &contacts[*pair];
        let ahead = contact.relation.ahead(|node| members[node].acceleration[n]);
        contact.over_grounds(ahead, |node| members[node].ground.coefficient(n, p))
    };
    let mut forces: Vec<_> = tie.pairs.iter().map(closing).collect();
    tie.solve(&mut forces);
    let floors = tie.pairs.iter().flat_map(|pair| contacts[*pair].floors());
    let slides = floors.into_iter().any(|floor| members[floor].stick.is_some());
    for (pair, force) in tie.pairs.iter().zip(forces) {
        contacts[*pair].force[n] = force;
        for (floor, part) in contacts[*pair].relation.pushes() {
            let member = &mut members[floor];
            let change = member.inverse_mass * (part * force);
            member.acceleration[n] += change;
            // Floors that stand still under friction and walls would yield, or turn, by rounding at once, again and again.
            if slides && member.acceleration[n].abs() <= OF_COEFFICIENTS * change.abs() {
                member.acceleration[n] = 0.0;
            }
        }
    }
    for pair in &tie.pairs {
        friction::press(&contacts[*pair], members, n);
    }
}

/// Coefficient `n` of the acceleration that members at rest against each other share under a net outer force, each over its ground.
fn accelerate(members: &mut [Member], block: &Block, force: f64, p: usize, n: usize) {
    let nodes = block.first..=block.last;
    let shared = match &members[nodes.clone()] {
        [alone] if alone.stands(n) => alone.ground.coefficient(n, p),
        [alone] => {
            let own = own_force(members, block.first, n);
            alone.inverse_mass * (force - own)
        }
        several => {
            if let Some(still) = several.iter().find(|member| member.stands(n)) {
                still.ground.coefficient(n, p)
            } else {
                let sum: f64 = nodes.clone().map(|node| own_force(members, node, n)).sum();
                let mass: f64 = several.iter().map(|member| member.mass).sum();
                (force - sum) / mass
            }
        }
    };
    for member in &mut members[nodes] {
        member.acceleration[n] = shared - member.ground.coefficient(n, p);
    }
}

/// Coefficient `n` of the forces between members at rest against each other, each from its lighter side.
fn resting_forces(members: &[Member], contacts: &mut [PairState], block: &Block, [left, right]: [f64; 2], p: usize, n: usize) {
    let side = |node: usize| Side {
        weight: members[node].mass,
        need: storey::need(members, node, p, n),
    };
    block.tell_lighter_sides(side, |index, found| {
        contacts[block.within + index].force[n] = match found {
            Lighter::Left(need) => left - need,
            Lighter::Right(need) => right + need,
        };
    });
    friction::share_between(members, contacts, block, p, n);
}

/// Largest length of a piece for which the last coefficients are below rounding, on every branch of its members.
pub(super) fn radius(members: &[Member], nodes: &[usize]) -> f64 {
    let fastest = nodes.iter().map(|node| members[*node].fastest_rate).fold(0.0, f64::max);
    1.0 / fastest
}
