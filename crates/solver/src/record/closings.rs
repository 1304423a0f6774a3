use std::collections::VecDeque;

use crate::span::Expansion;
use crate::{Impact, Motion, Path, Recorder, Span, State, Travel};

/// How far two neighbours came towards each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closing {
    /// Largest displacement of the left neighbour less that of the right one \[m\]; a gap of this width just closes.
    pub distance: f64,
    /// Its first instant \[s\].
    pub time: f64,
}

/// Records of every two neighbours how far they came towards each other, between nodes and samples too.
///
/// The motion of a stepping method is the cubic of its spans, and the largest closing that of these cubics. A series is taken
/// as a cubic between looks: with 200 of them in the shortest natural period it is off by (2π/200)⁴/384 of the
/// amplitude, 3e-9. What waits for a neighbour to come as far is kept, and nothing else: a record's step of it in the exact
/// method, a time step in others. Where grounds move apart, how far they do is part of the closing.
#[derive(Debug, Clone, PartialEq)]
pub struct Closings {
    look: f64,
    walls: Vec<bool>,
    /// How the ground motion travels; nothing where all are shaken at once.
    travel: Option<Travel>,
    /// Between each structure and its right neighbour.
    gaps: Vec<Gap>,
}

/// What lies between two neighbours.
#[derive(Debug, Clone, Default, PartialEq)]
struct Gap {
    /// Motion of the left and of the right neighbour that the other has not come to, from one common instant on.
    ahead: [VecDeque<Cubic>; 2],
    largest: Option<Closing>,
}

/// Instant \[s\], displacement \[m\] and velocity \[m/s\].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Node {
    time: f64,
    displacement: f64,
    velocity: f64,
}

/// The cubic through two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cubic {
    start: Node,
    end: Node,
}

impl Closings {
    /// For a row of these structures, of which some are walls; `look` is the longest interval between two looks at a series
    /// \[s\], > 0.
    pub fn new(walls: Vec<bool>, look: f64) -> Self {
        let gaps = vec![Gap::default(); walls.len().saturating_sub(1)];
        Self {
            look,
            walls,
            travel: None,
            gaps,
        }
    }

    /// The same on ground to which the excitation [travels](crate::Row::travel).
    ///
    /// A stepping method then has to take steps that are short beside the time between two samples: in a step the ground
    /// is a cubic, too. A wall moves with its own ground.
    #[must_use]
    pub fn travelled(self, travel: Option<Travel>) -> Self {
        Self { travel, ..self }
    }

    /// Of a structure and its right neighbour; nothing between two walls.
    pub fn of(&self, left: usize) -> Option<Closing> {
        self.gaps[left].largest
    }

    /// A piece of the motion of a structure, for the gaps on both sides.
    fn follow(&mut self, structure: usize, travel: Option<&Travel>, piece: Cubic) {
        let wall = |node: usize| self.walls[node].then(|| piece.of_ground(node, travel));
        if let Some(left) = structure.checked_sub(1) {
            self.gaps[left].follow(1, piece, wall(left));
        }
        if structure < self.gaps.len() {
            let wall = wall(structure + 1);
            self.gaps[structure].follow(0, piece, wall);
        }
    }

    /// Into how many cubics a span is cut.
    fn looks(&self, span: &Span<'_>) -> u32 {
        match span.path {
            Path::Cubic(_) => 1,
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a number of looks, at least one"
            )]
            Path::Series(_) | Path::Flight(_) => {
                (span.duration() / self.look).ceil().max(1.0) as u32
            }
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
        let looks = self.looks(span);
        let mut start = node(span.start_time, span.start);
        for look in 1..looks {
            let share = f64::from(look) / f64::from(looks);
            let time = span.start_time + share * span.duration();
            let end = node(time, span.at(time));
            self.follow(span.structure, travel.as_ref(), Cubic { start, end });
            start = end;
        }
        let end = node(span.end_time, span.end);
        self.follow(span.structure, travel.as_ref(), Cubic { start, end });
        self.travel = travel;
    }

    fn impact(&mut self, _: &Impact) {}
}

