//! The lean model equals the rich one, bit for bit, where both apply.

use crate::common::{
    AVERAGE, CENTRAL, HHT, METHODS, MOREAU_JEAN, STEREOMECHANICAL, STIFF, SUBSTEPPED, VERLET, VISCOELASTIC, WEAK, clock, elastic, ground,
    histories, pairs, yielding,
};
use crate::watch::Watch;
use pounding_solver::{Bilinear, Hht, Histories, Integrator, Node, Row, State};

/// Every state of every structure.
fn bits(histories: &Histories, n: usize) -> Vec<Vec<State>> {
    (0..n).map(|index| histories.of(index).states.clone()).collect()
}

#[test]
fn limit_a_gap_too_wide_equals_no_pair() {
    let nodes = vec![yielding(WEAK), yielding(STIFF), yielding(WEAK)];
    let apart = Row::new(nodes.clone(), vec![]).unwrap();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let wide = Row::new(nodes.clone(), pairs(3, 10.0, law)).unwrap();
        for (name, method) in METHODS {
            let run = |row| histories(row, method, &ground(), clock(0.01, 10.0));
            let ((lean, _), (rich, work)) = (run(&apart), run(&wide));
            assert_eq!(bits(&lean, 3), bits(&rich, 3), "{name}");
            assert_eq!(work.touching_steps, 0, "{name}");
        }
    }
}

#[test]
fn limit_a_yield_force_never_reached_equals_elastic() {
    let lean = Row::new(vec![elastic(WEAK), elastic(STIFF)], pairs(2, 0.02, VISCOELASTIC)).unwrap();
    for yield_force in [1e12, f64::INFINITY] {
        let strong = |(mass, stiffness, _)| yielding((mass, stiffness, yield_force));
        let rich = Row::new(vec![strong(WEAK), strong(STIFF)], pairs(2, 0.02, VISCOELASTIC)).unwrap();
        for (name, method) in METHODS {
            let (lean, work) = histories(&lean, method, &ground(), clock(0.005, 10.0));
            let (rich, _) = histories(&rich, method, &ground(), clock(0.005, 10.0));
            assert!(work.touching_steps > 20, "{name}: the structures must collide, {work:?}");
            assert_eq!(bits(&lean, 2), bits(&rich, 2), "{name}");
        }
    }
}

#[test]
fn limit_a_structure_out_of_reach_changes_nothing() {
    // The third structure is far away, then absent: neither the colliding pair nor the third structure may change.
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let mut near_and_far = pairs(3, 0.02, law);
        near_and_far[1].relation.offset = 10.0;
        let three = Row::new(vec![yielding(WEAK), yielding(STIFF), yielding(WEAK)], near_and_far).unwrap();
        let two = Row::new(vec![yielding(WEAK), yielding(STIFF)], pairs(2, 0.02, law)).unwrap();
        let one = Row::new(vec![yielding(WEAK)], vec![]).unwrap();
        for (name, method) in METHODS {
            let run = |row| histories(row, method, &ground(), clock(0.005, 10.0));
            let ((all, work), (pair, _), (alone, _)) = (run(&three), run(&two), run(&one));
            assert!(work.touching_steps > 0, "{name}: the pair must collide");
            assert_eq!(bits(&all, 2), bits(&pair, 2), "{name}");
            assert_eq!(all.of(2), alone.of(0), "{name}");
        }
    }
}

