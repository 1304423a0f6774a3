//! Labels along an axis: numbers or names, and short ticks between them.

use super::scale::Range;
use super::ticks::{self, Tick};
use super::{Axis, Scale, decades, text};

/// Sizes of text in points.
pub(super) const TICK_POINTS: f64 = 8.0;

/// Least distance of numbers: along the x axis between their texts, along the y axis between their middles \[mm\].
const NUMBER_SPACE: (f64, f64) = (2.2, 6.2);

/// Least distance of the middles of powers of ten and of names along the y axis \[mm\].
const LINE_SPACE: (f64, f64) = (4.6, 3.4);

/// A ruler is the sequence of labels along an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ruler {
    /// Numbers or names.
    pub(super) ticks: Vec<Tick>,
    /// Short ticks without a number.
    pub(super) between: Vec<f64>,
    /// Whether names are too close to each other to be readable.
    pub(super) crowded: bool,
}

impl Ruler {
    /// Chooses the labels along an x axis of a length \[mm\].
    pub(super) fn across(axis: &Axis, range: Range, length: f64) -> Self {
        let fit = |ticks: &[Tick]| spacing(ticks, range, length) >= NUMBER_SPACE.0 + widest(ticks).max(4.0);
        Self::choose(axis, range, length, (12, fit))
    }

    /// Chooses the labels along a y axis of a length \[mm\]: about ten numbers, or as many as a low panel can hold.
    pub(super) fn up(axis: &Axis, range: Range, length: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "paper is at most 2 m high")]
        let most = (length / NUMBER_SPACE.1).clamp(0.0, 9.0) as u32;
        let space = match axis.scale {
            Scale::Linear => NUMBER_SPACE.1,
            Scale::Log => LINE_SPACE.0,
            Scale::Names(_) => LINE_SPACE.1,
        };
        let fit = |ticks: &[Tick]| spacing(ticks, range, length) >= space;
        Self::choose(axis, range, length, (most, fit))
    }

    fn choose(axis: &Axis, range: Range, length: f64, (most, fit): (u32, impl Fn(&[Tick]) -> bool)) -> Self {
        let ends = (range.from, range.to);
        let (ticks, between) = match &axis.scale {
            Scale::Linear => (ticks::choose(ends, most, &fit), Vec::new()),
            Scale::Log => {
                let decade = range.fraction(10.0 * range.from) * length;
                decades::choose(ends, decade, &fit)
            }
            Scale::Names(names) => (named(names), Vec::new()),
        };
        let crowded = matches!(axis.scale, Scale::Names(_)) && !fit(&ticks);
        Self { ticks, between, crowded }
    }

    /// Returns the width of the widest number or name \[mm\].
    pub(super) fn widest(&self) -> f64 {
        widest(&self.ticks)
    }
}

/// Puts names at 0, 1, 2 and so on.
fn named(names: &[String]) -> Vec<Tick> {
    let tick = |(value, name): (f64, &String)| Tick {
        value,
        label: name.clone(),
    };
    let places = (0..u32::MAX).map(f64::from);
    places.zip(names).map(tick).collect()
}

/// Returns the least distance of ticks on an axis of a length \[mm\].
fn spacing(ticks: &[Tick], range: Range, length: f64) -> f64 {
    let place = |tick: &Tick| range.fraction(tick.value) * length;
    let distances = ticks.windows(2).map(|pair| (place(&pair[1]) - place(&pair[0])).abs());
    distances.fold(length, f64::min)
}

/// Returns the width of the widest of texts \[mm\].
fn widest(ticks: &[Tick]) -> f64 {
    ticks.iter().map(|tick| text::width(&tick.label, TICK_POINTS)).fold(0.0, f64::max)
}
