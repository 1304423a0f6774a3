//! The exact method in lanes: its results are those of the exact method alone.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, Stereomechanical};
use pounding_lanes::{ExactSideBySide, Excitations, PairSums, SceneSums};
use pounding_solver::{Clock, Closings, Collisions, Elastic, Exact, Excitation, Integrator, Node, Pair, Peaks, Row, SimultaneousImpacts};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use crate::random_rows::{any_law, config};
use crate::steps::own_grounds;
use crate::watch::Watch;

/// Samples of the record every 0.02 s.
pub(crate) const GROUND_STEP: f64 = 0.02;
/// The runs end between two samples.
pub(crate) const CLOCK: Clock = Clock {
    time_step: 0.005,
    n_steps: 801,
};

/// Time between two looks of a run alone at the closing of neighbours: the error of cubics between them is rounding.
const LOOK: f64 = 2e-5;

#[derive(Debug, Clone)]
struct Case {
    /// Mass \[kg\], period \[s\], damping ratio, initial velocity \[m/s\]; the period of a wall is NaN.
    sides: [[f64; 4]; 2],
    gap: f64,
    law: ContactLaw,
}

impl Case {
    fn row(&self) -> Row<Elastic> {
        let node = |[mass, period, ratio, velocity]: [f64; 4]| {
            if period.is_nan() {
                return Node::wall(Elastic { stiffness: 1.0 });
            }
            let omega = 2.0 * std::f64::consts::PI / period;
            let column = Elastic {
                stiffness: mass * omega * omega,
            };
            Node {
                initial_velocity: velocity,
                ..Node::structure(mass, 2.0 * ratio * omega * mass, column)
            }
        };
        row_of(self.sides.map(node), self.gap, self.law)
    }
}

fn cases() -> impl Strategy<Value = Case> {
    let side = || {
        let velocity = prop_oneof![3 => Just(0.0), 1 => -0.3..0.3_f64];
        let log_mass = 4.0..7.0_f64;
        let structure = (log_mass, 0.13..2.0_f64, 0.0..0.3_f64, velocity);
        structure.prop_map(|(log_mass, period, ratio, velocity)| [libm::pow(10.0, log_mass), period, ratio, velocity])
    };
    let right = prop_oneof![4 => side(), 1 => Just([1.0, f64::NAN, 0.0, 0.0])];
    let impulsive = prop_oneof![1 => Just(0.0), 6 => 0.0..1.0_f64]
        .prop_map(|restitution| ContactLaw::Stereomechanical(Stereomechanical { restitution }));
    let law = prop_oneof![1 => impulsive, 2 => any_law()];
    let gap = prop_oneof![1 => Just(0.0), 8 => 0.002..0.08_f64];
    (side(), right, gap, law).prop_map(|(left, right, gap, law)| Case {
        sides: [left, right],
        gap,
        law,
    })
}

/// The largest distance to exact runs with a record, or with periods of structures, that differ by a relative amount `part`.
fn condition(exact: &(Found, f64), case: &Case, ground: &[f64], part: f64) -> f64 {
    let mut slower = case.clone();
    for [_, period, ..] in &mut slower.sides {
        *period *= 1.0 + part;
    }
    let moved = [alone(&case.row(), &scaled(ground, 1.0 + part)), alone(&slower.row(), ground)];
    let moved = moved.map(|moved| moved.expect("it ran before").0);
    moved.iter().map(|moved| distance(exact, moved)).fold(0.0, f64::max)
}

fn settings(tolerance: f64) -> Exact {
    Exact {
        tolerance,
        simultaneous_impacts: SimultaneousImpacts::Together,
    }
}

/// Peak displacements and closing \[m\], sum and largest of the impulses \[N·s\], and peak force \[N\] with the number of collisions.
pub(crate) type Found = ([f64; 5], [f64; 2]);

