//! The ground motions as they shake the scenes, and what each of them is.

use crate::StudyError;
use crate::study::other_motions::{BeyondSettings, ListedMotion, Strength};
use pounding_motion::Record;
use pounding_scene::{GroundMotion, Method, Motion, RecordUse, Refused, ScaleTo, Scene, response_spectrum};
use pounding_text::digits;
use pounding_text::to_csv;
use std::path::Path;

/// Damping ratio of the spectral accelerations that are shown \[–\].
pub(super) const DAMPING: f64 = 0.05;

/// A ground motion as it shakes the scenes, but for its direction.
#[derive(Debug, Clone)]
pub(crate) struct Shaking {
    pub(crate) name: String,
    /// File or formula.
    origin: String,
    pub(super) record: Record,
    /// By what it was multiplied to be as strong as the first \[–\].
    factor: f64,
    /// Duration of the runs \[s\].
    pub(crate) duration: f64,
}

/// A strength that motions are scaled to, and its value in the first of them \[m/s²\].
#[derive(Debug, Clone, Copy)]
pub(super) struct Target(Strength, f64);

impl Target {
    /// The strength of the first motion, where a study scales by one.
    ///
    /// # Errors
    /// Refuses a spectral acceleration that cannot be computed.
    pub(super) fn of(settings: &BeyondSettings, first: &Shaking) -> Result<Option<Self>, Refused> {
        let Some(strength) = settings.scaled_by else {
            return Ok(None);
        };
        let value = match strength {
            Strength::Pga => first.record.peak().1.abs(),
            Strength::Sa { period_s, damping_ratio } => sa(&first.record, period_s, damping_ratio)?,
        };
        Ok(Some(Self(strength, value)))
    }

    /// In the words of a scene; `gravity` is what one g is worth \[m/s²\].
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

    /// The record scaled to this, unless it says itself what it is scaled to.
    fn on(self, record: &RecordUse) -> RecordUse {
        let mut record = record.clone();
        let scale_to = self.scale_to(record.gravity_m_per_s2);
        record.scale_to.get_or_insert(scale_to);
        record
    }
}

impl Shaking {
    /// A motion of a list; `base` is the folder that its file is named from.
    ///
    /// # Errors
    /// Those of [`GroundMotion::of`].
    pub(super) fn listed(
        motion: &ListedMotion,
        base: &Path,
        settings: &BeyondSettings,
        target: Option<Target>,
    ) -> Result<Self, StudyError> {
        let read = |record: &RecordUse| {
            let read = GroundMotion::of(record, base, &motion.name)?;
            Ok::<_, StudyError>(read.record)
        };
        let plain = read(&motion.record)?;
        let scaled = target.map(|target| read(&target.on(&motion.record)));
        let origin = motion.record.source.to_string();
        let mut shaking = Self::of((motion.name.clone(), origin), plain, scaled, settings)?;
        if let Some(duration) = motion.duration_s {
            shaking.duration = duration;
        }
        Ok(shaking)
    }

    /// A motion of a folder; what one g is worth, and what a file leaves out, says the record of a scene.
    ///
    /// # Errors
    /// Those of [`Motion::shake`].
    pub(super) fn of_folder(motion: &Motion, like: &Scene, settings: &BeyondSettings, target: Option<Target>) -> Result<Self, StudyError> {
        let read = |record: RecordUse| {
            let scene = Scene {
                record,
                method: Method::EXACT,
                ..like.clone()
            };
            let prepared = motion.shake(&scene, false, None)?;
            Ok::<_, StudyError>(prepared.record().clone())
        };
        let plain = read(like.record.clone())?;
        let scaled = target.map(|target| read(target.on(&like.record)));
        Self::of((motion.name.clone(), motion.name.clone()), plain, scaled, settings)
    }

    fn of(
        (name, origin): (String, String),
        plain: Record,
        scaled: Option<Result<Record, StudyError>>,
        settings: &BeyondSettings,
    ) -> Result<Self, StudyError> {
        let peak = plain.peak().1;
        let record = scaled.unwrap_or(Ok(plain))?;
        Ok(Self {
            name,
            origin,
            // Nothing is nothing, however it is scaled.
            factor: if peak == 0.0 { 1.0 } else { record.peak().1 / peak },
            duration: record.duration() + settings.rest_s,
            record,
        })
    }

    /// The record in a direction.
    pub(crate) fn directed(&self, reversed: bool) -> Record {
        if reversed { self.record.reversed() } else { self.record.clone() }
    }

    /// What of the record shakes: it may last longer than the runs.
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

/// What each motion is, with its spectral accelerations at some periods \[s\]; what cannot be computed stays empty.
pub(super) fn table(motions: &[Shaking], periods: &[f64]) -> String {
    let mut header = [
        "motion",
        "origin",
        "scaled_by",
        "time_step_s",
        "record_s",
        "run_s",
        "pga_m_per_s2",
        "pgv_m_per_s",
        "pgd_m",
        "arias_intensity_m_per_s",
        "d5_95_s",
        "mean_period_s",
    ]
    .map(String::from)
    .to_vec();
    let of_period = |period: &f64| format!("sa_{period:.2}_s_m_per_s2");
    header.extend(periods.iter().map(of_period));
    let row = |motion: &Shaking| {
        let heard = motion.heard();
        let measures = heard.measures();
        let length = measures.d5_95.map(|interval| interval.duration());
        let mut row = vec![motion.name.clone(), motion.origin.clone()];
        let numbers = [
            motion.factor,
            heard.time_step(),
            motion.record.duration(),
            motion.duration,
            measures.pga,
            measures.pgv,
            measures.pgd,
            measures.arias,
        ];
        row.extend(numbers.map(digits));
        let spectral = periods.iter().map(|period| sa(&heard, *period, DAMPING).ok());
        let known = [length, heard.mean_period()].into_iter().chain(spectral);
        row.extend(known.map(|number| number.map_or_else(String::new, digits)));
        row
    };
    to_csv(&header, &motions.iter().map(row).collect::<Vec<_>>())
}
