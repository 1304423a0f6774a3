//! Books of contacts side by side: they doubt what a ledger refuses, and little else.

use pounding_contact::{ContactLaw, KelvinVoigt, LinearSpring};
use pounding_solver::{
    CentralDifference, Clock, Elastic, Excitation, Integrator, Ledger, LedgerError, Node, Pair,
    Row, RowsOf, SceneSums, SideBySide, Stepping, Verlet, VerletImpacts,
};

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
    let pair = Pair {
        left: 0,
        right: 1,
        gap: 0.01 + 0.001 * shift,
        law,
    };
    let nodes = vec![node(0.7 + shift, 0.4), node(0.4, -0.3)];
    Row::new(nodes, vec![pair]).expect("valid")
}

const METHODS: [Stepping; 2] = [
    Stepping::CentralDifference(CentralDifference {
        contact_substeps: 1,
    }),
    Stepping::Verlet(Verlet {
        impacts: VerletImpacts::Located,
    }),
];
const SCENES: usize = 40;
const END: f64 = 3.0;

/// How many scenes the ledger of a run alone refuses, and how many of the others are doubted side by side.
fn refused_and_doubted(stepping: Stepping, law: ContactLaw, n_steps: u32) -> (usize, usize) {
    let ground: Vec<f64> = (0..300)
        .map(|n| 4.0 * libm::sin(0.11 * f64::from(n)))
        .collect();
    let excitation = Excitation::new(0.01, &ground).expect("valid");
    let (time_step, n_steps) = (END / f64::from(n_steps), n_steps as usize);
    let clock = Clock { time_step, n_steps };
    let rows: Vec<_> = (0..SCENES).map(|scene| row(scene, law)).collect();
    let together = SideBySide::new(stepping, excitation, clock).expect("valid");
    let mut found = SceneSums::default();
    let all: Vec<_> = rows.iter().collect();
    let ran = together.run(RowsOf::Elastic(&all), &[n_steps; SCENES], &mut found);
    assert!(ran, "the rows are of one shape");
    let (mut refused, mut doubted) = (0, 0);
    for (scene, row) in rows.iter().enumerate() {
        let mut ledger = Ledger::new(row, excitation);
        let ran = Integrator::from(stepping).watch(row, excitation, clock, &mut ledger);
        assert!(ran.is_ok() && found.is_told(scene), "{scene}");
        match ledger.verdict() {
            Err(LedgerError::GainInContact { .. }) => {
                assert!(found.is_doubted(scene), "{stepping:?} {scene}");
                refused += 1;
            }
            Err(other) => panic!("{other}"),
            Ok(_) => doubted += usize::from(found.is_doubted(scene)),
        }
    }
    (refused, doubted)
}

/// Steps that resolve a contact badly let it give back more than it took.
#[test]
fn limit_what_a_ledger_refuses_is_doubted() {
    let spring = ContactLaw::LinearSpring(LinearSpring {
        impact_stiffness: 5e9,
    });
    for stepping in METHODS {
        let (refused, _) = refused_and_doubted(stepping, spring, 500);
        assert!(refused > 0, "{stepping:?}: the test sees nothing");
    }
}

/// Steps that resolve it are not doubted.
#[test]
fn limit_ordinary_scenes_are_not_doubted() {
    let damped = ContactLaw::KelvinVoigt(
        KelvinVoigt::calibrated(5e7, 0.65, pounding_contact::Calibration::Exact).expect("valid"),
    );
    let spring = ContactLaw::LinearSpring(LinearSpring {
        impact_stiffness: 5e7,
    });
    for stepping in METHODS {
        for law in [damped, spring] {
            assert_eq!(refused_and_doubted(stepping, law, 3000), (0, 0), "{law:?}");
        }
    }
}
