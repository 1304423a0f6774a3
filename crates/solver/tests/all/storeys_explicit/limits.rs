//! Bit-for-bit equalities, stability, and allocations.

use nalgebra::DMatrix;
use pounding_contact::ContactLaw;
use pounding_solver::{
    Bilinear, Elastic, Excitation, Floor, Histories, Levels, Node, Peaks, Row, RunError, State, Storey, Support, TransferredMomentum,
};

use super::{EXPLICIT, elastic, plastic, side_by_side, soft, started, stiff};
use crate::allocations::ALLOCATIONS;
use crate::common::{CENTRAL, STEREOMECHANICAL, STIFF, VERLET, VISCOELASTIC, WEAK, clock, ground, histories, pairs, yielding};
use crate::towers::Tower;
use crate::watch::Watch;

const LAWS: [ContactLaw; 2] = [STEREOMECHANICAL, VISCOELASTIC];

/// A tower of one storey, equal to the structure.
fn house(node: &Node<Bilinear>) -> Tower<Bilinear> {
    vec![(1.0 / node.inverse_mass, node.column)]
}

fn states<'a>(histories: &'a Histories, levels: &Levels, building: usize) -> Vec<&'a [State]> {
    let floors = levels.of(building).iter();
    floors.map(|node| &histories.of(*node).states[..]).collect()
}

#[test]
fn limit_houses_beside_a_tower_are_structures_of_one_storey() {
    // Two structures that collide, alone and next to a tower out of reach: rows with floors on floors use other loops.
    let nodes = [yielding(WEAK), yielding(STIFF)];
    for law in LAWS {
        let lean = Row::new(nodes.to_vec(), pairs(2, 0.02, law)).unwrap();
        let towers = [house(&nodes[0]), house(&nodes[1]), soft(plastic)];
        let (rich, levels) = side_by_side(&towers, &[0.02, 10.0], law);
        assert_eq!(levels.of(2), [2, 3, 4]);
        let mut together = rich.nodes().to_vec();
        // The paper's damping; the tower has another damping.
        together[..2].copy_from_slice(&nodes);
        let rich = Row::new(together, rich.pairs().to_vec()).unwrap();
        for (name, method) in EXPLICIT {
            let (lean, work) = histories(&lean, method, &ground(), clock(0.005, 10.0));
            let (rich, _) = histories(&rich, method, &ground(), clock(0.005, 10.0));
            assert!(work.touching_steps > 0, "{name}: the pair must collide");
            for index in 0..2 {
                assert_eq!(lean.of(index), rich.of(index), "{name}, {index}");
            }
        }
    }
}

#[test]
fn limit_a_building_of_one_storey_is_a_structure() {
    let (storey, levels) = ((75e3, 2.056e6), Levels::new(&[1]));
    let column = Elastic { stiffness: storey.1 };
    let floor = levels.floor(
        0,
        Storey {
            mass: storey.0,
            damping: 0.001_447 * storey.1,
            ground_damping: 0.5712 * storey.0,
            column,
        },
    );
    let structure = crate::common::elastic((storey.0, storey.1, 0.0));
    let [floor, structure] = [floor, structure].map(|node| Row::new(vec![node], vec![]).unwrap());
    for (name, method) in EXPLICIT {
        let run = |row| histories(row, method, &ground(), clock(0.01, 10.0)).0;
        assert_eq!(run(&floor), run(&structure), "{name}");
    }
}

#[test]
fn limit_a_building_out_of_reach_changes_nothing() {
    for law in LAWS {
        let near = [soft(plastic), stiff(2, plastic)];
        let all = [soft(plastic), stiff(2, plastic), soft(plastic)];
        let (two, of_two) = side_by_side(&near, &[0.01], law);
        let (three, of_three) = side_by_side(&all, &[0.01, 10.0], law);
        let (one, of_one) = side_by_side(&all[2..], &[], law);
        for (name, method) in EXPLICIT {
            let run = |row| histories(row, method, &ground(), clock(0.005, 10.0));
            let ((two, work), (three, _), (one, _)) = (run(&two), run(&three), run(&one));
            assert!(work.touching_steps > 0, "{name}: the towers must collide");
            for building in 0..2 {
                assert_eq!(
                    states(&two, &of_two, building),
                    states(&three, &of_three, building),
                    "{name}, {building}"
                );
            }
            assert_eq!(states(&one, &of_one, 0), states(&three, &of_three, 2), "{name}");
        }
    }
}

#[test]
fn limit_a_mirrored_row_of_towers_mirrors() {
    let reversed: Vec<f64> = ground().iter().map(|sample| -sample).collect();
    let towers = [soft(plastic), stiff(2, plastic), stiff(3, plastic), soft(plastic)];
    // Impacts of three buildings at an instant are solved from left to right, and mirror only to rounding: two buildings are compared.
    for (law, n) in [(STEREOMECHANICAL, 2), (VISCOELASTIC, 4)] {
        let towers = &towers[..n];
        let gaps = &[0.01, 0.0, 0.015][..n - 1];
        let reversed_gaps: Vec<_> = gaps.iter().rev().copied().collect();
        let mirrored: Vec<_> = towers.iter().rev().cloned().collect();
        let (row, levels) = side_by_side(towers, gaps, law);
        let (mirror, mirrored) = side_by_side(&mirrored, &reversed_gaps, law);
        for (name, method) in EXPLICIT {
            let (there, work) = histories(&row, method, &ground(), clock(0.005, 10.0));
            let (back, _) = histories(&mirror, method, &reversed, clock(0.005, 10.0));
            assert!(work.touching_steps > 10, "{name}: the row must collide");
            for building in 0..n {
                let floors = states(&there, &levels, building);
                for (left, right) in floors.iter().zip(states(&back, &mirrored, n - 1 - building)) {
                    let unlike = left.iter().zip(right).position(|(left, right)| {
                        (left.displacement + right.displacement).abs() > 0.0 || (left.acceleration + right.acceleration).abs() > 0.0
                    });
                    assert_eq!(unlike, None, "{name}, {law:?}, building {building}");
                }
            }
        }
    }
}

