//! Ground motions that travel along a row: known answers, and cases in which they must change nothing.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Collision, Collisions, Elastic, Exact, Excitation, Histories, Hysteretic, Impact, Integrator, ModelError, Node, Recorder, Row, Span,
    State,
};

use crate::common::{
    METHODS, MOREAU_JEAN, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, elastic, ground, histories, pairs, yielding,
};
use crate::storeys_ledger::{DAMPING, TOWERS};
use crate::towers::{Tower, row};
use crate::watch::Watch;

pub(crate) const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: pounding_solver::SimultaneousImpacts::Together,
});

/// All methods, including the exact one.
pub(crate) fn all() -> impl Iterator<Item = (&'static str, Integrator)> {
    METHODS.into_iter().chain([("exact", EXACT)])
}

/// Three towers that touch by a law, and the building of every node.
pub(crate) fn towers(law: ContactLaw) -> (Row<Elastic>, Vec<usize>) {
    let build = |storeys: &&[(f64, f64, f64)]| -> Tower<Elastic> {
        let floor = |(mass, stiffness, _): &(f64, f64, f64)| {
            let column = Elastic { stiffness: *stiffness };
            (*mass, column)
        };
        storeys.iter().map(floor).collect()
    };
    let buildings: Vec<_> = TOWERS.iter().map(build).collect();
    let (row, levels) = row(&buildings, DAMPING, |_, _, [left, right]| {
        let gap = 0.01;
        Some(pounding_solver::Pair::of_floors(left, right, gap, law))
    });
    let of = (0..levels.n_nodes()).map(|node| levels.place(node).0);
    (row, of.collect())
}

fn bits(histories: &Histories, nodes: &[usize]) -> Vec<Vec<State>> {
    let states = |node: &usize| histories.of(*node).states.clone();
    nodes.iter().map(states).collect()
}

#[test]
fn limit_arrivals_at_once_are_the_row_without_any() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("it is valid");
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let lean = Row::new(vec![yielding(WEAK), yielding(STIFF)], pairs(2, 0.02, law)).expect("it is valid");
        let rich = lean.clone().delayed(vec![0.0; 2]).expect("it is valid");
        assert_eq!(lean, rich);
        assert!(rich.travel(excitation).is_none());
        assert!(lean.delayed(vec![0.0, 0.1]).expect("it is valid").travel(excitation).is_some());
    }
}

#[test]
fn limit_a_building_out_of_reach_that_is_shaken_later_changes_nothing() {
    // The ground motion travels along the row. A structure that is shaken at t = 0 must not change, and neither must a structure that is
    // shaken later.
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let mut near_and_far = pairs(3, 0.02, law);
        near_and_far[1].relation.offset = 10.0;
        let nodes = vec![yielding(WEAK), yielding(STIFF), yielding(WEAK)];
        let three = Row::new(nodes, near_and_far).expect("it is valid");
        let three = three.delayed(vec![0.0, 0.0, 0.377]).expect("it is valid");
        let two = Row::new(vec![yielding(WEAK), yielding(STIFF)], pairs(2, 0.02, law)).expect("it is valid");
        let one = Row::new(vec![yielding(WEAK)], vec![]).expect("it is valid");
        let one = one.delayed(vec![0.377]).expect("it is valid");
        for (name, method) in all() {
            let run = |row| histories(row, method, &ground(), clock(0.005, 5.0));
            let ((all, _), (pair, work), (alone, _)) = (run(&three), run(&two), run(&one));
            let apart = work.touching_steps == 0 && work.segments == 0;
            assert!(!apart, "{name}: the pair must collide");
            assert_eq!(bits(&all, &[0, 1]), bits(&pair, &[0, 1]), "{name}");
            assert_eq!(all.of(2), alone.of(0), "{name}");
        }
    }
}

#[test]
fn limit_towers_beside_one_that_is_shaken_later_keep_their_bits() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let (row, of) = towers(law);
        let mut far = row.pairs().to_vec();
        for pair in far.iter_mut().filter(|pair| of[pair.right()] == 2) {
            pair.relation.offset = 10.0;
        }
        let far = Row::new(row.nodes().to_vec(), far).expect("it is valid");
        let arrivals = of.iter().map(|of| if *of == 2 { 0.123 } else { 0.0 });
        let late = far.clone().delayed(arrivals.collect()).expect("it is valid");
        let near: Vec<_> = (0..of.len()).filter(|node| of[*node] < 2).collect();
        for (name, method) in all() {
            let [at_once, late] = [&far, &late].map(|row| histories(row, method, &ground(), clock(0.002, 3.0)).0);
            assert_eq!(bits(&at_once, &near), bits(&late, &near), "{name}");
        }
    }
}

