//! `pounding sweep`: a scene again and again, with other values of its fields.

mod task;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use pounding::scene::Method;
use pounding::sweep::{
    ColumnErrors, Joined, Parts, Shard, Sweep, SweepAccuracy, SweepError, compresses, merge,
};

use super::suite::{STOPPED, said_of_untold, stop_when_asked};
use crate::new_file;
use crate::progress::Counter;
use crate::text::{milliseconds, paragraph, percent};

const EXAMPLES: &str = "\
Examples:
  pounding sweep studies/sweeps/gap-and-period.json --out gaps.csv
  pounding sweep sweep.toml --out runs.csv.zst
  pounding sweep sweep.json --out runs.csv --shard 2/8
  pounding merge runs.csv

A sweep is a TOML or JSON file: a scene, what of it varies and under which
records. docs/reference/sweep.md lists its fields.

The table has a row for each run, in SI units; a run that fails is a row with
the reason in its last column. A name that ends in .zst is compressed
(Zstandard). The same bytes come out whatever the threads and shards.

Rows are kept in parts beside the table, in OUT.parts. Killed or stopped by
Ctrl-C, the same command goes on and runs only what is missing. Pressed again,
Ctrl-C ends at once.

A shard is a share of the runs: with --shard it leaves its parts, which
`pounding merge` joins. In a job array the task is taken from
SLURM_ARRAY_TASK_ID, or HQ_TASK_ID with --shards. studies/jobs has scripts.
All processors are used; RAYON_NUM_THREADS limits them.";

/// What is asked of `sweep`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The sweep, a TOML or JSON file.
    #[arg(value_name = "SWEEP")]
    sweep: PathBuf,
    /// The table: CSV, compressed where the name ends in .zst; without it, beside
    /// the sweep under its name.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Also where the table is there already, or parts of another sweep.
    #[arg(long)]
    overwrite: bool,
    /// Run a share of the runs alone and leave its parts, such as 2/8.
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// How many shards there are: then the tasks of a job array count from 1.
    #[arg(long, value_name = "N", conflicts_with = "shard")]
    shards: Option<u64>,
}

/// The shard of the task of a job array, where this is one; else the whole.
#[expect(
    clippy::print_stderr,
    reason = "who did not ask for a shard learns why this is one, before the work begins"
)]
fn shard_of_task(shards: Option<u64>) -> Result<Shard, String> {
    let task = task::shard(shards, |name| std::env::var(name).ok())?;
    if let Some((variable, shard)) = &task {
        eprintln!("{variable} is set: runs shard {shard} alone; --shard 1/1 runs the whole");
    }
    Ok(task.map_or(Shard::WHOLE, |(_, shard)| shard))
}

/// Says before long work begins how it is done.
#[expect(clippy::print_stderr, reason = "the answer comes at the end")]
fn announce(accuracy: &SweepAccuracy) {
    eprintln!("{}", chosen(accuracy));
}

/// Runs a sweep, or what is missing of it.
pub(crate) fn run(args: &Arguments) -> Result<String, String> {
    let shard = match args.shard {
        Some(shard) => shard,
        None => shard_of_task(args.shards)?,
    };
    let out = match &args.out {
        Some(out) => out.clone(),
        None => args.sweep.with_extension("csv"),
    };
    new_file::check(&out, args.overwrite)?;
    let words = |error: SweepError| error.to_string();
    let sweep = Sweep::read(&args.sweep).map_err(words)?;
    if let Some(accuracy) = sweep.accuracy() {
        announce(accuracy);
    }
    // A shard would delete what another has just begun.
    let overwritten = args.overwrite && shard.is_whole();
    let parts = Parts::open(&sweep, &out, overwritten).map_err(words)?;
    let n_runs = parts.runs_of(shard);
    let before = parts.runs_there(shard);
    let progress = Counter::new(before, n_runs);
    stop_when_asked();
    let filled = parts.fill(&sweep, shard, &STOPPED, &|runs| progress.add(runs));
    drop(progress);
    filled.map_err(words)?;
    let there = parts.runs_there(shard);
    if there < n_runs && STOPPED.load(Ordering::Relaxed) {
        return Err(format!(
            "stopped by Ctrl-C: {there} of {n_runs} runs are in {}; the same command runs the others",
            parts.folder().display()
        ));
    }
    let mut lines = vec![paragraph("Sweep", &runs(&sweep, shard, n_runs))];
    if !sweep.left_out().is_empty() {
        lines.push(paragraph("Left out", &sweep.left_out().join("\n")));
    }
    lines.extend(said_of_untold(sweep.untold()).map(|said| paragraph("Direction", &said)));
    if let Some(accuracy) = sweep.accuracy() {
        lines.push(paragraph("Accuracy", &measured(accuracy, &out)?));
    }
    if before > 0 {
        let text = format!("{before} runs were there already");
        lines.push(paragraph("Before", &text));
    }
    if shard.is_whole() {
        lines.push(joined(&parts, &out)?);
    } else {
        let text = format!(
            "in {}; when all shards are done, `pounding merge` joins them",
            parts.folder().display()
        );
        lines.push(paragraph("Parts", &text));
    }
    Ok(lines.concat())
}

