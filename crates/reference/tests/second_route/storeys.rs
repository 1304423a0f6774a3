//! Buildings of several storeys.

use libm::{cos, exp, sin};
use pounding_contact::{ContactLaw, LinearSpring};
use pounding_reference::Response;
use pounding_solver::{Elastic, Floor, Hysteretic, Levels, Node, Pair, Row, Storey};

use super::{close, pairs, run, stereomechanical, viscoelastic};

/// Rayleigh damping of the storeys: αm against the ground and βk in the storey.
pub(super) const ALPHA: f64 = 0.4;
pub(super) const BETA: f64 = 0.002;

/// A building from the ground up: mass \[kg\] and columns of each storey.
pub(super) type Building<Column> = Vec<(f64, Column)>;

pub(super) fn spring(impact_stiffness: f64) -> ContactLaw {
    ContactLaw::LinearSpring(LinearSpring { impact_stiffness })
}

/// Neighbouring buildings with damping α and β; floors that face each other are pairs.
pub(super) fn buildings<Column: Hysteretic>(
    of: &[Building<Column>],
    (alpha, beta): (f64, f64),
    (gap, law): (f64, ContactLaw),
) -> Row<Column> {
    let counts: Vec<_> = of.iter().map(Vec::len).collect();
    let levels = Levels::new(&counts);
    let floor = |node: usize| {
        let (building, storey) = levels.place(node);
        let (mass, column) = of[building][storey];
        levels.floor(
            node,
            Storey {
                mass,
                damping: beta * column.stiffness(),
                ground_damping: alpha * mass,
                column,
            },
        )
    };
    let nodes = (0..levels.n_nodes()).map(floor).collect();
    let facing = (1..of.len()).flat_map(|right| levels.facing(right - 1).collect::<Vec<_>>());
    let mut pairs: Vec<_> = facing.map(|(left, right)| Pair::of_floors(left, right, gap, law)).collect();
    pairs.sort_by_key(Pair::left);
    Row::new(nodes, pairs).expect("a valid row")
}

pub(super) fn elastic(of: &[(f64, f64)]) -> Building<Elastic> {
    let storey = |&(mass, stiffness): &(f64, f64)| (mass, Elastic { stiffness });
    of.iter().map(storey).collect()
}

/// Buildings of three, two and three storeys.
pub(super) const TOWERS: [&[(f64, f64)]; 3] = [
    &[(1e5, 6e7), (1e5, 5e7), (8e4, 4e7)],
    &[(3e5, 9e8), (2e5, 6e8)],
    &[(1.5e5, 9e7), (1.2e5, 7e7), (5e4, 2e7)],
];

/// Strong shaking, sampled every 0.1 s.
pub(super) fn ground() -> Vec<f64> {
    let acceleration = |t: f64| 3.0 * sin(5.1 * t) + 2.0 * sin(9.7 * t + 1.0) + 1.5 * cos(21.3 * t);
    (0..=60).map(|i| acceleration(0.1 * f64::from(i))).collect()
}

/// A mode: circular frequency, damping ratio, shape, and participation in the ground's acceleration.
struct Mode {
    omega: f64,
    zeta: f64,
    shape: [f64; 2],
    participation: f64,
}

/// Modes of two storeys: ω⁴ m₁m₂ − ω² ((k₁ + k₂) m₂ + k₂ m₁) + k₁k₂ = 0.
fn modes([m1, m2]: [f64; 2], [k1, k2]: [f64; 2]) -> [Mode; 2] {
    let (a, b, c) = (m1 * m2, (k1 + k2) * m2 + k2 * m1, k1 * k2);
    let high = (b + (b * b - 4.0 * a * c).sqrt()) / (2.0 * a);
    [c / (a * high), high].map(|square| {
        let omega = square.sqrt();
        let shape = [1.0, k2 / (k2 - m2 * square)];
        let mass = m1 * shape[0] * shape[0] + m2 * shape[1] * shape[1];
        Mode {
            omega,
            zeta: 0.5 * (ALPHA / omega + BETA * omega),
            shape,
            participation: (m1 * shape[0] + m2 * shape[1]) / mass,
        }
    })
}

