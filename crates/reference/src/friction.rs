//! Friction below floors on the ground, which stick or slide.
//!
//! A floor that sticks has no mass for others: it moves as its ground does, like a wall. The friction that holds it balances its other
//! forces, and the floor sticks while it is at most the limit. A floor that slides has the limit as friction, against its motion.
//!
//! Where floors do not move, all choices are tried: each may stick, or begin to slide to one side, unless it would accelerate to the other one.
//! Of those that fit and in which most floors stick, neighbours that press have the least Σ F² shortly after: they bear only what friction
//! does not hold.

use super::equations::Equations;
use super::model::{TIME, velocity};
use super::rest::IDLE;
use super::storey::{Friction, sign};

/// Time after which forces of choices are compared \[s\]: forces that are equal now differ then by more than rounding, and no other event
/// is near (1/1112 of the campaign).
const SHORTLY: f64 = 1e-7;

impl Equations {
    /// Adds the friction to the forces on floors; that of floors that stick balances the others.
    pub(super) fn rub(&self, y: &[f64], dy: &mut [f64]) {
        for (floor, friction) in self.model.frictions() {
            let phase = &self.phases.structures[floor];
            let force = match phase.held {
                Some(_) => dy[velocity(floor)] - self.segment.ground(floor, y[TIME]) / friction.inverse_mass,
                None => phase.direction * friction.limit,
            };
            dy[velocity(floor)] -= force;
            dy[friction.unknown] = force;
        }
    }

    /// Lets friction bear the force of a pair at rest on floors that stick.
    pub(super) fn brace(&self, pair: usize, force: f64, slope: &mut [f64]) {
        for (floor, friction) in self.model.frictions() {
            if self.phases.structures[floor].held.is_some() {
                slope[friction.unknown] -= self.model.pairs[pair].ends.part(floor) * force;
            }
        }
    }

    /// Gives all floors their own masses, for an impact.
    pub(super) fn release(&mut self) {
        for structure in &mut self.model.structures {
            if let Some(friction) = structure.friction {
                structure.inverse_mass = friction.inverse_mass;
            }
        }
    }

    /// Floors with friction that do not move.
    pub(super) fn still(&self, y: &[f64]) -> Vec<usize> {
        let floors = self.model.frictions().map(|(floor, _)| floor);
        floors.filter(|floor| y[velocity(*floor)] == 0.0).collect()
    }

    /// Lets a floor slide to a side, or stick at side 0.
    fn set_side(&mut self, floor: usize, side: f64) {
        let structure = &mut self.model.structures[floor];
        let own = structure.friction.map_or(structure.inverse_mass, |friction| friction.inverse_mass);
        structure.inverse_mass = if side == 0.0 { 0.0 } else { own };
        let phase = &mut self.phases.structures[floor];
        phase.held = (side == 0.0).then_some(1.0);
        if side != 0.0 {
            (phase.direction, phase.drift_direction) = (side, side);
        }
    }

    /// Decides which floors stick and which slide, while some pairs are at rest.
    pub(super) fn stick_or_slide(&mut self, resting: &[usize], y: &[f64], scratch: &mut [f64]) {
        let moving: Vec<_> = self.model.frictions().map(|(floor, _)| (floor, y[velocity(floor)])).collect();
        for (floor, velocity) in moving.into_iter().filter(|(_, velocity)| *velocity != 0.0) {
            self.set_side(floor, sign(velocity));
        }
        let still = self.still(y);
        if still.is_empty() {
            return;
        }
        let mut best: Option<([f64; 2], Vec<f64>)> = None;
        for sides in sides(still.len()) {
            // Of the choices that fit, only those in which most floors stick count.
            let fits = |([miss, _], known): &([f64; 2], Vec<f64>)| *miss == 0.0 && n_sliding(known) < n_sliding(&sides);
            if best.as_ref().is_some_and(fits) {
                break;
            }
            let found = self.try_sides(&still, &sides, resting, y, scratch);
            if best.as_ref().is_none_or(|(known, _)| found < *known) {
                best = Some((found, sides));
            }
        }
        for (floor, side) in still.iter().zip(best.map_or(Vec::new(), |(_, sides)| sides)) {
            self.set_side(*floor, side);
        }
    }

