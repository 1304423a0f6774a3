//! Drifts and forces of the floors of a row.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

use crate::model::ground::Ground;
use crate::span::{Load, StoreyForces};
use crate::{Floor, Motion, Node, RestoringForce, Row, State, Support};

/// The dashpot of a storey below a floor.
#[derive(Debug, Clone, Copy)]
pub struct Dashpot<N> {
    /// Its coefficient \[N·s/m\].
    pub damping: N,
    /// Velocity of the floor \[m/s\].
    pub velocity: N,
}

/// Properties of the floor below, for a floor that stands on another floor.
#[derive(Debug, Clone, Copy)]
pub struct Below<N> {
    /// Damping coefficient of the floor against the ground \[N·s/m\], in addition to that of its storey.
    pub ground_damping: N,
    /// Velocity of the floor below \[m/s\].
    pub velocity: N,
}

/// Damping force \[N\] against the motion of a floor, from its storey and the storey above, for a single scene or for several scenes in
/// lanes.
#[inline(always)]
pub fn damping_force<N: Number>(floor: Dashpot<N>, below: Option<Below<N>>, above: Option<Dashpot<N>>) -> N {
    let Dashpot { damping, velocity } = floor;
    let own = match below {
        None => damping * velocity,
        Some(below) => damping * (velocity - below.velocity) + below.ground_damping * velocity,
    };
    match above {
        None => own,
        Some(above) => own - above.damping * (above.velocity - velocity),
    }
}

impl<Column: RestoringForce> Row<Column> {
    /// Whether a node is a structure of one storey, or a wall: it stands on the ground and carries nothing.
    #[inline]
    pub fn stands_alone(&self, node: usize) -> bool {
        matches!(self.nodes()[node].support, Support::Ground) && self.above(node).is_none()
    }

    /// Drift of the storey below a node \[m\]: its displacement relative to its support.
    #[inline]
    pub(crate) fn drift(&self, node: usize, states: &[State]) -> f64 {
        match self.nodes()[node].support.below() {
            None => states[node].displacement,
            Some(below) => states[node].displacement - states[below].displacement,
        }
    }

    /// Damping force \[N\] against the motion of a node, from its storey and the storey above, at these velocities.
    #[inline]
    pub(crate) fn damping_force(&self, node: usize, states: &[State]) -> f64 {
        let velocity = |index: usize| states[index].velocity;
        self.damping_at(node, velocity)
    }

    /// Damping force \[N\] against the motion of a node, at given velocities \[m/s\].
    #[inline]
    pub(crate) fn damping_at(&self, node: usize, velocity: impl Fn(usize) -> f64) -> f64 {
        let dashpot = |index: usize| Dashpot {
            damping: self.nodes()[index].damping,
            velocity: velocity(index),
        };
        let below = match self.nodes()[node].support {
            Support::Ground => None,
            Support::Floor(Floor { below, ground_damping }) => Some(Below {
                ground_damping,
                velocity: velocity(below),
            }),
        };
        damping_force(dashpot(node), below, self.above(node).map(dashpot))
    }

    /// Restoring force \[N\] against a displacement of a node to the right, from its storey and the storey above.
    #[inline]
    pub(crate) fn restoring_force(&self, node: usize, states: &[State]) -> f64 {
        match self.above(node) {
            None => states[node].restoring_force,
            Some(above) => states[node].restoring_force - states[above].restoring_force,
        }
    }

    /// Acceleration \[m/s²\] of a node in equilibrium with these velocities and forces; 0 for a wall.
    #[inline]
    pub(crate) fn acceleration(&self, node: usize, states: &[State], ground: f64) -> f64 {
        self.acceleration_under(node, &self.load(node, states, ground))
    }

    /// Acceleration \[m/s²\] of a node under a load; 0 for a wall.
    #[inline]
    pub(crate) fn acceleration_under(&self, node: usize, load: &Load) -> f64 {
        let node = &self.nodes()[node];
        let ground = if node.is_wall() { 0.0 } else { load.ground };
        let force = load.from_left + load.from_right + load.links - load.damping - load.restoring;
        node.inverse_mass * force - ground
    }

    /// The load on a node in these states, as it enters the equation of motion.
    #[inline]
    pub(crate) fn load(&self, node: usize, states: &[State], ground: f64) -> Load {
        let forces = StoreyForces {
            restoring: self.restoring_force(node, states),
            damping: self.damping_force(node, states),
        };
        Load::at(&states[node], forces, ground)
    }

    /// Motion of the floor below a node in states at the start and at the end of a span; `None` on the ground.
    #[inline]
    pub(crate) fn below(&self, node: usize, [start, end]: [&[State]; 2]) -> Option<[Motion; 2]> {
        let below = self.nodes()[node].support.below()?;
        Some([(&start[below]).into(), (&end[below]).into()])
    }

    /// States at t = 0 in equilibrium, and the memory of the columns.
    pub(crate) fn initial(&self, ground: Ground<'_>) -> (Vec<State>, Vec<Column::Memory>) {
        let state = |node: &Node<Column>| State {
            displacement: node.initial_displacement,
            velocity: node.initial_velocity,
            ..State::default()
        };
        let mut states: Vec<_> = self.nodes().iter().map(state).collect();
        let mut memories = Vec::with_capacity(states.len());
        for (index, node) in self.nodes().iter().enumerate() {
            let drift = self.drift(index, &states);
            let response = node.column.loaded(drift);
            states[index].restoring_force = response.force;
            memories.push(response.memory);
        }
        for index in 0..states.len() {
            states[index].acceleration = self.acceleration(index, &states, ground.under(index));
        }
        (states, memories)
    }
}
