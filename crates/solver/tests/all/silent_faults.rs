//! Former silent errors and endless runs of the exact method.

use pounding_contact::{ContactLaw, ModifiedLinearViscoelastic, Stereomechanical};
use pounding_solver::{
    BoucWen, Clock, Collisions, Elastic, Exact, Excitation, Hysteretic, Impact, Integrator, Ledger, Node, Pair, Peaks, Recorder, Row,
    RunError, Smoothness, Span, TransferredMomentum,
};
use proptest::prelude::*;

use crate::common::{METHODS, clock, ground};
use crate::random_rows::{SI, any_law, cases, config};
use crate::watch::Watch;

const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: pounding_solver::SimultaneousImpacts::Together,
});

fn impulsive(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

/// Pairs of neighbours from the left, by gap and law.
fn pairs(contacts: &[(f64, ContactLaw)]) -> Vec<Pair> {
    let pair = |(left, &(gap, law)): (usize, &(f64, ContactLaw))| Pair::of_floors(left, left + 1, gap, law);
    contacts.iter().enumerate().map(pair).collect()
}

/// A structure by mass \[kg\], period \[s\] and damping ratio, with columns of its stiffness.
fn structure<Column>((mass, period, ratio): (f64, f64, f64), column: impl Fn(f64) -> Column) -> Node<Column> {
    let omega = 2.0 * std::f64::consts::PI / period;
    Node::structure(mass, 2.0 * ratio * omega * mass, column(mass * omega * omega))
}

fn elastic(values: (f64, f64, f64)) -> Node<Elastic> {
    structure(values, |stiffness| Elastic { stiffness })
}

/// The largest forces in all reports of a run: of every pair, and net on every node.
struct Shown {
    pairs: Vec<f64>,
    nodes: Vec<f64>,
}

/// Number of evaluations inside a span.
const LOOKS: u32 = 8;

impl Recorder for Shown {
    fn span(&mut self, span: &Span<'_>) {
        let inside = (1..LOOKS).map(|look| span.at(span.start_time + f64::from(look) / f64::from(LOOKS) * span.duration()));
        for state in inside.chain([span.start, span.end]) {
            let net = &mut self.nodes[span.structure];
            *net = net.max(state.pounding_force().abs());
            if let Some(largest) = self.pairs.get_mut(span.structure) {
                *largest = largest.max(-state.force_from_right);
            }
        }
    }

    fn impact(&mut self, _: &Impact) {}
}

/// Runs a row in which all neighbours are pairs, and compares the largest reported forces with the peaks.
fn peaks_are_the_largest<Column: Hysteretic>(
    (row, samples): (&Row<Column>, &[f64]),
    (method, clock): (Integrator, Clock),
) -> Result<Vec<f64>, String> {
    let n = row.nodes().len();
    let shown = Shown {
        pairs: vec![0.0; n - 1],
        nodes: vec![0.0; n],
    };
    let mut recorders = (shown, Collisions::new(n, row.pairs()), Peaks::new(n));
    let excitation = Excitation::new(0.01, samples).expect("the ground motion is finite");
    if method.watch(row, excitation, clock, &mut recorders).is_err() {
        // A run that fails reports nothing.
        return Ok(Vec::new());
    }
    let (shown, collisions, peaks) = recorders;
    let mut printed = vec![0.0_f64; n - 1];
    for one in collisions.all() {
        printed[one.pair] = printed[one.pair].max(one.peak_force.unwrap_or(0.0));
    }
    let hides = |(printed, shown): (f64, f64)| shown > printed * (1.0 + 1e-9);
    for (pair, values) in printed.iter().copied().zip(shown.pairs).enumerate() {
        // An impact with its rest has no printed force.
        if row.pairs()[pair].law.is_compliant() && hides(values) {
            return Err(format!("pair {pair}: printed and shown {values:?}"));
        }
    }
    for (node, shown) in shown.nodes.into_iter().enumerate() {
        let values = (peaks.of(node).pounding_force.value.abs(), shown);
        if hides(values) {
            return Err(format!("node {node}: printed and shown {values:?}"));
        }
    }
    Ok(printed)
}

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn limit_no_force_is_larger_than_the_printed_peak(case in cases(any_law)) {
        prop_assume!(case.structures.len() > 1);
        let row = case.row(SI);
        for (name, method) in METHODS.into_iter().chain([("exact", EXACT)]) {
            let run = (method, clock(2e-3, 0.4));
            let found = peaks_are_the_largest((&row, &case.ground), run);
            prop_assert!(found.is_ok(), "{name}: {}", found.unwrap_err());
        }
    }
}

