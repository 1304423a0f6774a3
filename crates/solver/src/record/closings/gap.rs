//! The motion between two neighbours, and how far they have closed their gap.
//!
//! A closing is a weighted sum of motions. For two floors it is the left motion minus the right motion. The motion of a column lies between
//! those of its ends.

use std::collections::VecDeque;

use super::cubic::Cubic;
use super::piece::Piece;
use super::{Closing, Widening};

/// The gap between two neighbours.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Gap {
    /// Motions that some other one has not reached yet, from a common instant: for two floors those of the left one and of the right one.
    pub(super) ahead: Vec<VecDeque<Piece>>,
    /// Weights of the motions in the closing.
    weights: Vec<f64>,
    pub(super) largest: Option<Closing>,
    /// Whether the gap is that under the mirrored shaking, which mirrors every motion.
    reversed: bool,
    /// Closing whose first instant is wanted \[m\].
    pub(super) passes: Option<f64>,
    /// First instant at which the closing is larger \[s\].
    passed: Option<f64>,
}

impl Gap {
    /// A gap between a left and a right neighbour.
    pub(super) const OF_TWO: [f64; 2] = [1.0, -1.0];

    /// A gap whose closing is the sum of motions with these weights.
    pub(super) fn of(weights: &[f64]) -> Self {
        Self {
            ahead: vec![VecDeque::new(); weights.len()],
            weights: weights.to_vec(),
            largest: None,
            reversed: false,
            passes: None,
            passed: None,
        }
    }

    /// The gap under the mirrored shaking.
    pub(super) fn reversed(&self) -> Self {
        Self {
            reversed: true,
            ..self.clone()
        }
    }

    /// The largest closing as a widening of the gap whose motions it mirrors.
    pub(super) fn widening(&self) -> Option<Widening> {
        let Closing { distance, time } = self.largest?;
        let unseated = self.passed;
        Some(Widening { distance, time, unseated })
    }

    /// Weighted sum of the foremost motions until an instant.
    fn foremost(&self, end: f64) -> Option<Cubic> {
        let weighed = |(ahead, weight): (&VecDeque<Piece>, &f64)| Some(ahead.front()?.cubic.until(end).times(*weight));
        let mut motions = self.ahead.iter().zip(&self.weights).map(weighed);
        let first = motions.next()??;
        motions.try_fold(first, |sum, next| Some(sum.plus(next?)))
    }

    /// First end of the foremost motions; `None` unless all are known.
    fn common_end(&self) -> Option<f64> {
        let ends = self.ahead.iter().map(|ahead| Some(ahead.front()?.cubic.end.time));
        ends.reduce(|one, other| Some(one?.min(other?)))?
    }

    /// Largest distance of the foremost motions from their cubics, weighed \[m\].
    fn leaves_out(&self) -> f64 {
        let fronts = self.ahead.iter().zip(&self.weights);
        let weighed = fronts.filter_map(|(ahead, weight)| Some(ahead.front()?.leaves_out() * weight.abs()));
        weighed.sum()
    }

    /// The closing of the gap, from the left motion minus the right motion.
    fn closing(&self, apart: Cubic) -> Cubic {
        if self.reversed { apart.mirrored() } else { apart }
    }

    /// Adds a piece of the motion of the left neighbour (side 0) or the right neighbour (side 1) next to a wall with this motion.
    pub(super) fn follow_beside_wall(&mut self, side: usize, piece: &Piece, wall: impl Fn(Cubic) -> Cubic) {
        let reversed = self.reversed;
        let closing = |cubic: Cubic| {
            let wall = wall(cubic);
            if (side == 0) == reversed {
                wall.less(cubic)
            } else {
                cubic.less(wall)
            }
        };
        if !self.knows(&closing(piece.cubic), piece.leaves_out()) {
            for cubic in piece.fine() {
                self.take(&closing(cubic));
            }
        }
    }

    /// Adds a piece of the motion with this index; for two floors 0 is the left one and 1 the right one.
    pub(super) fn follow(&mut self, side: usize, piece: Piece) {
        self.ahead[side].push_back(piece);
        while let Some(end) = self.common_end() {
            let Some(sum) = self.foremost(end) else { return };
            let closing = self.closing(sum);
            let leaves_out = self.leaves_out();
            if !self.knows(&closing, leaves_out) {
                if leaves_out > 0.0 {
                    self.ahead.iter_mut().for_each(look_closer);
                    continue;
                }
                self.take(&closing);
            }
            for ahead in &mut self.ahead {
                let piece = ahead.pop_front();
                let rest = piece.filter(|piece| piece.cubic.end.time > end);
                if let Some(piece) = rest {
                    ahead.push_front(piece.from(end));
                }
            }
        }
    }

    /// Whether a closing with at most this distance from its cubic cannot exceed the known closing. Its control points bound it, so that
    /// most pieces are skipped at once.
    fn knows(&self, closing: &Cubic, leaves_out: f64) -> bool {
        let known = self.largest.map_or(f64::NEG_INFINITY, |one| one.distance);
        let mut controls = closing.controls().into_iter();
        controls.all(|height| height + leaves_out <= known)
    }

    /// Updates the largest closing from a cubic.
    fn take(&mut self, closing: &Cubic) {
        let highest = closing.highest();
        let known = self.largest.map_or(f64::NEG_INFINITY, |one| one.distance);
        if highest.distance > known {
            self.largest = Some(highest);
        }
        if let Some(width) = self.passes.filter(|width| self.passed.is_none() && highest.distance > *width) {
            self.passed = Some(closing.first_above(width));
        }
    }
}

/// Replaces the first piece by the cubics between its looks.
fn look_closer(ahead: &mut VecDeque<Piece>) {
    if let Some(piece) = ahead.pop_front() {
        for cubic in piece.fine().rev() {
            ahead.push_front(cubic.into());
        }
    }
}
