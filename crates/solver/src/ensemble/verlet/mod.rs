//! The velocity Verlet method side by side: two structures, or one and a wall, with impacts after a step or located within it.
//!
//! An instant of impact is that of a lane: where some lane has one, all go there by spans of their own lengths, those without one
//! by a span of length 0.
//!
//! Rows of three and more structures run alone: side by side they would need the order of the impacts in every lane.

mod body;
mod group;

use std::ops::Range;

use fearless_simd::Simd;
use pounding_contact::Number;

use self::group::Group;
use super::column::SideBySideColumn;
use super::number::Lanes;
use super::rows::Rows;
use super::{BETWEEN, Grounds, SceneSums, Shaken};
use crate::{Row, Verlet};

/// A distance within which two structures may touch for all that rounding says \[m\]: there a step looks closer.
const NEAR: f64 = 1e-9;

/// Runs rows of two structures, each for its number of steps, and tells what happened in them.
#[inline(always)]
pub(super) fn run<S: Simd, Column: SideBySideColumn>(
    simd: S,
    method: &Shaken<'_, Verlet>,
    (rows, n_steps): (&[&Row<Column>], &[usize]),
    tallies: &mut SceneSums,
) {
    let in_step = 2 * Lanes::<S>::N;
    let groups = rows.chunks(in_step).zip(n_steps.chunks(in_step));
    let mut room = Vec::new();
    for (index, (rows, n_steps)) in groups.enumerate() {
        let first = index * in_step;
        let parts = Rows { rows, first }.split::<S>();
        let longest = n_steps.iter().copied().max().unwrap_or(0);
        let grounds = method.ground.in_lanes::<S, _>(&parts, longest, &mut room);
        let [one, other] = [0, 1].map(|group: usize| (parts[group], grounds.at(simd, 0, group)));
        let mut groups = [
            Group::new(simd, one, method),
            Group::new(simd, other, method),
        ];
        steps(method, grounds, &mut groups, (n_steps, first), tallies);
    }
}

/// All steps of two groups; what happened in a scene is told at its end, as one of those from `first` on.
#[inline(always)]
fn steps<S: Simd, Column: SideBySideColumn>(
    method: &Shaken<'_, Verlet>,
    grounds: Grounds<'_>,
    groups: &mut [Group<S, Column>; 2],
    (n_steps, first): (&[usize], usize),
    tallies: &mut SceneSums,
) {
    let mut done = 0;
    while let Some(end) = n_steps.iter().filter(|end| **end > done).min() {
        if method.budget.is_stopped() {
            return;
        }
        let next = (*end).min(done + BETWEEN);
        while done < next {
            done = go_apart(groups, grounds, done..next);
            if done < next {
                for (index, group) in groups.iter_mut().enumerate() {
                    let simd = group.constants[0].inverse_mass.token();
                    group.step([done, done + 1].map(|node| grounds.at(simd, node, index)));
                }
                done += 1;
            }
        }
        for (index, _) in n_steps.iter().enumerate().filter(|of| *of.1 == done) {
            let group = &groups[index / Lanes::<S>::N];
            let (lane, scene) = (index % Lanes::<S>::N, first + index);
            for (node, motion) in group.motions.iter().enumerate() {
                tallies.take_floor(scene, node, [motion.peak(lane); 2]);
            }
            if let Some(pair) = &group.pair {
                tallies.take_pair(scene, pair.index, pair.tally.lane(lane));
                if pair.tally.books.is_doubtful(lane) {
                    tallies.doubt(scene);
                }
            }
        }
    }
    let with_scenes = n_steps.len().div_ceil(Lanes::<S>::N);
    for group in &groups[..with_scenes] {
        tallies.steps += done as u64;
        tallies.touching_steps += group.touching_steps;
    }
}

/// Goes on while no lane may touch, with the motions at hand; the number of steps that are done.
#[inline(always)]
fn go_apart<S: Simd, Column: SideBySideColumn>(
    [one, other]: &mut [Group<S, Column>; 2],
    grounds: Grounds<'_>,
    steps: Range<usize>,
) -> usize {
    let mut done = steps.start;
    if one.busy || other.busy {
        return done;
    }
    let (mut ones, mut others) = (one.motions, other.motions);
    for step in steps {
        let a = one.constants[0].step.predict(ones[0].kinematics());
        let b = one.constants[1].step.predict(ones[1].kinematics());
        let c = other.constants[0].step.predict(others[0].kinematics());
        let d = other.constants[1].step.predict(others[1].kinematics());
        let near = one.may_touch(&ones, [a[0], b[0]]) | other.may_touch(&others, [c[0], d[0]]);
        if Lanes::any(near) {
            break;
        }
        let [ground, its] = [0, 1].map(|group: usize| grounds.at(a[0].token(), step + 1, group));
        one.constants[0].finish(&mut ones[0], a, ground);
        one.constants[1].finish(&mut ones[1], b, ground);
        other.constants[0].finish(&mut others[0], c, its);
        other.constants[1].finish(&mut others[1], d, its);
        done = step + 1;
    }
    (one.motions, other.motions) = (ones, others);
    done
}