/// Results of the exact method for a row alone, and the total momentum \[N·s\] of approach over all touches.
pub(crate) fn alone(row: &Row<Elastic>, ground: &[f64]) -> Option<(Found, f64)> {
    let excitation = Excitation::new(GROUND_STEP, ground).expect("the record is finite");
    let walls = row.nodes().iter().map(Node::is_wall).collect();
    let mut recorder = (Peaks::new(2), Collisions::new(2, row.pairs()), Closings::new(walls, LOOK));
    Integrator::Exact(settings(1e-14))
        .watch(row, excitation, CLOCK, &mut recorder)
        .ok()?;
    let (peaks, collisions, closings) = recorder;
    let mut tally = PairSums {
        closing: closings.of(0).map(|closing| closing.distance),
        ..PairSums::default()
    };
    let inverse_masses = row.nodes().iter().map(|node| node.inverse_mass);
    let reduced_mass = 1.0 / inverse_masses.sum::<f64>();
    let mut momentum = 0.0;
    for one in collisions.all() {
        momentum += reduced_mass * one.approach_speed.unwrap_or(0.0);
        tally.collisions += 1.0;
        tally.impulse += one.impulse;
        tally.largest_impulse = tally.largest_impulse.max(one.impulse);
        tally.peak_force = tally.peak_force.max(one.peak_force.unwrap_or(0.0));
    }
    let peak = |node| peaks.of(node).displacement.value;
    Some((found([peak(0), peak(1)], tally), momentum))
}

fn found([left, right]: [f64; 2], tally: PairSums) -> Found {
    let closing = tally.closing.expect("asked for");
    let numbers = [left, right, closing, tally.impulse, tally.largest_impulse];
    (numbers, [tally.peak_force, tally.collisions])
}

/// Results of rows in lanes; `None` for rows that must run alone.
pub(crate) fn beside(rows: &[Row<Elastic>], ground: &[f64], tolerance: f64) -> Vec<Option<Found>> {
    let excitation = Excitation::new(GROUND_STEP, ground).expect("the record is finite");
    beside_under(rows, excitation.into(), tolerance)
}

fn beside_under(rows: &[Row<Elastic>], excitations: Excitations<'_>, tolerance: f64) -> Vec<Option<Found>> {
    let together = ExactSideBySide::new(settings(tolerance), excitations, CLOCK).expect("valid");
    let together = together.with_closings(true);
    let mut tallies = SceneSums::default();
    tallies.begin(rows.len(), 2, 1);
    let places: Vec<_> = rows.iter().enumerate().collect();
    together.run(&places, &mut tallies);
    let tell = |scene: usize| {
        let peaks = [0, 1].map(|structure| tallies.displacement(scene, structure));
        let told = tallies.is_told(scene);
        told.then(|| found(peaks, tallies.pair(scene, 0)))
    };
    (0..rows.len()).map(tell).collect()
}

/// The largest difference of peaks, impulses and forces, relative to the larger of both.
///
/// Peaks are compared without their signs: if both sides are almost equally far, less than the error decides. Closings are differences of
/// displacements. Impulses below the momentum of approach are relative to this momentum, like the tolerance: a soft touch of long duration
/// passes on a hundredth of it.
pub(crate) fn distance((one, momentum): &(Found, f64), other: &Found) -> f64 {
    let relative = |a: f64, b: f64, least: f64| (a.abs() - b.abs()).abs() / a.abs().max(b.abs()).max(least);
    let displacement = one.0[0].abs().max(one.0[1].abs()).max(1e-12);
    let momentum = momentum.max(1e-12);
    let least = [1e-12, 1e-12, displacement, momentum, momentum];
    let peaks = one.0.iter().zip(&other.0).zip(least);
    let peaks = peaks.map(|((a, b), least)| relative(*a, *b, least)).fold(0.0, f64::max);
    peaks.max(relative(one.1[0], other.1[0], 1e-12))
}

pub(crate) fn scaled(ground: &[f64], by: f64) -> Vec<f64> {
    ground.iter().map(|a| by * a).collect()
}