impl Gap {
    /// A piece of the motion of the left neighbour (side 0) or of the right one; and of the other where that is a wall.
    fn follow(&mut self, side: usize, piece: Cubic, wall: Option<Cubic>) {
        let signed = |piece: Cubic| if side == 0 { piece } else { piece.mirrored() };
        if let Some(wall) = wall {
            return self.take(signed(piece.less(wall)));
        }
        self.ahead[side].push_back(piece);
        while let [Some(left), Some(right)] =
            self.ahead.each_ref().map(|ahead| ahead.front().copied())
        {
            let end = left.end.time.min(right.end.time);
            self.take(left.until(end).less(right.until(end)));
            for (ahead, piece) in self.ahead.iter_mut().zip([left, right]) {
                ahead.pop_front();
                if piece.end.time > end {
                    ahead.push_front(piece.from(end));
                }
            }
        }
    }

    /// Takes the largest value of a closing that is a cubic.
    fn take(&mut self, closing: Cubic) {
        // Not above its control points, so that most pieces are left at once.
        let known = self.largest.map_or(f64::NEG_INFINITY, |one| one.distance);
        if closing.controls().iter().all(|height| *height <= known) {
            return;
        }
        let (distance, time) = closing.highest();
        if distance > known {
            self.largest = Some(Closing { distance, time });
        }
    }
}

impl Node {
    fn new(time: f64, motion: Motion) -> Self {
        Self {
            time,
            displacement: motion.displacement,
            velocity: motion.velocity,
        }
    }
}

impl Cubic {
    /// The ground of a node over the same interval.
    fn of_ground(self, node: usize, travel: Option<&Travel>) -> Self {
        let at = |time: f64| {
            let ground = travel.map_or_else(Motion::default, |travel| travel.ground(node, time));
            Node::new(time, ground)
        };
        Self {
            start: at(self.start.time),
            end: at(self.end.time),
        }
    }

    fn duration(&self) -> f64 {
        self.end.time - self.start.time
    }

    /// Coefficients of 1, s, s² and s³ with s from 0 at the start to 1 at the end.
    fn coefficients(&self) -> [f64; 4] {
        let h = self.duration();
        let (first, last) = (self.start.velocity * h, self.end.velocity * h);
        let rise = self.end.displacement - self.start.displacement;
        [
            self.start.displacement,
            first,
            3.0 * rise - 2.0 * first - last,
            first + last - 2.0 * rise,
        ]
    }

    fn at(&self, time: f64) -> Node {
        let h = self.duration();
        let s = (time - self.start.time) / h;
        let [u, a, b, c] = self.coefficients();
        Node {
            time,
            displacement: u + s * (a + s * (b + s * c)),
            velocity: (a + s * (2.0 * b + 3.0 * s * c)) / h,
        }
    }

    /// The part up to an instant, which is not before its start.
    fn until(self, time: f64) -> Self {
        if time < self.end.time {
            Self {
                end: self.at(time),
                ..self
            }
        } else {
            self
        }
    }

    /// The part from an instant before its end on.
    fn from(self, time: f64) -> Self {
        Self {
            start: self.at(time),
            ..self
        }
    }

    fn mirrored(self) -> Self {
        let mirrored = |node: Node| Node {
            displacement: -node.displacement,
            velocity: -node.velocity,
            ..node
        };
        Self {
            start: mirrored(self.start),
            end: mirrored(self.end),
        }
    }

    /// The difference of two cubics over one interval.
    fn less(self, other: Self) -> Self {
        let less = |one: Node, other: Node| Node {
            time: one.time,
            displacement: one.displacement - other.displacement,
            velocity: one.velocity - other.velocity,
        };
        Self {
            start: less(self.start, other.start),
            end: less(self.end, other.end),
        }
    }

    /// Heights between which it stays: those of its Bézier points.
    fn controls(&self) -> [f64; 4] {
        let third = self.duration() / 3.0;
        let (start, end) = (&self.start, &self.end);
        [
            start.displacement,
            start.displacement + third * start.velocity,
            end.displacement - third * end.velocity,
            end.displacement,
        ]
    }

