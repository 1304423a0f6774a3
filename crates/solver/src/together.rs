//! Impulses of several pairs at one instant, found together.
//!
//! The impulses P ≥ 0 of a row take away relative velocity: W P, with W = G M⁻¹ Gᵀ. Asked is the least P that takes
//! away at least the demand of every pair, 0 ≤ W P − demand ⟂ P ≥ 0. W has no positive element off its diagonal (a
//! push on a structure drives it into its other neighbour), so that growing the set of pushing pairs is enough: a pair
//! once taken in never has to leave (R. Chandrasekaran, *Opsearch* 7 (1970) 263).

use crate::Pair;

/// What rounding leaves of a demand that was met, relative to its terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Scratch of the elimination, and its answer.
pub(crate) struct Together {
    /// Pairs that push.
    taken: Vec<bool>,
    /// Mobility of everything a pair has on its left, joined through the pairs that push.
    behind: Vec<f64>,
    /// Impulse of every pair \[N·s\].
    impulses: Vec<f64>,
}

impl Together {
    pub(crate) fn new(n_pairs: usize) -> Self {
        Self {
            taken: vec![false; n_pairs],
            behind: vec![0.0; n_pairs],
            impulses: vec![0.0; n_pairs],
        }
    }

    /// Impulse of every pair \[N·s\], ≥ 0.
    ///
    /// `mobilities` are the velocities a unit impulse gives to each structure \[1/kg\]; a `demand` \[m/s\] is the
    /// relative velocity to take away, −∞ for a pair that takes no part.
    pub(crate) fn solve(&mut self, pairs: &[Pair], mobilities: &[f64], demand: &[f64]) -> &[f64] {
        self.taken.fill(false);
        self.impulses.fill(0.0);
        while self.grow(pairs, mobilities, demand) {
            self.eliminate(pairs, mobilities, demand);
        }
        &self.impulses
    }

    /// Takes in the pairs that demand more than they get; true when there was one.
    fn grow(&mut self, pairs: &[Pair], mobilities: &[f64], demand: &[f64]) -> bool {
        let mut grown = false;
        for (index, pair) in pairs.iter().enumerate() {
            let neighbour = |joined: bool, other: usize, node: usize| {
                if joined {
                    mobilities[node] * self.impulses[other]
                } else {
                    0.0
                }
            };
            let left = index > 0 && pairs[index - 1].right == pair.left;
            let right = index + 1 < pairs.len() && pairs[index + 1].left == pair.right;
            let driven = neighbour(left, index.wrapping_sub(1), pair.left)
                + neighbour(right, index + 1, pair.right);
            let lacking = demand[index] + driven;
            if !self.taken[index] && lacking > ROUNDING * (demand[index].abs() + driven) {
                self.taken[index] = true;
                grown = true;
            }
        }
        grown
    }

    /// Solves W P = demand over the taken pairs, run by run from left to right.
    ///
    /// The diagonal after elimination is a sum of mobilities in series and parallel. Subtracting instead would lose
    /// as many digits as the masses differ in.
    fn eliminate(&mut self, pairs: &[Pair], mobilities: &[f64], demand: &[f64]) {
        for (index, pair) in pairs.iter().enumerate() {
            if !self.taken[index] {
                continue;
            }
            let own = mobilities[pair.left];
            (self.behind[index], self.impulses[index]) = if self.is_joined(pairs, index) {
                let behind = self.behind[index - 1];
                let total = behind + own;
                (
                    own * behind / total,
                    demand[index] + own * self.impulses[index - 1] / total,
                )
            } else {
                (own, demand[index])
            };
        }
        for index in (0..pairs.len()).rev() {
            if !self.taken[index] {
                continue;
            }
            let ahead = mobilities[pairs[index].right];
            let back = if index + 1 < pairs.len() && self.is_joined(pairs, index + 1) {
                ahead * self.impulses[index + 1]
            } else {
                0.0
            };
            self.impulses[index] = (self.impulses[index] + back) / (self.behind[index] + ahead);
        }
    }

    /// Whether a pair that pushes shares a structure with the one on its left, and that one pushes as well.
    fn is_joined(&self, pairs: &[Pair], index: usize) -> bool {
        index > 0
            && self.taken[index]
            && self.taken[index - 1]
            && pairs[index - 1].right == pairs[index].left
    }
}
