//! A structure of several scenes side by side.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::column::SideBySideColumn;
use super::number::{Lanes, Mask};
use pounding_solver::formulas::Coefficients;
use pounding_solver::formulas::first_increment;
use pounding_solver::formulas::{Dashpot, damping_force};
use pounding_solver::{Node, RestoringForce};

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
    /// Of the displacement so far \[m\].
    extremes: Extremes<S>,
}

/// Least and largest of what was met.
#[derive(Clone, Copy)]
pub(super) struct Extremes<S: Simd>([Lanes<S>; 2]);

/// What matters at nodes at which some lane touches.
pub(super) struct InContact<S: Simd> {
    /// Whether some lane touches a neighbour at the node under way, or has books of it to close.
    pub(super) is_near: bool,
    /// Pounding forces \[N\]; those of compliant pairs are renewed at every such node.
    pub(super) force_from_left: Lanes<S>,
    pub(super) force_from_right: Lanes<S>,
    /// At t = 0, and at nodes at which impulsive pairs touch.
    pub(super) at_node: AtNode<S>,
}

/// A structure at the node that a step has passed: displacement \[m\] and restoring force \[N\].
#[derive(Clone, Copy)]
pub(super) struct Passed<S: Simd> {
    pub(super) displacement: Lanes<S>,
    pub(super) restoring_force: Lanes<S>,
}

/// A structure at a node, as the step from it finds it.
#[derive(Clone, Copy)]
pub(super) struct AtNode<S: Simd> {
    /// Displacement \[m\], velocity \[m/s\] and restoring force \[N\].
    pub(super) displacement: Lanes<S>,
    pub(super) velocity: Lanes<S>,
    pub(super) restoring_force: Lanes<S>,
    /// Velocity after the jumps there \[m/s\].
    pub(super) jumped: Lanes<S>,
}

impl<S: Simd, Column: RestoringForce<Lanes<S>>> Body<S, Column> {
    /// A structure of some rows of the same shape at t = 0, from what gathers a number of it, and the drift of its storey \[m\].
    ///
    /// It does not move before it [begins](Self::begin).
    #[inline(always)]
    pub(super) fn new<Single: SideBySideColumn<Beside<Lanes<S>> = Column>>(
        gather: impl Fn(&dyn Fn(&Node<Single>) -> f64) -> Lanes<S>,
        drift: Lanes<S>,
        dt: f64,
    ) -> Self {
        let inverse_mass = gather(&|node| node.inverse_mass);
        let damping = gather(&|node| node.damping);
        let mobile = gather(&|node| node.mobile());
        let displacement = gather(&|node| node.initial_displacement);
        let velocity = gather(&|node| node.initial_velocity);
        let column = Single::beside(|number| gather(&|node| number(&node.column)));
        let loaded = column.loaded(drift);
        let zero = damping.like(0.0);
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
                increment: zero,
                earlier: zero,
                memory: loaded.memory,
                extremes: Extremes::of(displacement),
            },
            contact: InContact {
                is_near: false,
                force_from_left: zero,
                force_from_right: zero,
                at_node: AtNode {
                    displacement,
                    velocity,
                    restoring_force: loaded.force,
                    jumped: velocity,
                },
            },
        }
    }

    /// Begins a run from the acceleration in equilibrium \[m/s²\].
    #[inline(always)]
    pub(super) fn begin(&mut self, acceleration: Lanes<S>) {
        let time_step = self.constants.coefficients.time_step;
        let increment = first_increment([self.contact.at_node.velocity, acceleration], time_step);
        self.motion.increment = increment;
        self.motion.earlier = increment;
    }

    /// The step from a node at which no lane touches a neighbour.
    #[inline(always)]
    pub(super) fn step(&mut self, ground: Lanes<S>) {
        let apart = ground.like(0.0);
        self.constants.step(&mut self.motion, apart, ground);
    }

    /// The step from a node at which some lane touches; `jumps` keeps what velocity jumps begin from.
    #[inline(always)]
    pub(super) fn step_in_contact(&mut self, ground: Lanes<S>, jumps: bool) {
        let pounding = self.contact.pounding();
        let passed = self.constants.step(&mut self.motion, pounding, ground);
        self.contact.is_near = false;
        if jumps {
            self.contact.at_node.displacement = passed.displacement;
            self.contact.at_node.restoring_force = passed.restoring_force;
            self.contact.at_node.velocity = self.velocity_before();
        }
    }

    /// Velocity at the node before \[m/s\].
    #[inline(always)]
    pub(super) fn velocity_before(&self) -> Lanes<S> {
        self.constants.velocity_before(&self.motion)
    }

    /// Its dashpot after the velocity jumps of a node.
    #[inline(always)]
    pub(super) fn dashpot(&self) -> Dashpot<Lanes<S>> {
        self.constants.dashpot(&self.contact.at_node)
    }

    /// Acceleration of a structure of one storey in equilibrium after the velocity jumps of a node \[m/s²\].
    #[inline(always)]
    pub(super) fn acceleration(&self, ground: Lanes<S>) -> Lanes<S> {
        let pounding = self.contact.pounding();
        self.constants.acceleration(&self.contact.at_node, pounding, ground)
    }

    /// Lets the next displacement follow from the velocity and the acceleration \[m/s²\] after a jump, in these lanes.
    #[inline(always)]
    pub(super) fn restart(&mut self, acceleration: Lanes<S>, lanes: Mask<S>) {
        let node = &self.contact.at_node;
        self.constants.restart(&mut self.motion, node, acceleration, lanes);
    }
}