#[test]
fn reference_one_delay_for_all_shifts_the_run() {
    const LATER: f64 = 0.5;
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let nodes = vec![yielding(WEAK), yielding(STIFF), yielding(WEAK)];
        let row = Row::new(nodes, pairs(3, 0.02, law)).expect("it is valid");
        let late = row.clone().delayed(vec![LATER; 3]).expect("it is valid");
        for (name, method) in all() {
            let (at_once, _) = histories(&row, method, &ground(), clock(0.005, 4.0));
            let (late, _) = histories(&late, method, &ground(), clock(0.005, 4.5));
            for node in 0..3 {
                let (early, late) = (&at_once.of(node).states, &late.of(node).states);
                let largest = early.iter().map(|state| state.displacement.abs());
                let largest = largest.fold(0.0, f64::max);
                for (index, state) in early.iter().enumerate() {
                    let apart = (state.displacement - late[index + 100].displacement).abs();
                    assert!(apart < 1e-9 * largest, "{name}, {node}, {index}: {apart:e}");
                }
            }
        }
    }
}

/// Structures so stiff (T = 0.01 s, critically damped) that they follow their grounds.
fn rigid(masses: [f64; 2], law: ContactLaw, gap: f64) -> Row<Elastic> {
    let node = |mass: f64| {
        let omega = 200.0 * std::f64::consts::PI;
        let stiffness = mass * omega * omega;
        Node::structure(mass, 2.0 * omega * mass, Elastic { stiffness })
    };
    Row::new(masses.map(node).to_vec(), pairs(2, gap, law)).expect("it is valid")
}

/// Impulses of all impacts \[N·s\].
#[derive(Default)]
struct Impulses(Vec<f64>);

impl Recorder for Impulses {
    fn span(&mut self, _: &Span<'_>) {}

    fn impact(&mut self, impact: &Impact) {
        self.0.push(impact.impulse);
    }
}

fn collisions<Column: Hysteretic>(
    row: &Row<Column>,
    method: Integrator,
    samples: &[f64],
    (time_step, duration): (f64, f64),
) -> Vec<Collision> {
    let excitation = Excitation::new(0.01, samples).expect("it is valid");
    let mut recorder = Collisions::new(row.nodes().len(), row.pairs()).travelled(row.travel(excitation));
    let clock = clock(time_step, duration);
    method.watch(row, excitation, clock, &mut recorder).expect("the run ends");
    recorder.all().to_vec()
}

#[test]
fn reference_grounds_that_move_apart_make_rigid_structures_touch() {
    // Under a_g = 1 m/s² after the arrival, u_g = (t − τ)²/2. The left ground moves first and is ahead by D = 0.1 t − 0.005, with τ = 0.1
    // s. A gap of 20 mm closes at t = 0.25 s, at 0.1 m/s. Both structures lag by a_g/ω² alike.
    let samples = [1.0; 101];
    let (masses, e) = ([2e5, 3e5], 0.5);
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: e });
    let row = rigid(masses, law, 0.02);
    let late = row.clone().delayed(vec![0.0, 0.1]).expect("it is valid");
    let found = collisions(&late, EXACT, &samples, (0.01, 0.26));
    let impulse = (1.0 + e) * (masses[0] * masses[1] / (masses[0] + masses[1])) * 0.1;
    let first = found.first().expect("they touch");
    assert!((first.start - 0.25).abs() < 1e-12, "{first:?}");
    let speed = first.approach_speed.expect("it is known");
    assert!((speed - 0.1).abs() < 1e-12, "{first:?}");
    assert!((first.impulse / impulse - 1.0).abs() < 1e-11, "{first:?}");
    for (name, method) in METHODS {
        let found = collisions(&late, method, &samples, (1e-4, 0.26));
        let first = found.first().expect("they touch");
        // Found within a step of the touch, with the approach of that instant.
        assert!((first.start - 0.25).abs() < 2e-4, "{name}: {first:?}");
        // In Moreau–Jean stepping columns and dampers act within the step, ωΔt = 6 %.
        let open = if method == MOREAU_JEAN { 0.07 } else { 1e-3 };
        assert!((first.impulse / impulse - 1.0).abs() < open, "{name}: {first:?}");
    }
    // If the motion comes from the right, they part; if both are shaken at once, they never meet.
    let away = row.clone().delayed(vec![0.1, 0.0]).expect("it is valid");
    for row in [&row, &away] {
        assert_eq!(collisions(row, EXACT, &samples, (0.01, 1.0)), []);
    }
}

