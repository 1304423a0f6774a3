//! Pairs of any points: several on one floor, and points between floors.

use libm::{cos, sin, sqrt};
use pounding_contact::{ContactLaw, HertzDamp, KelvinVoigt};
use pounding_reference::{Fineness, Response};
use pounding_solver::{
    CentralDifference, Elastic, Excitation, Floor, Integrator, Newmark, Node, Pair, Point, Relation, Rk4, Row, Support, Verlet,
    VerletImpacts,
};

use super::exact::agree_on_floors;
use super::stepping::approach;
use super::storeys::{ALPHA, BETA, TOWERS, buildings, elastic, energy, ground, spring};
use super::{FREE, close, moving, pairs, run, stereomechanical};

fn on_floor<Column>(below: usize, node: Node<Column>) -> Node<Column> {
    node.on_floor(Floor {
        below,
        ground_damping: 0.0,
    })
}

/// The point with this part of the upper floor's displacement.
fn between(lower: impl Into<Option<usize>>, upper: usize, upper_part: f64) -> Point {
    Point::between(lower.into(), upper, upper_part).expect("a point of the row")
}

fn pair(left: impl Into<Point>, right: impl Into<Point>, offset: f64, law: ContactLaw) -> Pair {
    let (left, right) = (left.into(), right.into());
    Pair {
        relation: Relation { left, right, offset },
        law,
    }
}

/// Two slabs hit points of the columns above and below a floor: treated alone, the impulse of one of them would be a pull.
#[test]
fn reference_slabs_that_share_a_floor() {
    let law = stereomechanical(0.65);
    let nodes = vec![
        moving(3e5, 1.0, FREE),
        moving(3e5, 0.2, FREE),
        moving(2e5, 0.0, FREE),
        on_floor(2, moving(2e5, 0.0, FREE)),
        on_floor(3, moving(2e5, 0.0, FREE)),
    ];
    let mut pairs = vec![pair(0, between(2, 3, 0.6), 0.0, law), pair(1, between(3, 4, 0.3), 0.0, law)];
    for _ in 0..2 {
        let row = Row::new(nodes.clone(), pairs.clone()).expect("a valid row");
        let response = run(&row, &[0.0], 0.1);
        let v = |index: usize| response.structures[index].end_velocity;
        let [one, other] = [v(0) - (0.4 * v(2) + 0.6 * v(3)), v(1) - (0.7 * v(3) + 0.3 * v(4))];
        close(one, -0.65, 1e-14, "rate of the first");
        close(other, -0.383_988_764_044_943_8, 1e-14, "rate of the second");
        let hit = pairs.iter().position(|pair| pair.left() == 0).expect("it");
        let collisions = &response.collisions;
        assert!(collisions[1 - hit].is_empty(), "{collisions:?}");
        close(collisions[hit][0].impulse, 278_089.887_640_449_4, 1e-14, "impulse");
        pairs.reverse();
    }
}

#[test]
fn reference_a_slab_hits_a_column() {
    let floors = [
        (
            0.6,
            142_898.383_371_824_5,
            [0.023_672_055_427_251_73, 0.228_637_413_394_919_2, 0.428_695_150_115_473_4],
        ),
        (
            0.648,
            139_159.022_947_351,
            [0.036_136_590_175_496_68, 0.195_935_904_309_870_2, 0.450_875_234_349_417_2],
        ),
    ];
    for (part, impulse, velocities) in floors {
        let nodes = vec![
            moving(3e5, 0.5, FREE),
            moving(2.5e5, 0.0, FREE),
            on_floor(1, moving(2e5, 0.0, FREE)),
        ];
        let pairs = vec![pair(0, between(1, 2, part), 0.05, stereomechanical(0.65))];
        let response = run(&Row::new(nodes, pairs).expect("a valid row"), &[0.0], 0.2);
        close(response.collisions[0][0].impulse, impulse, 1e-13, "impulse");
        for (structure, velocity) in response.structures.iter().zip(velocities) {
            close(structure.end_velocity, velocity, 1e-13, "velocity");
        }
    }
}

