//! A structure of several scenes side by side.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::column::SideBySideColumn;
use super::number::Lanes;
use crate::explicit::central_difference::coefficients::Coefficients;
use crate::explicit::central_difference::first_increment;
use crate::{Node, RestoringForce};

/// A structure: what does not change, and what does from step to step.
pub(super) struct Body<S: Simd, Column: RestoringForce<Lanes<S>>> {
    pub(super) constants: Constants<S, Column>,
    pub(super) motion: Motion<S, Column::Memory>,
    pub(super) contact: InContact<S>,
}

/// What does not change.
pub(super) struct Constants<S: Simd, Column> {
    pub(super) coefficients: Coefficients<Lanes<S>>,
    column: Column,
    /// Damping coefficient c \[N·s/m\].
    damping: Lanes<S>,
}

/// What a structure carries from step to step.
#[derive(Clone, Copy)]
pub(super) struct Motion<S: Simd, Memory> {
    /// Displacement at the node that comes next \[m\].
    pub(super) displacement: Lanes<S>,
    /// What it is more than at the node before, and what it was more there than at the one before that.
    pub(super) increment: Lanes<S>,
    earlier: Lanes<S>,
    memory: Memory,
    /// Least and largest displacement so far \[m\].
    extremes: [Lanes<S>; 2],
}

/// What matters at nodes at which some lane touches.
pub(super) struct InContact<S: Simd> {
    /// Whether some lane touches a neighbour at the node under way, or has books of it to close.
    pub(super) is_near: bool,
    /// Pounding forces \[N\]; those of compliant pairs are renewed at every such node.
    pub(super) force_from_left: Lanes<S>,
    pub(super) force_from_right: Lanes<S>,
    /// Displacement \[m\], velocity \[m/s\] and restoring force \[N\] where impulsive pairs touch.
    displacement: Lanes<S>,
    pub(super) velocity: Lanes<S>,
    restoring_force: Lanes<S>,
    /// Velocity after the jumps there \[m/s\].
    pub(super) jumped: Lanes<S>,
}

impl<S: Simd, Column: RestoringForce<Lanes<S>>> Body<S, Column> {
    /// A structure of some rows of the same shape at the first node to be solved, from what gathers a number of it.
    #[inline(always)]
    pub(super) fn new<Single: SideBySideColumn<Beside<Lanes<S>> = Column>>(
        gather: impl Fn(&dyn Fn(&Node<Single>) -> f64) -> Lanes<S>,
        (dt, ground): (f64, f64),
    ) -> Self {
        let inverse_mass = gather(&|node| node.inverse_mass);
        let damping = gather(&|node| node.damping);
        let mobile = gather(&|node| node.mobile());
        let column = Single::beside(|number| gather(&|node| number(&node.column)));
        let displacement = gather(&|node| node.initial_displacement);
        let velocity = gather(&|node| node.initial_velocity);
        let response = column.loaded(displacement);
        let zero = damping.like(0.0);
        let force = zero - damping * velocity - response.force;
        let acceleration = inverse_mass * force - mobile * damping.like(ground);
        let increment = first_increment([velocity, acceleration], dt);
        let mut coefficients = Coefficients::of(inverse_mass, damping, mobile, dt);
        // A wall stays where it is, whatever the acceleration: one multiplication less in every step.
        coefficients.solve = mobile * coefficients.solve;
        Self {
            constants: Constants {
                coefficients,
                column,
                damping,
            },
            motion: Motion {
                displacement,
                increment,
                earlier: increment,
                memory: response.memory,
                extremes: [displacement; 2],
            },
            contact: InContact {
                is_near: false,
                force_from_left: zero,
                force_from_right: zero,
                displacement: zero,
                velocity,
                restoring_force: zero,
                jumped: zero,
            },
        }
    }

    /// The step from a node at which no lane touches a neighbour.
    #[inline(always)]
    pub(super) fn step(&mut self, ground: Lanes<S>) {
        self.constants.step(&mut self.motion, ground);
    }

