//! Equations of motion between two events.

use super::block::Block;
use super::law::{Law, Touching};
use super::model::{Model, TIME, displacement, velocity};
use super::phases::{ContactPhase, Phases};
use super::state::State;
use super::storey::{Branch, sign};
use super::variable::Variable;

/// A place in a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct InStep {
    /// Variable of the step.
    pub variable: Variable,
    /// Value of the variable, from 0 at the start of the step.
    pub position: f64,
}

/// Place of derivatives with respect to time.
pub(super) const NOW: InStep = InStep {
    variable: Variable::Time,
    position: 0.0,
};

/// All data of the equations of motion.
#[derive(Debug, Clone)]
pub(super) struct Equations {
    pub model: Model,
    pub phases: Phases,
    /// The pairs that press at rest; decided together with the phases.
    pub block: Block,
    pub segment: Segment,
}

/// A segment of the record.
#[derive(Debug, Clone, Default)]
pub(super) struct Segment {
    /// Its start \[s\].
    pub start: f64,
    /// Its length \[s\].
    pub length: f64,
    /// Ground acceleration at its start \[m/s²\] and its rate \[m/s³\], under every structure.
    pub grounds: Vec<(f64, f64)>,
    /// Displacement \[m\] and velocity \[m/s\] of the ground under every structure at the start, at the places of the structure's unknowns.
    pub moved: State,
}

impl Segment {
    /// Velocity of the ground under one structure relative to that under another, at a time since the start of the segment \[m/s\].
    pub(super) fn faster(&self, [one, other]: [usize; 2], since: f64) -> f64 {
        let [(of_one, rate_of_one), (of_other, rate_of_other)] = [one, other].map(|structure| self.grounds[structure]);
        let change = (of_one - of_other) + 0.5 * since * (rate_of_one - rate_of_other);
        self.moved.difference(velocity(one), velocity(other)) + since * change
    }

    /// Displacement of the ground under one structure relative to that under another, at a time since the start of the segment \[m\].
    pub(super) fn farther(&self, [one, other]: [usize; 2], since: f64) -> f64 {
        let [(of_one, rate_of_one), (of_other, rate_of_other)] = [one, other].map(|structure| self.grounds[structure]);
        let bent = 0.5 * (of_one - of_other) + since / 6.0 * (rate_of_one - rate_of_other);
        let faster = self.moved.difference(velocity(one), velocity(other)) + since * bent;
        self.moved.difference(displacement(one), displacement(other)) + since * faster
    }

    /// Ground acceleration under a structure, at a time since the start of the segment \[m/s²\].
    pub(super) fn ground(&self, structure: usize, since: f64) -> f64 {
        let (start, rate) = self.grounds[structure];
        start + rate * since
    }
}

impl Equations {
    /// Derivative of the unknowns with respect to a variable at a position.
    pub(super) fn slope(&self, place: InStep, y: &[f64], dy: &mut [f64]) {
        let Self { model, segment, .. } = self;
        self.accelerate(place, y, dy);
        self.lean(dy);
        self.close(y, dy);
        for index in 0..model.structures.len() {
            let slope = &mut dy[velocity(index)];
            *slope = if model.is_wall(index) {
                0.0
            } else {
                *slope - segment.ground(index, y[TIME])
            };
        }
        dy[TIME] = 1.0;
        let InStep { variable, position } = place;
        if !matches!(variable, Variable::Time) {
            let pace = variable.pace(position, |pair| model.rate(pair, y));
            for slope in dy {
                *slope *= pace;
            }
        }
    }