    /// Its largest value and where it is first.
    fn highest(&self) -> (f64, f64) {
        let [u, a, b, c] = self.coefficients();
        // Slope a + 2bs + 3cs²; without a root where it does not change its sign. A root that is no number, of b = 0 and
        // c = 0 or a = 0, is not between 0 and 1.
        let root = (b * b - 3.0 * a * c).sqrt();
        let sum = -(b + root.copysign(b));
        let mut highest = (self.start.displacement, self.start.time);
        let between = [sum / (3.0 * c), a / sum].into_iter();
        for s in between.filter(|s| *s > 0.0 && *s < 1.0) {
            let height = u + s * (a + s * (b + s * c));
            if height > highest.0 {
                highest = (height, self.start.time + s * self.duration());
            }
        }
        if self.end.displacement > highest.0 {
            highest = (self.end.displacement, self.end.time);
        }
        highest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Weighed;

    /// A cubic path between two instants, as a step of a stepping method.
    fn step(structure: usize, times: [f64; 2], path: fn(f64) -> (f64, f64)) -> Span<'static> {
        let [start, end] = times.map(|time| {
            let (displacement, velocity) = path(time);
            State {
                displacement,
                velocity,
                ..State::default()
            }
        });
        Span {
            structure,
            start_time: times[0],
            end_time: times[1],
            start,
            end,
            impulse_from_left: 0.0,
            impulse_from_right: 0.0,
            below: None,
            path: Path::Cubic(Weighed::default()),
        }
    }

    /// t³ − 3t² + 2t has its maximum 2√3/9 at 1 − 1/√3; what goes the other way adds 0.5 t.
    fn left(t: f64) -> (f64, f64) {
        (t * (2.0 + t * (t - 3.0)), 2.0 + t * (3.0 * t - 6.0))
    }

    fn right(t: f64) -> (f64, f64) {
        (-0.5 * t, -0.5)
    }

    #[test]
    fn reference_the_largest_closing_of_two_cubics_whose_ends_differ() {
        let mut closings = Closings::new(vec![false, false], 1.0);
        // The left neighbour is ahead of the right one, then behind it.
        closings.span(&step(0, [0.0, 1.25], left));
        assert_eq!(closings.of(0), None, "nothing is known of the right one");
        for times in [[0.0, 0.5], [0.5, 0.75], [0.75, 1.5]] {
            closings.span(&step(1, times, right));
        }
        closings.span(&step(0, [1.25, 1.5], left));
        let found = closings.of(0).expect("both moved");
        // 3t² − 6t + 2.5 = 0.
        let time = 1.0 - (1.0_f64 / 6.0).sqrt();
        let wanted = left(time).0 - right(time).0;
        assert!((found.time - time).abs() < 1e-15, "{found:?}");
        assert!((found.distance - wanted).abs() < 1e-15, "{found:?}");
        assert!(closings.gaps[0].ahead.iter().all(VecDeque::is_empty));
    }

    #[test]
    fn limit_a_wall_is_a_neighbour_that_does_not_move() {
        let rest = |_| (0.0, 0.0);
        for mirror in [false, true] {
            let mut beside_wall = Closings::new(vec![mirror, !mirror], 1.0);
            let mut beside_rest = Closings::new(vec![false, false], 1.0);
            let moving = usize::from(mirror);
            let times = [0.0, 2.0];
            beside_wall.span(&step(moving, times, left));
            beside_rest.span(&step(moving, times, left));
            beside_rest.span(&step(1 - moving, times, rest));
            assert_eq!(beside_wall.of(0), beside_rest.of(0), "{mirror}");
            // The least of t³ − 3t² + 2t is that far below 0 at 1 + 1/√3.
            let wanted = 2.0 * 3.0_f64.sqrt() / 9.0;
            let found = beside_wall.of(0).expect("it moved").distance;
            assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
        }
        assert_eq!(Closings::new(vec![true, true], 1.0).of(0), None);
    }

    /// Apart from the start on, and further.
    #[test]
    fn extreme_neighbours_that_never_come_near() {
        let mut closings = Closings::new(vec![false, false], 1.0);
        closings.span(&step(0, [0.0, 1.0], |t| (-1.0 - t, -1.0)));
        closings.span(&step(1, [0.0, 1.0], |t| (t, 1.0)));
        let wanted = Closing {
            distance: -1.0,
            time: 0.0,
        };
        assert_eq!(closings.of(0), Some(wanted));
    }
}
