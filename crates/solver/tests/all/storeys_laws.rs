//! Laws of mechanics on random rows of buildings, by the exact method.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Clock, Excitation, Histories, Hysteresis, Hysteretic, Knee, Levels, Node, Pair, Row, RunError, Smoothness, Storey, Support,
};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

use crate::common::{STEREOMECHANICAL, VISCOELASTIC, clock, ground};
use crate::random_rows::any_law;
use crate::storeys_books::{Books, LoopColumns};
use crate::storeys_exact::EXACT;
use crate::watch::Watch;

/// A row of buildings under a record.
#[derive(Debug, Clone)]
struct Case {
    /// Whether the first building is a wall.
    wall: bool,
    /// Storeys of every building.
    buildings: Vec<Vec<Storey<LoopColumns>>>,
    /// Gap and law of floors that face each other, for every two neighbours.
    between: Vec<Vec<(f64, ContactLaw)>>,
    /// Samples every 0.01 s \[m/s²\].
    ground: Vec<f64>,
}

fn power_of_ten(exponents: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    exponents.prop_map(|exponent| libm::pow(10.0, exponent))
}

fn storey(spread: f64) -> impl Strategy<Value = Storey<LoopColumns>> {
    let knee = prop_oneof![
        2 => Just(Knee::Sharp),
        1 => (1..=20_u32, 0.0..1.0_f64)
            .prop_map(|(exponent, unloading)| Knee::Smooth(Smoothness { exponent, unloading })),
    ];
    (
        power_of_ten(4.5 - spread..5.5 + spread),
        power_of_ten(-1.3..0.0),
        prop_oneof![Just((0.0, 0.0)), (0.0..2.0_f64, 0.0..4e-3_f64)],
        prop_oneof![Just(f64::INFINITY), power_of_ten(-4.0..-1.5)],
        prop_oneof![Just(0.0), 0.0..0.3_f64],
        knee,
    )
        .prop_map(|(mass, period, (alpha, beta), yields, hardening, knee)| {
            let omega = 2.0 * std::f64::consts::PI / period;
            let stiffness = mass * omega * omega;
            Storey {
                mass,
                damping: beta * stiffness,
                ground_damping: alpha * mass,
                column: LoopColumns(Hysteresis {
                    stiffness,
                    hardening,
                    yield_force: stiffness * yields,
                    knee,
                }),
            }
        })
}

/// Any law, except impacts that bounce without end.
fn law() -> impl Strategy<Value = ContactLaw> {
    any_law().prop_map(|law| {
        law.impulsive().map_or(law, |hard| {
            ContactLaw::Stereomechanical(Stereomechanical {
                restitution: hard.restitution.min(0.95),
            })
        })
    })
}

/// Two to four buildings of one to five storeys.
fn cases() -> impl Strategy<Value = Case> {
    let gap = || prop_oneof![Just(0.0), power_of_ten(-6.0..-3.0), 0.0..0.05_f64];
    let building = prop::collection::vec(storey(0.7), 1..=5);
    let contact = move || {
        prop_oneof![
            (gap(), law()).prop_map(|contact| vec![contact; 5]),
            prop::collection::vec((gap(), law()), 5),
        ]
    };
    (
        prop::bool::weighted(0.2),
        prop::collection::vec(building, 2..=4),
        prop::collection::vec(contact(), 3),
        prop::collection::vec(-8.0..8.0_f64, 2..60),
    )
        .prop_map(|(wall, buildings, between, ground)| Case {
            wall,
            buildings,
            between,
            ground,
        })
}

impl Case {
    fn row(&self) -> Row<LoopColumns> {
        let counts: Vec<_> = self.buildings.iter().map(Vec::len).collect();
        let levels = Levels::new(&counts);
        let floor = |node: usize| {
            let (building, storey) = levels.place(node);
            let storey = self.buildings[building][storey];
            if self.wall && building == 0 {
                Node::wall(storey.column)
            } else {
                levels.floor(node, storey)
            }
        };
        let nodes = (0..levels.n_nodes()).map(floor).collect();
        let mut pairs = Vec::new();
        for left in 0..counts.len() - 1 {
            for (storey, (a, b)) in levels.facing(left).enumerate() {
                let (gap, law) = self.between[left][storey];
                pairs.push(Pair::of_floors(a, b, gap, law));
            }
        }
        pairs.sort_by_key(Pair::left);
        Row::new(nodes, pairs).expect("a valid row")
    }
}

