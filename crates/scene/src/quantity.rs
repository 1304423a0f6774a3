//! The numbers that are printed of a run, and the quantities that they belong to.

/// A printed quantity, or all of them, whose error counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Transferred momentum of every structure.
    Momentum,
    /// Peak displacement of every floor, peak drift of every storey, both at the end, and least opening of every pair.
    Displacement,
    /// Peak absolute acceleration of every floor.
    Acceleration,
    /// Peak shear force of every structure and peak pounding force of every compliant pair.
    Force,
    /// Impulse of the first collision, largest impulse and sum of the impulses of every pair.
    Impulse,
    /// Time of the first collision of every pair, relative to that time, and time for which it touches.
    Time,
    /// All of these, and equal numbers of collisions.
    All,
}

/// A number that is printed of structures or pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Number {
    /// Transferred momentum of a structure.
    Momentum,
    /// Its peak displacement.
    Displacement,
    /// Peak drift of a storey on another floor.
    Drift,
    /// Its displacement at the end.
    LastDisplacement,
    /// Drift at the end of a storey on another floor.
    LastDrift,
    /// Its peak absolute acceleration.
    Acceleration,
    /// Its peak shear force.
    ShearForce,
    /// Number of collisions of a pair.
    Collisions,
    /// Time of its first collision.
    FirstTouch,
    /// Impulse of its first collision.
    FirstImpulse,
    /// Largest impulse of a collision.
    LargestImpulse,
    /// Its peak pounding force.
    PoundingForce,
    /// Sum of its impulses.
    TotalImpulse,
    /// Time for which it touches.
    Touching,
    /// Its least opening.
    LeastOpening,
}

impl Number {
    /// Every printed number.
    pub const ALL: [Self; 15] = [
        Self::Momentum,
        Self::Displacement,
        Self::Drift,
        Self::LastDisplacement,
        Self::LastDrift,
        Self::Acceleration,
        Self::ShearForce,
        Self::Collisions,
        Self::FirstTouch,
        Self::FirstImpulse,
        Self::LargestImpulse,
        Self::PoundingForce,
        Self::TotalImpulse,
        Self::Touching,
        Self::LeastOpening,
    ];

    /// Its name in text.
    pub fn words(self) -> &'static str {
        match self {
            Self::Momentum => "momentum",
            Self::Displacement => "displacement",
            Self::Drift => "storey drift",
            Self::LastDisplacement => "end displacement",
            Self::LastDrift => "end drift",
            Self::Acceleration => "acceleration",
            Self::ShearForce => "shear force",
            Self::Collisions => "collisions",
            Self::FirstTouch => "first touch",
            Self::FirstImpulse => "first impulse",
            Self::LargestImpulse => "largest impulse",
            Self::PoundingForce => "pounding force",
            Self::TotalImpulse => "total impulse",
            Self::Touching => "time of touching",
            Self::LeastOpening => "least opening",
        }
    }

    /// The quantity that it belongs to.
    pub(crate) fn quantity(self) -> Quantity {
        match self {
            Self::Momentum => Quantity::Momentum,
            Self::Displacement
            | Self::Drift
            | Self::LastDisplacement
            | Self::LastDrift
            | Self::LeastOpening => Quantity::Displacement,
            Self::Acceleration => Quantity::Acceleration,
            Self::ShearForce | Self::PoundingForce => Quantity::Force,
            Self::Collisions => Quantity::All,
            Self::FirstTouch | Self::Touching => Quantity::Time,
            Self::FirstImpulse | Self::LargestImpulse | Self::TotalImpulse => Quantity::Impulse,
        }
    }
}
