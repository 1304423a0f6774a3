//! The exact method on rows whose pairs are no chain: several pairs at a floor, and points between two floors.

use pounding_contact::{ContactLaw, HertzDamp, KelvinVoigt, LinearSpring, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{
    Clock, Elastic, Excitation, Impact, Integrator, Ledger, Node, Pair, Point, Recorder, Relation, Row, Share, Span, Support,
};

use crate::common::{AVERAGE, CENTRAL, between, book, building, clock, floors_and_columns, free, ground, meeting, slope};
use crate::storeys_exact::{EXACT, distance, histories, same};
use crate::watch::Watch;

const JUMPS: ContactLaw = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.6 });
const SPRING: ContactLaw = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 3e8 });
const VISCOUS: ContactLaw = ContactLaw::KelvinVoigt(KelvinVoigt {
    impact_stiffness: 3e8,
    impact_damping_ratio: 0.2,
});
const HERTZ: ContactLaw = ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
    impact_stiffness: 2.75e9,
    impact_damping_ratio: 0.35,
});
const DAMPED: ContactLaw = ContactLaw::HertzDamp(HertzDamp {
    impact_stiffness: 2.75e9,
    impact_damping_factor: 0.5,
});
const LAWS: [ContactLaw; 5] = [JUMPS, SPRING, VISCOUS, HERTZ, DAMPED];

/// Reports of a run about contact.
#[derive(Default)]
struct Seen {
    impacts: Vec<Impact>,
    /// Pair, start and end of spans with a force, and the force there.
    pushes: Vec<(usize, [f64; 2], [f64; 2])>,
    /// Displacement and velocity at the end of each such span, by node.
    ends: Vec<(usize, f64, [f64; 2])>,
}

impl Recorder for Seen {
    fn span(&mut self, span: &Span<'_>) {
        let end = [span.end.displacement, span.end.velocity];
        for push in span.pushes.iter().filter(|push| !push.is_none()) {
            let times = [span.start_time, span.end_time];
            self.pushes.push((push.pair, times, push.forces));
        }
        self.ends.push((span.structure, span.end_time, end));
    }
    fn impact(&mut self, impact: &Impact) {
        self.impacts.push(*impact);
    }
}

fn watch(row: &Row<Elastic>, duration: f64) -> Seen {
    let mut seen = Seen::default();
    let still = [0.0, 0.0];
    let excitation = Excitation::new(1.0, &still).expect("it is finite");
    EXACT
        .watch(row, excitation, clock(0.001, duration), &mut seen)
        .expect("the run ends");
    seen
}

fn moving(node: Node<Elastic>, velocity: f64) -> Node<Elastic> {
    Node {
        initial_velocity: velocity,
        ..node
    }
}

fn near(found: f64, wanted: f64) {
    let off = (found - wanted).abs() / wanted.abs().max(1e-3);
    assert!(off < 1e-12, "{found} {wanted} {off:e}");
}

#[test]
fn reference_slabs_that_share_a_floor() {
    let mut nodes = building(0, &[(3e5, 0.0, 0.0); 2]);
    nodes.extend(building(2, &[(2e5, 0.0, 0.0); 3]));
    nodes[0] = moving(nodes[0], 1.0);
    nodes[1] = moving(nodes[1], 0.2);
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 });
    let pairs = vec![
        meeting(0, between(Some(2), 3, 0.6), 0.0, law),
        meeting(1, between(Some(3), 4, 0.3), 0.0, law),
    ];
    let row = Row::new(nodes, pairs).unwrap();
    let impacts = watch(&row, 0.001).impacts;
    assert_eq!(impacts.len(), 1, "{impacts:?}");
    near(impacts[0].impulse, 278_089.887_640_449_4);
    near(impacts[0].rates()[1], -0.65);
    let floor = |floor: usize| {
        let struck = impacts[0].struck().find(|struck| struck.floor == floor);
        struck.unwrap().velocities[1]
    };
    near(0.2 - 0.7 * floor(3), -0.383_988_764_044_943_8);
}

#[test]
fn reference_a_slab_hits_a_column() {
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 });
    let cases = [
        (
            0.6,
            142_898.383_371_824_5,
            [0.023_672_055_427_251_73, 0.228_637_413_394_919_2, 0.428_695_150_115_473_4],
        ),
        (
            0.648,
            139_159.022_947_351,
            [0.036_136_590_175_496_68, 0.195_935_904_309_870_2, 0.450_875_234_349_417_2],
        ),
    ];
    for (part, impulse, velocities) in cases {
        let mut nodes = vec![free(3e5, 0.5)];
        nodes.extend(building(1, &[(2.5e5, 0.0, 0.0), (2e5, 0.0, 0.0)]));
        let pairs = vec![meeting(0, between(Some(1), 2, part), 0.0, law)];
        let impacts = watch(&Row::new(nodes, pairs).unwrap(), 0.001).impacts;
        near(impacts[0].impulse, impulse);
        for struck in impacts[0].struck() {
            near(struck.velocities[1], velocities[struck.floor]);
        }
    }
}

