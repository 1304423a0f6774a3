//! Whether walls leave a row no room: what an exact run that ends with `ClosedIn` says, asked of gaps and grounds alone.

use pounding_scene::{Error, Simulation};
use pounding_solver::RunError;

/// Rounding that a distance of grounds is forgiven \[m\].
const ROUNDING: f64 = 1e-9;

/// False where a run ends because walls close in, and there is room for all that stands between them.
pub(super) fn is_explained(prepared: &Simulation, error: &Error) -> bool {
    let Error::Run { source, .. } = error else {
        return true;
    };
    let RunError::ClosedIn { time, .. } = source else {
        return true;
    };
    let walls = prepared.walls();
    (0..walls.len()).any(|node| walls[node] && leaves_no_room(prepared, &walls, (node, *time)))
}

/// Whether a wall has come as close to the next one on its right as the gaps of impulsive contacts between them allow.
fn leaves_no_room(prepared: &Simulation, walls: &[bool], (wall, time): (usize, f64)) -> bool {
    let Some(travel) = prepared.travel() else {
        return false;
    };
    let (mut node, mut room) = (wall, 0.0);
    let right_of = |node: usize| {
        let mut pairs = prepared.pairs().iter();
        pairs.find(|pair| pair.left() == node && !pair.law.is_compliant())
    };
    while let Some(pair) = right_of(node) {
        (node, room) = (pair.right(), room + pair.gap());
        if walls[node] {
            return travel.opening([wall, node], time).displacement >= room - ROUNDING;
        }
    }
    false
}
