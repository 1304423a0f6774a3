//! Pairs of any points in stepping methods: several on a side of a floor, points between floors, in any order.

use pounding_contact::{ContactLaw, Hertz, LinearSpring, Stereomechanical};
use pounding_solver::{
    Elastic, Excitation, Floor, Impact, Integrator, Levels, Node, Pair, Point, Recorder, Relation, Row, RunError, Span, Storey,
};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::{METHODS, MOREAU_JEAN, VISCOELASTIC, book, clock, free, ground, histories};
use crate::random_rows::config;
use crate::watch::Watch;

fn restitution(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

fn pair([left, right]: [Point; 2], offset: f64, law: ContactLaw) -> Pair {
    Pair {
        relation: Relation { left, right, offset },
        law,
    }
}

fn between(lower: usize, upper: usize, upper_part: f64) -> Point {
    Point::between(Some(lower), upper, upper_part).expect("not the ground")
}

/// A free floor on another one.
fn above(below: usize, mass: f64, velocity: f64) -> Node<Elastic> {
    free(mass, velocity).on_floor(Floor {
        below,
        ground_damping: 0.0,
    })
}

/// The impacts of the first instant with impacts, and the velocity of every node at this instant.
struct Seen {
    impacts: Vec<Impact>,
    velocities: Vec<f64>,
}

impl Recorder for Seen {
    fn span(&mut self, span: &Span<'_>) {
        if self.impacts.is_empty() {
            self.velocities[span.structure] = span.end.velocity;
        }
    }

    fn impact(&mut self, impact: &Impact) {
        if self.impacts.iter().any(|first| first.time < impact.time) {
            return;
        }
        self.impacts.push(*impact);
        for struck in impact.struck() {
            self.velocities[struck.floor] = struck.velocities[1];
        }
    }
}

/// One step of a row, without ground motion.
fn step(row: &Row<Elastic>, method: Integrator, time_step: f64) -> Seen {
    let velocities = row.nodes().iter().map(|node| node.initial_velocity);
    let mut seen = Seen {
        impacts: Vec::new(),
        velocities: velocities.collect(),
    };
    let still = Excitation::new(1.0, &[0.0, 0.0]).expect("it is finite");
    method
        .watch(row, still, clock(time_step, time_step), &mut seen)
        .expect("a step ends");
    seen
}

fn close(found: f64, wanted: f64, tolerance: f64, place: &str) {
    let off = (found - wanted).abs();
    let allowed = tolerance * wanted.abs().max(1.0);
    assert!(off <= allowed, "{place}: {found}, wanted {wanted}");
}

#[test]
fn reference_slabs_that_share_a_floor() {
    let nodes = vec![
        free(3e5, 1.0),
        free(3e5, 0.2),
        free(2e5, 0.0),
        above(2, 2e5, 0.0),
        above(3, 2e5, 0.0),
    ];
    let law = restitution(0.65);
    let mut pairs = vec![
        pair([Point::Floor(0), between(2, 3, 0.6)], 0.0, law),
        pair([Point::Floor(1), between(3, 4, 0.3)], 0.0, law),
    ];
    for _ in 0..2 {
        let row = Row::new(nodes.clone(), pairs.clone()).expect("a valid row");
        for (name, method) in METHODS {
            let Seen { impacts, velocities: v } = step(&row, method, 1e-6);
            assert_eq!(impacts.len(), 1, "{name}: {impacts:?}");
            close(impacts[0].impulse, 278_089.887_640_449_4, 1e-13, name);
            close(v[0] - (0.4 * v[2] + 0.6 * v[3]), -0.65, 1e-14, name);
            let other = v[1] - (0.7 * v[3] + 0.3 * v[4]);
            close(other, -0.383_988_764_044_943_8, 1e-14, name);
        }
        pairs.reverse();
    }
}

#[test]
fn reference_a_slab_hits_a_column() {
    let straight = [0.023_672_055_427_251_73, 0.228_637_413_394_919_2, 0.428_695_150_115_473_4];
    let fixed = [0.036_136_590_175_496_68, 0.195_935_904_309_870_2, 0.450_875_234_349_417_2];
    for (part, impulse, velocities) in [(0.6, 142_898.383_371_824_5, straight), (0.648, 139_159.022_947_351, fixed)] {
        let nodes = vec![free(3e5, 0.5), free(2.5e5, 0.0), above(1, 2e5, 0.0)];
        let points = [Point::Floor(0), between(1, 2, part)];
        let pairs = vec![pair(points, 0.0, restitution(0.65))];
        let row = Row::new(nodes, pairs).expect("a valid row");
        for (name, method) in METHODS {
            let seen = step(&row, method, 1e-6);
            close(seen.impacts[0].impulse, impulse, 1e-13, name);
            for (found, wanted) in seen.velocities.iter().zip(velocities) {
                close(*found, wanted, 1e-14, name);
            }
        }
    }
}

/// Moving buildings that touch over their whole height.
#[derive(Debug, Clone)]
struct Case {
    /// Floors of every building from the ground up: mass \[kg\], period of the storey \[s\], velocity \[m/s\].
    buildings: Vec<Vec<[f64; 3]>>,
    /// Of each pair: its left building, the heights of its points in both buildings (0 at the ground, 1 at the top), and its coefficient of
    /// restitution.
    contacts: Vec<(usize, [f64; 2], f64)>,
    gap: f64,
}

impl Case {
    fn levels(&self) -> Levels {
        let storeys: Vec<_> = self.buildings.iter().map(Vec::len).collect();
        Levels::new(&storeys)
    }

    fn row(&self) -> Row<Elastic> {
        let levels = self.levels();
        let node = |index: usize| {
            let (building, storey) = levels.place(index);
            let [mass, period, velocity] = self.buildings[building][storey];
            let omega = 2.0 * std::f64::consts::PI / period;
            let column = Elastic {
                stiffness: mass * omega * omega,
            };
            let storey = Storey {
                mass,
                damping: 0.0,
                ground_damping: 0.0,
                column,
            };
            Node {
                initial_velocity: velocity,
                ..levels.floor(index, storey)
            }
        };
        let point = |building: usize, height: f64| {
            let floors = levels.of(building);
            let height = height * floors.len() as f64;
            let upper = (0..floors.len()).find(|storey| height <= (storey + 1) as f64);
            let upper = upper.expect("no point is above the roof");
            let below = upper.checked_sub(1).map(|lower| floors[lower]);
            Point::between(below, floors[upper], height - upper as f64)
        };
        let pair = |&(left, [low, high], e): &(usize, [f64; 2], f64)| {
            let points = [point(left, low)?, point(left + 1, high)?];
            Some(pair(points, self.gap, restitution(e)))
        };
        let nodes = (0..levels.n_nodes()).map(node).collect();
        Row::new(nodes, self.contacts.iter().filter_map(pair).collect()).expect("a valid row")
    }

    /// The mirrored case, with reversed velocities.
    fn mirrored(&self) -> Self {
        let mut mirrored = self.clone();
        mirrored.buildings.reverse();
        for [_, _, velocity] in mirrored.buildings.iter_mut().flatten() {
            *velocity = -*velocity;
        }
        let last = self.buildings.len() - 2;
        for (left, points, _) in &mut mirrored.contacts {
            *left = last - *left;
            points.reverse();
        }
        mirrored
    }

    /// Velocities of the floors, building by building.
    fn by_building(&self, velocities: &[f64]) -> Vec<Vec<f64>> {
        let levels = self.levels();
        let of = |node: &usize| velocities[*node];
        let floors = |building| levels.of(building).iter().map(of).collect();
        (0..self.buildings.len()).map(floors).collect()
    }
}

/// Two to four buildings of up to three storeys, with up to seven pairs; masses differ by up to 10⁴.
fn cases() -> impl Strategy<Value = Case> {
    let floor = (4.0..8.0_f64, 0.1..2.0_f64, -1.0..1.0_f64).prop_map(|(mass, period, velocity)| [libm::pow(10.0, mass), period, velocity]);
    let height = || prop_oneof![2 => 0.02..1.0_f64, 1 => Just(1.0), 1 => Just(0.5)];
    let e = prop_oneof![Just(0.0), 0.0..1.0_f64, Just(1.0)];
    let contact = (0..3_usize, height(), height(), e);
    let gap = prop_oneof![Just(0.0), 0.0..0.01_f64];
    (vec(vec(floor, 1..4), 2..5), vec(contact, 1..8), gap).prop_map(|(buildings, contacts, gap)| {
        let n = buildings.len() - 1;
        let contacts = contacts.into_iter().map(|(left, low, high, e)| (left % n, [low, high], e));
        Case {
            contacts: contacts.collect(),
            buildings,
            gap,
        }
    })
}

/// Difference of two runs relative to the velocities.
fn off(found: &[f64], wanted: &[f64]) -> f64 {
    let scale = wanted.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
    let each = found.iter().zip(wanted).map(|(one, other)| (one - other).abs() / scale);
    each.fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn limit_the_order_of_pairs_changes_nothing(case in cases(), by in 0..7_usize) {
        let case = Case { gap: 0.0, ..case };
        let mut turned = case.clone();
        let by = by % case.contacts.len();
        turned.contacts.rotate_left(by);
        for (name, method) in METHODS {
            let [one, other] = [&case, &turned].map(|case| step(&case.row(), method, 1e-4));
            let off = off(&one.velocities, &other.velocities);
            prop_assert!(off < 1e-13, "{name}: {off:e}");
        }
    }

    #[test]
    fn limit_mirrored_rows_move_alike(case in cases()) {
        let case = Case { gap: 0.0, ..case };
        let mirrored = case.mirrored();
        for (name, method) in METHODS {
            let one = step(&case.row(), method, 1e-4);
            let other = step(&mirrored.row(), method, 1e-4);
            let one = case.by_building(&one.velocities).concat();
            let mut other = mirrored.by_building(&other.velocities);
            other.reverse();
            let other: Vec<_> = other.concat().iter().map(|one| -one).collect();
            let off = off(&one, &other);
            prop_assert!(off < 1e-13, "{name}: {off:e}");
        }
    }

    #[test]
    fn limit_impacts_of_an_instant_create_no_energy(case in cases()) {
        let row = case.row();
        // Moreau–Jean stepping changes velocities within a step, by impulses and springs together.
        for (name, method) in METHODS.into_iter().filter(|one| one.1 != MOREAU_JEAN) {
            let mut instants = Instants::of(&row);
            let still = Excitation::new(1.0, &[0.0, 0.0]).expect("it is finite");
            method.watch(&row, still, clock(1e-3, 0.3), &mut instants).expect("it ends");
            instants.close();
            prop_assert!(instants.created < 1e-13, "{name}: creates {:e}", instants.created);
            prop_assert!(instants.approach < 1e-12, "{name}: {:e}", instants.approach);
        }
    }

    #[test]
    fn limit_the_books_of_any_row_balance(case in cases()) {
        let row = case.row();
        check_books(&row, &[0.5, -0.3, 0.2], true)?;
    }

    #[test]
    fn limit_the_books_of_all_laws_balance(case in cases(), delays in vec(0.0..0.1_f64, 4)) {
        let row = case.row();
        let mut pairs = row.pairs().to_vec();
        for pair in pairs.iter_mut().step_by(2) {
            pair.law = VISCOELASTIC;
        }
        let levels = case.levels();
        let delays = (0..levels.n_nodes()).map(|node| delays[levels.place(node).0]);
        let row = Row::new(row.nodes().to_vec(), pairs)
            .and_then(|row| row.delayed(delays.collect()))
            .expect("a valid row");
        check_books(&row, &[0.0, 0.5, -0.3, 0.2], false)?;
    }
}

/// Compares the ledgers of all methods with their reports, and checks the laws of mechanics.
fn check_books(row: &Row<Elastic>, ground: &[f64], is_held: bool) -> Result<(), TestCaseError> {
    for (name, method) in METHODS {
        let ledger = book(row, method, ground, clock(1e-3, 0.3));
        let (momentum, identity) = (ledger.momentum(), ledger.identity());
        prop_assert!(momentum < 1e-10, "{name}: momentum {momentum:e}");
        prop_assert!(identity < 1e-10, "{name}: energy {identity:e}");
        let verdict = ledger.verdict();
        prop_assert!(!is_held || verdict.is_ok(), "{name}: {verdict:?}");
    }
    Ok(())
}

/// Energy and approach after the impacts of every instant.
struct Instants {
    masses: Vec<f64>,
    time: f64,
    /// Velocities before and after of the floors hit at this instant.
    struck: Vec<Option<[f64; 2]>>,
    /// Largest energy created at an instant, relative to the energy there, and fastest approach after an impact \[m/s\].
    created: f64,
    approach: f64,
}

impl Instants {
    fn of(row: &Row<Elastic>) -> Self {
        let masses = row.nodes().iter().map(|node| 1.0 / node.inverse_mass);
        Self {
            masses: masses.collect(),
            time: 0.0,
            struck: vec![None; row.nodes().len()],
            created: 0.0,
            approach: 0.0,
        }
    }

    fn close(&mut self) {
        let mut energies = [0.0; 2];
        for (struck, mass) in self.struck.iter_mut().zip(&self.masses) {
            if let Some(velocities) = struck.take() {
                for (energy, velocity) in energies.iter_mut().zip(velocities) {
                    *energy += 0.5 * mass * velocity * velocity;
                }
            }
        }
        if energies[0] > 0.0 {
            let created = (energies[1] - energies[0]) / energies[0];
            self.created = self.created.max(created);
        }
    }
}

impl Recorder for Instants {
    fn span(&mut self, _: &Span<'_>) {}

    fn impact(&mut self, impact: &Impact) {
        if impact.time > self.time {
            self.close();
            self.time = impact.time;
        }
        for struck in impact.struck() {
            self.struck[struck.floor] = Some(struck.velocities);
        }
        let speeds = impact.before.left.abs() + impact.before.right.abs();
        let approach = impact.rates()[1] / speeds;
        self.approach = self.approach.max(approach);
    }
}

/// NaN velocities ended a run one step later, with advice about the time step.
#[test]
fn issue_walls_that_close_in_on_pairs_of_any_points_are_named() {
    let wall = || Node::wall(Elastic { stiffness: 1.0 });
    let nodes = vec![wall(), free(2e5, 0.0), above(1, 2e5, 0.0), wall()];
    let law = restitution(0.5);
    let pairs = vec![
        pair([Point::Floor(0), between(1, 2, 0.4)], 0.0, law),
        pair([between(1, 2, 0.4), Point::Floor(3)], 0.0, law),
    ];
    let row = Row::new(nodes, pairs)
        .and_then(|row| row.delayed(vec![0.0, 0.05, 0.05, 0.1]))
        .expect("a valid row");
    let ground = ground();
    let excitation = Excitation::new(0.01, &ground).expect("a finite ground motion");
    for (name, method) in METHODS {
        let ended = method.watch(&row, excitation, clock(1e-3, 10.0), &mut ());
        assert!(matches!(ended, Err(RunError::ClosedIn { .. })), "{name}: {ended:?}");
    }
}

#[test]
fn limit_two_soft_contacts_are_one_contact() {
    let column = Elastic { stiffness: 2e7 };
    let nodes = || {
        let structure = |velocity| Node {
            initial_velocity: velocity,
            ..Node::structure(1e5, 2e4, column)
        };
        let upper = Node::structure(8e4, 2e4, column);
        let upper = upper.on_floor(Floor {
            below: 1,
            ground_damping: 0.0,
        });
        vec![structure(0.4), structure(-0.2), upper]
    };
    let spring: fn(f64) -> ContactLaw = |impact_stiffness| ContactLaw::LinearSpring(LinearSpring { impact_stiffness });
    let hertz: fn(f64) -> ContactLaw = |impact_stiffness| ContactLaw::Hertz(Hertz { impact_stiffness });
    let (ground, clock) = (ground(), clock(1e-3, 3.0));
    for law in [spring, hertz] {
        for point in [Point::Floor(1), between(1, 2, 0.3)] {
            let contact = |k| pair([Point::Floor(0), point], 0.01, law(k));
            let one = Row::new(nodes(), vec![contact(4e8)]).expect("a valid row");
            let two = Row::new(nodes(), vec![contact(2e8); 2]).expect("a valid row");
            for (name, method) in METHODS {
                let of = |row: &Row<Elastic>| -> Vec<f64> {
                    let (histories, _) = histories(row, method, &ground, clock);
                    let states = (0..3).flat_map(|node| &histories.of(node).states);
                    states.map(|state| state.displacement).collect()
                };
                let off = off(&of(&one), &of(&two));
                assert!(off < 1e-10, "{name}, {point:?}: {off:e}");
            }
        }
    }
}