/// Largest circular frequency of a tower alone \[rad/s\], and the shape of that mode.
fn highest_mode(row: &Row<Elastic>) -> (f64, Vec<f64>) {
    let nodes = row.nodes();
    let n = nodes.len();
    let root = |index: usize| nodes[index].inverse_mass.sqrt();
    let stiffness = |index: usize| nodes[index].column.stiffness;
    let matrix = DMatrix::from_fn(n, n, |i, j| {
        let above = if i + 1 < n { stiffness(i + 1) } else { 0.0 };
        let entry = match (i, j) {
            _ if i == j => stiffness(i) + above,
            _ if i.abs_diff(j) == 1 => -stiffness(i.max(j)),
            _ => 0.0,
        };
        root(i) * entry * root(j)
    });
    let modes = matrix.symmetric_eigen();
    let last = modes.eigenvalues.imax();
    let shape = modes.eigenvectors.column(last);
    let shape = (0..n).map(|index| root(index) * shape[index]).collect();
    (modes.eigenvalues[last].sqrt(), shape)
}

#[test]
fn extreme_the_critical_time_step_is_that_of_the_highest_mode() {
    let (row, _) = side_by_side(&[soft(elastic)], &[], STEREOMECHANICAL);
    let (omega, shape) = highest_mode(&row);
    let row = started(&row, |node| (shape[node], 0.0));
    let amplitude = shape.iter().fold(0.0, |sum: f64, u| sum.max(u.abs()));
    for (name, method) in EXPLICIT {
        let largest = |part: f64| {
            let (histories, _) = histories(&row, method, &[0.0], clock(part * 2.0 / omega, 100.0));
            let last = (0..3).filter_map(|node| histories.of(node).states.last());
            last.fold(0.0, |sum: f64, state| sum.max(state.displacement.abs()))
        };
        let (below, above) = (largest(0.999), largest(1.001));
        assert!(below < amplitude, "{name}: {below:e} at a step below the limit");
        assert!(above > 1e3 * amplitude, "{name}: {above:e} at a step above it");
    }
}

#[test]
fn extreme_a_tower_that_diverges_ends_the_run() {
    let (row, _) = side_by_side(&[soft(elastic)], &[], STEREOMECHANICAL);
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    for method in [CENTRAL, VERLET] {
        let error = method.watch(&row, excitation, clock(0.1, 1000.0), &mut ());
        let diverged = matches!(error, Err(RunError::Diverged { structure, .. }) if structure < 3);
        assert!(diverged, "{method:?}: {error:?}");
    }
}

#[test]
fn extreme_rigid_dashpots_make_one_mass() {
    // With dashpots that prevent any drift, the tower is a structure of its whole mass on its lowest columns.
    let damping = |node: usize| if node == 0 { 1e5 } else { 1e14 };
    let (row, _) = side_by_side(&[soft(elastic)], &[], STEREOMECHANICAL);
    let nodes = row.nodes().iter().enumerate().map(|(index, node)| Node {
        damping: damping(index),
        support: match node.support {
            Support::Floor(floor) => Support::Floor(Floor {
                ground_damping: 0.0,
                ..floor
            }),
            ground @ Support::Ground => ground,
        },
        ..*node
    });
    let tower = Row::new(nodes.collect(), vec![]).unwrap();
    let one = Node::structure(2.9e5, 1e5, Elastic { stiffness: 6e7 });
    let one = Row::new(vec![one], vec![]).unwrap();
    for (name, method) in EXPLICIT {
        let run = |row: &Row<Elastic>| histories(row, method, &ground(), clock(0.002, 5.0)).0;
        let (tower, one) = (run(&tower), run(&one));
        for floor in 0..3 {
            let pairs = tower.of(floor).states.iter().zip(&one.of(0).states);
            let apart = pairs.map(|(a, b)| (a.displacement - b.displacement).abs());
            let apart = apart.fold(0.0, f64::max);
            assert!(apart < 1e-7, "{name}, floor {floor}: {apart:e}");
        }
    }
}

#[test]
fn limit_a_step_of_towers_allocates_nothing() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    for law in LAWS {
        let towers = [soft(plastic), stiff(2, plastic), soft(plastic)];
        let (row, _) = side_by_side(&towers, &[0.01, 0.01], law);
        let n = row.nodes().len();
        for (name, method) in EXPLICIT {
            let count = |duration| {
                let mut recorder = (Peaks::new(n), TransferredMomentum::new(n));
                let before = ALLOCATIONS.get();
                let work = method.watch(&row, excitation, clock(0.005, duration), &mut recorder).unwrap();
                (ALLOCATIONS.get() - before, work)
            };
            let ((short, _), (long, work)) = (count(1.0), count(10.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert_eq!(short, long, "{name}");
        }
    }
}
