//! Any bytes as a scene file: read, checked, prepared and run for a few steps, or refused; never a panic, and no result
//! that is not finite.
//!
//! No file is opened: the record is the text of `record.file` where that is a record, and else a pulse.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use pounding_motion::Accelerogram;
use pounding_studies::{Method, Outcome, Prepared, Scene, Structure, parse};

/// Steps of structures of a run.
const MOST_STEPS: f64 = 2000.0;
/// Pieces that the motion of a structure asks of the exact method, and longest run of it \[s\].
const MOST_PIECES: f64 = 1e4;
const LONGEST: f64 = 2.0;
/// Structures of such a run.
const MOST_STRUCTURES: usize = 6;
/// Radians of a period.
const TURN: f64 = 2.0 * std::f64::consts::PI;
/// Acceleration that sets structures moving \[g\].
const PULSE: &[u8] = b"time_s,acceleration_g\n0.0,0.1\n0.1,0.5\n0.2,-0.3\n0.3,0.2\n";

fuzz_target!(|bytes: &[u8]| {
    let Ok(mut scene) = parse::<Scene>(bytes, Path::new("scene.json")) else {
        return;
    };
    if matches!(scene.method, Method::Accuracy(_)) {
        // The search for a method takes seconds on the smallest scene; what it runs is met here one by one.
        scene.method = Method::EXACT;
    }
    // Long runs are refused or take their time: preparing them must not.
    let Ok(prepared) = Prepared::with_record(&scene, record(&scene)) else {
        return;
    };
    if !is_small(&scene) {
        return;
    }
    if let Ok(review) = prepared.review(false) {
        is_finite(&review.outcome, scene.structures.len());
        for warning in &review.warnings {
            assert!(!warning.to_string().is_empty(), "{warning:?}");
        }
    }
});

fn is_small(scene: &Scene) -> bool {
    let n = scene.structures.len();
    match scene.method {
        Method::Exact { .. } => {
            let rate = |structure: &Structure| match structure {
                Structure::Sdof(sdof) => sdof.damping_coefficient() / sdof.mass_kg + TURN / sdof.period(),
                Structure::Wall => 0.0,
            };
            let rates = scene.structures.iter().map(rate);
            let fastest = rates.fold(1.0, f64::max);
            scene.duration_s <= LONGEST && n <= MOST_STRUCTURES && fastest * scene.duration_s <= MOST_PIECES
        }
        method => method.time_step().is_some_and(|step| {
            let substeps = match method {
                Method::CentralDifference { contact_substeps, .. } => f64::from(contact_substeps),
                _ => 1.0,
            };
            scene.duration_s / step * n as f64 * substeps <= MOST_STEPS
        }),
    }
}

fn record(scene: &Scene) -> Accelerogram {
    let own = pounding_motion::read(scene.record.source.to_string().as_bytes());
    own.unwrap_or_else(|_| pounding_motion::read(PULSE).expect("a record"))
}

fn is_finite(outcome: &Outcome, n: usize) {
    for structure in 0..n {
        let peaks = outcome.peaks.of(structure);
        for peak in [peaks.displacement, peaks.restoring_force, peaks.pounding_force] {
            assert!(peak.value.is_finite() && peak.time.is_finite(), "{structure}: {peak:?}");
        }
        let momentum = outcome.momentum.of(structure);
        assert!(momentum.is_finite(), "{structure}: momentum {momentum}");
    }
    for collision in outcome.collisions.all() {
        let numbers = [collision.start, collision.end, collision.impulse];
        let peak = collision.peak_force.unwrap_or(0.0);
        assert!(numbers.iter().all(|number| number.is_finite()) && peak.is_finite(), "{collision:?}");
        assert!(collision.start <= collision.end, "{collision:?}");
    }
}
