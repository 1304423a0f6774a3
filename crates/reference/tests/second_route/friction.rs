//! Storeys that stick and slide under friction, by closed forms and by the exact method.

use pounding_contact::ContactLaw;
use pounding_solver::{Bilinear, Braced, Link, LinkLaw, Mixed, Node, Pair, Point, Relation, Restrainer, Row, Sliding, Spring};

use super::exact::{agree_on_floors, exact};
use super::storeys::spring;
use super::{close, moving, pairs, run, stereomechanical, viscoelastic};

const GRAVITY: f64 = 9.80665;

fn elastic(stiffness: f64) -> Mixed {
    yielding(stiffness, f64::INFINITY)
}

fn yielding(stiffness: f64, yield_force: f64) -> Mixed {
    Mixed::Sharp(Bilinear {
        stiffness,
        yield_force,
        hardening: 0.0,
    })
}

fn sliding(stiffness: f64, friction: f64) -> Mixed {
    Mixed::Sliding(Sliding { stiffness, friction })
}

/// A mass on a surface with friction, without a spring.
fn block(mass: f64, friction: f64) -> Node<Mixed> {
    Node::structure(mass, 0.0, sliding(0.0, friction * mass * GRAVITY))
}

fn floor(below: usize, mass: f64, damping: f64, column: Mixed) -> Node<Mixed> {
    Node::structure(mass, damping, column).on_floor(pounding_solver::Floor {
        below,
        ground_damping: 0.0,
    })
}

fn wall() -> Node<Mixed> {
    Node::wall(elastic(1.0))
}

/// Whatever the weight, turning points fall by 2µR each half period π √(R/g), and it sticks at 50 mm.
#[test]
fn reference_a_pendulum_lets_go_and_sticks() {
    let case = include_str!("../../../scene/tests/reach/isolator-friction-pendulum.json");
    let case: serde_json::Value = serde_json::from_str(case).expect("JSON");
    let of = |group: &str, name: &str| -> f64 { case[group][name].as_f64().expect(name) };
    let numbers = |name: &str| -> Vec<f64> {
        let all = case["expected"][name].as_array().expect(name).iter();
        all.map(|one| one.as_f64().expect(name)).collect()
    };
    let half = of("expected", "half_period_s");
    for (mass, sign) in [(4e5, 1.0), (123.0, -1.0)] {
        let weight = mass * of("inputs", "g");
        let node = Node {
            initial_displacement: sign * of("inputs", "u0_m"),
            ..Node::structure(mass, 0.0, sliding(weight / of("inputs", "R_m"), weight * of("inputs", "mu")))
        };
        let row = Row::new(vec![node], vec![]).expect("a row");
        let after = |half_periods: f64| run(&row, &[0.0; 2], half_periods * half).structures[0];
        for (n, turn) in (1_u32..).zip(&numbers("turning_points_m")[1..]) {
            let found = after(f64::from(n)).end_displacement;
            close(sign * found, *turn, 1e-13, "turning point");
        }
        // The fastest instant is in the middle of a half cycle.
        for (n, wanted) in (0_u32..).zip(numbers("largest_velocity_of_half_cycles")) {
            close(after(f64::from(n) + 0.5).end_velocity.abs(), wanted, 1e-12, "velocity");
        }
        let end = after(10.0);
        close(sign * end.end_displacement, of("expected", "residual_m"), 1e-13, "residual");
        assert_eq!(end.end_velocity.to_bits(), 0.0_f64.to_bits());
        // What holds it there is the pendulum's pull, and the force of both is zero.
        assert!(end.end_restoring_force.abs() < 1e-12 * weight, "{}", end.end_restoring_force);
        let first = weight * (of("inputs", "u0_m") / of("inputs", "R_m") - of("inputs", "mu"));
        close(sign * end.restoring_force.value, first, 1e-13, "peak force");
    }
}

/// A block on ground that jerks with −J t slides from t₀ = µg/J on: u = J (t − t₀)³/6. After the record friction alone acts.
#[test]
fn reference_a_block_slides_under_a_ramp() {
    let (mass, friction, jerk, end) = (2e5, 0.1, 20.0, 0.1);
    let row = Row::new(vec![block(mass, friction)], vec![]).expect("a row");
    let limit = friction * GRAVITY;
    let since = end - limit / jerk;
    let (u, v) = (jerk * since * since * since / 6.0, jerk * since * since / 2.0);
    let found = run(&row, &[0.0, -jerk * end], 1.0).structures[0];
    close(found.end_displacement, u + v * v / (2.0 * limit), 1e-12, "way");
    close(found.restoring_force.value, limit * mass, 1e-14, "friction");
}

