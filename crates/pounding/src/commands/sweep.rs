//! `pounding sweep`: a scene again and again, with other values of its fields.

mod joined;
mod summed;
mod task;

use std::path::{Path, PathBuf};

use pounding::report::said_briefly;
use pounding::scene::Method;
use pounding::sweep::{ColumnErrors, Parts, Shard, Sweep, SweepAccuracy, beside_table, summary_beside};
use pounding::text::{Answer, Form, Manner, Refused, Where, digits, percent};

pub(super) use joined::of_table;

use super::Failure;
use super::suite::{STOPPED, stop_when_asked};
use crate::progress::{Choosing, Counter};
use crate::{new_file, say};

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

With `summary` in the sweep, means, quantiles and exceedances of all runs stand
in place of the rows.

Rows are kept in parts beside the table, in OUT.parts. Killed or stopped by
Ctrl-C, the same command goes on and runs only what is missing. Pressed again,
Ctrl-C ends at once.

A shard is a share of the runs: with --shard it leaves its parts, which
`pounding merge` joins. In a job array the task is taken from
SLURM_ARRAY_TASK_ID, or HQ_TASK_ID with --shards. studies/jobs has scripts.
All processors are used; RAYON_NUM_THREADS limits them.";

/// The arguments of `sweep`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The sweep, a TOML or JSON file.
    #[arg(value_name = "SWEEP")]
    sweep: PathBuf,
    /// The table: CSV, compressed if the name ends in .zst; by default
    /// beside the sweep, as sweep.toml.csv.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Replace a table that exists, and parts of another sweep.
    #[arg(long)]
    overwrite: bool,
    /// Run a share of the runs alone and leave its parts, such as 2/8.
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// How many shards there are: then the tasks of a job array count from 1.
    #[arg(long, value_name = "N", conflicts_with = "shard")]
    shards: Option<u64>,
}

/// The shard of the task of a job array; the whole sweep if the process is no such task.
fn shard_of_task(shards: Option<u64>) -> Result<Shard, Refused> {
    let task = task::shard(shards, |name| std::env::var(name).ok())?;
    if let Some((variable, shard)) = &task {
        say(&format!("{variable} is set: runs shard {shard} alone; --shard 1/1 runs the whole"));
    }
    Ok(task.map_or(Shard::WHOLE, |(_, shard)| shard))
}

/// Says before long work begins how it is done, and which parts of earlier work are damaged.
fn announce(sweep: &Sweep, parts: &Parts) {
    if let Some(accuracy) = sweep.accuracy() {
        say(&chosen(accuracy));
    }
    if let Some(why) = sweep.alone_because().filter(|_| sweep.is_long()) {
        say(&format!("runs go one at a time: {why}"));
    }
    new_file::say_if_unlocked(parts.is_locked());
    for damaged in parts.damaged() {
        say(&format!("run again: {damaged}"));
    }
}

/// Runs a sweep, or the runs that are missing.
pub(crate) fn run(args: &Arguments) -> Result<String, Failure> {
    let shard = match args.shard {
        Some(shard) => shard,
        None => shard_of_task(args.shards)?,
    };
    let out = match &args.out {
        Some(out) => out.clone(),
        None => beside(&args.sweep),
    };
    if out.exists() && !args.overwrite && !Parts::are_begun(&out) {
        return Err(new_file::there_already(&out).into());
    }
    stop_when_asked();
    let choosing = Choosing::new();
    let sweep = Sweep::read_followed(&args.sweep, Some(&STOPPED), choosing.follow())?;
    drop(choosing);
    new_file::keep(&out, sweep.inputs())?;
    keep_errors(&sweep, &out, args.overwrite)?;
    keep_summary(&sweep, &out, args.overwrite)?;
    let opened = Parts::open(&sweep, &out, shard, args.overwrite)?;
    let Some(parts) = opened else {
        return Ok(finished(&out));
    };
    if out.exists() && !args.overwrite {
        if !parts.made_table()? {
            return Err(new_file::there_already(&out).into());
        }
        parts.clean_up()?;
        return Ok(finished(&out));
    }
    announce(&sweep, &parts);
    let progress = Counter::new(parts.n_runs_there(), parts.n_runs());
    let filled = parts.fill(&sweep, &|runs| progress.add(runs));
    drop(progress);
    let there = filled?;
    let n_runs = parts.n_runs();
    if there < n_runs && sweep.is_stopped() {
        return Err(format!(
            "stopped: {there} of {n_runs} runs are in {}; the same command runs the others",
            parts.folder().display()
        )
        .into());
    }
    end(args, &sweep, parts, &out)
}

