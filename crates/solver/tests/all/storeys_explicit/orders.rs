//! Orders of convergence towards the Runge–Kutta method at a far smaller step.

use pounding_contact::{ContactLaw, LinearSpring, Stereomechanical};
use pounding_solver::{Bilinear, BoucWen, Clock, Excitation, Histories, Hysteretic, Integrator, Row, Smoothness};

use super::{EXPLICIT, elastic, plastic, side_by_side, soft, started, stiff};
use crate::common::{CENTRAL, LOCATED, RK4, STEREOMECHANICAL, VERLET, VISCOELASTIC, clock, ground, slope};
use crate::watch::Watch;

/// Instants at which displacements are compared \[s\].
const INTERVAL: f64 = 0.02;

fn follow<Column: Hysteretic>(row: &Row<Column>, method: Integrator, samples: &[f64], clock: Clock) -> Histories {
    let duration = clock.time_step * clock.n_steps as f64;
    let mut histories = Histories::new(row.nodes().len(), INTERVAL, duration);
    let excitation = Excitation::new(0.01, samples).expect("the ground motion is finite");
    method.watch(row, excitation, clock, &mut histories).expect("the run ends");
    histories
}

/// Largest difference of displacements, over all floors \[m\].
fn apart(left: &Histories, right: &Histories, n: usize) -> f64 {
    let differences = (0..n).flat_map(|node| {
        let states = left.of(node).states.iter().zip(&right.of(node).states);
        states.map(|(left, right)| (left.displacement - right.displacement).abs())
    });
    differences.fold(0.0, f64::max)
}

/// Slope and errors of a method over these steps, against the Runge–Kutta method at 1/32 of the last step.
fn measured<Column: Hysteretic, const N: usize>(
    row: &Row<Column>,
    methods: &[(&'static str, Integrator)],
    (samples, duration): (&[f64], f64),
    steps: [f64; N],
) -> Vec<(&'static str, f64, [f64; N])> {
    let n = row.nodes().len();
    let truth = follow(row, RK4, samples, clock(steps[N - 1] / 32.0, duration));
    let measure = |&(name, method): &(&'static str, Integrator)| {
        let error = |dt| apart(&follow(row, method, samples, clock(dt, duration)), &truth, n);
        let errors = steps.map(error);
        (name, slope(&steps, &errors), errors)
    };
    methods.iter().map(measure).collect()
}

const STEPS: [f64; 4] = [0.005, 0.0025, 0.00125, 0.000_625];

#[test]
fn order_two_without_contact() {
    let (row, _) = side_by_side(&[soft(elastic)], &[], STEREOMECHANICAL);
    let free = started(&row, |node| (0.01 + 0.004 * node as f64, -0.2));
    let shaking = ground();
    for (row, samples) in [(&free, &[0.0; 2][..]), (&row, &shaking)] {
        for (name, order, errors) in measured(row, &EXPLICIT, (samples, 4.0), STEPS) {
            assert!((order - 2.0).abs() < 0.1, "{name}: {order} {errors:?}");
        }
    }
}

#[test]
fn order_of_yielding_storeys() {
    fn check<Column: Hysteretic>(what: &str, column: impl Fn(f64) -> Column) {
        let (row, _) = side_by_side(&[soft(&column)], &[], STEREOMECHANICAL);
        let methods = [("CD", CENTRAL), ("Verlet", VERLET)];
        let shaking = ground();
        for (name, order, errors) in measured(&row, &methods, (&shaking, 4.0), STEPS) {
            assert!(order > 1.6, "{what}, {name}: {order} {errors:?}");
            assert!(errors[3] < 1e-4, "{what}, {name}: {errors:?}");
        }
    }
    check("perfectly plastic", plastic);
    check("bilinear", |stiffness| Bilinear {
        stiffness,
        yield_force: 0.008 * stiffness,
        hardening: 0.1,
    });
    check("Bouc–Wen", |stiffness| BoucWen {
        stiffness,
        yield_force: 0.008 * stiffness,
        hardening: 0.05,
        smoothness: Smoothness {
            exponent: 2,
            unloading: 0.5,
        },
    });
}

#[test]
fn order_of_pounding_towers() {
    let spring = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 1e8 });
    let steps = [0.001, 0.0005, 0.000_25, 0.000_125];
    let shaking = ground();
    for (what, law, order) in [
        ("spring", spring, 1.5),
        ("viscoelastic", VISCOELASTIC, 0.8),
        ("jumps", STEREOMECHANICAL, 0.8),
    ] {
        let towers = [soft(elastic), stiff(2, elastic)];
        let (row, _) = side_by_side(&towers, &[0.01], law);
        for (name, found, errors) in measured(&row, &EXPLICIT, (&shaking, 2.0), steps) {
            assert!(found > order, "{what}, {name}: {found} {errors:?}");
            assert!(errors[3] < 1e-4, "{what}, {name}: {errors:?}");
        }
    }
}

#[test]
fn order_two_with_located_impacts() {
    // A moving tower hits a tower at rest, and is hit again: floor by floor, at different instants. The reference locates impacts, too, at
    // a far smaller step. While floors rest against each other the order is one.
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.9 });
    let towers = [soft(elastic), stiff(2, elastic)];
    let (row, levels) = side_by_side(&towers, &[0.01], law);
    let row = started(&row, |node| match levels.place(node) {
        (0, _) => (0.0, 0.4),
        _ => (0.0, 0.0),
    });
    let truth = follow(&row, LOCATED, &[0.0], clock(2e-5, 0.5));
    let errors = [LOCATED, VERLET].map(|method| STEPS.map(|dt| apart(&follow(&row, method, &[0.0], clock(dt, 0.5)), &truth, 5)));
    let orders = errors.map(|errors| slope(&STEPS, &errors));
    assert!(orders[0] > 1.8, "{orders:?} {errors:?}");
    assert!(orders[1] < 1.5, "no impact: {orders:?} {errors:?}");
}
