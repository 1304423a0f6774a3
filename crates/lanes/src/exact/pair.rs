//! Two neighbours of a scene.

use pounding_contact::{ContactLaw, Form};

use super::ExactSideBySide;
use crate::PairSums;
use pounding_solver::formulas::Expansion;
use pounding_solver::formulas::{LONGEST_LEAP, in_flight};
use pounding_solver::{Elastic, Flight, Node, Row};

/// First step in s \[s^¼\]: a thousandth of the time of a stiff contact.
const FIRST_STEP: f64 = 0.02;

/// A structure, or a wall: its constants and its motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    /// 1/m \[1/kg\], c \[N·s/m\] and k \[N/m\].
    pub(super) inverse_mass: f64,
    pub(super) damping: f64,
    pub(super) stiffness: f64,
    /// Mobility: 1, or 0 for a wall, which no ground motion moves.
    pub(super) mobile: f64,
    /// Number of coefficients of its series down to rounding.
    pub(super) len: usize,
    /// Displacement \[m\] and velocity \[m/s\].
    pub(super) displacement: f64,
    pub(super) velocity: f64,
    /// Smallest and largest displacement so far \[m\].
    pub(super) extremes: [f64; 2],
}

/// Two neighbours.
#[derive(Debug, Clone)]
pub(super) struct Scene {
    pub(super) sides: [Side; 2],
    pub(super) gap: f64,
    pub(super) law: ContactLaw,
    /// Reduced mass \[kg\].
    pub(super) reduced_mass: f64,
    pub(super) tolerance: f64,
    pub(super) tally: PairSums,
    pub(super) link: Link,
    /// Progress through an interval alone: its stage, the time since the start of the interval \[s\], and the events so far.
    pub(super) stage: Stage,
    pub(super) at: f64,
    pub(super) events: usize,
    /// Impacts in immediate succession.
    pub(super) bounces: Bounces,
    /// Impulse of the last impact, including the rest after it \[N·s\].
    pub(super) struck: f64,
}

/// State of the gap between two neighbours.
#[derive(Debug, Clone, Copy)]
pub(super) enum Link {
    /// Open gap.
    Apart,
    /// A gap that opens: an impact or a parting closed it at this instant, or just before.
    Parting(Opening),
    /// A gap that is closed without a rate: parting or pressing must be decided.
    Closed {
        /// Whether this follows an impact.
        is_struck: bool,
    },
    /// The neighbours press against each other and move together.
    Resting {
        /// Number of first coefficients of their force that are zero at this instant, despite rounding.
        zero_orders: usize,
    },
    /// Compliant contact.
    Pressed(PressedContact),
}

/// A compliant contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct PressedContact {
    pub(super) form: Form,
    /// Approach rate at the touch \[m/s\].
    pub(super) speed: f64,
    /// Fourth root of the time since the touch \[s^¼\], and the next step in it.
    pub(super) s: f64,
    pub(super) step: f64,
    /// Rate of its force \[N/s\]; NaN just after a touch or a bend.
    pub(super) climb: f64,
    /// Impulse so far \[N·s\].
    pub(super) impulse: f64,
}

impl PressedContact {
    pub(super) fn new(form: Form, speed: f64) -> Self {
        Self {
            form,
            speed,
            s: 0.0,
            step: FIRST_STEP,
            climb: f64::NAN,
            impulse: 0.0,
        }
    }
}

/// A deformation near zero, known better than from displacements and velocities.
#[derive(Debug, Clone, Copy)]
pub(super) enum Opening {
    /// The deformation \[m\], ≤ 0, and its rate \[m/s\].
    At(f64, f64),
    /// Number of first coefficients that are zero.
    Order(usize),
}

/// Impacts in immediate succession.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounces {
    /// Time of the last impact since the start of the interval \[s\].
    pub(super) last: f64,
    /// Number of impacts that followed the previous one at once.
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

/// Progress of a scene that runs alone through an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Stage {
    OnTheWay,
    Arrived,
    GivenUp,
}

impl Side {
    /// A side under a record with samples this far apart \[s\].
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

    /// Rate at which the coefficients of its motion fall \[1/s\].
    pub(super) fn fastest_rate(&self) -> f64 {
        let damping = self.damping * self.inverse_mass;
        let stiffness = self.stiffness * self.inverse_mass;
        0.5 * (damping + (damping * damping + 4.0 * stiffness).sqrt())
    }

    /// Its free motion under a ground with this acceleration \[m/s²\] and slope \[m/s³\].
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

    /// Updates the extremes with a displacement.
    pub(super) fn reach(&mut self, displacement: f64) {
        let [least, largest] = self.extremes;
        self.extremes = [least.min(displacement), largest.max(displacement)];
    }
}

impl Scene {
    /// The scene of a row; given up at once if series do not reach over an interval.
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

    /// Results of the pair, including a contact in progress.
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