#[test]
fn reference_a_slab_presses_a_column_through_a_spring() {
    let of = |stiffness| Elastic { stiffness };
    let parting = 0.154_679_328_180_761_6;
    let nodes = vec![
        moving(3e5, 0.5, of(2e7)),
        moving(2.5e5, 0.0, of(1.2e8)),
        on_floor(1, moving(2e5, 0.0, of(9e7))),
    ];
    let law = spring(67_045_698.347_993_99);
    let pairs = vec![pair(0, between(1, 2, 0.648), 0.0, law)];
    let row = Row::new(nodes, pairs).expect("a valid row");
    let response = run(&row, &[0.0], 0.2);
    let [met] = response.collisions[0][..] else {
        panic!("{:?}", response.collisions);
    };
    close(met.end, parting, 1e-12, "parting");
    close(met.peak_force.expect("a force"), 1_568_605.779_959_222, 1e-12, "peak force");
    let response = run(&row, &[0.0], parting);
    let ends = [
        (0.022_317_527_690_277_47, -0.239_565_052_716_423_8),
        (0.014_431_865_961_790_43, 0.122_635_516_920_282_3),
        (0.026_601_097_024_270_43, 0.169_406_317_370_665_5),
    ];
    for (structure, (displacement, velocity)) in response.structures.iter().zip(ends) {
        close(structure.end_displacement, displacement, 1e-12, "displacement");
        close(structure.end_velocity, velocity, 1e-12, "velocity");
    }
}

/// Dependent pairs share the impulse with the least sum of squares.
#[test]
fn reference_pairs_too_many_share_an_impulse() {
    let law = stereomechanical(0.5);
    let nodes = vec![
        moving(3e5, 1.0, FREE),
        moving(2e5, 0.0, FREE),
        on_floor(1, moving(2e5, 0.0, FREE)),
        on_floor(0, moving(3e5, 1.0, FREE)),
    ];
    let pairs = vec![
        pair(0, 1, 0.0, law),
        pair(between(0, 3, 0.5), between(1, 2, 0.5), 0.0, law),
        pair(3, 2, 0.0, law),
    ];
    let response = run(&Row::new(nodes, pairs).expect("a valid row"), &[0.0], 0.1);
    // Both floors need (1 + e) m v; the outer pairs alone could give it.
    let needed = 1.5 * 3e5 * 2e5 / 5e5;
    for met in &response.collisions {
        close(met[0].impulse, 2.0 / 3.0 * needed, 1e-14, "impulse");
    }
}

/// Two floors, a slab that moves with a part of each, and their storeys.
struct Joined {
    slab: f64,
    parts: [f64; 2],
    floors: [f64; 2],
    stiffnesses: [f64; 2],
}

impl Joined {
    /// Displacements, velocities and accelerations of the slab and of both floors at a time \[s\] after an impulse on the slab \[N·s\].
    fn after(&self, impulse: f64, t: f64) -> [[f64; 3]; 3] {
        let g = self.parts;
        let m = |one: usize, other: usize| {
            let own = if one == other { self.floors[one] } else { 0.0 };
            own + self.slab * g[one] * g[other]
        };
        let (a, b, c) = (m(0, 0), m(0, 1), m(1, 1));
        let [lower, upper] = self.stiffnesses;
        // The determinant of K − λ M vanishes: K = [lower + upper, −upper; −upper, upper].
        let two = a * c - b * b;
        let one = (lower + upper) * c + upper * a + 2.0 * upper * b;
        let root = sqrt(one * one - 4.0 * two * lower * upper);
        let mut found = [[0.0; 3]; 3];
        for square in [(one - root) / (2.0 * two), (one + root) / (2.0 * two)] {
            let shape = [upper + square * b, lower + upper - square * a];
            let of_slab = g[0] * shape[0] + g[1] * shape[1];
            let mass = self.floors[0] * shape[0] * shape[0] + self.floors[1] * shape[1] * shape[1] + self.slab * of_slab * of_slab;
            let (speed, omega) = (impulse * of_slab / mass, sqrt(square));
            let (s, c) = (sin(omega * t), cos(omega * t));
            for (found, factor) in found.iter_mut().zip([s / omega, c, -omega * s]) {
                for (found, shape) in found.iter_mut().zip([of_slab, shape[0], shape[1]]) {
                    *found += speed * factor * shape;
                }
            }
        }
        found
    }
}