proptest! {
    #![proptest_config(config(24))]

    /// Distances are compared with the [condition] of the scene.
    #[test]
    fn reference_what_is_told_is_what_the_exact_method_finds_alone(
        cases in prop::collection::vec(cases(), 11),
        ground in prop::collection::vec(-4.0..4.0_f64, 190),
    ) {
        let rows: Vec<_> = cases.iter().map(Case::row).collect();
        let tolerance = 1e-9;
        let told = beside(&rows, &ground, tolerance);
        // Long steps leave touches that graze a parting to runs alone.
        let coarse = beside(&rows, &ground, 1e-3);
        let lost = told.iter().zip(&coarse).filter(|(fine, coarse)| fine.is_some() && coarse.is_none());
        prop_assert!(lost.count() <= 1, "{told:?} {coarse:?}");
        let middle = beside(&rows, &ground, 1e-6);
        let all = [(tolerance, told), (1e-6, middle), (1e-3, coarse)];
        let all = all.iter().flat_map(|(tolerance, told)| {
            cases.iter().zip(rows.iter().zip(told)).map(move |case| (*tolerance, case))
        });
        for (tolerance, (case, (row, told))) in all {
            let Some(told) = told else {
                continue;
            };
            let exact = alone(row, &ground);
            prop_assert!(exact.is_some(), "{case:?}");
            let exact = exact.expect("asserted");
            let part = if case.law.impulsive().is_some() { 1e-13 } else { tolerance };
            let condition = condition(&exact, case, &ground, part);
            let error = distance(&exact, told);
            prop_assert!(error <= 100.0 * (part + condition), "{error:e} {condition:e} {case:?} {exact:?} {told:?}");
            if condition < 1e-6 && tolerance < 1e-3 {
                prop_assert!((exact.0.1[1] - told.1[1]).abs() < 0.5, "{case:?}");
            }
        }
    }

    /// The other scenes of a run do not change any bit.
    #[test]
    fn limit_a_lane_does_not_know_the_others(
        cases in prop::collection::vec(cases(), 19),
        ground in prop::collection::vec(-4.0..4.0_f64, 60),
    ) {
        let rows: Vec<_> = cases.iter().map(Case::row).collect();
        let mut reversed = rows.clone();
        reversed.reverse();
        let forth = beside(&rows, &ground, 1e-8);
        let mut back = beside(&reversed, &ground, 1e-8);
        back.reverse();
        let bits = |all: Vec<Option<Found>>| -> Vec<_> {
            all.into_iter().map(|one| one.map(|(a, b)| (a.map(f64::to_bits), b.map(f64::to_bits)))).collect()
        };
        prop_assert_eq!(bits(forth), bits(back));
        let single: Vec<_> = rows.iter().flat_map(|row| beside(std::slice::from_ref(row), &ground, 1e-8)).collect();
        prop_assert_eq!(bits(beside(&rows, &ground, 1e-8)), bits(single.clone()));
        // More than one batch, with lanes in contact that change scenes all the time.
        let many: Vec<_> = rows.iter().cycle().take(300).cloned().collect();
        let again: Vec<_> = single.iter().cycle().take(300).copied().collect();
        prop_assert_eq!(bits(beside(&many, &ground, 1e-8)), bits(again.clone()));
        let (mut many, mut again) = (many, again);
        many.reverse();
        again.reverse();
        prop_assert_eq!(bits(beside(&many, &ground, 1e-8)), bits(again));
    }

    /// A scene has the same bits with a separate ground motion and with a common one.
    #[test]
    fn limit_a_lane_does_not_know_the_other_motions(
        cases in prop::collection::vec(cases(), 19),
        ground in prop::collection::vec(-4.0..4.0_f64, 190),
    ) {
        let rows: Vec<_> = cases.iter().map(Case::row).cycle().take(300).collect();
        let grounds = own_grounds(&ground, 19);
        let single = rows.iter().zip(grounds.iter().cycle());
        let single = single.map(|(row, ground)| beside(std::slice::from_ref(row), ground, 1e-8)[0]);
        let shaken = grounds.iter().map(|ground| Excitation::new(GROUND_STEP, ground));
        let shaken: Vec<_> = shaken.map(|shaken| shaken.expect("the record is finite")).collect();
        let excitations: Vec<_> = shaken.iter().copied().cycle().take(300).collect();
        let found = beside_under(&rows, Excitations::of(&excitations), 1e-8);
        let bits = |one: Option<Found>| one.map(|(a, b)| (a.map(f64::to_bits), b.map(f64::to_bits)));
        for (scene, (found, wanted)) in found.into_iter().zip(single.collect::<Vec<_>>()).enumerate() {
            prop_assert_eq!(bits(found), bits(wanted), "{}", scene);
        }
    }
}

