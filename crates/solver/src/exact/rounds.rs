//! Impulses of any pairs that touch at one instant, in the rounds that chains have.
//!
//! With W = G M⁻¹ Gᵀ each round asks for 0 ≤ W P − (1 + e) r ⟂ P ≥ 0 over the pairs that do not separate. A push on a floor may help
//! other pairs of its building: growing the set of those that push is not enough.

use crate::RunError;
use crate::exact::impacts::{Look, ROUNDS, SimultaneousImpacts};
use crate::exact::rounding::OF_COEFFICIENTS;
use crate::impact::dense::{ClosedIn, Complementarity};

/// Pairs that touch, one number each.
pub(super) struct Rounds {
    /// Rates of deformation \[m/s\].
    pub(super) rates: Vec<f64>,
    pub(super) restitutions: Vec<f64>,
    /// Whether a pair that neither approaches nor separates passes on what it is hit by.
    pub(super) passes_on: Vec<bool>,
    /// Magnitudes of which the rates are rounded \[m/s\].
    pub(super) scales: Vec<f64>,
    /// Whether grounds move apart, and may leave no room for what is between two walls. Else only rounding does.
    pub(super) opens: bool,
    /// Impulses of all rounds \[N·s\].
    pub(super) impulses: Vec<f64>,
}

impl Rounds {
    /// Gives impulses until no pair approaches.
    pub(super) fn collide(
        &mut self,
        problem: &mut Complementarity,
        rule: SimultaneousImpacts,
        look: Look<'_>,
    ) -> Result<Result<(), ClosedIn>, RunError> {
        let mut rounds = 0;
        while self.approaches() {
            if rounds == ROUNDS {
                self.restitutions.fill(0.0);
            }
            rounds += 1;
            let plastic = rounds > ROUNDS;
            let alone = rule == SimultaneousImpacts::Sequential && !plastic;
            let sweeps = if alone { self.rates.len() } else { 1 };
            for pair in 0..sweeps {
                look()?;
                let takes_part = |index: usize, rate: f64, passes_on: bool| {
                    let closes = plastic || rate > 0.0 || (rate >= 0.0 && passes_on);
                    if alone {
                        index == pair && rate > 0.0
                    } else {
                        closes
                    }
                };
                if let Err(closed_in) = self.round(problem, takes_part) {
                    return Ok(Err(closed_in));
                }
            }
            if rounds > 2 * ROUNDS {
                // Rounding alone is left.
                for rate in &mut self.rates {
                    *rate = rate.min(0.0);
                }
            }
        }
        Ok(Ok(()))
    }

    /// Whether a pair approaches; what rounding leaves of a rate is none.
    fn approaches(&mut self) -> bool {
        for (rate, scale) in self.rates.iter_mut().zip(&self.scales) {
            if *rate > 0.0 && *rate <= OF_COEFFICIENTS * scale {
                *rate = 0.0;
            }
        }
        self.rates.iter().any(|rate| *rate > 0.0)
    }

    /// One round of the pairs that take part, by their place, rate and whether they pass on.
    fn round(
        &mut self,
        problem: &mut Complementarity,
        takes_part: impl Fn(usize, f64, bool) -> bool,
    ) -> Result<(), ClosedIn> {
        let n = self.rates.len();
        let part = |index: usize| takes_part(index, self.rates[index], self.passes_on[index]);
        let mut parts: Vec<_> = (0..n).map(part).collect();
        for (index, part) in parts.iter().enumerate() {
            let wanted = (1.0 + self.restitutions[index]) * self.rates[index];
            let demand = if *part { wanted } else { f64::NEG_INFINITY };
            problem.ask(index, demand, self.scales[index]);
        }
        while let Err(closed_in) = problem.solve() {
            if self.opens {
                return Err(closed_in);
            }
            problem.ask(closed_in.contact, f64::NEG_INFINITY, 0.0);
            parts[closed_in.contact] = false;
            self.rates[closed_in.contact] = 0.0;
        }
        for (index, impulse) in problem.impulses().enumerate() {
            let rate = self.rates[index];
            let (kept, returned) = (
                rate - problem.taken(index),
                -self.restitutions[index] * rate,
            );
            self.rates[index] = match parts[index] {
                true if impulse > 0.0 => returned,
                true => kept.min(returned),
                false => kept,
            };
            self.impulses[index] += impulse;
        }
        Ok(())
    }
}
