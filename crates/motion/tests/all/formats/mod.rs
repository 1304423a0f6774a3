//! Every format except CSV and AT2: the readings of a small file, and the message of each refusal.
//!
//! The files are made by hand in the layouts of the networks, with invented values.

mod contents;
mod contradictions;
mod cosmos;
mod csmip;
mod declared;
mod geonet;
mod junk;
mod knet;
mod lists;
mod miniseed;
mod no_motion;
mod plain;
mod real_files;
mod rows;
mod sac;
mod said;
mod smc;
mod tables;

use pounding_motion::{Accelerogram, Declared, read_declared};

/// The text of a file of this folder.
fn file(name: &str) -> String {
    let path = format!("{}/tests/files/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The file with one piece replaced, which must be there.
fn with(name: &str, from: &str, to: &str) -> String {
    let text = file(name);
    assert!(text.contains(from), "{name} has no {from:?}");
    text.replacen(from, to, 1)
}

fn accelerogram(bytes: impl AsRef<[u8]>, declared: &Declared) -> Accelerogram {
    read_declared(bytes.as_ref(), declared).unwrap_or_else(|error| panic!("{error}"))
}

fn refusal(bytes: impl AsRef<[u8]>, declared: &Declared) -> String {
    read_declared(bytes.as_ref(), declared)
        .expect_err("a file that is refused")
        .to_string()
}

/// A declaration of only the component.
fn component(name: &str) -> Declared {
    Declared {
        component: Some(name.to_owned()),
        ..Declared::default()
    }
}

/// The readings, one per line.
fn readings(found: &Accelerogram) -> String {
    let lines = found.readings().iter().map(|reading| match reading.line {
        Some(line) => format!("{} (line {line}): {}", reading.what, reading.found),
        None => format!("{}: {}", reading.what, reading.found),
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Values with changing signs, the largest below one.
fn wave(n_values: usize) -> Vec<f64> {
    let value = |step: usize| {
        let step = f64::from(u32::try_from(step).expect("few values"));
        0.9 * libm::sin(0.37 * step) * libm::cos(0.011 * step)
    };
    (0..n_values).map(value).collect()
}

/// One row per value of a [wave], made from its number and the value.
fn rows_of(n_values: usize, row: impl Fn(f64, f64) -> String) -> String {
    let values = wave(n_values).into_iter();
    let numbered = (0..).map(f64::from).zip(values);
    let rows: Vec<String> = numbered.map(|(number, value)| row(number, value)).collect();
    rows.concat()
}