#[test]
fn issue_a_force_that_jumps_at_an_impact_is_a_peak() {
    // A floor that presses a wall through a damped spring is hit from the other side: the force of the damper jumps. The peak was taken
    // only from the ends of spans, and was 22 % too low.
    let law = ContactLaw::ModifiedLinearViscoelastic(ModifiedLinearViscoelastic {
        impact_stiffness: 1e9,
        impact_damping_ratio: 0.8,
    });
    let nodes = vec![
        elastic((1e5, 0.9, 0.05)),
        elastic((3e5, 0.2, 0.05)),
        Node::wall(Elastic { stiffness: 1.0 }),
    ];
    let row = Row::new(nodes, pairs(&[(0.01, impulsive(0.4)), (0.005, law)])).expect("it is valid");
    let samples: Vec<_> = ground().iter().map(|sample| 2.0 * sample).collect();
    let largest = |method, time_step| {
        let run = (method, clock(time_step, 10.0));
        let printed = peaks_are_the_largest((&row, &samples), run);
        printed.expect("every shown force is printed")[1]
    };
    let exact = largest(EXACT, 0.01);
    for (name, method) in METHODS {
        if name.starts_with("central") {
            continue;
        }
        let found = largest(method, 1e-4);
        assert!((found / exact - 1.0).abs() < 0.02, "{name}: {found}, {exact}");
    }
}

fn bouc_wen(exponent: u32, unloading: f64) -> impl Fn(f64) -> BoucWen {
    move |stiffness| BoucWen {
        stiffness,
        hardening: 0.05,
        yield_force: 0.006 * stiffness,
        smoothness: Smoothness { exponent, unloading },
    }
}

#[test]
fn issue_columns_that_yield_smoothly_leave_a_standstill_the_way_they_go() {
    // After parting from a wall, the first coefficient of the rate of the drift is rounding. Its sign decided whether the column was loaded
    // or unloaded for a whole piece: impulses had errors of 1e-4, and the energy residual was 4e-5.
    let samples = ground();
    for (exponent, unloading) in [(1, 0.5), (2, 0.3), (3, 1.0)] {
        for restitution in [0.0, 0.3, 0.5] {
            let column = bouc_wen(exponent, unloading);
            let wall = || Node::wall(column(1.0));
            let between = vec![wall(), structure((2e5, 0.4, 0.05), &column), wall()];
            let law = impulsive(restitution);
            let between = Row::new(between, pairs(&[(0.002, law); 2])).expect("it is valid");
            let row = vec![structure((2e5, 0.4, 0.05), &column), structure((1e5, 0.7, 0.02), &column), wall()];
            let row = Row::new(row, pairs(&[(0.004, law), (0.0, law)])).expect("it is valid");
            for row in [between, row] {
                let ledger = crate::common::book(&row, EXACT, &samples, clock(0.01, 10.0));
                let residual = ledger.residual();
                assert!(residual < 1e-12, "n {exponent}, e {restitution}: {residual:e}");
            }
        }
    }
}

