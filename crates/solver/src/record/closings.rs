pub(crate) mod cubic;
mod gap;
mod piece;

use crate::span::{Expansion, Power};
use crate::{Impact, Motion, Path, Recorder, Span, State, Travel};

use cubic::{Cubic, Node};
use gap::Gap;
use piece::Piece;

/// How far two neighbours came towards each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closing {
    /// Largest displacement of the left neighbour minus that of the right neighbour \[m\]; a gap of this width just closes.
    pub distance: f64,
    /// Its first instant \[s\].
    pub time: f64,
}

/// How far the right neighbour moved away from the left one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Widening {
    /// Largest displacement of the right neighbour minus that of the left neighbour \[m\]: the largest opening of a gap without width.
    pub distance: f64,
    /// Its first instant \[s\].
    pub time: f64,
    /// First instant at which the distance exceeds the width of the seat \[s\]; `None` if it never does, or if there is no seat.
    pub unseated: Option<f64>,
}

/// A floor beside a column of its neighbour, whose motion lies between those of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BesideColumn {
    /// The floor.
    pub floor: usize,
    /// Whether the floor is on the left of the column.
    pub is_left: bool,
    /// Floor at the foot of the column; `None` if the column stands on the ground.
    pub below: Option<usize>,
    /// Floor at the head of the column.
    pub above: usize,
    /// Part of the head in the motion of the column beside the floor \[–\], more than 0 and at most 1; the foot has the rest.
    pub upper_part: f64,
}

impl BesideColumn {
    /// The gap between the floor and the column: the weights of their motions. Ground that does not travel has no motion; the motion of ground
    /// that does is part of the column's.
    fn gap(&self, travels: bool) -> Gap {
        let side = if self.is_left { 1.0 } else { -1.0 };
        let head = -side * self.upper_part;
        match self.below {
            Some(_) => Gap::of(&[side, head, -side - head]),
            None if travels => Gap::of(&[side, -side]),
            None => Gap::of(&[side, head]),
        }
    }

    /// Index of the motion of a node in the gap.
    fn part(&self, node: usize) -> Option<usize> {
        let parts = [Some(self.floor), Some(self.above), self.below];
        parts.iter().position(|part| *part == Some(node))
    }

    /// The motion of a column that stands on travelling ground, beside the floor.
    fn on_ground(&self, head: Cubic, travel: Option<&Travel>) -> Cubic {
        let ground = head.of_ground(self.above, travel);
        head.times(self.upper_part).plus(ground.times(1.0 - self.upper_part))
    }
}

/// Records how far every two neighbours came towards each other, including the motion between nodes and samples.
///
/// The motion of a stepping method is the cubic of its spans; the largest closing is that of these cubics. A series is replaced by cubics
/// between looks, as many as leave out at most 1e-12 of its terms. A cubic over a duration h leaves out h⁴/384 times the fourth derivative.
/// A series is looked at only if the cubic through its ends, with this error, could close the gap further than already known.
///
/// Memory: the motion of a neighbour is kept only until the other neighbour has come as far. This is a sample interval in the exact method,
/// and a time step in others. If grounds move apart, their motion is part of the closing; it is a cubic between samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Closings {
    look: f64,
    walls: Vec<bool>,
    /// How the ground motion travels; `None` if all are shaken at once.
    travel: Option<Travel>,
    /// The gap between each structure and its right neighbour.
    gaps: Vec<Gap>,
    /// Floors beside columns, whose gaps follow those of neighbours.
    columns: Vec<BesideColumn>,
    /// The gaps of mirrored motions, whose closings are the openings of the others; empty unless requested.
    reversed: Vec<Gap>,
}