/// Joins what has run, and says what it was.
fn end(args: &Arguments, sweep: &Sweep, parts: Parts, out: &Path) -> Result<String, Failure> {
    let records = sweep
        .suite()
        .map(|suite| said_briefly(suite, "`pounding run --records` names every one"));
    let accuracy = sweep.accuracy().map(|accuracy| measured(accuracy, out)).transpose()?;
    let before = parts.n_runs_there();
    let before = (before > 0).then(|| format!("{before} runs were there already"));
    let mut facts = vec![
        fact("Unusual", sweep.unusual().iter().map(ToString::to_string)),
        fact("Sweep", [runs(sweep, &parts)]),
        fact("Contact", sweep.says_of_contact()),
        fact("Records", records.unwrap_or_default()),
        fact("Accuracy", accuracy),
        fact("Before", before),
    ];
    if !parts.shard().is_whole() {
        let folder = parts.folder().display();
        let text = format!("in {folder}; when all shards are done, `pounding merge` joins them");
        facts.push(fact("Parts", [text]));
        return Ok(answer(facts).text(Form::Brief));
    }
    let joined = parts.join(new_file::existing(args.overwrite))?;
    of_table(facts, &joined, out)
}

/// Sentences under a word; `None` if there are none.
fn fact(word: &str, lines: impl IntoIterator<Item = String>) -> Option<String> {
    let lines: Vec<String> = lines.into_iter().collect();
    (!lines.is_empty()).then(|| format!("{word}: {}", lines.join("\n")))
}

/// An answer that begins with facts.
fn answer(facts: Vec<Option<String>>) -> Answer<'static> {
    Answer::new().say_as(Where::Terminal, Manner::Facts, "", facts.into_iter().flatten().collect())
}

/// The table of a sweep by default: beside the sweep and with its whole name, so that no two sweeps share one.
fn beside(sweep: &Path) -> PathBuf {
    let mut name = sweep.file_name().unwrap_or_default().to_owned();
    name.push(".csv");
    sweep.with_file_name(name)
}

/// Says that an earlier process put the table in its place before it was ended.
fn finished(out: &Path) -> String {
    let text = format!("{}: was finished already; what was left of its parts is gone", out.display());
    answer(vec![fact("Results", [text])]).text(Form::Brief)
}

/// The number of runs.
fn runs(sweep: &Sweep, parts: &Parts) -> String {
    let (all, n_runs, shard) = (sweep.n_runs(), parts.n_runs(), parts.shard());
    if shard.is_whole() {
        format!("{all} runs")
    } else {
        format!("{n_runs} of {all} runs, shard {shard}")
    }
}

/// Where the errors of all columns go.
fn errors_beside(out: &Path) -> PathBuf {
    beside_table(out, "accuracy.csv")
}

/// Refuses a summary that exists beside the table, unless an earlier process of this sweep wrote it.
fn keep_summary(sweep: &Sweep, out: &Path, overwrite: bool) -> Result<(), Refused> {
    if !sweep.has_summary_beside() {
        return Ok(());
    }
    let is_ours = overwrite || Parts::are_begun(out);
    new_file::check(&summary_beside(out), sweep.inputs(), is_ours)
}

/// Refuses a table of errors that exists, unless it is that of this sweep.
fn keep_errors(sweep: &Sweep, out: &Path, overwrite: bool) -> Result<(), Refused> {
    let Some(accuracy) = sweep.accuracy() else {
        return Ok(());
    };
    let path = errors_beside(out);
    let is_ours = pounding::files::holds(&path, accuracy.csv().as_bytes()).unwrap_or(false);
    new_file::check(&path, sweep.inputs(), overwrite || is_ours)
}

/// A sentence about the method that an accuracy chose; writes the errors of all columns beside the table.
fn measured(accuracy: &SweepAccuracy, out: &Path) -> Result<String, Refused> {
    // Every shard writes the same errors.
    let path = errors_beside(out);
    new_file::write(&path, accuracy.csv().as_bytes(), true)?;
    let ColumnErrors {
        runs, quantiles, largest, ..
    } = &accuracy.rows;
    if accuracy.method == Method::EXACT {
        return Ok(format!(
            "{}: by the estimate of their costs nothing that keeps {} of a sample of the runs within it is cheaper. It has no errors but those \
             of rounding; none were measured. All columns: {}",
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
            " In the sample that chose the method {} were; here fewer are. Ask for a smaller error, take the exact method, or leave out a number \
             that counts whole things.",
            percent(SweepAccuracy::SHARE)
        )
    } else {
        String::new()
    };
    Ok(format!(
        "{}. Of {runs} runs measured by the exact method {:.0} are within it in every number; the median of the largest error in a \
         row is {}, the largest of these {} ({worst}); other runs may be further off.{short} All columns: {}",
        chosen(accuracy),
        accuracy.within * *runs as f64,
        percent(quantiles[0]),
        percent(*largest),
        path.display()
    ))
}

/// The accuracy that was asked for, and the method that it chose.
fn chosen(accuracy: &SweepAccuracy) -> String {
    let (name, asked) = (accuracy.method.name(), percent(accuracy.asked));
    match accuracy.method.time_step() {
        Some(step) => format!("{asked} asked: {name} with steps of {} ms", digits(1e3 * step)),
        None => format!("{asked} asked: {name}"),
    }
}
