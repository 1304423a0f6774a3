//! Tests that write the tables of numbers in documents: they must equal those of the program.

use pounding::scene::{FloorQuantity, LinkQuantity, PairQuantity, Quantity};
use pounding::sweep::Outputs;
use serde::de::DeserializeOwned;
use serde_json::json;

use crate::law_lists::{code, renew, with_table};

/// The meaning of a number, as a cell of a table.
fn meaning(quantity: Quantity) -> String {
    let sentence = quantity.about().meaning.trim_end_matches('.');
    let (first, rest) = sentence.split_at(1);
    format!("{}{rest}", first.to_lowercase())
}

/// Rows of a table of `summary.json`: name, unit, name of the error, meaning.
fn of_summary<Q: Into<Quantity> + Copy>(all: &[Q]) -> impl Iterator<Item = Vec<String>> {
    all.iter().map(|one| {
        let quantity = (*one).into();
        let about = quantity.about();
        let name = match about.collision {
            Some(collision) => about.name.replacen(&format!("{collision}_"), &format!("{collision}."), 1),
            None => about.name.into(),
        };
        let error = about.error_name().map_or_else(String::new, code);
        vec![code(&name), about.unit.symbol.into(), error, meaning(quantity)]
    })
}

/// Rows of a table of outputs of a sweep: name, unit, default, meaning.
fn of_sweep<Q: Into<Quantity> + Copy + PartialEq + DeserializeOwned>(all: &[Q], default: &[Q]) -> impl Iterator<Item = Vec<String>> {
    let allowed = |one: &&Q| serde_json::from_value::<Q>(json!((**one).into().about().name)).is_ok();
    all.iter().filter(allowed).map(|one| {
        let quantity = (*one).into();
        let about = quantity.about();
        let is_default = if default.contains(one) { "yes" } else { "no" };
        vec![code(about.name), about.unit.symbol.into(), is_default.into(), meaning(quantity)]
    })
}

#[test]
fn limit_the_reference_of_results_lists_the_numbers() {
    renew("docs/reference/results.md", |page| {
        let head = ["Number of a structure", "Unit", "Its error", "Meaning"];
        let page = with_table(page, &head, of_summary(FloorQuantity::ALL));
        let head = ["Number of a pair", "Unit", "Its error", "Meaning"];
        let page = with_table(&page, &head, of_summary(PairQuantity::ALL));
        let head = ["Number of a link", "Unit", "Its error", "Meaning"];
        with_table(&page, &head, of_summary(LinkQuantity::ALL))
    });
}

#[test]
fn limit_the_reference_of_sweeps_lists_the_outputs() {
    let default = Outputs::default();
    renew("docs/reference/sweep.md", |page| {
        let structures = of_sweep(FloorQuantity::ALL, &default.structures);
        let page = with_table(page, &["Output of structures", "Unit", "Default", "Meaning"], structures);
        let pairs = of_sweep(PairQuantity::ALL, &default.pairs);
        let page = with_table(&page, &["Output of pairs", "Unit", "Default", "Meaning"], pairs);
        let links = of_sweep(LinkQuantity::ALL, &default.links);
        with_table(&page, &["Output of links", "Unit", "Default", "Meaning"], links)
    });
}
