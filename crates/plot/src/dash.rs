//! Lines split into dashes, which plotters does not do in an SVG.

use super::PaperPoint;

/// Length of a dash and of the space after it, in widths of the line.
const DASH: (f64, f64) = (4.0, 2.4);

/// Cuts a line into dashes; `width` is that of the line \[mm\].
pub(super) fn dashes(points: &[PaperPoint], width: f64) -> Vec<Vec<PaperPoint>> {
    let lengths = [DASH.0 * width, DASH.1 * width];
    let mut dashes: Vec<Vec<PaperPoint>> = Vec::new();
    let (mut phase, mut left) = (0, lengths[0]);
    let mut dash: Vec<PaperPoint> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        loop {
            let (dx, dy) = (to.0 - from.0, to.1 - from.1);
            let length = (dx * dx + dy * dy).sqrt();
            if length <= left {
                left -= length;
                break;
            }
            from = (from.0 + dx * left / length, from.1 + dy * left / length);
            if phase == 0 {
                dash.push(from);
                dashes.push(std::mem::take(&mut dash));
            } else {
                dash = vec![from];
            }
            phase = 1 - phase;
            left = lengths[phase];
        }
        if phase == 0 {
            dash.push(to);
        }
    }
    dashes.push(dash);
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_dashes_follow_the_line() {
        let dashes = dashes(&[(0.0, 0.0), (3.0, 0.0), (3.0, 7.0)], 1.0);
        let expected = [vec![(0.0, 0.0), (3.0, 0.0), (3.0, 1.0)], vec![(3.0, 3.4), (3.0, 7.0)]];
        assert_eq!(dashes, expected);
    }
}
