//! Neighbours that come to rest against each other.

use libm::sin;
use pounding_solver::{Bilinear, Elastic, Hysteretic, Levels, Node, Pair, Row};

use super::exact::agree;
use super::storeys::{ALPHA, BETA, TOWERS, buildings, elastic, ground};
use super::{FREE, close, moving, pairs, run, stereomechanical};

/// A ball of unit mass that falls towards a floor 1 m below.
fn ball(restitution: f64) -> Row<Elastic> {
    let nodes = vec![moving(1.0, 0.0, FREE), Node::wall(FREE)];
    Row::new(nodes, pairs(2, 1.0, stereomechanical(restitution))).expect("a valid row")
}

#[test]
fn reference_bouncing_ball() {
    let (gravity, restitution) = (9.81_f64, 0.8);
    let response = run(&ball(restitution), &[-gravity; 42], 4.0);
    let first = (2.0 / gravity).sqrt();
    let speed = gravity * first;
    // Flight n lasts 2 eⁿ times the first fall; the end is shortly before the ball rests at 4.06 s.
    let (mut time, mut factor) = (first, 1.0);
    let mut wanted = Vec::new();
    while time < 4.0 {
        wanted.push((time, (1.0 + restitution) * speed * factor));
        factor *= restitution;
        time += 2.0 * first * factor;
    }
    let found = &response.collisions[0];
    assert_eq!(found.len(), wanted.len(), "number of impacts");
    for (collision, (time, impulse)) in found.iter().zip(wanted) {
        close(collision.start, time, 1e-14, "time of an impact");
        close(collision.impulse, impulse, 1e-13, "its impulse");
    }
    let total: f64 = found.iter().map(|collision| collision.impulse).sum();
    close(response.structures[0].transferred_momentum, total, 1e-15, "transferred momentum");
}

#[test]
fn reference_a_ball_at_rest() {
    let (gravity, restitution) = (9.81_f64, 0.8);
    let response = run(&ball(restitution), &[-gravity; 62], 6.0);
    let found = &response.collisions[0];
    // The last impact and the rest after it are a single collision.
    let rest = found.last().expect("collisions");
    let over = (2.0 / gravity).sqrt() * (1.0 + restitution) / (1.0 - restitution);
    let early = over - rest.start;
    assert!((0.0..2e-12).contains(&early), "end of the bounces: {early:e}");
    close(rest.end, 6.0, 0.0, "end of the run");
    assert!(found.iter().all(|impact| impact.peak_force.is_none()));
    // Bounces end once the remainder takes less than 1e-12 s: over · eⁿ.
    let n = found.len() as f64;
    let wanted = libm::log(1e-12 / over) / libm::log(restitution);
    assert!((n - wanted).abs() < 2.0, "{n} impacts, {wanted}");
    // In the end it has neither fallen nor risen.
    let impulse: f64 = found.iter().map(|collision| collision.impulse).sum();
    close(impulse, gravity * 6.0, 1e-14, "impulse");
    let ball = response.structures[0];
    close(ball.transferred_momentum, impulse, 1e-14, "momentum");
    close(ball.end_displacement, 1.0, 1e-14, "the floor");
    assert!(ball.end_velocity == 0.0, "{}", ball.end_velocity);
}

/// The left of two neighbours without a gap hits the right one, and they swing together for half a period.
#[test]
fn reference_two_structures_swing_together() {
    let (masses, stiffnesses, speed) = ([3e5, 1e5], [4e7, 6e7], 0.3_f64);
    let nodes = vec![
        moving(masses[0], speed, Elastic { stiffness: stiffnesses[0] }),
        moving(masses[1], 0.0, Elastic { stiffness: stiffnesses[1] }),
    ];
    let row = Row::new(nodes, pairs(2, 0.0, stereomechanical(0.0))).expect("a valid row");
    let mass = masses[0] + masses[1];
    let common = speed * masses[0] / mass;
    let omega = ((stiffnesses[0] + stiffnesses[1]) / mass).sqrt();
    let half = std::f64::consts::PI / omega;
    // Their force slows the stiffer structure down to the common period.
    let press = (masses[0] * stiffnesses[1] - masses[1] * stiffnesses[0]) / mass * common / omega;
    let response = run(&row, &[0.0], half + 0.01);
    let [met] = response.collisions[0][..] else {
        panic!("{:?}", response.collisions);
    };
    assert!(met.start < 1e-15, "at once");
    close(met.end, half, 1e-13, "parting");
    let impulse = masses[1] * common + press * 2.0 / omega;
    close(met.impulse, impulse, 1e-13, "impact and pressing");
    for (index, structure) in response.structures.iter().enumerate() {
        let peak = structure.displacement;
        close(peak.value, common / omega, 1e-14, "peak");
        close(peak.time, 0.5 * half, 1e-12, "its time");
        // Both swing on alone.
        let alone = (stiffnesses[index] / masses[index]).sqrt();
        let end = -common / alone * sin(alone * 0.01);
        close(structure.end_displacement, end, 1e-12, "end");
    }
}

