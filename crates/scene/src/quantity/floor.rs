//! The table of the numbers of a floor.

use pounding_text::Unit;

use super::{QuantityEntry, QuantityKind, quantities};
use crate::QuantityGroup;

quantities! {
    /// A number of a structure; a building has it for every floor and its storey.
    FloorQuantity, Floor:
    #[serde(skip_deserializing)]
    PeriodS("period_s", "Natural period, of a building the first.") =
        QuantityEntry::new(&Unit::PERIOD, "Period", |run, floor| Some(run.oscillation(floor)?.0)).kind(QuantityKind::Model);
    #[serde(skip_deserializing)]
    DampingRatio("damping_ratio", "Damping ratio, of a building in the first mode.") =
        QuantityEntry::new(&Unit::ONE, "Damping ratio", |run, floor| Some(run.oscillation(floor)?.1)).kind(QuantityKind::Model);
    PeakDisplacementM("peak_displacement_m", "Displacement of largest magnitude, relative to the ground, positive to the right.") =
        QuantityEntry::new(&Unit::METRE, "Peak displacement", |run, floor| Some(run.peaks(floor)?.displacement.value))
            .kind(QuantityKind::Peak).measured(QuantityGroup::Displacement, "displacement");
    PeakDisplacementTimeS("peak_displacement_time_s", "Instant of the peak displacement.") = QuantityEntry {
        absolute: Some("peak_displacement_time_s"),
        ..QuantityEntry::instant(|run, floor| Some(run.peaks(floor)?.displacement.time))
    };
    PeakShearForceN("peak_shear_force_n", "Shear force of largest magnitude, of the columns of the storey alone: the force of the damper is not in it.") =
        QuantityEntry::new(&Unit::NEWTON, "Peak shear", |run, floor| Some(run.peaks(floor)?.column_force().value))
            .kind(QuantityKind::Peak).measured(QuantityGroup::Force, "shear force");
    #[serde(skip_deserializing)]
    PeakShearForceTimeS("peak_shear_force_time_s", "Instant of the peak shear force.") =
        QuantityEntry::instant(|run, floor| Some(run.peaks(floor)?.column_force().time));
    PeakDriftM("peak_drift_m", "Storey drift of largest magnitude; none of a storey on the ground, whose drift is the displacement.") = QuantityEntry {
        on_ground: Some(FloorQuantity::PeakDisplacementM),
        ..QuantityEntry::new(&Unit::METRE, "Peak drift", |run, floor| Some(run.peaks(floor)?.storey_drift?.value))
            .kind(QuantityKind::Peak).measured(QuantityGroup::Displacement, "storey drift")
    };
    #[serde(skip_deserializing)]
    PeakDriftTimeS("peak_drift_time_s", "Instant of the peak drift; none of a storey on the ground.") = QuantityEntry {
        on_ground: Some(FloorQuantity::PeakDisplacementTimeS),
        ..QuantityEntry::instant(|run, floor| Some(run.peaks(floor)?.storey_drift?.time))
    };
    ResidualDisplacementAtEndM("residual_displacement_at_end_m", "Displacement at the end of the run; free vibration that has not died away is in it.") =
        QuantityEntry::new(&Unit::RESIDUAL, "Residual at end", |run, floor| run.moves(floor).then(|| run.last(floor)))
            .kind(QuantityKind::Residual(FloorQuantity::PeakDisplacementM)).measured(QuantityGroup::Displacement, "end displacement");
    ResidualDriftAtEndM("residual_drift_at_end_m", "Storey drift at the end of the run; none of a storey on the ground.") = QuantityEntry {
        on_ground: Some(FloorQuantity::ResidualDisplacementAtEndM),
        ..QuantityEntry::new(&Unit::RESIDUAL, "Residual at end", |run, floor| Some(run.last(floor) - run.last(run.below(floor)?)))
            .kind(QuantityKind::Residual(FloorQuantity::PeakDriftM)).measured(QuantityGroup::Displacement, "end drift")
    };
    PeakAccelerationMPerS2("peak_acceleration_m_per_s2", "Absolute acceleration of largest magnitude, without impulsive impacts.") =
        QuantityEntry::new(&Unit::ACCELERATION, "Peak acceleration", |run, floor| Some(run.acceleration(floor)?.value))
            .kind(QuantityKind::Peak).measured(QuantityGroup::Acceleration, "acceleration");
    #[serde(skip_deserializing)]
    PeakAccelerationTimeS("peak_acceleration_time_s", "Instant of the peak acceleration.") =
        QuantityEntry::instant(|run, floor| Some(run.acceleration(floor)?.time));
    Ductility("ductility", "Peak drift over yield drift; only of columns that can yield.") = QuantityEntry {
        error_of: Some(FloorQuantity::PeakDriftM),
        ..QuantityEntry::new(&Unit::ONE, "Ductility", |run, floor| run.floor(floor).ductility(run.peaks(floor)?.drift().value))
    };
    DriftRatio("drift_ratio", "Peak drift over storey height; only if the height is given. Of a whole building without its isolators.") = QuantityEntry {
        error_of: Some(FloorQuantity::PeakDriftM),
        ..QuantityEntry::new(&Unit::PART, "Drift ratio", |run, floor| run.floor(floor).drift_ratio(run.peaks(floor)?.drift().value))
    };
    #[serde(skip_deserializing)]
    BaseShearRatio("base_shear_ratio", "Peak shear force of the lowest storey over the weight of its structure.") =
        QuantityEntry::new(&Unit::RATIO, "V/W", |run, floor| run.simulation.base_shear(run.result, floor));
    #[serde(skip_deserializing)]
    DamperForceRatio("damper_force_ratio", "Peak force of the damper of the storey over its yield force; only of columns that can yield.") =
        QuantityEntry::new(&Unit::PART, "Damper / yield", |run, floor| {
            Some(run.damper_force(floor)? / run.floor(floor).made_of?.columns.yield_force_n?)
        });
    #[serde(skip_deserializing)]
    MassDampingRatio("mass_damping_ratio", "Damping ratio of the mass-proportional damping at the period of the secant stiffnesses; of a building, with its lowest storey.") =
        QuantityEntry::new(&Unit::PART, "Mass damping", |run, floor| Some(run.mass_damping(floor)?.ratio));
    UnstableS("unstable_s", "First instant at which the drift of the storey passes its unstable equilibrium under gravity.") =
        QuantityEntry::new(&Unit::SECOND, "Unstable", |run, floor| run.peaks(floor)?.unstable)
            .kind(QuantityKind::First).measured(QuantityGroup::Time, "unstable equilibrium");
    CollapseS("collapse_s", "Instant at which the storey collapses under gravity, which ends the run.") =
        QuantityEntry::new(&Unit::SECOND, "Collapse", |run, floor| Some(run.result.collapse.filter(|one| one.floor == floor)?.time_s))
            .kind(QuantityKind::First).measured(QuantityGroup::Time, "collapse");
    TransferredMomentumNS("transferred_momentum_n_s", "Sum of the impulses from the neighbours, by magnitude.") = QuantityEntry {
        least: |run, _| run.least_momentum(),
        ..QuantityEntry::new(&Unit::NEWTON_SECOND, "Transferred momentum", |run, floor| Some(run.result.momentum.of(floor)))
            .kind(QuantityKind::Total).measured(QuantityGroup::Momentum, "momentum")
    };
}