    /// Pounding forces and absolute accelerations without the forces of pairs at rest, and the other derivatives.
    pub(super) fn accelerate(&self, InStep { variable, position }: InStep, y: &[f64], dy: &mut [f64]) {
        let Self {
            model, phases, segment, ..
        } = self;
        for (index, structure) in model.structures.iter().enumerate() {
            dy[displacement(index)] = y[velocity(index)];
            let rate = model.drift_rate(index, y);
            let damping = match phases.structures[index].branch {
                Branch::Yielding { .. } => structure.damping - structure.elastic_damping,
                Branch::Elastic { .. } | Branch::Smooth { .. } => structure.damping,
            };
            let force = self.restoring_force(index, y) + damping * rate;
            dy[velocity(index)] = -force;
            if let Some(below) = structure.below {
                dy[velocity(index)] -= structure.ground_damping * y[velocity(index)];
                dy[velocity(below)] += force;
            }
        }
        self.bend(y, dy);
        for (index, (pair, phase)) in model.pairs.iter().zip(&phases.pairs).enumerate() {
            let mut force = 0.0;
            if phase.contact.touches() {
                let known = variable.deformation(index, position);
                let deformation = known.unwrap_or_else(|| model.deformation(index, y));
                force = self.pounding_force(index, deformation, model.rate(index, y));
                for (floor, part) in pair.ends.parts() {
                    dy[velocity(floor)] -= part * force;
                }
            }
            dy[model.impulse(index)] = force;
        }
        self.pull(y, dy);
        self.rub(y, dy);
        // Converts forces to absolute accelerations.
        for (index, structure) in model.structures.iter().enumerate() {
            let slope = &mut dy[velocity(index)];
            *slope = if model.is_wall(index) {
                segment.ground(index, y[TIME])
            } else {
                *slope * structure.inverse_mass
            };
        }
    }

    /// Derivatives of deformations and their rates, from absolute accelerations.
    fn close(&self, y: &[f64], dy: &mut [f64]) {
        for (pair, phase) in self.model.pairs.iter().zip(&self.phases.pairs) {
            let rests = matches!(phase.contact, ContactPhase::Resting { .. });
            let [rate, closing] = if rests {
                [0.0; 2]
            } else {
                let closing = pair.ends.ahead(|floor| dy[velocity(floor)]);
                [y[pair.deformation + 1], closing]
            };
            dy[pair.deformation] = rate;
            dy[pair.deformation + 1] = closing;
        }
    }

    /// Derivatives of the elastic parts of drifts with respect to time.
    fn bend(&self, y: &[f64], dy: &mut [f64]) {
        for (index, smooth) in self.model.smooth() {
            let phase = &self.phases.structures[index];
            if let Branch::Smooth { side } = phase.branch {
                let columns = &self.model.structures[index].columns;
                let direction = phase.drift_direction;
                let bend = columns.bend(smooth, y[smooth.unknown], side, direction);
                dy[smooth.unknown] = self.model.drift_rate(index, y) * bend;
            }
        }
    }

    /// Restoring force of the storey below a floor \[N\].
    pub(super) fn restoring_force(&self, structure: usize, y: &[f64]) -> f64 {
        let branch = self.phases.structures[structure].branch;
        let drift = self.model.drift(structure, y);
        self.model.structures[structure].columns.force(branch, drift, y)
    }

    /// Yielding part of the restoring force \[N\].
    pub(super) fn yielding_force(&self, structure: usize, y: &[f64]) -> f64 {
        let columns = &self.model.structures[structure].columns;
        let force = self.restoring_force(structure, y);
        columns.yielding_part(force, self.model.drift(structure, y))
    }

    /// Starts yielding of columns, unless the drift turned at this instant.
    pub(super) fn yields(&mut self, structure: usize, y: &[f64]) {
        let part = self.yielding_force(structure, y);
        let phase = &mut self.phases.structures[structure];
        if phase.drift_direction * part > 0.0 {
            let limit = self.model.structures[structure].columns.limit();
            phase.branch = Branch::Yielding {
                force: phase.drift_direction * limit,
            };
        }
    }

    /// Pounding force of a pair \[N\].
    pub(super) fn pounding_force(&self, pair: usize, deformation: f64, rate: f64) -> f64 {
        let Law::Compliant(force) = self.model.pairs[pair].law else {
            return 0.0;
        };
        let touching = self.touching(pair, deformation, rate);
        match self.phases.pairs[pair].contact {
            ContactPhase::Apart | ContactPhase::Resting { .. } | ContactPhase::Clamped => 0.0,
            ContactPhase::Approach { .. } => force.on_approach(touching),
            ContactPhase::Restitution { .. } => force.on_return(touching),
        }
    }

    fn touching(&self, pair: usize, deformation: f64, rate: f64) -> Touching {
        Touching {
            deformation,
            rate,
            bent: self.phases.pairs[pair].bent,
            approach_speed: self.phases.pairs[pair].approach_speed,
        }
    }

