//! A declaration never overrides a statement of the file.

use pounding_motion::{AccelerationUnit, Accelerogram, Declared, read_declared};
use proptest::prelude::*;

use super::{file, rows_of};

/// A small text with the unit and step \[s\] that it states.
#[derive(Clone, Debug)]
struct Case {
    text: String,
    unit: Option<AccelerationUnit>,
    time_step: Option<f64>,
}

const FILES: [&str; 11] = [
    "cosmos.v2",
    "csmip-new.v1",
    "csmip-old.v1",
    "csmip.v2",
    "esm.asc",
    "geonet.v1a",
    "geonet.v2a",
    "knet.ns",
    "renadic.v1",
    "usc.s0a",
    "usgs.smc",
];

fn first() -> Declared {
    Declared {
        component: Some("1".to_owned()),
        ..Declared::default()
    }
}

/// The files of the tests, and small texts in layouts of comments, names and columns.
fn cases() -> Vec<Case> {
    let of_files = FILES.map(|name| {
        let text = file(name);
        let found = read_declared(text.as_bytes(), &first()).expect("a file that says everything");
        Case {
            unit: Some(found.unit()),
            time_step: Some(found.time_step()),
            text,
        }
    });
    of_files.into_iter().chain(of_texts()).collect()
}

/// Small texts; some state their unit or their step of 0.02 s.
fn of_texts() -> impl Iterator<Item = Case> {
    let column = rows_of(40, |_, value| format!("{value:.6}\n"));
    let pairs = rows_of(40, |step, value| format!("{:.2},{value:.6}\n", 0.02 * step));
    let rows = rows_of(40, |step, value| {
        let end = if (step + 1.0) % 5.0 < 0.5 { "\n" } else { " " };
        format!("{value:.6}{end}")
    });
    let semicolons = pairs.replace(',', ";").replace('.', ",");
    let g = Some(AccelerationUnit::StandardGravity);
    let gal = Some(AccelerationUnit::CentimetrePerSecondSquared);
    let peer = "A\nB, 180\nACCELERATION IN UNITS OF G\nNPTS= 40, DT= .02 SEC\n";
    let stepped = [
        (format!("# dt = 0.02 s\n{column}"), None),
        (format!("# 40 samples, 50 sps, acceleration in g\n{column}"), g),
        (format!("1\n0.02\n{column}"), None),
        (format!("40 0.02\n{rows}"), None),
        (format!("A title\n40 0.02\n{column}"), None),
        (pairs.clone(), None),
        (format!("time_s,acceleration_g\n{pairs}"), g),
        (format!("time (s),NS (gal)\n{pairs}"), gal),
        (semicolons, None),
        (format!("{peer}{column}"), g),
        (format!("STA 090\n40 0.02 0 0 0 0 0 0\n{rows}"), None),
    ];
    let silent = [
        (column.clone(), None),
        (format!("# units: gal\n{column}"), gal),
        (format!("acc_g\n{column}"), g),
    ];
    let case = |time_step| move |(text, unit)| Case { text, unit, time_step };
    stepped.into_iter().map(case(Some(0.02))).chain(silent.into_iter().map(case(None)))
}

/// Possible declarations for a file without statements.
fn filled(case: &Case, declared: &Declared) -> Declared {
    Declared {
        unit: declared.unit.filter(|_| case.unit.is_none()),
        time_step: declared.time_step.filter(|_| case.time_step.is_none()),
        ..first()
    }
}

fn read(text: &str, declared: &Declared) -> Option<Accelerogram> {
    read_declared(text.as_bytes(), declared).ok()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn extreme_declarations_against_what_a_file_says(
        index in 0..25_usize,
        unit in prop::option::of(prop::sample::select(&AccelerationUnit::ALL[..])),
        time_step in prop::option::of(prop::sample::select(&[0.005, 0.01, 0.02, 0.1, 20.0][..])),
        acceleration in any::<bool>(),
        in_rows in any::<bool>(),
    ) {
        let cases = cases();
        let case = &cases[index % cases.len()];
        let declared = Declared { unit, time_step, acceleration, in_rows, ..first() };
        let Some(found) = read(&case.text, &declared) else {
            return Ok(());
        };
        // The values read are those of the file, and nothing else was declared.
        if let Some(stated) = case.unit {
            prop_assert_eq!(found.unit(), stated, "{}", case.text);
            prop_assert!(unit.is_none_or(|unit| unit == stated), "{:?} taken for {:?}", unit, stated);
        }
        if let Some(stated) = case.time_step {
            prop_assert!((found.time_step() - stated).abs() < 1e-9, "{}", case.text);
            prop_assert!(time_step.is_none_or(|step| (step - stated).abs() < 1e-9), "{:?} taken for {}", time_step, stated);
        }
        let silent = read(&case.text, &filled(case, &declared)).expect("read with less");
        prop_assert_eq!(found.values(), silent.values(), "{}", case.text);
    }
}

/// Missing information may be declared; stated information may be repeated.
#[test]
fn limit_what_is_missing_is_asked_for_and_what_is_said_may_be_repeated() {
    for case in cases() {
        let repeated = Declared {
            unit: case.unit.or(Some(AccelerationUnit::MilliG)),
            time_step: case.time_step.or(Some(0.01)),
            ..first()
        };
        let found = read_declared(case.text.as_bytes(), &repeated);
        let found = found.unwrap_or_else(|error| panic!("{error}: {}", case.text));
        if case.unit.is_none() {
            let silent = Declared {
                unit: None,
                ..repeated.clone()
            };
            assert!(read(&case.text, &silent).is_none(), "{}", case.text);
        }
        if case.time_step.is_none() {
            let silent = Declared {
                time_step: None,
                ..repeated.clone()
            };
            assert!(read(&case.text, &silent).is_none(), "{}", case.text);
        }
        let silent = read(&case.text, &filled(&case, &repeated)).expect("the same without repeating");
        assert_eq!(found.values(), silent.values());
    }
}