impl Mode {
    /// Displacement and velocity after a time t of ground acceleration a + b t.
    fn after(&self, (u, v): (f64, f64), [a, b]: [f64; 2], t: f64) -> (f64, f64) {
        let Self { omega, zeta, .. } = *self;
        let [a, b] = [a, b].map(|load| -self.participation * load);
        let square = omega * omega;
        // p + q t satisfies the equation of motion; a free vibration is added.
        let q = b / square;
        let p = (a - 2.0 * zeta * omega * q) / square;
        let (u, v) = (u - p, v - q);
        let damped = omega * (1.0 - zeta * zeta).sqrt();
        let (c, s, decay) = (cos(damped * t), sin(damped * t), exp(-zeta * omega * t));
        let slope = (v + zeta * omega * u) / damped;
        (
            p + q * t + decay * (u * c + slope * s),
            q + decay * (v * c - (zeta * omega * slope + u * damped) * s),
        )
    }
}

/// Displacements and velocities of both floors at a time \[s\] after rest.
fn in_modes(modes: &[Mode; 2], ground: &[f64], until: f64) -> [(f64, f64); 2] {
    let mut found = [(0.0, 0.0); 2];
    for mode in modes {
        let mut state = (0.0, 0.0);
        for (index, ends) in (0_u32..).zip(ground.windows(2)) {
            let t = (until - 0.1 * f64::from(index)).clamp(0.0, 0.1);
            state = mode.after(state, [ends[0], (ends[1] - ends[0]) / 0.1], t);
        }
        for (found, shape) in found.iter_mut().zip(mode.shape) {
            found.0 += shape * state.0;
            found.1 += shape * state.1;
        }
    }
    found
}

#[test]
fn reference_two_storeys_under_shaking_in_modal_form() {
    let ground = ground();
    for (masses, stiffnesses) in [([2e5, 1e5], [8e7, 5e7]), ([1e5, 3e5], [4e7, 9e7]), ([1e6, 1e4], [4e8, 1e6])] {
        let of = [(masses[0], stiffnesses[0]), (masses[1], stiffnesses[1])];
        let row = buildings(&[elastic(&of)], (ALPHA, BETA), (0.0, stereomechanical(1.0)));
        let modes = modes(masses, stiffnesses);
        for duration in [0.37, 3.0, 5.95] {
            let response = run(&row, &ground, duration);
            let wanted = in_modes(&modes, &ground, duration);
            for (found, (u, v)) in response.structures.iter().zip(wanted) {
                let scale = found.displacement.value.abs();
                let errors = (found.end_displacement - u, found.end_velocity - v);
                assert!(
                    errors.0.abs() < 1e-12 * scale && errors.1.abs() < 1e-12 * scale * modes[1].omega,
                    "{masses:?}, {duration} s: {errors:?} of {scale}"
                );
            }
            let drift = response.structures[1].drift;
            let there = in_modes(&modes, &ground, drift.time);
            let peak = there[1].0 - there[0].0;
            close(drift.value, peak, 1e-12, "peak drift");
            let rate = (there[1].1 - there[0].1).abs();
            let end = drift.time >= duration;
            assert!(end || rate < 1e-11 * peak.abs() * modes[1].omega, "{rate}");
            let shear = response.structures[1].restoring_force.value;
            close(shear, stiffnesses[1] * peak, 1e-12, "peak shear");
        }
    }
}