    /// Tries sides of floors that do not move: by how much they are wrong \[m/s²\], and Σ F² of pairs at rest \[N²\] shortly after: when a force
    /// fades, two choices may have the same forces now.
    fn try_sides(&mut self, still: &[usize], sides: &[f64], resting: &[usize], y: &[f64], scratch: &mut [f64]) -> [f64; 2] {
        for (floor, side) in still.iter().zip(sides) {
            self.set_side(*floor, *side);
        }
        let closings = self.press(resting, y, scratch);
        self.lean(scratch);
        let terms = self.block.accelerations(f64::abs, &self.terms(y));
        let wrong = |(&floor, &side): (&usize, &f64)| match self.model.structures[floor].friction {
            Some(friction) if side == 0.0 => -self.left(floor, friction, y, scratch) * friction.inverse_mass,
            Some(_) | None => {
                let over_ground = scratch[velocity(floor)] - self.segment.ground(floor, y[TIME]);
                -side * over_ground - IDLE * terms[floor]
            }
        };
        let closing = |pair: &usize| closings[*pair][0] - closings[*pair][1];
        let all = still.iter().zip(sides).map(wrong).chain(resting.iter().map(closing));
        let wrong = all.fold(0.0, f64::max);
        self.slope(super::equations::NOW, y, scratch);
        let near: Vec<_> = y
            .iter()
            .zip(scratch.iter())
            .map(|(unknown, slope)| unknown + SHORTLY * slope)
            .collect();
        self.slope(super::equations::NOW, &near, scratch);
        let square = |pair: &usize| scratch[self.model.impulse(*pair)] * scratch[self.model.impulse(*pair)];
        [wrong, self.block.pairs.iter().map(square).sum()]
    }

    /// Size of the terms of the friction that holds a floor \[N\].
    fn friction_terms(&self, floor: usize, y: &[f64]) -> f64 {
        let forces = self.block.forces(f64::abs, &self.terms(y));
        let pressed = self.block.pairs.iter().zip(forces);
        let pressed = pressed.map(|(pair, force)| self.model.pairs[*pair].ends.part(floor).abs() * force);
        self.loads(y)[floor] + pressed.sum::<f64>()
    }

    /// What is left until the friction that holds a floor exceeds its limit by more than rounding \[N\].
    fn left(&self, floor: usize, friction: Friction, y: &[f64], slope: &[f64]) -> f64 {
        friction.limit + IDLE * self.friction_terms(floor, y) - slope[friction.unknown].abs()
    }

    /// Negative once a floor that sticks slides. `scratch` receives the derivative of the unknowns.
    pub(super) fn before_slip(&self, floor: usize, y: &[f64], scratch: &mut [f64]) -> f64 {
        self.slope(super::equations::NOW, y, scratch);
        let friction = self.model.structures[floor].friction;
        friction.map_or(0.0, |friction| self.left(floor, friction, y, scratch))
    }

    /// Negative once the friction that holds a floor has passed a maximum or minimum. `scratch` receives the derivative of the unknowns.
    pub(super) fn friction_peak(&self, floor: usize, y: &[f64], scratch: &mut [f64]) -> f64 {
        self.slope(super::equations::NOW, y, scratch);
        let [rate, rounding] = self.friction_rate(floor, y, scratch);
        self.phases.structures[floor].held.map_or(0.0, |rising| rising * rate + rounding)
    }

    /// Rate of the friction below a floor \[N/s\], and its rounding. `slope` is the derivative of the unknowns.
    fn friction_rate(&self, floor: usize, y: &[f64], slope: &[f64]) -> [f64; 2] {
        let friction = self.model.structures[floor].friction;
        friction.map_or([0.0; 2], |friction| {
            self.rate_of(friction.unknown, self.friction_terms(floor, y), y, slope)
        })
    }

    /// Notes whether the friction that holds floors rises.
    pub(super) fn rise_or_fall(&mut self, y: &[f64], slope: &[f64]) {
        for floor in self.still(y) {
            let [rate, _] = self.friction_rate(floor, y, slope);
            let held = &mut self.phases.structures[floor].held;
            *held = held.map(|_| sign(rate));
        }
    }
}

/// All choices of sides, −1, 0 or 1, for `n` floors; those with more zeros first.
fn sides(n: usize) -> Vec<Vec<f64>> {
    let mut all = vec![Vec::new()];
    for _ in 0..n {
        let longer = |sides: &Vec<f64>| [0.0, 1.0, -1.0].map(|side| [sides.as_slice(), &[side]].concat());
        all = all.iter().flat_map(longer).collect();
    }
    all.sort_by_key(|sides| n_sliding(sides));
    all
}

fn n_sliding(sides: &[f64]) -> usize {
    sides.iter().filter(|side| **side != 0.0).count()
}
