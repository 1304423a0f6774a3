//! Orders of convergence: two where theory predicts two; measured and printed where contact or yielding lowers it.

use insta::assert_snapshot;
use pounding_contact::ContactLaw;
use pounding_solver::{Bilinear, Elastic, Exact, Excitation, Hysteretic, Integrator, Node, Recorder, Row, TransferredMomentum};

use crate::common::{
    FIRST_ORDER, METHODS, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, elastic, ground, histories, pairs, slope, yielding,
};
use crate::watch::Watch;

/// Displacement of a damped structure released at u₀ under a load that rises linearly: closed form.
fn ramp(node: &Node<Elastic>, initial: f64, rate: f64, time: f64) -> f64 {
    let (omega2, c) = (node.column.stiffness * node.inverse_mass, node.damping * node.inverse_mass);
    let decay = 0.5 * c;
    let frequency = (omega2 - decay * decay).sqrt();
    // u = p t + q + e^(−dt) (a cos ωt + b sin ωt) solves ü + c u̇ + ω² u = −rate·t.
    let p = -rate / omega2;
    let q = -c * p / omega2;
    let a = initial - q;
    let b = (decay * a - p) / frequency;
    p * time + q + libm::exp(-decay * time) * (a * libm::cos(frequency * time) + b * libm::sin(frequency * time))
}

/// The theoretical order of free elastic motion.
fn promised(method: Integrator) -> f64 {
    match method {
        Integrator::Rk4(_) => 4.0,
        Integrator::MoreauJean(settings) if settings.theta > 0.5 => 1.0,
        Integrator::CentralDifference(_)
        | Integrator::Newmark(_)
        | Integrator::Hht(_)
        | Integrator::Verlet(_)
        | Integrator::MoreauJean(_) => 2.0,
        Integrator::Exact(_) => f64::INFINITY,
    }
}

#[test]
fn order_without_contact_is_the_promised_one() {
    let node = Node {
        initial_displacement: 0.01,
        ..elastic(WEAK)
    };
    let samples: Vec<f64> = (0..=400).map(|i| 0.01 * f64::from(i)).collect();
    for (name, method) in METHODS.into_iter().chain(FIRST_ORDER) {
        let row = Row::new(vec![node], vec![]).unwrap();
        let steps = [0.01, 0.005, 0.0025, 0.00125];
        let errors = steps.map(|dt| {
            let (histories, _) = histories(&row, method, &samples, clock(dt, 4.0));
            let errors = histories
                .of(0)
                .states
                .iter()
                .enumerate()
                .map(|(i, state)| (state.displacement - ramp(&node, 0.01, 1.0, i as f64 * dt)).abs());
            errors.fold(0.0, f64::max)
        });
        let order = slope(&steps, &errors);
        assert!((order - promised(method)).abs() < 0.2, "{name}: order {order}, errors {errors:?}");
    }
}

/// A quantity of a run at a time step.
fn measure<Column: Hysteretic>(row: &Row<Column>, method: Integrator, time_step: f64, recorder: &mut impl Recorder) {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    // Only up to the end of the first collisions: later ones would multiply the errors of the first.
    method
        .watch(row, excitation, clock(time_step, 3.0), recorder)
        .expect("the run ends");
}

/// The transferred momentum, or the last displacement if nothing touches.
fn quantity(row: &Row<impl Hysteretic>, method: Integrator, time_step: f64) -> f64 {
    let mut recorder = (
        TransferredMomentum::new(row.nodes().len()),
        pounding_solver::Histories::new(row.nodes().len(), 0.01, 3.0),
    );
    measure(row, method, time_step, &mut recorder);
    if row.pairs().is_empty() {
        recorder.1.of(0).states.last().expect("states were recorded").displacement
    } else {
        recorder.0.of(0)
    }
}

/// Order of the quantity, and its errors against a reference.
fn observed(row: &Row<impl Hysteretic>, method: Integrator, reference: f64) -> (f64, Vec<f64>) {
    let steps: Vec<f64> = (0..8).map(|halvings| 0.002 / f64::from(1 << halvings)).collect();
    let errors: Vec<f64> = steps
        .iter()
        .map(|dt| (quantity(row, method, *dt) / reference - 1.0).abs())
        .collect();
    (slope(&steps, &errors), errors)
}

/// Names and rows of the measurement: yielding without contact, then each contact law without and with yielding.
fn elastic_rows() -> Vec<(String, Row<Elastic>)> {
    let row = |law| {
        let nodes = vec![elastic(WEAK), elastic(STIFF)];
        Row::new(nodes, pairs(2, 0.02, law)).expect("the row is valid")
    };
    LAWS.map(|(name, law)| (format!("{name} elastic"), row(law))).to_vec()
}

fn yielding_rows() -> Vec<(String, Row<Bilinear>)> {
    let row = |law| {
        let nodes = vec![yielding(WEAK), yielding(STIFF)];
        Row::new(nodes, pairs(2, 0.02, law)).expect("the row is valid")
    };
    let alone = Row::new(vec![yielding(WEAK)], vec![]).expect("the row is valid");
    let touching = LAWS.map(|(name, law)| (format!("{name} nonlinear"), row(law)));
    std::iter::once(("yielding".to_string(), alone)).chain(touching).collect()
}

const LAWS: [(&str, ContactLaw); 2] = [("stereomechanical", STEREOMECHANICAL), ("viscoelastic", VISCOELASTIC)];

/// A line of the printed table.
fn line(what: &str, name: &str, (order, errors): &(f64, Vec<f64>)) -> String {
    let errors: Vec<_> = errors.iter().map(|error| format!("{error:.0e}")).collect();
    format!("{what:<28} {name:<18} order {order:>4.1}   errors {}\n", errors.join(" "))
}

#[test]
fn order_with_yielding_and_contact_is_measured() {
    // Each method against itself at a far smaller step.
    fn own(row: &Row<impl Hysteretic>, method: Integrator) -> (f64, Vec<f64>) {
        observed(row, method, quantity(row, method, 0.002 / 4096.0))
    }
    let mut table = String::new();
    let (elastic, nonlinear) = (elastic_rows(), yielding_rows());
    for (name, method) in &METHODS[..3] {
        let mut add = |what: &str, found| table += &line(what, name, &found);
        add(&nonlinear[0].0, own(&nonlinear[0].1, *method));
        for law in 0..LAWS.len() {
            add(&elastic[law].0, own(&elastic[law].1, *method));
            add(&nonlinear[law + 1].0, own(&nonlinear[law + 1].1, *method));
        }
    }
    assert_snapshot!(table);
}

#[test]
fn order_of_all_methods_against_one_limit_is_measured() {
    // A common limit for all methods: the result of the exact method.
    fn measure_all(what: &str, row: &Row<impl Hysteretic>, table: &mut String) {
        let limit = quantity(row, Integrator::Exact(Exact::default()), 0.01);
        for (name, method) in METHODS.into_iter().chain(FIRST_ORDER) {
            let (order, errors) = observed(row, method, limit);
            *table += &line(what, name, &(order, errors.clone()));
            let finest = errors.last().expect("errors of every step");
            assert!(*finest < 3e-3, "{what}, {name}: no convergence: {errors:?}");
        }
    }
    let mut table = String::new();
    for (what, row) in elastic_rows() {
        measure_all(&what, &row, &mut table);
    }
    for (what, row) in yielding_rows() {
        measure_all(&what, &row, &mut table);
    }
    assert_snapshot!(table);
}
