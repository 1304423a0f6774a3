//! Ranges of axes, and the step from values to millimetres.

use super::clip::Box2;
use super::{Axis, Curve, Kind, Panel, PlotError, Point};

/// Part of the range left free above and below the data.
const HEADROOM: f64 = 0.07;

/// The lowest and the highest value of something.
pub(super) type Range = (f64, f64);

/// A frame is the inside of a panel: which part of the paper it covers, and which values it shows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// Lower left and upper right corner on the paper \[mm\].
    pub(super) edges: Box2,
    /// Values at the left and the right edge.
    pub(super) x: Range,
    /// Values at the lower and the upper edge.
    pub(super) y: Range,
}

impl Frame {
    /// Returns where a value of x stands on the paper.
    pub(super) fn across(&self, x: f64) -> f64 {
        let ((left, _), (right, _)) = self.edges;
        left + fraction(self.x, x) * (right - left)
    }

    /// Returns where a value of y stands on the paper.
    pub(super) fn up(&self, y: f64) -> f64 {
        let ((_, bottom), (_, top)) = self.edges;
        bottom + fraction(self.y, y) * (top - bottom)
    }

    /// Returns where a point stands on the paper.
    pub(super) fn place(&self, (x, y): (f64, f64)) -> Point {
        (self.across(x), self.up(y))
    }

    /// Returns the value of y within the panel that is closest to zero: where stems and areas start.
    pub(super) fn base(&self) -> f64 {
        self.up(0.0_f64.clamp(self.y.0, self.y.1))
    }

    /// Returns the width on the paper \[mm\].
    pub(super) fn width(&self) -> f64 {
        self.edges.1.0 - self.edges.0.0
    }
}

/// Returns where a value stands in a range, 0 at its lower and 1 at its upper end.
fn fraction((from, to): Range, value: f64) -> f64 {
    // Far outside it does not matter where; the bound keeps what follows finite.
    ((value - from) / (to - from)).clamp(-1e6, 1e6)
}

/// Returns the range of an x axis: its own, or that of the curves of the panels that share it.
pub(super) fn x_range(axis: &Axis, panels: &[&Panel]) -> Result<Range, PlotError> {
    let curves = || panels.iter().flat_map(|panel| &panel.curves);
    let points = curves()
        .flat_map(|curve| &curve.points)
        .map(|point| point.0);
    let airy =
        curves().any(|curve| matches!(curve.kind, Kind::Points | Kind::Stems) || turns_back(curve));
    settle(axis, points, if airy { HEADROOM } else { 0.0 })
}

/// Returns the range of the y axis of a panel: its own, or that of the curves, with zero where they start from it.
pub(super) fn y_range(panel: &Panel) -> Result<Range, PlotError> {
    let points = panel
        .curves
        .iter()
        .flat_map(|curve| &curve.points)
        .map(|point| point.1);
    let zero = panel.curves.iter().any(starts_from_zero).then_some(0.0);
    settle(
        &panel.y,
        points.chain(panel.levels.iter().copied()).chain(zero),
        HEADROOM,
    )
}

/// Tells whether a curve goes left anywhere, as a loop does: it should not be cut at its turning points.
fn turns_back(curve: &Curve) -> bool {
    curve.points.windows(2).any(|pair| pair[1].0 < pair[0].0)
}

/// Tells whether a curve stands on the line of zero.
pub(super) fn starts_from_zero(curve: &Curve) -> bool {
    matches!(curve.kind, Kind::Stems | Kind::Area)
}

/// Returns the range asked for, or one around the values; refuses what cannot be divided into ticks.
fn settle(
    axis: &Axis,
    values: impl Iterator<Item = f64>,
    headroom: f64,
) -> Result<Range, PlotError> {
    let (from, to) = axis.range.unwrap_or_else(|| around(values, headroom));
    let size = from.abs().max(to.abs());
    // The bounds keep differences of values finite and ticks apart.
    let sound = from < to && size < 1e300 && to - from > 1e-300 && to - from > 1e-9 * size;
    if sound {
        Ok((from, to))
    } else {
        Err(PlotError::Range {
            axis: axis.label.clone(),
            from,
            to,
        })
    }
}

/// Returns a range around values with headroom; a single value stands in the middle, and no value gives 0 to 1.
fn around(values: impl Iterator<Item = f64>, headroom: f64) -> Range {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    if low > high {
        return (0.0, 1.0);
    }
    let size = low.abs().max(high.abs());
    if high - low <= 1e-8 * size || size == 0.0 {
        let margin = if size == 0.0 { 1.0 } else { 0.2 * size };
        return (low - margin, high + margin);
    }
    let margin = headroom * (high - low);
    // Zero is an edge that values stand on: no room is wanted beyond it.
    (
        if low == 0.0 { low } else { low - margin },
        if high == 0.0 { high } else { high + margin },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(values: &[f64]) -> Range {
        around(values.iter().copied(), 0.1)
    }

    #[test]
    fn reference_data_get_headroom() {
        assert_eq!(range(&[1.0, 11.0, 3.0]), (0.0, 12.0));
        assert_eq!(range(&[0.0, 10.0]), (0.0, 11.0));
    }

    #[test]
    fn limit_of_no_spread() {
        assert_eq!(range(&[]), (0.0, 1.0));
        assert_eq!(range(&[0.0, 0.0]), (-1.0, 1.0));
        assert_eq!(range(&[-5.0, -5.0]), (-6.0, -4.0));
    }

    #[test]
    fn extreme_ranges_are_refused() {
        let ends = [
            (1.0, 1.0),
            (2.0, 1.0),
            (0.0, f64::INFINITY),
            (f64::NAN, 1.0),
            (-1e308, 1e308),
            (1e9, 1e9 + 1e-3),
        ];
        for (from, to) in ends {
            let settled = settle(&Axis::over("u", from, to), std::iter::empty(), 0.0);
            assert!(
                matches!(settled, Err(PlotError::Range { .. })),
                "{from} to {to}"
            );
        }
    }
}