/// Friction that holds a floor has its peak inside a step: a floor that swings above with an amplitude a pulls with at most k a.
#[test]
fn reference_the_peak_of_a_friction_that_holds() {
    let swinging = Node {
        initial_displacement: 0.3,
        initial_velocity: 0.4,
        ..floor(0, 1.0, 0.0, elastic(1.0))
    };
    let row = Row::new(vec![block(1e3, 0.1), swinging], vec![]).expect("a row");
    let found = run(&row, &[0.0; 2], 7.0).structures[0];
    close(found.restoring_force.value.abs(), 0.5, 1e-12, "peak");
    assert_eq!(found.displacement.value.to_bits(), 0.0_f64.to_bits());
}

/// An impact finds the floor with its own mass: v = (1 + e) m₂ v₂/(m₁ + m₂). Then it slides for v²/2µg, and sticks.
#[test]
fn reference_an_impact_makes_it_slide() {
    let row = Row::new(
        vec![moving(3e5, 0.8, elastic(0.0)), block(1e5, 0.2)],
        pairs(2, 0.02, stereomechanical(0.5)),
    );
    let (v, limit) = (1.5 * 0.75 * 0.8, 0.2 * GRAVITY);
    let found = run(&row.expect("a row"), &[0.0; 2], 0.2).structures[1];
    let since = 0.2 - 0.02 / 0.8;
    close(found.end_displacement, v * since - 0.5 * limit * since * since, 1e-13, "slides");
    close(found.end_velocity, v - limit * since, 1e-13, "velocity");
}

/// A free mass rests against a block under a ramp: the friction holds both, until both slide as one mass.
#[test]
fn reference_friction_holds_a_neighbour_that_presses() {
    let (jerk, friction, own, other) = (20.0, 0.3, 1e5, 3e5);
    for sign in [1.0, -1.0] {
        let mut nodes = vec![moving(other, 0.0, elastic(0.0)), block(own, friction)];
        if sign < 0.0 {
            nodes.reverse();
        }
        let row = Row::new(nodes, pairs(2, 0.0, stereomechanical(0.0))).expect("a row");
        let found = run(&row, &[0.0, -0.1 * jerk * sign, -0.2 * jerk * sign], 0.2);
        let since: f64 = 0.2 - friction * own * GRAVITY / (own + other) / jerk;
        for node in found.structures {
            close(sign * node.end_displacement, jerk * since * since * since / 6.0, 1e-11, "way");
        }
    }
}

/// A wall bears what friction does not hold of a block that slides against it: m (a − µg).
#[test]
fn reference_a_block_pressed_against_a_wall() {
    let row = Row::new(vec![block(1e5, 0.1), wall()], pairs(2, 0.01, stereomechanical(0.0))).expect("a row");
    let found = run(&row, &[-3.0; 21], 2.0);
    let rest = found.collisions[0].last().expect("it touches");
    let limit = 0.1 * GRAVITY;
    let touch = (2.0 * 0.01 / (3.0 - limit)).sqrt();
    let stops = 1e5 * (3.0 - limit) * touch;
    let presses = 1e5 * (3.0 - limit) * (2.0 - touch);
    close(rest.impulse, stops + presses, 1e-12, "impulse");
    close(found.structures[0].displacement.value, 0.01, 1e-14, "way");
}

/// How the floors of [`moat`] meet.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Meets {
    /// The base meets its neighbours.
    InAChain,
    /// The columns above the base meet the slab of a neighbour, too.
    Columns,
}

/// A tower of two floors on isolators beside a wall; another one, whose base slides, too; and a mass beside a wall.
fn moat(law: ContactLaw, friction: f64, meets: Meets, gap: f64) -> Row<Mixed> {
    let mut base = Node::structure(3e5, 1e4, sliding(1e6, friction));
    base.initial_velocity = 0.1;
    let nodes = vec![
        wall(),
        base,
        Node::structure(2e5, 2e5, sliding(2e6, 0.5 * friction)),
        Node::structure(1e5, 1e5, yielding(5e7, 4e5)),
        wall(),
        floor(1, 2e5, 3e5, elastic(2e8)),
        floor(2, 1e5, 1e5, yielding(9e7, 3e5)),
    ];
    let mut all = pairs(5, gap, law);
    if meets == Meets::Columns {
        let relation = Relation {
            left: Point::between(Some(1), 5, 0.4).expect("a point"),
            right: Point::Floor(2),
            offset: 0.025,
        };
        all.push(Pair { relation, law });
    }
    all.push(Pair::of_floors(5, 6, 0.01, law));
    Row::new(nodes, all).expect("a row")
}

fn laws() -> [ContactLaw; 4] {
    [spring(2e8), viscoelastic(0.35), stereomechanical(0.6), stereomechanical(0.0)]
}

