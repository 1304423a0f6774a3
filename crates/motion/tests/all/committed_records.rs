//! The records that the project ships.

use pounding_motion::{Record, read};

fn record(text: &str) -> Record {
    let found = read(text.as_bytes()).expect("a readable CSV");
    // The values stay in g, as in the file.
    found.into_record(1.0).expect("finite values")
}

#[test]
fn reference_el_centro_of_pacific_engineering() {
    let record = record(include_str!(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../studies/records/el-centro-1940-ns-peer-pacific-engineering.csv"
    )));
    assert_eq!(record.samples().len(), 3995);
    assert_eq!(record.time_step().to_string(), "0.01");
    let (time, acceleration) = record.peak();
    assert!((time - 2.15).abs() < 0.02, "peak at {time} s");
    assert!((acceleration + 0.3129).abs() < 1e-4, "peak of {acceleration} g");
    assert_eq!(record.source().lines().count(), 4);
}

#[test]
fn reference_el_centro_of_chopra() {
    let record = record(include_str!(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../studies/records/el-centro-1940-ns-chopra.csv"
    )));
    assert_eq!(record.samples().len(), 1560);
    assert_eq!(record.time_step().to_string(), "0.02");
    let (_, acceleration) = record.peak();
    assert!((acceleration.abs() - 0.3188).abs() < 1e-4, "peak of {acceleration} g");
}
