//! Impacts of all impulsive pairs that touch at one instant, solved together.
//!
//! With u the velocity at which a pair separates and W = G M⁻¹ Gᵀ: u⁺ = −e u⁻ for every touching pair that does not
//! separate, no impulse for the others, and again while a touching pair still approaches. W is then an M-matrix and
//! −(1+e) u⁻ ≥ 0, so the impulses that solve W P = −(1+e) u⁻ are ≥ 0 without a search.

use super::law::Law;
use super::model::{Model, displacement, velocity};
use super::scales::Scales;
use super::state::State;

/// Rounds in which a pair gives back its restitution; what still approaches then is stopped.
const MOST_ROUNDS: usize = 50;

/// Distance, as a part of the gap and the displacements, below which a pair touches together with another.
const TOGETHER: f64 = 1e-13;

/// Velocity, as a part of the largest of the row, below which a pair does not approach again, and the like for the
/// impulse of a collision.
pub(super) const NOISE: f64 = 1e-14;

/// Approach, as a part of the largest velocities so far, that is too slow to be followed: between two such impacts
/// structures part by no more than displacements are rounded.
const REST: f64 = 1e-8;

/// What happened at an instant.
#[derive(Debug, Clone)]
pub(super) struct Impacts {
    /// Each pair that collided and its impulse \[N·s\], > 0.
    pub impulses: Vec<(usize, f64)>,
    /// Rounding of the velocities after it \[m/s\].
    pub noise: f64,
}

/// Jumps the velocities of a state.
///
/// # Errors
/// The pair that approaches fastest, where even that is too slow.
pub(super) fn collide(model: &Model, state: &mut State, scales: &Scales) -> Result<Impacts, usize> {
    let touching = touching(model, &state.high);
    let relative = |pair: usize| model.rate(pair, &state.high) / scales.speed(model, pair);
    let fastest = touching
        .iter()
        .copied()
        .max_by(|&left, &right| relative(left).total_cmp(&relative(right)));
    if let Some(pair) = fastest
        && relative(pair) <= REST
    {
        return Err(pair);
    }
    let speeds = (0..model.structures.len()).map(|index| state.high[velocity(index)].abs());
    let openings = model.pairs.iter().filter_map(|pair| pair.opening);
    let openings = openings.map(|index| state.high[index + 1].abs());
    let noise = NOISE * speeds.chain(openings).fold(0.0, f64::max);
    let mut total = vec![0.0; model.pairs.len()];
    for round in 0..=MOST_ROUNDS {
        let approaches = |&pair: &usize| model.rate(pair, &state.high) > noise;
        if !touching.iter().any(approaches) {
            break;
        }
        let impulses = if round < MOST_ROUNDS {
            restitute(model, &touching, &state.high)
        } else {
            stop(model, &touching, &state.high, noise)
        };
        for (pair, impulse) in impulses {
            push(model, pair, impulse, &mut state.high);
            total[pair] += impulse;
        }
    }
    let found = total.into_iter().enumerate();
    let impulses =
        found.filter(|&(pair, impulse)| impulse > noise * model.pairs[pair].reduced_mass);
    Ok(Impacts {
        impulses: impulses.collect(),
        noise,
    })
}

/// Impulsive pairs that touch, from left to right.
fn touching(model: &Model, y: &[f64]) -> Vec<usize> {
    let touches = |&index: &usize| {
        let pair = model.pairs[index];
        let size = pair.gap + y[displacement(pair.left)].abs() + y[displacement(pair.right)].abs();
        let size = pair.opening.map_or(size, |index| size + y[index].abs());
        matches!(pair.law, Law::Impulsive { .. }) && model.deformation(index, y) >= -TOGETHER * size
    };
    (0..model.pairs.len()).filter(touches).collect()
}

/// One round: impulses of the pairs that do not separate.
fn restitute(model: &Model, touching: &[usize], y: &[f64]) -> Vec<(usize, f64)> {
    let active: Vec<usize> = touching
        .iter()
        .copied()
        .filter(|&pair| model.rate(pair, y) >= 0.0)
        .collect();
    let wanted = |pair: usize| match model.pairs[pair].law {
        Law::Impulsive { restitution } => (1.0 + restitution) * model.rate(pair, y),
        Law::Compliant(_) => 0.0,
    };
    solve(model, &active, wanted)
}

/// Impulses that leave no touching pair approaching; the set of those that push grows until none does.
fn stop(model: &Model, touching: &[usize], y: &[f64], noise: f64) -> Vec<(usize, f64)> {
    let mut active: Vec<usize> = Vec::new();
    let mut impulses = Vec::new();
    let mut after = y.to_vec();
    loop {
        let before = active.len();
        active = touching
            .iter()
            .copied()
            .filter(|pair| active.contains(pair) || model.rate(*pair, &after) > noise)
            .collect();
        if active.len() == before {
            return impulses;
        }
        impulses = solve(model, &active, |pair| model.rate(pair, y));
        after.copy_from_slice(y);
        for &(pair, impulse) in &impulses {
            push(model, pair, impulse, &mut after);
        }
    }
}

fn push(model: &Model, pair: usize, impulse: f64, y: &mut [f64]) {
    let neighbours = model.pairs[pair];
    let inverse_mass = |structure: usize| model.structures[structure].inverse_mass;
    y[velocity(neighbours.left)] -= impulse * inverse_mass(neighbours.left);
    y[velocity(neighbours.right)] += impulse * inverse_mass(neighbours.right);
}

/// Impulses of the `active` pairs that slow each approach by what is `wanted` \[m/s\]: W P = wanted, tridiagonal.
fn solve(model: &Model, active: &[usize], wanted: impl Fn(usize) -> f64) -> Vec<(usize, f64)> {
    // −W between a pair and the one before it: the inverse mass of the structure they share.
    let shared = |position: usize| {
        let (before, after) = (active[position - 1], active[position]);
        let structure = model.pairs[after].left;
        if model.pairs[before].right == structure {
            model.structures[structure].inverse_mass
        } else {
            0.0
        }
    };
    let mut pivots = vec![0.0; active.len()];
    let mut impulses = vec![0.0; active.len()];
    for (position, &pair) in active.iter().enumerate() {
        pivots[position] = 1.0 / model.pairs[pair].reduced_mass;
        impulses[position] = wanted(pair);
        if position > 0 {
            let factor = shared(position) / pivots[position - 1];
            pivots[position] -= factor * shared(position);
            impulses[position] += factor * impulses[position - 1];
        }
    }
    for position in (0..active.len()).rev() {
        if position + 1 < active.len() {
            impulses[position] += shared(position + 1) * impulses[position + 1];
        }
        impulses[position] /= pivots[position];
    }
    active.iter().copied().zip(impulses).collect()
}
