//! Every table as text, the agreement and the claims: a snapshot that changes is a result that changed.

use std::path::Path;

use insta::{assert_snapshot, glob};
use pounding_studies::{Completed, Studies, StudyFile, Table};

#[test]
fn reference_tables() {
    glob!("../../../studies", "{table-*,text}.json", |path| {
        let study = StudyFile::read(path).expect("a readable study");
        let completed = Completed::run(study, &|| ()).expect("a study that runs");
        let table = Table::of(&completed).expect("scenes that give the table");
        assert_snapshot!(table.expect("a study that prints a table").to_csv());
    });
}

#[test]
fn reference_agreement_claims_and_converged_tables() {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let made = Studies::read(&studies)
        .expect("readable studies")
        // Of which nothing is in these files.
        .only(|file| !["trade", "laws", "beyond", "extremes"].contains(&file.id.as_str()))
        // The committed results have 200; three show the same columns in a fraction of the time.
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
    for table in ["2", "4", "5", "6", "7"] {
        let name = format!("converged-{table}.csv");
        assert_snapshot!(name.clone(), text(&Path::new("tables").join(&name)));
    }
}
