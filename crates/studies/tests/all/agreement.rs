//! Agreement with the published numbers: reproduced and other numbers, and messages about changes.

use pounding_studies::{Comparison, Completed, PrintedDigits, PublishedValues, StudyError, StudyFile, StudyTable, Value, Verdict};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

type Values = BTreeMap<String, Vec<Value>>;

fn studies() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies")
}

fn published() -> PublishedValues {
    PublishedValues::read(&studies().join("published")).expect("the published values are readable")
}

/// The computed numbers of every table.
static COMPUTED: LazyLock<Values> = LazyLock::new(|| {
    ["table-2", "table-4", "table-5", "table-6", "table-7", "text"]
        .map(|id| {
            let path = studies().join(id).with_extension("json");
            let study = StudyFile::read(&path).expect("a readable study");
            let completed = Completed::run(study, &|| ()).expect("a study that runs");
            let table = StudyTable::of(&completed).expect("scenes that give the table");
            let values = table.expect("a study that prints a table").values;
            (id.trim_start_matches("table-").to_string(), values)
        })
        .into()
});

fn comparisons() -> Vec<Comparison> {
    published().compare(&COMPUTED)
}

/// The messages after a change of one computed number.
fn surprises(table: &str, row: &str, quantity: &str, change: impl Fn(&mut f64)) -> Vec<String> {
    let mut computed = COMPUTED.clone();
    let values = computed.get_mut(table).expect("a table");
    let value = values.iter_mut().find(|value| value.row == row && value.quantity == quantity);
    change(&mut value.expect("a number of the table").value);
    let published = published();
    published.surprises(&published.compare(&computed))
}

#[test]
fn issue_disagreements_are_the_known_ones() {
    let surprises = published().surprises(&comparisons());
    assert!(surprises.is_empty(), "{}", surprises.join("\n"));
}

#[test]
fn issue_every_published_number_is_computed() {
    let comparisons = comparisons();
    // Tables 2, 4, 5, 6 and 7, and the text.
    assert_eq!(comparisons.len(), 37 + 48 + 4 + 18 + 18 + 8, "published numbers");
    for Comparison { published, computed, .. } in comparisons {
        assert!(computed.is_some(), "nothing computes {published:?}");
    }
}

#[test]
fn limit_every_unlike_number_has_a_reason() {
    for comparison in comparisons() {
        let needs_reason = comparison.verdict != Verdict::Reproduced || comparison.digits == PrintedDigits::Other;
        assert_eq!(needs_reason, !comparison.reason.is_empty(), "{comparison:?}");
    }
}

/// The paper prints 131 numbers of its runs. It compares two further numbers, of another work, itself: they get no verdict.
#[test]
fn issue_every_number_of_the_paper_s_own_runs_is_reproduced() {
    let own: Vec<_> = comparisons()
        .into_iter()
        .filter(|number| !number.published.row.starts_with("reference [7]"))
        .collect();
    assert_eq!(own.len(), 131);
    for Comparison { published, computed, .. } in &own {
        let (printed, computed) = (published.published.value, computed.expect("a computed value"));
        assert!((computed - printed).abs() <= 1.5e-4 * printed.abs(), "{published:?}: {computed}");
    }
    let others: Vec<_> = own
        .iter()
        .filter(|number| number.digits == PrintedDigits::Other)
        .map(|number| &*number.published.row)
        .collect();
    assert_eq!(others, ["layout A nonlinear middle"]);
}

#[test]
fn issue_a_new_disagreement_is_a_surprise() {
    let told = surprises("2", "elastic 1", "force on weak", |force| *force *= 1.0011);
    assert_eq!(
        told,
        ["table 2, elastic 1, force on weak: found \"close\", studies/published/reasons.csv says \"reproduced\""]
    );
}

/// A listed reason for numbers that are reproduced.
#[test]
fn issue_a_disagreement_that_vanished_is_a_surprise() {
    let known = |reason: &str| {
        let published = changed("vanished", "reasons.csv", |text| text + reason);
        let published = published.expect("well formed");
        published.surprises(&published.compare(&COMPUTED))
    };
    assert_eq!(
        known("6,layout C elastic left,transferred momentum,differs,?\n"),
        ["table 6, layout C elastic left, transferred momentum: found \"reproduced\", \
          studies/published/reasons.csv says \"differs\""]
    );
    assert_eq!(
        known("6,layout C elastic left,transferred momentum,reproduced,?\n"),
        ["table 6, layout C elastic left, transferred momentum: found as printed, \
          studies/published/reasons.csv gives a reason why not"]
    );
}

#[test]
fn issue_a_disagreement_in_the_last_digit_is_a_surprise() {
    let row = "layout C elastic left";
    let told = surprises("6", row, "transferred momentum", |momentum| {
        *momentum = 1694.7;
    });
    assert_eq!(
        told,
        [
            "table 6, layout C elastic left, transferred momentum: found other digits than printed, \
          studies/published/reasons.csv gives no reason"
        ]
    );
}

#[test]
fn issue_a_number_that_is_no_longer_computed_is_a_surprise() {
    let mut computed = COMPUTED.clone();
    computed.remove("5");
    let published = published();
    let told = published.surprises(&published.compare(&computed));
    assert_eq!(told.len(), 4, "Table 5 has four numbers: {told:?}");
    assert!(told.iter().all(|surprise| surprise.starts_with("table 5, ")), "{told:?}");
}

/// A number in another unit is not the published number.
#[test]
fn issue_a_number_in_another_unit_is_a_surprise() {
    let mut computed = COMPUTED.clone();
    computed.get_mut("5").expect("Table 5")[0].unit = "N·s";
    let published = published();
    let told = published.surprises(&published.compare(&computed));
    assert_eq!(told.len(), 1, "{told:?}");
}

/// A copy of the published values with one file changed.
fn changed(test: &str, file: &str, change: impl Fn(String) -> String) -> Result<PublishedValues, StudyError> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("agreement").join(test);
    fs::create_dir_all(&folder).expect("the folder can be made");
    for entry in fs::read_dir(studies().join("published")).expect("the folder is there") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a file");
        let mut text = fs::read_to_string(&path).expect("a readable file");
        if name == file {
            text = change(text);
        }
        fs::write(folder.join(name), text).expect("the copy can be written");
    }
    PublishedValues::read(&folder)
}

#[test]
fn issue_a_reason_for_nothing_is_a_surprise() {
    let published = changed("reason", "reasons.csv", |text| {
        text + "6,layout D left,transferred momentum,close,?\n"
    })
    .expect("well formed");
    assert_eq!(
        published.surprises(&published.compare(&COMPUTED)),
        ["reasons.csv names a number that is not published: (\"6\", \"layout D left\", \"transferred momentum\")"]
    );
}

#[test]
fn extreme_published_number_is_a_word() {
    let error = changed("word", "table-5.csv", |text| text.replace("36.07", "thirty-six"));
    let message = error.expect_err("no number").to_string().replace('\\', "/");
    let (_, message) = message.split_once("agreement/word/").expect("the file is named");
    insta::assert_snapshot!(message, @r#"table-5.csv: line 2: found "thirty-six", allowed a decimal number"#);
}

#[test]
fn extreme_verdict_unknown() {
    let error = changed("verdict", "reasons.csv", |text| text.replacen(",not comparable,", ",near,", 1));
    let message = error.expect_err("no verdict").to_string().replace('\\', "/");
    let (_, message) = message.split_once("agreement/verdict/").expect("the file is named");
    insta::assert_snapshot!(message, @"reasons.csv: line 3: unknown variant `near`, expected one of `reproduced`, `close`, `differs`, `not comparable`");
}
