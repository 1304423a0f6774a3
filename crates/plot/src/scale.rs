//! Ranges of axes, and the step from values to millimetres.

use super::clip::Box2;
use super::{Axis, Curve, CurveKind, Panel, PaperPoint, PlotError, Scale};

/// Part of the range left free above and below the data.
const HEADROOM: f64 = 0.07;

/// A range is the lowest and the highest value of an axis, with the mapping in between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    pub(super) from: f64,
    pub(super) to: f64,
    rule: Rule,
}

/// Mapping from values to the length of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Rule {
    /// Equal differences, equal lengths.
    Linear,
    /// Equal ratios, equal lengths.
    Log,
    /// Equal differences, equal lengths, counted from the upper end: names are read downwards.
    Down,
}

impl Range {
    /// Returns the position of a value: 0 at the start and 1 at the end of its axis.
    pub(super) fn fraction(&self, value: f64) -> f64 {
        let Self { from, to, rule } = *self;
        let fraction = match rule {
            Rule::Linear => (value - from) / (to - from),
            Rule::Log => {
                let start = libm::log10(from);
                (libm::log10(value) - start) / (libm::log10(to) - start)
            }
            Rule::Down => (to - value) / (to - from),
        };
        // Far outside, the exact position does not matter; the bound keeps results finite.
        fraction.clamp(-1e6, 1e6)
    }

    /// Whether a value is on the axis.
    pub(super) fn contains(&self, value: f64) -> bool {
        self.from <= value && value <= self.to
    }
}

/// A frame is the inside of a panel: its area on the paper, and its range of values.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// Lower left and upper right corner on the paper \[mm\].
    pub(super) edges: Box2,
    /// Values from the left to the right edge.
    pub(super) x: Range,
    /// Values between the lower and the upper edge.
    pub(super) y: Range,
}

impl Frame {
    /// Returns the position of a value of x on the paper.
    pub(super) fn across(&self, x: f64) -> f64 {
        let ((left, _), (right, _)) = self.edges;
        left + self.x.fraction(x) * (right - left)
    }

    /// Returns the position of a value of y on the paper.
    pub(super) fn up(&self, y: f64) -> f64 {
        let ((_, bottom), (_, top)) = self.edges;
        bottom + self.y.fraction(y) * (top - bottom)
    }

    /// Returns the position of a point on the paper.
    pub(super) fn place(&self, (x, y): (f64, f64)) -> PaperPoint {
        (self.across(x), self.up(y))
    }

    /// Returns the value of y within the panel that is closest to zero: the start of stems and areas.
    pub(super) fn base(&self) -> f64 {
        self.up(0.0_f64.clamp(self.y.from, self.y.to))
    }
}

/// Returns the range of an x axis: its range if set, or that of the curves of the panels that share it.
pub(super) fn x_range(axis: &Axis, panels: &[&Panel]) -> Result<Range, PlotError> {
    let curves = || panels.iter().flat_map(|panel| &panel.curves);
    let points = curves().flat_map(|curve| &curve.points).map(|point| point.0);
    let headroom = if curves().any(is_airy) { HEADROOM } else { 0.0 };
    settle(axis, points, headroom, Rule::Linear)
}

/// Returns the range of the y axis of a panel: its range if set, or that of the curves, including zero if they start there.
pub(super) fn y_range(panel: &Panel) -> Result<Range, PlotError> {
    let points = panel.curves.iter().flat_map(|curve| &curve.points).map(|point| point.1);
    let stands = panel.y.scale != Scale::Log && panel.curves.iter().any(starts_from_zero);
    let values = points.chain(panel.levels.iter().copied()).chain(stands.then_some(0.0));
    settle(&panel.y, values, HEADROOM, Rule::Down)
}

/// Whether a curve needs room at its sides: its marks extend beyond its ends, and a loop should not be cut.
fn is_airy(curve: &Curve) -> bool {
    let turns_back = curve.points.windows(2).any(|pair| pair[1].0 < pair[0].0);
    let by_kind = matches!(curve.kind, CurveKind::Points | CurveKind::Stems | CurveKind::Bars);
    by_kind || curve.mark.is_some() || turns_back
}

/// Whether a curve starts from zero.
pub(super) fn starts_from_zero(curve: &Curve) -> bool {
    matches!(curve.kind, CurveKind::Stems | CurveKind::Area)
}

