//! A structure between events: its state, its branch, and its motion as a power series.

use crate::exact::noise::Terms;
use crate::exact::roots::CAPACITY;
use crate::{Hysteretic, Node, State};

/// The branch of a piecewise-linear restoring force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Branch {
    Elastic,
    /// Yielding with the force at +`f_y`.
    Right,
    /// Yielding with the force at −`f_y`.
    Left,
}

/// A structure or a wall.
#[derive(Debug, Clone)]
pub(super) struct Member {
    pub(super) inverse_mass: f64,
    /// Infinite for a wall.
    pub(super) mass: f64,
    pub(super) damping: f64,
    pub(super) stiffness: f64,
    pub(super) yield_force: f64,
    pub(super) branch: Branch,
    /// The net pounding force is known to be zero.
    pub(super) balanced: bool,
    /// The net pounding force is known to have an extremum.
    pub(super) peaked: bool,
    pub(super) terms: Terms,
    /// State at the start of the piece; displacement, velocity and restoring force lead, the rest follows.
    pub(super) state: State,
    pub(super) displacement: [f64; CAPACITY],
    pub(super) velocity: [f64; CAPACITY],
    pub(super) acceleration: [f64; CAPACITY],
}

impl Member {
    pub(super) fn new<Column: Hysteretic>(node: &Node<Column>) -> Self {
        let response = node
            .column
            .respond(node.initial_displacement, Column::Memory::default());
        let force = if node.is_wall() { 0.0 } else { response.force };
        Self {
            inverse_mass: node.inverse_mass,
            mass: 1.0 / node.inverse_mass,
            damping: node.damping,
            stiffness: node.column.stiffness(),
            yield_force: node.column.yield_force(),
            branch: Branch::Elastic,
            balanced: false,
            peaked: false,
            terms: Terms::default(),
            state: State {
                displacement: node.initial_displacement,
                velocity: node.initial_velocity,
                restoring_force: force,
                ..State::default()
            },
            displacement: [0.0; CAPACITY],
            velocity: [0.0; CAPACITY],
            acceleration: [0.0; CAPACITY],
        }
    }

    pub(super) fn is_wall(&self) -> bool {
        self.inverse_mass == 0.0
    }

    /// Tangent stiffness of the branch \[N/m\].
    pub(super) fn tangent(&self) -> f64 {
        match self.branch {
            Branch::Elastic => self.stiffness,
            Branch::Right | Branch::Left => 0.0,
        }
    }

    /// Coefficient `n` of the restoring force.
    pub(super) fn restoring_force(&self, n: usize) -> f64 {
        if n == 0 {
            self.state.restoring_force
        } else {
            self.tangent() * self.displacement[n]
        }
    }

    /// The rate ρ with ρ² = ρ c/m + k/m: coefficients of the motion fall at least like ρⁿ/n!.
    pub(super) fn fastest_rate(&self) -> f64 {
        let (damping, stiffness) = (
            self.damping * self.inverse_mass,
            self.stiffness * self.inverse_mass,
        );
        0.5 * (damping + (damping * damping + 4.0 * stiffness).sqrt())
    }

    /// Ends yielding where the motion from a standstill leads back; true when it did.
    pub(super) fn turns_back(&mut self, p: usize) -> bool {
        let coefficients = self.velocity.iter().enumerate();
        // Where the acceleration is zero by an event, rounding has no say in it.
        let leading = coefficients
            .filter(|(n, coefficient)| coefficient.abs() > self.noise_of_velocity(p, *n))
            .map(|(_, coefficient)| coefficient)
            .next();
        let back = match (self.branch, leading) {
            (Branch::Right, Some(leading)) => *leading < 0.0,
            (Branch::Left, Some(leading)) => *leading > 0.0,
            (Branch::Elastic, _) | (_, None) => false,
        };
        if back {
            self.branch = Branch::Elastic;
        }
        back
    }

    /// Clears what rounding leaves of the first velocities from a standstill: columns would yield again at once.
    pub(super) fn clear_standstill(&mut self, p: usize) {
        for n in 0..CAPACITY - p {
            if self.velocity[n].abs() > self.noise_of_velocity(p, n) {
                return;
            }
            (self.velocity[n], self.displacement[n + p]) = (0.0, 0.0);
            if n >= p {
                self.acceleration[n - p] = 0.0;
            }
        }
    }

    /// Columns yield no longer once the structure turns.
    pub(super) fn unload(&mut self) {
        let velocity = self.state.velocity;
        let turned = match self.branch {
            Branch::Elastic => false,
            Branch::Right => velocity < 0.0,
            Branch::Left => velocity > 0.0,
        };
        if turned {
            self.branch = Branch::Elastic;
        }
    }
}
