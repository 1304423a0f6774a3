//! Groups of scenes, two in step where rows are short: what one computes does not wait for the other, as it waits for its own step
//! before.
//!
//! Two groups instead of one of twice the lanes: a group in which no lane touches makes the plain step.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::body::Passed;
use super::closings::Closings;
use super::column::SideBySideColumn;
use super::frame::{Frame, Single};
use super::group::Group;
use super::jump::{Jumps, rounds};
use super::number::Lanes;
use super::rows::Rows;
use super::scenes::{Moving, Pair, Structure};
use super::storeys::Storeys;
use super::{BETWEEN, Grounds, SceneSums, Shaken};
use crate::{CentralDifference, Row};

/// Structures of the longest rows that go in step two groups at once, with their motions at hand while nothing touches. Structures of
/// longer rows do not wait for each other, and a second group doubles the memory in use.
const SHORT: usize = 3;

/// Rows of one shape with the number of steps of each, and where what happened in them is told.
struct Task<'a, G, Column> {
    rows: Rows<'a, Column>,
    n_steps: &'a [usize],
    grounds: &'a mut G,
    tallies: &'a mut SceneSums,
}

/// Runs rows of one shape, each for its number of steps, and tells what happened in them.
#[inline(always)]
pub(super) fn run<S: Simd, Column: SideBySideColumn>(
    (simd, method): (S, &Shaken<CentralDifference>),
    mut grounds: impl Grounds,
    (rows, n_steps): (&[&Row<Column>], &[usize]),
    tallies: &mut SceneSums,
) {
    let row = rows[0];
    let stand_alone = (0..row.nodes().len()).all(|node| row.stands_alone(node));
    let n_groups = if stand_alone && row.nodes().len() <= SHORT {
        2
    } else {
        1
    };
    let in_step = n_groups * Lanes::<S>::N;
    let groups = rows.chunks(in_step).zip(n_steps.chunks(in_step));
    for (index, (rows, n_steps)) in groups.enumerate() {
        let first = index * in_step;
        let task = Task {
            rows: Rows { rows, first },
            n_steps,
            grounds: &mut grounds,
            tallies,
        };
        run_in_step(simd, n_groups, method, task);
    }
}

/// Runs as many rows as the groups have lanes, or fewer, and tells what happened in them.
#[inline(always)]
fn run_in_step<S: Simd, Column: SideBySideColumn, G: Grounds>(
    simd: S,
    n_groups: usize,
    method: &Shaken<CentralDifference>,
    task: Task<'_, G, Column>,
) {
    let parts = task.rows.split::<S>();
    let dt = method.time_step;
    if let Some(storeys) = Storeys::of(simd, parts[0], dt) {
        let (mut structures, mut pairs) = gathered(simd, parts[0], dt, storeys.nodes());
        let mut rounds = rounds::<S, Column>(&storeys, &structures, &pairs);
        let mut closings = closings::<S, Column>((simd, method), &storeys, &pairs);
        let scenes = (&mut structures[..], &mut pairs[..]);
        let lent = (Jumps::Longer(&mut rounds), closings.as_mut());
        let mut groups = [Group::new(simd, method, scenes, storeys, lent)];
        steps(method, &mut groups, task);
    } else if parts[0].lane(0).nodes().len() == 2 {
        let (mut a, mut b) = (parts[0].two(simd, dt), parts[1].two(simd, dt));
        let (mut c, mut d) = (
            [parts[0].pair(simd, 0), None],
            [parts[1].pair(simd, 0), None],
        );
        let mut closings =
            [&c, &d].map(|pairs| closings::<S, Column>((simd, method), &Single, &pairs[..]));
        let [one, other] = closings.each_mut().map(Option::as_mut);
        let scenes = [
            ((&mut a[..], &mut c[..]), one),
            ((&mut b[..], &mut d[..]), other),
        ];
        let mut groups = scenes.map(|(scenes, closings)| {
            Group::new(
                simd,
                method,
                scenes,
                Single,
                (Jumps::TwoStructures, closings),
            )
        });
        steps(method, &mut groups, task);
    } else {
        let nodes: Vec<_> = (0..parts[0].lane(0).nodes().len()).collect();
        let scenes = parts[..n_groups].iter().map(|rows| {
            let (structures, pairs) = gathered(simd, *rows, dt, &nodes);
            let rounds = rounds::<S, Column>(&Single, &structures, &pairs);
            let closings = closings::<S, Column>((simd, method), &Single, &pairs);
            (structures, pairs, rounds, closings)
        });
        let mut scenes: Vec<_> = scenes.collect();
        let groups = scenes
            .iter_mut()
            .map(|(structures, pairs, rounds, closings)| {
                let scenes = (&mut structures[..], &mut pairs[..]);
                let lent = (Jumps::Longer(rounds), closings.as_mut());
                Group::new(simd, method, scenes, Single, lent)
            });
        steps(method, &mut groups.collect::<Vec<_>>(), task);
    }
}

/// What follows the neighbours of some scenes, where that is asked for.
fn closings<S: Simd, Column: SideBySideColumn>(
    (simd, method): (S, &Shaken<CentralDifference>),
    frame: &impl Frame<S, Column>,
    pairs: &[Option<Pair<S>>],
) -> Option<Closings<S>> {
    let of = || Closings::new((simd, method.time_step), pairs, |node| frame.place(node));
    method.closings.then(of)
}

/// The structures of some rows, in an order of their nodes, and the pairs.
type Gathered<S, Column> = (Vec<Structure<S, Column>>, Vec<Option<Pair<S>>>);

