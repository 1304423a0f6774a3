//! Every table and figure of the paper, and how close they came.

use std::path::Path;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use pounding_studies::{Finding, Reproduction, Studies, Verdict};

use crate::results;

/// Runs every study; writes results/, or compares it with the fresh run.
pub(crate) fn run(root: &Path, check: bool) -> Result<(), String> {
    let started = Instant::now();
    let studies = Studies::read(&root.join("studies")).map_err(|error| error.to_string())?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} scenes and pictures, {elapsed}")
        .expect("the template is well formed");
    let bar = ProgressBar::new(studies.n_units() as u64).with_style(style);
    let made = studies
        .reproduce(&|| bar.inc(1))
        .map_err(|error| error.to_string())?;
    bar.finish_and_clear();
    let folder = root.join("results");
    if check {
        let differences = results::differences(&folder, &made.files)?;
        if !differences.is_empty() {
            return Err(format!(
                "results/ is not what a fresh run gives; run `cargo xtask reproduce` and name each moved number in \
                 CHANGELOG.md:\n  {}",
                differences.join("\n  ")
            ));
        }
        println!(
            "results/ is what a fresh run gives ({} files)",
            made.files.len()
        );
    } else {
        let changed = results::write(&folder, &made.files)?;
        println!(
            "{} files in results/, {changed} of them changed, in {:.1} s\n",
            made.files.len(),
            started.elapsed().as_secs_f64()
        );
        summarise(&made);
    }
    if made.surprises.is_empty() {
        Ok(())
    } else {
        Err(format!(
            "the agreement is not the known one:\n  {}",
            made.surprises.join("\n  ")
        ))
    }
}

/// How close the numbers came, and where to look.
fn summarise(made: &Reproduction) {
    let numbers = |verdict| {
        made.comparisons
            .iter()
            .filter(|comparison| comparison.verdict == verdict)
            .count()
    };
    let findings = |finding| {
        made.claims
            .iter()
            .filter(|claim| claim.finding == finding)
            .count()
    };
    println!(
        "Published numbers   {:>4}   results/agreement.csv",
        made.comparisons.len()
    );
    for (verdict, meaning) in [
        (Verdict::Reproduced, "within 0.1 %"),
        (Verdict::Close, "within 3 %"),
        (
            Verdict::Differs,
            "further away; the reason stands beside each",
        ),
        (Verdict::NotComparable, "of another record"),
    ] {
        println!(
            "  {:<17} {:>4}   {meaning}",
            verdict.words(),
            numbers(verdict)
        );
    }
    println!(
        "Claims of the paper {:>4}   results/claims.csv",
        made.claims.len()
    );
    for finding in [
        Finding::Holds,
        Finding::HoldsOnlyAsStated,
        Finding::DoesNotHold,
    ] {
        println!("  {:<19} {:>2}", finding.words(), findings(finding));
    }
    println!("\nTables in results/tables, figures in results/figures.");
}