#[test]
fn reference_a_slab_presses_a_column() {
    let law = ContactLaw::LinearSpring(LinearSpring {
        impact_stiffness: 67_045_698.347_993_99,
    });
    let slab = Node::structure(3e5, 0.0, Elastic { stiffness: 2e7 });
    let mut nodes = vec![moving(slab, 0.5)];
    let mut floors = building(1, &[(2.5e5, 1.2e8, 0.0), (2e5, 9e7, 0.0)]);
    floors[1] = Node::structure(2e5, 0.0, Elastic { stiffness: 9e7 }).on_floor(pounding_solver::Floor {
        below: 1,
        ground_damping: 0.0,
    });
    nodes.extend(floors);
    let pairs = vec![meeting(0, between(Some(1), 2, 0.648), 0.0, law)];
    let seen = watch(&Row::new(nodes, pairs).unwrap(), 0.16);
    let parting = seen.pushes.last().unwrap().1[1];
    near(parting, 0.154_679_328_180_761_6);
    let forces = seen.pushes.iter().map(|push| push.2[1]);
    let peak = forces.fold(0.0, f64::max);
    near(peak, 1_568_605.779_959_222);
    let wanted = [
        [0.022_317_527_690_277_47, -0.239_565_052_716_423_8],
        [0.014_431_865_961_790_43, 0.122_635_516_920_282_3],
        [0.026_601_097_024_270_43, 0.169_406_317_370_665_5],
    ];
    for (node, wanted) in wanted.iter().enumerate() {
        let mut ends = seen.ends.iter();
        let end = ends.find(|end| end.0 == node && (end.1 - parting).abs() < 1e-15);
        let (_, _, found) = end.unwrap();
        near(found[0], wanted[0]);
        near(found[1], wanted[1]);
    }
}

/// The row with other pairs.
fn with(row: &Row<Elastic>, pairs: Vec<Pair>) -> Row<Elastic> {
    Row::new(row.nodes().to_vec(), pairs).expect("the row is valid")
}

fn far(a: &Row<Elastic>, b: &Row<Elastic>, nodes: impl Iterator<Item = (usize, usize)>) -> f64 {
    let samples = ground();
    let run = clock(0.01, 4.0);
    let [a, b] = [a, b].map(|row| histories(row, EXACT, (run, &samples)).0);
    distance(&a, &b, nodes)
}

#[test]
fn limit_relations_balance_momentum_and_energy() {
    let samples = ground();
    for law in LAWS {
        let row = floors_and_columns(law);
        let ledger = book(&row, EXACT, &samples, clock(0.01, 6.0));
        assert!(ledger.identity() < 1e-12, "{law:?}: {:e}", ledger.identity());
        assert!(ledger.momentum() < 1e-12, "{law:?}: {:e}", ledger.momentum());
        assert!(ledger.residual() < 1e-12, "{law:?}: {:e}", ledger.residual());
        ledger.verdict().unwrap();
        for pair in 0..row.pairs().len() {
            let terms = ledger.of_pair(pair);
            assert!(terms.impulse > 0.0, "{law:?}: {pair} {terms:?}");
            assert!(terms.imbalance.abs() < 1e-9 * terms.impulse, "{law:?} {terms:?}");
        }
    }
}

#[test]
fn limit_relations_in_another_order() {
    for law in LAWS {
        let row = floors_and_columns(law);
        let mut pairs = row.pairs().to_vec();
        pairs.rotate_left(2);
        pairs.swap(0, 1);
        let off = far(&row, &with(&row, pairs), same(6));
        assert!(off < 1e-13, "{law:?}: {off:e}");
    }
}

/// Node in the mirrored row of a floor of two buildings of three storeys.
fn opposite(node: usize) -> usize {
    (node + 3) % 6
}

