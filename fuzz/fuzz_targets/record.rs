//! Any bytes as a record file: read or refused, never a panic; what is read is finite and can be used.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(file) = pounding_motion::read(bytes) else {
        return;
    };
    assert!(file.time_step() > 0.0 && file.time_step().is_finite(), "time step {}", file.time_step());
    assert!(
        file.values().len() <= bytes.len(),
        "{} values of {} bytes",
        file.values().len(),
        bytes.len()
    );
    assert!(file.values().iter().all(|value| value.is_finite()), "a value that is not finite");
    if let Ok(record) = file.into_record(9.81) {
        assert!(record.samples().iter().all(|sample| sample.is_finite()), "a sample that is not finite");
    }
});