#[test]
fn limit_a_mirrored_row_under_mirrored_shaking_mirrors() {
    let reversed: Vec<f64> = ground().iter().map(|sample| -sample).collect();
    let kinds = [WEAK, (120e3, 5e6, 90e3), STIFF];
    for n in [2, 3] {
        for law in [STEREOMECHANICAL, VISCOELASTIC] {
            let nodes: Vec<_> = kinds[..n].iter().map(|kind| yielding(*kind)).collect();
            let mirrored: Vec<_> = nodes.iter().rev().copied().collect();
            let row = Row::new(nodes, pairs(n, 0.02, law)).unwrap();
            let mirror = Row::new(mirrored, pairs(n, 0.02, law)).unwrap();
            for (name, method) in METHODS {
                let (there, work) = histories(&row, method, &ground(), clock(0.005, 10.0));
                let (back, _) = histories(&mirror, method, &reversed, clock(0.005, 10.0));
                assert!(work.touching_steps > 0, "{name}: the row must collide");
                for index in 0..n {
                    let (left, right) = (&there.of(index).states, &back.of(n - 1 - index).states);
                    let apart = left
                        .iter()
                        .zip(right)
                        .map(|(left, right)| (left.displacement + right.displacement).abs())
                        .fold(0.0, f64::max);
                    // Elimination from left to right is not symmetric. Newton's method stops within its tolerance of 1e-12 of the forces
                    // (300 m/s² in contact) at slightly different values, and ten seconds multiply this.
                    let allowed = match method {
                        Integrator::MoreauJean(_) if law == VISCOELASTIC => 1e-11,
                        Integrator::Newmark(_) | Integrator::Hht(_) if n == 3 && law == VISCOELASTIC => 1e-12,
                        Integrator::CentralDifference(_)
                        | Integrator::Newmark(_)
                        | Integrator::Hht(_)
                        | Integrator::Verlet(_)
                        | Integrator::Rk4(_)
                        | Integrator::MoreauJean(_)
                        | Integrator::Exact(_) => 0.0,
                    };
                    assert!(apart <= allowed, "{name}, {law:?}, structure {index} of {n}: {apart:e}");
                }
            }
        }
    }
}

#[test]
fn limit_a_wall_is_a_neighbour_of_infinite_mass() {
    // A neighbour of 1e30 kg with a circular frequency of 1e6 rad/s moves by 1e-12 m: a wall must give an equal result.
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let heavy = yielding((1e30, 1e42, f64::INFINITY));
        let wall = Node::wall(Bilinear {
            stiffness: 1.0,
            yield_force: f64::INFINITY,
            hardening: 0.0,
        });
        let [wall, heavy] = [wall, heavy].map(|right| Row::new(vec![yielding(WEAK), right], pairs(2, 0.02, law)).unwrap());
        // Only methods without a critical time step can follow such a stiff neighbour.
        for method in [AVERAGE, HHT, MOREAU_JEAN] {
            let run = |row| histories(row, method, &ground(), clock(0.002, 10.0));
            let ((wall, work), (heavy, _)) = (run(&wall), run(&heavy));
            assert!(work.touching_steps > 0, "the structure must reach the wall");
            assert!(
                wall.of(1).states.iter().all(|state| state.displacement == 0.0),
                "a wall stands still"
            );
            for (a, b) in wall.of(0).states.iter().zip(&heavy.of(0).states) {
                assert!((a.displacement - b.displacement).abs() < 1e-9, "{method:?}: {a:?} against {b:?}");
            }
        }
    }
}

#[test]
fn limit_identical_structures_never_touch() {
    for (name, method) in METHODS {
        let row = Row::new(vec![yielding(WEAK); 4], pairs(4, 0.0, VISCOELASTIC)).unwrap();
        let (_, work) = histories(&row, method, &ground(), clock(0.01, 10.0));
        assert_eq!(work.touching_steps, 0, "{name}");
    }
}

#[test]
fn limit_histories_do_not_depend_on_their_interval() {
    let row = Row::new(vec![elastic(WEAK)], vec![]).unwrap();
    let (nodes, _) = histories(&row, CENTRAL, &ground(), clock(0.01, 4.0));
    let mut sparse = Histories::new(1, 0.04, 4.0);
    let samples = ground();
    let excitation = pounding_solver::Excitation::new(0.01, &samples).unwrap();
    CENTRAL.watch(&row, excitation, clock(0.01, 4.0), &mut sparse).unwrap();
    assert_eq!(sparse.of(0).states.len(), 101);
    assert!(
        sparse.of(0).states.iter().eq(nodes.of(0).states.iter().step_by(4)),
        "every fourth node"
    );
}

