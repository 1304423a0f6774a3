//! The numbers that a run gives of every floor and every pair, under the names that files spell.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A number of a structure; of a building one of every floor and its storey.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FloorQuantity {
    /// Displacement of largest magnitude, relative to the ground, positive to the right \[m\].
    PeakDisplacementM,
    /// Its instant \[s\].
    PeakDisplacementTimeS,
    /// Shear force of largest magnitude \[N\].
    PeakShearForceN,
    /// Drift of largest magnitude of a storey on another floor \[m\].
    PeakDriftM,
    /// Displacement at the end of the run \[m\].
    ResidualDisplacementAtEndM,
    /// Drift at the end of the run of a storey on another floor \[m\].
    ResidualDriftAtEndM,
    /// Absolute acceleration of largest magnitude \[m/s²\], without impulsive impacts.
    #[serde(rename = "peak_acceleration_m_per_s2")]
    PeakAccelerationMPerS2,
    /// Peak drift over the drift at yielding \[–\]; of columns that can yield.
    Ductility,
    /// Peak drift over the height of the storey \[–\]; where the scene gives the height.
    DriftRatio,
    /// Sum of the impulses from the neighbours, by magnitude \[N·s\].
    TransferredMomentumNS,
}

/// A number of two neighbours that can touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PairQuantity {
    /// Number of collisions, each from touch to parting; of impacts every bounce, the last one with the rest that follows.
    Collisions,
    /// When the first begins \[s\].
    FirstStartS,
    /// Its impulse \[N·s\].
    FirstImpulseNS,
    /// The largest impulse of a collision \[N·s\].
    LargestImpulseNS,
    /// Largest pounding force \[N\]; of laws that have one.
    PeakForceN,
    /// Sum of all impulses \[N·s\].
    TotalImpulseNS,
    /// Time for which they touch, all collisions together \[s\].
    TouchingS,
    /// Least opening of the gap \[m\]; 0 or less where they touch.
    LeastOpeningM,
}

/// A number that a run gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Of every floor.
    Floor(FloorQuantity),
    /// Of every pair.
    Pair(PairQuantity),
}

/// Quantities whose errors count together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum QuantityGroup {
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

impl QuantityGroup {
    /// Every group.
    pub const EVERY: [Self; 7] = [
        Self::Momentum,
        Self::Displacement,
        Self::Acceleration,
        Self::Force,
        Self::Impulse,
        Self::Time,
        Self::All,
    ];

    /// Its name, as users write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Momentum => "momentum",
            Self::Displacement => "displacement",
            Self::Acceleration => "acceleration",
            Self::Force => "force",
            Self::Impulse => "impulse",
            Self::Time => "time",
            Self::All => "all",
        }
    }
}

impl From<FloorQuantity> for Quantity {
    fn from(quantity: FloorQuantity) -> Self {
        Self::Floor(quantity)
    }
}

impl From<PairQuantity> for Quantity {
    fn from(quantity: PairQuantity) -> Self {
        Self::Pair(quantity)
    }
}

impl FloorQuantity {
    /// Whether it is the value of largest magnitude of something that goes to both sides.
    pub fn is_peak(self) -> bool {
        match self {
            Self::PeakDisplacementM | Self::PeakShearForceN | Self::PeakDriftM | Self::PeakAccelerationMPerS2 => true,
            Self::PeakDisplacementTimeS
            | Self::ResidualDisplacementAtEndM
            | Self::ResidualDriftAtEndM
            | Self::Ductility
            | Self::DriftRatio
            | Self::TransferredMomentumNS => false,
        }
    }

    /// Of what is left over of a peak, and may be next to nothing beside it, that peak.
    pub fn left_over_of(self) -> Option<Self> {
        match self {
            Self::ResidualDisplacementAtEndM => Some(Self::PeakDisplacementM),
            Self::ResidualDriftAtEndM => Some(Self::PeakDriftM),
            Self::PeakDisplacementM
            | Self::PeakDisplacementTimeS
            | Self::PeakShearForceN
            | Self::PeakDriftM
            | Self::PeakAccelerationMPerS2
            | Self::Ductility
            | Self::DriftRatio
            | Self::TransferredMomentumNS => None,
        }
    }
}

