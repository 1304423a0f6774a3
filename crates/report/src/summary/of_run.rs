//! What a run left behind, turned into its summary.

use pounding_solver::Collision;

use super::{
    CollisionSummary, LedgerSummary, MethodSummary, PairErrorSummary, PairSummary, ReadingSummary, RecordSummary, SCHEMA_VERSION,
    StructureErrorSummary, StructureSummary, Summary, WorkSummary,
};
use crate::sampling::Sampling;
use pounding_scene::{Errors, FloorQuantity, PairOutcome, PairQuantity, QuantityGroup, Review, RunErrors, Simulation, Source};

impl Summary {
    /// Of a run, with what is known of its errors.
    pub fn of(prepared: &Simulation, review: &Review) -> Self {
        Self {
            schema_version: SCHEMA_VERSION,
            version: env!("CARGO_PKG_VERSION").into(),
            scene: prepared.scene().clone(),
            method: method(prepared, &review.errors),
            record: RecordSummary::of(prepared),
            structures: StructureSummary::of_run(prepared, review),
            pairs: PairSummary::of_run(prepared, review),
            effects: None,
            ledger: LedgerSummary::of(&review.balance),
            work: WorkSummary::of(&review.outcome.work),
            unusual: prepared.doubts(),
            warnings: review.notices(),
        }
    }
}

impl RecordSummary {
    /// Of a scene, which need not have run.
    pub fn of(prepared: &Simulation) -> Self {
        let record = prepared.record();
        let file = match &prepared.scene().record.source {
            Source::File(file) => Some(file.file.clone()),
            Source::Generated(_) => None,
        };
        let origin = prepared.origin();
        let read = |reading: &pounding_motion::Reading| ReadingSummary {
            what: reading.what.into(),
            line: reading.line,
            found: reading.found.clone(),
        };
        let (peak_time_s, peak_m_per_s2) = record.peak();
        Self {
            file,
            sha256: origin.map(|origin| origin.sha256.clone()),
            format: origin.map(|origin| origin.file.format().name().into()),
            unit: origin.map(|origin| origin.file.unit().symbol().into()),
            scale_factor: prepared.scale(),
            samples: record.samples().len(),
            time_step_s: record.time_step(),
            // A negative zero loses its sign.
            peak_m_per_s2: peak_m_per_s2 + 0.0,
            peak_time_s,
            provenance: record.source().into(),
            processing: prepared.scene().record.processing(),
            readings: origin.map_or_else(Vec::new, |origin| origin.file.readings().iter().map(read).collect()),
        }
    }
}

impl StructureSummary {
    /// Of every structure and wall, from left to right.
    pub fn of_run(prepared: &Simulation, review: &Review) -> Vec<Self> {
        let floors = 0..prepared.floors().all().len();
        let measured = review.measured();
        floors.map(|index| structure(prepared, review, index, measured)).collect()
    }
}

impl PairSummary {
    /// Of every pair that can touch, from left to right.
    pub fn of_run(prepared: &Simulation, review: &Review) -> Vec<Self> {
        let pairs = 0..prepared.floors().facing().len();
        let measured = review.measured();
        pairs.map(|index| pair(prepared, review, (index, measured))).collect()
    }
}

fn method(prepared: &Simulation, errors: &Errors) -> MethodSummary {
    let method = prepared.method();
    let (known, largest) = match errors {
        Errors::Exact => ("exact", None),
        Errors::NotMeasured => ("not_measured", None),
        Errors::Doubtful | Errors::Unknown(_) => ("unknown", None),
        Errors::Measured(errors, _) => ("measured", finite(errors.largest(QuantityGroup::All).0)),
    };
    MethodSummary {
        name: method.name().into(),
        time_step_s: method.time_step(),
        duration_s: prepared.duration(),
        history_interval_s: Sampling::of(prepared).interval,
        chosen_for_error: prepared.advice().map(|advice| advice.goal.error),
        errors: known.into(),
        largest_error: largest,
    }
}