impl<S: Simd> InContact<S> {
    /// Net pounding force \[N\].
    #[inline(always)]
    pub(super) fn pounding(&self) -> Lanes<S> {
        self.force_from_left + self.force_from_right
    }
}

impl<S: Simd> AtNode<S> {
    /// Where the velocity has jumped.
    #[inline(always)]
    pub(super) fn jumps(&self) -> Mask<S> {
        self.jumped.differs(self.velocity)
    }
}

impl<S: Simd, Column: RestoringForce<Lanes<S>>> Constants<S, Column> {
    /// Force of the columns at a drift \[m\], which they remember \[N\].
    #[inline(always)]
    pub(super) fn respond(&self, motion: &mut Motion<S, Column::Memory>, drift: Lanes<S>) -> Lanes<S> {
        let response = self.column.respond(drift, motion.memory);
        motion.memory = response.memory;
        response.force
    }

    /// Velocity at the node before that of a motion \[m/s\].
    #[inline(always)]
    pub(super) fn velocity_before(&self, motion: &Motion<S, Column::Memory>) -> Lanes<S> {
        let Motion { earlier, increment, .. } = *motion;
        self.coefficients.velocity([earlier, increment])
    }

    /// The dashpot after the velocity jumps of a node.
    #[inline(always)]
    fn dashpot(&self, node: &AtNode<S>) -> Dashpot<Lanes<S>> {
        Dashpot {
            damping: self.damping,
            velocity: node.jumped,
        }
    }

    /// Acceleration of a structure of one storey in equilibrium after the velocity jumps of a node \[m/s²\], with a pounding force \[N\].
    #[inline(always)]
    pub(super) fn acceleration(&self, node: &AtNode<S>, pounding: Lanes<S>, ground: Lanes<S>) -> Lanes<S> {
        let pounding = pounding - damping_force(self.dashpot(node), None, None);
        let felt = self.coefficients.mobile * ground;
        self.coefficients.smooth((pounding, node.restoring_force), felt)
    }

    /// Lets the next displacement follow from the velocity and the acceleration \[m/s²\] after a jump at a node, in these lanes.
    #[inline(always)]
    pub(super) fn restart(&self, motion: &mut Motion<S, Column::Memory>, node: &AtNode<S>, acceleration: Lanes<S>, lanes: Mask<S>) {
        let time_step = self.coefficients.time_step;
        let increment = Coefficients::restarted(time_step, node.jumped, acceleration);
        let displacement = node.displacement + increment;
        motion.increment = Number::select(lanes, increment, motion.increment);
        motion.displacement = Number::select(lanes, displacement, motion.displacement);
    }

    /// The step of a structure of one storey from a node with this net pounding force \[N\], which it passes.
    #[inline(always)]
    pub(super) fn step(&self, motion: &mut Motion<S, Column::Memory>, pounding: Lanes<S>, ground: Lanes<S>) -> Passed<S> {
        let displacement = motion.displacement;
        let restoring_force = self.respond(motion, displacement);
        let smooth = self.coefficients.smooth((pounding, restoring_force), ground);
        motion.go_on(self.coefficients.next(smooth, motion.increment));
        Passed {
            displacement,
            restoring_force,
        }
    }
}

impl<S: Simd, Memory> Motion<S, Memory> {
    /// Displacement of the largest magnitude so far in a lane \[m\].
    #[inline(always)]
    pub(super) fn peak(&self, lane: usize) -> Option<f64> {
        self.extremes.peak(self.displacement, lane)
    }

    /// Holds what will be part of the next increment \[m\], in place of the one before the last, which no step needs.
    #[inline(always)]
    pub(super) fn hold(&mut self, increment: Lanes<S>) {
        self.earlier = increment;
    }

    /// What it holds \[m\].
    #[inline(always)]
    pub(super) fn held(&self) -> Lanes<S> {
        self.earlier
    }

    /// Goes on by the next increment \[m\].
    #[inline(always)]
    pub(super) fn go_on(&mut self, increment: Lanes<S>) {
        self.extremes = self.extremes.with(self.displacement);
        self.earlier = self.increment;
        self.increment = increment;
        self.displacement = self.displacement + self.increment;
    }
}

impl<S: Simd> Extremes<S> {
    /// Those of one value.
    #[inline(always)]
    pub(super) fn of(value: Lanes<S>) -> Self {
        Self([value; 2])
    }

    /// Those of none.
    #[inline(always)]
    pub(super) fn none(simd: S) -> Self {
        Self([f64::INFINITY, f64::NEG_INFINITY].map(|value| Lanes::splat(simd, value)))
    }

    /// Those of all that was met, and of a value.
    #[inline(always)]
    pub(super) fn with(self, value: Lanes<S>) -> Self {
        let [least, largest] = self.0;
        Self([least.min(value), largest.max(value)])
    }

    /// That of the largest magnitude in a lane; nothing where it is one to the left and one to the right, and where the last value
    /// is no longer finite.
    #[inline(always)]
    pub(super) fn peak(&self, last: Lanes<S>, lane: usize) -> Option<f64> {
        let [least, largest] = self.0.map(|extreme| extreme.lane(lane));
        let differ = (-least).total_cmp(&largest).is_ne();
        let known = differ && last.lane(lane).is_finite();
        known.then_some(if -least > largest { least } else { largest })
    }
}
