//! Books of contacts in lanes: they doubt everything that a ledger refuses, and little else.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, LinearSpring};
use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{
    Bilinear, CentralDifference, Clock, Elastic, Excitation, Hysteretic, Integrator, Ledger, LedgerError, Node, Pair, Row,
};

use crate::towers::{self, Rayleigh, uniform};
use crate::watch::Watch;

/// Two structures that approach each other, and touch for about a hundredth of a second.
fn row(scene: usize, law: ContactLaw) -> Row<Elastic> {
    let node = |period: f64, velocity: f64| {
        let omega = 2.0 * std::f64::consts::PI / period;
        let stiffness = 1e5 * omega * omega;
        let structure = Node::structure(1e5, 0.1 * omega * 1e5, Elastic { stiffness });
        Node {
            initial_velocity: velocity,
            ..structure
        }
    };
    let shift = 0.01 * scene as f64;
    let pair = Pair::of_floors(0, 1, 0.01 + 0.001 * shift, law);
    let nodes = vec![node(0.7 + shift, 0.4), node(0.4, -0.3)];
    Row::new(nodes, vec![pair]).expect("valid")
}

/// Two towers that yield, approach each other, and touch.
fn tower_row(scene: usize, law: ContactLaw) -> Row<Bilinear> {
    let column = |stiffness: f64| Bilinear {
        stiffness,
        yield_force: 0.01 * stiffness,
        hardening: 0.1,
    };
    let shift = 1.0 + 0.01 * scene as f64;
    let towers = [uniform(3, 1e5, column(3e7 * shift)), uniform(2, 1e5, column(5e7))];
    let damping = Rayleigh { alpha: 0.3, beta: 1e-3 };
    let (row, levels) = towers::row(&towers, damping, |_, _, [left, right]| {
        Some(Pair::of_floors(left, right, 0.01 * shift, law))
    });
    let velocity = |node| if levels.place(node).0 == 0 { 0.4 } else { -0.3 };
    let nodes = row.nodes().iter().enumerate().map(|(index, node)| Node {
        initial_velocity: velocity(index),
        ..*node
    });
    Row::new(nodes.collect(), row.pairs().to_vec()).expect("valid")
}

const CENTRAL: CentralDifference = CentralDifference { contact_substeps: 1 };
const SCENES: usize = 40;
const END: f64 = 3.0;

/// Gives rows the name of their columns.
type OfKind<Column> = for<'a> fn(&'a [&'a Row<Column>]) -> RowsOf<'a>;

fn elastic<'a>(rows: &'a [&'a Row<Elastic>]) -> RowsOf<'a> {
    RowsOf::Elastic(rows)
}

fn bilinear<'a>(rows: &'a [&'a Row<Bilinear>]) -> RowsOf<'a> {
    RowsOf::Bilinear(rows)
}

/// Number of scenes that the ledger of a run alone refuses, and number of the others that lanes doubt.
fn refused_and_doubted<Column: Hysteretic>(
    settings: CentralDifference,
    (row, kind): (impl Fn(usize) -> Row<Column>, OfKind<Column>),
    n_steps: u32,
) -> (usize, usize) {
    let ground: Vec<f64> = (0..300).map(|n| 4.0 * libm::sin(0.11 * f64::from(n))).collect();
    let excitation = Excitation::new(0.01, &ground).expect("valid");
    let (time_step, n_steps) = (END / f64::from(n_steps), n_steps as usize);
    let clock = Clock { time_step, n_steps };
    let rows: Vec<_> = (0..SCENES).map(row).collect();
    let together = SideBySide::new(settings, excitation, clock).expect("valid");
    let mut found = SceneSums::default();
    let all: Vec<_> = rows.iter().collect();
    let ran = together.run(kind(&all), &[n_steps; SCENES], &mut found);
    assert!(ran, "the rows are of one shape");
    let (mut refused, mut doubted) = (0, 0);
    for (scene, row) in rows.iter().enumerate() {
        let mut ledger = Ledger::new(row, excitation);
        let ran = Integrator::CentralDifference(settings).watch(row, excitation, clock, &mut ledger);
        assert!(ran.is_ok() && found.is_told(scene), "{scene}");
        match ledger.verdict() {
            Err(LedgerError::GainInContact { .. }) => {
                assert!(found.is_doubted(scene), "{settings:?} {scene}");
                refused += 1;
            }
            Err(other) => panic!("{other}"),
            Ok(_) => doubted += usize::from(found.is_doubted(scene)),
        }
    }
    (refused, doubted)
}

/// Steps that resolve a contact badly let it give back more energy than it took.
#[test]
fn limit_what_a_ledger_refuses_is_doubted() {
    let spring = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 5e9 });
    let rows = (|scene| row(scene, spring), elastic as OfKind<_>);
    let (refused, _) = refused_and_doubted(CENTRAL, rows, 500);
    assert!(refused > 0, "the test sees nothing");
    let towers = (|scene| tower_row(scene, spring), bilinear as OfKind<_>);
    let (refused, _) = refused_and_doubted(CENTRAL, towers, 500);
    assert!(refused > 0, "towers: the test sees nothing");
}

/// Steps that resolve a contact are not doubted.
#[test]
fn limit_ordinary_scenes_are_not_doubted() {
    let damped = LawName::KelvinVoigt.calibrated(5e7, 0.65, Calibration::Exact, &FreePair::UNIT);
    let damped = damped.expect("valid");
    let spring = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 5e7 });
    for law in [damped, spring] {
        let rows = (|scene| row(scene, law), elastic as OfKind<_>);
        let found = refused_and_doubted(CENTRAL, rows, 3000);
        assert_eq!(found, (0, 0), "{law:?}");
    }
    for law in [damped, spring] {
        let towers = (|scene| tower_row(scene, law), bilinear as OfKind<_>);
        let found = refused_and_doubted(CENTRAL, towers, 3000);
        assert_eq!(found, (0, 0), "towers: {law:?}");
    }
}
