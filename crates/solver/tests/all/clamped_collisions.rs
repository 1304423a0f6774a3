//! A collision lasts from touch to parting, even if a clamped force releases the pair in between.

use pounding_contact::{Calibration, ContactLaw, FreePair, KelvinVoigt, LawName};
use pounding_solver::{Collisions, Elastic, Exact, Excitation, Histories, Impact, Integrator, Ledger, Node, Recorder, Row, Span};

use crate::common::{METHODS, STIFF, WEAK, clock, elastic, ground, pairs};
use crate::watch::Watch;

const GAP: f64 = 0.0;

/// Counts how often the left structure begins to be pushed.
#[derive(Default)]
struct Pushes {
    n: usize,
    pushed: bool,
}

impl Recorder for Pushes {
    fn span(&mut self, span: &Span<'_>) {
        if span.structure == 0 {
            let pushed = span.impulse_from_right != 0.0;
            self.n += usize::from(pushed && !self.pushed);
            self.pushed = pushed;
        }
    }

    fn impact(&mut self, _: &Impact) {}
}

/// Collisions, pushes, and overlaps counted at equal intervals.
fn counts(method: Integrator, time_step: f64) -> [usize; 3] {
    let law = LawName::KelvinVoigt.calibrated(9.35e7, 0.2, Calibration::Exact, &FreePair::UNIT);
    let law = law.expect("a good law");
    let row = Row::new(vec![elastic(WEAK), elastic(STIFF)], pairs(2, GAP, law)).expect("a row");
    let ground = ground();
    let excitation = Excitation::new(0.01, &ground).expect("good samples");
    let mut seen = (Collisions::new(2, row.pairs()), Pushes::default(), Histories::new(2, 1e-4, 10.0));
    method
        .watch(&row, excitation, clock(time_step, 10.0), &mut seen)
        .expect("the run ends");
    let (collisions, pushes, histories) = seen;
    let [left, right] = [0, 1].map(|structure| &histories.of(structure).states);
    let overlaps: Vec<_> = left
        .iter()
        .zip(right)
        .map(|(left, right)| left.displacement - right.displacement - GAP > 0.0)
        .collect();
    let n_overlaps = overlaps.windows(2).filter(|pair| !pair[0] && pair[1]).count();
    [collisions.all().len(), pushes.n, n_overlaps]
}

/// Each time a clamped law released and pushed again, a new collision was counted.
#[test]
fn issue_a_force_that_lets_go_before_the_parting_is_no_new_collision() {
    let [exact, pushes, overlaps] = counts(Integrator::Exact(Exact::default()), 1e-4);
    assert_eq!(exact, overlaps, "collisions are overlaps");
    assert!(pushes > exact, "the clamp lets go: {pushes} pushes, {exact} collisions");
    for (name, method) in METHODS {
        let [found, _, overlaps] = counts(method, 1e-4);
        assert_eq!([found, overlaps], [exact; 2], "{name}");
    }
}

/// The dashpot releases neighbours, the ground then holds them together, and the spring finally drives them apart. The law gives back
/// energy that it took before. The verdict reported a collision that gave energy without having taken any.
#[test]
fn issue_energy_given_back_after_a_clamp_was_taken_before() {
    let law = ContactLaw::KelvinVoigt(KelvinVoigt {
        impact_stiffness: 9.35e7,
        impact_damping_ratio: 0.9,
    });
    // Against a wall: after the dashpot has released the structure, the ground holds it for 20 ms.
    let nodes = vec![
        Node {
            initial_velocity: 1.0,
            ..Node::structure(1e5, 0.0, Elastic { stiffness: 1e3 })
        },
        Node::wall(Elastic { stiffness: 1.0 }),
    ];
    let row = Row::new(nodes, pairs(2, 0.0, law)).expect("a row");
    let mut ground = vec![0.0; 200];
    ground[75..95].fill(-6.0);
    let excitation = Excitation::new(1e-3, &ground).expect("good samples");
    for (name, method) in METHODS.into_iter().chain([("exact", Integrator::Exact(Exact::default()))]) {
        let mut seen = (Ledger::new(&row, excitation), Pushes::default(), Collisions::new(2, row.pairs()));
        method.watch(&row, excitation, clock(1e-5, 0.2), &mut seen).expect("the run ends");
        let (ledger, pushes, collisions) = seen;
        assert_eq!((pushes.n, collisions.all().len()), (2, 1), "{name}");
        ledger.verdict().unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}