/// The mirrored row: left and right building are swapped.
fn mirror(row: &Row<Elastic>) -> Row<Elastic> {
    let turned = |node: usize| {
        let mut floor = row.nodes()[opposite(node)];
        if let Support::Floor(on) = &mut floor.support {
            on.below = opposite(on.below);
        }
        floor
    };
    let point = |point: Point| match point {
        Point::Floor(floor) => Point::Floor(opposite(floor)),
        Point::Ground(floor) => Point::Ground(opposite(floor)),
        Point::Share(Share { base, other, lean }) => Point::Share(Share {
            base: base.map(opposite),
            other: other.map(opposite),
            lean,
        }),
    };
    let pair = |pair: &Pair| {
        let Relation { left, right, offset } = pair.relation;
        meeting(point(right), point(left), offset, pair.law)
    };
    let pairs = row.pairs().iter().map(pair).collect();
    Row::new((0..6).map(turned).collect(), pairs).expect("the row is valid")
}

#[test]
fn limit_a_mirrored_row_moves_mirrored() {
    let samples = ground();
    let mirrored: Vec<_> = samples.iter().map(|sample| -sample).collect();
    for law in LAWS {
        let row = floors_and_columns(law);
        let other = mirror(&row);
        let run = clock(0.01, 4.0);
        let (a, _) = histories(&row, EXACT, (run, &samples));
        let (b, _) = histories(&other, EXACT, (run, &mirrored));
        for node in 0..6 {
            let (own, others) = (&a.of(node).states, &b.of(opposite(node)).states);
            for (a, b) in own.iter().zip(others) {
                let off = (a.displacement + b.displacement).abs();
                assert!(off < 1e-14, "{law:?}: {node} {off:e}");
            }
        }
    }
}

#[test]
fn limit_a_point_that_hardly_leans_is_a_floor() {
    for law in LAWS {
        let row = floors_and_columns(law);
        let leaning = |lean: f64| {
            let share = Share {
                base: Some(4),
                other: Some(5),
                lean,
            };
            let level = lean == 0.0;
            let right = if level { Point::Floor(4) } else { Point::Share(share) };
            let pairs = vec![meeting(1, right, 0.004, law), meeting(2, 5, 0.006, law)];
            with(&row, pairs)
        };
        let off = far(&leaning(0.0), &leaning(1e-15), same(6));
        assert!(off < 1e-12, "{law:?}: {off:e}");
    }
}

#[test]
fn limit_a_relation_that_never_touches_changes_nothing() {
    for law in LAWS {
        let row = floors_and_columns(law);
        let mut pairs = vec![meeting(0, 3, 0.002, law), meeting(1, 4, 0.004, law), meeting(2, 5, 0.006, law)];
        // In the order of a chain: successive nodes.
        let order = [0, 3, 1, 4, 2, 5];
        let chain: Vec<_> = interleaved(&row);
        for pair in &mut pairs {
            let place = |point: Point| order.iter().position(|node| *node == point.floor());
            let [left, right] = pair.relation.points().map(|point| place(point).unwrap());
            *pair = meeting(left, right, pair.relation.offset, law);
        }
        let chained = Row::new(chain.clone(), pairs.clone()).unwrap();
        assert!(chained.is_chain());
        pairs.push(meeting(0, between(Some(1), 3, 0.4), 10.0, law));
        let row = Row::new(chain, pairs).unwrap();
        assert!(!row.is_chain());
        let off = far(&chained, &row, same(6));
        assert!(off < 1e-12, "{law:?}: {off:e}");
    }
}

/// The floors of both buildings in turn.
fn interleaved(row: &Row<Elastic>) -> Vec<Node<Elastic>> {
    let order = [0, 3, 1, 4, 2, 5];
    let node = |(place, node): (usize, &usize)| {
        let mut node = row.nodes()[*node];
        if let Support::Floor(floor) = &mut node.support {
            floor.below = place - 2;
        }
        node
    };
    order.iter().enumerate().map(node).collect()
}

#[test]
fn limit_two_halves_of_a_contact_are_the_whole() {
    let law = |impact_stiffness| ContactLaw::LinearSpring(LinearSpring { impact_stiffness });
    let hertz = |impact_stiffness| ContactLaw::Hertz(pounding_contact::Hertz { impact_stiffness });
    let laws: [[ContactLaw; 2]; 3] = [[law(3e8), law(1.5e8)], [hertz(3e9), hertz(1.5e9)], [JUMPS, JUMPS]];
    for [whole, half] in laws {
        let row = floors_and_columns(whole);
        let point = between(Some(3), 4, 0.65);
        let one = with(&row, vec![meeting(1, point, 0.004, whole)]);
        let two = with(&row, vec![meeting(1, point, 0.004, half); 2]);
        let off = far(&one, &two, same(6));
        assert!(off < 1e-12, "{whole:?}: {off:e}");
    }
}

