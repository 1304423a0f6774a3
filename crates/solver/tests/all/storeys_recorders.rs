//! Recorders of a run of towers, compared with each other.

use pounding_solver::{Bilinear, Collisions, Excitation, FloorAccelerations, Histories, Ledger, Peaks, Row, Support, TransferredMomentum};

use crate::allocations::allocations;
use crate::common::{RK4, STEREOMECHANICAL, VISCOELASTIC, clock, ground};
use crate::storeys_ledger::{plastic, smooth, strong, towers};
use crate::watch::Watch;

/// All recorders of a run of towers agree.
#[test]
fn limit_recorders_of_one_run_agree_on_every_level() {
    let samples = strong();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let row = towers(plastic, Some(law));
        let (n, run) = (row.nodes().len(), clock(0.001, 5.0));
        let mut recorder = (
            Collisions::new(n, row.pairs()),
            Ledger::new(&row, excitation),
            (
                Peaks::new(n),
                FloorAccelerations::new(n, excitation),
                Histories::new(n, run.time_step, 5.0),
            ),
            TransferredMomentum::new(n),
        );
        RK4.watch(&row, excitation, run, &mut recorder).unwrap();
        let (collisions, ledger, (peaks, accelerations, histories), momentum) = recorder;
        for (index, pair) in row.pairs().iter().enumerate() {
            let of_pair = collisions.all().iter().filter(|it| it.pair == index);
            let impulse: f64 = of_pair.map(|it| it.impulse).sum();
            let booked = ledger.of_pair(index).impulse;
            assert!((impulse / booked - 1.0).abs() < 1e-12, "{index}: {impulse} {booked}");
            // Floors at the ends of a level have one neighbour.
            let alone = |node| row.pairs().iter().filter(move |it| it.left() == node || it.right() == node);
            for node in [pair.left(), pair.right()] {
                let got = momentum.of(node);
                let once = alone(node).count() > 1 || (got / booked - 1.0).abs() < 1e-12;
                assert!(once, "{node}: {got} {booked}");
            }
        }
        check_peaks(&row, &peaks, &histories);
        for node in 0..n {
            let states = histories.of(node).states.iter().enumerate();
            let at = |index: usize| samples[index / 10];
            let known = states.filter(|(index, _)| index % 10 == 0);
            let most = known.map(|(index, state)| (state.acceleration + at(index)).abs());
            let (most, peak) = (most.fold(0.0, f64::max), accelerations.of(node).value.abs());
            assert!(most > 0.0 && peak >= most, "{node}: {peak} {most}");
        }
    }
}

/// Peaks are the largest values of histories of every step.
fn check_peaks(row: &Row<Bilinear>, peaks: &Peaks, histories: &Histories) {
    for (node, floor) in row.nodes().iter().enumerate() {
        let displacement = |node: usize, n: usize| histories.of(node).states[n].displacement;
        let below = match floor.support {
            Support::Ground => None,
            Support::Floor(floor) => Some(floor.below),
        };
        let drift = |n: usize| displacement(node, n) - below.map_or(0.0, |below| displacement(below, n));
        let largest = (0..histories.of(node).states.len()).map(|n| drift(n).abs()).fold(0.0, f64::max);
        let peak = peaks.of(node).drift();
        assert_eq!(peak.value.abs().to_bits(), largest.to_bits(), "{node}");
        let own = peaks.of(node).storey_drift.is_some();
        assert_eq!(own, below.is_some(), "{node}");
        let ductility = peak.value.abs() * floor.column.stiffness / floor.column.yield_force;
        let shear = peaks.of(node).restoring_force.value.abs();
        let yielded = shear >= floor.column.yield_force;
        assert_eq!(ductility > 1.0, yielded, "{node}: {ductility}, {shear}");
    }
}

#[test]
fn limit_recorders_of_towers_allocate_nothing_in_a_step() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    let row = towers(smooth, Some(VISCOELASTIC));
    let n = row.nodes().len();
    let count = |duration| {
        let mut recorder = (
            Peaks::new(n),
            FloorAccelerations::new(n, excitation),
            TransferredMomentum::new(n),
            Ledger::new(&row, excitation),
        );
        let before = allocations();
        RK4.watch(&row, excitation, clock(0.005, duration), &mut recorder).unwrap();
        allocations() - before
    };
    let (short, long) = (count(1.0), count(5.0));
    assert_eq!(short, long, "five times the steps, the same allocations");
    assert!(short > 0, "the counter must count");
}