#[test]
fn reference_a_wall_moves_with_its_own_ground() {
    // As above, with a wall on the right that is shaken later, then with a wall on the left, from which the ground of the structure moves
    // away.
    let samples = [1.0; 101];
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 });
    let node = rigid([2e5, 2e5], law, 0.02).nodes()[0];
    let wall = Node::wall(Elastic { stiffness: 1.0 });
    let beside = |nodes: Vec<Node<Elastic>>, arrivals: Vec<f64>| {
        let row = Row::new(nodes, pairs(2, 0.02, law)).expect("it is valid");
        row.delayed(arrivals).expect("it is valid")
    };
    let row = beside(vec![node, wall], vec![0.0, 0.1]);
    let found = collisions(&row, EXACT, &samples, (0.01, 0.9));
    let first = found.first().expect("they touch");
    // The structure lags by a_g/ω², the wall does not.
    let lag = node.column.stiffness * node.inverse_mass;
    let touch = 0.25 + 1.0 / (0.1 * lag);
    assert!((first.start - touch).abs() < 1e-12, "{first:?}");
    let excitation = Excitation::new(0.01, &samples).expect("it is valid");
    let mut impulses = Impulses::default();
    let run = EXACT.watch(&row, excitation, clock(0.01, 0.9), &mut impulses);
    run.expect("the run ends");
    let Impulses(impulses) = impulses;
    assert!((impulses[0] / (2e5 * 0.1) - 1.0).abs() < 1e-11);
    // The structure comes to rest against the wall and moves with it: relative to its own ground it moves left, like the wall.
    assert_eq!((impulses.len(), found.len()), (1, 1), "{found:?}");
    let (carried, _) = histories(&row, EXACT, &samples, clock(0.01, 0.9));
    for (index, state) in carried.of(0).states.iter().enumerate().skip(27) {
        let time = 0.01 * index as f64;
        let wanted = 0.02 - (0.1 * time - 0.005);
        assert!((state.displacement - wanted).abs() < 1e-13, "{time}: {state:?}");
        assert!((state.velocity + 0.1).abs() < 1e-12, "{time}: {state:?}");
    }
    let row = beside(vec![wall, node], vec![0.1, 0.0]);
    assert_eq!(collisions(&row, EXACT, &samples, (0.01, 1.0)), []);
}

#[test]
fn reference_the_ground_is_the_double_integral_of_the_record() {
    // a_g = t to 1 s, then back to 0 at 2 s: u_g = t³/6, then 1/6 + s/2 + s²/2 − s³/6, then 1 + (t − 2).
    let samples: Vec<f64> = (0..=20).map(|i| 0.1 * f64::from(if i <= 10 { i } else { 20 - i })).collect();
    let excitation = Excitation::new(0.1, &samples).expect("it is valid");
    let row = rigid([1e5, 1e5], STEREOMECHANICAL, 1.0);
    let travel = row
        .delayed(vec![0.0, 0.25])
        .expect("it is valid")
        .travel(excitation)
        .expect("it is valid");
    let wanted = |t: f64| {
        let (first, s) = (t.clamp(0.0, 1.0), (t - 1.0).clamp(0.0, 1.0));
        let ramps = first * first * first / 6.0 + s * (0.5 + s * (0.5 - s / 6.0));
        ramps + (t - 2.0).max(0.0)
    };
    for step in 0..300 {
        let time = 0.0101 * f64::from(step);
        for (node, arrival) in [(0, 0.0), (1, 0.25)] {
            let ground = travel.ground(node, time);
            let apart = (ground.displacement - wanted(time - arrival)).abs();
            assert!(apart < 1e-14, "{node}, {time}: {ground:?}");
        }
    }
    // After the record both grounds move at 1 m/s, a quarter of a second apart.
    let largest = travel.largest_opening([0, 1], 5.0);
    assert!((largest.distance - 0.25).abs() < 1e-14, "{largest:?}");
}

/// Grounds that have moved by 800 m each are 0.03 m apart. Rounded sums lost three digits of this distance, and the two routes differed by
/// a thousand times their rounding.
#[test]
fn issue_an_opening_keeps_its_digits_where_grounds_move_far() {
    let samples = vec![1.0; 4001];
    let excitation = Excitation::new(0.01, &samples).expect("it is valid");
    let row = rigid([1e5, 1e5], STEREOMECHANICAL, 1.0);
    let arrivals = [0.0131, 0.0127];
    let travel = row
        .delayed(arrivals.to_vec())
        .expect("it is valid")
        .travel(excitation)
        .expect("it is valid");
    for step in 1..400 {
        let time = 0.0997 * f64::from(step);
        // ½ (t − τ₁)² − ½ (t − τ₂)².
        let wanted = (arrivals[1] - arrivals[0]) * (time - 0.5 * (arrivals[0] + arrivals[1]));
        let found = travel.opening([0, 1], time).displacement;
        assert!((found / wanted - 1.0).abs() < 2e-14, "{time}: {found} {wanted}");
    }
}

