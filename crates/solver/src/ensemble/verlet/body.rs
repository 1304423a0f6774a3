//! A structure of several scenes side by side, as the velocity Verlet method moves it.

use fearless_simd::Simd;
use pounding_contact::Number;

use crate::RestoringForce;
use crate::ensemble::body::Extremes;
use crate::ensemble::column::{MemoryOf, SideBySideColumn};
use crate::ensemble::number::{Lanes, Mask};
use crate::ensemble::rows::Rows;
use crate::explicit::verlet::formulas::Length;

/// What does not change of a structure.
pub(super) struct Constants<S: Simd, Column: SideBySideColumn> {
    pub(super) inverse_mass: Lanes<S>,
    /// c \[N·s/m\].
    damping: Lanes<S>,
    /// 1 for a structure, 0 for a wall, which does not feel the ground.
    mobile: Lanes<S>,
    column: Column::Beside<Lanes<S>>,
    /// A whole step.
    pub(super) step: Length<Lanes<S>>,
}

/// What a structure carries from step to step.
#[derive(Clone, Copy)]
pub(super) struct Motion<S: Simd, Column: SideBySideColumn> {
    /// Displacement \[m\], velocity \[m/s\] and acceleration \[m/s²\].
    pub(super) displacement: Lanes<S>,
    pub(super) velocity: Lanes<S>,
    pub(super) acceleration: Lanes<S>,
    restoring_force: Lanes<S>,
    memory: MemoryOf<Lanes<S>, Column>,
    /// Of the displacement so far \[m\].
    extremes: Extremes<S>,
}

/// Pounding force at the end of a span: its part of the impulse \[N·s\], and itself \[N\].
#[derive(Clone, Copy)]
pub(super) struct Push<S: Simd> {
    pub(super) impulse: Lanes<S>,
    pub(super) force: Lanes<S>,
}

impl<S: Simd, Column: SideBySideColumn> Constants<S, Column> {
    /// A structure of some rows, and its motion at t = 0, where the ground has this acceleration \[m/s²\].
    #[inline(always)]
    pub(super) fn new(
        (simd, rows, node): (S, Rows<'_, Column>, usize),
        (time_step, ground): (f64, Lanes<S>),
    ) -> (Self, Motion<S, Column>) {
        let inverse_mass = rows.gather(simd, node, &|node| node.inverse_mass);
        let damping = rows.gather(simd, node, &|node| node.damping);
        let mobile = rows.gather(simd, node, &|node| node.mobile());
        let displacement = rows.gather(simd, node, &|node| node.initial_displacement);
        let velocity = rows.gather(simd, node, &|node| node.initial_velocity);
        let column = Column::beside(|number| rows.gather(simd, node, &|node| number(&node.column)));
        let response = column.loaded(displacement);
        let constants = Self {
            inverse_mass,
            damping,
            mobile,
            column,
            step: Length::new(damping.like(time_step), inverse_mass * damping),
        };
        let mut motion = Motion {
            displacement,
            velocity,
            acceleration: displacement,
            restoring_force: response.force,
            memory: response.memory,
            extremes: Extremes::of(displacement),
        };
        motion.acceleration = constants.acceleration(&motion, damping.like(0.0), ground);
        (constants, motion)
    }

    /// A span of this length \[s\].
    #[inline(always)]
    pub(super) fn span(&self, length: Lanes<S>) -> Length<Lanes<S>> {
        Length::new(length, self.inverse_mass * self.damping)
    }

    /// Acceleration in equilibrium \[m/s²\] with a pounding force \[N\].
    #[inline(always)]
    fn acceleration(
        &self,
        motion: &Motion<S, Column>,
        pounding: Lanes<S>,
        ground: Lanes<S>,
    ) -> Lanes<S> {
        let force = pounding - self.damping * motion.velocity - motion.restoring_force;
        self.inverse_mass * force - self.mobile * ground
    }

    /// The state at the end of a step in which nothing touches.
    #[inline(always)]
    pub(super) fn finish(
        &self,
        motion: &mut Motion<S, Column>,
        [displacement, half_way]: [Lanes<S>; 2],
        ground: Lanes<S>,
    ) {
        let response = self.column.respond(displacement, motion.memory);
        let felt = self.mobile * ground;
        let smooth = -(self.inverse_mass * response.force) - felt;
        let velocity = self.step.free_velocity(half_way, smooth);
        let force = -(self.damping * velocity) - response.force;
        *motion = Motion {
            displacement,
            velocity,
            acceleration: self.inverse_mass * force - felt,
            restoring_force: response.force,
            memory: response.memory,
            extremes: motion.extremes.with(displacement),
        };
    }

    /// The state at the end of a span, in the lanes that go to it, with the pounding force there.
    #[inline(always)]
    pub(super) fn finish_span(
        &self,
        motion: &mut Motion<S, Column>,
        length: &Length<Lanes<S>>,
        goes: Mask<S>,
        push: Push<S>,
        ground: Lanes<S>,
    ) {
        let before = *motion;
        let [displacement, half_way] = length.predict(before.kinematics());
        let response = self.column.respond(displacement, before.memory);
        let smooth = -(self.inverse_mass * response.force) - self.mobile * ground;
        let pushed = self.inverse_mass * push.impulse;
        let mut after = Motion {
            displacement,
            velocity: length.velocity(half_way, smooth, pushed),
            acceleration: before.acceleration,
            restoring_force: response.force,
            memory: response.memory,
            extremes: before.extremes.with(displacement),
        };
        after.acceleration = self.acceleration(&after, push.force, ground);
        *motion = after.or(before, goes);
    }

    /// Takes a velocity after an impact \[m/s\]; the acceleration follows it where it is another one.
    #[inline(always)]
    pub(super) fn jump(
        &self,
        motion: &mut Motion<S, Column>,
        velocity: Lanes<S>,
        ground: Lanes<S>,
    ) {
        let jumped = velocity.differs(motion.velocity);
        motion.velocity = velocity;
        let follows = self.acceleration(motion, ground.like(0.0), ground);
        motion.acceleration = Number::select(jumped, follows, motion.acceleration);
    }
}

impl<S: Simd, Column: SideBySideColumn> Motion<S, Column> {
    /// Displacement, velocity and acceleration.
    #[inline(always)]
    pub(super) fn kinematics(&self) -> [Lanes<S>; 3] {
        [self.displacement, self.velocity, self.acceleration]
    }

    /// Displacement of the largest magnitude so far in a lane \[m\], where lanes know it.
    #[inline(always)]
    pub(super) fn peak(&self, lane: usize) -> Option<f64> {
        self.extremes.peak(self.displacement, lane)
    }

    /// This one where the mask says so, else the other.
    #[inline(always)]
    fn or(self, other: Self, these: Mask<S>) -> Self {
        let select = |this, other| Number::select(these, this, other);
        Self {
            displacement: select(self.displacement, other.displacement),
            velocity: select(self.velocity, other.velocity),
            acceleration: select(self.acceleration, other.acceleration),
            restoring_force: select(self.restoring_force, other.restoring_force),
            memory: Column::select::<Lanes<S>>(these, self.memory, other.memory),
            extremes: self.extremes.or(other.extremes, these),
        }
    }
}
