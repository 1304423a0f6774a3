//! `pounding laws` and `pounding certify`.

use std::fmt::Write as _;
use std::path::Path;

use insta::assert_snapshot;

use crate::{Ended, pounding};

fn certify(arguments: &str) -> Ended {
    let arguments: Vec<_> = arguments.split_whitespace().collect();
    pounding(Path::new("."), &[&["certify"], &arguments[..]].concat())
}

#[test]
fn reference_laws() {
    let output = pounding(Path::new("."), &["laws"]);
    assert_snapshot!(output.stdout);
}

#[test]
fn reference_a_certificate_with_every_method() {
    let asked = "hertz_damp --restitution 0.65 --masses 75e3 3e6 --speed 0.3 --time-step 0.005";
    assert_snapshot!(certify(&format!("{asked} --calibration literature")).stdout);
}

#[test]
fn reference_a_certificate_for_machines() {
    let asked =
        "kelvin_voigt --restitution 0.5 --masses 1e5 1e5 --speed 1 --time-step 0.001 --method hht";
    assert_snapshot!("json", certify(&format!("{asked} --format json")).stdout);
    assert_snapshot!("csv", certify(&format!("{asked} --format csv")).stdout);
}

#[test]
fn extreme_what_cannot_be_certified() {
    let mut messages = String::new();
    for wrong in [
        "hertz --restitution 0.5 --masses 1e5 1e5 --speed 1",
        "hertz_damp --restitution 1.5 --masses 1e5 1e5 --speed 1",
        "hertz_damp --restitution 0.5 --masses 1e5 0 --speed 1",
        "hertz_damp --restitution 0.5 --masses 1e5 1e5 --speed nan",
        "hertz_damp --restitution 0.5 --masses 1e5 1e5 --speed 1 --time-step 0",
        "kuwabara_kono --restitution 0.5 --masses 1e5 1e5 --speed 1 --calibration literature",
        "hertz_dam --restitution 0.5 --masses 1e5 1e5 --speed 1",
    ] {
        let output = certify(wrong);
        assert_ne!(output.code, 0, "{wrong}");
        writeln!(messages, "{wrong}\n{}", output.stderr).expect("a string takes all");
    }
    assert_snapshot!(messages);
}
