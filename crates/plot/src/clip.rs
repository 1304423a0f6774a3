//! Cutting curves at the edges of a panel.

use super::PaperPoint;

/// A box is the lower left and the upper right corner of what is visible.
pub(super) type Box2 = (PaperPoint, PaperPoint);

/// Cuts a line at the edges of a box and returns the visible pieces.
pub(super) fn pieces(points: &[PaperPoint], edges: Box2) -> Vec<Vec<PaperPoint>> {
    let mut pieces: Vec<Vec<PaperPoint>> = Vec::new();
    for pair in points.windows(2) {
        let Some((from, to)) = visible(pair[0], pair[1], edges) else {
            continue;
        };
        match pieces.last_mut() {
            // A segment that was not cut at its start goes on from the end of the segment before.
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

/// Returns the visible part of a segment, after Liang and Barsky (1984).
fn visible(a: PaperPoint, b: PaperPoint, (low, high): Box2) -> Option<(PaperPoint, PaperPoint)> {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (step, room) in [(-dx, a.0 - low.0), (dx, high.0 - a.0), (-dy, a.1 - low.1), (dy, high.1 - a.1)] {
        if step == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            enter = enter.max(room / step);
        } else {
            leave = leave.min(room / step);
        }
    }
    if enter > leave {
        return None;
    }
    let at = |s: f64| (a.0 + s * dx, a.1 + s * dy);
    Some((if enter > 0.0 { at(enter) } else { a }, if leave < 1.0 { at(leave) } else { b }))
}

/// Tells whether a point is inside a box or on its edge.
pub(super) fn contains((low, high): Box2, (x, y): PaperPoint) -> bool {
    low.0 <= x && x <= high.0 && low.1 <= y && y <= high.1
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Box2 = ((0.0, 0.0), (1.0, 1.0));

    #[test]
    fn limit_an_inner_line_stays_whole() {
        let line = vec![(0.1, 0.2), (0.5, 0.9), (0.5, 0.9), (1.0, 0.0)];
        assert_eq!(pieces(&line, UNIT), vec![line]);
    }

    #[test]
    fn reference_a_spike_is_cut_into_two() {
        let line = [(0.0, 0.0), (0.5, 2.0), (1.0, 0.0)];
        let expected = vec![vec![(0.0, 0.0), (0.25, 1.0)], vec![(0.75, 1.0), (1.0, 0.0)]];
        assert_eq!(pieces(&line, UNIT), expected);
    }

    #[test]
    fn extreme_nothing_is_left_of_an_outer_line() {
        assert!(pieces(&[(-1.0, 2.0), (2.0, 2.0), (2.0, -1.0)], UNIT).is_empty());
        assert!(pieces(&[(0.5, 0.5)], UNIT).is_empty());
    }
}
