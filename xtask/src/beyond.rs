//! The paper's scenes and claims under a folder of one's own records.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};
use pounding_studies::{Beyond, BeyondStudy};

/// Where tables and figures go unless asked, from the top folder.
const USUAL: &str = "target/beyond";

/// Runs the scenes under every record of a folder; writes tables and figures.
pub(crate) fn run(
    root: &Path,
    records: &Path,
    out: Option<PathBuf>,
    scaled: bool,
) -> Result<(), String> {
    let study = BeyondStudy::of_records(&root.join("studies"), records, scaled);
    let study = study.map_err(|error| error.to_string())?;
    let style =
        ProgressStyle::with_template("{bar:40} {pos}/{len} records × directions, {elapsed}")
            .expect("the template is well formed");
    let bar = ProgressBar::new(study.n_cases() as u64).with_style(style);
    let made = study.run(&|| bar.inc(1));
    bar.finish_and_clear();
    let made = made.map_err(|error| error.to_string())?;
    let files = made.files().map_err(|error| error.to_string())?;
    let folder = out.unwrap_or_else(|| root.join(USUAL));
    for (path, bytes) in &files {
        // The folder is theirs alone.
        let name = path.file_name().unwrap_or(path.as_os_str());
        let path = folder.join(name);
        fs::create_dir_all(&folder)
            .and_then(|()| fs::write(&path, bytes))
            .map_err(|error| format!("{}: cannot be written: {error}", path.display()))?;
    }
    crate::reproduce::say(&format!(
        "{}\n{} files in {}\n",
        summary(&made),
        files.len(),
        folder.display()
    ))
}

/// In how many cases each claim holds, and what was left out.
fn summary(made: &Beyond) -> String {
    let mut text = String::from("The paper's claims under these records in both directions\n");
    let mut line = |words: String| writeln!(text, "  {words}").expect("a string takes all");
    for (claim, tally) in made.claims() {
        line(format!("{:<40} {claim}", tally.words()));
    }
    for (name, reason) in made.left_out() {
        line(format!("left out: {name}: {reason}"));
    }
    text
}
