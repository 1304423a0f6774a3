//! A structure of several scenes in lanes.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::column::SideBySideColumn;
use super::number::{Lanes, Mask};
use pounding_solver::formulas::Coefficients;
use pounding_solver::formulas::{Dashpot, damping_force};
use pounding_solver::formulas::{first_increment, increment_before};
use pounding_solver::{Node, RestoringForce};

/// A structure: its constants, and its state from step to step.
pub(super) struct Body<S: Simd, Column: RestoringForce<Lanes<S>>> {
    pub(super) constants: Constants<S, Column>,
    pub(super) motion: LaneMotion<S, Column::Memory>,
    pub(super) contact: InContact<S>,
}

/// Constants of a structure.
pub(super) struct Constants<S: Simd, Column> {
    pub(super) coefficients: Coefficients<Lanes<S>>,
    column: Column,
    /// Damping coefficient c \[N·s/m\].
    damping: Lanes<S>,
}

/// State of a structure from step to step.
#[derive(Clone, Copy)]
pub(super) struct LaneMotion<S: Simd, Memory> {
    /// Displacement at the next node \[m\].
    pub(super) displacement: Lanes<S>,
    /// Increment of the displacement since the node before, and the increment before that \[m\].
    pub(super) increment: Lanes<S>,
    earlier: Lanes<S>,
    memory: Memory,
    /// Extremes of the displacement so far \[m\].
    extremes: Extremes<S>,
}

/// Smallest and largest value so far.
#[derive(Clone, Copy)]
pub(super) struct Extremes<S: Simd>([Lanes<S>; 2]);

/// Data for nodes at which some lane touches.
pub(super) struct InContact<S: Simd> {
    /// Whether some lane touches a neighbour at the present node, or must close the books of a touch.
    pub(super) is_near: bool,
    /// Pounding forces \[N\]. Those of compliant pairs are updated at every such node.
    pub(super) force_from_left: Lanes<S>,
    pub(super) force_from_right: Lanes<S>,
    /// Net force of links \[N\], updated at every node, and lanes in which it has jumped with velocities at this node.
    pub(super) link_force: Lanes<S>,
    pub(super) relinked: Mask<S>,
    /// The state at t = 0, and at nodes at which impulsive pairs touch.
    pub(super) at_node: AtNode<S>,
}

/// A structure at the node that a step has passed: displacement \[m\] and restoring force \[N\].
#[derive(Clone, Copy)]
pub(super) struct Passed<S: Simd> {
    pub(super) displacement: Lanes<S>,
    pub(super) restoring_force: Lanes<S>,
}

/// A structure at a node, at the start of the next step.
#[derive(Clone, Copy)]
pub(super) struct AtNode<S: Simd> {
    /// Displacement \[m\], velocity \[m/s\] and restoring force \[N\].
    pub(super) displacement: Lanes<S>,
    pub(super) velocity: Lanes<S>,
    pub(super) restoring_force: Lanes<S>,
    /// Velocity after the jumps at the node \[m/s\].
    pub(super) jumped: Lanes<S>,
}