/// Neighbours without a gap begin with a common velocity. The right one is stiffer by a ten-thousandth than the stiffness for equal swings,
/// so that they press slightly.
#[test]
fn reference_the_peak_of_a_slight_force_at_rest() {
    let (masses, stiffnesses, speed) = ([3e5, 1e5], [4e7, 4e7 / 3.0 * 1.0001], 0.3_f64);
    let node = |index: usize| {
        let stiffness = stiffnesses[index];
        moving(masses[index], speed, Elastic { stiffness })
    };
    let pairs = pairs(2, 0.0, stereomechanical(0.0));
    let row = Row::new(vec![node(0), node(1)], pairs).expect("a valid row");
    let mass = masses[0] + masses[1];
    let omega = ((stiffnesses[0] + stiffnesses[1]) / mass).sqrt();
    let press = (masses[0] * stiffnesses[1] - masses[1] * stiffnesses[0]) / mass * speed / omega;
    let response = run(&row, &[0.0], 3.0 / omega);
    let [met] = response.collisions[0][..] else {
        panic!("{:?}", response.collisions);
    };
    let peak = met.peak_force.expect("no impact");
    close(peak, press, 1e-11, "a quarter of a period after the start");
}

/// Columns that yield at a force of `yields` metres times their stiffness.
fn structure(mass: f64, period: f64, yields: f64) -> Node<Bilinear> {
    let omega = 2.0 * std::f64::consts::PI / period;
    let stiffness = mass * omega * omega;
    let column = Bilinear {
        stiffness,
        yield_force: yields * stiffness,
        hardening: 0.0,
    };
    Node::structure(mass, 0.1 * omega * mass, column)
}

fn wall() -> Node<Bilinear> {
    Node::wall(Bilinear {
        stiffness: 1.0,
        yield_force: 1.0,
        hardening: 0.0,
    })
}

fn chain() -> Vec<Node<Bilinear>> {
    vec![
        structure(1e5, 0.8, 0.05),
        structure(3e5, 0.3, 0.02),
        structure(2e5, 0.5, f64::INFINITY),
    ]
}

/// Pairs of all neighbours, each with its gap and restitution.
fn contacts(of: &[(f64, f64)]) -> Vec<Pair> {
    let pair = |(left, &(gap, restitution)): (usize, &(f64, f64))| Pair::of_floors(left, left + 1, gap, stereomechanical(restitution));
    of.iter().enumerate().map(pair).collect()
}

/// Asserts that both routes agree and that `n_resting` pairs press at rest.
#[track_caller]
fn agree_at_rest<Column: Hysteretic>(row: &Row<Column>, n_resting: usize, what: &str) {
    let met = agree(row, 4.0, what);
    let resting = met.iter().filter(|pair| pair.touching > 0.0).count();
    assert_eq!(resting, n_resting, "{what}: {met:?}");
}

#[test]
fn reference_two_structures_stick_together() {
    for (gap, restitution) in [(0.01, 0.0), (0.0, 0.0)] {
        let row = Row::new(chain()[..2].to_vec(), contacts(&[(gap, restitution)]));
        let what = format!("{gap} m, {restitution}");
        agree_at_rest(&row.expect("a valid row"), 1, &what);
    }
}

#[test]
fn reference_a_chain_of_three_sticks_together() {
    let row = Row::new(chain(), contacts(&[(0.01, 0.0), (0.005, 0.0)]));
    agree_at_rest(&row.expect("a valid row"), 2, "three");
}

#[test]
fn reference_a_structure_between_walls_rests_on_both() {
    let nodes = vec![wall(), structure(1e5, 0.5, 0.02), wall()];
    for restitution in [0.0, 0.4] {
        let of = contacts(&[(0.003, restitution), (0.005, restitution)]);
        let row = Row::new(nodes.clone(), of).expect("a valid row");
        agree_at_rest(&row, 2, &format!("{restitution}"));
    }
}

/// A structure between walls without gaps. Each route decides freely between its forces: together the walls carry the whole push of the
/// ground.
#[test]
fn limit_an_enclosed_structure_does_not_move() {
    let nodes = vec![wall(), structure(1e5, 0.5, 0.02), wall()];
    let row = Row::new(nodes, contacts(&[(0.0, 0.0), (0.0, 0.5)])).expect("a valid row");
    let samples = ground();
    let response = run(&row, &samples, 6.0);
    let enclosed = response.structures[1];
    assert!(enclosed.displacement.value.abs() < 1e-15, "{enclosed:?}");
    let largest = samples.iter().map(|sample| sample.abs()).fold(0.0, f64::max);
    let forces = response.collisions.iter().flatten();
    let force = forces.filter_map(|one| one.peak_force).fold(0.0, f64::max);
    close(force, 1e5 * largest, 1e-12, "largest force");
}

#[test]
fn reference_towers_rest_on_several_levels() {
    for restitution in [0.0, 0.5] {
        let of = TOWERS.map(elastic);
        let law = stereomechanical(restitution);
        let row = buildings(&of[..2], (ALPHA, BETA), (0.004, law));
        agree_at_rest(&row, 2, &format!("{restitution}"));
    }
}

/// Neighbours at rest with different grounds share their absolute motion.
#[test]
fn reference_neighbours_at_rest_are_shaken_in_turn() {
    let row = Row::new(chain(), contacts(&[(0.01, 0.0), (0.005, 0.0)])).expect("a valid row");
    let row = row.delayed(vec![0.0, 0.07, 0.15]).expect("valid arrivals");
    agree_at_rest(&row, 2, "three");
    let of = TOWERS.map(elastic);
    let row: Row<Elastic> = buildings(&of[..2], (ALPHA, BETA), (0.004, stereomechanical(0.0)));
    let levels = Levels::new(&[TOWERS[0].len(), TOWERS[1].len()]);
    let arrival = |node: usize| [0.0, 0.06][levels.place(node).0];
    let arrivals = (0..levels.n_nodes()).map(arrival).collect();
    let row = row.delayed(arrivals).expect("valid arrivals");
    agree_at_rest(&row, 2, "towers");
}
