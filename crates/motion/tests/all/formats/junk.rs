//! Damaged files are read or refused and never cause a panic.

use pounding_motion::{AccelerationUnit, Declared, components, read_declared};
use proptest::prelude::*;

use super::{accelerogram, file};

const FILES: [&str; 12] = [
    "cosmos.v0",
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

/// The first component, and the information that a file may leave to the caller.
fn declared(per_count: Option<f64>) -> Declared {
    Declared {
        unit: Some(AccelerationUnit::CentimetrePerSecondSquared),
        time_step: None,
        component: Some("1".to_owned()),
        per_count,
        acceleration: true,
        in_rows: false,
    }
}

/// Asserts that the file is refused, or read as usable numbers.
fn check(bytes: &[u8], declared: &Declared) {
    let names = components(bytes);
    let Ok(found) = read_declared(bytes, declared) else {
        return;
    };
    assert!(names.is_ok(), "read, but {names:?}");
    let step = found.time_step();
    assert!(step.is_finite() && step > 0.0, "time step {step}");
    assert!(!found.values().is_empty(), "no values");
    let finite = found.values().iter().all(|value| value.is_finite());
    assert!(finite, "a value that is not finite");
}

#[test]
fn extreme_every_cut_of_a_file_is_refused_or_loses_nothing_of_the_channel() {
    for name in FILES {
        let text = file(name);
        let declared = Declared {
            component: Some("1".to_owned()),
            ..declared((name == "cosmos.v0").then_some(2.0))
        };
        let declared = Declared {
            unit: declared.unit.filter(|_| name == "cosmos.v0"),
            ..declared
        };
        let whole = accelerogram(&text, &declared);
        for length in (0..text.len()).step_by(7) {
            let _ = components(&text.as_bytes()[..length]);
            if let Ok(found) = read_declared(&text.as_bytes()[..length], &declared) {
                // A cut may remove only the last digits of the last value.
                let n_values = whole.values().len();
                assert_eq!(found.values().len(), n_values, "{name} cut at {length}");
                assert_eq!(found.values()[..n_values - 1], whole.values()[..n_values - 1]);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn extreme_bytes_replaced(name in prop::sample::select(&FILES[..]), changes in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(&b" 0123456789.-+E(),:=/\n\r|&*#\xff\0gG"[..])), 1..6), counts in any::<bool>()) {
        let mut bytes = file(name).into_bytes();
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        check(&bytes, &declared(counts.then_some(2.0)));
        check(&bytes, &Declared::default());
    }

    #[test]
    fn extreme_lines_lost_or_repeated(name in prop::sample::select(&FILES[..]), line in any::<prop::sample::Index>(), repeat in 0..3_usize) {
        let text = file(name);
        let lines: Vec<&str> = text.lines().collect();
        let at = line.index(lines.len());
        let mut changed = lines[..at].to_vec();
        changed.extend(std::iter::repeat_n(lines[at], repeat));
        changed.extend(&lines[at + 1..]);
        check(changed.join("\n").as_bytes(), &declared(None));
    }
}

const TOKENS: [&str; 40] = [
    "dt",
    "=",
    "0.01",
    "npts",
    "40",
    "g",
    "(cm/s)",
    "time",
    "NS",
    "EW",
    "1",
    "-0.5",
    ";",
    ",",
    "\n",
    "\n",
    "\n",
    "#",
    " ",
    " ",
    "2020-01-01T00:00:00",
    "2020-01-01T00:00:00.01",
    "1,5",
    "0,25",
    "***",
    "END",
    "Sampling rate:",
    "velocity (",
    "units:",
    "é",
    "0.25-0.25",
    "\u{1a}",
    "\r\n",
    "1e300",
    "component: ",
    "Sa (g)",
    "Period",
    "[",
    "]",
    "1577836800000",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn extreme_texts_of_words_and_numbers(tokens in prop::collection::vec(prop::sample::select(&TOKENS[..]), 1..40), in_rows in any::<bool>()) {
        let text = tokens.concat();
        let declared = Declared { in_rows, time_step: Some(0.01), ..declared(None) };
        check(text.as_bytes(), &declared);
        check(text.as_bytes(), &Declared::default());
        let _ = pounding_motion::contents(text.as_bytes());
    }
}
