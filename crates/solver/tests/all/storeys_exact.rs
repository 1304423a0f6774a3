//! Elastic buildings of several storeys by the exact method: against the closed form of their modes, against stepping at small steps, and
//! in cases with known answers.

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Clock, Elastic, Exact, Excitation, Histories, Hysteretic, Integrator, Node, Pair, Rk4, Row, SimultaneousImpacts, Support, Work,
};

use crate::common::{STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, ground, yielding};
use crate::towers::{Rayleigh, Tower, row, uniform};
use crate::watch::Watch;

pub(crate) const DAMPING: Rayleigh = Rayleigh { alpha: 0.5, beta: 1.5e-3 };

pub(crate) const EXACT: Integrator = exact(1e-16);

pub(crate) const fn exact(tolerance: f64) -> Integrator {
    Integrator::Exact(Exact {
        tolerance,
        simultaneous_impacts: SimultaneousImpacts::Together,
    })
}

/// Histories at the samples of at most ten seconds of shaking.
pub(crate) fn histories<Column: Hysteretic>(row: &Row<Column>, method: Integrator, (clock, samples): (Clock, &[f64])) -> (Histories, Work) {
    let mut histories = Histories::new(row.nodes().len(), 0.01, clock.time(clock.n_steps));
    let excitation = Excitation::new(0.01, samples).expect("the ground motion is finite");
    let work = method.watch(row, excitation, clock, &mut histories).expect("the run ends");
    (histories, work)
}

/// Largest difference of the displacements of nodes of two runs, relative to the largest displacement.
pub(crate) fn distance(a: &Histories, b: &Histories, nodes: impl Iterator<Item = (usize, usize)>) -> f64 {
    let (mut most, mut off) = (0.0_f64, 0.0_f64);
    for (left, right) in nodes {
        for (a, b) in a.of(left).states.iter().zip(&b.of(right).states) {
            most = most.max(a.displacement.abs());
            off = off.max((a.displacement - b.displacement).abs());
        }
    }
    off / most
}

pub(crate) fn same(n_nodes: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n_nodes).zip(0..n_nodes)
}

/// A common gap and law between all floors that face each other.
pub(crate) fn facing(gap: f64, law: ContactLaw) -> impl Fn(usize, usize, [usize; 2]) -> Option<Pair> {
    move |_, _, [left, right]| Some(Pair::of_floors(left, right, gap, law))
}

/// Elastic towers of unequal storeys.
fn towers() -> [Tower<Elastic>; 2] {
    let column = |stiffness| Elastic { stiffness };
    [
        vec![(9e4, column(4e7)), (8e4, column(3e7)), (7e4, column(2.5e7)), (5e4, column(1.5e7))],
        vec![(3e5, column(6e8)), (2e5, column(5e8)), (2e5, column(4e8))],
    ]
}

/// Displacements at the samples of an elastic row without contact, by its modes. Each mode is a damped oscillator under a load that is
/// linear between samples.
fn by_modes(row: &Row<Elastic>, damping: Rayleigh, samples: &[f64]) -> Vec<DVector<f64>> {
    let n = row.nodes().len();
    let mut stiffness = DMatrix::<f64>::zeros(n, n);
    let roots = DVector::from_fn(n, |node, _| (1.0 / row.nodes()[node].inverse_mass).sqrt());
    for (node, floor) in row.nodes().iter().enumerate() {
        let k = floor.column.stiffness;
        stiffness[(node, node)] += k;
        if let Support::Floor(floor) = floor.support {
            stiffness[(floor.below, floor.below)] += k;
            stiffness[(node, floor.below)] -= k;
            stiffness[(floor.below, node)] -= k;
        }
    }
    let scaled = DMatrix::from_fn(n, n, |i, j| stiffness[(i, j)] / (roots[i] * roots[j]));
    let modes = SymmetricEigen::new(scaled);
    let mut answer = vec![DVector::zeros(n); samples.len()];
    for (mode, square) in modes.eigenvalues.iter().enumerate() {
        let shape = modes.eigenvectors.column(mode);
        let (omega, part) = (square.sqrt(), shape.dot(&roots));
        let half = 0.5 * (damping.alpha + damping.beta * square);
        let damped = (square - half * half).sqrt();
        let (decay, sine, cosine) = (libm::exp(-half * 0.01), libm::sin(damped * 0.01), libm::cos(damped * 0.01));
        let (mut q, mut rate) = (0.0, 0.0);
        for (step, ends) in samples.windows(2).enumerate() {
            // The particular solution A + Bt of q̈ + 2hq̇ + ω²q = −Γ a_g.
            let slope = -part * (ends[1] - ends[0]) / 0.01 / square;
            let line = -part * ends[0] / square - 2.0 * half * slope / (omega * omega);
            let (a, b) = (q - line, rate - slope);
            let b = (b + half * a) / damped;
            let free = decay * (a * cosine + b * sine);
            q = free + line + slope * 0.01;
            rate = slope - half * free + decay * damped * (b * cosine - a * sine);
            let floors = shape.component_div(&roots) * q;
            answer[step + 1] += floors;
        }
    }
    answer
}

