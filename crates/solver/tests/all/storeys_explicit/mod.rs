//! Buildings of several storeys by the central difference and the Verlet method.

mod limits;
mod orders;
mod spans;

use pounding_contact::ContactLaw;
use pounding_solver::{Bilinear, Elastic, Hysteretic, Integrator, Levels, Node, Pair, Row};

use crate::common::{CENTRAL, LOCATED, SUBSTEPPED, VERLET};
use crate::towers::{self, Rayleigh, Tower};

/// Every explicit method except that of Runge and Kutta.
const EXPLICIT: [(&str, Integrator); 4] = [
    ("central difference", CENTRAL),
    ("CD, sub-steps", SUBSTEPPED),
    ("Verlet", VERLET),
    ("Verlet, located", LOCATED),
];

const DAMPING: Rayleigh = Rayleigh { alpha: 0.3, beta: 2e-3 };

/// A tower of three storeys with a period of 0.7 s, lighter and softer towards the top.
fn soft<Column: Copy>(column: impl Fn(f64) -> Column) -> Tower<Column> {
    vec![(1.2e5, column(6e7)), (1.0e5, column(5e7)), (0.7e5, column(3e7))]
}

/// A stiff tower of this many storeys.
fn stiff<Column: Copy>(n_storeys: usize, column: impl Fn(f64) -> Column) -> Tower<Column> {
    towers::uniform(n_storeys, 3e5, column(4.5e8))
}

fn elastic(stiffness: f64) -> Elastic {
    Elastic { stiffness }
}

/// Columns that yield at a drift of 8 mm.
fn plastic(stiffness: f64) -> Bilinear {
    Bilinear {
        stiffness,
        yield_force: 0.008 * stiffness,
        hardening: 0.0,
    }
}

/// Neighbouring towers. Floors that face each other touch by a law if there is a gap between their buildings.
fn side_by_side<Column: Hysteretic>(towers: &[Tower<Column>], gaps: &[f64], law: ContactLaw) -> (Row<Column>, Levels) {
    towers::row(towers, DAMPING, |building, _, [left, right]| {
        (right == left + 1).then_some(Pair::of_floors(left, right, gaps[building], law))
    })
}

/// The row with other initial displacements and velocities of the nodes.
fn started<Column: Hysteretic>(row: &Row<Column>, start: impl Fn(usize) -> (f64, f64)) -> Row<Column> {
    let nodes = row.nodes().iter().enumerate().map(|(index, node)| {
        let (initial_displacement, initial_velocity) = start(index);
        Node {
            initial_displacement,
            initial_velocity,
            ..*node
        }
    });
    Row::new(nodes.collect(), row.pairs().to_vec()).expect("a valid row")
}