/// How many runs there are.
fn runs(sweep: &Sweep, shard: Shard, n_runs: u64) -> String {
    let all = sweep.n_runs();
    if shard.is_whole() {
        format!("{all} runs")
    } else {
        format!("{n_runs} of {all} runs, shard {shard}")
    }
}

/// What is said of the method that an accuracy chose; the errors of all columns go beside the table.
fn measured(accuracy: &SweepAccuracy, out: &Path) -> Result<String, String> {
    // Every shard measures the same.
    let table = if compresses(out) {
        out.with_extension("")
    } else {
        out.to_path_buf()
    };
    let path = table.with_extension("accuracy.csv");
    new_file::write(&path, accuracy.csv().as_bytes(), true)?;
    let ColumnErrors {
        runs,
        quantiles,
        largest,
        ..
    } = &accuracy.rows;
    if accuracy.method == Method::EXACT {
        return Ok(format!(
            "{}: for so many runs nothing that keeps {} of a sample of them within it costs less. It has no errors but those of \
             rounding; none were measured. All columns: {}",
            chosen(accuracy),
            percent(SweepAccuracy::SHARE),
            path.display()
        ));
    }
    let worst = accuracy.columns.iter();
    let worst = worst.max_by(|a, b| a.largest.total_cmp(&b.largest));
    let worst = worst.map_or("", |column| column.name.as_str());
    let short = if accuracy.within < SweepAccuracy::SHARE {
        format!(
            " Those are fewer than the {} of the sample that chose the method: ask for a smaller error, or leave out a number that \
             counts whole things.",
            percent(SweepAccuracy::SHARE)
        )
    } else {
        String::new()
    };
    Ok(format!(
        "{}. Of {runs} runs measured by the exact method {} are within it in every number; the median of the largest error in a \
         row is {}, the largest {} ({worst}).{short} All columns: {}",
        chosen(accuracy),
        percent(accuracy.within),
        percent(quantiles[0]),
        percent(*largest),
        path.display()
    ))
}

/// What was asked, and the method that it chose.
fn chosen(accuracy: &SweepAccuracy) -> String {
    let (name, asked) = (accuracy.method.name(), percent(accuracy.asked));
    match accuracy.method.time_step() {
        Some(step) => format!("{asked} asked: {name} with steps of {}", milliseconds(step)),
        None => format!("{asked} asked: {name}"),
    }
}

/// Joins the parts, which then are no longer needed.
fn joined(parts: &Parts, out: &Path) -> Result<String, String> {
    let folder = parts.folder();
    let folders = [folder.to_path_buf()];
    let joined = merge(out, &folders).map_err(|error| error.to_string())?;
    fs::remove_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    Ok(result(joined, out))
}

/// What is said of a table.
pub(super) fn result(joined: Joined, out: &Path) -> String {
    let failed = match joined.failed {
        0 => "none failed".into(),
        failed => format!("{failed} failed: the last column says why"),
    };
    let text = format!("{}: {} rows, {failed}", out.display(), joined.runs);
    paragraph("Results", &text)
}