    /// Net pounding force on a structure \[N\], positive to the right; `slope` is the derivative of the unknowns.
    pub(super) fn push(&self, structure: usize, slope: &[f64]) -> f64 {
        let mut push = 0.0;
        for (index, pair) in self.model.pairs.iter().enumerate() {
            push -= pair.ends.part(structure) * slope[self.model.impulse(index)];
        }
        push
    }

    /// Whether neighbours touch a structure from both sides.
    pub(super) fn is_between(&self, structure: usize) -> bool {
        let from = |side: f64| {
            let mut pairs = self.model.pairs.iter().zip(&self.phases.pairs);
            pairs.any(|(pair, phase)| phase.contact.touches() && side * pair.ends.part(structure) > 0.0)
        };
        from(1.0) && from(-1.0)
    }

    /// Stores the sign of the net pounding force if both sides have begun to touch.
    pub(super) fn settle(&mut self, slope: &[f64]) {
        for index in 0..self.model.structures.len() {
            let known = self.phases.structures[index].push;
            let between = self.is_between(index);
            self.phases.structures[index].push = between.then(|| known.unwrap_or_else(|| sign(self.push(index, slope))));
        }
    }

    /// Rate of a pair's pounding force, times its deformation \[N·m/s\].
    ///
    /// `slope` is the derivative of the unknowns `y` with respect to time. After the approach the damper must act, too.
    pub(super) fn force_rate(&self, pair: usize, y: &[f64], slope: &[f64]) -> f64 {
        let Law::Compliant(force) = self.model.pairs[pair].law else {
            return 0.0;
        };
        let (deformation, rate) = (self.model.deformation(pair, y), self.model.rate(pair, y));
        let touching = self.touching(pair, deformation, rate);
        force.rate_on_approach(touching, self.model.rate(pair, slope))
    }

    /// Updates, after velocity jumps, which formulas would pull: the change would not show at the end of the next step.
    pub(super) fn grip_again(&mut self, y: &[f64]) {
        for pair in 0..self.phases.pairs.len() {
            let pulls = self.grip(pair, y) < 0.0;
            let contact = &mut self.phases.pairs[pair].contact;
            match contact {
                ContactPhase::Restitution { .. } if pulls => *contact = ContactPhase::Clamped,
                ContactPhase::Clamped if !pulls => *contact = ContactPhase::Restitution { rising: -1.0 },
                ContactPhase::Apart
                | ContactPhase::Approach { .. }
                | ContactPhase::Restitution { .. }
                | ContactPhase::Clamped
                | ContactPhase::Resting { .. } => {}
            }
        }
    }

    /// Updates, after velocity jumps, whether the forces of compliant pairs rise, and forgets the sign of net forces. `slope` is the
    /// derivative of the unknowns.
    pub(super) fn rise_again(&mut self, y: &[f64], slope: &[f64]) {
        for phase in &mut self.phases.structures {
            phase.push = None;
        }
        self.aim(y, slope);
    }

    /// Updates, after jumps of accelerations, whether the forces of compliant pairs rise. `slope` is the derivative of the unknowns.
    pub(super) fn aim(&mut self, y: &[f64], slope: &[f64]) {
        for pair in 0..self.phases.pairs.len() {
            let rate = self.force_rate(pair, y, slope);
            if let ContactPhase::Approach { rising, .. } | ContactPhase::Restitution { rising } = &mut self.phases.pairs[pair].contact
                && *rising * rate < 0.0
            {
                *rising = -*rising;
            }
        }
    }

    /// How far the deformation of a pair is from the other slope of its law \[m\]; `None` for a law of one slope.
    pub(super) fn before_bend(&self, pair: usize, y: &[f64]) -> Option<f64> {
        let Law::Compliant(force) = self.model.pairs[pair].law else {
            return None;
        };
        let left = force.bend()? - self.model.deformation(pair, y);
        Some(if self.phases.pairs[pair].bent { -left } else { left })
    }

    /// Negative if the formula of a pair would pull after the approach.
    pub(super) fn grip(&self, pair: usize, y: &[f64]) -> f64 {
        let Law::Compliant(force) = self.model.pairs[pair].law else {
            return 1.0;
        };
        let (deformation, rate) = (self.model.deformation(pair, y), self.model.rate(pair, y));
        force.grip(self.touching(pair, deformation, rate))
    }
}
