//! Tests of the second route to a reference.

mod closed_forms;
mod exact;
mod friction;
mod impacts;
mod laws;
mod limits;
mod links;
mod loops;
mod opensees;
mod relations;
mod rest;
mod stepping;
mod storeys;
mod travel;

use pounding_contact::{ContactLaw, NonlinearViscoelastic, Stereomechanical};
use pounding_reference::{Fineness, Response};
use pounding_solver::{Elastic, Excitation, Hysteretic, Node, Pair, Row};

/// Columns without stiffness: a free mass.
const FREE: Elastic = Elastic { stiffness: 0.0 };

fn stereomechanical(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

fn viscoelastic(impact_damping_ratio: f64) -> ContactLaw {
    ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
        impact_stiffness: 2.75e9,
        impact_damping_ratio,
    })
}

/// Pairs of all neighbours, with a common gap and law.
fn pairs(n_nodes: usize, gap: f64, law: ContactLaw) -> Vec<Pair> {
    let pair = |left| Pair::of_floors(left, left + 1, gap, law);
    (0..n_nodes - 1).map(pair).collect()
}

/// A structure with an initial velocity.
fn moving<Column>(mass: f64, velocity: f64, column: Column) -> Node<Column> {
    Node {
        initial_velocity: velocity,
        ..Node::structure(mass, 0.0, column)
    }
}

/// Runs a row under ground accelerations 0.1 s apart.
fn run<Column: Hysteretic>(row: &Row<Column>, ground: &[f64], duration: f64) -> Response {
    let excitation = Excitation::new(0.1, ground).expect("finite samples");
    pounding_reference::run(row, excitation, duration, Fineness::FINE).expect("the run ends")
}

/// Asserts that a number is within a relative `tolerance` of the wanted number.
#[track_caller]
fn close(found: f64, wanted: f64, tolerance: f64, what: &str) {
    assert!(
        (found - wanted).abs() <= tolerance * wanted.abs(),
        "{what}: found {found}, wanted {wanted}, relative error {:e}",
        (found - wanted) / wanted
    );
}
