//! What a record leaves open between its samples, and how far the numbers of a run hang on it.

use pounding_motion::Record;
use pounding_text::percent;
use serde::{Deserialize, Serialize};

use crate::file::Interpolation;
use crate::{Error, RunResult, Simulation, Source};

/// How far numbers of a run move if its record is band-limited between samples, in place of straight lines.
///
/// JSON names the numbers as relative changes: `drift_change`, `impulse_change`, `force_change`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BetweenSamples {
    /// Change of the largest drift of all storeys \[–\].
    #[serde(rename = "drift_change")]
    pub drift: Option<f64>,
    /// Change of the largest impulse of all collisions \[–\]; `None` if one of both runs has none.
    #[serde(rename = "impulse_change")]
    pub impulse: Option<f64>,
    /// Change of the largest pounding force \[–\]; `None` if one of both runs has none.
    #[serde(rename = "force_change")]
    pub force: Option<f64>,
    /// Number of collisions with straight lines, and with the band-limited record.
    pub collisions: [usize; 2],
    /// First or last acceleration as a part of the peak, if the record jumps there: a band-limited record rings.
    pub jumps: Option<f64>,
}

impl BetweenSamples {
    /// The largest of the changes \[–\]; infinite if the numbers of collisions differ.
    pub fn largest(&self) -> f64 {
        if self.collisions[0] != self.collisions[1] {
            return f64::INFINITY;
        }
        let changes = [self.drift, self.impulse, self.force].into_iter().flatten();
        changes.map(f64::abs).fold(0.0, f64::max)
    }
}

/// The largest drift \[m\], impulse \[N·s\] and force \[N\] of a run.
fn largest(run: &RunResult, n_floors: usize) -> [f64; 3] {
    let drifts = (0..n_floors).map(|floor| run.peaks.of(floor).drift().value.abs());
    let all = run.collisions.all();
    let impulses = all.iter().map(|one| one.impulse);
    let forces = all.iter().filter_map(|one| one.peak_force);
    [drifts.fold(0.0, f64::max), impulses.fold(0.0, f64::max), forces.fold(0.0, f64::max)]
}

impl Simulation {
    /// Runs the scene under its record as band-limited between samples, by its own method. `None` for a motion from a formula, whose samples
    /// are its definition, and for a record that is band-limited already.
    ///
    /// # Errors
    /// Errors of [`Self::run`], and of a record with too many samples.
    pub fn between_samples(&self, run: &RunResult) -> Option<Result<BetweenSamples, Error>> {
        let used = &self.scene().record;
        let is_sampled = matches!(used.source, Source::File(_)) && used.interpolation == Interpolation::Linear;
        is_sampled.then(|| {
            let other = self.under(Record::band_limited)?.run(None)?;
            let n_floors = self.floors().all().len();
            let both = [run, &other].map(|run| largest(run, n_floors));
            let change = |index: usize| {
                let [linear, limited] = both.map(|numbers| numbers[index]);
                (linear > 0.0 && limited > 0.0).then(|| limited / linear - 1.0)
            };
            Ok(BetweenSamples {
                drift: change(0),
                impulse: change(1),
                force: change(2),
                collisions: [run, &other].map(|run| run.collisions.all().len()),
                jumps: self.record().jumps(),
            })
        })
    }
}

impl std::fmt::Display for BetweenSamples {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let changes = [("drift", self.drift), ("impulse", self.impulse), ("force", self.force)];
        let changes = changes.into_iter().filter_map(|(what, change)| {
            let change = change?;
            let sign = if change < 0.0 { "−" } else { "+" };
            Some(format!("largest {what} {sign}{}", percent(change.abs())))
        });
        let [linear, limited] = self.collisions;
        let collisions = (linear != limited).then(|| format!("{limited} collisions in place of {linear}"));
        let all: Vec<String> = changes.chain(collisions).collect();
        let all = if all.is_empty() { "nothing".to_owned() } else { all.join(", ") };
        write!(
            formatter,
            "with a band-limited record in place of straight lines between its samples (record.interpolation): {all}"
        )?;
        match self.jumps {
            None => Ok(()),
            Some(part) => write!(
                formatter,
                "; it begins or ends at {} of its peak, where a band-limited one rings",
                percent(part)
            ),
        }
    }
}