/// Largest distance of floors from a solution by modes, relative to the largest displacement.
fn off(histories: &Histories, nodes: &[usize], wanted: &[DVector<f64>]) -> f64 {
    let (mut most, mut off) = (0.0_f64, 0.0_f64);
    for (floor, node) in nodes.iter().enumerate() {
        for (state, wanted) in histories.of(*node).states.iter().zip(wanted) {
            most = most.max(wanted[floor].abs());
            off = off.max((state.displacement - wanted[floor]).abs());
        }
    }
    off / most
}

#[test]
fn reference_free_flight_is_that_of_the_modes() {
    let samples = ground();
    for tower in towers() {
        let (row, levels) = row(&[tower], DAMPING, |_, _, _| None);
        let wanted = by_modes(&row, DAMPING, &samples);
        let (found, _) = histories(&row, EXACT, (clock(0.01, 10.0), &samples));
        let off = off(&found, levels.of(0), &wanted);
        assert!(off < 1e-12, "{off:e}");
    }
}

#[test]
fn reference_towers_at_rest_against_each_other_are_one_tower() {
    // Under a constant push to the right, the soft tower on the left leans on the stiff tower with every floor.
    let samples = vec![-3.0; 100];
    let column = |stiffness| Elastic { stiffness };
    let tower = |mass, stiffness| uniform(3, mass, column(stiffness));
    let plastic = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 });
    let two = [tower(5e4, 1e7), tower(1e5, 9e7)];
    let (pair, levels) = row(&two, DAMPING, facing(0.0, plastic));
    let (one, _) = row(&[tower(1.5e5, 1e8)], DAMPING, |_, _, _| None);
    let wanted = by_modes(&one, DAMPING, &samples);
    // The right tower alone would swing back after half of its first period of 0.47 s; until then both move together.
    let (found, _) = histories(&pair, EXACT, (clock(0.01, 0.2), &samples));
    for building in 0..2 {
        let off = off(&found, levels.of(building), &wanted);
        assert!(off < 1e-12, "building {building}: {off:e}");
    }
    let forces = |node: usize| found.of(node).states.last().map(|state| state.force_from_right);
    for node in levels.of(0) {
        let pushed = forces(*node).is_some_and(|force| force < -1.0);
        assert!(pushed, "{node}: {:?}", forces(*node));
    }
}

#[test]
fn order_stepping_tends_to_the_exact_pounding() {
    let samples = ground();
    // Jumps after a step reduce the Runge-Kutta method to order one; a force that begins like δ^(1/4) reduces it to order 1.2.
    for (law, finest) in [(STEREOMECHANICAL, 2e-4), (VISCOELASTIC, 3e-6)] {
        let (row, _) = row(&towers(), DAMPING, facing(0.01, law));
        let n = row.nodes().len();
        let (best, work) = histories(&row, EXACT, (clock(0.01, 3.0), &samples));
        let errors = [2e-4, 2e-5].map(|step| {
            let steps = (clock(step, 3.0), &samples[..]);
            let (found, stepped) = histories(&row, Integrator::Rk4(Rk4), steps);
            assert!(stepped.touching_steps > 0, "the towers must touch");
            distance(&best, &found, same(n))
        });
        assert!(work.events > 0, "{work:?}");
        assert!(errors[1] < finest && errors[1] < 0.3 * errors[0], "{errors:?}");
    }
}

