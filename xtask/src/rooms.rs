//! The crates and their modules: allowed dependencies, and sizes.
//!
//! An arrow goes from a user to the used item. Between crates, arrows only go down the list of [`CRATES`]. The modules of a folder must not
//! form a circle; modules inside them count as part of them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

mod circles;
mod source;

use circles::circle;
use source::Source;

/// Folders of the crates in storeys, from the ground up: a crate may use crates below its storey.
const CRATES: [&[&str]; 9] = [
    &["crates/files", "crates/text"],
    &["crates/contact", "crates/motion", "crates/plot", "crates/risk"],
    &["crates/solver"],
    &["crates/lanes", "crates/reference", "crates/scene"],
    &["crates/assess"],
    &["crates/report", "crates/sweep"],
    &["crates/pounding", "crates/python", "crates/studies"],
    &["bench"],
    &["xtask"],
];

/// Largest part of all code lines in a single crate \[–\].
const LARGEST: f64 = 0.3;

/// Prints the table of crates.
///
/// # Errors
/// Arrows that run up, circles of modules, or a crate that has become too large.
pub(crate) fn check(root: &Path) -> Result<(), String> {
    let mut faults = Vec::new();
    let mut below = BTreeSet::new();
    let mut table = Vec::new();
    for storey in CRATES {
        let mut own = Vec::new();
        for folder in storey {
            let (name, used) = manifest(&root.join(folder).join("Cargo.toml"))?;
            let up = used.iter().filter(|used| !below.contains(*used));
            faults.extend(up.map(|used| format!("{name} uses {used}, which is not below it")));
            let source = Source::read(&root.join(folder).join("src"))?;
            faults.extend(circles_of(&name, &source));
            table.push((name.clone(), source.n_lines(), source.n_public(), used));
            own.push(name);
        }
        below.extend(own);
    }
    let all: usize = table.iter().map(|(_, lines, ..)| lines).sum();
    println!("   {:<20} {:>6} {:>4} {:>6}  uses", "crate", "code", "%", "public");
    for (name, lines, public, used) in &table {
        let part = *lines as f64 / all as f64;
        let used: Vec<_> = used.iter().map(|name| short(name)).collect();
        println!(
            "   {:<20} {lines:>6} {:>4.0} {public:>6}  {}",
            short(name),
            100.0 * part,
            used.join(", ")
        );
        if part > LARGEST {
            faults.push(format!(
                "{name} has {:.0} % of all code lines, allowed are {:.0} %",
                100.0 * part,
                100.0 * LARGEST
            ));
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

/// Name of a crate without the common prefix.
fn short(name: &str) -> &str {
    name.strip_prefix("pounding-").unwrap_or(name)
}

/// Name of a crate, and the crates of the workspace that it uses.
fn manifest(path: &Path) -> Result<(String, BTreeSet<String>), String> {
    let fault = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = fs::read_to_string(path).map_err(|error| fault(&error))?;
    let manifest: toml::Table = text.parse().map_err(|error: toml::de::Error| fault(&error))?;
    let name = manifest["package"]["name"].as_str().unwrap_or_default();
    let used = manifest.get("dependencies").and_then(toml::Value::as_table);
    let used = used.into_iter().flat_map(toml::Table::keys);
    let own = used.filter(|used| used.starts_with("pounding"));
    Ok((name.into(), own.cloned().collect()))
}

/// The circles among the modules of every folder of a crate.
fn circles_of(name: &str, source: &Source) -> Vec<String> {
    let folders = source.folders();
    let found = folders.iter().filter_map(|folder| {
        let arrows = siblings(folder, source);
        let names = circle(&arrows)?;
        let place = [vec![short(name).to_owned()], folder.clone()].concat().join("::");
        Some(format!("{place}: a circle of modules: {}", names.join(" → ")))
    });
    found.collect()
}

/// For each module of a folder, the other modules of the folder that it uses.
fn siblings(folder: &[String], source: &Source) -> BTreeMap<String, BTreeSet<String>> {
    let inside = |module: &[String]| {
        let rest = module.strip_prefix(folder)?;
        rest.first().cloned()
    };
    let mut arrows: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (from, to) in source.arrows() {
        if let (Some(from), Some(to)) = (inside(from), inside(to))
            && from != to
        {
            arrows.entry(from).or_default().insert(to);
        }
    }
    arrows
}