/// Kinetic and elastic energy of undamped towers.
pub(super) fn energy(row: &Row<Elastic>, state: impl Fn(usize) -> (f64, f64)) -> f64 {
    let nodes = row.nodes().iter().enumerate();
    let of = nodes.map(|(index, node)| {
        let (u, v) = state(index);
        let below = match node.support {
            pounding_solver::Support::Ground => 0.0,
            pounding_solver::Support::Floor(floor) => state(floor.below).0,
        };
        let drift = u - below;
        0.5 * (v * v / node.inverse_mass + node.column.stiffness * drift * drift)
    });
    of.sum()
}

#[test]
fn limit_energy_is_kept_without_damping() {
    for law in [stereomechanical(1.0), viscoelastic(0.0), spring(5e8)] {
        let towers = TOWERS.map(elastic);
        let row = buildings(&towers, (0.0, 0.0), (0.01, law));
        let speeds = [0.5, 0.2, -0.4, 0.3, 0.0, -0.8, 0.9, 0.1];
        let nodes = row.nodes().iter().zip(speeds);
        let moving = nodes.map(|(node, initial_velocity)| Node { initial_velocity, ..*node });
        let row = Row::new(moving.collect(), row.pairs().to_vec()).expect("a valid row");
        let response = run(&row, &[0.0], 4.0);
        let before = energy(&row, |index| (0.0, speeds[index]));
        let end = |index: usize| {
            let floor = &response.structures[index];
            (floor.end_displacement, floor.end_velocity)
        };
        // Energy in a contact that lasts to the end.
        let pairs = row.pairs().iter().map(|pair| {
            let overlap = (end(pair.left()).0 - end(pair.right()).0 - pair.gap()).max(0.0);
            if let ContactLaw::LinearSpring(spring) = law {
                0.5 * spring.impact_stiffness * overlap * overlap
            } else if let ContactLaw::NonlinearViscoelastic(spring) = law {
                0.4 * spring.impact_stiffness * overlap * overlap * overlap.sqrt()
            } else {
                0.0
            }
        });
        let after = energy(&row, end) + pairs.sum::<f64>();
        let count: Vec<_> = response.collisions.iter().map(Vec::len).collect();
        assert!(count.iter().all(|n| *n > 1), "{count:?}");
        close(after, before, 1e-13, "energy");
    }
}

/// Only one floor moves at first; the storeys set the others in motion.
#[test]
fn extreme_a_floor_wakes_the_others() {
    let of = vec![(1e5, Elastic { stiffness: 5e7 }); 6];
    let row = buildings(&[of], (0.0, 0.0), (0.0, spring(1.0)));
    let mut nodes = row.nodes().to_vec();
    nodes[0].initial_velocity = 1.0;
    let row = Row::new(nodes, vec![]).expect("a valid row");
    let response = run(&row, &[0.0], 1.0);
    let after = energy(&row, |index| {
        let floor = &response.structures[index];
        (floor.end_displacement, floor.end_velocity)
    });
    close(after, 5e4, 1e-13, "energy");
}

/// Floors without columns hit each other level by level, like separate rows.
#[test]
fn limit_levels_without_columns_are_rows_of_their_own() {
    let free = Elastic { stiffness: 0.0 };
    let speeds = [[1.0, 0.0, -0.5], [0.3, -0.9, 0.2]];
    let masses = [2e5, 1e5, 3e5];
    for law in [stereomechanical(0.6), viscoelastic(0.3)] {
        let of = masses.map(|mass| vec![(mass, free); 2]);
        let row = buildings(&of, (0.0, 0.0), (0.05, law));
        let nodes = row.nodes().iter().zip(speeds.as_flattened());
        let moving = nodes.map(|(node, &initial_velocity)| Node { initial_velocity, ..*node });
        let row = Row::new(moving.collect(), row.pairs().to_vec()).expect("a valid row");
        let both = run(&row, &[0.0], 1.0);
        for (level, speeds) in speeds.iter().enumerate() {
            let node = |(mass, speed): (&f64, &f64)| super::moving(*mass, *speed, free);
            let nodes = masses.iter().zip(speeds).map(node).collect();
            let row = Row::new(nodes, pairs(3, 0.05, law)).expect("a valid row");
            let alone = run(&row, &[0.0], 1.0);
            for index in 0..3 {
                let (found, wanted) = (both.structures[3 * level + index], alone.structures[index]);
                close(found.end_velocity, wanted.end_velocity, 1e-12, "velocity");
                close(found.transferred_momentum, wanted.transferred_momentum, 1e-12, "momentum");
            }
            for pair in 0..2 {
                let (found, wanted) = (&both.collisions[2 * level + pair], &alone.collisions[pair]);
                assert_eq!(found.len(), wanted.len(), "collisions");
            }
        }
    }
}

