//! Ground motions that arrive at structures one after the other, compared with the exact method.

use pounding_contact::ContactLaw;
use pounding_solver::{Bilinear, Elastic, Node, Row};

use super::exact::agree;
use super::storeys::{ALPHA, BETA, TOWERS, buildings, elastic, spring};
use super::{pairs, stereomechanical, viscoelastic};

/// Laws, each with the duration of its run.
fn laws(impulsive: f64) -> [(ContactLaw, f64); 3] {
    [(stereomechanical(0.9), impulsive), (spring(5e8), 4.0), (viscoelastic(0.35), 4.0)]
}

#[test]
fn reference_structures_shaken_in_turn() {
    let structure = |mass: f64, period: f64, yields: f64| {
        let omega = 2.0 * std::f64::consts::PI / period;
        let stiffness = mass * omega * omega;
        let column = Bilinear {
            stiffness,
            yield_force: yields * stiffness,
            hardening: 0.0,
        };
        Node::structure(mass, 0.1 * omega * mass, column)
    };
    for (law, duration) in laws(4.0) {
        let nodes = vec![
            structure(1e5, 0.8, 0.05),
            structure(3e5, 0.3, 0.02),
            structure(2e5, 0.5, f64::INFINITY),
            Node::wall(Bilinear {
                stiffness: 1.0,
                yield_force: 1.0,
                hardening: 0.0,
            }),
        ];
        let row = Row::new(nodes, pairs(4, 0.02, law)).expect("a valid row");
        // Neither ordered, nor whole parts of the 0.1 s between samples.
        for arrivals in [[0.0, 0.07, 0.15, 0.222], [0.13, 0.13, 0.0, 0.05]] {
            let what = format!("{law:?}, {arrivals:?}");
            let row = row.clone().delayed(arrivals.to_vec()).expect("valid arrivals");
            let met = agree(&row, duration, &what);
            assert!(met.iter().any(|pair| pair.n > 1), "{what}: {met:?}");
        }
    }
}

#[test]
fn reference_towers_shaken_in_turn() {
    // Hits with e = 0.9 between three towers multiply rounding: after 1 s two tolerances differ by 2e-8.
    for (law, duration) in laws(0.34) {
        let of: Vec<_> = TOWERS.iter().map(|tower| elastic(tower)).collect();
        let row: Row<Elastic> = buildings(&of, (ALPHA, BETA), (0.01, law));
        let levels = pounding_solver::Levels::new(&TOWERS.map(<[_]>::len));
        let arrival = |node: usize| [0.0, 0.06, 0.21][levels.place(node).0];
        let arrivals = (0..levels.n_nodes()).map(arrival).collect();
        let row = row.delayed(arrivals).expect("valid arrivals");
        let what = format!("{law:?}");
        let met = agree(&row, duration, &what);
        assert!(met.iter().any(|pair| pair.n > 1), "{what}: {met:?}");
    }
}
