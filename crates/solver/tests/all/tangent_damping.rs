//! Damping on the tangent stiffness: columns that yield lose β (k − `k_t`) of it.

use pounding_solver::{
    Bilinear, Exact, Excitation, Floor, Impact, Integrator, Ledger, Node, Recorder, Row, RunError, SimultaneousImpacts, Span,
};

use crate::common::{
    AVERAGE, CENTRAL, HHT, LINEAR, LOCATED, MOREAU_JEAN, RK4, VERLET, VISCOELASTIC, book, clock, ground, histories, pairs, slope,
};
use crate::watch::Watch;

const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: SimultaneousImpacts::Together,
});
/// α \[1/s\] and β \[s\].
const RAYLEIGH: (f64, f64) = (0.3, 4e-3);

/// A storey with Rayleigh damping on the tangent stiffness.
fn storey(mass: f64, stiffness: f64, yield_displacement: f64, hardening: f64) -> Node<Bilinear> {
    let column = Bilinear {
        stiffness,
        yield_force: stiffness * yield_displacement,
        hardening,
    };
    let (alpha, beta) = RAYLEIGH;
    Node {
        elastic_damping: beta * (1.0 - hardening) * stiffness,
        ..Node::structure(mass, alpha * mass + beta * stiffness, column)
    }
}

/// Two structures and a building of two storeys, which all yield and touch.
fn row() -> Row<Bilinear> {
    let mut nodes = vec![
        storey(75e3, 2.056e6, 0.02, 0.0),
        storey(2e5, 4e7, 0.006, 0.05),
        storey(3e5, 5e7, 0.005, 0.1),
        storey(1.5e5, 3e7, 0.006, 0.1),
    ];
    let (alpha, beta) = RAYLEIGH;
    let upper = nodes[3];
    nodes[3] = Node {
        damping: beta * upper.column.stiffness,
        ..upper
    }
    .on_floor(Floor {
        below: 2,
        ground_damping: alpha * 1.5e5,
    });
    Row::new(nodes, pairs(3, 0.01, VISCOELASTIC)).expect("a valid row")
}

/// Counts the changes of branch at which damping jumps.
#[derive(Default)]
struct Yields(usize);

impl Recorder for Yields {
    fn span(&mut self, span: &Span<'_>) {
        let [start, end] = span.drifts().map(|drift| drift.displacement);
        let gained = (span.end.restoring_force - span.start.restoring_force).abs();
        self.0 += usize::from(span.structure == 3 && gained < 0.5 * 3e7 * (end - start).abs());
    }

    fn impact(&mut self, _: &Impact) {}
}

/// Thrown from rest, a structure swings with damping to its yield point, and from there flies against the yield force alone.
#[test]
fn reference_damping_ends_where_perfectly_plastic_columns_yield() {
    let (mass, stiffness, yields, speed, beta) = (1e5, 4e6, 0.01, 0.5, 0.01);
    let column = Bilinear {
        stiffness,
        yield_force: stiffness * yields,
        hardening: 0.0,
    };
    let node = Node {
        initial_velocity: speed,
        elastic_damping: beta * stiffness,
        ..Node::structure(mass, beta * stiffness, column)
    };
    let row = Row::new(vec![node], vec![]).expect("a valid row");
    // u = v₀ e^(−ζωt) sin(ω_d t)/ω_d up to u_y.
    let omega = (stiffness / mass).sqrt();
    let decay = 0.5 * beta * omega * omega;
    let swing = (omega * omega - decay * decay).sqrt();
    let at = |t: f64| speed * libm::exp(-decay * t) * libm::sin(swing * t) / swing;
    let (mut early, mut late) = (0.0, 0.05);
    assert!(at(late) > yields, "the bracket");
    for _ in 0..100 {
        let middle = 0.5 * (early + late);
        if at(middle) < yields { early = middle } else { late = middle }
    }
    let rate = speed * libm::exp(-decay * early) * libm::cos(swing * early) - decay * yields;
    let wanted = yields + 0.5 * mass * rate * rate / (stiffness * yields);
    let stop = early + rate * mass / (stiffness * yields);
    let (found, _) = histories(&row, EXACT, &[0.0], clock(0.25 * stop, stop));
    let last = found.of(0).states.last().expect("states");
    assert!((last.displacement / wanted - 1.0).abs() < 1e-12, "{} {wanted}", last.displacement);
    assert!(last.velocity.abs() < 1e-12, "{}", last.velocity);
}

