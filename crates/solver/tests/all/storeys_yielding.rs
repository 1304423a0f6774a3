//! Storeys that yield, harden and yield smoothly, by the exact method.

use pounding_solver::{
    Bilinear, BoucWen, Elastic, Excitation, Hysteretic, Impact, Integrator, Recorder, Response, RestoringForce, Rk4, Row, Smoothness, Span,
};

use crate::common::{STEREOMECHANICAL, VISCOELASTIC, clock, ground};
use crate::storeys_exact::{DAMPING, EXACT, distance, exact, facing, histories, same};
use crate::towers::{Tower, row};
use crate::watch::Watch;

const KNEES: [Smoothness; 5] = [knee(1, 0.5), knee(2, 0.5), knee(3, 0.8), knee(5, 0.2), knee(20, 0.6)];

const fn knee(exponent: u32, unloading: f64) -> Smoothness {
    Smoothness { exponent, unloading }
}

fn bending(smoothness: Smoothness) -> impl Fn(f64, f64) -> BoucWen {
    move |stiffness, yield_force| BoucWen {
        stiffness,
        yield_force,
        hardening: 0.05,
        smoothness,
    }
}

fn hardening(part: f64) -> impl Fn(f64, f64) -> Bilinear {
    move |stiffness, yield_force| Bilinear {
        stiffness,
        yield_force,
        hardening: part,
    }
}

fn plastic(stiffness: f64, yield_force: f64) -> Bilinear {
    Bilinear {
        stiffness,
        yield_force,
        hardening: 0.0,
    }
}

/// Two towers in which every storey yields, with columns made from stiffness and yield force.
fn towers<Column>(column: impl Fn(f64, f64) -> Column) -> [Tower<Column>; 2] {
    [
        vec![(9e4, column(4e7, 2.5e5)), (8e4, column(3e7, 2e5)), (7e4, column(2.5e7, 1.2e5))],
        vec![(2e5, column(3e8, 5e5)), (2e5, column(2e8, 3e5))],
    ]
}

/// Largest distance of the Runge-Kutta method at this step from the exact run of a row.
fn stepped<Column: Hysteretic>(row: &Row<Column>, (step, duration): (f64, f64)) -> f64 {
    let samples = ground();
    let (best, _) = histories(row, EXACT, (clock(0.01, duration), &samples));
    let method = Integrator::Rk4(Rk4);
    let (found, _) = histories(row, method, (clock(step, duration), &samples));
    distance(&best, &found, same(row.nodes().len()))
}

#[test]
fn order_stepping_tends_to_exact_yielding() {
    fn check<Column: Hysteretic>(name: &str, column: impl Fn(f64, f64) -> Column) {
        let (row, _) = row(&towers(column), DAMPING, |_, _, _| None);
        let errors = [5e-4, 5e-5].map(|step| stepped(&row, (step, 3.0)));
        assert!(errors[1] < 1e-6 && errors[1] < 0.1 * errors[0], "{name}: {errors:?}");
    }
    check("plastic", plastic);
    check("bilinear", hardening(0.1));
    for smoothness in KNEES {
        check(&format!("{smoothness:?}"), bending(smoothness));
    }
}

#[test]
fn order_stepping_tends_to_exact_pounding_of_yielding_towers() {
    fn check<Column: Hysteretic>(name: &str, column: impl Fn(f64, f64) -> Column) {
        let towers = towers(column);
        // Every hit multiplies the uncertainty of its instant in a step: after two seconds little is left to compare.
        for (law, finest, duration) in [(VISCOELASTIC, 1e-5, 3.0), (STEREOMECHANICAL, 1e-4, 1.25)] {
            let (row, _) = row(&towers, DAMPING, facing(0.01, law));
            let errors = [2e-4, 2e-5].map(|step| stepped(&row, (step, duration)));
            assert!(errors[1] < finest && errors[1] < 0.3 * errors[0], "{name}, {law:?}: {errors:?}");
        }
    }
    check("plastic", plastic);
    check("bilinear", hardening(0.1));
    check("smooth", bending(KNEES[1]));
}

