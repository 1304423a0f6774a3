//! What the paper's scenes are shaken with beyond its own record and direction.

use serde::{Deserialize, Serialize};

use crate::RecordUse;

/// Ground motions, each of which shakes the paper's scenes in both directions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BeyondSettings {
    /// The ground motions; the first is the paper's.
    pub motions: Vec<ListedMotion>,
    /// Strength in which all are scaled to the first; without it they are as their records say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scaled_by: Option<Strength>,
    /// How long a run goes on after the end of a record without a duration of its own \[s\], ≥ 0.
    pub rest_s: f64,
}

/// A ground motion of the list.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ListedMotion {
    /// Name for tables and figures.
    pub name: String,
    /// The record in the words of a scene, not reversed: both directions run.
    pub record: RecordUse,
    /// Duration of the runs \[s\], > 0, where they are not to last until the ground has been at rest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub duration_s: Option<f64>,
}

/// How strong a ground motion is, in one number.
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
    /// Number of cases: motions in both directions.
    pub(crate) fn n_cases(&self) -> usize {
        2 * self.motions.len()
    }

    /// What is not allowed: field, what was found, and what is allowed.
    pub(super) fn fault(&self) -> Option<(&'static str, String, &'static str)> {
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
        let rest = self.rest_s;
        let sound = rest.is_finite() && rest >= 0.0;
        (!sound).then(|| {
            (
                "output.beyond.rest_s",
                rest.to_string(),
                "a finite number >= 0 s",
            )
        })
    }
}
