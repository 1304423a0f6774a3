//! Rows of towers that must agree with other rows.

use pounding_solver::{Bilinear, Node};

use super::{DAMPING, SPRING, all, facing, plastic, run, sampled, towers};
use crate::allocations::ALLOCATIONS;
use crate::common::{STEREOMECHANICAL, VISCOELASTIC, clock, ground};
use crate::towers::{Tower, row, uniform};

#[test]
fn limit_one_storey_beside_towers_is_a_structure() {
    // Three structures of one storey, alone and next to a tower out of reach, which makes them buildings.
    let kinds = [(75e3, 2.056e6), (3e6, 1.316e9), (120e3, 5e6)];
    let structures: Vec<Tower<Bilinear>> = kinds.iter().map(|&(mass, stiffness)| vec![(mass, plastic(stiffness))]).collect();
    let mut beside = structures.clone();
    beside.push(uniform(4, 1e5, plastic(5e7)));
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let near = |left: usize, _, [a, b]: [usize; 2]| {
            let gap = if left < 2 { 0.01 } else { 10.0 };
            facing(gap, law)(left, 0, [a, b])
        };
        let (lean, _) = row(&structures, DAMPING, near);
        let (rich, levels) = row(&beside, DAMPING, near);
        let plain = kinds.iter().map(|&(mass, stiffness)| {
            let damping = DAMPING.alpha * mass + DAMPING.beta * stiffness;
            Node::structure(mass, damping, plastic(stiffness))
        });
        assert_eq!(lean.nodes(), plain.collect::<Vec<_>>(), "the nodes themselves");
        let alone = row(&beside[3..], DAMPING, near).0;
        for (name, method) in all() {
            let run = |row| sampled(row, method, &ground(), clock(5e-3, 10.0));
            let ((lean, work), (rich, _), (alone, _)) = (run(&lean), run(&rich), run(&alone));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert_eq!(lean[..], rich[..3], "{name}");
            let tower: Vec<_> = levels.of(3).iter().map(|node| rich[*node].clone()).collect();
            assert_eq!(tower, alone, "{name}: the tower");
        }
    }
}

#[test]
fn limit_buildings_out_of_reach_change_nothing() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let [left, right] = towers(plastic);
        let far = uniform(5, 2e5, plastic(6e7));
        let pair = |building: usize, _, nodes| {
            let gap = if building == 0 { 0.005 } else { 10.0 };
            facing(gap, law)(building, 0, nodes)
        };
        let (two, levels) = row(&[left.clone(), right.clone()], DAMPING, pair);
        let (three, more) = row(&[left, right, far], DAMPING, pair);
        for (name, method) in all() {
            let run = |row| sampled(row, method, &ground(), clock(5e-3, 10.0));
            let ((two, work), (three, _)) = (run(&two), run(&three));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            for building in 0..2 {
                for (one, other) in levels.of(building).iter().zip(more.of(building)) {
                    assert_eq!(two[*one], three[*other], "{name}");
                }
            }
        }
    }
}

#[test]
fn limit_a_mirrored_row_of_towers_mirrors() {
    let reversed: Vec<f64> = ground().iter().map(|sample| -sample).collect();
    for law in [STEREOMECHANICAL, SPRING, VISCOELASTIC] {
        let towers = towers(plastic);
        let mirrored: Vec<_> = towers.iter().rev().cloned().collect();
        let (there, levels) = row(&towers, DAMPING, facing(0.005, law));
        let (back, other) = row(&mirrored, DAMPING, facing(0.005, law));
        for (name, method) in all() {
            let (there, work) = sampled(&there, method, &ground(), clock(5e-3, 10.0));
            let (back, _) = sampled(&back, method, &reversed, clock(5e-3, 10.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            let mut apart: f64 = 0.0;
            for building in 0..2 {
                let floors = levels.of(building).iter().zip(other.of(1 - building));
                for (left, right) in floors {
                    for (left, right) in there[*left].iter().zip(&back[*right]) {
                        apart = apart.max((left.displacement + right.displacement).abs());
                    }
                }
            }
            let allowed = if law == STEREOMECHANICAL { 0.0 } else { 1e-12 };
            assert!(apart <= allowed, "{law:?} {name}: {apart:e}");
        }
    }
}

#[test]
fn limit_a_step_of_buildings_allocates_nothing() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let (row, _) = row(&towers(plastic), DAMPING, facing(0.005, law));
        for (name, method) in all() {
            let count = |duration| {
                let before = ALLOCATIONS.get();
                let clock = clock(5e-3, duration);
                let work = run(&row, method, (&ground(), clock), &mut ());
                (ALLOCATIONS.get() - before, work)
            };
            let ((short, _), (long, work)) = (count(1.0), count(10.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert_eq!(short, long, "{name}: ten times the steps, the same allocations");
        }
    }
}
