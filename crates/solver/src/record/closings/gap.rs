//! The motion between two neighbours, and how far they have closed their gap.

use std::collections::VecDeque;

use super::Closing;
use super::cubic::Cubic;
use super::piece::Piece;

/// The gap between two neighbours.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Gap {
    /// Motions of the left and of the right neighbour that the other has not reached yet, from a common instant.
    pub(super) ahead: [VecDeque<Piece>; 2],
    pub(super) largest: Option<Closing>,
    /// Whether the gap is that under the mirrored shaking, which mirrors every motion.
    reversed: bool,
}

impl Gap {
    /// A gap under the mirrored shaking.
    pub(super) fn reversed() -> Self {
        Self {
            reversed: true,
            ..Self::default()
        }
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

    /// Adds a piece of the motion of a neighbour, next to a neighbour that moves.
    pub(super) fn follow(&mut self, side: usize, piece: Piece) {
        self.ahead[side].push_back(piece);
        while let [Some(left), Some(right)] = self.ahead.each_ref().map(VecDeque::front) {
            let end = left.cubic.end.time.min(right.cubic.end.time);
            let closing = self.closing(left.cubic.until(end).less(right.cubic.until(end)));
            let leaves_out = left.leaves_out() + right.leaves_out();
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
