//! Impacts of all impulsive pairs that touch at one instant, solved together.
//!
//! With u the velocity at which a pair separates and W = G M⁻¹ Gᵀ: u⁺ = −e u⁻ for every touching pair that does not
//! separate, no impulse for the others, and again while a touching pair still approaches. W is then an M-matrix and
//! −(1+e) u⁻ ≥ 0, so the impulses that solve W P = −(1+e) u⁻ are ≥ 0 without a search.

use super::law::Law;
use super::model::Model;
use super::motion::Motion;
use super::phases::Contact;

/// Rounds in which a pair gives back its restitution; what still approaches then is stopped.
const MOST_ROUNDS: usize = 50;

/// Bounces whose geometric remainder is shorter are over \[s\].
pub(super) const SHORTEST: f64 = 1e-12;

/// Part of what a velocity or an impulse is a sum of that is rounding.
pub(super) const NOISE: f64 = 1e-14;

/// Impulsive pairs that touch, from left to right.
pub(super) fn touching(motion: &Motion, y: &[f64]) -> Vec<usize> {
    let model = &motion.model;
    let touches = |&index: &usize| {
        let rests = matches!(motion.phases.pairs[index].contact, Contact::Resting { .. });
        let impulsive = matches!(model.pairs[index].law, Law::Impulsive { .. });
        impulsive && (rests || model.deformation(index, y) >= 0.0)
    };
    (0..model.pairs.len()).filter(touches).collect()
}

/// Jumps the velocities of touching pairs, those marked `plastic` without restitution; the impulse of every pair \[N·s\].
pub(super) fn collide(
    model: &Model,
    y: &mut [f64],
    touching: &[usize],
    plastic: &[bool],
) -> Vec<f64> {
    let mut total = vec![0.0; model.pairs.len()];
    for round in 0..=MOST_ROUNDS {
        if !touching.iter().any(|&pair| model.rate(pair, y) > 0.0) {
            break;
        }
        let impulses = if round < MOST_ROUNDS {
            restitute(model, y, touching, plastic)
        } else {
            stop(model, y, touching)
        };
        for (pair, impulse) in impulses {
            total[pair] += impulse;
        }
    }
    total
}

/// One round: the pairs that do not separate turn round.
fn restitute(
    model: &Model,
    y: &mut [f64],
    touching: &[usize],
    plastic: &[bool],
) -> Vec<(usize, f64)> {
    let turns = touching.iter().copied().filter_map(|pair| {
        let rate = model.rate(pair, y);
        let restitution = match model.pairs[pair].law {
            Law::Impulsive { restitution } if !plastic[pair] => restitution,
            Law::Impulsive { .. } | Law::Compliant(_) => 0.0,
        };
        (rate >= 0.0).then_some(Turn {
            pair,
            rate,
            after: -restitution * rate,
        })
    });
    let turns: Vec<_> = turns.collect();
    jump(model, y, touching, &turns)
}

/// Leaves no touching pair approaching; the set of those that push grows until none does.
fn stop(model: &Model, y: &mut [f64], touching: &[usize]) -> Vec<(usize, f64)> {
    let mut after = y.to_vec();
    let mut active: Vec<usize> = Vec::new();
    let mut impulses = Vec::new();
    loop {
        let before = active.len();
        active = touching
            .iter()
            .copied()
            .filter(|pair| active.contains(pair) || model.rate(*pair, &after) > 0.0)
            .collect();
        if active.len() == before {
            y.copy_from_slice(&after);
            return impulses;
        }
        let turn = |&pair: &usize| Turn {
            pair,
            rate: model.rate(pair, y),
            after: 0.0,
        };
        let turns: Vec<_> = active.iter().map(turn).collect();
        after.copy_from_slice(y);
        impulses = jump(model, &mut after, touching, &turns);
    }
}

/// A pair whose rate of deformation is to change.
#[derive(Debug, Clone, Copy)]
struct Turn {
    pair: usize,
    /// The rate before \[m/s\].
    rate: f64,
    /// The rate after \[m/s\].
    after: f64,
}

/// Gives the impulses of some turns.
fn jump(model: &Model, y: &mut [f64], touching: &[usize], turns: &[Turn]) -> Vec<(usize, f64)> {
    let impulses = solve(model, turns);
    let before: Vec<_> = touching.iter().map(|&pair| model.rate(pair, y)).collect();
    for &(pair, impulse) in &impulses {
        let neighbours = model.pairs[pair];
        let gained = |structure: usize| impulse * model.structures[structure].inverse_mass;
        model.push(neighbours.left, -gained(neighbours.left), y);
        model.push(neighbours.right, gained(neighbours.right), y);
    }
    for turn in turns {
        y[model.pairs[turn.pair].deformation + 1] = turn.after;
    }
    // Of what stops by the push of a neighbour, rounding is left.
    for (&pair, before) in touching.iter().zip(before) {
        let rate = &mut y[model.pairs[pair].deformation + 1];
        if *rate > 0.0 && *rate <= NOISE * before.abs() {
            *rate = 0.0;
        }
    }
    impulses
}

/// Impulses of turns, from left to right: W P = the turns, tridiagonal.
///
/// The pivot of a pair is 1/(all mass of its block to the left) + 1/(the mass on the right): no term is taken from another.
fn solve(model: &Model, turns: &[Turn]) -> Vec<(usize, f64)> {
    let inverse_mass = |structure: usize| model.structures[structure].inverse_mass;
    // −W between a pair and the one before it: the inverse mass of the structure they share.
    let shared = |position: usize| {
        let structure = model.pairs[turns[position].pair].left;
        if model.pairs[turns[position - 1].pair].right == structure {
            inverse_mass(structure)
        } else {
            0.0
        }
    };
    let mut pivots = vec![0.0; turns.len()];
    let mut impulses = vec![0.0; turns.len()];
    let mut lighter = 0.0;
    for (position, turn) in turns.iter().enumerate() {
        let pair = model.pairs[turn.pair];
        impulses[position] = turn.rate - turn.after;
        let joined = position > 0 && shared(position) > 0.0;
        // 1/(mass to the left): of the structure alone, or with what it leans on.
        lighter = if joined {
            1.0 / (1.0 / lighter + 1.0 / inverse_mass(pair.left))
        } else {
            inverse_mass(pair.left)
        };
        pivots[position] = lighter + inverse_mass(pair.right);
        if joined {
            impulses[position] += shared(position) / pivots[position - 1] * impulses[position - 1];
        }
    }
    for position in (0..turns.len()).rev() {
        if position + 1 < turns.len() {
            impulses[position] += shared(position + 1) * impulses[position + 1];
        }
        impulses[position] /= pivots[position];
    }
    let pairs = turns.iter().map(|turn| turn.pair);
    pairs.zip(impulses).collect()
}
