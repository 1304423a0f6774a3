//! Velocity jumps of several scenes in lanes.

use fearless_simd::Simd;

use super::closings::Closings;
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::number::Lanes;
use super::scenes::Scenes;
use pounding_solver::formulas::Rounds;

/// Applies velocity jumps at a node to impulsive pairs that touch and approach. Structures that jump are restarted, and closings are
/// updated.
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

/// Strikes all pairs that touch; false if none approaches.
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
