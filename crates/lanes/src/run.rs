//! Groups of scenes from the first step to the last, two in step where rows are short.
//!
//! Two groups instead of one of twice the lanes: a group in which no lane touches makes the plain step.

use fearless_simd::Simd;

use super::at_hand::{self, SHORT};
use super::column::SideBySideColumn;
use super::frame::{Frame, Single};
use super::group::Group;
use super::number::Lanes;
use super::rows::Rows;
use super::storeys::Storeys;
use super::{BETWEEN, Grounds, SceneSums, Shaken};
use pounding_solver::Row;

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
    (simd, method): (S, &Shaken),
    grounds: impl Grounds,
    (rows, n_steps): (&[&Row<Column>], &[usize]),
    tallies: &mut SceneSums,
) {
    let method = (simd, method);
    if (0..rows[0].nodes().len()).all(|node| rows[0].stands_alone(node)) {
        run_in::<S, Column, Single>(method, grounds, (rows, n_steps), tallies);
    } else {
        run_in::<S, Column, Storeys<S>>(method, grounds, (rows, n_steps), tallies);
    }
}

/// The same, and their structures go on as the frame says.
#[inline(always)]
fn run_in<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>>(
    (simd, method): (S, &Shaken),
    mut grounds: impl Grounds,
    (rows, n_steps): (&[&Row<Column>], &[usize]),
    tallies: &mut SceneSums,
) {
    let is_short = F::STANDS_ALONE && rows[0].nodes().len() <= SHORT;
    let n_groups = if is_short { 2 } else { 1 };
    let in_step = n_groups * Lanes::<S>::N;
    let mut groups = Vec::with_capacity(n_groups);
    let chunks = rows.chunks(in_step).zip(n_steps.chunks(in_step));
    for (chunk, (rows, n_steps)) in chunks.enumerate() {
        let first = chunk * in_step;
        let rows = Rows { rows, first };
        for (index, part) in rows.split::<S>().iter().take(n_groups).enumerate() {
            match groups.get_mut(index) {
                None => groups.push(Group::<S, Column, F>::new(simd, method, *part)),
                Some(group) => group.renew(*part),
            }
        }
        let task = Task {
            rows,
            n_steps,
            grounds: &mut grounds,
            tallies,
        };
        steps(method, &mut groups, task);
    }
}

/// All steps of some groups; what happened in a scene is told at its end.
#[inline(always)]
fn steps<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>, G: Grounds>(
    method: &Shaken,
    groups: &mut [Group<S, Column, F>],
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
            if F::STANDS_ALONE {
                step += at_hand::go_on::<S, Column, F, G>(groups, &nodes[step - first..]);
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
            group.tell(lane % Lanes::<S>::N, rows.first + lane, tallies);
        }
    }
    let with_scenes = n_steps.len().div_ceil(Lanes::<S>::N);
    for group in &groups[..with_scenes] {
        tallies.steps += step as u64;
        tallies.touching_steps += group.touching_steps;
    }
}
