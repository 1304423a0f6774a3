//! Rounds of impulses between pairs that touch and are a chain, of one scene or of several side by side.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

use crate::impact::chain::{Link, Together};

/// Rounds after which the rest is plastic: what still touches and approaches then stays together.
pub(crate) const MAX_ROUNDS: u32 = 50;
/// An approach left by rounding, relative to the velocities.
pub const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// An impulsive pair that touches.
#[expect(missing_debug_implementations, reason = "masks of lanes have none")]
pub struct Touching<N: Number> {
    /// The scenes in which it does.
    pub scenes: N::Mask,
    /// 1 + e.
    pub factor: N,
    /// Rate at which the grounds under it move towards each other \[m/s\].
    pub opening_rate: N,
    /// The magnitude of which that is rounded \[m/s\]; its velocities are added when it is struck.
    pub speeds: N,
}

impl<N: Number> Touching<N> {
    /// A pair under which no ground moves towards the other.
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
    /// Impulse of each \[N·s\], all rounds.
    impulses: Vec<N>,
    /// Velocity of every structure \[m/s\], before and after; those of structures that touch none are left alone.
    velocities: Vec<N>,
    /// Velocities that a unit impulse gives to each structure \[1/kg\].
    mobilities: Vec<N>,
    together: Together<N>,
}

impl<N: Number> Rounds<N> {
    /// Of structures of such mobilities \[1/kg\], with room for so many pairs.
    pub fn new(mobilities: Vec<N>, n_pairs: usize) -> Self {
        Self {
            touching: Vec::with_capacity(n_pairs),
            impulses: Vec::with_capacity(n_pairs),
            // Of the same length; none is read before it is taken.
            velocities: mobilities.clone(),
            mobilities,
            together: Together::new(n_pairs),
        }
    }

    /// Takes structures of such mobilities \[1/kg\] in place of those it has, and forgets the pairs.
    #[inline(always)]
    pub fn renew(&mut self, mobilities: impl Iterator<Item = N>) {
        self.clear();
        self.mobilities.clear();
        self.mobilities.extend(mobilities);
        self.velocities.clone_from(&self.mobilities);
    }

    /// Forgets the pairs.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.touching.clear();
        self.impulses.clear();
        self.together.clear();
    }

    /// Takes a pair, farther to the right than those before, and its left neighbour.
    #[inline(always)]
    pub fn push(&mut self, of: (usize, usize), touching: Touching<N>) {
        let zero = touching.factor.like(0.0);
        self.together.push(of, zero);
        self.impulses.push(zero);
        self.touching.push(touching);
    }

    /// Velocity of a structure after \[m/s\], of one that touches.
    #[inline(always)]
    pub fn velocity(&self, node: usize) -> N {
        self.velocities[node]
    }

    /// The pairs taken.
    #[inline(always)]
    pub fn links(&self) -> &[Link] {
        &self.together.links
    }

    /// The same, each with its impulse \[N·s\].
    #[inline(always)]
    pub fn struck(&self) -> impl Iterator<Item = (Link, N)> {
        let links = self.together.links.iter();
        links.copied().zip(self.impulses.iter().copied())
    }

    /// Lets the velocities before \[m/s\] jump until no pair approaches that touches; false when none does.
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

    /// Asks what each pair has to lose in this round; true when one approaches.
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
            // The first round meets real approaches; later ones also meet what rounding made of those.
            let left_over = if round == 0 { zero } else { zero.like(ROUNDING) * pair.speeds };
            approaching = approaching | (pair.scenes & rate.exceeds(left_over));
            let wanted = if round == MAX_ROUNDS {
                rate
            } else {
                N::select(zero.exceeds(rate), nothing, pair.factor * rate)
            };
            *demand = N::select(pair.scenes, wanted, nothing);
        }
        // A scene in which no pair approaches is at its end.
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
            // Summed before it is added to a velocity: a mirrored row then gives mirrored bits.
            let net = if link.is_joined { impulses[index - 1] - impulse } else { -impulse };
            let (left, right) = (link.left, link.right);
            velocities[left] = velocities[left] + mobilities[left] * net;
            if !self.together.joins_next(index) {
                velocities[right] = velocities[right] + mobilities[right] * impulse;
            }
        }
    }
}
