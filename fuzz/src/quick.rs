//! Ground motions that are quick to make: a budget counts the cost of a run, but not that of its record.

use pounding_scene::{Generated, Scene, Source};

/// Largest number of samples of a record, and of terms of a stochastic one. Larger ones take seconds, and tests cover them.
const MOST_SAMPLES: f64 = 1e4;
const MOST_TERMS: f64 = 1e3;

/// Whether the ground motion is quick to make.
pub(crate) fn is_quickly_shaken(scene: &Scene) -> bool {
    let is_short = |duration: f64, step: f64| duration <= MOST_SAMPLES * step.abs();
    if let Some(step) = scene.record.resample_s
        && !is_short(1.0, step)
    {
        return false;
    }
    match &scene.record.source {
        Source::File(_) => true,
        Source::Generated(generated) => match *generated {
            Generated::Harmonic {
                duration_s, time_step_s, ..
            }
            | Generated::HalfSine {
                duration_s, time_step_s, ..
            } => is_short(duration_s, time_step_s),
            Generated::Ricker {
                frequency_hz, time_step_s, ..
            } => is_short(3.0 / frequency_hz, time_step_s),
            Generated::Stochastic(ref motion) => {
                let terms = motion.cutoff_hz.unwrap_or(25.0) * motion.duration_s;
                is_short(motion.duration_s, motion.time_step_s) && terms <= MOST_TERMS
            }
        },
    }
}
