//! Long curves with fewer points that look the same.

/// Farthest that a point that is left out lies from the curve, in parts of the extent of the figure: a tenth of a line's
/// width on paper.
const TOLERANCE: f64 = 2e-4;

/// The curve without the points that nobody would see missing (Ramer 1972; Douglas and Peucker 1973).
pub(super) fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() < 3 {
        return points;
    }
    let extent = |values: fn(&(f64, f64)) -> f64| {
        let (low, high) = points
            .iter()
            .map(values)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        if high > low { high - low } else { 1.0 }
    };
    let scale = (extent(|point| point.0), extent(|point| point.1));
    let mut kept = vec![false; points.len()];
    kept[0] = true;
    kept[points.len() - 1] = true;
    let mut stretches = vec![(0, points.len() - 1)];
    while let Some((first, last)) = stretches.pop() {
        let farthest = (first + 1..last)
            .map(|index| (index, distance(points[index], points[first], points[last], scale)))
            .fold((first, 0.0), |most, next| if next.1 > most.1 { next } else { most });
        if farthest.1 > TOLERANCE {
            kept[farthest.0] = true;
            stretches.push((first, farthest.0));
            stretches.push((farthest.0, last));
        }
    }
    points
        .into_iter()
        .zip(kept)
        .filter_map(|(point, kept)| kept.then_some(point))
        .collect()
}

/// Distance of a point from a stretch of a straight line, in parts of the extent.
fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64), scale: (f64, f64)) -> f64 {
    let relative = |point: (f64, f64)| ((point.0 - from.0) / scale.0, (point.1 - from.1) / scale.1);
    let (x, y) = relative(point);
    let (dx, dy) = relative(to);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 {
        ((x * dx + y * dy) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let (off_x, off_y) = (x - along * dx, y - along * dy);
    (off_x * off_x + off_y * off_y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_corners_stay_and_straight_lines_lose_their_points() {
        let saw = |x: u32| f64::from(if x <= 50 { x } else { 100 - x });
        let points: Vec<_> = (0..=100).map(|x| (f64::from(x), saw(x))).collect();
        assert_eq!(thinned(points), [(0.0, 0.0), (50.0, 50.0), (100.0, 0.0)]);
    }

    #[test]
    fn limit_a_loop_keeps_its_turns() {
        let turns = vec![(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (1.0, -1.0), (0.0, 0.0)];
        assert_eq!(thinned(turns.clone()), turns);
    }

    #[test]
    fn extreme_curves_without_extent() {
        for points in [vec![], vec![(1.0, 2.0)], vec![(1.0, 2.0); 2]] {
            assert_eq!(thinned(points.clone()), points);
        }
        assert_eq!(thinned(vec![(1.0, 2.0); 9]).len(), 2);
    }
}