/// Rows that are not told run alone, which costs most of the savings of lanes.
#[test]
fn limit_most_random_rows_are_told() {
    let mut runner = TestRunner::deterministic();
    let grounds = prop::collection::vec(-4.0..4.0_f64, 190);
    let (mut told, mut all) = (0, 0);
    for _ in 0..40 {
        let drawn = (prop::collection::vec(cases(), 19), grounds.clone()).new_tree(&mut runner);
        let (cases, ground) = drawn.expect("rows are drawn").current();
        let rows: Vec<_> = cases.iter().map(Case::row).collect();
        told += beside(&rows, &ground, 1e-9).iter().flatten().count();
        all += rows.len();
    }
    assert!(10 * told >= 9 * all, "{told} of {all} are told");
}

/// In a contact of a few long steps, polynomials missed where the forces of these laws end, and the error estimate of the step did not show
/// the loss.
#[test]
fn issue_a_parting_that_the_polynomial_missed_is_tried_again() {
    let pair = FreePair {
        reduced_mass: 1e5,
        approach_speed: 0.3,
    };
    for (law, stiffness, e) in [(LawName::ModifiedLinearViscoelastic, 1e10, 0.1), (LawName::KelvinVoigt, 1e9, 0.4)] {
        let calibrated = law.calibrated(stiffness, e, Calibration::Exact, &pair);
        let calibrated = calibrated.expect("valid");
        let row = |speed: u32| {
            let speed = 0.01 * libm::pow(1.2, f64::from(speed));
            let case = Case {
                sides: [[1e5, 1e5, 0.0, speed], [1.0, f64::NAN, 0.0, 0.0]],
                gap: 0.005 * speed,
                law: calibrated,
            };
            case.row()
        };
        let (rows, ground): (Vec<_>, _) = ((0..40).map(row).collect(), [0.0; 30]);
        for (row, told) in rows.iter().zip(beside(&rows, &ground, 1e-3)) {
            let (told, exact) = (told.expect("told"), alone(row, &ground).expect("it runs"));
            let error = (told.0[2] / exact.0.0[2] - 1.0).abs();
            assert!(error < 1e-3, "{law:?}: {error:e}");
        }
    }
}

/// Touches at samples, within rounding on either side: contact steps without length, and contacts that begin with an interval.
#[test]
fn extreme_touches_at_samples() {
    let law = LawName::NonlinearViscoelastic.calibrated(1e9, 0.6, Calibration::Exact, &FreePair::UNIT);
    let law = law.expect("valid");
    let ground = [0.0; 60];
    let rows: Vec<_> = (1..=40)
        .map(|sample| {
            let case = Case {
                // Nearly free: the structure arrives at its target.
                sides: [[1e5, 1e5, 0.0, 0.5], [1.0, f64::NAN, 0.0, 0.0]],
                gap: 0.5 * GROUND_STEP * f64::from(sample),
                law,
            };
            case.row()
        })
        .collect();
    for tolerance in [1e-9, 1e-3] {
        for (row, told) in rows.iter().zip(beside(&rows, &ground, tolerance)) {
            let (told, exact) = (told.expect("told"), alone(row, &ground).expect("it runs"));
            let error = distance(&exact, &told);
            assert!(error < 10.0 * tolerance, "{error:e}: {exact:?} {told:?}");
            assert!((exact.0.1[1] - told.1[1]).abs() < 0.5, "{exact:?} {told:?}");
        }
    }
}

pub(crate) fn row_of(nodes: [Node<Elastic>; 2], gap: f64, law: ContactLaw) -> Row<Elastic> {
    let pair = Pair::of_floors(0, 1, gap, law);
    Row::new(nodes.to_vec(), vec![pair]).expect("the row is valid")
}
