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
fn reference_agreement_and_claims() {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let made = Studies::read(&studies)
        .expect("readable studies")
        .only(|file| file.id != "trade")
        .reproduce(&|| ());
    let files = made.expect("studies that run").files;
    for name in ["agreement.csv", "claims.csv"] {
        let text = std::str::from_utf8(&files[Path::new(name)]).expect("CSV is text");
        assert_snapshot!(name, text);
    }
}
