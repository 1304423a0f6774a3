//! The assertions on every scene file. It is read, checked, prepared and run within a budget, as `pounding run` and `pounding check` do, or
//! it is refused. There is no panic, and every result is finite.
//!
//! No file is opened: the record is the text of `record.file` if that is a record, else a pulse. Bytes are tried as JSON, then as TOML.

use std::path::Path;

use pounding_motion::Accelerogram;
use pounding_scene::file::RunBudget;
use pounding_scene::{Error, Method, RunResult, Scene, Simulation, Source};

use crate::quick::is_quickly_shaken;

/// The budget of a run.
const BUDGET: RunBudget = RunBudget {
    steps: Some(1e4),
    pieces: Some(1e4),
    seconds: None,
};
/// Acceleration that sets structures moving \[g\].
const PULSE: &[u8] = b"time_s,acceleration_g\n0.0,0.1\n0.1,0.5\n0.2,-0.3\n0.3,0.2\n";

/// Reads some bytes as a scene and runs it if the run is short.
pub(crate) fn check(bytes: &[u8]) {
    let read = |name| said(Scene::parse(bytes, Path::new(name)));
    let Some(mut scene) = read("scene.json").or_else(|| read("scene.toml")) else {
        return;
    };
    if matches!(scene.method, Method::Accuracy(_)) {
        // The search for a method takes seconds on the smallest scene; its runs are tested here one by one.
        scene.method = Method::EXACT;
    }
    if !is_quickly_shaken(&scene) {
        return;
    }
    scene.budget = BUDGET;
    let prepared = match &scene.record.source {
        Source::File(file) => Simulation::with_record(&scene, record(&file.file)),
        Source::Generated(_) => Simulation::new(&scene, Path::new("")),
    };
    let Some(prepared) = said(prepared) else {
        return;
    };
    if let Some(review) = said(prepared.review(true)) {
        check_finite(&review.outcome, prepared.floors().all().len());
        for warning in &review.warnings {
            assert!(!warning.to_string().is_empty(), "{warning:?}");
        }
    }
    // `check` runs the exact method too, whatever the result of the run.
    let exact = prepared.exact().and_then(|exact| exact.run(None));
    if let Some(expected) = said(exact) {
        check_finite(&expected, prepared.floors().all().len());
        let _ = (prepared.warnings_before(&expected), prepared.limits(&expected));
        let _ = (prepared.unneeded(&[&expected]), prepared.openings());
    }
    for doubt in prepared.doubts() {
        assert!(!doubt.to_string().is_empty(), "{doubt:?}");
    }
}

/// The result; for a refusal asserts that it gives a reason.
fn said<T>(result: Result<T, Error>) -> Option<T> {
    match result {
        Ok(done) => Some(done),
        Err(refused) => {
            assert!(!refused.to_string().is_empty(), "{refused:?}");
            None
        }
    }
}

fn record(file: &str) -> Accelerogram {
    let own = pounding_motion::read(file.as_bytes());
    own.unwrap_or_else(|_| pounding_motion::read(PULSE).expect("a record"))
}

fn check_finite(outcome: &RunResult, n: usize) {
    for structure in 0..n {
        let peaks = outcome.peaks.of(structure);
        for peak in [peaks.displacement, peaks.restoring_force, peaks.pounding_force] {
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
