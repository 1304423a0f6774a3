//! Links between floors, to the ground and to walls, by closed forms and by the exact method.

use pounding_contact::ContactLaw;
use pounding_reference::Fineness;
use pounding_solver::{
    Bilinear, Braced, Elastic, Excitation, Hysteretic, Levels, Link, LinkLaw, Node, Point, Relation, Restrainer, Row, Spring, Viscous,
};

use super::exact::agree_on_floors;
use super::storeys::{ALPHA, BETA, TOWERS, buildings, elastic, ground};
use super::{FREE, close, moving, pairs, run, stereomechanical, viscoelastic};

fn link(left: impl Into<Point>, right: impl Into<Point>, law: LinkLaw) -> Link {
    let (left, right) = (left.into(), right.into());
    let relation = Relation { left, right, offset: 0.0 };
    Link { relation, law }
}

fn spring(stiffness: f64, yield_force: f64, hardening: f64, damping: f64) -> LinkLaw {
    LinkLaw::Spring(Spring {
        stiffness,
        yield_force,
        hardening,
        damping,
    })
}

fn restrainer(slack: f64, yield_force: f64) -> LinkLaw {
    LinkLaw::Restrainer(Restrainer {
        stiffness: 4e7,
        yield_force,
        slack,
    })
}

fn braced(coefficient: f64, inverse_exponent: u32) -> LinkLaw {
    LinkLaw::Braced(Braced {
        stiffness: 5e7,
        coefficient,
        inverse_exponent,
    })
}

/// Links of every kind.
fn every_kind() -> [LinkLaw; 12] {
    let never = f64::INFINITY;
    [
        spring(2e7, never, 0.0, 0.0),
        spring(2e7, 2e5, 0.0, 0.0),
        spring(2e7, 2e5, 0.05, 1e5),
        spring(0.0, never, 0.0, 8e5),
        restrainer(0.005, never),
        restrainer(0.01, 3e5),
        restrainer(0.0, 2e5),
        braced(8e5, 1),
        braced(4e5, 2),
        braced(3e5, 3),
        braced(3e5, 4),
        braced(2e5, 5),
    ]
}

/// Impulsive and compliant laws of contacts.
fn laws() -> [ContactLaw; 3] {
    [stereomechanical(0.6), viscoelastic(0.35), super::storeys::spring(5e8)]
}

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

/// Two structures beside a wall.
fn beside_a_wall(law: ContactLaw) -> Row<Bilinear> {
    let wall = Bilinear {
        stiffness: 1.0,
        yield_force: 1.0,
        hardening: 0.0,
    };
    let nodes = vec![structure(1e5, 0.8, 0.05), structure(3e5, 0.3, f64::INFINITY), Node::wall(wall)];
    Row::new(nodes, pairs(3, 0.02, law)).expect("a valid row")
}

/// Both routes agree on floors and touches, and the links change the motion.
fn agree<Column: Hysteretic>(row: &Row<Column>, links: Vec<Link>, duration: f64, what: &str) {
    let without = run(row, &ground(), duration);
    let row = row.clone().linked(links).expect("valid links");
    let (collisions, other) = agree_on_floors(&row, duration, (1e-11, what));
    for (pair, known) in other.collisions.iter().enumerate() {
        let what = format!("{what}, pair {pair}");
        let found = collisions.all().iter().filter(|found| found.pair == pair);
        let sum = found.map(|found| found.impulse).sum::<f64>();
        close(sum, known.iter().map(|known| known.impulse).sum(), 1e-11, &what);
    }
    assert!(other.collisions.iter().any(|known| known.len() > 1), "{what}: no collisions");
    let [one, other] = [&without, &other].map(|response| response.structures[0].displacement.value);
    assert!((one - other).abs() > 1e-3 * one.abs(), "{what}: {one} with and without");
}

#[test]
fn reference_the_exact_method_agrees_on_a_link_of_each_kind() {
    for law in laws() {
        let row = beside_a_wall(law);
        for kind in every_kind() {
            agree(&row, vec![link(0, 1, kind)], 3.0, &format!("{law:?}, {kind:?}"));
        }
    }
}

/// To a wall, to the ground under the structure and under its neighbour.
#[test]
fn reference_the_exact_method_agrees_on_links_to_the_ground() {
    for law in laws() {
        for arrivals in [[0.0, 0.0, 0.0], [0.0, 0.07, 0.222], [0.13, 0.0, 0.05]] {
            let row = beside_a_wall(law).delayed(arrivals.to_vec()).expect("valid arrivals");
            for (to, kind) in [
                (2.into(), restrainer(0.005, 3e5)),
                (2.into(), braced(4e5, 2)),
                (Point::Ground(0), spring(1e7, 2e5, 0.05, 1e5)),
                (Point::Ground(1), spring(1e7, 2e5, 0.0, 1e5)),
                (Point::Ground(1), braced(3e5, 3)),
                (1.into(), restrainer(0.01, f64::INFINITY)),
                (1.into(), braced(4e5, 4)),
            ] {
                let what = format!("{law:?}, {arrivals:?}, {kind:?} to {to:?}");
                agree(&row, vec![link(0, to, kind)], 3.0, &what);
            }
        }
    }
}