/// A slab at rest against a point between two floors, until their force fades.
#[test]
fn reference_a_slab_rests_on_a_column() {
    let joined = Joined {
        slab: 2e5,
        parts: [0.35, 0.65],
        floors: [3e5, 2e5],
        stiffnesses: [8e7, 5e7],
    };
    let column = |floor: usize| Elastic {
        stiffness: joined.stiffnesses[floor],
    };
    let nodes = vec![
        moving(joined.slab, 0.5, FREE),
        moving(joined.floors[0], 0.0, column(0)),
        on_floor(1, moving(joined.floors[1], 0.0, column(1))),
    ];
    let pairs = vec![pair(0, between(1, 2, 0.65), 0.0, stereomechanical(0.0))];
    let row = Row::new(nodes, pairs).expect("a valid row");
    let response = run(&row, &[0.0], 1.0);
    let [rest] = response.collisions[0][..] else {
        panic!("{:?}", response.collisions);
    };
    let after = |t: f64| joined.after(joined.slab * 0.5, t);
    let [_, [left, ..], [push, ..]] = after(rest.end);
    let largest = after(0.5 * rest.end)[2][0].abs();
    assert!(push.abs() < 1e-11 * largest, "{push} of {largest}");
    close(rest.impulse, joined.slab * (0.5 - left), 1e-12, "impulse");
    let twice = Row::new(row.nodes().to_vec(), [row.pairs(), row.pairs()].concat());
    let halves = run(&twice.expect("a valid row"), &[0.0], 1.0).collisions;
    for half in halves {
        close(half[0].impulse, 0.5 * rest.impulse, 1e-12, "of two");
        close(half[0].end, rest.end, 1e-12, "parting of two");
    }
    for part in [0.3, 0.7, 1.0] {
        let response = run(&row, &[0.0], part * rest.end);
        let [displacements, velocities, _] = after(part * rest.end);
        for (index, found) in response.structures.iter().enumerate() {
            close(found.end_displacement, displacements[index], 1e-12, "displacement");
            close(found.end_velocity, velocities[index], 1e-12, "velocity");
        }
    }
}

/// Towers of three and two storeys. Two pairs meet at a floor; others meet at points between floors or above the ground.
fn towers(law: ContactLaw) -> Row<Elastic> {
    let of = TOWERS.map(elastic);
    let row = buildings(&of[..2], (ALPHA, BETA), (0.01, law));
    let pairs = vec![
        pair(2, between(1, 3, 0.65), 0.008, law),
        pair(4, 3, 0.012, law),
        pair(2, 3, 0.0078, law),
        pair(between(None, 0, 0.4), between(None, 1, 0.45), 0.0018, law),
        pair(0, 1, 0.0045, law),
    ];
    Row::new(row.nodes().to_vec(), pairs).expect("a valid row")
}

/// The towers without gaps.
fn towers_without_gaps(law: ContactLaw) -> Row<Elastic> {
    let row = towers(law);
    let pairs = row.pairs().iter();
    let pairs = pairs.map(|one| pair(one.relation.left, one.relation.right, 0.0, law));
    Row::new(row.nodes().to_vec(), pairs.collect()).expect("a valid row")
}

/// The compliant laws.
fn compliant() -> [ContactLaw; 2] {
    [
        ContactLaw::KelvinVoigt(KelvinVoigt {
            impact_stiffness: 9e8,
            impact_damping_ratio: 0.15,
        }),
        ContactLaw::HertzDamp(HertzDamp {
            impact_stiffness: 3e9,
            impact_damping_factor: 0.6,
        }),
    ]
}

fn all_meet(response: &Response) {
    let counts: Vec<_> = response.collisions.iter().map(Vec::len).collect();
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
}

#[test]
fn limit_the_order_of_pairs_is_nothing() {
    for law in compliant().into_iter().chain([0.6, 0.0].map(stereomechanical)) {
        let row = towers(law);
        let one = run(&row, &ground(), 3.0);
        all_meet(&one);
        let order = [3, 1, 4, 0, 2];
        let pairs = order.map(|pair| row.pairs()[pair]).to_vec();
        let permuted = Row::new(row.nodes().to_vec(), pairs).expect("a valid row");
        let other = run(&permuted, &ground(), 3.0);
        for (one, other) in one.structures.iter().zip(&other.structures) {
            let (peak, momentum) = (one.displacement.value, one.transferred_momentum);
            close(peak, other.displacement.value, 1e-12, "peak");
            close(momentum, other.transferred_momentum, 1e-12, "momentum");
        }
        for (index, pair) in order.into_iter().enumerate() {
            let (one, other) = (&one.collisions[pair], &other.collisions[index]);
            assert_eq!(one.len(), other.len(), "{law:?}, pair {pair}");
        }
    }
}

