//! Groups of scenes from the first step to the last.

use fearless_simd::Simd;

use super::column::SideBySideColumn;
use super::excitations::Grounds;
use super::frame::{Frame, Single};
use super::group::Group;
use super::number::Lanes;
use super::rows::Rows;
use super::storeys::Storeys;
use super::{BETWEEN, SceneSums, Shaken};
use pounding_solver::Row;

/// Rows of a common shape with the number of steps of each, and the receiver of their results.
pub(super) struct Task<'a, Column> {
    pub(super) rows: &'a [&'a Row<Column>],
    pub(super) n_steps: &'a [usize],
    pub(super) grounds: Grounds<'a>,
    pub(super) tallies: &'a mut SceneSums,
}

/// Runs rows of a common shape, each for its number of steps, and reports their results.
#[inline(always)]
pub(super) fn run<S: Simd, Column: SideBySideColumn>(simd: S, method: &Shaken, task: Task<'_, Column>) {
    let first = task.rows[0];
    if (0..first.nodes().len()).all(|node| first.stands_alone(node)) {
        run_in::<S, Column, Single>(simd, method, task);
    } else {
        run_in::<S, Column, Storeys<S>>(simd, method, task);
    }
}

/// Runs rows whose structures advance by a frame.
#[inline(always)]
fn run_in<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>>(simd: S, method: &Shaken, mut task: Task<'_, Column>) {
    let mut group: Option<Group<S, Column, F>> = None;
    let chunks = task.rows.chunks(Lanes::<S>::N);
    for (chunk, rows) in chunks.enumerate() {
        let first = chunk * Lanes::<S>::N;
        let rows = Rows { rows, first };
        let group = match &mut group {
            None => group.insert(Group::new(simd, method, rows)),
            Some(group) => {
                group.renew(rows);
                group
            }
        };
        steps(method, group, rows, &mut task);
    }
}

/// Makes all steps of a group and reports each scene at its end.
#[inline(always)]
fn steps<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>>(
    method: &Shaken,
    group: &mut Group<S, Column, F>,
    rows: Rows<'_, Column>,
    task: &mut Task<'_, Column>,
) {
    let n_steps = &task.n_steps[rows.first..rows.first + rows.rows.len()];
    let between = BETWEEN.div_ceil(rows.lane(0).nodes().len().max(1));
    task.grounds.sample::<S, _>(rows, 0..=0);
    group.begin(task.grounds.at(group.simd, 0));
    let mut step = 0;
    while let Some(end) = n_steps.iter().filter(|end| **end >= step).min() {
        if method.budget.is_stopped() {
            return;
        }
        let last = (*end).min(step + between);
        task.grounds.sample::<S, _>(rows, step..=last);
        while step <= last {
            group.step(task.grounds.at(group.simd, step));
            step += 1;
        }
        let ended = n_steps.iter().enumerate();
        for (lane, _) in ended.filter(|of| *of.1 < step && of.1 == end) {
            group.tell(lane, rows.first + lane, task.tallies);
        }
    }
    task.tallies.steps += step as u64;
    task.tallies.touching_steps += group.touching_steps;
}
