//! Snapshots of every table, of the agreement and of the claims: a changed snapshot is a changed result.

use std::path::Path;

use insta::{assert_snapshot, glob};
use pounding_studies::{Completed, Studies, StudyFile, StudyTable};

#[test]
fn reference_tables() {
    glob!("../../../../studies", "{table-*,text}.json", |path| {
        let study = StudyFile::read(path).expect("a readable study");
        let completed = Completed::run(study, &|| ()).expect("a study that runs");
        let table = StudyTable::of(&completed).expect("scenes that give the table");
        assert_snapshot!(table.expect("a study that prints a table").to_csv());
    });
}

#[test]
fn reference_agreement_claims_and_converged_tables() {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let made = Studies::read(&studies)
        .expect("readable studies")
        // These studies write none of the snapshot files.
        .only(|file| !["trade", "laws", "beyond", "extremes"].contains(&file.id.as_str()))
        // The committed results use 200; three runs give the same columns in a fraction of the time.
        .with_noisy_runs(3)
        .reproduce(&|| ());
    let files = made.expect("studies that run").files;
    let text = |path: &Path| std::str::from_utf8(&files[path]).expect("CSV is text");
    for name in ["agreement.csv", "claims.csv"] {
        assert_snapshot!(name, text(Path::new(name)));
    }
    for name in ["slips.csv", "combinations.csv"] {
        assert_snapshot!(name, text(&Path::new("paper").join(name)));
    }
    assert_known(text(Path::new("paper/slips.csv")));
    for table in ["2", "4", "5", "6", "7"] {
        let name = format!("converged-{table}.csv");
        assert_snapshot!(name.clone(), text(&Path::new("tables").join(&name)));
    }
}

/// Totals \[kN·s\] without one choice of the paper's program, by an independent finder of that choice: table, scene, column, and the three
/// structures.
const KNOWN: [(&str, &str, &str, [f64; 3]); 17] = [
    ("6", "layout A elastic", "papers_program", [456.95, 1170.77, 725.36]),
    ("6", "layout C elastic", "papers_program", [1694.59, 3397.04, 1702.45]),
    ("7", "layout A elastic", "papers_program", [207.06, 467.27, 293.94]),
    ("7", "layout B elastic", "papers_program", [409.72, 681.92, 272.21]),
    ("7", "layout A elastic", "loads_as_recorded", [207.74, 469.18, 295.11]),
    ("7", "layout B elastic", "loads_as_recorded", [409.74, 681.98, 272.24]),
    ("6", "layout C elastic", "length_of_loads", [1326.9, 2614.7, 1287.8]),
    ("7", "layout A elastic", "length_of_loads", [199.27, 459.48, 293.94]),
    ("7", "layout B elastic", "length_of_loads", [409.71, 679.31, 269.60]),
    ("6", "layout A elastic", "forces_added", [463.69, 1157.18, 715.15]),
    ("6", "layout C elastic", "forces_added", [1694.59, 3397.04, 1702.45]),
    ("7", "layout A elastic", "forces_added", [200.54, 498.89, 338.65]),
    ("7", "layout B elastic", "forces_added", [409.72, 681.92, 272.21]),
    ("6", "layout A elastic", "velocities_before_both", [407.27, 1213.69, 817.25]),
    ("6", "layout C elastic", "velocities_before_both", [1694.59, 3397.04, 1702.45]),
    ("6", "layout A elastic", "impacts_on_approach", [584.62, 1300.46, 751.79]),
    ("6", "layout C elastic", "impacts_on_approach", [1408.1, 2803.1, 1395.0]),
];

fn assert_known(slips: &str) {
    let mut reader = csv::Reader::from_reader(slips.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row")).collect();
    for (table, scene, column, known) in KNOWN {
        let column = header.iter().position(|name| name == column);
        let column = column.expect("a column of this name");
        let has_one_decimal = known.iter().all(|one| (10.0 * one).fract().abs() < 1e-6);
        let allowed = if has_one_decimal { 0.051 } else { 0.0051 };
        for (place, known) in ["left", "middle", "right"].into_iter().zip(known) {
            let name = format!("{scene} {place}");
            let is = |row: &&csv::StringRecord| &row[0] == table && row[1] == name;
            let found = &rows.iter().find(is).expect("a row of this name")[column];
            let found: f64 = found.parse().expect("a number");
            assert!((found - known).abs() <= allowed, "{table}, {name}: {found}, {known}");
        }
    }
}
