//! Velocity jumps of pairs that touch at one instant.
//!
//! Let r be the rate of deformation before, P the impulse and r⁺ the rate after. Touching pairs that do not separate have 0 ≤ −(r⁺ + e r) ⟂
//! P ≥ 0; others have P = 0. This is repeated while a touching pair approaches. Each round changes the kinetic energy by −½ Σ P (1 − e) r ≤
//! 0. A pair that has stopped in a round no longer touches in the next one: for floors caught between two neighbours this is the limit of
//! successive impacts.
//!
//! In a chain the matrix between impulses and rates is an M-matrix, so that a growing set of pairs with an impulse finds the solution.
//! `rounds.rs` has other rows. Impulses and rates are sums of terms of the same sign, so that nothing cancels at extreme mass ratios.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::RunError;

/// What happens when several pairs of a row touch at the same instant.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SimultaneousImpacts {
    /// All pairs together; mirror-symmetric rows stay so.
    #[default]
    Together,
    /// Each pair alone, from left to right, again and again until none approaches.
    Sequential,
}

/// Ends the impacts of an instant if the run exceeds its budget.
pub(super) type Look<'a> = &'a dyn Fn() -> Result<(), RunError>;

/// Number of rounds. Later impacts are plastic (e = 0).
pub(super) const ROUNDS: usize = 50;

/// A chain of neighbours in which each pair touches.
#[derive(Debug, Default)]
pub(super) struct Chain {
    /// Masses \[kg\], infinite for a wall.
    pub(super) masses: Vec<f64>,
    pub(super) velocities: Vec<f64>,
    /// Rate of deformation of every pair \[m/s\].
    pub(super) rates: Vec<f64>,
    pub(super) restitutions: Vec<f64>,
    /// Whether a pair that neither approaches nor separates passes on a hit. A pair that parts counts as open and is treated alone once it
    /// approaches.
    pub(super) passes_on: Vec<bool>,
    /// Impulse of every pair \[N·s\].
    pub(super) impulses: Vec<f64>,
    active: Vec<bool>,
    closing: Vec<bool>,
    /// Rates after the current round.
    after: Vec<f64>,
}

impl Chain {
    pub(super) fn clear(&mut self) {
        self.masses.clear();
        self.velocities.clear();
        self.rates.clear();
        self.restitutions.clear();
        self.passes_on.clear();
        self.impulses.clear();
    }

    /// Gives impulses until no pair approaches. The cost grows with the cube of the chain length: `look` may end it.
    pub(super) fn collide(&mut self, rule: SimultaneousImpacts, look: Look<'_>) -> Result<(), RunError> {
        let n = self.rates.len();
        self.impulses.clear();
        self.impulses.resize(n, 0.0);
        let mut rounds = 0;
        while self.rates.iter().any(|rate| *rate > 0.0) {
            if rounds == ROUNDS {
                self.restitutions.fill(0.0);
            }
            rounds += 1;
            let together = match rule {
                SimultaneousImpacts::Together => true,
                SimultaneousImpacts::Sequential => rounds > ROUNDS,
            };
            if together {
                self.round(rounds > ROUNDS, look)?;
            } else {
                self.sweep(look)?;
            }
            if rounds > 2 * ROUNDS {
                // Only rounding is left.
                for rate in &mut self.rates {
                    *rate = rate.min(0.0);
                }
            }
        }
        Ok(())
    }

    /// Resolves every approaching pair once, from left to right.
    fn sweep(&mut self, look: Look<'_>) -> Result<(), RunError> {
        for pair in 0..self.rates.len() {
            if self.rates[pair] > 0.0 {
                self.active.clear();
                self.active.resize(self.rates.len(), false);
                self.active[pair] = true;
                self.apply(look)?;
            }
        }
        Ok(())
    }

