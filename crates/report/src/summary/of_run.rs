//! What a run left behind, turned into its summary.

use pounding_motion::Reading;
use pounding_solver::Collision;

use super::{
    CollapseSummary, CollisionSummary, ErrorSummary, LedgerSummary, LinkSummary, MethodSummary, Numbers, PairErrorSummary, PairSummary,
    ReadingSummary, RecordSummary, SCHEMA_VERSION, StructureSummary, Summary, WorkSummary,
};
use crate::sampling::Sampling;
use pounding_scene::{
    Errors, Floor, FloorQuantity, Link, LinkQuantity, PairQuantity, QuantityGroup, Review, RunResult, Simulation, Source,
};

impl Summary {
    /// The summary of a run, with its errors if they are known.
    pub fn of(prepared: &Simulation, review: &Review) -> Self {
        Self {
            schema_version: SCHEMA_VERSION,
            version: env!("CARGO_PKG_VERSION").into(),
            scene: prepared.scene().clone(),
            method: method(prepared, &review.errors),
            record: RecordSummary::of(prepared),
            structures: StructureSummary::of_run(prepared, review),
            pairs: PairSummary::of_run(prepared, review),
            links: LinkSummary::of_run(prepared, review),
            effects: None,
            collapse: CollapseSummary::of_run(prepared, &review.outcome),
            between_samples: None,
            ledger: LedgerSummary::of(&review.balance),
            work: WorkSummary::of(&review.outcome.work),
            unusual: prepared.doubts(),
            warnings: review.notices(),
        }
    }
}

impl CollapseSummary {
    /// The collapse that ended a run; `None` if all storeys stand.
    pub fn of_run(prepared: &Simulation, outcome: &RunResult) -> Option<Self> {
        let collapse = outcome.collapse?;
        Some(Self {
            structure: prepared.floors().structures()[collapse.structure].clone(),
            storey: collapse.storey,
            time_s: collapse.time_s,
        })
    }
}

impl RecordSummary {
    /// The record of a scene, which need not have run.
    pub fn of(prepared: &Simulation) -> Self {
        let record = prepared.record();
        let file = match &prepared.scene().record.source {
            Source::File(file) => Some(file.file.clone()),
            Source::Generated(_) => None,
        };
        let origin = prepared.origin();
        let (pga_time_s, peak_m_per_s2) = record.peak();
        Self {
            file,
            sha256: origin.map(|origin| origin.sha256.clone()),
            format: origin.map(|origin| origin.file.format().name().into()),
            unit: origin.map(|origin| origin.file.unit().name().into()),
            scale_factor: prepared.scale(),
            n_samples: record.samples().len(),
            time_step_s: record.time_step(),
            // A negative zero loses its sign.
            peak_m_per_s2: peak_m_per_s2 + 0.0,
            pga_time_s,
            provenance: record.source().into(),
            processing: prepared.scene().record.processing(),
            readings: origin.map_or_else(Vec::new, |origin| origin.file.readings().iter().map(ReadingSummary::from).collect()),
        }
    }
}

impl From<&Reading> for ReadingSummary {
    fn from(reading: &Reading) -> Self {
        Self {
            what: reading.what.into(),
            line: reading.line,
            found: reading.found.clone(),
        }
    }
}

impl StructureSummary {
    /// Of every structure and wall, from left to right.
    pub fn of_run(prepared: &Simulation, review: &Review) -> Vec<Self> {
        let values = review.outcome.values(prepared);
        let all = || FloorQuantity::ALL.iter().map(|one| (*one).into());
        let of = |(place, floor): (usize, &Floor)| Self {
            name: floor.name.clone(),
            storey: floor.storey,
            numbers: Numbers::of(&values, (all(), place)),
            errors: review.measured().map(|errors| ErrorSummary::of(errors, (all(), place))),
        };
        prepared.floors().all().iter().enumerate().map(of).collect()
    }
}

impl PairSummary {
    /// Of every pair that can touch, from left to right.
    pub fn of_run(prepared: &Simulation, review: &Review) -> Vec<Self> {
        let values = review.outcome.values(prepared);
        let all = || PairQuantity::ALL.iter().map(|one| (*one).into());
        let of = |place: usize| {
            let found = review.outcome.of_pair(place);
            let [left, right] = prepared.floors().names(place);
            Self {
                left,
                right,
                law: prepared.pairs()[place].law.name().into(),
                numbers: Numbers::of(&values, (all(), place)),
                first: found.first.as_ref().map(collision),
                largest: found.largest.as_ref().map(collision),
                leaning: review.outcome.leaning(prepared, place).as_ref().map(collision),
                errors: review.measured().map(|errors| PairErrorSummary {
                    exact_collisions: errors.pairs()[place].collisions[1],
                    rests: errors.pairs()[place].rests,
                    errors: ErrorSummary::of(errors, (all(), place)),
                }),
            }
        };
        (0..prepared.floors().facing().len()).map(of).collect()
    }
}

impl LinkSummary {
    /// Of every link, in the order of the scene.
    pub fn of_run(prepared: &Simulation, review: &Review) -> Vec<Self> {
        let values = review.outcome.values(prepared);
        let all = || LinkQuantity::ALL.iter().map(|one| (*one).into());
        let scene = prepared.scene();
        let of = |(place, link): (usize, &Link)| {
            let [left, right] = link.names(scene);
            Self {
                left,
                right,
                law: link.law.name().into(),
                numbers: Numbers::of(&values, (all(), place)),
            }
        };
        scene.links.iter().enumerate().map(of).collect()
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

fn collision(one: &Collision) -> CollisionSummary {
    CollisionSummary {
        start_s: one.start,
        end_s: one.end,
        impulse_n_s: one.impulse,
        peak_force_n: one.peak_force,
        peak_force_time_s: one.peak_force_time,
    }
}

/// JSON has no infinity.
fn finite(error: f64) -> Option<f64> {
    error.is_finite().then_some(error)
}