#[test]
fn issue_a_resting_floor_keeps_a_velocity_that_passes_zero() {
    // Neighbours rest against each other over different grounds. Where one velocity passed zero, it was recomputed from the other, missed
    // zero by a rounding, and passed it again, without end.
    let samples = ground();
    for restitution in [0.0, 0.3, 0.65] {
        for arrival in [0.02, 0.05, 0.09] {
            let nodes = vec![elastic((3e5, 0.3, 0.05)), elastic((3e5, 0.5, 0.05)), elastic((1e5, 0.2, 0.02))];
            let row = Row::new(nodes, pairs(&[(0.01, impulsive(restitution)), (0.005, impulsive(0.0))]))
                .and_then(|row| row.delayed(vec![0.0, arrival, 0.0]))
                .expect("it is valid");
            let excitation = Excitation::new(0.01, &samples).expect("the ground motion is finite");
            let mut ledger = Ledger::new(&row, excitation);
            let ended = EXACT.watch(&row, excitation, clock(0.01, 10.0), &mut ledger);
            assert!(ended.is_ok(), "e {restitution}, {arrival} s: {}", ended.unwrap_err());
            let residual = ledger.residual();
            assert!(residual < 1e-12, "e {restitution}, {arrival} s: {residual:e}");
        }
    }
}

#[test]
fn issue_what_walls_enclose_without_a_gap_rests() {
    // If walls hold a row on both sides, one of its forces is zero. All pairs were assumed to press, which left the forces without a
    // solution, and a search for their zeros without end.
    let samples = ground();
    for restitution in [0.0, 0.65, 1.0] {
        let law = impulsive(restitution);
        for n in 1..=3_u32 {
            let wall = || Node::wall(Elastic { stiffness: 1.0 });
            let inside = (0..n).map(|index| elastic((f64::from(index + 1) * 1e5, 0.8, 0.02)));
            let nodes: Vec<_> = [wall()].into_iter().chain(inside).chain([wall()]).collect();
            let contacts = vec![(0.0, law); nodes.len() - 1];
            let row = Row::new(nodes, pairs(&contacts)).expect("it is valid");
            let excitation = Excitation::new(0.01, &samples).expect("the ground motion is finite");
            let n_nodes = row.nodes().len();
            let mut recorders = (TransferredMomentum::new(n_nodes), Peaks::new(n_nodes));
            EXACT
                .watch(&row, excitation, clock(0.01, 2.0), &mut recorders)
                .expect("nothing moves");
            let (momentum, peaks) = recorders;
            // The walls push and pull with the force that the ground's acceleration demands: ∫ |m·a_g| dt, summed over each sign.
            let push: f64 = row.nodes()[1..n_nodes - 1].iter().map(|node| 1.0 / node.inverse_mass).sum();
            let wanted = push * integral_of_magnitude(&samples[..=200]);
            let found = momentum.of(0) + momentum.of(n_nodes - 1);
            assert!((found / wanted - 1.0).abs() < 1e-12, "{n}, e {restitution}: {found}, {wanted}");
            for node in 0..n_nodes {
                let moved = peaks.of(node).displacement.value.abs() > 0.0;
                assert!(!moved, "{n}, e {restitution}");
            }
        }
    }
}

/// ∫ |a| dt of samples every 0.01 s, linear in between.
fn integral_of_magnitude(samples: &[f64]) -> f64 {
    let piece = |ends: &[f64]| {
        let (a, b) = (ends[0], ends[1]);
        if a * b >= 0.0 {
            0.5 * (a + b).abs()
        } else {
            0.5 * (a * a + b * b) / (a - b).abs()
        }
    };
    0.01 * samples.windows(2).map(piece).sum::<f64>()
}

#[test]
fn extreme_walls_that_close_in_are_named() {
    // Walls on separate grounds leave the structures between them no room: no such motion exists.
    let samples = ground();
    for gap in [0.0, 0.002] {
        let wall = || Node::wall(Elastic { stiffness: 1.0 });
        let nodes = vec![wall(), elastic((2e5, 0.8, 0.02)), wall()];
        let row = Row::new(nodes, pairs(&[(0.0, impulsive(0.5)), (gap, impulsive(0.0))]))
            .and_then(|row| row.delayed(vec![0.0, 0.05, 0.1]))
            .expect("it is valid");
        let excitation = Excitation::new(0.01, &samples).expect("the ground motion is finite");
        let ended = EXACT.watch(&row, excitation, clock(0.01, 10.0), &mut ());
        assert!(matches!(ended, Err(RunError::ClosedIn { .. })), "{gap}: {ended:?}");
    }
}
