//! The numbers of a run that become columns, in the names of a summary.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use pounding_scene::{PairOutcome, RunResult, Simulation};

/// A number of a structure; of a building one of every floor and its storey.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StructureQuantity {
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
    /// Least opening of the gap \[m\]; 0 or less where they touch.
    LeastOpeningM,
}

/// A run whose numbers are asked for.
pub(super) struct Ran<'a> {
    pub(super) prepared: &'a Simulation,
    pub(super) outcome: &'a RunResult,
}

impl StructureQuantity {
    /// Whether it is the value of largest magnitude of something that goes to both sides.
    pub(super) fn is_peak(self) -> bool {
        match self {
            Self::PeakDisplacementM
            | Self::PeakShearForceN
            | Self::PeakDriftM
            | Self::PeakAccelerationMPerS2 => true,
            Self::PeakDisplacementTimeS
            | Self::ResidualDisplacementAtEndM
            | Self::Ductility
            | Self::DriftRatio
            | Self::TransferredMomentumNS => false,
        }
    }

    /// Whether it is left over of a peak displacement, and may be next to nothing beside it.
    pub(super) fn is_left_over(self) -> bool {
        self == Self::ResidualDisplacementAtEndM
    }

    /// Of a floor; nothing where it has no such number.
    pub(super) fn of(self, ran: &Ran<'_>, index: usize) -> Option<f64> {
        let floor = &ran.prepared.floors().all()[index];
        if matches!(self, Self::TransferredMomentumNS) {
            return Some(ran.outcome.momentum.of(index));
        }
        if floor.is_wall() {
            return None;
        }
        let peaks = ran.outcome.peaks.of(index);
        match self {
            Self::PeakDisplacementM => Some(peaks.displacement.value),
            Self::PeakDisplacementTimeS => Some(peaks.displacement.time),
            Self::PeakShearForceN => Some(peaks.restoring_force.value),
            Self::PeakDriftM => {
                let upper = floor.storey.is_some_and(|storey| storey > 1);
                upper.then_some(peaks.drift().value)
            }
            // A negative zero loses its sign.
            Self::ResidualDisplacementAtEndM => Some(ran.outcome.last.of(index) + 0.0),
            Self::PeakAccelerationMPerS2 => Some(ran.outcome.accelerations[index].value),
            Self::Ductility => floor.ductility(peaks.drift().value),
            Self::DriftRatio => floor.drift_ratio(peaks.drift().value),
            Self::TransferredMomentumNS => Some(ran.outcome.momentum.of(index)),
        }
    }
}

impl PairQuantity {
    /// Whether closings have to be recorded for it.
    pub(super) fn needs_closings(self) -> bool {
        self == Self::LeastOpeningM
    }

    /// As for a [structure](StructureQuantity::is_left_over).
    pub(super) fn is_left_over(self) -> bool {
        self == Self::LeastOpeningM
    }

    /// Of a pair, of which `found` happened; nothing where it has no such number.
    pub(super) fn of(self, ran: &Ran<'_>, (index, found): (usize, &PairOutcome)) -> Option<f64> {
        match self {
            Self::Collisions => Some(found.collisions as f64),
            Self::FirstStartS => found.first.map(|first| first.start),
            Self::FirstImpulseNS => found.first.map(|first| first.impulse),
            Self::LargestImpulseNS => found.largest.map(|largest| largest.impulse),
            Self::PeakForceN => found.peak_force.map(|peak| peak.value),
            Self::TotalImpulseNS => Some(found.total_impulse),
            Self::LeastOpeningM => {
                let pair = &ran.prepared.pairs()[index];
                Some(ran.outcome.least_opening(pair, found)?.0)
            }
        }
    }
}

/// Name of a quantity, as files spell it.
pub(super) fn name(quantity: &impl Serialize) -> String {
    let name = serde_json::to_value(quantity).unwrap_or_default();
    name.as_str().unwrap_or_default().into()
}
