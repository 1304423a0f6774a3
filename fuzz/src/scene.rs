//! What every scene file is held to: read, checked, prepared and run for a few steps, or refused; never a panic, and no
//! result that is not finite.
//!
//! No file is opened: the record is the text of `record.file` where that is a record, and else a pulse. Bytes are tried as
//! JSON, then as TOML.

use std::path::Path;

use pounding_motion::Accelerogram;
use pounding_studies::{
    Generated, Method, Outcome, Prepared, Scene, Source, Structure, StudyError,
};

/// Steps of structures of a run.
const MOST_STEPS: f64 = 2000.0;
/// Pieces that the motion of a structure asks of the exact method, and longest run of it \[s\].
const MOST_PIECES: f64 = 1e4;
const LONGEST: f64 = 2.0;
/// Structures of such a run.
const MOST_STRUCTURES: usize = 6;
/// Samples of a record, and terms of a stochastic one: more are made in seconds, and met by tests.
const MOST_SAMPLES: f64 = 1e4;
const MOST_TERMS: f64 = 1e3;
/// Acceleration that sets structures moving \[g\].
const PULSE: &[u8] = b"time_s,acceleration_g\n0.0,0.1\n0.1,0.5\n0.2,-0.3\n0.3,0.2\n";

/// Reads some bytes as a scene and runs it, where that is short.
pub(crate) fn check(bytes: &[u8]) {
    let read = |name| said(Scene::parse(bytes, Path::new(name)));
    let Some(mut scene) = read("scene.json").or_else(|| read("scene.toml")) else {
        return;
    };
    if matches!(scene.method, Method::Accuracy(_)) {
        // The search for a method takes seconds on the smallest scene; what it runs is met here one by one.
        scene.method = Method::EXACT;
    }
    if !is_quickly_shaken(&scene) {
        return;
    }
    // Long runs are refused or take their time: preparing them must not.
    let prepared = match &scene.record.source {
        Source::File(file) => Prepared::with_record(&scene, record(&file.file)),
        Source::Generated(_) => Prepared::new(&scene, Path::new("")),
    };
    let Some(prepared) = said(prepared).filter(is_small) else {
        return;
    };
    if let Some(review) = said(prepared.review(false)) {
        check_finite(&review.outcome, prepared.floors().all().len());
        for warning in &review.warnings {
            assert!(!warning.to_string().is_empty(), "{warning:?}");
        }
    }
}

/// What was done; what is refused says why.
fn said<T>(result: Result<T, StudyError>) -> Option<T> {
    match result {
        Ok(done) => Some(done),
        Err(refused) => {
            assert!(!refused.to_string().is_empty(), "{refused:?}");
            None
        }
    }
}

/// Whether the ground motion is made in no time.
fn is_quickly_shaken(scene: &Scene) -> bool {
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
                duration_s,
                time_step_s,
                ..
            }
            | Generated::HalfSine {
                duration_s,
                time_step_s,
                ..
            } => is_short(duration_s, time_step_s),
            Generated::Ricker {
                frequency_hz,
                time_step_s,
                ..
            } => is_short(3.0 / frequency_hz, time_step_s),
            Generated::Stochastic(ref motion) => {
                let terms = motion.cutoff_hz.unwrap_or(25.0) * motion.duration_s;
                is_short(motion.duration_s, motion.time_step_s) && terms <= MOST_TERMS
            }
        },
    }
}

fn is_small(prepared: &Prepared) -> bool {
    let (scene, duration) = (prepared.scene(), prepared.duration());
    if prepared.record().samples().len() as f64 > MOST_SAMPLES {
        return false;
    }
    let n = prepared.floors().all().len();
    if let Some(step) = scene.method.time_step() {
        let substeps = match scene.method {
            Method::CentralDifference {
                contact_substeps, ..
            } => f64::from(contact_substeps),
            Method::Newmark { .. }
            | Method::Hht { .. }
            | Method::VelocityVerlet { .. }
            | Method::Rk4 { .. }
            | Method::MoreauJean { .. }
            | Method::Exact { .. }
            | Method::Accuracy(_) => 1.0,
        };
        return duration / step * n as f64 * substeps <= MOST_STEPS;
    }
    let rate = |structure: &Structure| {
        let fastest = structure.fastest();
        fastest.map_or(0.0, |one| {
            (2.0 * one.damping_ratio + 1.0) * one.angular_frequency
        })
    };
    let fastest = scene.structures.iter().map(rate).fold(1.0, f64::max);
    duration <= LONGEST && n <= MOST_STRUCTURES && fastest * duration <= MOST_PIECES
}

fn record(file: &str) -> Accelerogram {
    let own = pounding_motion::read(file.as_bytes());
    own.unwrap_or_else(|_| pounding_motion::read(PULSE).expect("a record"))
}

fn check_finite(outcome: &Outcome, n: usize) {
    for structure in 0..n {
        let peaks = outcome.peaks.of(structure);
        for peak in [
            peaks.displacement,
            peaks.restoring_force,
            peaks.pounding_force,
        ] {
            let finite = peak.value.is_finite() && peak.time.is_finite();
            assert!(finite, "{structure}: {peak:?}");
        }
        let momentum = outcome.momentum.of(structure);
        assert!(momentum.is_finite(), "{structure}: momentum {momentum}");
    }
    for collision in outcome.collisions.all() {
        let numbers = [collision.start, collision.end, collision.impulse];
        let peak = collision.peak_force.unwrap_or(0.0);
        let finite = numbers.iter().all(|number| number.is_finite()) && peak.is_finite();
        assert!(finite, "{collision:?}");
        assert!(collision.start <= collision.end, "{collision:?}");
    }
}
