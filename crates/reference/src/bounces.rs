//! Impacts at an instant, and bounces that end in rest.

use super::SecondRouteError;
use super::impact::{self, NOISE, Outcome};
use super::law::Law;
use super::model::{TIME, velocity};
use super::phases::ContactPhase;
use super::runner::Runner;
use super::state::{Bounces, Sum};

/// Impacts of a pair, each within the shortest time of the previous one, after which the pair stops.
const MOST_BOUNCES: u32 = 50;

impl Runner {
    /// Impacts of all impulsive pairs that touch now; then they rest or part.
    pub(super) fn collide(&mut self, time: f64) -> Result<(), SecondRouteError> {
        let touching = impact::touching(&self.motion, &self.state.high);
        // Impulses are larger than any friction.
        self.motion.release();
        let groups = impact::together(&self.motion.model, &touching, time)?;
        for &pair in &touching {
            self.state.set(self.motion.model.pairs[pair].deformation, 0.0);
        }
        let mut phases = self.motion.phases.clone();
        let impulses = self.strike(&touching, &groups, time);
        self.motion.rise_again(&self.state.high, &self.scratch);
        for &pair in touching.iter().filter(|&&pair| impulses[pair] > 0.0) {
            let bounces = &mut self.bounces[pair];
            let soon = time - bounces.last < self.shortest;
            *bounces = Bounces {
                last: time,
                count: if soon { bounces.count + 1 } else { 0 },
            };
        }
        self.scales.enlarge(&self.motion.model, &self.state.high);
        let sizes = self.scales.sizes();
        let least = |pair: usize| NOISE * sizes[self.motion.model.impulse(pair)];
        let least: Vec<_> = (0..impulses.len()).map(least).collect();
        for &pair in &touching {
            // An impact that a pair at rest passes on is a separate collision.
            if impulses[pair] > least[pair] && phases.presses(pair) {
                self.part(pair, time);
                phases.pairs[pair].contact = ContactPhase::IDLE;
            }
        }
        self.record.impacts(&self.motion, &impulses, &least, time);
        self.begin_or_end(&phases, time)?;
        for &pair in &touching {
            self.proposal = self.proposal.min(self.flight(pair).max(self.shortest));
        }
        Ok(())
    }

    /// Applies velocity jumps, without bounces that are over; returns the impulse of every pair \[N·s\].
    fn strike(&mut self, touching: &[usize], groups: &[Vec<usize>], time: f64) -> Vec<f64> {
        let outcome = |pair| {
            if self.stops(pair, touching, time) {
                Outcome::Stops
            } else {
                Outcome::Bounces
            }
        };
        let mut outcomes: Vec<_> = (0..self.bounces.len()).map(outcome).collect();
        let (state, phases) = (self.state.clone(), self.motion.phases.clone());
        loop {
            self.motion.release();
            let model = &self.motion.model;
            let impulses = impact::collide(model, &mut self.state.high, groups, &outcomes);
            self.motion.phases.redirect(model, &self.state.high);
            self.motion.redirect_links(&self.state.high);
            self.motion.grip_again(&self.state.high);
            let model = &self.motion.model;
            for &pair in touching {
                // The rounding of the rate before does not belong to the new rate.
                self.state.low[model.pairs[pair].deformation + 1] = 0.0;
                let rests = model.rate(pair, &self.state.high) >= 0.0;
                let contact = if rests { ContactPhase::IDLE } else { ContactPhase::Apart };
                self.motion.phases.pairs[pair].contact = contact;
            }
            self.motion.decide(&self.state.high, &mut self.scratch);
            let over = touching.iter().filter(|&&pair| self.is_over(pair));
            let over: Vec<_> = over.collect();
            if over.is_empty() {
                return impulses;
            }
            for &pair in over {
                let hit = impulses[pair] > 0.0 && outcomes[pair] == Outcome::Bounces;
                outcomes[pair] = if hit { Outcome::Stops } else { Outcome::Stays };
            }
            self.state.copy_from(&state);
            self.motion.phases.clone_from(&phases);
        }
    }