#[test]
fn reference_the_exact_method_agrees_on_pairs_of_any_points() {
    for law in compliant().into_iter().chain([0.6, 0.0].map(stereomechanical)) {
        let (row, what) = (towers(law), format!("{law:?}"));
        let (collisions, other) = agree_on_floors(&row, 3.0, (1e-11, &what));
        all_meet(&other);
        for (pair, known) in other.collisions.iter().enumerate() {
            let what = format!("{what}, pair {pair}");
            let found = collisions.all().iter().filter(|found| found.pair == pair);
            let known = known.iter().map(|known| (known.impulse, known.peak_force));
            let sums = |(sum, peak): (f64, f64), (impulse, force): (f64, Option<f64>)| (sum + impulse, peak.max(force.unwrap_or(0.0)));
            let found = found.map(|found| (found.impulse, found.peak_force));
            let [found, known] = [found.fold((0.0, 0.0), sums), known.fold((0.0, 0.0), sums)];
            close(found.0, known.0, 1e-11, &what);
            // Before a rest, each route decides which impact was the last.
            if law.is_compliant() {
                close(found.1, known.1, 1e-11, &what);
            }
        }
    }
}

/// Usually several pairs are at rest, on a single floor or across each other.
#[test]
fn reference_the_exact_method_agrees_on_pairs_without_gaps() {
    for law in [0.0, 0.3].map(stereomechanical) {
        let row = towers_without_gaps(law);
        let (_, other) = agree_on_floors(&row, 3.0, (1e-11, &format!("{law:?}")));
        all_meet(&other);
    }
}

#[test]
fn reference_stepping_methods_come_near_pairs_of_any_points() {
    let methods = [
        Integrator::CentralDifference(CentralDifference { contact_substeps: 1 }),
        Integrator::Newmark(Newmark::AVERAGE_ACCELERATION),
        Integrator::Verlet(Verlet {
            impacts: VerletImpacts::Located,
        }),
        Integrator::Rk4(Rk4),
    ];
    for law in compliant() {
        let row = towers(law);
        for method in methods {
            approach(&row, method, [4e-5, 0.8], &format!("{law:?}, {method:?}"));
        }
    }
}

/// The energy of columns, contacts and motion, before and after collisions without loss.
#[test]
fn limit_energy_is_kept_by_pairs_of_any_points() {
    for law in [stereomechanical(1.0), spring(5e8)] {
        let row = towers(law);
        let speeds = [0.7, -0.3, 1.2, -0.4, 0.3];
        let nodes = row.nodes().iter().zip(speeds);
        let moving = nodes.map(|(node, initial_velocity)| Node {
            initial_velocity,
            damping: 0.0,
            support: match node.support {
                Support::Ground => Support::Ground,
                Support::Floor(Floor { below, .. }) => on_floor(below, *node).support,
            },
            ..*node
        });
        let row = Row::new(moving.collect(), row.pairs().to_vec()).expect("a valid row");
        let response = run(&row, &[0.0], 2.0);
        all_meet(&response);
        let end = |floor: usize| {
            let floor = &response.structures[floor];
            (floor.end_displacement, floor.end_velocity)
        };
        let kept = |pair: &Pair| {
            let overlap = pair.relation.ahead(|floor| end(floor).0) - pair.gap();
            0.5 * if law.is_compliant() { 5e8 } else { 0.0 } * overlap.max(0.0) * overlap
        };
        let before = energy(&row, |floor| (0.0, speeds[floor]));
        let after = energy(&row, end) + row.pairs().iter().map(kept).sum::<f64>();
        close(after, before, 1e-13, "energy");
    }
}

/// Sixteen pairs have too many sets to try.
#[test]
fn extreme_more_pairs_at_once_than_can_be_tried() {
    let nodes = vec![moving(1e5, 1.0, Elastic { stiffness: 1e6 }); 17];
    let row = Row::new(nodes, pairs(17, 0.0, stereomechanical(0.5))).expect("a valid row");
    let excitation = Excitation::new(0.1, &[0.0]).expect("finite samples");
    let error = pounding_reference::run(&row, excitation, 1.0, Fineness::FINE);
    let error = error.expect_err("too many").to_string();
    let wanted = "second route: 16 impulsive pairs touch at t = 0 s and meet floors of each other, allowed are 14; \
                  give some of them a gap or a compliant law";
    assert!(error.contains(wanted), "{error}");
}
