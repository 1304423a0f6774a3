//! Where a motion that is known between its ends turns inside a span.

use crate::span::Expansion;
use crate::{Path, Series, Span};

/// Steps after which a search is ended; it needs about ten.
const MOST_STEPS: u32 = 100;

impl Span<'_> {
    /// The instant inside the span at which a quantity passes through zero that has opposite signs at its ends; nothing
    /// in a step, of which only the ends are known.
    ///
    /// Regula falsi (Illinois) to the rounding of the time.
    pub(crate) fn crossing(
        &self,
        [mut low, mut high]: [f64; 2],
        quantity: impl Fn(f64) -> f64,
    ) -> Option<f64> {
        let same = low == 0.0 || high == 0.0 || (low < 0.0) == (high < 0.0);
        if same || matches!(self.path, Path::Cubic(_)) {
            return None;
        }
        let (mut from, mut to) = (self.start_time, self.end_time);
        for _ in 0..MOST_STEPS {
            let time = from + (to - from) * (low / (low - high));
            let value = quantity(time);
            if value == 0.0 || time <= from.min(to) || time >= from.max(to) {
                return Some(time);
            }
            if (value < 0.0) == (high < 0.0) {
                low *= 0.5;
            } else {
                (from, low) = (to, high);
            }
            (to, high) = (time, value);
        }
        Some(to)
    }

    /// Rate at which the absolute acceleration changes, on ground whose acceleration changes at `slope` \[m/s³\], but for a
    /// positive factor; nothing in a step.
    pub(crate) fn jerk(&self, time: f64, slope: f64) -> f64 {
        match self.path {
            Path::Cubic(_) => 0.0,
            Path::Series(series) => series.jerk(self.x(series, time), slope),
            Path::Flight(_) => self.expanded(&mut Expansion::default()).jerk(time, slope),
        }
    }
}

impl Series<'_> {
    /// d(acceleration)/dx of the floor on ground whose acceleration changes at `slope` \[m/s³\].
    fn jerk(&self, x: f64, slope: f64) -> f64 {
        let terms = self.acceleration.iter().enumerate().skip(1).rev();
        let own = terms.fold(0.0, |sum, (n, coefficient)| {
            sum * x + n as f64 * coefficient
        });
        own + slope * self.power.rate(x)
    }
}