    /// The step from a node at which some lane touches; `jumps` keeps what velocity jumps begin from.
    #[inline(always)]
    pub(super) fn step_in_contact(&mut self, ground: Lanes<S>, jumps: bool) {
        let Constants {
            coefficients,
            column,
            ..
        } = &self.constants;
        let (motion, contact) = (&mut self.motion, &mut self.contact);
        let response = column.respond(motion.displacement, motion.memory);
        let pounding = contact.force_from_left + contact.force_from_right;
        let smooth = coefficients.smooth((pounding, response.force), ground);
        let (displacement, increment) = (motion.displacement, motion.increment);
        contact.is_near = false;
        motion.go_on(coefficients, smooth);
        motion.memory = response.memory;
        if jumps {
            contact.displacement = displacement;
            contact.restoring_force = response.force;
            contact.velocity = coefficients.velocity([increment, motion.increment]);
        }
    }

    /// Velocity at the node before \[m/s\].
    #[inline(always)]
    pub(super) fn velocity_before(&self) -> Lanes<S> {
        let Motion {
            earlier, increment, ..
        } = self.motion;
        self.constants.coefficients.velocity([earlier, increment])
    }

    /// Lets the next displacement follow from the velocity after a jump, where there was one.
    #[inline(always)]
    pub(super) fn restart(&mut self, ground: Lanes<S>) {
        let (contact, coefficients) = (&self.contact, &self.constants.coefficients);
        let jumped = contact.jumped.differs(contact.velocity);
        let pounding = contact.force_from_left + contact.force_from_right;
        let damping = self.constants.damping * contact.jumped;
        let force = pounding - damping - contact.restoring_force;
        let acceleration = coefficients.inverse_mass * force - ground;
        let time_step = coefficients.time_step;
        let increment = Coefficients::restarted(time_step, contact.jumped, acceleration);
        let displacement = contact.displacement + increment;
        let motion = &mut self.motion;
        motion.increment = Number::select(jumped, increment, motion.increment);
        motion.displacement = Number::select(jumped, displacement, motion.displacement);
    }
}

impl<S: Simd, Column: RestoringForce<Lanes<S>>> Constants<S, Column> {
    /// The step from a node without contact in any lane.
    #[inline(always)]
    pub(super) fn step(&self, motion: &mut Motion<S, Column::Memory>, ground: Lanes<S>) {
        let response = self.column.respond(motion.displacement, motion.memory);
        let forces = (ground.like(0.0), response.force);
        motion.go_on(&self.coefficients, self.coefficients.smooth(forces, ground));
        motion.memory = response.memory;
    }
}

impl<S: Simd, Memory> Motion<S, Memory> {
    /// Displacement of the largest magnitude so far in a lane \[m\].
    #[inline(always)]
    pub(super) fn peak(&self, lane: usize) -> Option<f64> {
        peak(self.extremes, self.displacement, lane)
    }

    /// The next displacement under an acceleration but for damping \[m/s²\].
    #[inline(always)]
    fn go_on(&mut self, coefficients: &Coefficients<Lanes<S>>, load: Lanes<S>) {
        let [least, largest] = self.extremes;
        self.extremes = [least.min(self.displacement), largest.max(self.displacement)];
        self.earlier = self.increment;
        self.increment = coefficients.next(load, self.increment);
        self.displacement = self.displacement + self.increment;
    }
}

/// Displacement of the largest magnitude in a lane \[m\], of the least and the largest; nothing where it is one to the left and one to
/// the right, and where the last displacement is no longer finite.
#[inline(always)]
pub(super) fn peak<S: Simd>(extremes: [Lanes<S>; 2], last: Lanes<S>, lane: usize) -> Option<f64> {
    let [least, largest] = [extremes[0].lane(lane), extremes[1].lane(lane)];
    let differ = (-least).total_cmp(&largest).is_ne();
    let known = differ && last.lane(lane).is_finite();
    known.then_some(if -least > largest { least } else { largest })
}