impl<S: Simd, Column: RestoringForce<Lanes<S>>> Body<S, Column> {
    /// A structure of rows of a common shape at t = 0, and the drift of its storey \[m\]. `gather` collects a number from each row.
    ///
    /// The structure does not move before [`begin`](Self::begin).
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
        // A wall never moves, whatever the acceleration. This saves a multiplication in every step.
        coefficients.solve = mobile * coefficients.solve;
        Self {
            constants: Constants {
                coefficients,
                column,
                damping,
            },
            motion: LaneMotion {
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
                link_force: zero,
                relinked: zero.exceeds(zero),
                at_node: AtNode {
                    displacement,
                    velocity,
                    restoring_force: loaded.force,
                    jumped: velocity,
                },
            },
        }
    }

    /// Begins a run with the acceleration in equilibrium \[m/s²\].
    #[inline(always)]
    pub(super) fn begin(&mut self, acceleration: Lanes<S>) {
        let time_step = self.constants.coefficients.time_step;
        let increment = first_increment([self.contact.at_node.velocity, acceleration], time_step);
        self.motion.increment = increment;
        self.motion.earlier = increment_before(increment, acceleration, time_step);
    }

    /// The step from a node at which no lane touches a neighbour.
    #[inline(always)]
    pub(super) fn step(&mut self, ground: Lanes<S>) {
        let apart = ground.like(0.0);
        self.constants.step(&mut self.motion, apart, ground);
    }

    /// The step from a node at which some lane touches. `jumps` keeps the state from which velocity jumps start.
    #[inline(always)]
    pub(super) fn step_in_contact(&mut self, ground: Lanes<S>, jumps: bool) {
        let pounding = self.contact.pounding();
        let passed = self.constants.step(&mut self.motion, pounding, ground);
        self.contact.is_near = false;
        if jumps {
            self.contact.at_node.displacement = passed.displacement;
            self.contact.at_node.restoring_force = passed.restoring_force;
            let velocity = self.velocity_before();
            self.contact.at_node.velocity = velocity;
            self.contact.at_node.jumped = velocity;
        }
    }

    /// Velocity at the node before \[m/s\].
    #[inline(always)]
    pub(super) fn velocity_before(&self) -> Lanes<S> {
        self.constants.velocity_before(&self.motion)
    }

    /// Its dashpot after the velocity jumps at a node.
    #[inline(always)]
    pub(super) fn dashpot(&self) -> Dashpot<Lanes<S>> {
        self.constants.dashpot(&self.contact.at_node)
    }

    /// Acceleration of a structure of one storey in equilibrium after the velocity jumps at a node \[m/s²\].
    #[inline(always)]
    pub(super) fn acceleration(&self, ground: Lanes<S>) -> Lanes<S> {
        let pounding = self.contact.pounding();
        self.constants.acceleration(&self.contact.at_node, pounding, ground)
    }

    /// Sets the next displacement from the velocity and the acceleration \[m/s²\] after a jump, in these lanes.
    #[inline(always)]
    pub(super) fn restart(&mut self, acceleration: Lanes<S>, lanes: Mask<S>) {
        let node = &self.contact.at_node;
        self.constants.restart(&mut self.motion, node, acceleration, lanes);
    }
}

impl<S: Simd> InContact<S> {
    /// Takes part in the contact of this node. Forces of the node before are forgotten; those of structures that do not take part are 0, because
    /// pairs take part until their force is.
    #[inline(always)]
    pub(super) fn come_near(&mut self) {
        if !self.is_near {
            let zero = self.force_from_left.like(0.0);
            (self.force_from_left, self.force_from_right, self.is_near) = (zero, zero, true);
        }
    }

    /// Net force of neighbours and links \[N\].
    #[inline(always)]
    pub(super) fn pounding(&self) -> Lanes<S> {
        self.force_from_left + self.force_from_right + self.link_force
    }

    /// Lanes in which the velocity or the force of a link has jumped.
    #[inline(always)]
    pub(super) fn restarts(&self) -> Mask<S> {
        self.at_node.jumps() | self.relinked
    }
}

impl<S: Simd> AtNode<S> {
    /// Lanes in which the velocity has jumped.
    #[inline(always)]
    pub(super) fn jumps(&self) -> Mask<S> {
        self.jumped.differs(self.velocity)
    }
}

impl<S: Simd, Column: RestoringForce<Lanes<S>>> Constants<S, Column> {
    /// Force of the columns at a drift \[m\]; the columns remember it \[N\].
    #[inline(always)]
    pub(super) fn respond(&self, motion: &mut LaneMotion<S, Column::Memory>, drift: Lanes<S>) -> Lanes<S> {
        let response = self.column.respond(drift, motion.memory);
        motion.memory = response.memory;
        response.force
    }

    /// Velocity of a motion at the node before \[m/s\].
    #[inline(always)]
    pub(super) fn velocity_before(&self, motion: &LaneMotion<S, Column::Memory>) -> Lanes<S> {
        let LaneMotion { earlier, increment, .. } = *motion;
        self.coefficients.velocity([earlier, increment])
    }

    /// The dashpot after the velocity jumps at a node.
    #[inline(always)]
    fn dashpot(&self, node: &AtNode<S>) -> Dashpot<Lanes<S>> {
        Dashpot {
            damping: self.damping,
            velocity: node.jumped,
        }
    }

