//! Machines with narrower vectors than this one.

use fearless_simd::Level;
use pounding_contact::{Calibration, ContactLaw, NonlinearViscoelastic, Stereomechanical};

use super::{ExactSideBySide, RowsOf, SideBySide, Tallies};
use crate::{
    CentralDifference, Clock, Elastic, Exact, Excitation, ImpactRule, Node, Pair, Row,
    SimultaneousImpacts, Start,
};

const CLOCK: Clock = Clock {
    time_step: 0.01,
    n_steps: 400,
};
/// No whole number of groups of any width.
const SCENES: usize = 13;

/// Two structures of other periods in every scene.
fn rows(law: ContactLaw) -> Vec<Row<Elastic>> {
    let row = |scene: usize| {
        let node = |stiffness: f64| Node::structure(1e5, 2e4, Elastic { stiffness });
        let stiffness = 2e6 + 3e5 * scene as f64;
        let pair = Pair {
            left: 0,
            right: 1,
            gap: 0.002,
            law,
        };
        Row::new(vec![node(stiffness), node(9e6)], vec![pair]).expect("valid")
    };
    (0..SCENES).map(row).collect()
}

fn laws() -> [ContactLaw; 2] {
    let element = NonlinearViscoelastic::calibrated(1e9, 0.65, Calibration::Exact);
    [
        ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 }),
        ContactLaw::NonlinearViscoelastic(element.expect("valid")),
    ]
}

/// What was told of every scene, in bits.
fn bits(tallies: &Tallies) -> Vec<[u64; 5]> {
    let of = |scene: usize| {
        let pair = tallies.pair(scene, 0);
        let [left, right] = [0, 1].map(|node| tallies.displacement(scene, node));
        assert!(tallies.is_told(scene), "scene {scene} was given up");
        assert!(pair.collisions > 0.0, "nothing touches in scene {scene}");
        [left, right, pair.collisions, pair.impulse, pair.peak_force].map(f64::to_bits)
    };
    (0..SCENES).map(of).collect()
}

#[test]
fn limit_two_lanes_give_the_bits_of_as_many_as_there_are() {
    let ground: Vec<f64> = (0..=80).map(|n| 4.0 * libm::sin(f64::from(n))).collect();
    let excitation = Excitation::new(0.05, &ground).expect("valid");
    let narrow = Level::Sse2(Level::new().as_sse2().expect("every such machine has it"));
    let settings = CentralDifference {
        start: Start::Consistent,
        impacts: ImpactRule::VelocityJump,
        contact_substeps: 1,
    };
    let exact = Exact {
        tolerance: 1e-8,
        simultaneous_impacts: SimultaneousImpacts::Together,
    };
    for law in laws() {
        let rows = rows(law);
        let mut wide = SideBySide::new(settings, excitation, CLOCK).expect("valid");
        let [mut one, mut other] = [Tallies::default(), Tallies::default()];
        let all: Vec<_> = rows.iter().collect();
        let n_steps = [CLOCK.n_steps; SCENES];
        assert!(wide.run(RowsOf::Elastic(&all), &n_steps, &mut one));
        wide.level = narrow;
        assert!(wide.run(RowsOf::Elastic(&all), &n_steps, &mut other));
        assert_eq!(bits(&one), bits(&other), "{}", law.name());

        let mut wide = ExactSideBySide::new(exact, excitation, CLOCK).expect("valid");
        let all: Vec<_> = rows.iter().enumerate().collect();
        one.begin(SCENES, (2, 1));
        wide.run(&all, &mut one);
        wide.level = narrow;
        other.begin(SCENES, (2, 1));
        wide.run(&all, &mut other);
        assert_eq!(bits(&one), bits(&other), "{}", law.name());
    }
}