/// Towers of three, two and three storeys with links between neighbours, across the middle tower, inside a tower and to the ground.
#[test]
fn reference_the_exact_method_agrees_on_many_links() {
    let levels = Levels::new(&TOWERS.map(<[_]>::len));
    let arrival = |node: usize| [0.0, 0.06, 0.21][levels.place(node).0];
    let arrivals: Vec<_> = (0..levels.n_nodes()).map(arrival).collect();
    for law in laws() {
        let of: Vec<_> = TOWERS.iter().map(|tower| elastic(tower)).collect();
        let row: Row<Elastic> = buildings(&of, (ALPHA, BETA), (0.01, law));
        // Floors by level: 0, 1, 2 are the lowest, 3, 4, 5 above them, 6 and 7 the roofs of the outer towers.
        let links = vec![
            link(3, 4, restrainer(0.004, 3e5)),
            link(4, 5, spring(3e7, 1e5, 0.1, 2e5)),
            link(6, 7, braced(3e5, 2)),
            link(0, 6, spring(1e7, f64::INFINITY, 0.0, 3e5)),
            link(Point::Ground(0), 2, braced(2e5, 5)),
            link(1, 5, spring(0.0, f64::INFINITY, 0.0, 4e5)),
        ];
        agree(&row, links.clone(), 1.5, &format!("{law:?}"));
        let delayed = row.delayed(arrivals.clone()).expect("valid arrivals");
        agree(&delayed, links, 1.5, &format!("{law:?}, delayed"));
    }
}

/// A link that is deformed at the start has its force there.
#[test]
fn reference_the_exact_method_agrees_on_links_that_start_deformed() {
    let law = stereomechanical(0.6);
    for kind in every_kind() {
        let mut nodes = beside_a_wall(law).nodes().to_vec();
        (nodes[0].initial_displacement, nodes[0].initial_velocity) = (-0.03, 0.2);
        let row = Row::new(nodes, pairs(3, 0.02, law)).expect("a valid row");
        agree(&row, vec![link(0, 1, kind)], 2.0, &format!("{kind:?}"));
    }
}

/// A yielding spring between a free mass and its ground is a column.
#[test]
fn limit_a_spring_to_the_ground_is_a_column() {
    let column = Bilinear {
        stiffness: 5e7,
        yield_force: 1e6,
        hardening: 0.1,
    };
    let node = Node::structure(1e5, 2e5, column);
    let wanted = run(&Row::new(vec![node], vec![]).expect("a valid row"), &ground(), 5.0).structures[0];
    let free = Row::new(vec![Node::structure(1e5, 0.0, FREE)], vec![]).expect("a valid row");
    let links = vec![link(Point::Ground(0), 0, spring(5e7, 1e6, 0.1, 2e5))];
    let found = run(&free.linked(links).expect("a valid link"), &ground(), 5.0).structures[0];
    assert!(wanted.restoring_force.value.abs() > 1.01e6, "it yields");
    close(found.displacement.value, wanted.displacement.value, 1e-13, "peak");
    close(found.end_displacement, wanted.end_displacement, 1e-12, "end");
}

/// A mass with velocity v stretches a restrainer: slack, elastic, then ½ m v² − ½ f²/k at the yield force f. It comes back with f/√(k m).
#[test]
fn reference_a_restrainer_stops_a_mass() {
    let (mass, v, k, f, slack) = (1e5, 1.5, 4e7, 6e5, 0.02);
    let node = moving(mass, v, FREE);
    let row = Row::new(vec![node], vec![]).expect("a valid row");
    let row = row
        .linked(vec![link(Point::Ground(0), 0, restrainer(slack, f))])
        .expect("a valid link");
    let found = run(&row, &[0.0], 1.0).structures[0];
    let peak = slack + f / k + (0.5 * mass * v * v - 0.5 * f * f / k) / f;
    close(found.displacement.value, peak, 1e-13, "peak");
    close(found.end_velocity, -f / libm::sqrt(k * mass), 1e-13, "velocity afterwards");
}

/// Its force has an infinite slope, or a kink, where the rate is 0.
#[test]
fn extreme_a_viscous_damper_without_a_brace_is_refused() {
    let damper = LinkLaw::Viscous(Viscous {
        coefficient: 1e5,
        exponent: 0.5,
    });
    let row = beside_a_wall(stereomechanical(0.6));
    let row = row.linked(vec![link(0, 1, spring(1e6, 1e9, 0.0, 0.0)), link(1, 2, damper)]);
    let excitation = Excitation::new(0.1, &[0.0]).expect("finite samples");
    let error = pounding_reference::run(&row.expect("valid links"), excitation, 1.0, Fineness::FINE);
    let error = error.expect_err("no brace").to_string();
    assert_eq!(error, "second route: links[1] is a viscous damper without a brace; give it a brace");
}
