//! Two neighbours of one scene.

use pounding_contact::ContactLaw;

use super::ExactSideBySide;
use super::contact::Contact;
use crate::PairSums;
use pounding_solver::formulas::Expansion;
use pounding_solver::formulas::{LONGEST_LEAP, in_flight};
use pounding_solver::{Elastic, Flight, Node, Row};

/// A structure, or a wall: what does not change, and its motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    /// 1/m \[1/kg\], c \[N·s/m\] and k \[N/m\].
    pub(super) inverse_mass: f64,
    pub(super) damping: f64,
    pub(super) stiffness: f64,
    /// 1, and 0 of a wall, which no ground motion moves.
    pub(super) mobile: f64,
    /// Coefficients of its series that reach rounding.
    pub(super) len: usize,
    /// Displacement \[m\] and velocity \[m/s\].
    pub(super) displacement: f64,
    pub(super) velocity: f64,
    /// Least and largest displacement so far \[m\].
    pub(super) extremes: [f64; 2],
}

/// Two neighbours.
#[derive(Debug, Clone)]
pub(super) struct Scene {
    pub(super) sides: [Side; 2],
    pub(super) gap: f64,
    pub(super) law: ContactLaw,
    /// \[kg\].
    pub(super) reduced_mass: f64,
    pub(super) tolerance: f64,
    pub(super) tally: PairSums,
    pub(super) link: Link,
    /// Of the interval through which it goes alone: how far it is, the time since its start \[s\], and events so far.
    pub(super) stage: Stage,
    pub(super) at: f64,
    pub(super) events: usize,
    /// Impacts that have followed each other at once.
    pub(super) bounces: Bounces,
    /// Impulse of the last one, with that of the rest behind it \[N·s\].
    pub(super) struck: f64,
}

/// What is between two neighbours.
#[derive(Debug, Clone, Copy)]
pub(super) enum Link {
    /// A gap.
    Apart,
    /// A gap that opens: it is closed at this instant, or was a moment ago, by an impact or a parting.
    Parting(Opening),
    /// A gap that is closed at this instant, and no rate: whether they part or press is to be decided.
    Closed {
        /// Whether this goes on from an impact.
        is_struck: bool,
    },
    /// They press against each other and move as one.
    Resting {
        /// So many of the first coefficients of their force are zero at this instant, though rounding says otherwise.
        zero_orders: usize,
    },
    /// Compliant contact.
    Pressed(Contact),
}

/// What is known of a deformation where it is nearly zero, better than displacements and velocities know it.
#[derive(Debug, Clone, Copy)]
pub(super) enum Opening {
    /// Itself \[m\], ≤ 0, and its rate \[m/s\].
    At(f64, f64),
    /// So many of its first coefficients are zero.
    Order(usize),
}

/// Impacts that follow each other at once.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounces {
    /// When the last one was, since the start of the interval \[s\].
    pub(super) last: f64,
    /// How many have followed the one before at once.
    pub(super) burst: u32,
}

impl Default for Bounces {
    fn default() -> Self {
        Self {
            last: f64::NEG_INFINITY,
            burst: 0,
        }
    }
}

/// How far a scene is that goes alone through an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Stage {
    OnTheWay,
    Arrived,
    GivenUp,
}

impl Side {
    /// Of a record with samples this far apart \[s\].
    fn new(node: &Node<Elastic>, step: f64) -> Self {
        let displacement = node.initial_displacement;
        let mut side = Self {
            inverse_mass: node.inverse_mass,
            damping: node.damping,
            stiffness: node.column.stiffness,
            mobile: node.mobile(),
            len: 0,
            displacement,
            velocity: node.initial_velocity,
            extremes: [displacement; 2],
        };
        side.len = in_flight(step * side.fastest_rate());
        side
    }

    /// The rate with which coefficients of its motion fall \[1/s\].
    pub(super) fn fastest_rate(&self) -> f64 {
        let damping = self.damping * self.inverse_mass;
        let stiffness = self.stiffness * self.inverse_mass;
        0.5 * (damping + (damping * damping + 4.0 * stiffness).sqrt())
    }

    /// Its free motion under a ground that has this acceleration \[m/s²\] and slope \[m/s³\].
    pub(super) fn expand(&self, ground: [f64; 2], room: &mut Expansion) {
        let flight = Flight {
            origin: 0.0,
            displacement: self.displacement,
            velocity: self.velocity,
            restoring_force: self.stiffness * self.displacement,
            stiffness: self.stiffness,
            damping: self.damping,
            inverse_mass: self.inverse_mass,
            ground: ground.map(|number| self.mobile * number),
            len: self.len,
        };
        flight.expand(room);
    }

    /// Brings the side to a displacement.
    pub(super) fn reach(&mut self, displacement: f64) {
        let [least, largest] = self.extremes;
        self.extremes = [least.min(displacement), largest.max(displacement)];
    }
}

impl Scene {
    /// The scene of a row; given up at once where series do not reach over an interval.
    pub(super) fn new(row: &Row<Elastic>, method: &ExactSideBySide<'_>) -> Self {
        let step = method.step;
        let pair = &row.pairs()[0];
        let sides = [0, 1].map(|node: usize| Side::new(&row.nodes()[node], step));
        let reaches = |side: &Side| step * side.fastest_rate() <= LONGEST_LEAP;
        let stage = if sides.iter().all(reaches) {
            Stage::Arrived
        } else {
            Stage::GivenUp
        };
        let mut scene = Self {
            sides,
            gap: pair.gap(),
            law: pair.law,
            reduced_mass: row.reduced_mass(pair),
            tolerance: method.tolerance,
            tally: PairSums::default(),
            link: Link::Apart,
            stage,
            at: 0.0,
            events: 0,
            bounces: Bounces::default(),
            struck: 0.0,
        };
        let (deformation, rate) = scene.closing();
        if (deformation, rate) == (0.0, 0.0) {
            scene.link = Link::Closed { is_struck: false };
        }
        scene.tally.closing = method.closings.then_some(deformation + pair.gap());
        scene
    }

    /// What happened to the pair, with a contact that goes on.
    pub(super) fn tally(&self) -> PairSums {
        let open = match &self.link {
            Link::Pressed(contact) => contact.impulse,
            Link::Apart | Link::Parting(_) | Link::Closed { .. } | Link::Resting { .. } => 0.0,
        };
        PairSums {
            impulse: self.tally.impulse + open,
            largest_impulse: self.tally.largest_impulse.max(open),
            ..self.tally
        }
    }

    /// Deformation \[m\] and approach rate \[m/s\] of the pair.
    pub(super) fn closing(&self) -> (f64, f64) {
        let [left, right] = &self.sides;
        let ahead = left.displacement - right.displacement;
        (ahead - self.gap, left.velocity - right.velocity)
    }
}