#[test]
fn limit_half_the_tolerance_changes_nothing_that_counts() {
    fn check<Column: Hysteretic>(name: &str, column: impl Fn(f64, f64) -> Column) {
        let samples = ground();
        let towers = towers(column);
        for law in [STEREOMECHANICAL, VISCOELASTIC] {
            let (row, _) = row(&towers, DAMPING, facing(0.01, law));
            let run = |tolerance| histories(&row, exact(tolerance), (clock(0.01, 10.0), &samples)).0;
            let (whole, half) = (run(1e-12), run(5e-13));
            let off = distance(&whole, &half, same(row.nodes().len()));
            assert!(off < 1e-7, "{name}, {law:?}: {off:e}");
        }
    }
    check("plastic", plastic);
    check("bilinear", hardening(0.1));
    for smoothness in KNEES {
        check(&format!("{smoothness:?}"), bending(smoothness));
    }
}

#[test]
fn limit_lean_columns_have_the_bits_of_rich_ones() {
    fn states<Column: Hysteretic>(column: impl Fn(f64, f64) -> Column) -> Vec<Vec<pounding_solver::State>> {
        let samples = ground();
        let (row, _) = row(&towers(column), DAMPING, facing(0.01, VISCOELASTIC));
        let (found, _) = histories(&row, EXACT, (clock(0.01, 5.0), &samples));
        let nodes = 0..row.nodes().len();
        nodes.map(|node| found.of(node).states.clone()).collect()
    }
    let never = f64::INFINITY;
    let elastic = states(|stiffness, _| Elastic { stiffness });
    assert_eq!(elastic, states(|stiffness, _| plastic(stiffness, never)));
    assert_eq!(elastic, states(|stiffness, _| plastic(stiffness, 1e12)));
    assert_eq!(elastic, states(|stiffness, _| hardening(0.1)(stiffness, never)));
    assert_eq!(elastic, states(|stiffness, _| bending(KNEES[1])(stiffness, never)));
    assert_eq!(states(plastic), states(hardening(0.0)));
    assert_ne!(elastic, states(plastic), "the towers must yield");
}

/// Follows the loops of columns from end to end of the spans, in which drifts are monotone.
struct Loops<'a, Column: RestoringForce> {
    row: &'a Row<Column>,
    memories: Vec<Column::Memory>,
    /// Largest distance of a force from the loop, and the largest force.
    off: f64,
    most: f64,
}

impl<Column: RestoringForce> Recorder for Loops<'_, Column> {
    fn span(&mut self, span: &Span<'_>) {
        let node = span.structure;
        let [_, end] = span.drifts();
        let column = self.row.nodes()[node].column;
        let Response { force, memory, .. } = column.respond(end.displacement, self.memories[node]);
        self.memories[node] = memory;
        self.off = self.off.max((span.end.restoring_force - force).abs());
        self.most = self.most.max(force.abs());
        let inside = span.at(0.5 * (span.start_time + span.end_time));
        assert!(inside.restoring_force.is_finite(), "{inside:?}");
    }

    fn impact(&mut self, _: &Impact) {}
}

#[test]
fn reference_forces_follow_the_loop() {
    fn off<Column: Hysteretic>(column: impl Fn(f64, f64) -> Column) -> f64 {
        let samples = ground();
        let (row, _) = row(&towers(column), DAMPING, facing(0.01, STEREOMECHANICAL));
        let mut loops = Loops {
            row: &row,
            memories: row.nodes().iter().map(|node| node.column.untouched()).collect(),
            off: 0.0,
            most: 0.0,
        };
        let excitation = Excitation::new(0.01, &samples).expect("the ground motion is finite");
        EXACT.watch(&row, excitation, clock(0.01, 10.0), &mut loops).expect("the run ends");
        loops.off / loops.most
    }
    assert!(off(plastic) < 1e-12, "{:e}", off(plastic));
    assert!(off(hardening(0.1)) < 1e-12, "{:e}", off(hardening(0.1)));
    // The column integrates its loop to 1e-8.
    for smoothness in KNEES {
        let off = off(bending(smoothness));
        assert!(off < 1e-7, "{smoothness:?}: {off:e}");
    }
}