fn check_order(name: &str, method: Integrator, law: ContactLaw) {
    let samples = ground();
    let row = floors_and_columns(law);
    let duration = 1.5;
    let exact = histories(&row, EXACT, (clock(0.01, duration), &samples)).0;
    let steps = [1e-4, 5e-5, 2.5e-5];
    let errors = steps.map(|step| {
        let run: Clock = clock(step, duration);
        let found = histories(&row, method, (run, &samples)).0;
        distance(&exact, &found, same(6))
    });
    let found = slope(&steps, &errors);
    assert!(errors[2] < 1e-4, "{name}, {law:?}: {found} {errors:?}");
    assert!(found > 0.8, "{name}, {law:?}: {found} {errors:?}");
}

#[test]
fn order_steps_converge_to_relations() {
    for law in [SPRING, HERTZ] {
        check_order("central", CENTRAL, law);
        check_order("Newmark", AVERAGE, law);
    }
}

#[test]
fn limit_slabs_that_rest_against_columns() {
    // Without restitution every contact ends in rest.
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 });
    let samples: Vec<_> = ground().iter().map(|sample| 3.0 * sample).collect();
    let row = floors_and_columns(law);
    let excitation = Excitation::new(0.01, &samples).unwrap();
    let mut ledger = Ledger::new(&row, excitation);
    let work = EXACT.watch(&row, excitation, clock(0.01, 5.0), &mut ledger).unwrap();
    assert!(ledger.residual() < 1e-12, "{:e} {work:?}", ledger.residual());
    ledger.verdict().unwrap();
}

/// A slab and a building, released 1 cm to the left, touching: c₀ = 4 − 0.65 · 5 m/s², W = 1/m + (0.65² + 0.35²)/M.
#[test]
fn reference_a_slab_at_rest_against_a_column() {
    let aside = |node: Node<Elastic>| Node {
        initial_displacement: -0.01,
        ..node
    };
    let slab = Node::structure(1e5, 0.0, Elastic { stiffness: 4e7 });
    let mut nodes = vec![slab];
    nodes.extend(building(1, &[(2e5, 1e8, 0.0), (2e5, 1e8, 0.0)]));
    let nodes: Vec<_> = nodes.into_iter().map(aside).collect();
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.3 });
    let pair = meeting(0, between(Some(1), 2, 0.35), 0.0, law);
    let wanted = 0.75 / (1.0 / 1e5 + (0.65 * 0.65 + 0.35 * 0.35) / 2e5);
    for count in [1, 2, 3] {
        // Several pairs with the same points share the force of a single pair.
        let row = Row::new(nodes.clone(), vec![pair; count]).unwrap();
        let seen = watch(&row, 0.002);
        let mut starts = 0;
        for (_, _, [force, _]) in seen.pushes.iter().filter(|push| push.1[0] <= 0.0) {
            near(*force, wanted / count as f64);
            starts += 1;
        }
        // The slab and both floors carry each pair.
        assert_eq!(starts, 3 * count);
        assert!(seen.impacts.is_empty(), "{:?}", seen.impacts);
    }
}

/// All were refused as pairs of nodes that cannot meet, one of them with a node of twenty digits.
#[test]
fn issue_points_are_refused_by_what_is_wrong_with_them() {
    let row = floors_and_columns(JUMPS);
    let share = |base, other, lean| Point::Share(Share { base, other, lean });
    let refused = |left: Point, right: Point| {
        let pairs = vec![Pair::new(left, right, 0.01, JUMPS)];
        let refused = Row::new(row.nodes().to_vec(), pairs);
        refused.expect_err("the point must be refused").to_string()
    };
    let rights = [
        share(Some(3), Some(4), 0.7),
        share(Some(3), Some(9), 0.35),
        share(None, None, 0.35),
        share(Some(3), Some(0), 0.35),
        share(None, Some(4), 0.35),
    ];
    let mut messages: Vec<_> = rights.map(|right| refused(0.into(), right)).into();
    messages.push(refused(3.into(), 5.into()));
    insta::assert_snapshot!(messages.join("\n"), @"
    pairs[0].right: found a lean of 0.7, allowed more than 0 and at most 0.5: take the nearer floor as base, or use Point::between
    pairs[0].right: found node 9, allowed are those below 6
    pairs[0].right: found no floor, allowed are a floor, and a point between a floor and what it stands on
    pairs[0].right: found a point between node 0 and node 3, allowed is one between a floor and what it stands on
    pairs[0].right: found a point between the ground and node 4, allowed is one between a floor and what it stands on
    pairs[0]: found points at nodes 3 and 5 of one building; allowed are two buildings, or a building and a wall
    ");
    for part in [1.35, -0.1, f64::NAN] {
        assert_eq!(Point::between(Some(3), 4, part), None);
    }
}