impl Quantity {
    /// Whether it is the value of largest magnitude of something that goes to both sides.
    pub fn is_peak(self) -> bool {
        match self {
            Self::Floor(quantity) => quantity.is_peak(),
            Self::Pair(_) => false,
        }
    }

    /// Every number whose errors are measured; ductility and drift ratio have that of the drift, instants of peaks jump where two
    /// peaks are nearly equal.
    pub const COMPARED: [Self; 15] = [
        Self::Floor(FloorQuantity::TransferredMomentumNS),
        Self::Floor(FloorQuantity::PeakDisplacementM),
        Self::Floor(FloorQuantity::PeakDriftM),
        Self::Floor(FloorQuantity::ResidualDisplacementAtEndM),
        Self::Floor(FloorQuantity::ResidualDriftAtEndM),
        Self::Floor(FloorQuantity::PeakAccelerationMPerS2),
        Self::Floor(FloorQuantity::PeakShearForceN),
        Self::Pair(PairQuantity::Collisions),
        Self::Pair(PairQuantity::FirstStartS),
        Self::Pair(PairQuantity::FirstImpulseNS),
        Self::Pair(PairQuantity::LargestImpulseNS),
        Self::Pair(PairQuantity::PeakForceN),
        Self::Pair(PairQuantity::TotalImpulseNS),
        Self::Pair(PairQuantity::TouchingS),
        Self::Pair(PairQuantity::LeastOpeningM),
    ];

    /// Its name in text.
    pub fn words(self) -> &'static str {
        match self {
            Self::Floor(quantity) => match quantity {
                FloorQuantity::TransferredMomentumNS => "momentum",
                FloorQuantity::PeakDisplacementM => "displacement",
                FloorQuantity::PeakDisplacementTimeS => "time of the peak displacement",
                FloorQuantity::PeakDriftM => "storey drift",
                FloorQuantity::ResidualDisplacementAtEndM => "end displacement",
                FloorQuantity::ResidualDriftAtEndM => "end drift",
                FloorQuantity::PeakAccelerationMPerS2 => "acceleration",
                FloorQuantity::PeakShearForceN => "shear force",
                FloorQuantity::Ductility => "ductility",
                FloorQuantity::DriftRatio => "drift ratio",
            },
            Self::Pair(quantity) => match quantity {
                PairQuantity::Collisions => "collisions",
                PairQuantity::FirstStartS => "first touch",
                PairQuantity::FirstImpulseNS => "first impulse",
                PairQuantity::LargestImpulseNS => "largest impulse",
                PairQuantity::PeakForceN => "pounding force",
                PairQuantity::TotalImpulseNS => "total impulse",
                PairQuantity::TouchingS => "time of touching",
                PairQuantity::LeastOpeningM => "least opening",
            },
        }
    }

    /// The group that its error counts in.
    pub(crate) fn group(self) -> QuantityGroup {
        match self {
            Self::Floor(quantity) => match quantity {
                FloorQuantity::TransferredMomentumNS => QuantityGroup::Momentum,
                FloorQuantity::PeakDisplacementM
                | FloorQuantity::PeakDriftM
                | FloorQuantity::ResidualDisplacementAtEndM
                | FloorQuantity::ResidualDriftAtEndM
                | FloorQuantity::Ductility
                | FloorQuantity::DriftRatio => QuantityGroup::Displacement,
                FloorQuantity::PeakDisplacementTimeS => QuantityGroup::Time,
                FloorQuantity::PeakAccelerationMPerS2 => QuantityGroup::Acceleration,
                FloorQuantity::PeakShearForceN => QuantityGroup::Force,
            },
            Self::Pair(quantity) => match quantity {
                PairQuantity::Collisions => QuantityGroup::All,
                PairQuantity::FirstStartS | PairQuantity::TouchingS => QuantityGroup::Time,
                PairQuantity::FirstImpulseNS | PairQuantity::LargestImpulseNS | PairQuantity::TotalImpulseNS => QuantityGroup::Impulse,
                PairQuantity::PeakForceN => QuantityGroup::Force,
                PairQuantity::LeastOpeningM => QuantityGroup::Displacement,
            },
        }
    }
}