    /// Resolves all pairs at once. The final plastic round includes pairs that separate.
    fn round(&mut self, plastic: bool, look: Look<'_>) -> Result<(), RunError> {
        let n = self.rates.len();
        self.closing.clear();
        let closes = |(rate, passes_on): (&f64, &bool)| plastic || *rate > 0.0 || (*rate >= 0.0 && *passes_on);
        let pairs = self.rates.iter().zip(&self.passes_on);
        self.closing.extend(pairs.map(closes));
        self.active.clear();
        self.active.extend(self.rates.iter().map(|rate| *rate > 0.0));
        loop {
            self.rates_after(look)?;
            let mut grown = false;
            for pair in 0..n {
                let wanted = -self.restitutions[pair] * self.rates[pair];
                if self.closing[pair] && !self.active[pair] && self.after[pair] > wanted {
                    self.active[pair] = true;
                    grown = true;
                }
            }
            if !grown {
                break;
            }
        }
        self.apply(look)
    }

    /// First and last structure of the block of active pairs around a structure.
    fn block(&self, structure: usize) -> (usize, usize) {
        let (mut first, mut last) = (structure, structure);
        while first > 0 && self.active[first - 1] {
            first -= 1;
        }
        while last < self.active.len() && self.active[last] {
            last += 1;
        }
        (first, last)
    }

    /// Change of rate that an active pair demands, ≥ 0.
    fn turn(&self, pair: usize) -> f64 {
        (1.0 + self.restitutions[pair]) * self.rates[pair]
    }

    /// Impulse of an active pair: Σ over the pairs q of its block of turn(q) · (mass left of both)·(mass right of both)/M.
    fn impulse(&self, pair: usize, first: usize, last: usize, look: Look<'_>) -> Result<f64, RunError> {
        let left = |pair: usize| self.masses[first..=pair].iter().sum::<f64>();
        let right = |pair: usize| self.masses[pair + 1..=last].iter().sum::<f64>();
        (first..last)
            .map(|other| {
                look()?;
                let (lower, upper) = (pair.min(other), pair.max(other));
                let (near, far) = (left(lower), right(upper));
                let total = left(last - 1) + self.masses[last];
                // A wall is infinitely heavy: its side and the total mass cancel.
                let share = match (near.is_infinite(), far.is_infinite()) {
                    (false, true) => near,
                    (true, false) => far,
                    (true, true) => 0.0,
                    (false, false) => near * far / total,
                };
                Ok(self.turn(other) * share)
            })
            .sum()
    }

    /// Rates after the impulses of the active pairs.
    fn rates_after(&mut self, look: Look<'_>) -> Result<(), RunError> {
        let n = self.rates.len();
        self.after.clear();
        for pair in 0..n {
            let after = if self.active[pair] {
                -self.restitutions[pair] * self.rates[pair]
            } else {
                // Only pairs outside push the two neighbours towards each other.
                let push = |other: usize, structure: usize| {
                    let (first, last) = self.block(structure);
                    Ok(self.impulse(other, first, last, look)? / self.masses[structure])
                };
                let from_left = if pair > 0 && self.active[pair - 1] {
                    push(pair - 1, pair)?
                } else {
                    0.0
                };
                let from_right = if pair + 1 < n && self.active[pair + 1] {
                    push(pair + 1, pair + 1)?
                } else {
                    0.0
                };
                self.rates[pair] + from_left + from_right
            };
            self.after.push(after);
        }
        Ok(())
    }

    /// Applies the impulses of the active pairs.
    ///
    /// The velocities of a block follow from its momentum and its inner rates. Adding impulses to the velocities would lose the digits of a
    /// light structure between heavy ones.
    fn apply(&mut self, look: Look<'_>) -> Result<(), RunError> {
        self.rates_after(look)?;
        let mut first = 0;
        while first < self.masses.len() {
            let (_, last) = self.block(first);
            if last > first {
                for pair in first..last {
                    let impulse = self.impulse(pair, first, last, look)?;
                    self.impulses[pair] += impulse;
                }
                self.set_velocities(first, last, look)?;
            }
            first = last + 1;
        }
        std::mem::swap(&mut self.rates, &mut self.after);
        Ok(())
    }

