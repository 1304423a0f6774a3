//! The paper's scenes and claims under other ground motions: those of the project's list, or a folder of records.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};
use pounding_studies::{Beyond, BeyondStudy, StudyFile};

/// Default folders of tables and figures, from the top folder: for the project's motions, and for a folder of records.
const USUAL: [&str; 2] = ["results/beyond", "target/beyond"];

/// Runs the scenes under every record of a folder, or under the motions of the project; writes tables and figures.
pub(crate) fn run(root: &Path, records: Option<&Path>, out: Option<PathBuf>, scaled: bool) -> Result<(), String> {
    let studies = root.join("studies");
    let study = match records {
        Some(records) => BeyondStudy::of_records(&studies, records, scaled).map(Some),
        None => StudyFile::read_all(&studies).and_then(|files| {
            let files: Vec<&StudyFile> = files.iter().collect();
            BeyondStudy::listed(&files)
        }),
    };
    let study = study.map_err(|error| error.to_string())?;
    let study = study.ok_or("studies: no study lists ground motions")?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} motions × directions × kinds of scene, {elapsed}")
        .expect("the template is well formed");
    let bar = ProgressBar::new(study.n_cases() as u64).with_style(style);
    let made = study.run(&|| bar.inc(1));
    bar.finish_and_clear();
    let made = made.map_err(|error| error.to_string())?;
    let files = made.files().map_err(|error| error.to_string())?;
    let usual = USUAL[usize::from(records.is_some())];
    let folder = out.unwrap_or_else(|| root.join(usual));
    for (path, bytes) in &files {
        // The folder contains only these files.
        let path = folder.join(path.strip_prefix("beyond").unwrap_or(path));
        fs::create_dir_all(path.parent().unwrap_or(&folder))
            .and_then(|()| fs::write(&path, bytes))
            .map_err(|error| format!("{}: cannot be written: {error}", path.display()))?;
    }
    crate::reproduce::say(&format!("{}\n{} files in {}\n", summary(&made), files.len(), folder.display()))
}

/// Number of cases in which each claim holds, and omitted records.
fn summary(made: &Beyond) -> String {
    let mut text = String::from("The paper's claims under these motions in both directions\n");
    let mut line = |words: String| writeln!(text, "  {words}").expect("a string takes all");
    for (change, claims) in made.claims() {
        if let Some(change) = change {
            line(format!("With {change}:"));
        }
        for (claim, tally) in claims {
            line(format!("{:<40} {claim}", tally.words()));
        }
    }
    for (name, reason) in made.left_out() {
        line(format!("left out: {name}: {reason}"));
    }
    text
}