    /// Whether a pair that is hit now stops. Either it has been hit again and again, or another pair has come to rest on a floor that both
    /// hit in turn. All remaining impulses of this series are then given at once.
    fn stops(&self, pair: usize, touching: &[usize], time: f64) -> bool {
        let soon = |pair: usize| time - self.bounces[pair].last < self.shortest;
        if !soon(pair) {
            return false;
        }
        let pairs = &self.motion.model.pairs;
        let shares = |other: usize| {
            let mut met = pairs[pair].ends.parts();
            other != pair && met.any(|(floor, _)| pairs[other].ends.part(floor) != 0.0)
        };
        let rests = |other: usize| matches!(self.motion.phases.pairs[other].contact, ContactPhase::Resting { .. });
        let mut others = touching.iter();
        self.bounces[pair].count >= MOST_BOUNCES || others.any(|&other| shares(other) && soon(other) && rests(other))
    }

    /// Time until a pair that was just hit touches again at the present acceleration; infinite if it does not. In a longer step it could
    /// touch and part unnoticed.
    fn flight(&self, pair: usize) -> f64 {
        let rate = self.motion.model.rate(pair, &self.state.high);
        let closing = self.motion.closing(pair, &self.state.high, &self.scratch);
        if rate < 0.0 && closing > 0.0 {
            -2.0 * rate / closing
        } else {
            f64::INFINITY
        }
    }

    /// Whether the bounces of a pair that was just hit are over: it closes again within the shortest time.
    fn is_over(&self, pair: usize) -> bool {
        let Law::Impulsive { restitution } = self.motion.model.pairs[pair].law else {
            return false;
        };
        let y = &self.state.high;
        let rate = self.motion.model.rate(pair, y);
        let closing = self.motion.closing(pair, y, &self.scratch);
        rate < 0.0 && restitution < 1.0 && closing > 0.0 && -2.0 * rate < self.shortest * closing * (1.0 - restitution)
    }

    /// Decides which pairs at rest press.
    pub(super) fn rest(&mut self, time: f64) -> Result<(), SecondRouteError> {
        if !self.motion.rests() {
            return Ok(());
        }
        let touching = impact::touching(&self.motion, &self.state.high);
        impact::together(&self.motion.model, &touching, time)?;
        let before = self.motion.phases.clone();
        self.motion.decide(&self.state.high, &mut self.scratch);
        if self.motion.model.frictions().next().is_some() {
            // A floor that sticks or lets go changes the rates of forces at once.
            self.motion.aim(&self.state.high, &self.scratch);
        }
        self.begin_or_end(&before, time)
    }

    /// Records which pairs begin to press at rest, and which stop.
    fn begin_or_end(&mut self, before: &super::phases::Phases, time: f64) -> Result<(), SecondRouteError> {
        for pair in 0..before.pairs.len() {
            match (before.presses(pair), self.motion.phases.presses(pair)) {
                (false, true) => self.touch(pair, time),
                (true, false) => self.part(pair, time),
                (true, true) | (false, false) => {}
            }
        }
        let still = self.motion.still(&self.state.high).len();
        self.unite();
        // Floors that stop with others may stick, too.
        if self.motion.still(&self.state.high).len() > still {
            self.rest(time)
        } else {
            Ok(())
        }
    }

    /// Sets the velocities of floors of the block that follow others, each over its ground, to the last digit.
    fn unite(&mut self) {
        let since = self.state.high[TIME];
        let Self { motion, state, .. } = self;
        for (floor, way) in motion.block.followers() {
            let mut sum = Sum::default();
            for (leader, &part) in way.iter().enumerate().filter(|(_, part)| **part != 0.0) {
                let carried = part * motion.segment.faster([leader, floor], since);
                let own = state.sum(velocity(leader));
                sum = sum.plus_product(Sum::of(part), own).plus(carried);
            }
            state.put_sum(velocity(floor), sum);
        }
    }
}
