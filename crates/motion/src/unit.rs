//! Units of accelerations in files.

use strum::EnumCount;

/// An `AccelerationUnit` is the unit of the values in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, EnumCount)]
pub enum AccelerationUnit {
    /// Multiples of the acceleration of gravity, g.
    StandardGravity,
    /// Metres per second squared.
    MetrePerSecondSquared,
    /// Centimetres per second squared, also called gal.
    CentimetrePerSecondSquared,
    /// Millimetres per second squared.
    MillimetrePerSecondSquared,
    /// Thousandths of g.
    MilliG,
    /// Tenths of g, as in old uncorrected accelerograms.
    TenthG,
}

impl AccelerationUnit {
    /// All units in the order of their definition.
    pub const ALL: [Self; Self::COUNT] = [
        Self::StandardGravity,
        Self::MetrePerSecondSquared,
        Self::CentimetrePerSecondSquared,
        Self::MillimetrePerSecondSquared,
        Self::MilliG,
        Self::TenthG,
    ];

    /// Returns the name of the unit in scene files and options.
    pub fn name(self) -> &'static str {
        match self {
            Self::StandardGravity => "g",
            Self::MetrePerSecondSquared => "m_per_s2",
            Self::CentimetrePerSecondSquared => "cm_per_s2",
            Self::MillimetrePerSecondSquared => "mm_per_s2",
            Self::MilliG => "mg",
            Self::TenthG => "g_per_10",
        }
    }

    /// Returns the symbol after a number.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::StandardGravity => "g",
            Self::MetrePerSecondSquared => "m/s²",
            Self::CentimetrePerSecondSquared => "cm/s²",
            Self::MillimetrePerSecondSquared => "mm/s²",
            Self::MilliG => "mg",
            Self::TenthG => "g/10",
        }
    }

    /// Turns a value in this unit into m/s², with one g worth `gravity` \[m/s²\].
    ///
    /// Powers of ten divide: 12.3 cm/s² become exactly the f64 written 0.123.
    pub fn to_si(self, value: f64, gravity: f64) -> f64 {
        match self {
            Self::StandardGravity => value * gravity,
            Self::MetrePerSecondSquared => value,
            Self::CentimetrePerSecondSquared => value / 100.0,
            Self::MillimetrePerSecondSquared => value / 1000.0,
            Self::MilliG => value / 1000.0 * gravity,
            Self::TenthG => value / 10.0 * gravity,
        }
    }

    /// Value of this unit in another unit, with the standard g of 9.80665 m/s².
    pub fn worth_in(self, other: Self) -> f64 {
        if self == other {
            return 1.0;
        }
        self.to_si(1.0, 9.806_65) / other.to_si(1.0, 9.806_65)
    }

    /// Whether the value of the unit depends on g.
    pub(crate) fn needs_gravity(self) -> bool {
        matches!(self, Self::StandardGravity | Self::MilliG | Self::TenthG)
    }

    /// The names of all units for a message.
    pub(crate) fn names() -> String {
        Self::ALL.map(Self::name).join(", ")
    }
}
