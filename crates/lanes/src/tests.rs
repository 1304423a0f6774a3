//! Simulation of machines with narrower vectors.

use fearless_simd::Level;
use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, Stereomechanical};

use super::{ExactSideBySide, RowsOf, SceneSums, SideBySide};
use pounding_solver::{CentralDifference, Clock, Elastic, Exact, Excitation, Floor, Node, Pair, Row, SimultaneousImpacts};

const CLOCK: Clock = Clock {
    time_step: 0.01,
    n_steps: 400,
};
/// Not a multiple of any group width.
const SCENES: usize = 13;

/// Rows with this many structures of this many storeys; periods differ between scenes.
fn rows(law: ContactLaw, structures: usize, storeys: usize) -> Vec<Row<Elastic>> {
    let row = |scene: usize| {
        let node = |index: usize| {
            let shift = if index.is_multiple_of(2) { 3e5 * scene as f64 } else { 6.6e6 };
            let stiffness = 2e6 + 4e5 * index as f64 + shift;
            let node = Node::structure(1e5, 2e4, Elastic { stiffness });
            let on_floor = |below| {
                let ground_damping = 1e4;
                node.on_floor(Floor { below, ground_damping })
            };
            index.checked_sub(structures).map_or(node, on_floor)
        };
        let pair = |left: usize| Pair::of_floors(left, left + 1, 0.002, law);
        let floors = structures * storeys;
        let lefts = (0..floors).filter(|left| (left + 1) % structures > 0);
        let pairs = lefts.map(pair).collect();
        Row::new((0..floors).map(node).collect(), pairs).expect("valid")
    };
    (0..SCENES).map(row).collect()
}

fn laws() -> [ContactLaw; 2] {
    let element = LawName::NonlinearViscoelastic.calibrated(1e9, 0.65, Calibration::Exact, &FreePair::UNIT);
    [
        ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 }),
        element.expect("valid"),
    ]
}

/// Results of every structure and its right neighbour, in bits.
fn bits(tallies: &SceneSums, structures: usize) -> Vec<[u64; 5]> {
    let of = |scene: usize| {
        assert!(tallies.is_told(scene), "{structures}: scene {scene} was given up");
        (1..structures).map(move |right| {
            let pair = tallies.pair(scene, right - 1);
            let [one, other] = [right - 1, right].map(|node| tallies.displacement(scene, node));
            assert!(pair.collisions > 0.0, "{structures}: nothing touches in scene {scene}");
            [one, other, pair.collisions, pair.impulse, pair.peak_force].map(f64::to_bits)
        })
    };
    (0..SCENES).flat_map(of).collect()
}

#[test]
fn limit_two_lanes_give_the_bits_of_as_many_as_there_are() {
    let ground: Vec<f64> = (0..=80).map(|n| 4.0 * libm::sin(f64::from(n))).collect();
    let excitation = Excitation::new(0.05, &ground).expect("valid");
    let narrow = Level::Sse2(Level::new().as_sse2().expect("every such machine has it"));
    let exact = Exact {
        tolerance: 1e-8,
        simultaneous_impacts: SimultaneousImpacts::Together,
    };
    for law in laws() {
        let [mut one, mut other] = [SceneSums::default(), SceneSums::default()];
        // Two structures have separate code; up to three advance two groups together.
        let shapes = [(2, 1), (3, 1), (5, 1), (2, 3)];
        for (structures, storeys) in shapes {
            let rows = rows(law, structures, storeys);
            let mut wide = SideBySide::new(CentralDifference::default(), excitation, CLOCK).expect("valid");
            let all: Vec<_> = rows.iter().collect();
            let n_steps = [CLOCK.n_steps; SCENES];
            assert!(wide.run(RowsOf::Elastic(&all), &n_steps, &mut one));
            wide.level = narrow;
            assert!(wide.run(RowsOf::Elastic(&all), &n_steps, &mut other));
            let [one, other] = [&one, &other].map(|tallies| bits(tallies, structures));
            assert_eq!(one, other, "{structures} with {}", law.name());
        }

        let rows = rows(law, 2, 1);
        let mut wide = ExactSideBySide::new(exact, excitation, CLOCK).expect("valid");
        let all: Vec<_> = rows.iter().enumerate().collect();
        one.begin(SCENES, 2, 1);
        wide.run(&all, &mut one);
        wide.level = narrow;
        other.begin(SCENES, 2, 1);
        wide.run(&all, &mut other);
        assert_eq!(bits(&one, 2), bits(&other, 2), "{}", law.name());
    }
}
