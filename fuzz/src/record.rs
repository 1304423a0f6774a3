//! The assertions on every record file: it is read or refused without a panic, and values that are read are finite and usable.

use pounding_motion::{AccelerationUnit, Declared, Direction, NamedFile, components, contents, read_declared};

/// Reads some bytes with more and more declarations of the caller.
pub(crate) fn check(bytes: &[u8]) {
    for name in components(bytes).unwrap_or_default() {
        let _ = Direction::of_component(&name);
    }
    if let Ok(found) = contents(bytes) {
        assert!(!found.channels.is_empty(), "no channel");
    }
    let name = String::from_utf8_lossy(bytes);
    let _ = NamedFile::of_all(&[&*name, "A-ELC180.AT2", "A-ELC-UP.AT2"]);
    read(bytes, &Declared::default());
    let first = Declared {
        component: Some("1".to_owned()),
        ..Declared::default()
    };
    read(bytes, &first);
    let unit = Declared {
        unit: Some(AccelerationUnit::MilliG),
        ..first
    };
    read(bytes, &unit);
    let step = Declared {
        time_step: Some(0.01),
        ..unit
    };
    read(bytes, &step);
    let counts = Declared {
        per_count: Some(-0.5),
        time_step: None,
        ..step
    };
    read(bytes, &counts);
    let turned = Declared {
        acceleration: true,
        ..counts
    };
    read(bytes, &turned);
    let in_rows = Declared {
        in_rows: true,
        per_count: None,
        time_step: Some(0.01),
        ..turned
    };
    read(bytes, &in_rows);
}

fn read(bytes: &[u8], declared: &Declared) {
    let file = match read_declared(bytes, declared) {
        Ok(file) => file,
        Err(refused) => {
            assert!(!refused.to_string().is_empty(), "{refused:?}");
            return;
        }
    };
    let step = file.time_step();
    assert!(step > 0.0 && step.is_finite(), "time step {step}");
    // A packed value takes more than half a byte.
    let n_values = file.values().len();
    assert!(n_values <= 2 * bytes.len(), "{n_values} values of {} bytes", bytes.len());
    let finite = file.values().iter().all(|value| value.is_finite());
    assert!(finite, "a value that is not finite");
    if let Ok(record) = file.into_record(9.81) {
        let finite = record.samples().iter().all(|sample| sample.is_finite());
        assert!(finite, "a sample that is not finite");
    }
}
