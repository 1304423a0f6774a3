//! Ground motions that arrive at one structure after the other, against the exact method.

use pounding_contact::ContactLaw;
use pounding_solver::{
    Clock, Collisions, Elastic, ElastoPlastic, Exact, Excitation, Hysteretic, Integrator, Node,
    Peaks, Row, TransferredMomentum,
};

use super::storeys::{ALPHA, BETA, TOWERS, buildings, elastic, ground, spring};
use super::{close, pairs, run, stereomechanical, viscoelastic};

/// Digits on which both routes agree.
const TOLERANCE: f64 = 1e-9;

/// Both routes on one row; how many collisions there are.
fn agree<Column: Hysteretic>(row: &Row<Column>, duration: f64, what: &str) -> usize {
    let tolerance = TOLERANCE;
    let samples = ground();
    let excitation = Excitation::new(0.1, &samples).expect("finite samples");
    let n = row.nodes().len();
    let mut recorders = (
        Peaks::new(n),
        TransferredMomentum::new(n),
        Collisions::new(n, row.pairs()).travelled(row.travel(excitation)),
    );
    let clock = Clock {
        time_step: duration,
        n_steps: 1,
    };
    Integrator::Exact(Exact::default())
        .run(row, excitation, clock, &mut recorders)
        .expect("the run ends");
    let (peaks, momentum, collisions) = recorders;
    let other = run(row, &samples, duration);
    let walls = row.nodes().iter().map(Node::is_wall);
    for (index, wall) in walls.enumerate() {
        let response = &other.structures[index];
        let what = format!("{what}, node {index}");
        let (one, other) = (peaks.of(index), response);
        if !wall {
            let found = one.displacement.value;
            close(found, other.displacement.value, tolerance, &what);
        }
        let found = momentum.of(index);
        close(found, other.transferred_momentum, tolerance, &what);
    }
    for (pair, wanted) in other.collisions.iter().enumerate() {
        let found: Vec<_> = collisions
            .all()
            .iter()
            .filter(|one| one.pair == pair)
            .collect();
        assert_eq!(found.len(), wanted.len(), "{what}, pair {pair}");
        for (one, other) in found.iter().zip(wanted) {
            let apart = (one.start - other.start).abs();
            assert!(apart < 10.0 * tolerance, "{what}, pair {pair}: {apart:e}");
        }
    }
    collisions.all().len()
}

/// Laws, each with the duration of its run.
///
/// Impulsive neighbours soon come to rest against each other, which this route does not follow.
fn laws(impulsive: f64) -> [(ContactLaw, f64); 3] {
    [
        (stereomechanical(0.9), impulsive),
        (spring(5e8), 4.0),
        (viscoelastic(0.35), 4.0),
    ]
}

#[test]
fn reference_structures_shaken_in_turn() {
    let structure = |mass: f64, period: f64, yields: f64| {
        let omega = 2.0 * std::f64::consts::PI / period;
        let stiffness = mass * omega * omega;
        let column = ElastoPlastic {
            stiffness,
            yield_force: yields * stiffness,
        };
        Node::structure(mass, 0.1 * omega * mass, column)
    };
    for (law, duration) in laws(0.7) {
        let nodes = vec![
            structure(1e5, 0.8, 0.05),
            structure(3e5, 0.3, 0.02),
            structure(2e5, 0.5, f64::INFINITY),
            Node::wall(ElastoPlastic {
                stiffness: 1.0,
                yield_force: 1.0,
            }),
        ];
        let row = Row::new(nodes, pairs(4, 0.02, law)).expect("a valid row");
        // Neither order, nor whole parts of the 0.1 s between samples.
        for arrivals in [[0.0, 0.07, 0.15, 0.222], [0.13, 0.13, 0.0, 0.05]] {
            let what = format!("{law:?}, {arrivals:?}");
            let row = row
                .clone()
                .delayed(arrivals.to_vec())
                .expect("valid arrivals");
            let n = agree(&row, duration, &what);
            assert!(n > 1, "{what}: {n}");
        }
    }
}

#[test]
fn reference_towers_shaken_in_turn() {
    for (law, duration) in laws(0.34) {
        let of: Vec<_> = TOWERS.iter().map(|tower| elastic(tower)).collect();
        let row: Row<Elastic> = buildings(&of, (ALPHA, BETA), (0.01, law));
        let levels = pounding_solver::Levels::new(&TOWERS.map(<[_]>::len));
        let arrival = |node: usize| [0.0, 0.06, 0.21][levels.place(node).0];
        let arrivals = (0..levels.n_nodes()).map(arrival).collect();
        let row = row.delayed(arrivals).expect("valid arrivals");
        let what = format!("{law:?}");
        let n = agree(&row, duration, &what);
        assert!(n > 1, "{what}: {n}");
    }
}