/// Largest overlap \[m\] of impulsive pairs at the instants of histories.
fn overlap(row: &Row<LoopColumns>, dense: &Histories) -> f64 {
    let impulsive = |pair: &&Pair| matches!(pair.law, ContactLaw::Stereomechanical(_));
    let pairs = row.pairs().iter().filter(impulsive);
    pairs.fold(0.0, |most, pair| {
        let sides = [pair.left(), pair.right()].map(|node| &dense.of(node).states);
        let overlaps = sides[0].iter().zip(sides[1]);
        let overlaps = overlaps.map(|(a, b)| a.displacement - b.displacement - pair.gap());
        overlaps.fold(most, f64::max)
    })
}

/// Runs a row for longer than its record. Returns the largest violation of a law, or the error of the run.
fn run(case: &Case) -> Result<(f64, &'static str), RunError> {
    let row = case.row();
    let clock = Clock {
        time_step: 0.01,
        n_steps: 60,
    };
    let excitation = Excitation::new(0.01, &case.ground).expect("the ground motion is finite");
    let mut recorders = (Books::new(&row, &case.ground), Histories::new(row.nodes().len(), 0.01 / 16.0, 0.6));
    EXACT.watch(&row, excitation, clock, &mut recorders)?;
    let (books, dense) = recorders;
    let overlap = overlap(&row, &dense) / 1e-11;
    let worst = books.worst();
    Ok(if overlap > worst.0 {
        (overlap, "an impulsive pair overlaps")
    } else {
        worst
    })
}

/// A hundred rows, equal in every run; `PROPTEST_CASES` asks for more and `SEED` for others. Of 3500 such rows two ended with an error
/// ([`RunError::NoSeries`]: compliant pairs without a gap, pressed together from the start), and none broke a law.
#[test]
fn limit_random_rows_keep_the_laws_of_mechanics() {
    let asked = |name: &str| std::env::var(name).ok()?.parse::<u32>().ok();
    let (count, seed) = (asked("PROPTEST_CASES").unwrap_or(100), asked("SEED").unwrap_or(0));
    let seed = seed.to_le_bytes().repeat(8);
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(ProptestConfig::default(), rng);
    let strategy = cases();
    let (mut ended, mut broken) = (Vec::new(), Vec::new());
    for number in 0..count {
        let case = strategy.new_tree(&mut runner).expect("a case is made without rejection").current();
        match run(&case) {
            Err(error) => ended.push(format!("{number}: {error}")),
            Ok((worst, law)) if worst.is_nan() || worst > 1.0 => {
                broken.push(format!("{number}: {law}, {worst:e} of what is allowed"));
            }
            Ok(_) => {}
        }
    }
    println!("{} of {count} rows end early: {ended:#?}", ended.len());
    assert!(broken.is_empty(), "{broken:#?}");
    assert!(100 * ended.len() <= count as usize, "{ended:#?}");
}

#[test]
fn reference_energies_of_elastic_towers_balance() {
    let samples = ground();
    let storey = |mass: f64, stiffness: f64| Storey {
        mass,
        damping: 1.5e-3 * stiffness,
        ground_damping: 0.5 * mass,
        column: LoopColumns(Hysteresis::elastic(stiffness)),
    };
    let buildings = vec![
        vec![storey(9e4, 4e7), storey(8e4, 3e7), storey(7e4, 2.5e7), storey(5e4, 1.5e7)],
        vec![storey(3e5, 6e8), storey(2e5, 5e8), storey(2e5, 4e8)],
        vec![storey(6e4, 2e7), storey(6e4, 2e7)],
    ];
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let case = Case {
            wall: false,
            buildings: buildings.clone(),
            between: vec![vec![(0.01, law); 5]; 2],
            ground: samples.clone(),
        };
        let row = case.row();
        let mut recorders = (Books::new(&row, &samples), Histories::new(9, 0.01, 10.0));
        let excitation = Excitation::new(0.01, &samples).expect("the ground motion is finite");
        EXACT
            .watch(&row, excitation, clock(0.01, 10.0), &mut recorders)
            .expect("the run ends");
        let (books, histories) = recorders;
        let worst = books.worst();
        assert!(worst.0 < 0.1, "{law:?}: {worst:?}");
        // The work of the columns is their energy at the end.
        let end = |node: usize| histories.of(node).states[1000].displacement;
        let strain = row.nodes().iter().enumerate().map(|(node, floor)| {
            let below = match floor.support {
                Support::Ground => 0.0,
                Support::Floor(floor) => end(floor.below),
            };
            0.5 * floor.column.stiffness() * (end(node) - below) * (end(node) - below)
        });
        let off = (books.terms[3] - strain.sum::<f64>()).abs() / books.scale;
        assert!(off < 1e-9, "{law:?}: {off:e}");
    }
}