#[inline(always)]
fn gathered<S: Simd, Column: SideBySideColumn>(
    simd: S,
    rows: Rows<'_, Column>,
    time_step: f64,
    in_order: &[usize],
) -> Gathered<S, Column> {
    let structure = |node: &usize| rows.structure(simd, *node, time_step);
    let pairs = (0..in_order.len()).map(|left| rows.pair(simd, left));
    (in_order.iter().map(structure).collect(), pairs.collect())
}

/// All steps of some groups; what happened in a scene is told at its end.
#[inline(always)]
fn steps<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>, G: Grounds>(
    method: &Shaken<CentralDifference>,
    groups: &mut [Group<'_, S, Column, F>],
    Task {
        rows,
        n_steps,
        grounds,
        tallies,
    }: Task<'_, G, Column>,
) {
    let (simd, parts) = (groups[0].simd, rows.split::<S>());
    let between = BETWEEN.div_ceil(rows.lane(0).nodes().len().max(1));
    let at_start = G::at(simd, &grounds.nodes::<S, _>(&parts, 0..=0)[0]);
    for (group, ground) in groups.iter_mut().zip(at_start) {
        group.begin(ground);
    }
    let mut step = 0;
    while let Some(end) = n_steps.iter().filter(|end| **end >= step).min() {
        if method.budget.is_stopped() {
            return;
        }
        let (first, last) = (step, (*end).min(step + between));
        let nodes = grounds.nodes::<S, _>(&parts, first..=last);
        while step <= last {
            if F::STANDS_ALONE
                && let [one, other] = groups
                && one.is_plain()
                && other.is_plain()
            {
                let groups = [one, other];
                step += match groups[0].structures.len() {
                    2 => go_apart::<S, Column, F, G, 2>(groups, &nodes[step - first..]),
                    SHORT => go_apart::<S, Column, F, G, SHORT>(groups, &nodes[step - first..]),
                    _ => 0,
                };
            }
            if let Some(node) = nodes.get(step - first) {
                let grounds = G::at(simd, node);
                for (index, group) in groups.iter_mut().enumerate() {
                    group.step(grounds[index]);
                }
                step += 1;
            }
        }
        for (lane, _) in n_steps
            .iter()
            .enumerate()
            .filter(|of| *of.1 < step && of.1 == end)
        {
            let group = &groups[lane / Lanes::<S>::N];
            let (lane, scene) = (lane % Lanes::<S>::N, rows.first + lane);
            for node in 0..group.structures.len() {
                tallies.take_floor(scene, node, group.peaks(node, lane));
            }
            for pair in group.pairs.iter().flatten() {
                tallies.take_pair(scene, pair.index, group.sums(pair, lane));
                if pair.tally.books.is_doubtful(lane) {
                    tallies.doubt(scene);
                }
            }
        }
    }
    let with_scenes = n_steps.len().div_ceil(Lanes::<S>::N);
    for group in &groups[..with_scenes] {
        tallies.steps += step as u64;
        tallies.touching_steps += group.touching_steps;
    }
}

/// Goes on over nodes with the motions of so many structures at hand, while no lane touches; two structures also over their impacts.
/// How many it passed.
#[inline(always)]
#[expect(
    clippy::needless_range_loop,
    reason = "iterators over the motions of both groups would keep them in memory"
)]
fn go_apart<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>, G: Grounds, const N: usize>(
    [one, other]: [&mut Group<'_, S, Column, F>; 2],
    nodes: &[G::Node],
) -> usize {
    let simd = one.simd;
    let zero = Lanes::splat(simd, 0.0);
    let motion = |group: &Group<'_, S, Column, F>, index: usize| group.structures[index].motion;
    let mut motions: [[_; N]; 2] = [
        std::array::from_fn(|index| motion(one, index)),
        std::array::from_fn(|index| motion(other, index)),
    ];
    let may_strike = N == 2 && one.has_impacts() && other.has_impacts();
    let mut passed = 0;
    for node in nodes {
        let mut touching = [zero.exceeds(zero); 2];
        for left in 1..N {
            for (group, pair) in [&one.pairs[left - 1], &other.pairs[left - 1]]
                .into_iter()
                .enumerate()
            {
                if let Some(pair) = pair {
                    let motions = &motions[group];
                    let ahead = motions[left - 1].displacement - motions[left].displacement;
                    touching[group] = touching[group] | (ahead - pair.gap).reaches(zero);
                }
            }
        }
        let grounds = G::at(simd, node);
        if Lanes::any(touching[0] | touching[1]) {
            if !may_strike {
                break;
            }
            let left = step_at_hand([one, other], &mut motions, grounds);
            one.strike_at_hand(touching[0], &left[0], &mut motions[0], grounds[0]);
            other.strike_at_hand(touching[1], &left[1], &mut motions[1], grounds[1]);
        } else {
            step_at_hand([one, other], &mut motions, grounds);
        }
        passed += 1;
    }
    for index in 0..N {
        one.structures[index].motion = motions[0][index];
        other.structures[index].motion = motions[1][index];
    }
    passed
}

/// The step of two groups with their motions at hand from a node without pounding forces, and what it leaves behind.
#[inline(always)]
fn step_at_hand<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>, const N: usize>(
    [one, other]: [&Group<'_, S, Column, F>; 2],
    motions: &mut [[Moving<S, Column>; N]; 2],
    [ground, its]: [Lanes<S>; 2],
) -> [[Passed<S>; N]; 2] {
    let zero = ground.like(0.0);
    let mut left = [[Passed {
        displacement: zero,
        restoring_force: zero,
    }; N]; 2];
    for index in 0..N {
        let constants = [
            &one.structures[index].constants,
            &other.structures[index].constants,
        ];
        left[0][index] = constants[0].step(&mut motions[0][index], zero, ground);
        left[1][index] = constants[1].step(&mut motions[1][index], zero, its);
    }
    left
}
