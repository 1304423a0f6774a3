//! What lies between two neighbours, and how far they have closed it.

use std::collections::VecDeque;

use super::Closing;
use super::cubic::Cubic;
use super::piece::Piece;

/// What lies between two neighbours.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Gap {
    /// Motion of the left and of the right neighbour that the other has not come to, from one common instant on.
    pub(super) ahead: [VecDeque<Piece>; 2],
    pub(super) largest: Option<Closing>,
    /// Whether the ground shakes the other way round, of which every motion is the mirror.
    reversed: bool,
}

impl Gap {
    /// Under the mirror of the shaking that is followed.
    pub(super) fn reversed() -> Self {
        Self {
            reversed: true,
            ..Self::default()
        }
    }

    /// What closes the gap, of the left neighbour's motion less that of the right one.
    fn closing(&self, apart: Cubic) -> Cubic {
        if self.reversed { apart.mirrored() } else { apart }
    }

    /// A piece of the motion of the left neighbour (side 0) or of the right one, beside a wall that moves so.
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

    /// The same beside a neighbour that moves.
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

    /// Whether a closing that is so far from a cubic at most goes no further than is known. It does not go above the control points, so
    /// that most pieces are left at once.
    fn knows(&self, closing: &Cubic, leaves_out: f64) -> bool {
        let known = self.largest.map_or(f64::NEG_INFINITY, |one| one.distance);
        let mut controls = closing.controls().into_iter();
        controls.all(|height| height + leaves_out <= known)
    }

    /// Takes the largest value of a closing that is a cubic.
    fn take(&mut self, closing: &Cubic) {
        let highest = closing.highest();
        let known = self.largest.map_or(f64::NEG_INFINITY, |one| one.distance);
        if highest.distance > known {
            self.largest = Some(highest);
        }
    }
}

/// Puts the cubics between the looks of the first piece in its place.
fn look_closer(ahead: &mut VecDeque<Piece>) {
    if let Some(piece) = ahead.pop_front() {
        for cubic in piece.fine().rev() {
            ahead.push_front(cubic.into());
        }
    }
}
