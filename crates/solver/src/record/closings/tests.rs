//! Closings and openings of known motions.

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

/// A widening has a first instant beyond a seat: 0.5 t less t³ − 3t² + 2t, of both motions of this module, exceeds 0.3.
#[test]
fn reference_the_first_instant_beyond_a_seat() {
    let seat = 0.3;
    let follow = |closings: Closings| {
        let mut closings = closings;
        // The right neighbour moves away: it is the left one mirrored.
        for (structure, path) in [(1, left as fn(f64) -> (f64, f64)), (0, right)] {
            for times in [[0.0, 0.25], [0.25, 0.75], [0.75, 1.5]] {
                closings.span(&step(structure, times, path));
            }
        }
        closings
    };
    let new = || Closings::new(vec![false, false], 1.0).both_ways();
    let found = follow(new().seated([(0, seat)])).widening(0).expect("both moved");
    let away = |t: f64| left(t).0 - right(t).0;
    // Its largest value is at the smaller root of 3t² − 6t + 2.5 = 0, as in the closing of the same motions.
    let time = 1.0 - (1.0_f64 / 6.0).sqrt();
    assert!(
        (found.time - time).abs() < 1e-15 && (found.distance - away(time)).abs() < 1e-15,
        "{found:?}"
    );
    let first = found.unseated.expect("it leaves its seat");
    assert!(first < 0.25 && (away(first) - seat).abs() < 1e-15, "{found:?}");
    let wide = follow(new().seated([(0, 2.0)])).widening(0).expect("both moved");
    assert_eq!((wide.unseated, wide.distance), (None, found.distance));
    // Without a seat there is no such instant, and without the request no widening.
    assert_eq!(follow(new()).widening(0).expect("both moved").unseated, None);
    assert_eq!(follow(Closings::new(vec![false, false], 1.0)).widening(0), None);
}
