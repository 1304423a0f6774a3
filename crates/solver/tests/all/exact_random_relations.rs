//! Random rows whose pairs are no chain, under random records, by the exact method.

use pounding_contact::ContactLaw;
use pounding_solver::{Bilinear, Excitation, Floor, Ledger, Node, Pair, Point, Row, RunError};
use proptest::prelude::*;

use crate::common::{clock, meeting};
use crate::random_rows::{any_law, config, stereomechanical};
use crate::storeys_exact::exact;
use crate::watch::Watch;

/// A point: building, floor, and the part of this floor in its displacement; the rest belongs to the floor below.
type Place = (prop::sample::Index, prop::sample::Index, f64);
/// Two points, gap and law.
type Meeting = ([Place; 2], f64, ContactLaw);

/// Buildings, and pairs of points on two of them.
#[derive(Debug, Clone)]
struct Case {
    /// Mass \[kg\], period of the storey alone \[s\] and yield displacement \[m\] of every floor.
    buildings: Vec<Vec<[f64; 3]>>,
    has_wall: bool,
    pairs: Vec<Meeting>,
    /// Delay from building to building \[s\].
    delay: f64,
    ground: Vec<f64>,
}

impl Case {
    fn row(&self) -> Row<Bilinear> {
        let (mut nodes, mut first, mut arrivals) = (Vec::new(), Vec::new(), Vec::new());
        for (index, floors) in self.buildings.iter().enumerate() {
            first.push(nodes.len());
            for (storey, [mass, period, yields]) in floors.iter().enumerate() {
                let omega = 2.0 * std::f64::consts::PI / period;
                let column = Bilinear {
                    stiffness: mass * omega * omega,
                    yield_force: mass * omega * omega * yields,
                    hardening: 0.05,
                };
                let node = Node::structure(*mass, 0.04 * omega * mass, column);
                let floor = Floor {
                    below: nodes.len().saturating_sub(1),
                    ground_damping: 0.1 * mass,
                };
                nodes.push(if storey > 0 { node.on_floor(floor) } else { node });
                arrivals.push(self.delay * index as f64);
            }
        }
        let wall = nodes.len();
        if self.has_wall {
            nodes.push(Node::wall(nodes[0].column));
            arrivals.push(self.delay * self.buildings.len() as f64);
        }
        let n = self.buildings.len() + usize::from(self.has_wall);
        let point = |building: usize, floor: &prop::sample::Index, part: f64| {
            if building == self.buildings.len() {
                return Point::Floor(wall);
            }
            let storey = floor.index(self.buildings[building].len());
            let upper = first[building] + storey;
            let lower = storey.checked_sub(1).map(|_| upper - 1);
            Point::between(lower, upper, part).unwrap_or(Point::Floor(upper))
        };
        let pair = |([left, right], gap, law): &Meeting| -> Pair {
            let (a, floor, part) = left;
            let (b, other, others) = right;
            let a = a.index(n);
            let b = (a + 1 + b.index(n - 1)) % n;
            // From left to right: a building on both sides of another would hold it from the start.
            let (a, b) = (a.min(b), a.max(b));
            meeting(point(a, floor, *part), point(b, other, *others), *gap, *law)
        };
        let row = Row::new(nodes, self.pairs.iter().map(pair).collect()).expect("a valid row");
        row.delayed(arrivals).expect("one for each building")
    }
}

fn cases(law: fn() -> BoxedStrategy<ContactLaw>) -> impl Strategy<Value = Case> {
    let mass = (3.5..6.5_f64).prop_map(|exponent| libm::pow(10.0, exponent));
    let yields = prop_oneof![Just(f64::INFINITY), 1e-3..1e-1_f64];
    let floor = (mass, 0.05..1.0_f64, yields);
    let floor = floor.prop_map(|(mass, period, yields)| [mass, period, yields]);
    let building = prop::collection::vec(floor, 1..=3);
    let part = prop_oneof![Just(1.0), 0.05..0.95_f64];
    let point = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), part);
    let points = [point.clone(), point];
    let gap = prop_oneof![Just(0.0), 0.0..0.02_f64];
    let pairs = prop::collection::vec((points, gap, law()), 1..=6);
    (
        prop::collection::vec(building, 2..=3),
        any::<bool>(),
        pairs,
        prop_oneof![2 => Just(0.0), 1 => 0.001..0.03_f64],
        prop::collection::vec(-8.0..8.0_f64, 2..60),
    )
        .prop_map(|(buildings, has_wall, pairs, delay, ground)| Case {
            buildings,
            has_wall,
            pairs,
            delay,
            ground,
        })
}

fn check(case: &Case) -> Result<(), TestCaseError> {
    let row = case.row();
    let excitation = Excitation::new(0.01, &case.ground).expect("finite");
    let mut ledger = Ledger::new(&row, excitation);
    let done = exact(1e-16).watch(&row, excitation, clock(0.01, 0.8), &mut ledger);
    match done {
        Ok(_) => {}
        // With e near 1, neighbours that press bounce for ever, and grounds that move apart may leave no room.
        Err(RunError::BouncesWithoutEnd { restitution, .. }) if restitution > 0.9 => return Ok(()),
        Err(RunError::ClosedIn { .. }) if case.delay > 0.0 => return Ok(()),
        // Compliant pairs without a gap, pressed together from the start, as in chains of floors.
        Err(RunError::NoSeries { .. } | RunError::OutOfNumbers { .. })
            if case.pairs.iter().any(|(_, gap, law)| *gap == 0.0 && law.is_compliant()) =>
        {
            return Ok(());
        }
        Err(error) => return Err(TestCaseError::fail(format!("{error:?}"))),
    }
    // If grounds move apart, the result has the rounding of their displacements.
    let allowed = if case.delay > 0.0 { 1e-10 } else { 1e-11 };
    for found in [ledger.identity(), ledger.momentum(), ledger.residual()] {
        prop_assert!(found < allowed, "{found:e}");
    }
    let verdict = ledger.verdict();
    prop_assert!(verdict.is_ok(), "{verdict:?}");
    Ok(())
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn limit_random_relations_balance(case in cases(any_law)) {
        check(&case)?;
    }

    #[test]
    fn limit_random_impacts_balance(case in cases(stereomechanical)) {
        check(&case)?;
    }
}