/// Both routes agree on the peaks of floors. Forces between floors that friction holds are not unique.
fn peaks_agree(row: &Row<Mixed>, what: &str) {
    let ((peaks, ..), other) = (exact(row, 3.0), run(row, &super::storeys::ground(), 3.0));
    for (index, node) in row.nodes().iter().enumerate().filter(|(_, node)| !node.is_wall()) {
        let known = other.structures[index];
        for (found, known) in [
            (peaks.of(index).displacement, known.displacement),
            (peaks.of(index).restoring_force, known.restoring_force),
        ] {
            close(found.value.abs(), known.value.abs(), 1e-11, &format!("{what}, {index}: {node:?}"));
        }
    }
}

/// Both routes agree on floors and on the impulse of every pair. The last bounces before a rest may differ in number.
fn impulses_agree(row: &Row<Mixed>, what: &str) {
    let (collisions, other) = agree_on_floors(row, 3.0, (1e-11, what));
    for (pair, known) in other.collisions.iter().enumerate() {
        let found = collisions.all().iter().filter(|found| found.pair == pair);
        let sum = found.map(|found| found.impulse).sum::<f64>();
        let known = known.iter().map(|known| known.impulse).sum();
        close(sum, known, 1e-11, &format!("{what}, pair {pair}"));
    }
    let n: usize = other.collisions.iter().map(Vec::len).sum();
    assert!(n > 5, "{what}: {n} collisions");
}

#[test]
fn reference_the_exact_method_agrees_on_floors_that_slide_and_hit() {
    for law in laws() {
        for meets in [Meets::InAChain, Meets::Columns] {
            for friction in [1e5, 3e5, 1.2e6] {
                let (row, what) = (moat(law, friction, meets, 0.02), format!("{law:?} {meets:?} {friction}"));
                peaks_agree(&row, &what);
                if meets == Meets::InAChain || law.is_compliant() {
                    impulses_agree(&row, &what);
                }
            }
        }
    }
}

/// Grounds that travel move the walls against floors that stick.
#[test]
fn reference_the_exact_method_agrees_on_floors_that_slide_on_travelling_ground() {
    for law in laws() {
        let arrivals = vec![0.0, 0.003, 0.017, 0.02, 0.03, 0.003, 0.017];
        let row = moat(law, 3e5, Meets::InAChain, 0.03).delayed(arrivals).expect("arrivals");
        impulses_agree(&row, &format!("{law:?}"));
    }
}

#[test]
fn reference_the_exact_method_agrees_on_floors_that_slide_with_links() {
    let link = |left: usize, right: Point, law: LinkLaw| Link {
        relation: Relation {
            left: left.into(),
            right,
            offset: 0.0,
        },
        law,
    };
    let springs = |yield_force: f64| {
        LinkLaw::Spring(Spring {
            stiffness: 2e7,
            yield_force,
            hardening: 0.05,
            damping: 1e5,
        })
    };
    let restrainer = LinkLaw::Restrainer(Restrainer {
        stiffness: 4e7,
        yield_force: 3e5,
        slack: 0.01,
    });
    let braced = LinkLaw::Braced(Braced {
        stiffness: 5e7,
        coefficient: 4e5,
        inverse_exponent: 2,
    });
    for law in laws() {
        for (n, one) in [springs(1e5), restrainer, braced].into_iter().enumerate() {
            let links = vec![link(1, 2.into(), one), link(2, Point::Ground(2), springs(f64::INFINITY))];
            let row = moat(law, 3e5, Meets::InAChain, 0.02).linked(links).expect("links");
            impulses_agree(&row, &format!("{law:?} {n}"));
        }
    }
}

/// A tower on isolators that never slide moves as the fixed tower does.
#[test]
fn limit_a_base_that_never_slides_is_a_fixed_base() {
    for law in laws() {
        let of = |held: bool| {
            let first = |mass: f64, stiffness: f64| {
                let node = Node::structure(mass, 2e5, elastic(stiffness));
                if held { floor(0, mass, 2e5, elastic(stiffness)) } else { node }
            };
            let mut nodes = vec![Node::structure(3e5, 0.0, sliding(1e6, 1e9))];
            nodes.extend([first(2e5, 1e8), Node::structure(1e5, 1e5, elastic(3e8))]);
            let nodes = if held { nodes } else { nodes.split_off(1) };
            let last = nodes.len() - 1;
            let row = Row::new(nodes, vec![Pair::of_floors(last - 1, last, 0.005, law)]).expect("a row");
            run(&row, &super::storeys::ground(), 3.0).structures.split_off(last - 1)
        };
        for (one, other) in of(true).iter().zip(of(false)) {
            close(one.displacement.value, other.displacement.value, 1e-11, "peak");
            close(one.transferred_momentum, other.transferred_momentum, 1e-11, "momentum");
        }
    }
}
