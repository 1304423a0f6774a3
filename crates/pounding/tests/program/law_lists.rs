//! Tests that write the lists of laws in documents and in the dictionary of fuzzing: they must equal those of the program.

use std::path::Path;
use std::{env, fs};

use pounding::contact::{Exact, LawName, Parameter};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Compares a file with the version that the program makes. With `INSTA_UPDATE=always` the file is written; otherwise a difference fails.
pub(crate) fn renew(file: &str, renewed: impl Fn(&str) -> String) {
    let path = Path::new(ROOT).join(file);
    let text = fs::read_to_string(&path).expect("a file of the project");
    let renewed = renewed(&text);
    if env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        fs::write(path, renewed).expect("it can be written");
    } else {
        let why = "differs from the list of the program; INSTA_UPDATE=always writes it";
        assert!(text == renewed, "{file} {why}");
    }
}

/// A page with new rows in the table with this head.
pub(crate) fn with_table(page: &str, head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let head = line(&head.iter().map(ToString::to_string).collect::<Vec<_>>());
    let (before, after) = page.split_once(&head).expect("the page has that table");
    let (rule, after) = after.split_once('\n').expect("a line below the head");
    let after = after.trim_start_matches('\n');
    let end = after.find("\n\n").expect("text behind the table") + 1;
    let rows: String = rows.map(|row| line(&row)).collect();
    format!("{before}{head}{rule}\n{rows}{}", &after[end..])
}

/// The law names in scene files.
fn words_of_scenes() -> impl Iterator<Item = LawName> {
    let first = |law: &LawName| law.about().names[0].name == law.name();
    LawName::ALL.into_iter().filter(first)
}

/// Every parameter once, with a flag whether an e may replace it.
fn parameters() -> Vec<(&'static Parameter, bool)> {
    let mut parameters: Vec<(&Parameter, bool)> = Vec::new();
    for law in words_of_scenes() {
        let rows = law.parameters();
        let by_restitution = matches!(law.about().exact, Exact::Any(_));
        for (index, row) in rows.iter().enumerate() {
            if !parameters.iter().any(|(known, _)| known.name == row.name) {
                parameters.push((row, by_restitution && index + 1 == rows.len()));
            }
        }
    }
    parameters
}

pub(crate) fn code(name: &str) -> String {
    format!("`{name}`")
}

#[test]
fn limit_the_reference_of_scenes_lists_the_laws() {
    renew("docs/reference/scene.md", |page| {
        let laws = words_of_scenes().map(|law| {
            let fields: Vec<_> = law.parameters().iter().map(|row| code(row.name)).collect();
            vec![code(law.name()), law.about().force.into(), fields.join(", ")]
        });
        let page = with_table(page, &["Law", "Force", "Fields"], laws);
        let fields = parameters().into_iter().map(|(row, by_restitution)| {
            let default = if by_restitution { "this or `restitution`" } else { "required" };
            let Parameter {
                name,
                unit,
                meaning,
                allowed,
                ..
            } = row;
            [&code(name), *unit, allowed.words, default, *meaning].map(String::from).into()
        });
        let head = ["Field of laws", "Unit", "Allowed", "Default", "Meaning"];
        with_table(&page, &head, fields)
    });
}

#[test]
fn limit_the_theory_lists_the_laws() {
    renew("docs/theory.md", |page| {
        let cells = |law: LawName, cells: [&str; 2]| {
            let cells = cells.map(String::from);
            [vec![law.named().label.into()], cells.into()].concat()
        };
        let laws = LawName::ALL.into_iter();
        let sources = laws.map(|law| cells(law, [law.about().force, law.named().citation]));
        let page = with_table(page, &["Law", "Force", "Source"], sources);
        let damped = LawName::ALL.into_iter().filter(|law| {
            let exact = law.about().exact;
            matches!(exact, Exact::Any(_) | Exact::Pair(..))
        });
        let formulas = damped.map(|law| {
            let formula = law.named().formula.map_or("none", |(text, _)| text);
            let relation = law.about().relation.unwrap_or("none; e depends on the speed");
            cells(law, [formula, relation])
        });
        with_table(&page, &["Law", "Formula of the literature", "Exact relation"], formulas)
    });
}

#[test]
fn limit_fuzzing_knows_the_words_of_laws() {
    for words in ["fuzz/scene.dict", "fuzz/sweep.dict"] {
        renew(words, |text| {
            let laws = words_of_scenes().map(LawName::name);
            let names = laws.chain(parameters().into_iter().map(|(row, _)| row.name));
            let mut text = text.to_string();
            for word in names.map(|name| format!("\"{name}\"\n")) {
                if !text.contains(&word) {
                    text += &word;
                }
            }
            text
        });
    }
}
