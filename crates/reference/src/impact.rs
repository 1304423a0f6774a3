//! Impacts of all impulsive pairs that touch at an instant, solved together.
//!
//! Let r be the rates at which pairs approach and W = G M⁻¹ Gᵀ. Pairs that do not separate have 0 ≤ P ⟂ W P − (1 + e) r ≥ 0. A pair that
//! pushes leaves with −e r, another pair at least as fast. A pair that separates has no impulse. This repeats while a touching pair
//! approaches. All sets of pairs are tried to find the pushing set.

use super::SecondRouteError;
use super::block::{best, groups, least, mobility};
use super::equations::Equations;
use super::law::Law;
use super::model::Model;
use super::phases::ContactPhase;

/// Rounds in which a pair gives back its restitution. Later approaches are stopped.
const MOST_ROUNDS: usize = 50;

/// Bounces with a shorter geometric remainder are usually over \[s\].
pub(super) const SHORTEST: f64 = 1e-12;

/// Rounding of a velocity or an impulse, relative to its terms.
pub(super) const NOISE: f64 = 1e-14;

/// Impulsive pairs that touch.
pub(super) fn touching(motion: &Equations, y: &[f64]) -> Vec<usize> {
    let model = &motion.model;
    let touches = |&index: &usize| {
        let rests = matches!(motion.phases.pairs[index].contact, ContactPhase::Resting { .. });
        let impulsive = matches!(model.pairs[index].law, Law::Impulsive { .. });
        impulsive && (rests || model.deformation(index, y) >= 0.0)
    };
    (0..model.pairs.len()).filter(touches).collect()
}

/// Most pairs of a group: all their sets can be tried in a second.
const MOST_AT_ONCE: usize = 14;

/// The groups of pairs that touch at a time \[s\].
pub(super) fn together(model: &Model, touching: &[usize], time: f64) -> Result<Vec<Vec<usize>>, SecondRouteError> {
    let groups = groups(model, touching);
    match groups.iter().map(Vec::len).max() {
        Some(found) if found > MOST_AT_ONCE => Err(SecondRouteError::TooManyAtOnce {
            time,
            found,
            limit: MOST_AT_ONCE,
        }),
        Some(_) | None => Ok(groups),
    }
}

/// Effect of an impact on a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outcome {
    /// The pair bounces with its restitution.
    Bounces,
    /// The pair stops without restitution: its bounces are over.
    Stops,
    /// The pair stays together, whatever hits its floors: it would close again at once.
    Stays,
}

/// Applies velocity jumps to groups of touching pairs; returns the impulse of every pair \[N·s\].
pub(super) fn collide(model: &Model, y: &mut [f64], groups: &[Vec<usize>], outcomes: &[Outcome]) -> Vec<f64> {
    let mut total = vec![0.0; model.pairs.len()];
    for group in groups {
        for round in 0..=MOST_ROUNDS {
            if !group.iter().any(|&pair| model.rate(pair, y) > 0.0) {
                break;
            }
            let stops = round == MOST_ROUNDS;
            let turn = |&pair: &usize| {
                let rate = model.rate(pair, y);
                let stays = outcomes[pair] == Outcome::Stays;
                let restitution = match (model.pairs[pair].law, outcomes[pair]) {
                    (Law::Impulsive { restitution }, Outcome::Bounces) if !stops => restitution,
                    _ => 0.0,
                };
                (rate >= 0.0 || stops || stays).then_some(Turn {
                    pair,
                    rate,
                    after: -restitution * rate,
                    stays,
                })
            };
            let turns: Vec<_> = group.iter().filter_map(turn).collect();
            for (pair, impulse) in jump(model, y, group, &turns) {
                total[pair] += impulse;
            }
        }
    }
    total
}

/// A change of the rate of deformation of a pair.
#[derive(Debug, Clone, Copy)]
struct Turn {
    pair: usize,
    /// The rate before \[m/s\].
    rate: f64,
    /// The largest rate after the change, which a pushing pair has \[m/s\].
    after: f64,
    /// Whether the pair has this rate in any case.
    stays: bool,
}

/// Applies the impulses of some turns of a group.
fn jump(model: &Model, y: &mut [f64], group: &[usize], turns: &[Turn]) -> Vec<(usize, f64)> {
    let impulses = answer(model, turns);
    let before: Vec<_> = group.iter().map(|&pair| model.rate(pair, y)).collect();
    for (turn, &impulse) in turns.iter().zip(&impulses) {
        for (floor, part) in model.pairs[turn.pair].ends.parts() {
            let gained = part * impulse * model.structures[floor].inverse_mass;
            model.push(floor, -gained, y);
        }
    }
    let pairs = turns.iter().map(|turn| turn.pair);
    let found: Vec<_> = pairs.zip(impulses).collect();
    for (turn, (_, impulse)) in turns.iter().zip(&found) {
        if turn.stays || *impulse > 0.0 {
            y[model.pairs[turn.pair].deformation + 1] = turn.after;
        }
    }
    // A pair that stops by the push of a neighbour has only rounding left.
    for (&pair, before) in group.iter().zip(before) {
        let rate = &mut y[model.pairs[pair].deformation + 1];
        if *rate > 0.0 && *rate <= NOISE * before.abs() {
            *rate = 0.0;
        }
    }
    found
}

/// Impulses of turns.
fn answer(model: &Model, turns: &[Turn]) -> Vec<f64> {
    let pairs: Vec<_> = turns.iter().map(|turn| turn.pair).collect();
    let all = mobility(model, &pairs);
    let demand = |of: usize| turns[of].rate - turns[of].after;
    let judge = |set: &[usize]| {
        let own = |&one: &usize| set.iter().map(|other| all[one][*other]).collect();
        let of_set: Vec<Vec<f64>> = set.iter().map(own).collect();
        let demands = set.iter().map(|one| demand(*one)).collect();
        let mut impulses = vec![0.0; turns.len()];
        for (one, found) in set.iter().zip(&least(&of_set, &[demands])[0]) {
            impulses[*one] = *found;
        }
        let miss = |one: usize| {
            let lost = all[one].iter().zip(&impulses).map(|(by, impulse)| by * impulse);
            let terms = lost.clone().map(f64::abs).sum::<f64>() + demand(one).abs();
            let lack = demand(one) - lost.sum::<f64>();
            let Turn { stays, .. } = turns[one];
            let off = if stays || set.contains(&one) { lack.abs() } else { lack };
            let pull = if stays { 0.0 } else { -impulses[one] };
            (off - NOISE * terms).max(pull * all[one][one])
        };
        let miss = (0..turns.len()).map(miss).fold(0.0, f64::max);
        let squares = impulses.iter().map(|impulse| impulse * impulse).sum();
        (miss, squares, impulses)
    };
    let impulses = best(turns.len(), judge).unwrap_or_default();
    let least = |turn: &Turn| if turn.stays { f64::NEG_INFINITY } else { 0.0 };
    let least = turns.iter().map(least);
    impulses.into_iter().zip(least).map(|(impulse, least)| impulse.max(least)).collect()
}
