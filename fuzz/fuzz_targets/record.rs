//! Any bytes as a record file: read or refused, never a panic; what is read is finite and can be used.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pounding_motion::{AccelerationUnit, Declared, components, read_declared};

fuzz_target!(|bytes: &[u8]| {
    let _ = components(bytes);
    check(bytes, &Declared::default());
    let first = Declared {
        component: Some("1".to_owned()),
        ..Declared::default()
    };
    check(bytes, &first);
    let unit = Declared {
        unit: Some(AccelerationUnit::MilliG),
        ..first
    };
    check(bytes, &unit);
    let step = Declared {
        time_step: Some(0.01),
        ..unit
    };
    check(bytes, &step);
    let counts = Declared {
        per_count: Some(-0.5),
        time_step: None,
        ..step
    };
    check(bytes, &counts);
});

fn check(bytes: &[u8], declared: &Declared) {
    let Ok(file) = read_declared(bytes, declared) else {
        return;
    };
    assert!(file.time_step() > 0.0 && file.time_step().is_finite(), "time step {}", file.time_step());
    // Packed values take more than half a byte each.
    assert!(
        file.values().len() <= 2 * bytes.len(),
        "{} values of {} bytes",
        file.values().len(),
        bytes.len()
    );
    assert!(file.values().iter().all(|value| value.is_finite()), "a value that is not finite");
    if let Ok(record) = file.into_record(9.81) {
        assert!(record.samples().iter().all(|sample| sample.is_finite()), "a sample that is not finite");
    }
}
