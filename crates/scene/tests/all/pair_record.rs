//! Records of two horizontal components along an axis, in a scene.

use std::fs;
use std::path::Path;

use pounding_scene::{GroundMotion, Scene};

const SINE: f64 = 0.3;

/// A motion of the azimuth 30° only, by this component.
fn value(azimuth: f64, step: i32) -> f64 {
    0.2 * libm::cos((azimuth - 30.0).to_radians()) * libm::sin(SINE * f64::from(step))
}

fn at2(azimuth: f64) -> String {
    let values: Vec<String> = (0..100).map(|step| format!("{:e}\n", value(azimuth, step))).collect();
    let values = values.concat();
    format!(
        "PEER NGA STRONG MOTION DATABASE RECORD\nA, {azimuth}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 100, DT= .0100 SEC,\n{values}"
    )
}

fn columns(names: &str) -> String {
    let line = |step: i32| {
        format!(
            "{},{:e},{:e},{:e}\n",
            0.01 * f64::from(step),
            value(0.0, step),
            value(90.0, step),
            9.0
        )
    };
    let lines: String = (0..100).map(line).collect();
    format!("{names}\n{lines}")
}

fn scene(record: &str) -> Result<Scene, String> {
    let text = format!(
        "name = \"pair\"\nstructures = [{{ sdof = {{ name = \"a\", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0.05 }} }}]\n[record]\n{record}\n"
    );
    Scene::parse(text.as_bytes(), "scene.toml".as_ref()).map_err(|error| error.to_string())
}

fn motion(folder: &Path, record: &str) -> Result<Vec<f64>, String> {
    let scene = scene(record)?;
    let motion = GroundMotion::of(&scene.record, folder, "pair").map_err(|error| error.to_string())?;
    Ok(motion.record.samples().to_vec())
}

fn assert_is(found: &[f64], factor: f64, what: &str) {
    for (step, found) in (0..).zip(found) {
        let wanted = factor * 9.80665 * value(30.0, step);
        assert!((found - wanted).abs() < 1e-6, "{what}, step {step}: {found} against {wanted}");
    }
}

/// Two files of PEER, a right angle apart, and a file with all components.
#[test]
fn reference_a_pair_shakes_along_the_axis_of_the_row() {
    let folder = tempfile::tempdir().expect("a disk");
    let write = |name: &str, text: String| fs::write(folder.path().join(name), text).expect("a disk");
    write("RSN1_A000.AT2", at2(0.0));
    write("RSN1_A270.AT2", at2(270.0));
    write("all.csv", columns("time_s,NS (g),EW (g),UD (g)"));
    let both = "file = \"RSN1_A000.AT2\"\nsecond_file = \"RSN1_A270.AT2\"\naxis_deg = ";
    for (axis, factor) in [(30.0, 1.0), (120.0, 0.0), (210.0, -1.0), (-150.0, -1.0)] {
        assert_is(
            &motion(folder.path(), &format!("{both}{axis}")).expect("a pair"),
            factor,
            "two files",
        );
        assert_is(
            &motion(folder.path(), &format!("file = \"all.csv\"\naxis_deg = {axis}")).expect("a pair"),
            factor,
            "one file",
        );
    }
    let scene = scene(&format!("{both}30")).expect("a scene");
    assert_eq!(scene.record.processing(), ["two components along the axis of 30°"]);
}

#[test]
fn extreme_axes_without_a_pair_are_refused() {
    let folder = tempfile::tempdir().expect("a disk");
    let write = |name: &str, text: String| fs::write(folder.path().join(name), text).expect("a disk");
    write("A000.AT2", at2(0.0));
    write("A045.AT2", at2(45.0));
    for (record, wanted) in [
        ("file = \"A000.AT2\"\naxis_deg = 30", "found 1 horizontal components"),
        (
            "file = \"A000.AT2\"\nsecond_file = \"A045.AT2\"\naxis_deg = 30",
            "not at right angles",
        ),
        ("file = \"A000.AT2\"\nsecond_file = \"none.AT2\"\naxis_deg = 30", "cannot be read"),
        ("file = \"A000.AT2\"\nsecond_file = \"A045.AT2\"", "it without `axis_deg`"),
        ("file = \"A000.AT2\"\naxis_deg = 361", "-360 to 360"),
        ("file = \"A000.AT2\"\ncomponent = 1\naxis_deg = 3", "delete it: an axis takes both"),
        (
            "generated.half_sine = { amplitude_m_per_s2 = 1, duration_s = 1, time_step_s = 0.1 }\naxis_deg = 3",
            "`axis_deg` beside `generated`",
        ),
    ] {
        let refused = motion(folder.path(), record).expect_err(record);
        assert!(refused.contains(wanted), "{record}: {refused}");
    }
}
