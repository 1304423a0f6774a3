//! `pounding run`: runs a scene and says what happened.

mod batch;

use std::path::{Path, PathBuf};

use pounding::assess::Effects;
use pounding::report::{Report, other_direction};
use pounding::scene::{Error, Implausible, Simulation};
use pounding::solver::LedgerError;
use pounding::text::{Form, RefusalKind, Refused, Where};

use super::declared::Declared;
use super::printed::Results;
use crate::progress::Waiting;

const EXAMPLES: &str = "\
Examples:
  pounding run studies/examples/two-structures.json
  pounding run studies/examples/two-structures.json --out results/two
  pounding run studies/examples/row-of-five.toml --effects --out results/five
  pounding run scene.toml --records records --both
  pounding run scene.toml --records records --csv > runs.csv
  pounding run scene.toml --records records --out results/records

The folder holds report.html, for people; summary.json, which --json prints, for
machines; history.csv and impacts.csv; and the figures as SVG and PNG. Of a
folder of records it holds runs.txt, runs.csv and runs.json.

Ctrl-C ends a folder of records with the runs that are finished: they are
printed and written; pressed again it ends at once.

`pounding init` writes a scene to begin with; files named in a scene are
relative to its folder.

Of a folder of records verticals, velocities, copies, and records in boreholes
or on structures are left out. Records lists them with the reason, and those
whose direction nothing tells: they count as horizontal.";

/// The arguments of `run`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; - is standard input.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    model: How,
    /// Also say what pounding does to every storey, against the same building
    /// alone, in both directions of shaking, and what 1 % of the record changes:
    /// 24 exact runs, whatever the method of the scene. Of one record at a time.
    #[arg(long)]
    effects: bool,
    #[command(flatten)]
    suite: Suite,
    #[command(flatten)]
    shown: Shown,
    #[command(flatten)]
    results: Results,
    #[command(flatten)]
    declared: Declared,
}

/// How the scene is run.
#[derive(Debug, clap::Args)]
struct How {
    /// Do not measure the errors; saves the exact run.
    #[arg(long)]
    no_error: bool,
    /// Take the general model even if a simpler one gives the same numbers: slower.
    #[arg(long, conflicts_with = "records")]
    full: bool,
    /// Print what is refused, too, with a warning.
    #[arg(long, conflicts_with = "records")]
    force: bool,
}

/// How the answer is printed.
#[derive(Debug, clap::Args)]
struct Shown {
    /// Run the direction of the scene only; by default the first lines also say
    /// what the reversed shaking does.
    #[arg(long, conflicts_with = "records")]
    one_direction: bool,
    /// Print every floor and pair, what was read of the record, errors and work.
    #[arg(long, conflicts_with_all = ["records", "json"])]
    details: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with = "csv")]
    json: bool,
}

/// The records of a folder.
#[derive(Debug, clap::Args)]
struct Suite {
    /// Run the scene under every record of a folder instead of its own.
    #[arg(long, value_name = "FOLDER")]
    records: Option<PathBuf>,
    /// Shake in both directions, each record of --records; of one record
    /// `record.reversed` of the scene says the direction, and --effects has both.
    #[arg(long, requires = "records")]
    both: bool,
    /// Print a table for a program, SI units, of --records; of one record --json
    /// does, or --out.
    #[arg(long, requires = "records")]
    csv: bool,
}

impl Arguments {
    fn form(&self) -> Form {
        Form::asked(self.shown.details, self.suite.csv, self.shown.json)
    }
}

/// Runs a scene; returns the summary.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    if let Some(folder) = &args.suite.records {
        return batch::run(args, folder);
    }
    if args.declared != Declared::default() {
        return Err(NO_FOLDER.into());
    }
    let path = &args.scene;
    let out = args.results.open()?;
    let refused = |error| hint(error, path);
    let prepared = super::prepare(path, args.model.force).map_err(refused)?;
    if let Some(out) = &out {
        out.keep(&super::inputs(path, &prepared))?;
    }
    let prepared = if args.model.full {
        prepared.full().map_err(refused)?
    } else {
        prepared
    };
    let failed = |error| with_doubts(args, refused(error), &prepared);
    let measure = !args.model.no_error;
    let _waiting = Waiting::new("running");
    let effects = args.effects.then(|| Effects::of(&prepared));
    let effects = effects.transpose().map_err(|error| {
        let is_exact = prepared.scene().method.time_step().is_none();
        let hint = if is_exact { "" } else { EFFECTS_ARE_EXACT };
        failed(error).help_also(hint)
    })?;
    let other = (!args.shown.one_direction).then(|| other_direction(&prepared));
    let report = if out.is_some() {
        Report::of(&prepared, measure).map_err(failed)?
    } else {
        Report::of_review(&prepared, prepared.review(measure).map_err(failed)?.into())
    };
    let mut report = report.with_effects(effects);
    if measure {
        report = report.with_between_samples();
    }
    if let Some(other) = other {
        report = report.with_other_direction(other);
    }
    let mut answer = report.answer();
    if let Some(out) = out {
        out.write(&report.files())?;
        let page = out.path().join("report.html");
        answer = answer.say(Where::Terminal, "Results", vec![page.display().to_string()]);
    }
    Ok(answer.text(args.form()))
}

const NO_FOLDER: &str = "found what files do not say (--unit, --time-step, --per-count, --acceleration, --in-rows), allowed is it with --records; of the \
                         scene's own record declare it in the scene, such as `record.unit`";

const EFFECTS_ARE_EXACT: &str =
    "; --effects always uses the exact method, whatever the scene says: without it the scene runs by its own method";

/// The refusal of a run that failed, with unusual values of its scene, which may be the reason.
fn with_doubts(args: &Arguments, refused: Refused, prepared: &Simulation) -> Refused {
    // JSON has the parts of one refusal; `check --json` has what is unusual.
    if args.shown.json {
        return refused;
    }
    let mut doubts = prepared.doubts();
    // A record and a duration are no reasons to fail.
    doubts.retain(Implausible::is_of_row);
    let doubts = Implausible::lines(doubts.iter().map(|one| ("", one)));
    if doubts.is_empty() {
        refused
    } else {
        refused.help_also(format!("; unusual in this scene: {}", doubts.join("; ")))
    }
}

/// The refusal of a scene, with a hint at `--force` if that would print its numbers.
fn hint(error: Error, path: &Path) -> Refused {
    let is_forced = matches!(error, Error::Broken { .. }) || error.refused().is_kind(RefusalKind::Unstable);
    let is_exact = matches!(
        &error,
        Error::Broken {
            source: LedgerError::EnergyUnexplained { .. },
            ..
        }
    );
    let refused = Refused::from(error.in_file(path));
    if is_exact {
        refused.help_also("; --force prints its numbers with this as a warning")
    } else if is_forced {
        refused.help_also("; `pounding check` says what its time step can follow, --force runs it while its numbers are finite")
    } else {
        refused
    }
}