#[test]
fn limit_one_storey_has_the_bits_of_a_structure() {
    let samples = ground();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let plain = [WEAK, STIFF, WEAK].map(yielding);
        let pairs = crate::common::pairs(3, 0.02, law);
        let row = Row::new(plain.to_vec(), pairs.clone()).expect("a valid row");
        let (alone, work) = histories(&row, EXACT, (clock(0.01, 10.0), &samples));
        // A tower far away that must not affect the structures.
        let levels = pounding_solver::Levels::new(&[1, 1, 1, 3]);
        let mut nodes = plain.to_vec();
        for node in levels.of(3) {
            let floor = yielding(STIFF);
            nodes.push(match node {
                3 => floor,
                _ => floor.on_floor(pounding_solver::Floor {
                    below: node - 1,
                    ground_damping: 1e3,
                }),
            });
        }
        let row = Row::new(nodes, pairs).expect("a valid row");
        let (beside, more) = histories(&row, EXACT, (clock(0.01, 10.0), &samples));
        assert!(more.segments > work.segments, "{more:?}");
        for node in 0..3 {
            assert_eq!(alone.of(node).states, beside.of(node).states, "{node}");
        }
    }
}

#[test]
fn limit_identical_towers_never_touch() {
    let samples = ground();
    let tower = towers()[0].clone();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let (row, levels) = row(&[tower.clone(), tower.clone()], DAMPING, facing(1e-9, law));
        let (found, _) = histories(&row, EXACT, (clock(0.01, 10.0), &samples));
        for (left, right) in levels.facing(0) {
            assert_eq!(found.of(left).states, found.of(right).states);
        }
    }
}

#[test]
fn limit_a_mirrored_row_mirrors() {
    let samples = ground();
    let mirrored: Vec<_> = samples.iter().map(|sample| -sample).collect();
    let mut towers = towers().to_vec();
    towers.push(uniform(2, 6e4, Elastic { stiffness: 2e7 }));
    let back: Vec<_> = towers.iter().rev().cloned().collect();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let (there, levels) = row(&towers, DAMPING, facing(0.012, law));
        let (back, turned) = row(&back, DAMPING, facing(0.012, law));
        let (a, _) = histories(&there, EXACT, (clock(0.01, 10.0), &samples));
        let (b, _) = histories(&back, EXACT, (clock(0.01, 10.0), &mirrored));
        let (mut most, mut off) = (0.0_f64, 0.0_f64);
        for building in 0..3 {
            for (node, image) in levels.of(building).iter().zip(turned.of(2 - building)) {
                for (a, b) in a.of(*node).states.iter().zip(&b.of(*image).states) {
                    most = most.max(a.displacement.abs());
                    off = off.max((a.displacement + b.displacement).abs());
                }
            }
        }
        assert!(off <= 1e-12 * most, "{law:?}: {:e}", off / most);
    }
}

#[test]
fn limit_a_tower_out_of_reach_changes_nothing() {
    let samples = ground();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let mut three = towers().to_vec();
        three.push(uniform(4, 6e4, Elastic { stiffness: 2e7 }));
        let (two, levels) = row(&towers(), DAMPING, facing(0.01, law));
        let (three, all) = row(&three, DAMPING, |left, _, [a, b]| {
            facing(if left == 0 { 0.01 } else { 10.0 }, law)(left, 0, [a, b])
        });
        let (alone, _) = histories(&two, EXACT, (clock(0.01, 10.0), &samples));
        let (beside, _) = histories(&three, EXACT, (clock(0.01, 10.0), &samples));
        for building in 0..2 {
            for (node, other) in levels.of(building).iter().zip(all.of(building)) {
                assert_eq!(alone.of(*node).states, beside.of(*other).states, "{node}");
            }
        }
    }
}

#[test]
fn limit_rigid_upper_storeys_are_one_mass() {
    let samples = ground();
    let column = |stiffness| Elastic { stiffness };
    let damping = Rayleigh { alpha: 0.5, beta: 0.0 };
    let stiff = |factor: f64| vec![(5e4, column(2e7)), (3e4, column(2e7 * factor)), (2e4, column(2e7 * factor))];
    let single = Node::structure(1e5, 0.5e5, column(2e7));
    let single = Row::new(vec![single], vec![]).expect("a valid row");
    let (wanted, _) = histories(&single, EXACT, (clock(0.01, 5.0), &samples));
    let errors = [1e3, 1e5].map(|factor| {
        let (row, _) = row(&[stiff(factor)], damping, |_, _, _| None);
        let (found, _) = histories(&row, EXACT, (clock(0.01, 5.0), &samples));
        distance(&wanted, &found, (0..1).map(|_| (0, 2)))
    });
    assert!(errors[1] < 1e-4 && errors[1] < 0.02 * errors[0], "{errors:?}");
}
