//! The velocity Verlet method side by side: two structures, or one and a wall, with impacts after a step or located within it.
//!
//! An instant of impact is that of a lane: where some lane has one, all go there by spans of their own lengths, those without one
//! by a span of length 0.
//!
//! Rows of three and more structures run alone: side by side they would need the order of the impacts in every lane.

mod body;
mod group;

use fearless_simd::Simd;
use pounding_contact::Number;

use self::group::Group;
use super::column::SideBySideColumn;
use super::excitations::GROUPS;
use super::number::Lanes;
use super::rows::Rows;
use super::{BETWEEN, Grounds, SceneSums, Shaken};
use crate::{Row, Verlet};

/// A distance within which two structures may touch for all that rounding says \[m\]: there a step looks closer.
const NEAR: f64 = 1e-9;

/// Runs rows of two structures, each for its number of steps, and tells what happened in them.
#[inline(always)]
pub(super) fn run<S: Simd, Column: SideBySideColumn, G: Grounds>(
    (simd, method): (S, &Shaken<Verlet>),
    mut grounds: G,
    (rows, n_steps): (&[&Row<Column>], &[usize]),
    tallies: &mut SceneSums,
) {
    let in_step = 2 * Lanes::<S>::N;
    let groups = rows.chunks(in_step).zip(n_steps.chunks(in_step));
    for (index, (rows, n_steps)) in groups.enumerate() {
        let first = index * in_step;
        let parts = Rows { rows, first }.split::<S>();
        let at_start = G::at(simd, &grounds.nodes::<S, _>(&parts, 0..=0)[0]);
        let [one, other] = [0, 1].map(|group: usize| (parts[group], at_start[group]));
        let mut groups = [
            Group::new(simd, one, method),
            Group::new(simd, other, method),
        ];
        steps(
            method,
            (&parts, &mut grounds),
            &mut groups,
            (n_steps, first),
            tallies,
        );
    }
}

/// All steps of two groups; what happened in a scene is told at its end, as one of those from `first` on.
#[inline(always)]
fn steps<S: Simd, Column: SideBySideColumn, G: Grounds>(
    method: &Shaken<Verlet>,
    (parts, grounds): (&[Rows<'_, Column>; GROUPS], &mut G),
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
        let before = done;
        let nodes = grounds.nodes::<S, _>(parts, before..=next);
        while done < next {
            done += go_apart::<S, Column, G>(groups, &nodes[done - before..]);
            if let [from, to, ..] = &nodes[done - before..] {
                let simd = groups[0].constants[0].inverse_mass.token();
                let (from, to) = (G::at(simd, from), G::at(simd, to));
                let times = [done, done + 1].map(|step| step as f64 * method.time_step);
                for (index, group) in groups.iter_mut().enumerate() {
                    group.step([from[index], to[index]], times);
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
                tallies.take_pair(scene, pair.index, group.sums(pair, lane));
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

/// Goes on from the first of some nodes while no lane may touch, with the motions at hand; the number of steps.
#[inline(always)]
fn go_apart<S: Simd, Column: SideBySideColumn, G: Grounds>(
    [one, other]: &mut [Group<S, Column>; 2],
    nodes: &[G::Node],
) -> usize {
    let mut done = 0;
    if !(one.is_plain() && other.is_plain()) {
        return done;
    }
    let (mut ones, mut others) = (one.motions, other.motions);
    for node in &nodes[1..] {
        let a = one.constants[0].step.predict(ones[0].kinematics());
        let b = one.constants[1].step.predict(ones[1].kinematics());
        let c = other.constants[0].step.predict(others[0].kinematics());
        let d = other.constants[1].step.predict(others[1].kinematics());
        let near = one.may_touch(&ones, [a[0], b[0]]) | other.may_touch(&others, [c[0], d[0]]);
        if Lanes::any(near) {
            break;
        }
        let [ground, its] = G::at(a[0].token(), node);
        one.constants[0].finish(&mut ones[0], a, ground);
        one.constants[1].finish(&mut ones[1], b, ground);
        other.constants[0].finish(&mut others[0], c, its);
        other.constants[1].finish(&mut others[1], d, its);
        done += 1;
    }
    (one.motions, other.motions) = (ones, others);
    done
}
