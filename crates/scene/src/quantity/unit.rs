//! Units of the numbers of a run.

use pounding_text::{instant, percent, short};

/// A unit, and the unit in which people read its numbers.
#[derive(Debug)]
pub struct QuantityUnit {
    /// Ending of names in files.
    pub suffix: &'static str,
    /// Its symbol in documents.
    pub symbol: &'static str,
    /// The unit that people read; empty if they read none.
    pub shown: &'static str,
    /// Factor from the SI unit to the unit that people read, for an acceleration of gravity \[m/s²\].
    factor: fn(f64) -> f64,
    /// Text of a number in the unit that people read.
    pub(super) text: fn(f64) -> String,
}

impl QuantityUnit {
    pub(super) const ONE: Self = Self::new("", "–", "", |_| 1.0, short);
    pub(super) const PART: Self = Self::new("", "–", "", |_| 1.0, percent);
    pub(super) const COUNT: Self = Self::new("", "–", "", |_| 1.0, |count| count.to_string());
    pub(super) const SECOND: Self = Self::new("_s", "s", "s", |_| 1.0, instant);
    pub(super) const PERIOD: Self = Self::new("_s", "s", "s", |_| 1.0, short);
    pub(super) const METRE: Self = Self::new("_m", "m", "mm", |_| 1e3, short);
    pub(super) const NEWTON: Self = Self::new("_n", "N", "kN", |_| 1e-3, short);
    pub(super) const NEWTON_SECOND: Self = Self::new("_n_s", "N·s", "kN·s", |_| 1e-3, short);
    pub(super) const ACCELERATION: Self = Self::new("_m_per_s2", "m/s²", "g", f64::recip, short);

    const fn new(suffix: &'static str, symbol: &'static str, shown: &'static str, factor: fn(f64) -> f64, text: fn(f64) -> String) -> Self {
        Self {
            suffix,
            symbol,
            shown,
            factor,
            text,
        }
    }

    /// Converts an SI value to the unit that people read.
    pub fn of(&self, value: f64, gravity: f64) -> f64 {
        value * (self.factor)(gravity)
    }
}