/// Largest difference of displacements.
fn apart(left: &Histories, right: &Histories, n: usize) -> f64 {
    let of = |index| left.of(index).states.iter().zip(&right.of(index).states);
    (0..n)
        .flat_map(of)
        .map(|(left, right)| (left.displacement - right.displacement).abs())
        .fold(0.0, f64::max)
}

#[test]
fn limit_hht_without_its_damping_equals_average_acceleration() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let row = Row::new(vec![yielding(WEAK), yielding(STIFF)], pairs(2, 0.02, law)).unwrap();
        let undamped = Integrator::Hht(Hht { alpha: 0.0 });
        let run = |method| histories(&row, method, &ground(), clock(0.005, 10.0));
        let ((hht, work), (newmark, _)) = (run(undamped), run(AVERAGE));
        assert!(work.touching_steps > 0, "the row must collide");
        // After a jump the two methods compute the acceleration from different sums.
        let apart = apart(&hht, &newmark, 2);
        assert!(apart < 1e-12, "{law:?}: {apart:e}");
    }
}

#[test]
fn limit_one_motion_by_two_formulas() {
    // Without compliant contact velocity Verlet equals the central difference method, and without impacts Moreau–Jean stepping with θ = 1/2
    // equals average acceleration; only rounding differs.
    let alone = Row::new(vec![yielding(WEAK), yielding(STIFF)], vec![]).unwrap();
    let stereomechanical = pairs(2, 0.02, STEREOMECHANICAL);
    let viscoelastic = pairs(2, 0.02, VISCOELASTIC);
    let row = |pairs| Row::new(vec![yielding(WEAK), yielding(STIFF)], pairs).unwrap();
    for (row, left, right) in [
        (&alone, VERLET, CENTRAL),
        (&row(stereomechanical), VERLET, CENTRAL),
        (&alone, MOREAU_JEAN, AVERAGE),
        (&row(viscoelastic), MOREAU_JEAN, AVERAGE),
    ] {
        let run = |method| histories(row, method, &ground(), clock(0.005, 10.0)).0;
        let apart = apart(&run(left), &run(right), 2);
        assert!(apart < 1e-10, "{left:?} and {right:?}: {apart:e}");
    }
}

#[test]
fn limit_sub_steps_change_nothing_while_nothing_touches() {
    let row = |gap| {
        let nodes = vec![yielding(WEAK), yielding(STIFF)];
        Row::new(nodes, pairs(2, gap, VISCOELASTIC)).unwrap()
    };
    let run = |method, gap| histories(&row(gap), method, &ground(), clock(0.005, 10.0));
    assert_eq!(bits(&run(SUBSTEPPED, 10.0).0, 2), bits(&run(CENTRAL, 10.0).0, 2));
}

#[test]
fn limit_sub_steps_all_the_time_are_a_smaller_step() {
    // Pressed together from the start, the pair always sub-steps: the motion is that of the smaller step.
    let pressed = |velocity, node: Node<Bilinear>| Node {
        initial_velocity: velocity,
        ..node
    };
    let nodes = vec![pressed(0.1, yielding(WEAK)), pressed(-0.1, yielding(STIFF))];
    let row = Row::new(nodes, pairs(2, 0.0, VISCOELASTIC)).unwrap();
    let run = |method: Integrator, dt| {
        let samples = [-1.0; 10];
        let mut histories = Histories::new(2, 0.004, 0.016);
        let excitation = pounding_solver::Excitation::new(0.01, &samples).unwrap();
        let work = method.watch(&row, excitation, clock(dt, 0.016), &mut histories).unwrap();
        (histories, work)
    };
    let ((coarse, work), (fine, _)) = (run(SUBSTEPPED, 0.004), run(CENTRAL, 0.001));
    assert_eq!(work.force_evaluations, 2 * 17, "every step is divided");
    let apart = apart(&coarse, &fine, 2);
    assert!(apart < 1e-14, "{apart:e}");
}