impl Closings {
    /// A recorder for a row of these structures; `walls` marks the walls. `look` is the longest interval \[s\], > 0, between two looks at a
    /// series of more than forty terms or in fractional powers of time.
    pub fn new(walls: Vec<bool>, look: f64) -> Self {
        let gaps = vec![Gap::of(&Gap::OF_TWO); walls.len().saturating_sub(1)];
        Self {
            look,
            walls,
            travel: None,
            gaps,
            columns: Vec::new(),
            reversed: Vec::new(),
        }
    }

    /// Also records how far neighbours move away from each other. These are the closings under the mirrored shaking if the row mirrors its
    /// motion under mirrored shaking: nothing touches, columns have no preferred direction, and the run begins at rest.
    #[must_use]
    pub fn both_ways(self) -> Self {
        let reversed = self.gaps.iter().map(Gap::reversed).collect();
        Self { reversed, ..self }
    }

    /// Also records when the right neighbour has moved farther from the left one than a seat is wide: the width \[m\], > 0, by the left
    /// neighbour. Comes after [`Self::both_ways`], without which it records nothing.
    #[must_use]
    pub fn seated(mut self, seats: impl IntoIterator<Item = (usize, f64)>) -> Self {
        for (left, width) in seats {
            if let Some(gap) = self.reversed.get_mut(left) {
                gap.passes = Some(width);
            }
        }
        self
    }

    /// Also records the closings of floors and columns. Comes after [`Self::travelled`] and before [`Self::both_ways`].
    #[must_use]
    pub fn beside(mut self, columns: Vec<BesideColumn>) -> Self {
        let travels = self.travel.is_some();
        self.gaps.extend(columns.iter().map(|column| column.gap(travels)));
        Self { columns, ..self }
    }

    /// Records on ground along which the excitation [travels](crate::Row::travel).
    ///
    /// The steps of a stepping method must be short compared with the time between two samples: the ground counts as a cubic in a step,
    /// too. A wall moves with the ground under it.
    #[must_use]
    pub fn travelled(self, travel: Option<Travel>) -> Self {
        Self { travel, ..self }
    }

    /// Closing of a structure and its right neighbour; `None` between two walls.
    pub fn of(&self, left: usize) -> Option<Closing> {
        self.gaps[left].largest
    }

    /// Closing under the mirrored shaking; `None` unless [requested](Self::both_ways).
    pub fn of_reversed(&self, left: usize) -> Option<Closing> {
        self.reversed.get(left)?.largest
    }

    /// How far the right neighbour moved away from a structure; `None` between two walls, or unless [requested](Self::both_ways).
    pub fn widening(&self, left: usize) -> Option<Widening> {
        self.reversed.get(left)?.widening()
    }

    /// How far a floor and a column moved away from each other, by the index of the column; `None` unless [requested](Self::both_ways).
    pub fn widening_of_column(&self, column: usize) -> Option<Widening> {
        self.reversed.get(self.of_neighbours() + column)?.widening()
    }

    /// Closing of a floor and a column, by the index of the column, as it shakes or under the mirrored shaking; `None` unless requested.
    pub fn of_column(&self, column: usize, reversed: bool) -> Option<Closing> {
        let gaps = if reversed { &self.reversed } else { &self.gaps };
        gaps.get(self.of_neighbours() + column)?.largest
    }

    /// Number of gaps between neighbours.
    fn of_neighbours(&self) -> usize {
        self.walls.len().saturating_sub(1)
    }

    /// Adds a piece of the motion of a structure to its gaps.
    fn follow(&mut self, structure: usize, travel: Option<&Travel>, piece: &Piece) {
        self.follow_neighbours(structure, travel, piece);
        let first = self.of_neighbours();
        for (index, column) in self.columns.iter().enumerate() {
            let Some(part) = column.part(structure) else {
                continue;
            };
            let on_ground = travel.is_some() && column.below.is_none() && structure == column.above;
            let both = [self.gaps.get_mut(first + index), self.reversed.get_mut(first + index)];
            for gap in both.into_iter().flatten() {
                let piece = if on_ground {
                    column.on_ground(piece.cubic, travel).into()
                } else {
                    piece.clone()
                };
                gap.follow(part, piece);
            }
        }
    }

