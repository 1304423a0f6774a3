//! Impulses of several pairs of a chain at an instant, found together, for a single scene or for several scenes in lanes.
//!
//! The impulses P ≥ 0 of a row remove relative velocity W P, with W = G M⁻¹ Gᵀ. The solution is the smallest P that removes at least the
//! demand of every pair: 0 ≤ W P − demand ⟂ P ≥ 0. W has no positive off-diagonal element (a push on a structure drives it into its other
//! neighbour). A growing set of pushing pairs therefore suffices: a pair in the set never has to leave it (R. Chandrasekaran, *Opsearch* 7
//! (1970) 263).
//!
//! `exact/impacts.rs` deliberately solves this problem by another route: its rates of deformation are stored numbers, not differences of
//! velocities. The solver here takes mobilities, which Moreau–Jean stepping changes from step to step.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

/// Rounding of a demand that was met, relative to its terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The pairs that take part, from left to right, and scratch.
///
/// Numbers are in the order of the links. There is room for every pair of the row, so that nothing is allocated later.
pub(crate) struct Together<N: Number> {
    pub(crate) links: Vec<Link>,
    /// Relative velocity that each pair must lose \[m/s\]; −∞ in scenes in which the pair takes no part.
    pub(crate) demand: Vec<N>,
    /// Impulse of each pair \[N·s\], ≥ 0.
    pub(crate) impulses: Vec<N>,
    /// Scenes in which each pair pushes.
    taken: Vec<N::Mask>,
    /// Mobility of the structures to the left of a pair, joined through pushing pairs.
    behind: Vec<N>,
}

/// A pair that takes part.
#[derive(Debug, Clone, Copy)]
pub struct Link {
    /// Index among the pairs of the row.
    pub pair: usize,
    /// Left neighbour.
    pub left: usize,
    /// Right neighbour.
    pub right: usize,
    /// Whether the left neighbour is the right neighbour of the link before.
    pub is_joined: bool,
}

impl<N: Number> Together<N> {
    pub(crate) fn new(n_pairs: usize) -> Self {
        Self {
            links: Vec::with_capacity(n_pairs),
            demand: Vec::with_capacity(n_pairs),
            impulses: Vec::with_capacity(n_pairs),
            taken: Vec::with_capacity(n_pairs),
            behind: Vec::with_capacity(n_pairs),
        }
    }

    /// Forgets the pairs.
    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.links.clear();
        self.demand.clear();
    }

    /// Adds a pair, to the right of the earlier pairs, and its left neighbour.
    #[inline(always)]
    pub(crate) fn push(&mut self, pair: usize, left: usize, demand: N) {
        let before = self.links.last();
        self.links.push(Link {
            pair,
            left,
            right: left + 1,
            is_joined: before.is_some_and(|before| before.right == left),
        });
        self.demand.push(demand);
    }

    /// Finds the impulses from the demands.
    ///
    /// `mobilities` are the velocities \[1/kg\] of each structure under a unit impulse.
    #[inline(always)]
    pub(crate) fn solve(&mut self, mobilities: &[N]) {
        self.impulses.clear();
        self.taken.clear();
        self.behind.clear();
        for demand in &self.demand {
            let zero = demand.like(0.0);
            self.impulses.push(zero);
            self.taken.push(zero.exceeds(zero));
            self.behind.push(zero);
        }
        while self.grow(mobilities) {
            self.eliminate(mobilities);
        }
    }

    /// Whether the right neighbour of this pair is the left neighbour of the next pair.
    #[inline(always)]
    pub(crate) fn joins_next(&self, index: usize) -> bool {
        self.links.get(index + 1).is_some_and(|next| next.is_joined)
    }

    /// Adds pairs that demand more than they get; true if there were any.
    #[inline(always)]
    fn grow(&mut self, mobilities: &[N]) -> bool {
        let mut grown = false;
        for (index, link) in self.links.iter().enumerate() {
            let demand = self.demand[index];
            let mut driven = demand.like(0.0);
            if link.is_joined {
                driven = mobilities[link.left] * self.impulses[index - 1];
            }
            if self.joins_next(index) {
                driven = driven + mobilities[link.right] * self.impulses[index + 1];
            }
            let met = demand.like(ROUNDING) * (demand.abs() + driven);
            let lacks = (demand + driven).exceeds(met) & !self.taken[index];
            self.taken[index] = self.taken[index] | lacks;
            grown |= N::any(lacks);
        }
        grown
    }

    /// Solves W P = demand over the pushing pairs, run by run from left to right.
    ///
    /// The diagonal after elimination is a sum of mobilities in series and parallel. A subtraction would lose as many digits as the masses
    /// differ in.
    #[inline(always)]
    fn eliminate(&mut self, mobilities: &[N]) {
        for (index, link) in self.links.iter().enumerate() {
            let own = mobilities[link.left];
            let (mut behind, mut impulse) = (own, self.demand[index]);
            if link.is_joined {
                let both = self.taken[index - 1];
                let total = self.behind[index - 1] + own;
                behind = N::select(both, own * self.behind[index - 1] / total, behind);
                let passed = impulse + own * self.impulses[index - 1] / total;
                impulse = N::select(both, passed, impulse);
            }
            self.behind[index] = behind;
            self.impulses[index] = N::select(self.taken[index], impulse, self.impulses[index]);
        }
        for (index, link) in self.links.iter().enumerate().rev() {
            let ahead = mobilities[link.right];
            let mut sum = self.impulses[index];
            if self.joins_next(index) {
                // A pair that does not push has impulse 0 and contributes nothing.
                sum = sum + ahead * self.impulses[index + 1];
            }
            let impulse = sum / (self.behind[index] + ahead);
            self.impulses[index] = N::select(self.taken[index], impulse, self.impulses[index]);
        }
    }
}