#[test]
fn reference_the_largest_opening_is_none_that_a_fine_search_exceeds() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("it is valid");
    let row = rigid([1e5, 1e5], STEREOMECHANICAL, 1.0);
    for arrivals in [[0.0, 0.1], [0.0531, 0.0], [1.0, 0.3007]] {
        let travel = row
            .clone()
            .delayed(arrivals.to_vec())
            .expect("it is valid")
            .travel(excitation)
            .expect("it is valid");
        let found = travel.largest_opening([0, 1], 12.0);
        let at = |time: f64| travel.opening([0, 1], time);
        let searched = (0..=120_000).map(|step| at(1e-4 * f64::from(step)).displacement.abs());
        let searched = searched.fold(0.0, f64::max);
        assert!((at(found.time).displacement - found.distance).abs() < 1e-15, "{found:?}");
        let excess = found.distance.abs() / searched - 1.0;
        assert!((0.0..1e-6).contains(&excess), "{arrivals:?}: {excess:e}");
    }
}

#[test]
fn extreme_arrivals_that_are_none_are_refused() {
    let (row, _) = towers(STEREOMECHANICAL);
    let n = row.nodes().len();
    let few = row.clone().delayed(vec![0.1; 3]);
    assert_eq!(few, Err(ModelError::Arrivals { found: 3, n_nodes: n }));
    for bad in [-0.1, f64::NAN, f64::INFINITY] {
        let mut arrivals = vec![0.0; n];
        arrivals[1] = bad;
        let refused = row.clone().delayed(arrivals).unwrap_err().to_string();
        assert!(refused.starts_with("arrivals[1]: found"), "{refused}");
    }
    let mut torn = vec![0.0; n];
    torn[0] = 0.1;
    let refused = row.clone().delayed(torn).unwrap_err().to_string();
    assert!(refused.contains("that of the floor below"), "{refused}");
}

#[test]
fn limit_displacements_over_grounds_mirror() {
    // A mirrored row under the reversed motion, arriving in mirrored order.
    let reversed: Vec<f64> = ground().iter().map(|sample| -sample).collect();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let arrivals = vec![0.0, 0.05, 0.12];
        let nodes = vec![elastic(WEAK), elastic((120e3, 5e6, 0.0)), elastic(STIFF)];
        let mirrored: Vec<_> = nodes.iter().rev().copied().collect();
        let row = Row::new(nodes, pairs(3, 0.02, law)).expect("it is valid");
        let mirror = Row::new(mirrored, pairs(3, 0.02, law)).expect("it is valid");
        let backwards = arrivals.iter().rev().copied().collect();
        let (row, mirror) = (
            row.delayed(arrivals).expect("it is valid"),
            mirror.delayed(backwards).expect("it is valid"),
        );
        for (name, method) in all() {
            let (there, _) = histories(&row, method, &ground(), clock(0.002, 3.0));
            let (back, _) = histories(&mirror, method, &reversed, clock(0.002, 3.0));
            for node in 0..3 {
                let (one, other) = (&there.of(node).states, &back.of(2 - node).states);
                let apart = one.iter().zip(other);
                let apart = apart.map(|(one, other)| (one.displacement + other.displacement).abs());
                let apart = apart.fold(0.0, f64::max);
                assert!(apart < 1e-12, "{name}, {node}: {apart:e}");
            }
        }
    }
}

#[test]
fn extreme_grounds_stay_as_far_apart_as_they_are_long_after_the_record() {
    // The ground keeps 0.8 m/s and moves by 8 km while two of its sites stay 0.1 m apart.
    let samples = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0];
    let excitation = Excitation::new(0.1, &samples).expect("it is valid");
    let velocity = 0.8;
    let node = elastic((1.0, 1.0, 0.0));
    let pairs = pairs(2, 0.01, STEREOMECHANICAL);
    let row = Row::new(vec![node, node], pairs).expect("it is valid");
    let row = row.delayed(vec![0.0, 0.125]).expect("they are valid");
    let travel = row.travel(excitation).expect("it travels");
    for time in [2.0, 31.4, 1e3, 1e4] {
        let apart = travel.opening([0, 1], time).displacement;
        let off = apart - velocity * 0.125;
        assert!(off.abs() < 1e-16, "{time} s: {off:e}");
    }
}