fn structure(prepared: &Simulation, review: &Review, index: usize, measured: Option<&RunErrors>) -> StructureSummary {
    let floor = &prepared.floors().all()[index];
    let errors = measured.map(|errors| structure_errors(errors, index));
    let common = StructureSummary {
        name: floor.name.clone(),
        storey: floor.storey,
        transferred_momentum_n_s: review.outcome.momentum.of(index),
        errors,
        ..StructureSummary::default()
    };
    let Some((period, damping_ratio)) = floor.oscillation(prepared.scene()) else {
        return common;
    };
    let peaks = review.outcome.peaks.of(index);
    let displacement = peaks.displacement.value;
    let drift = peaks.drift();
    let acceleration = review.outcome.accelerations[index];
    // A negative zero loses its sign.
    let last = |index| review.outcome.last.of(index).displacement + 0.0;
    let upper = floor.is_upper();
    StructureSummary {
        period_s: Some(period),
        damping_ratio: Some(damping_ratio),
        peak_displacement_m: Some(displacement),
        peak_displacement_time_s: Some(peaks.displacement.time),
        peak_shear_force_n: Some(peaks.restoring_force.value),
        peak_shear_force_time_s: Some(peaks.restoring_force.time),
        peak_drift_m: upper.then_some(drift.value),
        peak_drift_time_s: upper.then_some(drift.time),
        residual_displacement_at_end_m: Some(last(index)),
        residual_drift_at_end_m: prepared.floors().below(index).map(|below| last(index) - last(below)),
        peak_acceleration_m_per_s2: Some(acceleration.value),
        peak_acceleration_time_s: Some(acceleration.time),
        ductility: floor.ductility(drift.value),
        drift_ratio: floor.drift_ratio(drift.value),
        ..common
    }
}

fn structure_errors(errors: &RunErrors, floor: usize) -> StructureErrorSummary {
    let known = |quantity: FloorQuantity| errors.at(quantity, floor).and_then(finite);
    StructureErrorSummary {
        peak_displacement: known(FloorQuantity::PeakDisplacementM),
        peak_displacement_time_s: known(FloorQuantity::PeakDisplacementTimeS),
        peak_drift: known(FloorQuantity::PeakDriftM),
        residual_displacement_at_end: known(FloorQuantity::ResidualDisplacementAtEndM),
        residual_drift_at_end: known(FloorQuantity::ResidualDriftAtEndM),
        peak_acceleration: known(FloorQuantity::PeakAccelerationMPerS2),
        peak_shear_force: known(FloorQuantity::PeakShearForceN),
        transferred_momentum: known(FloorQuantity::TransferredMomentumNS),
    }
}

fn pair(prepared: &Simulation, review: &Review, (index, measured): (usize, Option<&RunErrors>)) -> PairSummary {
    let own = &prepared.pairs()[index];
    let found = review.outcome.of_pair(index);
    let opening = review.outcome.least_opening(own, &found);
    let (opening, time) = opening.expect("a review asks for closings");
    let PairOutcome {
        collisions,
        first,
        largest,
        peak_force,
        ..
    } = found;
    let [left, right] = prepared.floors().names(index);
    PairSummary {
        left,
        right,
        gap_m: own.gap(),
        law: own.law.name().into(),
        collisions,
        first: first.as_ref().map(collision),
        largest: largest.as_ref().map(collision),
        peak_force_n: peak_force.map(|peak| peak.value),
        peak_force_time_s: peak_force.map(|peak| peak.time),
        total_impulse_n_s: found.total_impulse,
        touching_s: found.touching,
        leaning: found.leaning().as_ref().map(collision),
        least_opening_m: opening,
        least_opening_time_s: time,
        errors: measured.map(|errors| pair_errors(errors, index)),
    }
}

fn collision(one: &Collision) -> CollisionSummary {
    CollisionSummary {
        start_s: one.start,
        end_s: one.end,
        impulse_n_s: one.impulse,
        peak_force_n: one.peak_force,
        peak_force_time_s: one.peak_force_time,
    }
}

fn pair_errors(errors: &RunErrors, pair: usize) -> PairErrorSummary {
    let known = |quantity: PairQuantity| errors.at(quantity, pair).and_then(finite);
    let of_pair = &errors.pairs()[pair];
    PairErrorSummary {
        exact_collisions: of_pair.collisions[1],
        rests: of_pair.rests,
        first_time_s: of_pair.first_start_s.and_then(finite),
        first_impulse: known(PairQuantity::FirstImpulseNS),
        largest_impulse: known(PairQuantity::LargestImpulseNS),
        peak_force: known(PairQuantity::PeakForceN),
        total_impulse: known(PairQuantity::TotalImpulseNS),
        touching: known(PairQuantity::TouchingS),
        least_opening: known(PairQuantity::LeastOpeningM),
    }
}

/// JSON has no infinity.
fn finite(error: f64) -> Option<f64> {
    error.is_finite().then_some(error)
}
