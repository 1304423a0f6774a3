//! Scales of the unknowns for error control.

use super::model::{Model, TIME, displacement, velocity};

/// Sizes of the unknowns.
#[derive(Debug, Clone)]
pub(super) struct Scales {
    /// Largest magnitude so far of each displacement and velocity, and of the rates of deformation.
    largest: Vec<f64>,
    /// Size of each unknown.
    sizes: Vec<f64>,
    longest_step: f64,
    /// Speed \[m/s\] below which a structure counts as not yet moving: a structure that leaves its neighbour does so with the rounding of
    /// the ground's acceleration.
    least_speed: f64,
}

/// Ratio of the least speed to the ground's largest acceleration times the longest step.
const LEAST: f64 = 1e-6;

impl Scales {
    /// Scales before the start, for segments of `interval` \[s\] and steps of at most `longest_step` \[s\].
    pub(super) fn new(n_unknowns: usize, interval: f64, longest_step: f64) -> Self {
        let mut sizes = vec![0.0; n_unknowns];
        sizes[TIME] = interval;
        Self {
            largest: vec![0.0; n_unknowns],
            sizes,
            longest_step,
            least_speed: 0.0,
        }
    }

    /// Notes a ground acceleration \[m/s²\] under neighbours at rest.
    pub(super) fn shake(&mut self, acceleration: f64) {
        let speed = LEAST * self.longest_step * acceleration.abs();
        self.least_speed = self.least_speed.max(speed);
    }

    /// Sizes of the unknowns.
    pub(super) fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    /// Largest speed so far of the structures of a pair, summed, or of their grounds relative to each other \[m/s\].
    fn speed(&self, model: &Model, pair: usize) -> f64 {
        let neighbours = model.pairs[pair];
        let speed = neighbours.ends.size(|floor| self.largest[velocity(floor)]);
        speed.max(self.largest[neighbours.deformation + 1])
    }

    /// Updates the scales with a state.
    pub(super) fn enlarge(&mut self, model: &Model, y: &[f64]) {
        for index in 0..model.structures.len() {
            for unknown in [displacement(index), velocity(index)] {
                self.largest[unknown] = self.largest[unknown].max(y[unknown].abs());
                self.sizes[unknown] = self.largest[unknown];
            }
            let speed = &mut self.sizes[velocity(index)];
            *speed = speed.max(self.least_speed);
        }
        for (index, pair) in model.pairs.iter().enumerate() {
            let rate = pair.deformation + 1;
            self.largest[rate] = self.largest[rate].max(y[rate].abs());
            // Neighbours that begin to press at rest have no speed yet, and their impulse begins like a high power of time, too.
            let momentum = pair.reduced_mass * self.speed(model, index).max(self.least_speed);
            self.sizes[model.impulse(index)] = momentum;
            // A structure that its first collision sets in motion has no scale yet. Relative to the structure itself, the error of a motion
            // that begins like a high power of the variable is the same in every step, however short.
            for (structure, part) in pair.ends.parts() {
                let gained = momentum * (part.abs() * model.structures[structure].inverse_mass);
                let size = &mut self.sizes[velocity(structure)];
                *size = size.max(gained);
            }
        }
        self.share(model, velocity);
        for index in 0..model.structures.len() {
            let moved = self.sizes[velocity(index)] * self.longest_step;
            let size = &mut self.sizes[displacement(index)];
            *size = size.max(moved);
        }
        self.share(model, displacement);
        // Errors of deformations are those of the displacements and velocities in their differences.
        for pair in &model.pairs {
            self.sizes[pair.deformation] = f64::INFINITY;
            self.sizes[pair.deformation + 1] = f64::INFINITY;
        }
        for (index, smooth) in model.smooth() {
            let moved = self.sizes[velocity(index)] * self.longest_step;
            let largest = &mut self.largest[smooth.unknown];
            *largest = largest.max(y[smooth.unknown].abs());
            self.sizes[smooth.unknown] = largest.max(moved);
        }
        // What holds a floor follows from the other unknowns.
        for (_, friction) in model.frictions() {
            self.sizes[friction.unknown] = f64::INFINITY;
        }
        for link in &model.links {
            if let Some(force) = link.unknown() {
                let moved = link.ends.size(|floor| self.sizes[velocity(floor)]) * self.longest_step;
                let largest = &mut self.largest[force];
                *largest = largest.max(y[force].abs());
                self.sizes[force] = largest.max(link.rates()[0] * moved);
            }
        }
    }

    /// Gives all floors of a body the largest of their scales.
    ///
    /// Drifts are differences of displacements. A floor set in motion by the floor below begins to move like a higher power of time than a
    /// structure that is hit.
    fn share(&mut self, model: &Model, unknown: fn(usize) -> usize) {
        let mut largest = vec![0.0_f64; model.structures.len()];
        for (floor, structure) in model.structures.iter().enumerate() {
            let of_body = &mut largest[structure.body];
            *of_body = of_body.max(self.sizes[unknown(floor)]);
        }
        for (floor, structure) in model.structures.iter().enumerate() {
            self.sizes[unknown(floor)] = largest[structure.body];
        }
    }
}
