//! Two neighbours of one scene.

use pounding_contact::ContactLaw;

use super::contact::Contact;
use crate::ensemble::PairSums;
use crate::span::Expansion;
use crate::{Elastic, Flight, Node, Row};

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
    /// Compliant contact that goes on.
    pub(super) contact: Option<Contact>,
    /// Whether the gap is closed at this instant and opens: after an impact, or a parting.
    pub(super) parts: bool,
    /// Of the interval through which it goes alone: how far it is, the time since its start \[s\], and events so far.
    pub(super) stage: Stage,
    pub(super) at: f64,
    pub(super) events: usize,
}

/// How far a scene is that goes alone through an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Stage {
    OnTheWay,
    Arrived,
    GivenUp,
}

/// Why a scene has to run alone.
#[derive(Debug, Clone, Copy)]
pub(super) struct GivenUp;

impl Side {
    pub(super) fn new(node: &Node<Elastic>, len: usize) -> Self {
        let displacement = node.initial_displacement;
        Self {
            inverse_mass: node.inverse_mass,
            damping: node.damping,
            stiffness: node.column.stiffness,
            mobile: node.mobile(),
            len,
            displacement,
            velocity: node.initial_velocity,
            extremes: [displacement; 2],
        }
    }

    /// The rate with which coefficients of its motion fall \[1/s\].
    pub(super) fn fastest_rate(node: &Node<Elastic>) -> f64 {
        let damping = node.damping * node.inverse_mass;
        let stiffness = node.column.stiffness * node.inverse_mass;
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
    pub(super) fn new(row: &Row<Elastic>, (tolerance, lens): (f64, [usize; 2])) -> Self {
        let pair = &row.pairs()[0];
        let side = |node: usize| Side::new(&row.nodes()[node], lens[node]);
        Self {
            sides: [side(0), side(1)],
            gap: pair.gap,
            law: pair.law,
            reduced_mass: row.reduced_mass(pair),
            tolerance,
            tally: PairSums::default(),
            contact: None,
            parts: false,
            stage: Stage::Arrived,
            at: 0.0,
            events: 0,
        }
    }

    /// What happened to the pair, with a contact that goes on.
    pub(super) fn tally(&self) -> PairSums {
        let open = self.contact.as_ref().map_or(0.0, |contact| contact.impulse);
        PairSums {
            impulse: self.tally.impulse + open,
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
