//! Velocity jumps of several scenes side by side.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::closings::Closings;
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::number::{Lanes, Mask};
use super::scenes::Scenes;
use pounding_solver::formulas::{ROUNDING, Rounds};

/// Lets the velocities at a node jump where impulsive pairs touch and approach; what has jumped begins anew from there, and is told to those
/// who follow neighbours.
#[inline(always)]
pub(super) fn jump<S: Simd, Column: SideBySideColumn>(
    rounds: &mut Rounds<Lanes<S>>,
    frame: &mut impl Frame<S, Column>,
    (structures, pairs): Scenes<'_, S, Column>,
    ground: Lanes<S>,
    closings: Option<&mut Closings<S>>,
) {
    if strike_all(rounds, frame, (structures, pairs)) {
        frame.restart(structures, rounds.links(), ground);
        if let Some(closings) = closings {
            for link in rounds.links() {
                for place in [link.left, link.right].map(|node| frame.place(node)) {
                    closings.jump(place, structures[place].contact.at_node.jumped);
                }
            }
        }
    }
    rounds.clear();
}

/// Strikes all pairs that touch; false where none approaches.
#[inline(always)]
fn strike_all<S: Simd, Column: SideBySideColumn>(
    rounds: &mut Rounds<Lanes<S>>,
    frame: &impl Frame<S, Column>,
    (structures, pairs): Scenes<'_, S, Column>,
) -> bool {
    let strikes = rounds.strike_all(|node| structures[frame.place(node)].contact.at_node.velocity);
    if strikes {
        for (link, impulse) in rounds.struck() {
            if let Some(pair) = &mut pairs[link.left] {
                pair.tally.strike(impulse);
            }
            for node in [link.left, link.right] {
                structures[frame.place(node)].contact.at_node.jumped = rounds.velocity(node);
            }
        }
    }
    strikes
}

/// Velocities after an impact \[m/s\], and its impulse \[N·s\]: those before and 0 where there is none.
pub(super) struct Struck<S: Simd> {
    pub(super) impulse: Lanes<S>,
    pub(super) velocities: [Lanes<S>; 2],
}

/// Strikes pairs that touch in these lanes, each the only one of its scene, with 1 + e; nothing where none approaches.
///
/// A scene that rounding would let approach once more is given up: its velocities are no numbers from then on, and it runs alone.
/// [`Rounds`] would strike it again.
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
