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
    /// The gaps under the mirrored shaking; empty unless requested.
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

    /// Also records the closings under the mirrored shaking. The row must mirror its motion under mirrored shaking: nothing touches,
    /// columns have no preferred direction, and the run begins at rest.
    #[must_use]
    pub fn both_ways(self) -> Self {
        let reversed = self.gaps.iter().map(Gap::reversed).collect();
        Self { reversed, ..self }
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
mod tests {
    use std::collections::VecDeque;

    use super::*;
    use crate::Weighed;
    use crate::span::{Power, Series};

    /// A cubic path between two instants, like a step of a stepping method.
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
            pushes: &[],
            links: &[],
        }
    }

    /// t³ − 3t² + 2t has its maximum 2√3/9 at 1 − 1/√3; the opposite motion adds 0.5 t.
    fn left(t: f64) -> (f64, f64) {
        (t * (2.0 + t * (t - 3.0)), 2.0 + t * (3.0 * t - 6.0))
    }

    fn right(t: f64) -> (f64, f64) {
        (-0.5 * t, -0.5)
    }

    #[test]
    fn reference_the_largest_closing_of_two_cubics_whose_ends_differ() {
        let mut closings = Closings::new(vec![false, false], 1.0);
        // The left neighbour is ahead of the right neighbour, then behind it.
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

    /// Taylor series of sin ωt and its rate about an instant.
    fn sine(omega: f64, from: f64) -> [[f64; 20]; 2] {
        let (sine, cosine) = (libm::sin(omega * from), libm::cos(omega * from));
        let mut terms = [[0.0; 20]; 2];
        // Derivatives of order n are ωⁿ times these; divided by n!.
        let (cycle, mut scale) = ([sine, cosine, -sine, -cosine], 1.0);
        for n in 0..20 {
            terms[0][n] = scale * cycle[n % 4];
            terms[1][n] = scale * omega * cycle[(n + 1) % 4];
            scale *= omega / (n + 1) as f64;
        }
        terms
    }

    /// sin t ahead of sin 1.3 t, in different pieces, next to each other and to a wall. A skipped piece never has the largest value, and
    /// the result is exact to rounding.
    #[test]
    fn reference_series_are_looked_at_where_they_matter() {
        let mut closings = Closings::new(vec![true, false, false], 0.01);
        let mut follow = |node: usize, omega: f64, step: f64| {
            let mut from = 0.0;
            while from < 12.0 {
                let [displacement, velocity] = sine(omega, from);
                let to = from + step;
                let state = |t: f64| State {
                    displacement: libm::sin(omega * t),
                    velocity: omega * libm::cos(omega * t),
                    ..State::default()
                };
                closings.span(&Span {
                    path: Path::Series(Series {
                        origin: from,
                        power: Power::One,
                        end: step,
                        displacement: &displacement,
                        velocity: &velocity,
                        acceleration: &[],
                        below: None,
                        restoring_force: (0.0, 0.0),
                        bent: &[],
                        force_from_left: &[],
                        force_from_right: &[],
                    }),
                    start: state(from),
                    end: state(to),
                    ..step_of(node, [from, to])
                });
                from = to;
            }
        };
        follow(1, 1.0, 0.5);
        follow(2, 1.3, 0.375);
        let ahead = |t: f64| libm::sin(t) - libm::sin(1.3 * t);
        let looked = (0..1_200_000).map(|look| ahead(1e-5 * f64::from(look)));
        let wanted = looked.fold(0.0, f64::max);
        let found = closings.of(1).expect("both moved");
        // The error is up to 1e-10 below the maximum between looks; cubics leave out 1e-12 of the terms of both.
        let above = found.distance - wanted;
        assert!((-5e-12..1e-10).contains(&above), "{found:?} {wanted}");
        let there = ahead(found.time);
        assert!((there - found.distance).abs() < 5e-12, "{found:?} {there}");
        // The wall on the left: the least of sin t is −1.
        let wall = closings.of(0).expect("it moved");
        assert!((wall.distance - 1.0).abs() < 1e-12, "{wall:?}");
        assert!((libm::sin(wall.time) + 1.0).abs() < 1e-12, "{wall:?}");
    }

    /// Required gaps over travelling ground were too small by up to 1e-7. A motion was looked at 200 times per period, and the ground of a
    /// wall was taken for a cubic across its samples. A structure that moves as sin 5t over ground under a sawtooth must close the gap to a
    /// wall as far as half a million looks show.
    #[test]
    fn issue_ground_that_travels_is_known_as_well_as_other_ground() {
        let samples: Vec<f64> = (0..61).map(|index| f64::from(index % 7) - 3.0).collect();
        let excitation = crate::Excitation::new(0.05, &samples).expect("it is sound");
        let travel = Travel::new(excitation, vec![0.0, 0.033]);
        let mut closings = Closings::new(vec![false, true], 0.01).travelled(Some(travel.clone()));
        let omega = 5.0;
        for index in 0..60 {
            let [from, to] = [index, index + 1].map(|index| 0.05 * f64::from(index));
            let [displacement, velocity] = sine(omega, from);
            let state = |t: f64| State {
                displacement: libm::sin(omega * t),
                velocity: omega * libm::cos(omega * t),
                ..State::default()
            };
            closings.span(&Span {
                path: Path::Series(Series {
                    origin: from,
                    power: Power::One,
                    end: to - from,
                    displacement: &displacement,
                    velocity: &velocity,
                    acceleration: &[],
                    below: None,
                    restoring_force: (0.0, 0.0),
                    bent: &[],
                    force_from_left: &[],
                    force_from_right: &[],
                }),
                start: state(from),
                end: state(to),
                ..step_of(0, [from, to])
            });
        }
        let ahead = |t: f64| libm::sin(omega * t) + travel.opening([0, 1], t).displacement;
        let looked = (0..500_000).map(|look| ahead(6e-6 * f64::from(look)));
        let wanted = looked.fold(0.0, f64::max);
        let found = closings.of(0).expect("it moved");
        // The looks are up to 2e-10 below the maximum between them.
        assert!((-1e-12..2e-10).contains(&(found.distance - wanted)), "{found:?} {wanted}");
        let there = ahead(found.time);
        assert!((there - found.distance).abs() < 1e-12, "{found:?} {there}");
    }

    /// A span at rest.
    fn step_of(node: usize, times: [f64; 2]) -> Span<'static> {
        step(node, times, |_| (0.0, 0.0))
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
            // The minimum of t³ − 3t² + 2t is this far below 0, at 1 + 1/√3.
            let wanted = 2.0 * 3.0_f64.sqrt() / 9.0;
            let found = beside_wall.of(0).expect("it moved").distance;
            assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
        }
        assert_eq!(Closings::new(vec![true, true], 1.0).of(0), None);
    }

    /// Mirrored shaking closes a gap exactly as far as the original shaking opens it.
    #[test]
    fn limit_both_ways_are_those_of_either() {
        let all = |sign: f64, closings: Closings| {
            let mut closings = closings;
            for (structure, path) in [(0, left as fn(f64) -> (f64, f64)), (1, right)] {
                for times in [[0.0, 0.7], [0.7, 1.1], [1.1, 1.8]] {
                    let mut span = step(structure, times, path);
                    for end in [&mut span.start, &mut span.end] {
                        end.displacement *= sign;
                        end.velocity *= sign;
                    }
                    closings.span(&span);
                }
            }
            closings
        };
        for walls in [[false, false], [true, false], [false, true]] {
            let new = || Closings::new(walls.to_vec(), 1.0);
            let both = all(1.0, new().both_ways());
            assert_eq!(both.of(0), all(1.0, new()).of(0));
            assert_eq!(both.of_reversed(0), all(-1.0, new()).of(0));
            assert_eq!(all(1.0, new()).of_reversed(0), None);
        }
    }

    /// Neighbours that are apart at the start and move further apart.
    #[test]
    fn extreme_neighbours_that_never_come_near() {
        let mut closings = Closings::new(vec![false, false], 1.0);
        closings.span(&step(0, [0.0, 1.0], |t| (-1.0 - t, -1.0)));
        closings.span(&step(1, [0.0, 1.0], |t| (t, 1.0)));
        let wanted = Closing { distance: -1.0, time: 0.0 };
        assert_eq!(closings.of(0), Some(wanted));
    }
}
