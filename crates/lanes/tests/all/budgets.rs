//! Runs in lanes that are stopped, and long runs.

use std::sync::atomic::AtomicBool;

use pounding_contact::ContactLaw;
use pounding_lanes::{ExactSideBySide, RowsOf, SceneSums, SideBySide};
use pounding_solver::{Budget, Clock, Elastic, Exact, Excitation, Integrator, Peaks, Row};

use crate::common::{STIFF, VISCOELASTIC, WEAK, elastic, ground, pairs};
use crate::steps::SETTINGS;

/// A stop flag that is set before the run begins.
static STOPPED: AtomicBool = AtomicBool::new(true);
const STOP: Budget = Budget {
    pieces: Budget::PIECES,
    seconds: None,
    stop: Some(&STOPPED),
};
/// More steps than between two checks of the budget.
const LONG: Clock = Clock {
    time_step: 1e-4,
    n_steps: 40_000,
};

fn two(law: ContactLaw) -> Row<Elastic> {
    let nodes = vec![elastic(WEAK), elastic(STIFF)];
    Row::new(nodes, pairs(2, 0.01, law)).expect("a row")
}

/// A stopped run in lanes did not end; its scenes must not be told.
#[test]
fn issue_whoever_stops_ends_runs_side_by_side() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    let row = two(VISCOELASTIC);
    let mut tallies = SceneSums::default();
    for (budget, told) in [(Budget::default(), true), (STOP, false)] {
        let together = SideBySide::new(SETTINGS, excitation, LONG).expect("valid");
        let rows = [&row; 3];
        let steps = [LONG.n_steps; 3];
        let ran = together.within(budget).run(RowsOf::Elastic(&rows), &steps, &mut tallies);
        assert!(ran && (0..3).all(|scene| tallies.is_told(scene) == told), "told: {told}");
        let settings = Exact {
            tolerance: 1e-8,
            ..Exact::default()
        };
        let together = ExactSideBySide::new(settings, excitation, LONG).expect("valid");
        tallies.begin(1, 2, 1);
        together.within(budget).run(&[(0, &row)], &mut tallies);
        assert_eq!(tallies.is_told(0), told);
    }
}

/// Steps in lanes run in parts: the bits remain those of each scene alone, for any length.
#[test]
fn limit_long_runs_side_by_side_have_the_bits_of_each_alone() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    let row = two(VISCOELASTIC);
    let lengths = [1, 65_535, 65_536, 65_537, 100_000, 131_072];
    let clock = |n_steps| Clock { time_step: 5e-5, n_steps };
    {
        let together = SideBySide::new(SETTINGS, excitation, clock(131_072)).expect("valid");
        let mut tallies = SceneSums::default();
        assert!(together.run(RowsOf::Elastic(&[&row; 6]), &lengths, &mut tallies));
        for (scene, length) in lengths.into_iter().enumerate() {
            let mut peaks = Peaks::new(2);
            let alone = Integrator::CentralDifference(SETTINGS).run(&row, excitation, clock(length), &mut peaks);
            alone.expect("the run ends");
            for node in 0..2 {
                let peak = peaks.of(node).displacement.value;
                assert!(
                    !tallies.is_told(scene) || tallies.displacement(scene, node).to_bits() == peak.to_bits(),
                    "{length} steps, structure {node}"
                );
            }
            assert!(length == 1 || tallies.is_told(scene), "{length} steps");
        }
    }
}