    /// Adds a piece of the motion of a structure to the gaps on both sides.
    fn follow_neighbours(&mut self, structure: usize, travel: Option<&Travel>, piece: &Piece) {
        let left = structure.checked_sub(1);
        let right = (structure < self.of_neighbours()).then_some(structure + 1);
        let sides = [(left, left, 1), (right, right.map(|_| structure), 0)];
        for (neighbour, gap, side) in sides {
            let Some((neighbour, gap)) = neighbour.zip(gap) else {
                continue;
            };
            let both = [self.gaps.get_mut(gap), self.reversed.get_mut(gap)];
            for gap in both.into_iter().flatten() {
                if self.walls[neighbour] {
                    gap.follow_beside_wall(side, piece, |cubic| cubic.of_ground(neighbour, travel));
                } else {
                    gap.follow(side, piece.clone());
                }
            }
        }
    }

    /// The next instant at which the ground under a neighbouring wall follows another cubic.
    fn ground_of_walls_bends(&self, structure: usize, travel: Option<&Travel>, after: f64) -> f64 {
        let Some(travel) = travel else {
            return f64::INFINITY;
        };
        let sides = [structure.checked_sub(1), Some(structure + 1)];
        let sides = sides.into_iter().flatten();
        let walls = sides.filter(|side| self.walls.get(*side).is_some_and(|wall| *wall));
        let arrivals = walls.map(|wall| travel.next_arrival(wall, after));
        arrivals.fold(f64::INFINITY, f64::min)
    }

    /// Number of cubics into which a span is split.
    fn looks(&self, span: &Span<'_>, travels: bool) -> u32 {
        match span.path {
            Path::Cubic(_) => 1,
            // The ground under the structure is a cubic, which leaves out nothing.
            Path::Series(series) if travels && series.power == Power::One => piece::looks(series.displacement, span.duration()),
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a number of looks, at least one"
            )]
            Path::Series(_) | Path::Flight(_) => (span.duration() / self.look).ceil().max(1.0) as u32,
        }
    }
}

impl Recorder for Closings {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        // A wall may report the whole run at its end; its neighbours do not wait for it.
        if self.walls[span.structure] {
            return;
        }
        let travel = self.travel.take();
        let node = |time: f64, state: State| match &travel {
            None => Node::new(time, (&state).into()),
            Some(travel) => {
                let ground = travel.ground(span.structure, time);
                Node::new(time, Motion::from(&state).over(ground))
            }
        };
        let mut room = Expansion::default();
        let span = &span.expanded(&mut room);
        let start = node(span.start_time, span.start);
        let end = node(span.end_time, span.end);
        let whole = Cubic { start, end };
        let series = match span.path {
            Path::Series(series) if travel.is_none() => Piece::of_series(whole, &series),
            Path::Series(_) | Path::Cubic(_) | Path::Flight(_) => None,
        };
        if let Some(piece) = series {
            return self.follow(span.structure, None, &piece);
        }
        let looks = self.looks(span, travel.is_some());
        let (mut start, mut look) = (start, 1);
        loop {
            let share = f64::from(look) / f64::from(looks);
            let time = span.start_time + share * span.duration();
            let bends = self.ground_of_walls_bends(span.structure, travel.as_ref(), start.time);
            if look == looks && bends >= span.end_time {
                break;
            }
            look += u32::from(look < looks && time <= bends);
            let time = time.min(bends);
            let end = node(time, span.at(time));
            self.follow(span.structure, travel.as_ref(), &Cubic { start, end }.into());
            start = end;
        }
        self.follow(span.structure, travel.as_ref(), &Cubic { start, end }.into());
        self.travel = travel;
    }

    fn impact(&mut self, _: &Impact) {}
}

#[cfg(test)]
mod tests;