    /// Velocity of each structure of a block: V + Σ r⁺ (mass right of the pair)/M over the pairs to its right − Σ r⁺ (mass left of the
    /// pair)/M over those to its left. V is the momentum of the block over its mass M. The order of summation makes a mirrored block give
    /// mirrored bits.
    fn set_velocities(&mut self, first: usize, last: usize, look: Look<'_>) -> Result<(), RunError> {
        let (masses, after) = (&self.masses, &self.after);
        let outward = |sum: f64, mass: &f64| sum + mass;
        let left = |pair: usize| masses[first..=pair].iter().rev().fold(0.0, outward);
        let right = |pair: usize| masses[pair + 1..=last].iter().fold(0.0, outward);
        let share = |side: f64, pair: usize| {
            // A wall is infinitely heavy: only its side counts.
            if side.is_infinite() {
                1.0
            } else {
                side / (left(pair) + right(pair))
            }
        };
        let n = last - first + 1;
        let symmetric = |term: &dyn Fn(usize) -> f64| {
            let ends = (0..n / 2).map(|k| term(first + k) + term(last - k));
            let middle = if n % 2 == 1 { term(first + n / 2) } else { 0.0 };
            ends.sum::<f64>() + middle
        };
        let mass = symmetric(&|index| masses[index]);
        let common = if mass.is_infinite() {
            0.0
        } else {
            symmetric(&|index| masses[index] * self.velocities[index]) / mass
        };
        for (index, velocity) in self.velocities.iter_mut().enumerate().take(last + 1).skip(first) {
            look()?;
            let from_right = (index..last).fold(0.0, |sum, pair| sum + after[pair] * share(right(pair), pair));
            let from_left = (first..index)
                .rev()
                .fold(0.0, |sum, pair| sum + after[pair] * share(left(pair), pair));
            *velocity = if masses[index].is_infinite() {
                0.0
            } else {
                common + (from_right - from_left)
            };
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impact::rounds::{Rounds, Touching};
    use proptest::prelude::*;

    fn chain(masses: &[f64], velocities: &[f64], restitution: f64) -> Chain {
        let rates: Vec<_> = velocities.windows(2).map(|v| v[0] - v[1]).collect();
        Chain {
            passes_on: rates.iter().map(|rate| rate.abs() <= 0.0).collect(),
            masses: masses.to_vec(),
            velocities: velocities.to_vec(),
            rates,
            restitutions: vec![restitution; masses.len() - 1],
            ..Chain::default()
        }
    }

    #[test]
    fn reference_three_equal_masses() {
        let mut together = chain(&[2.0; 3], &[3.0, 0.0, 0.0], 1.0);
        together.collide(SimultaneousImpacts::Together, &|| Ok(())).expect("nobody ends it");
        for (found, wanted) in together.velocities.iter().zip([-1.0, 2.0, 2.0]) {
            assert!((found - wanted).abs() < 1e-15, "{:?}", together.velocities);
        }
        let mut sequential = chain(&[2.0; 3], &[3.0, 0.0, 0.0], 1.0);
        sequential
            .collide(SimultaneousImpacts::Sequential, &|| Ok(()))
            .expect("nobody ends it");
        assert_eq!(sequential.velocities, [0.0, 0.0, 3.0]);
    }

    #[test]
    fn reference_wall() {
        let mut chain = chain(&[2.0, f64::INFINITY], &[3.0, 0.0], 0.5);
        chain.collide(SimultaneousImpacts::Together, &|| Ok(())).expect("nobody ends it");
        assert_eq!(chain.velocities, [-1.5, 0.0]);
        assert_eq!(chain.impulses, [9.0]);
    }

    #[test]
    fn limit_mirror_symmetric_double_hit() {
        let mut chain = chain(&[1e6, 1.0, 1e6], &[1.0, 0.0, -1.0], 0.4);
        chain.collide(SimultaneousImpacts::Together, &|| Ok(())).expect("nobody ends it");
        assert!((chain.velocities[0] + 0.4).abs() < 1e-15, "{:?}", chain.velocities);
        assert_eq!(chain.velocities[1..], [0.0, -chain.velocities[0]]);
    }

    proptest! {
        /// The rule of the stepping methods, computed by another route.
        #[test]
        fn reference_together_is_what_stepping_methods_do(
            structures in prop::collection::vec((-1.0..1.0_f64, -2.0..2.0_f64), 2..9),
            restitution in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64],
        ) {
            let masses: Vec<_> = structures.iter().map(|(exponent, _)| libm::pow(10.0, *exponent)).collect();
            let velocities: Vec<_> = structures.iter().map(|(_, velocity)| *velocity).collect();
            let mobilities = masses.iter().map(|mass| 1.0 / mass).collect();
            let mut rounds = Rounds::new(mobilities, masses.len() - 1);
            for left in 1..masses.len() {
                rounds.push(left - 1, left - 1, Touching::on_one_ground(true, 1.0 + restitution));
            }
            let struck = rounds.strike_all(|node| velocities[node]);
            let mut chain = chain(&masses, &velocities, restitution);
            prop_assert_eq!(struck, chain.rates.iter().any(|rate| *rate > 0.0));
            chain.collide(SimultaneousImpacts::Together, &|| Ok(())).expect("nobody ends it");
            for (node, wanted) in chain.velocities.iter().enumerate() {
                let found = rounds.velocity(node);
                prop_assert!((found - wanted).abs() < 1e-10, "{node}: {found} {wanted}");
            }
            for ((_, found), wanted) in rounds.struck().zip(&chain.impulses) {
                prop_assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
            }
        }

        #[test]
        fn limit_momentum_energy_and_no_approach(
            structures in prop::collection::vec((-6.0..6.0_f64, -2.0..2.0_f64), 2..7),
            restitution in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64],
            sequential: bool,
        ) {
            let masses: Vec<_> = structures.iter().map(|(exponent, _)| libm::pow(10.0, *exponent)).collect();
            let velocities: Vec<_> = structures.iter().map(|(_, velocity)| *velocity).collect();
            let mut chain = chain(&masses, &velocities, restitution);
            let rule = if sequential { SimultaneousImpacts::Sequential } else { SimultaneousImpacts::Together };
            chain.collide(rule, &|| Ok(())).expect("nobody ends it");
            prop_assert!(chain.rates.iter().all(|rate| *rate <= 0.0), "{:?}", chain.rates);
            prop_assert!(chain.impulses.iter().all(|impulse| *impulse >= 0.0), "{:?}", chain.impulses);
            let sum = |f: &dyn Fn(usize) -> f64| (0..masses.len()).map(f).sum::<f64>();
            let (before, after) = (sum(&|i| masses[i] * velocities[i]), sum(&|i| masses[i] * chain.velocities[i]));
            let scale = sum(&|i| masses[i] * velocities[i].abs());
            prop_assert!((before - after).abs() <= 1e-13 * scale, "momentum {before} {after}");
            let (before, after) =
                (sum(&|i| masses[i] * velocities[i] * velocities[i]), sum(&|i| masses[i] * chain.velocities[i] * chain.velocities[i]));
            prop_assert!(after <= before * (1.0 + 1e-12), "energy {before} {after}");
            for (pair, rate) in chain.rates.iter().enumerate() {
                let found = chain.velocities[pair] - chain.velocities[pair + 1];
                prop_assert!((found - rate).abs() <= 1e-12 * scale / masses.iter().copied().fold(f64::INFINITY, f64::min).max(1e-30) , "{found} {rate}");
            }
        }
    }
}
