//! The ledger of a motion known between its nodes: a building of two storeys as power series, computed here.

use super::*;
use crate::span::{Motion, Power, Series};
use crate::{Elastic, Floor, Node, Row, State};

const N: usize = 24;
const MASSES: [f64; 2] = [2e5, 1e5];
const STIFFNESSES: [f64; 2] = [3e7, 2e7];
/// Rayleigh damping, α \[1/s\] and β \[s\].
const DAMPING: (f64, f64) = (0.3, 2e-3);
/// A binary fraction of a sample: the pieces end exactly at samples.
const TIME_STEP: f64 = 0.015_625;

/// Coefficients of displacement, velocity and acceleration of a floor.
type Motions = [[f64; N]; 3];

/// Term that the method omits.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fault {
    Nothing,
    /// The upper storey does not push the lower floor back.
    Reaction,
    /// The upper floor is not damped against the ground.
    GroundDamping,
}

fn row() -> Row<Elastic> {
    let storey = |index: usize| {
        let stiffness = STIFFNESSES[index];
        Node::structure(MASSES[index], DAMPING.1 * stiffness, Elastic { stiffness })
    };
    let mut first = storey(0);
    first.damping += DAMPING.0 * MASSES[0];
    first.initial_displacement = 0.01;
    let mut second = storey(1).on_floor(Floor {
        below: 0,
        ground_damping: DAMPING.0 * MASSES[1],
    });
    (second.initial_displacement, second.initial_velocity) = (-0.005, 0.3);
    Row::new(vec![first, second], vec![]).unwrap()
}

/// The motion from these states, under a ground acceleration with a value and a slope.
fn expand(starts: [Motion; 2], ground: (f64, f64), fault: Fault) -> [Motions; 2] {
    let mut floors = [[[0.0; N]; 3]; 2];
    for (floor, start) in floors.iter_mut().zip(starts) {
        (floor[0][0], floor[1][0]) = (start.displacement, start.velocity);
        floor[0][1] = start.velocity;
    }
    for n in 0..N - 2 {
        let own = |index: usize| {
            let drift = |kind: usize| {
                let below = if index == 0 { 0.0 } else { floors[0][kind][n] };
                floors[index][kind][n] - below
            };
            STIFFNESSES[index] * (drift(0) + DAMPING.1 * drift(1))
        };
        let storeys = [own(0), own(1)];
        let ground = [ground.0, ground.1].get(n).copied().unwrap_or(0.0);
        let order = (n + 1) as f64;
        for (index, floor) in floors.iter_mut().enumerate() {
            let damped = fault != Fault::GroundDamping || index == 0;
            let outside = if damped { DAMPING.0 * floor[1][n] } else { 0.0 };
            let reaction = if index == 0 && fault != Fault::Reaction { storeys[1] } else { 0.0 };
            let acceleration = (reaction - storeys[index]) / MASSES[index] - outside - ground;
            floor[2][n] = acceleration;
            floor[1][n + 1] = acceleration / order;
            floor[0][n + 2] = floor[1][n + 1] / (order + 1.0);
        }
    }
    floors
}

/// Books a second of that motion. Returns its own two balances, the physical balance, and the terms.
fn book(fault: Fault) -> ([f64; 3], Terms) {
    let samples = [1.0, -2.0, 0.5, 3.0, -1.0, 0.0];
    let excitation = Excitation::new(0.25, &samples).unwrap();
    let row = row();
    let mut ledger = Ledger::new(&row, excitation);
    let mut starts = [0, 1].map(|index| {
        let node = &row.nodes()[index];
        Motion {
            displacement: node.initial_displacement,
            velocity: node.initial_velocity,
        }
    });
    let mut start_time = 0.0;
    for step in 1..=64_u32 {
        let end_time = TIME_STEP * f64::from(step);
        let segment = excitation.segment(start_time, 0.0);
        let floors = expand(starts, (segment.value, segment.slope), fault);
        starts = report(&mut ledger, &floors, start_time, end_time);
        start_time = end_time;
    }
    let balances = [ledger.identity(), ledger.momentum(), ledger.residual()];
    (balances, ledger.verdict().unwrap())
}

/// Reports the spans of both floors; returns their motions at the end.
fn report(ledger: &mut Ledger<'_>, floors: &[Motions; 2], start_time: f64, end_time: f64) -> [Motion; 2] {
    let span = |index: usize| {
        let [displacement, velocity, acceleration] = &floors[index];
        let below = (index == 1).then_some([&floors[0][0][..], &floors[0][1][..]]);
        let drift = displacement[0] - below.map_or(0.0, |[below, _]| below[0]);
        let stiffness = STIFFNESSES[index];
        let mut span = Span {
            structure: index,
            start_time,
            end_time,
            start: State::default(),
            end: State::default(),
            impulse_from_left: 0.0,
            impulse_from_right: 0.0,
            below: None,
            pushes: &[],
            links: &[],
            path: Path::Series(Series {
                origin: start_time,
                power: Power::One,
                end: f64::INFINITY,
                displacement,
                velocity,
                acceleration,
                below,
                restoring_force: (stiffness * drift, stiffness),
                bent: &[],
                force_from_left: &[],
                force_from_right: &[],
            }),
        };
        (span.start, span.end) = (span.at(start_time), span.at(end_time));
        span
    };
    let (lower, upper) = (span(0), span(1));
    let ends = |state: fn(&Span<'_>) -> State| Motion::from(&state(&lower));
    let below = [ends(|span| span.start), ends(|span| span.end)];
    let upper = Span {
        below: Some(below),
        ..upper
    };
    ledger.span(&lower);
    ledger.span(&upper);
    [below[1], (&upper.end).into()]
}

#[test]
fn reference_a_motion_known_between_its_nodes_balances_by_storeys() {
    let (balances, terms) = book(Fault::Nothing);
    for balance in balances {
        assert!(balance < 1e-14, "{balances:?}");
    }
    let first = 0.5 * 1e5 * 0.3 * 0.3;
    let strain = 0.5 * 3e7 * 0.01 * 0.01 + 0.5 * 2e7 * 0.015 * 0.015;
    assert!((terms.initial - first - strain).abs() < 1e-9, "{terms:?}");
    assert!(terms.damping > 0.1 * terms.initial, "{terms:?}");
}

#[test]
fn limit_a_storey_that_does_not_push_the_floor_below_back_is_found() {
    let ([identity, momentum, residual], _) = book(Fault::Reaction);
    let shows = identity > 1e-3 && momentum > 1e-3 && residual > 1e-3;
    assert!(shows, "{identity:e}, {momentum:e}, {residual:e}");
}

#[test]
fn limit_damping_against_the_ground_that_does_not_act_is_found() {
    let ([identity, momentum, residual], _) = book(Fault::GroundDamping);
    let shows = identity > 1e-4 && momentum > 1e-4 && residual > 1e-4;
    assert!(shows, "{identity:e}, {momentum:e}, {residual:e}");
}
