//! The motion between samples in scenes.
#![expect(clippy::disallowed_methods, reason = "sines in tests")]

use std::f64::consts::TAU;

use pounding_motion::Record;
use pounding_scene::file::Interpolation;
use pounding_scene::{GroundMotion, Scene, response_spectrum};

/// A wave of 5 Hz that swells and fades.
fn wave(time_step: f64) -> Record {
    let times = (0..).map(|index: u32| time_step * f64::from(index)).take_while(|time| *time < 10.0);
    let at = |time: f64| {
        let after = time - 5.0;
        (-2.0 * after * after).exp() * (TAU * 5.0 * after).sin()
    };
    Record::new(time_step, times.map(at).collect(), "").expect("a record")
}

/// Straight lines lose 3 % of 5 Hz at 20 ms. A band-limited record at any step tends to the motion.
#[test]
fn order_spectra_tend_to_those_of_the_motion() {
    let at = |record: &Record| response_spectrum(record, &[0.15, 0.2, 0.3, 1.0], 0.05).expect("a spectrum");
    let motion = at(&wave(2.5e-4));
    let error = |record: &Record| {
        let found = at(record).into_iter().zip(&motion);
        let errors = found.map(|(found, motion)| (found.displacement / motion.displacement - 1.0).abs());
        errors.fold(0.0, f64::max)
    };
    for time_step in [0.01, 0.02, 0.04] {
        let record = wave(time_step);
        let (linear, limited) = (error(&record), error(&record.band_limited().expect("a finer one")));
        let lost = (std::f64::consts::PI * 5.0 * time_step).powi(2) / 3.0;
        assert!(linear > 0.5 * lost, "{time_step}: {linear}");
        assert!(limited < 1e-3, "{time_step}: {limited}");
    }
}

fn scene(interpolation: &str) -> Scene {
    let text = format!(
        "name = \"a\"\nrecord = {{ generated.half_sine = {{ amplitude_m_per_s2 = 2.0, duration_s = 0.5, time_step_s = 0.02 }}{interpolation} }}
structures = [{{ sdof = {{ name = \"a\", mass_kg = 1e5, period_s = 0.3, damping.ratio = 0.05 }} }}]"
    );
    Scene::parse(text.as_bytes(), "a.toml".as_ref()).expect("a scene")
}

#[test]
fn reference_a_scene_takes_its_record_band_limited() {
    let motion = |scene: &Scene| GroundMotion::of(&scene.record, "".as_ref(), "").expect("a motion").record;
    let (linear, limited) = (scene(""), scene(", interpolation = \"band_limited\""));
    assert_eq!(linear.record.interpolation, Interpolation::Linear);
    assert_eq!(limited.record.processing(), ["band-limited between samples"]);
    assert_eq!(motion(&limited), motion(&linear).band_limited().expect("a finer one"));
}
