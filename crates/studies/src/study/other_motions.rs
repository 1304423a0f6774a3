//! Ground motions beyond the paper's record and direction.

use serde::{Deserialize, Serialize};

use super::change::Change;
use pounding_scene::RecordUse;

/// Ground motions for the paper's scenes; each runs in both directions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BeyondSettings {
    /// The ground motions; the first is the paper's.
    pub motions: Vec<ListedMotion>,
    /// Measure by which all motions are scaled to the strength of the first. By default they are not scaled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scaled_by: Option<Strength>,
    /// Changes of the scenes under which all runs are repeated, at most one of a kind.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub changes: Vec<Change>,
    /// Length of a run after the end of the record \[s\], ≥ 0. A motion with `duration_s` ignores it.
    pub rest_s: f64,
}

/// A ground motion of the list.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ListedMotion {
    /// Name in tables and figures.
    pub name: String,
    /// The record as in a scene, not reversed: both directions run.
    pub record: RecordUse,
    /// Duration of the runs \[s\], > 0. By default a run lasts until the ground has been at rest for a while.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub duration_s: Option<f64>,
}

/// A measure of the strength of a ground motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Strength {
    /// Peak ground acceleration.
    Pga,
    /// Pseudo-spectral acceleration at one period.
    Sa {
        /// Period \[s\], > 0.
        period_s: f64,
        /// Damping ratio \[–\], 0 to 1.
        damping_ratio: f64,
    },
}

impl BeyondSettings {
    /// Number of cases that usually run: every motion in both directions, for the paper's scenes and for every change that is not long.
    pub(crate) fn n_usual_cases(&self) -> usize {
        let usual = self.changes.iter().filter(|change| !change.is_long());
        2 * self.motions.len() * (1 + usual.count())
    }

    /// The first fault: field, value found, and values allowed. `None` if all is allowed.
    pub(crate) fn fault(&self) -> Option<(&'static str, String, &'static str)> {
        let motions = &self.motions;
        for (index, motion) in motions.iter().enumerate() {
            let quoted = || format!("\"{}\"", motion.name);
            let twice = |other: &ListedMotion| other.name == motion.name;
            if motions[..index].iter().any(twice) {
                let found = quoted() + " twice";
                return Some(("output.beyond.motions.name", found, "names that differ"));
            }
            if motion.record.reversed {
                let allowed = "records that are not reversed: both directions run";
                return Some(("output.beyond.motions.record.reversed", quoted(), allowed));
            }
            let duration = motion.duration_s.unwrap_or(1.0);
            if !(duration.is_finite() && duration > 0.0) {
                let found = format!("{duration} in {}", quoted());
                return Some(("output.beyond.motions.duration_s", found, "a number > 0 s"));
            }
        }
        if motions.is_empty() {
            return Some(("output.beyond.motions", "none".into(), "one or more"));
        }
        for (index, change) in self.changes.iter().enumerate() {
            let fault = change.fault();
            if let Some((found, allowed)) = fault {
                return Some(("output.beyond.changes", found, allowed));
            }
            let alike = |other: &Change| other.word() == change.word();
            if self.changes[..index].iter().any(alike) {
                let found = format!("{} twice", change.word());
                return Some(("output.beyond.changes", found, "one change of a kind"));
            }
        }
        let rest = self.rest_s;
        let sound = rest.is_finite() && rest >= 0.0;
        (!sound).then(|| ("output.beyond.rest_s", rest.to_string(), "a finite number >= 0 s"))
    }
}
