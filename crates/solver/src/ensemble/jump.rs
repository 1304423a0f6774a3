//! Velocity jumps of several scenes side by side.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::body::Body;
use super::closings::Closings;
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::law::{Impulsive, Law};
use super::number::{Lanes, Mask};
use super::scenes::{Pair, Scenes, Structure};
use crate::RestoringForce;
use crate::impact::rounds::{ROUNDING, Rounds, Touching};

/// The rule of [`Impacts`](crate::impact::impacts::Impacts): the pair of two structures at once, pairs of longer rows in its rounds.
pub(super) enum Jumps<'a, S: Simd> {
    TwoStructures,
    Longer(&'a mut Rounds<Lanes<S>>),
}

/// The rounds of longer rows.
///
/// Who keeps them lends them: a group that had to be dropped would be kept in memory, and not in registers.
#[inline(always)]
pub(super) fn rounds<S: Simd, Column: SideBySideColumn>(
    frame: &impl Frame<S, Column>,
    structures: &[Structure<S, Column>],
    pairs: &[Option<Pair<S>>],
) -> Rounds<Lanes<S>> {
    let nodes = 0..structures.len();
    let mobilities = nodes.map(|node| mobility(&structures[frame.place(node)]));
    Rounds::new(mobilities.collect(), pairs.iter().flatten().count())
}

impl<S: Simd> Jumps<'_, S> {
    /// Takes an impulsive pair that touches, with its left neighbour; farther to the right than those before.
    #[inline(always)]
    pub(super) fn take(&mut self, of: (usize, usize), touching: Touching<Lanes<S>>) {
        if let Self::Longer(rounds) = self {
            rounds.push(of, touching);
        }
    }

    /// Lets the velocities at a node jump where impulsive pairs touch and approach; what has jumped begins anew from there, and is told
    /// to those who follow neighbours.
    #[inline(always)]
    pub(super) fn jump<Column: SideBySideColumn>(
        &mut self,
        frame: &mut impl Frame<S, Column>,
        (structures, pairs): Scenes<'_, S, Column>,
        ground: Lanes<S>,
        closings: Option<&mut Closings<S>>,
    ) {
        match self {
            Self::TwoStructures => {
                let [left, right] = structures else {
                    return;
                };
                if let Some(pair) = &mut pairs[0]
                    && let Law::Impulsive(law) = pair.law
                    && strike(pair, law, [left, right])
                {
                    for structure in [&mut *left, &mut *right] {
                        let jumps = structure.contact.node.jumps();
                        structure.restart(structure.acceleration(ground), jumps);
                    }
                    if let Some(closings) = closings {
                        closings.jump(0, left.contact.node.jumped);
                        closings.jump(1, right.contact.node.jumped);
                    }
                }
            }
            Self::Longer(rounds) => {
                if strike_all(rounds, frame, (structures, pairs)) {
                    frame.restart(structures, rounds.links(), ground);
                    if let Some(closings) = closings {
                        for link in rounds.links() {
                            for place in [link.left, link.right].map(|node| frame.place(node)) {
                                closings.jump(place, structures[place].contact.node.jumped);
                            }
                        }
                    }
                }
                rounds.clear();
            }
        }
    }
}

/// The velocity that a unit impulse gives to a structure \[1/kg\].
#[inline(always)]
fn mobility<S: Simd, Column: RestoringForce<Lanes<S>>>(structure: &Body<S, Column>) -> Lanes<S> {
    structure.constants.coefficients.inverse_mass
}

/// Strikes all pairs that touch; false where none approaches.
#[inline(always)]
fn strike_all<S: Simd, Column: SideBySideColumn>(
    rounds: &mut Rounds<Lanes<S>>,
    frame: &impl Frame<S, Column>,
    (structures, pairs): Scenes<'_, S, Column>,
) -> bool {
    let strikes = rounds.strike_all(|node| structures[frame.place(node)].contact.node.velocity);
    if strikes {
        for (link, impulse) in rounds.struck() {
            if let Some(pair) = &mut pairs[link.left] {
                pair.tally.strike(impulse);
            }
            for node in [link.left, link.right] {
                structures[frame.place(node)].contact.node.jumped = rounds.velocity(node);
            }
        }
    }
    strikes
}

/// Strikes a pair that is the only one of every scene, where it touches; false where none approaches.
#[inline(always)]
fn strike<S: Simd, Column: RestoringForce<Lanes<S>>>(
    pair: &mut Pair<S>,
    law: Impulsive<S>,
    [left, right]: [&mut Body<S, Column>; 2],
) -> bool {
    let velocities = [left.contact.node.velocity, right.contact.node.velocity];
    let touches = pair.deformation.reaches(velocities[0].like(0.0));
    let mobilities = [mobility(left), mobility(right)];
    let Some(struck) = struck((touches, law.factor), velocities, mobilities) else {
        return false;
    };
    pair.tally.strike(struck.impulse);
    [left.contact.node.jumped, right.contact.node.jumped] = struck.velocities;
    true
}

/// Velocities after an impact \[m/s\], and its impulse \[N·s\]: those before and 0 where there is none.
pub(super) struct Struck<S: Simd> {
    pub(super) impulse: Lanes<S>,
    pub(super) velocities: [Lanes<S>; 2],
}

/// Strikes pairs that touch in these lanes, each the only one of its scene, with 1 + e; nothing where none approaches.
///
/// A scene that rounding would let approach once more, which takes further rounds, is given up: its velocities are no numbers from
/// then on, and it runs alone.
#[inline(always)]
pub(super) fn struck<S: Simd>(
    (touches, factor): (Mask<S>, Lanes<S>),
    [v, w]: [Lanes<S>; 2],
    mobilities: [Lanes<S>; 2],
) -> Option<Struck<S>> {
    let zero = v.like(0.0);
    let hits = touches & (v - w).exceeds(zero);
    if !Lanes::any(hits) {
        return None;
    }
    let impulse = factor * (v - w) / (mobilities[0] + mobilities[1]);
    let after = (v - mobilities[0] * impulse, w + mobilities[1] * impulse);
    // What rounding leaves of an approach; more would be solved in further rounds.
    let left_over = zero.like(ROUNDING) * (v.abs() + w.abs());
    let again = (after.0 - after.1).exceeds(left_over);
    let nowhere = zero.like(f64::NAN);
    let after = [
        Number::select(again, nowhere, after.0),
        Number::select(again, nowhere, after.1),
    ];
    Some(Struck {
        impulse: Number::select(hits, impulse, zero),
        velocities: [
            Number::select(hits, after[0], v),
            Number::select(hits, after[1], w),
        ],
    })
}
