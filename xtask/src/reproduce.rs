//! Every table and figure of the paper, and their agreement with it.

use std::fmt::Write as _;
use std::io::{ErrorKind, IsTerminal as _, Write as _, stderr, stdout};
use std::path::Path;
use std::sync::LazyLock;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use pounding_studies::{Claim, Comparison, Examples, Extent, Finding, PrintedDigits, Reproduction, Studies, Verdict};

use crate::results;

/// When the studies began, for the lines of a log.
static STARTED: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Runs every study; writes results/, or compares it with the fresh run.
pub(crate) fn run(root: &Path, check: bool, extent: Extent) -> Result<(), String> {
    let started = Instant::now();
    let studies = Studies::read(&root.join("studies")).map_err(|error| error.to_string())?;
    let mut studies = studies.with_extremes(extent);
    // A bar draws nothing into a file.
    if !stderr().is_terminal() {
        LazyLock::force(&STARTED);
        studies = studies.telling(|done| eprintln!("{:.0} s  {done}", STARTED.elapsed().as_secs_f64()));
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} scenes and pictures, {elapsed}").expect("the template is well formed");
    let examples = Examples::read(&root.join("studies/examples"));
    let examples = examples.map_err(|error| error.to_string())?;
    let units = studies.n_units() + examples.n_units();
    let bar = ProgressBar::new(units as u64).with_style(style);
    let mut made = studies.reproduce(&|| bar.inc(1)).map_err(|error| error.to_string())?;
    let of_examples = examples.files(&|| bar.inc(1));
    made.files.extend(of_examples.map_err(|error| error.to_string())?);
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
        println!("results/ is what a fresh run gives ({} files)", made.files.len());
    } else {
        let changed = results::write(&folder, &made.files)?;
        let seconds = started.elapsed().as_secs_f64();
        let files = made.files.len();
        let summary = summary(&made);
        say(&format!(
            "{files} files in results/, {changed} of them changed, in {seconds:.1} s\n\n{summary}"
        ))?;
    }
    if made.surprises.is_empty() {
        Ok(())
    } else {
        Err(format!("the agreement is not the known one:\n  {}", made.surprises.join("\n  ")))
    }
}

/// Writes to standard output; a reader that closes the pipe (`| head`) is no failure.
pub(crate) fn say(text: &str) -> Result<(), String> {
    match stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!("standard output cannot be written: {error}")),
        _ => Ok(()),
    }
}

/// Agreement of the numbers, and where to look.
fn summary(made: &Reproduction) -> String {
    let numbers = |verdict| {
        let with = |comparison: &&Comparison| comparison.verdict == verdict;
        made.comparisons.iter().filter(with).count()
    };
    let findings = |finding| {
        let with = |claim: &&Claim| claim.finding == finding;
        made.claims.iter().filter(with).count()
    };
    let of_others = numbers(Verdict::NotComparable);
    let own = made.comparisons.len() - of_others;
    let to_the_digit = made
        .comparisons
        .iter()
        .filter(|comparison| comparison.verdict == Verdict::Reproduced && comparison.digits != PrintedDigits::Other);
    let mut text = format!(
        "Numbers of the paper's own runs: {} of {own} reproduced   results/agreement.csv\n",
        numbers(Verdict::Reproduced)
    );
    let mut line = |words: &str, count: usize, meaning: &str| {
        writeln!(text, "  {words:<20} {count:>4}   {meaning}").expect("a string takes all");
    };
    line("within 0.1 %", numbers(Verdict::Reproduced), "");
    line("to the last digit", to_the_digit.count(), "rounded, or cut off");
    line("within 3 %", numbers(Verdict::Close), "");
    line("further away", numbers(Verdict::Differs), "the reason stands beside each");
    line("not comparable", of_others, "of another work, whose inputs are not known");
    writeln!(text, "Findings of the paper: {}   results/claims.csv", made.claims.len()).expect("a string takes all");
    for finding in [Finding::Holds, Finding::HoldsOnlyAsStated, Finding::DoesNotHold] {
        writeln!(text, "  {:<20} {:>4}", finding.words(), findings(finding)).expect("a string takes all");
    }
    text + "\nTables in results/tables, figures in results/figures.\n"
}