/// A loose floor on top of another floor leaves that floor an ordinary structure.
#[test]
fn limit_one_storey_is_a_structure() {
    let ground = ground();
    let node = Node::structure(1e5, 1e5 * ALPHA + 5e7 * BETA, Elastic { stiffness: 5e7 });
    let alone = Row::new(vec![node], vec![]).expect("a valid row");
    let wanted = run(&alone, &ground, 4.0);
    let one = buildings(&[elastic(&[(1e5, 5e7)])], (ALPHA, BETA), (0.0, spring(1.0)));
    assert_eq!(run(&one, &ground, 4.0), wanted);
    let loose = Node::structure(1e5, 0.0, Elastic { stiffness: 0.0 }).on_floor(Floor {
        below: 0,
        ground_damping: 0.0,
    });
    let row = Row::new(vec![node, loose], vec![]).expect("a valid row");
    let found = run(&row, &ground, 4.0).structures[0];
    let wanted = wanted.structures[0];
    close(found.displacement.value, wanted.displacement.value, 1e-13, "peak");
    close(found.displacement.time, wanted.displacement.time, 1e-12, "its time");
    // Upper storeys so stiff that they drift by a millionth: a single mass.
    let rigid = elastic(&[(4e4, 5e7), (3e4, 5e13), (3e4, 5e13)]);
    let row = buildings(&[rigid], (0.0, 0.0), (0.0, spring(1.0)));
    let sum = buildings(&[elastic(&[(1e5, 5e7)])], (0.0, 0.0), (0.0, spring(1.0)));
    let (found, wanted) = (run(&row, &ground, 1.0), run(&sum, &ground, 1.0));
    for floor in &found.structures {
        close(floor.displacement.value, wanted.structures[0].displacement.value, 1e-5, "rigid");
    }
}

#[test]
fn limit_a_mirrored_row_mirrors() {
    let ground = ground();
    let reversed: Vec<f64> = ground.iter().map(|sample| -sample).collect();
    for law in [stereomechanical(0.9), viscoelastic(0.35)] {
        let there = towers(|index| index, law, &ground);
        let back = towers(|index| 2 - index, law, &reversed);
        // Nodes are numbered level by level.
        let nodes = [(0, 2), (1, 1), (2, 0), (3, 5), (4, 4), (5, 3), (6, 7), (7, 6)];
        for (one, other) in nodes {
            let (one, other) = (there.structures[one], back.structures[other]);
            close(one.displacement.value, -other.displacement.value, 1e-11, "peak");
            close(one.drift.value, -other.drift.value, 1e-11, "peak drift");
            close(one.transferred_momentum, other.transferred_momentum, 1e-10, "momentum");
        }
        for (one, other) in [(0, 1), (1, 0), (2, 3), (3, 2)] {
            let (one, other) = (&there.collisions[one], &back.collisions[other]);
            assert!(!one.is_empty() && one.len() == other.len(), "{one:?}");
        }
    }
}

fn towers(order: fn(usize) -> usize, law: ContactLaw, ground: &[f64]) -> Response {
    let of = [0, 1, 2].map(|place| elastic(TOWERS[order(place)]));
    let row = buildings(&of, (ALPHA, BETA), (0.01, law));
    run(&row, ground, 4.0)
}
