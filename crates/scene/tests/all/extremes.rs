//! Promises that the committed results of the extremes keep.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use pounding_contact::{Calibration, LawName};
use pounding_scene::{Certificate, CertificateRequest, FreeCollision, MethodLimits, StepMethod};
use sha2::{Digest, Sha256};

/// A file of results/extremes.
fn read(name: &str) -> String {
    let path = Path::new("../../results/extremes").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Rows of a table as pairs of column and value.
fn rows(text: &str) -> Vec<Vec<(String, String)>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let row = |record: csv::StringRecord| {
        let columns = header.iter().map(String::from);
        columns.zip(record.iter().map(String::from)).collect()
    };
    reader.records().map(|record| row(record.expect("a row"))).collect()
}

fn column<'a>(row: &'a [(String, String)], name: &str) -> &'a str {
    let found = row.iter().find(|(column, _)| column == name);
    &found.unwrap_or_else(|| panic!("no column {name}")).1
}

#[test]
fn reference_the_part_that_every_run_repeats_is_in_the_whole() {
    let whole = read("cells.csv");
    let whole: BTreeSet<&str> = whole.lines().collect();
    let part = read("part/cells.csv");
    let missing: Vec<_> = part.lines().filter(|row| !whole.contains(row)).collect();
    assert!(part.lines().count() > 100, "a part worth its name");
    assert!(
        missing.is_empty(),
        "run `cargo xtask reproduce --all`; not in the whole:\n{}",
        missing.join("\n")
    );
}

#[test]
fn reference_the_whole_is_what_its_command_made() {
    for table in ["cells.csv", "summary.csv"] {
        let hash = format!("{:x}", Sha256::digest(read(table).as_bytes()));
        assert!(read("made-by.txt").contains(&hash), "{table}: {hash}");
    }
}

#[test]
fn extreme_no_number_is_silently_wrong_and_few_are_warned_of_in_vain() {
    let summary = rows(&read("summary.csv"));
    for row in &summary {
        assert_eq!(column(row, "silently_wrong"), "0", "{}", column(row, "name"));
    }
    let all = summary.last().expect("a last row");
    assert_eq!(column(all, "by"), "all");
    let number = |name: &str| column(all, name).parse::<f64>().expect("a number");
    // Counts only numbers that can be a false alarm.
    assert!(number("false_alarms") <= 0.05 * number("compared"), "{all:?}");
    assert!(number("wrong_refusals") <= 0.01 * number("numbers"), "{all:?}");
}

#[test]
fn extreme_the_summary_counts_the_cells() {
    let cells = rows(&read("cells.csv"));
    let summary = rows(&read("summary.csv"));
    let quantities = [
        "time_of_first_collision",
        "impulse_of_first_collision",
        "transferred_momentum",
        "peak_pounding_force_or_impulse",
        "peak_displacement",
        "peak_shear_force",
    ];
    for row in summary.iter().filter(|row| column(row, "by") == "method") {
        let own = cells.iter().filter(|cell| column(cell, "method") == column(row, "name"));
        let numbers: Vec<_> = own
            .flat_map(|cell| {
                quantities.map(|key| {
                    let error = column(cell, &format!("{key}_error")).parse::<f64>().ok();
                    let warned = column(cell, "warned").split(' ').any(|other| other == key);
                    (column(cell, key), error, warned)
                })
            })
            .collect();
        let name = column(row, "name");
        for class in ["accurate", "degraded", "refused", "diverged_and_caught"] {
            let found = numbers.iter().filter(|(other, ..)| *other == class).count();
            assert_eq!(found.to_string(), column(row, class), "{name}, {class}");
        }
        // The errors themselves are counted.
        let printed = |class: &str| !matches!(class, "refused" | "diverged_and_caught");
        let silent = numbers
            .iter()
            .filter(|(class, error, warned)| printed(class) && !warned && *error > Some(0.11));
        assert_eq!(silent.count(), 0, "{name}");
    }
}

#[test]
fn reference_ten_steps_per_contact_deliver_the_impulse_to_6_per_cent() {
    let collision = FreeCollision {
        masses: [75e3, 3e6],
        speed: 0.3,
    };
    for restitution in [0.65, 0.9] {
        for law in LawName::ALL {
            let stiffness = match law.stiffness_unit() {
                Some("N/m") => 9.35e7,
                _ => 2.75e9,
            };
            let wanted = CertificateRequest {
                law,
                stiffness,
                restitution,
                calibration: Calibration::Exact,
            };
            let Ok(certificate) = Certificate::new(&wanted, &collision) else {
                assert!(law.is_elastic(), "{law:?}");
                continue;
            };
            let Some(impact) = certificate.impact else {
                continue;
            };
            for method in StepMethod::differing(false) {
                let scheme = method.at(impact.duration / MethodLimits::STEPS_PER_CONTACT);
                let delivered = certificate.by(&collision, &scheme).expect("a run");
                let off = delivered.error / (1.0 + restitution);
                assert!(off < 0.06, "{law:?}, {}: {off}", method.name());
            }
        }
    }
}
