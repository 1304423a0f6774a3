//! Declarations of the caller: added, repeated, contradicted; and the units.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components};

use super::{accelerogram, component, file, refusal};

const CSV: &str = "time_s,acceleration_g\n0.00,0.5\n0.02,-0.25\n";

fn unit(unit: AccelerationUnit) -> Declared {
    Declared {
        unit: Some(unit),
        ..Declared::default()
    }
}

fn time_step(time_step: f64) -> Declared {
    Declared {
        time_step: Some(time_step),
        ..Declared::default()
    }
}

fn per_count(per_count: f64) -> Declared {
    Declared {
        per_count: Some(per_count),
        unit: Some(AccelerationUnit::MilliG),
        time_step: Some(0.01),
        ..Declared::default()
    }
}

#[test]
fn limit_repeating_what_the_file_says_changes_nothing() {
    let plain = accelerogram(CSV, &Declared::default());
    let repeated = Declared {
        time_step: Some(0.02),
        component: Some("1".to_owned()),
        ..unit(AccelerationUnit::StandardGravity)
    };
    assert_eq!(accelerogram(CSV, &repeated), plain);
}

#[test]
fn extreme_contradictions() {
    assert_snapshot!(refusal(CSV, &unit(AccelerationUnit::MetrePerSecondSquared)), @"line 1 says that the values are in g, but m_per_s2 is declared as `unit`; leave the declaration away");
    assert_snapshot!(refusal(CSV, &time_step(0.01)), @"line 2 gives a time step of 0.02 s, but 0.01 s is declared as `time_step`; leave the declaration away");
    assert_snapshot!(refusal(CSV, &time_step(f64::NAN)), @"the declared `time_step` is NaN s, and must be finite and above 0 s");
    assert_snapshot!(refusal(CSV, &time_step(0.0)), @"the declared `time_step` is 0 s, and must be finite and above 0 s");
    assert_snapshot!(refusal(CSV, &component("Up")), @r#""Up" is declared as `component`, but the file holds one, which has no name; leave the declaration away"#);
    assert_snapshot!(refusal(file("esm.asc"), &component("HNN")), @r#""HNN" is declared as `component`, but the file holds 1 = "HNE"; choose one of them by its name, a part of it, or its number"#);
    assert_snapshot!(refusal(CSV, &Declared { unit: None, time_step: None, ..per_count(2.0) }), @"line 1 says that the values are in g, but `per_count` is declared as 2; leave it away, there are no counts to scale");
    let scaled = |worth| refusal("1e30\n2.0\n", &per_count(worth));
    assert_snapshot!(scaled(0.0), @"the declared `per_count` is 0.0, and must be finite, not 0, and keep every value finite");
    assert_snapshot!(scaled(f64::INFINITY), @"the declared `per_count` is inf, and must be finite, not 0, and keep every value finite");
    assert_snapshot!(scaled(1e300), @"the declared `per_count` is 1e300, and must be finite, not 0, and keep every value finite");
}

#[test]
fn reference_units_and_their_powers_of_ten() {
    // The value 12.3 in each unit in m/s², with one g equal to 10 m/s².
    let expected = ["123", "12.3", "0.123", "0.0123", "0.123", "12.3"];
    for (unit, expected) in AccelerationUnit::ALL.into_iter().zip(expected) {
        let declared = Declared {
            unit: Some(unit),
            time_step: Some(1.0),
            ..Declared::default()
        };
        let record = accelerogram("12.3\n", &declared).into_record(10.0).unwrap();
        let found = record.samples()[0];
        let expected: f64 = expected.parse().unwrap();
        assert!((found - expected).abs() <= f64::EPSILON * expected, "{unit:?}: {found}");
        assert!(!unit.symbol().is_empty());
    }
    let mut names = AccelerationUnit::ALL.map(AccelerationUnit::name);
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
}

#[test]
fn reference_names_of_formats_differ() {
    let mut names = Format::ALL.map(Format::name);
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
    assert_eq!(components(CSV.as_bytes()).unwrap(), Vec::<String>::new());
}