/// Returns the requested range, or a range around the values; refuses ranges that cannot be divided into ticks.
///
/// Axes of names use the rule `names`.
fn settle(axis: &Axis, values: impl Iterator<Item = f64>, headroom: f64, names: Rule) -> Result<Range, PlotError> {
    let (rule, (from, to)) = match &axis.scale {
        Scale::Linear => (Rule::Linear, axis.range.unwrap_or_else(|| around(values, headroom))),
        Scale::Log => (Rule::Log, axis.range.unwrap_or_else(|| around_ratios(values, headroom))),
        Scale::Names(list) => (names, (-0.5, list.len() as f64 - 0.5)),
    };
    let size = from.abs().max(to.abs());
    // The bounds keep differences of values finite and ticks apart.
    let sound = from < to && size < 1e300 && to - from > 1e-300 && to - from > 1e-9 * size;
    if sound && (rule != Rule::Log || from > 1e-300) {
        Ok(Range { from, to, rule })
    } else {
        Err(PlotError::Range {
            axis: axis.label.clone(),
            from,
            to,
        })
    }
}

/// Returns the lowest and the highest of values, if there are any.
fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.fold(None, |extent, v| match extent {
        None => Some((v, v)),
        Some((low, high)) => Some((v.min(low), v.max(high))),
    })
}

/// Returns a range around values with headroom; a single value is in the middle, and no value gives 0 to 1.
fn around(values: impl Iterator<Item = f64>, headroom: f64) -> (f64, f64) {
    let Some((low, high)) = extent(values) else {
        return (0.0, 1.0);
    };
    let size = low.abs().max(high.abs());
    if high - low <= 1e-8 * size || size == 0.0 {
        let margin = if size == 0.0 { 1.0 } else { 0.2 * size };
        return (low - margin, high + margin);
    }
    let margin = headroom * (high - low);
    // Values stand on zero: there is no room beyond it.
    (
        if low == 0.0 { low } else { low - margin },
        if high == 0.0 { high } else { high + margin },
    )
}

/// Returns a range around positive values, with headroom as a part of its length. A single value is in the middle of two decades, and no
/// value gives 1 to 10.
fn around_ratios(values: impl Iterator<Item = f64>, headroom: f64) -> (f64, f64) {
    let Some((low, high)) = extent(values) else {
        return (1.0, 10.0);
    };
    let decades = libm::log10(high / low);
    let factor = if decades > 1e-8 { libm::exp10(headroom * decades) } else { 10.0 };
    (low / factor, high * factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(values: &[f64]) -> (f64, f64) {
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
    fn reference_decades_have_one_length() {
        let axis = Axis::over("e", 1e-14, 1.0).log();
        let range = settle(&axis, std::iter::empty(), 0.0, Rule::Linear).unwrap();
        for n in 0..=14 {
            let value: f64 = format!("1e-{n}").parse().unwrap();
            let expected = 1.0 - f64::from(n) / 14.0;
            assert!((range.fraction(value) - expected).abs() < 1e-14, "1e-{n}");
        }
    }

    #[test]
    fn limit_ratios_get_the_headroom_of_differences() {
        let (low, high) = around_ratios([1e-3, 1e2, 1.0].into_iter(), 0.1);
        let (from, to) = around([-3.0, 2.0].into_iter(), 0.1);
        assert!((libm::log10(low) - from).abs() < 1e-14 && (libm::log10(high) - to).abs() < 1e-14);
        assert_eq!(around_ratios(std::iter::empty(), 0.1), (1.0, 10.0));
        assert_eq!(
            around_ratios([5.0, 5.0].into_iter(), 0.1),
            (0.5, 50.0),
            "a single value stands in the middle of two decades"
        );
    }

    #[test]
    fn reference_names_run_downwards_on_a_y_axis() {
        let axis = Axis::names(vec!["a".into(), "b".into(), "c".into()]);
        for (rule, expected) in [(Rule::Down, [1.0, 0.5, 0.0]), (Rule::Linear, [0.0, 0.5, 1.0])] {
            let range = settle(&axis, std::iter::empty(), 0.0, rule).unwrap();
            for (value, expected) in [-0.5, 1.0, 2.5].into_iter().zip(expected) {
                assert!((range.fraction(value) - expected).abs() < 1e-15, "{rule:?} {value}");
            }
        }
    }

    #[test]
    fn extreme_logarithmic_ranges_are_refused() {
        for (from, to) in [(0.0, 1.0), (-1.0, 1.0), (1e-310, 1.0), (1.0, 1.0)] {
            let axis = Axis::over("e", from, to).log();
            let settled = settle(&axis, std::iter::empty(), 0.0, Rule::Linear);
            assert!(matches!(settled, Err(PlotError::Range { .. })), "{from} to {to}");
        }
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
            let settled = settle(&Axis::over("u", from, to), std::iter::empty(), 0.0, Rule::Linear);
            assert!(matches!(settled, Err(PlotError::Range { .. })), "{from} to {to}");
        }
    }
}
