//! Ground motions as they shake the scenes, with a table of their properties.

use crate::StudyError;
use crate::study::other_motions::{BeyondSettings, ListedMotion, Strength};
use pounding_assess::SuiteMotion;
use pounding_motion::Record;
use pounding_scene::file::ScaleTo;
use pounding_scene::{GroundMotion, Method, RecordUse, Refused, Scene, response_spectrum};
use pounding_text::Table;
use std::path::Path;

/// Damping ratio of the spectral accelerations in tables and figures \[–\].
pub(super) const DAMPING: f64 = 0.05;

/// A ground motion as it shakes the scenes, in the direction of its record.
#[derive(Debug, Clone)]
pub(crate) struct Shaking {
    pub(crate) name: String,
    /// The motion's file or formula.
    origin: String,
    pub(super) record: Record,
    /// Factor that made the motion as strong as the first \[–\].
    factor: f64,
    /// Duration of the runs \[s\].
    pub(crate) duration: f64,
}

/// A measure of strength with its value for the first motion \[m/s²\]; the other motions are scaled to it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Target(Strength, f64);

impl Target {
    /// The strength of the first motion; `None` if the study does not scale.
    ///
    /// # Errors
    /// [`Refused`] if the spectral acceleration cannot be computed.
    pub(super) fn of(settings: &BeyondSettings, first: &Shaking) -> Result<Option<Self>, Refused> {
        let value = |strength| match strength {
            Strength::Pga => Ok(first.record.peak().1.abs()),
            Strength::Sa { period_s, damping_ratio } => sa(&first.record, period_s, damping_ratio),
        };
        let target = settings.scaled_by.map(|strength| Ok(Self(strength, value(strength)?)));
        target.transpose()
    }

    /// The target in the form of a scene; `gravity` is the value of one g \[m/s²\].
    fn scale_to(self, gravity: f64) -> ScaleTo {
        let Self(strength, value) = self;
        match strength {
            Strength::Pga => ScaleTo::PgaG(value / gravity),
            Strength::Sa { period_s, damping_ratio } => ScaleTo::Sa {
                period_s,
                damping_ratio,
                sa_g: value / gravity,
            },
        }
    }

    /// The record scaled to this target, unless it names its own target.
    fn on(self, record: &RecordUse) -> RecordUse {
        let mut record = record.clone();
        let scale_to = self.scale_to(record.gravity_m_per_s2);
        record.scale_to.get_or_insert(scale_to);
        record
    }
}

impl Shaking {
    /// A motion of a list; `base` is the folder that its file name is relative to.
    ///
    /// # Errors
    /// Those of [`GroundMotion::of`].
    pub(super) fn listed(
        motion: &ListedMotion,
        base: &Path,
        settings: &BeyondSettings,
        target: Option<Target>,
    ) -> Result<Self, StudyError> {
        let read = |record: &RecordUse| -> Result<_, StudyError> { Ok(GroundMotion::of(record, base, &motion.name)?.record) };
        let plain = read(&motion.record)?;
        let scaled = target.map(|target| read(&target.on(&motion.record)));
        let origin = motion.record.source.to_string();
        let mut shaking = Self::of(motion.name.clone(), origin, plain, scaled, settings)?;
        if let Some(duration) = motion.duration_s {
            shaking.duration = duration;
        }
        Ok(shaking)
    }

    /// A motion of a folder. `like` gives the value of one g, and everything that a file leaves out.
    ///
    /// # Errors
    /// Those of [`SuiteMotion::shake`].
    pub(super) fn of_folder(
        motion: &SuiteMotion,
        like: &Scene,
        settings: &BeyondSettings,
        target: Option<Target>,
    ) -> Result<Self, StudyError> {
        let read = |record: RecordUse| {
            let scene = Scene {
                record,
                method: Method::EXACT,
                ..like.clone()
            };
            Ok::<_, StudyError>(motion.shake(&scene, false, None)?.record().clone())
        };
        let plain = read(like.record.clone())?;
        let scaled = target.map(|target| read(target.on(&like.record)));
        Self::of(motion.name.clone(), motion.name.clone(), plain, scaled, settings)
    }

    fn of(
        name: String,
        origin: String,
        plain: Record,
        scaled: Option<Result<Record, StudyError>>,
        settings: &BeyondSettings,
    ) -> Result<Self, StudyError> {
        let peak = plain.peak().1;
        let record = scaled.unwrap_or(Ok(plain))?;
        Ok(Self {
            name,
            origin,
            // A motion without shaking has no factor.
            factor: if peak == 0.0 { 1.0 } else { record.peak().1 / peak },
            duration: record.duration() + settings.rest_s,
            record,
        })
    }

    /// The record in one direction.
    pub(crate) fn directed(&self, reversed: bool) -> Record {
        if reversed { self.record.reversed() } else { self.record.clone() }
    }

    /// The part of the record within the duration of the runs.
    pub(super) fn heard(&self) -> Record {
        let record = &self.record;
        let step = record.time_step();
        let heard = |&(index, _): &(usize, &f64)| index as f64 * step <= self.duration;
        let samples = record.samples().iter().enumerate().take_while(heard);
        let samples = samples.map(|(_, sample)| *sample).collect();
        Record::new(step, samples, record.source()).expect("the samples are those of a record")
    }
}

/// Pseudo-spectral acceleration \[m/s²\].
fn sa(record: &Record, period: f64, damping: f64) -> Result<f64, Refused> {
    let values = response_spectrum(record, &[period], damping)?;
    Ok(values[0].pseudo_acceleration)
}

/// Table of each motion's properties, with its spectral accelerations at some periods \[s\]. A value that cannot be computed stays empty.
pub(super) fn table(motions: &[Shaking], periods: &[f64]) -> String {
    let measured = |motion| {
        let heard = Shaking::heard(motion);
        (motion, heard.measures(), heard)
    };
    Table::of(motions.iter().map(measured))
        .column("motion", |(motion, ..)| motion.name.clone())
        .column("origin", |(motion, ..)| motion.origin.clone())
        .column("scaled_by", |(motion, ..)| motion.factor)
        .column("time_step_s", |(.., heard)| heard.time_step())
        .column("record_s", |(motion, ..)| motion.record.duration())
        .column("run_s", |(motion, ..)| motion.duration)
        .column("pga_m_per_s2", |(_, measures, _)| measures.pga)
        .column("pgv_m_per_s", |(_, measures, _)| measures.pgv)
        .column("pgd_m", |(_, measures, _)| measures.pgd)
        .column("arias_intensity_m_per_s", |(_, measures, _)| measures.arias)
        .column("d5_95_s", |(_, measures, _)| measures.d5_95.map(|interval| interval.duration()))
        .column("mean_period_s", |(.., heard)| heard.mean_period())
        .columns(
            periods.iter().copied(),
            |period| format!("sa_{period:.2}_s_m_per_s2"),
            |(.., heard), period| sa(heard, period, DAMPING).ok(),
        )
        .csv()
}
