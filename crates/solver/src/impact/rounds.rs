//! Rounds of impulses between touching pairs of a chain, for a single scene or for several scenes in lanes.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

use crate::impact::chain::{Link, Together};

/// Number of rounds. Later rounds are plastic: pairs that still touch and approach stay together.
pub(crate) const MAX_ROUNDS: u32 = 50;
/// Rounding of an approach, relative to the velocities.
pub const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// An impulsive pair that touches.
#[expect(missing_debug_implementations, reason = "masks of lanes have none")]
pub struct Touching<N: Number> {
    /// The scenes in which the pair touches.
    pub scenes: N::Mask,
    /// 1 + e.
    pub factor: N,
    /// Rate at which the grounds under it move towards each other \[m/s\].
    pub opening_rate: N,
    /// Magnitude of the rounding of `opening_rate` \[m/s\]. The velocities are added at the impact.
    pub speeds: N,
}

impl<N: Number> Touching<N> {
    /// A pair whose grounds do not move relative to each other.
    #[inline(always)]
    pub fn on_one_ground(scenes: N::Mask, factor: N) -> Self {
        let zero = factor.like(0.0);
        Self {
            scenes,
            factor,
            opening_rate: zero,
            speeds: zero,
        }
    }
}

/// The pairs that touch at an instant, and scratch.
#[expect(missing_debug_implementations, reason = "scratch")]
pub struct Rounds<N: Number> {
    touching: Vec<Touching<N>>,
    /// Impulse of each pair \[N·s\], over all rounds.
    impulses: Vec<N>,
    /// Velocity of every structure \[m/s\], before and after. Structures that touch nobody are not updated.
    velocities: Vec<N>,
    /// Velocities that a unit impulse gives to each structure \[1/kg\].
    mobilities: Vec<N>,
    together: Together<N>,
}

impl<N: Number> Rounds<N> {
    /// Rounds for structures with these mobilities \[1/kg\], with room for this many pairs.
    pub fn new(mobilities: Vec<N>, n_pairs: usize) -> Self {
        Self {
            touching: Vec::with_capacity(n_pairs),
            impulses: Vec::with_capacity(n_pairs),
            // Only the length matters: every value is set before it is read.
            velocities: mobilities.clone(),
            mobilities,
            together: Together::new(n_pairs),
        }
    }

    /// Forgets the pairs.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.touching.clear();
        self.impulses.clear();
        self.together.clear();
    }

    /// Adds a pair, to the right of the earlier pairs, and its left neighbour.
    #[inline(always)]
    pub fn push(&mut self, pair: usize, left: usize, touching: Touching<N>) {
        let zero = touching.factor.like(0.0);
        self.together.push(pair, left, zero);
        self.impulses.push(zero);
        self.touching.push(touching);
    }

    /// Velocity \[m/s\] after the impacts of a structure that touches.
    #[inline(always)]
    pub fn velocity(&self, node: usize) -> N {
        self.velocities[node]
    }

    /// The pairs.
    #[inline(always)]
    pub fn links(&self) -> &[Link] {
        &self.together.links
    }

    /// The pairs, each with its impulse \[N·s\].
    #[inline(always)]
    pub fn struck(&self) -> impl Iterator<Item = (Link, N)> {
        let links = self.together.links.iter();
        links.copied().zip(self.impulses.iter().copied())
    }

    /// Applies jumps to the velocities \[m/s\] until no touching pair approaches; false if none did.
    #[inline(always)]
    pub fn strike_all(&mut self, velocity: impl Fn(usize) -> N) -> bool {
        for (pair, link) in self.touching.iter_mut().zip(&self.together.links) {
            let [left, right] = [link.left, link.right].map(&velocity);
            self.velocities[link.left] = left;
            self.velocities[link.right] = right;
            pair.speeds = left.abs() + right.abs() + pair.speeds;
        }
        let mut round = 0;
        while round <= MAX_ROUNDS && self.demand(round) {
            self.together.solve(&self.mobilities);
            self.strike();
            round += 1;
        }
        round > 0
    }

    /// Finds the demand of each pair in this round; true if any pair approaches.
    #[inline(always)]
    fn demand(&mut self, round: u32) -> bool {
        let Some(zero) = self.impulses.first().map(|impulse| impulse.like(0.0)) else {
            return false;
        };
        let Together { links, demand, .. } = &mut self.together;
        let nothing = zero.like(f64::NEG_INFINITY);
        let mut approaching = zero.exceeds(zero);
        for (demand, (link, pair)) in demand.iter_mut().zip(links.iter().zip(&self.touching)) {
            let faster = self.velocities[link.left] - self.velocities[link.right];
            let rate = faster + pair.opening_rate;
            // The first round has true approaches; later rounds also have their rounding.
            let left_over = if round == 0 { zero } else { zero.like(ROUNDING) * pair.speeds };
            approaching = approaching | (pair.scenes & rate.exceeds(left_over));
            let wanted = if round == MAX_ROUNDS {
                rate
            } else {
                N::select(zero.exceeds(rate), nothing, pair.factor * rate)
            };
            *demand = N::select(pair.scenes, wanted, nothing);
        }
        // A scene in which no pair approaches is done.
        for demand in demand {
            *demand = N::select(approaching, *demand, nothing);
        }
        N::any(approaching)
    }

    /// Changes the velocities by the impulses of a round.
    #[inline(always)]
    fn strike(&mut self) {
        let (velocities, mobilities) = (&mut self.velocities, &self.mobilities);
        let impulses = &self.together.impulses;
        for (index, link) in self.together.links.iter().enumerate() {
            let impulse = impulses[index];
            self.impulses[index] = self.impulses[index] + impulse;
            // Summed before it is added to a velocity, so that a mirrored row gives mirrored bits.
            let net = if link.is_joined { impulses[index - 1] - impulse } else { -impulse };
            let (left, right) = (link.left, link.right);
            velocities[left] = velocities[left] + mobilities[left] * net;
            if !self.together.joins_next(index) {
                velocities[right] = velocities[right] + mobilities[right] * impulse;
            }
        }
    }
}
