//! Tests of `pounding laws` and `pounding certify`.

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

/// The only value on offer was the paper's, an order of magnitude below that of two slabs that meet.
#[test]
fn issue_slabs_tell_the_impact_stiffness() {
    let laws = |arguments: &str| {
        let arguments: Vec<_> = arguments.split_whitespace().collect();
        pounding(Path::new("."), &[&["laws"], &arguments[..]].concat())
    };
    let slabs = laws("--slab-area 3 --slab-length 20 --modulus 30e9").stdout;
    assert!(
        slabs.starts_with("Impact stiffness  2.25e9 N/m, from 4.5e9 N/m on the left"),
        "{slabs}"
    );
    assert!(
        slabs.contains("impact_stiffness_n_per_m = 2.25e9") && slabs.contains("11.55 ms"),
        "{slabs}"
    );
    let json = laws("--slab-area 3 6 --slab-length 20 --json").stdout;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["impact_stiffness_n_per_m"], 3e9);
    assert_eq!(json["slab_stiffness_n_per_m"], serde_json::json!([4.5e9, 9e9]));
    assert_snapshot!(laws("--slab-area 3").stderr, @"error: --slab-length: found none, allowed are both `--slab-area` and `--slab-length`; a stiffness E A/L needs the section and the length");
}

#[test]
fn reference_a_certificate_with_every_method() {
    let asked = "hertz_damp --restitution 0.65 --masses 75e3 3e6 --speed 0.3 --time-step 0.005";
    assert_snapshot!(certify(&format!("{asked} --calibration literature")).stdout);
}

#[test]
fn reference_a_certificate_for_machines() {
    let asked = "kelvin_voigt --restitution 0.5 --masses 1e5 1e5 --speed 1 --time-step 0.001 --method hht";
    assert_snapshot!("json", certify(&format!("{asked} --format json")).stdout);
    assert_snapshot!("csv", certify(&format!("{asked} --format csv")).stdout);
}

/// Four laws did not end: the exact method cut a collision of a million years into pieces as short as a contact.
#[test]
fn issue_a_certificate_of_a_soft_contact_ends() {
    for law in [
        "kelvin_voigt",
        "modified_kelvin",
        "modified_linear_viscoelastic",
        "pant_wijeyewickrema",
    ] {
        let soft = "--restitution 0.65 --masses 1e5 1e5 --speed 0.3 --stiffness 1e-30";
        let ended = certify(&format!("{law} {soft}"));
        assert_eq!(ended.code, 1, "{law}: {}", ended.stdout);
        let wanted = "more than 1e5 pieces of the exact method";
        assert!(ended.stderr.contains(wanted), "{law}: {}", ended.stderr);
    }
    let fine = "hertz --restitution 1 --masses 1e5 1e5 --speed 1 --time-step 1e-9 --format json";
    let ended = certify(fine);
    assert!(ended.stdout.contains("at most 1e6 steps"), "{}", ended.stdout);
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

#[test]
fn extreme_numbers_that_are_none_are_refused_by_every_option() {
    let options = [
        ("restitution", "0.5"),
        ("masses", "1e5 2e5"),
        ("speed", "1"),
        ("stiffness", "1e9"),
        ("time-step", "0.01"),
    ];
    let asked = |changed: Option<(&str, &str)>| {
        let words = options.map(|(option, good)| match changed {
            Some((other, numbers)) if other == option => format!("--{option} {numbers}"),
            _ => format!("--{option} {good}"),
        });
        certify(&format!("hertz_damp {}", words.join(" ")))
    };
    assert_eq!(asked(None).code, 0, "good as it is");
    for (option, _) in options {
        for none in ["nan", "NaN", "inf", "infinity", "1e999", "-1e999"] {
            let numbers = match option {
                "masses" => format!("1e5 {none}"),
                _ => none.to_string(),
            };
            let ended = asked(Some((option, &numbers)));
            assert!(ended.code != 0 && ended.stdout.is_empty(), "{option} {none}");
            // A number that begins with a minus sign is read as an option.
            let named = ended.stderr.contains(option) || none.starts_with('-');
            assert!(named, "{option} {none}: {}", ended.stderr);
        }
    }
}

/// A negative mass was read as an unknown option.
#[test]
fn issue_a_negative_mass_is_refused_as_a_number() {
    for masses in [["-75e3", "3e6"], ["75e3", "-3e6"]] {
        let masses = [&["--masses"], &masses[..]].concat();
        let rest = ["certify", "hertz_damp", "--restitution", "0.65", "--speed", "0.3"];
        let ended = pounding(Path::new("."), &[&rest[..], &masses].concat());
        assert_eq!(ended.code, 2);
        let said = "for '--masses <LEFT> <RIGHT>': allowed is a finite number > 0";
        assert!(ended.stderr.contains(said), "{}", ended.stderr);
    }
}