    /// Acceleration of a structure of one storey in equilibrium after the velocity jumps at a node \[m/s²\], with a pounding force \[N\].
    #[inline(always)]
    pub(super) fn acceleration(&self, node: &AtNode<S>, pounding: Lanes<S>, ground: Lanes<S>) -> Lanes<S> {
        let pounding = pounding - damping_force(self.dashpot(node), None, None);
        let felt = self.coefficients.mobile * ground;
        self.coefficients.smooth(pounding, node.restoring_force, felt)
    }

    /// Sets the next displacement from the velocity and the acceleration \[m/s²\] after a jump at a node, in these lanes.
    #[inline(always)]
    pub(super) fn restart(&self, motion: &mut LaneMotion<S, Column::Memory>, node: &AtNode<S>, acceleration: Lanes<S>, lanes: Mask<S>) {
        let time_step = self.coefficients.time_step;
        let increment = Coefficients::restarted(time_step, node.jumped, acceleration);
        let displacement = node.displacement + increment;
        motion.increment = Number::select(lanes, increment, motion.increment);
        let earlier = first_increment([node.jumped, acceleration], time_step);
        motion.earlier = Number::select(lanes, earlier, motion.earlier);
        motion.displacement = Number::select(lanes, displacement, motion.displacement);
    }

    /// The step of a structure of one storey from a node with this net pounding force \[N\]; returns the passed node.
    #[inline(always)]
    pub(super) fn step(&self, motion: &mut LaneMotion<S, Column::Memory>, pounding: Lanes<S>, ground: Lanes<S>) -> Passed<S> {
        let displacement = motion.displacement;
        let restoring_force = self.respond(motion, displacement);
        let smooth = self.coefficients.smooth(pounding, restoring_force, ground);
        motion.go_on(self.coefficients.next(smooth, motion.increment));
        Passed {
            displacement,
            restoring_force,
        }
    }
}

impl<S: Simd, Memory> LaneMotion<S, Memory> {
    /// Displacement of the largest magnitude so far in a lane \[m\].
    #[inline(always)]
    pub(super) fn peak(&self, lane: usize) -> Option<f64> {
        self.extremes.peak(self.displacement, lane)
    }

    /// The increment before the last one, and the last one \[m\].
    #[inline(always)]
    pub(super) fn increments(&self) -> [Lanes<S>; 2] {
        [self.earlier, self.increment]
    }

    /// Stores a part of the next increment \[m\], in place of the second-last increment, which no step needs any more.
    #[inline(always)]
    pub(super) fn hold(&mut self, increment: Lanes<S>) {
        self.earlier = increment;
    }

    /// The stored part of the next increment \[m\].
    #[inline(always)]
    pub(super) fn held(&self) -> Lanes<S> {
        self.earlier
    }

    /// Moves by the next increment \[m\].
    #[inline(always)]
    pub(super) fn go_on(&mut self, increment: Lanes<S>) {
        self.extremes = self.extremes.with(self.displacement);
        self.earlier = self.increment;
        self.increment = increment;
        self.displacement = self.displacement + self.increment;
    }
}

impl<S: Simd> Extremes<S> {
    /// Extremes of a single value.
    #[inline(always)]
    pub(super) fn of(value: Lanes<S>) -> Self {
        Self([value; 2])
    }

    /// Extremes of no value.
    #[inline(always)]
    pub(super) fn none(simd: S) -> Self {
        Self([f64::INFINITY, f64::NEG_INFINITY].map(|value| Lanes::splat(simd, value)))
    }

    /// Extremes that include another value.
    #[inline(always)]
    pub(super) fn with(self, value: Lanes<S>) -> Self {
        let [least, largest] = self.0;
        Self([least.min(value), largest.max(value)])
    }

    /// The value of largest magnitude in a lane. `None` if it is reached on both sides, or if the last value is not finite.
    #[inline(always)]
    pub(super) fn peak(&self, last: Lanes<S>, lane: usize) -> Option<f64> {
        let [least, largest] = self.0.map(|extreme| extreme.lane(lane));
        let differ = (-least).total_cmp(&largest).is_ne();
        let known = differ && last.lane(lane).is_finite();
        known.then_some(if -least > largest { least } else { largest })
    }
}