/// The ledger closes, and the damping takes less energy than damping on the initial stiffness does.
#[test]
fn reference_the_ledger_closes_over_jumps_of_damping() {
    let (samples, clock) = (ground(), clock(0.01, 8.0));
    let excitation = Excitation::new(0.01, &samples).expect("finite");
    let row = row();
    let mut recorders = (Ledger::new(&row, excitation), Yields::default());
    EXACT.watch(&row, excitation, clock, &mut recorders).expect("the run ends");
    let (ledger, yields) = recorders;
    assert!(yields.0 > 10, "{} spans of yielding", yields.0);
    ledger.verdict().expect("all laws hold");
    let residuals = [ledger.residual(), ledger.identity(), ledger.momentum()];
    assert!(residuals.iter().all(|residual| residual.abs() < 1e-11), "{residuals:?}");
    for method in [RK4, AVERAGE, LINEAR] {
        let ledger = book(&row, method, &samples, crate::common::clock(0.001, 8.0));
        ledger.verdict().unwrap_or_else(|error| panic!("{method:?}: {error}"));
        assert!(ledger.momentum().abs() < 1e-9, "{method:?}: {}", ledger.momentum());
    }
}

/// Stepping methods use the tangent at the end of the last step: Runge–Kutta comes down to order one. The error of order two of Newmark's
/// method is larger than that of the late tangent.
#[test]
fn order_the_tangent_of_the_last_step() {
    let samples = ground();
    let row = row();
    let (exact, _) = histories(&row, EXACT, &samples, clock(0.01, 2.0));
    let steps = [4e-4, 2e-4, 1e-4, 5e-5];
    for (method, orders) in [(RK4, 0.7..1.4), (AVERAGE, 1.5..2.1)] {
        let error = |step: f64| {
            let (found, _) = histories(&row, method, &samples, clock(step, 2.0));
            let last = |all: &pounding_solver::Histories, node: usize| all.of(node).states.last().expect("states").displacement;
            (0..4)
                .map(|node| (last(&found, node) - last(&exact, node)).abs())
                .fold(0.0, f64::max)
        };
        let errors = steps.map(error);
        let order = slope(&steps, &errors);
        assert!(orders.contains(&order), "{method:?}: {order} {errors:?}");
        assert!(errors[3] < 2e-4, "{method:?}: {errors:?}");
    }
}

/// Columns that never yield have the damping on the initial stiffness: the same bits, and in Newmark's method the same to rounding, because
/// it finds the acceleration at the start of each step anew.
#[test]
fn limit_without_yielding_nothing_changes() {
    let samples = ground();
    let of = |part: f64| {
        let mut node = storey(75e3, 2.056e6, 1e3, 0.1);
        node.elastic_damping *= part;
        Row::new(vec![node], vec![]).expect("a valid row")
    };
    for (method, within) in [(EXACT, 0.0), (RK4, 0.0), (AVERAGE, 1e-12)] {
        let [with, without] = [1.0, 0.0].map(|part| histories(&of(part), method, &samples, clock(0.001, 4.0)).0);
        let pairs = with.of(0).states.iter().zip(&without.of(0).states);
        let apart = pairs.map(|(one, other)| (one.displacement - other.displacement).abs());
        assert!(apart.fold(0.0, f64::max) <= within, "{method:?}");
    }
}

#[test]
fn extreme_methods_that_keep_their_damping_refuse() {
    let samples = ground();
    let row = row();
    let excitation = Excitation::new(0.01, &samples).expect("finite");
    for method in [CENTRAL, VERLET, LOCATED, HHT, MOREAU_JEAN] {
        let ended = method.watch(&row, excitation, clock(0.001, 0.1), &mut Yields::default());
        assert_eq!(ended.map(|_| ()), Err(RunError::TangentDamping { structure: 0 }), "{method:?}");
    }
    let more = Node {
        elastic_damping: 2.0,
        ..Node::structure(
            1.0,
            1.0,
            Bilinear {
                stiffness: 1.0,
                yield_force: 1.0,
                hardening: 0.0,
            },
        )
    };
    let refused = Row::new(vec![more], vec![]).expect_err("it would feed energy").to_string();
    assert_eq!(refused, "nodes[0].elastic_damping: found 2, allowed 0 to the damping of the storey");
}
