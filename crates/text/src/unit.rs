//! Units of numbers, and their texts for people.

use crate::{digits, instant, percent, rounded_up, short, two_decimals, two_digits};

/// A unit, and the one in which people read its numbers.
#[derive(Debug)]
pub struct Unit {
    /// How names in files end.
    pub suffix: &'static str,
    /// Its symbol in documents.
    pub symbol: &'static str,
    /// The unit that people read; empty if they read none.
    pub shown: &'static str,
    /// How many of the units that people read are one SI unit, by the acceleration of gravity \[m/s²\].
    factor: fn(f64) -> f64,
    /// Makes the text for people.
    text: fn(f64) -> String,
}

impl Unit {
    /// A number without a unit, in four digits.
    pub const ONE: Self = Self::new("", "–", "", |_| 1.0, short);
    /// A number without a unit, in two decimals.
    pub const RATIO: Self = Self::ONE.read(two_decimals);
    /// A part, in per cent.
    pub const PART: Self = Self::ONE.read(percent);
    /// A part, in whole per cent.
    pub const WHOLE_PERCENT: Self = Self::ONE.read(|part| format!("{:.0} %", 100.0 * part));
    /// A whole number.
    pub const COUNT: Self = Self::ONE.read(|count| count.to_string());
    /// An instant, to a tenth of a millisecond.
    pub const SECOND: Self = Self::new("_s", "s", "s", |_| 1.0, instant);
    /// A time, in four digits.
    pub const PERIOD: Self = Self::SECOND.read(short);
    /// A short time, in milliseconds.
    pub const MILLISECOND: Self = Self::new("_s", "s", "ms", |_| 1e3, short);
    /// A length, in millimetres.
    pub const METRE: Self = Self::new("_m", "m", "mm", |_| 1e3, short);
    /// A gap as its user wrote it, in millimetres.
    pub const GAP: Self = Self::METRE.read(digits);
    /// A width, to a tenth of a millimetre.
    pub const WIDTH: Self = Self::METRE.read(|millimetres| digits((millimetres * 10.0).round() / 10.0));
    /// A width that is needed: rounded up to a tenth of a millimetre.
    pub const NEEDED: Self = Self::METRE.read(|millimetres| {
        let up = rounded_up(millimetres, 1);
        up.parse().map_or(up, digits)
    });
    /// A residual of a displacement: 0 if nobody could measure it in a building, below 0.1 mm.
    pub const RESIDUAL: Self = Self::METRE.read(|millimetres| if millimetres.abs() < 0.1 { "0".into() } else { short(millimetres) });
    /// A force, in kilonewtons.
    pub const NEWTON: Self = Self::new("_n", "N", "kN", |_| 1e-3, short);
    /// A pounding force: it depends on an impact stiffness that is not known, so two digits.
    pub const POUNDING_FORCE: Self = Self::NEWTON.read(two_digits);
    /// A bending moment that is known to two digits.
    pub const MOMENT: Self = Self::new("_nm", "N·m", "kN·m", |_| 1e-3, two_digits);
    /// An impulse.
    pub const NEWTON_SECOND: Self = Self::new("_n_s", "N·s", "kN·s", |_| 1e-3, short);
    /// A speed.
    pub const SPEED: Self = Self::new("_m_per_s", "m/s", "m/s", |_| 1.0, short);
    /// A frequency.
    pub const HERTZ: Self = Self::new("_hz", "Hz", "Hz", |_| 1.0, short);
    /// A speed that is known to two digits.
    pub const ROUGH_SPEED: Self = Self::SPEED.read(two_digits);
    /// An energy.
    pub const ENERGY: Self = Self::new("_j", "J", "kJ", |_| 1e-3, short);
    /// An acceleration, in parts of that of gravity.
    pub const ACCELERATION: Self = Self::new("_m_per_s2", "m/s²", "g", f64::recip, short);

    const fn new(suffix: &'static str, symbol: &'static str, shown: &'static str, factor: fn(f64) -> f64, text: fn(f64) -> String) -> Self {
        Self {
            suffix,
            symbol,
            shown,
            factor,
            text,
        }
    }

    /// The unit with another text, which `text` makes of a number in the unit that people read.
    #[must_use]
    pub const fn read(self, text: fn(f64) -> String) -> Self {
        Self { text, ..self }
    }

    /// The function that makes a text of a number in the unit that people read.
    pub const fn reader(&self) -> fn(f64) -> String {
        self.text
    }

    /// An SI value in the unit that people read, by the acceleration of gravity \[m/s²\].
    pub fn of(&self, value: f64, gravity: f64) -> f64 {
        value * (self.factor)(gravity)
    }

    /// An SI value in words, by the acceleration of gravity \[m/s²\].
    pub fn text_of(&self, value: f64, gravity: f64) -> String {
        (self.text)(self.of(value, gravity))
    }
}
