//! `pounding compare`: several scenes side by side.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use pounding::studies::{
    Errors, Floor, PairOutcome, Prepared, Quantity, Review, StudyError, Summary, digits,
};

use crate::progress::Waiting;
use crate::text::{NONE, percent, short, side_by_side};

const EXAMPLES: &str = "\
Examples:
  pounding compare today.toml wider-gap.toml other-law.toml
  pounding compare today.toml wider-gap.toml --json > both.json

Structures and pairs are matched from the left.";

/// What is asked of `compare`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scenes, TOML or JSON files.
    #[arg(value_name = "SCENE", required = true, num_args = 2..)]
    scenes: Vec<PathBuf>,
    /// Do not measure the errors; saves the exact runs.
    #[arg(long)]
    no_error: bool,
    /// Print JSON, SI units: for each scene what `run --json` prints.
    #[arg(long)]
    json: bool,
}

/// What is printed as JSON.
#[derive(serde::Serialize)]
struct Compared {
    /// The files of the scenes, as asked for.
    files: Vec<String>,
    runs: Vec<Summary>,
}

/// A scene that ran.
struct Run {
    file: PathBuf,
    prepared: Prepared,
    review: Review,
}

/// Runs the scenes; returns a column for each.
pub(crate) fn answer(asked: &Arguments) -> Result<String, String> {
    let run = |path: &PathBuf| {
        run(path, !asked.no_error).map_err(|error| error.in_file(path).to_string())
    };
    let runs: Vec<Run> = asked.scenes.iter().map(run).collect::<Result<_, _>>()?;
    if asked.json {
        return Ok(json_of(&runs));
    }
    let mut names = names(&runs).into_iter();
    let mut rows = vec![row("Scene", &runs, |_| names.next().unwrap_or_default())];
    rows.extend(of_runs(&runs));
    let most = |count: fn(&Run) -> usize| runs.iter().map(count).max().unwrap_or(0);
    let structures = most(|run| run.prepared.floors().all().len());
    let pairs = most(|run| run.prepared.floors().facing().len());
    rows.extend((0..structures).flat_map(|index| of_structure(&runs, index)));
    rows.extend((0..pairs).flat_map(|index| of_pair(&runs, index)));
    Ok(side_by_side(&rows))
}

fn run(path: &Path, measure: bool) -> Result<Run, StudyError> {
    let prepared = super::prepare(path, false)?;
    let _waiting = Waiting::new("running");
    let review = prepared.review(measure)?;
    Ok(Run {
        file: path.to_path_buf(),
        prepared,
        review,
    })
}

/// A name of every scene unlike the others, where there is one: its own, or else that of its file, or its path.
fn names(runs: &[Run]) -> Vec<String> {
    let own = |run: &Run| run.prepared.scene().name.clone();
    let path = |run: &Run| run.file.display().to_string();
    let file = |run: &Run| {
        let name = run.file.file_name().map(|name| name.to_string_lossy());
        name.map_or_else(|| path(run), Cow::into_owned)
    };
    let ways: [&dyn Fn(&Run) -> String; 2] = [&own, &file];
    let ways = ways.map(|way| runs.iter().map(way).collect::<Vec<_>>());
    let differ = |names: &Vec<String>| names.iter().collect::<BTreeSet<_>>().len() == names.len();
    let found = ways.into_iter().find(differ);
    found.unwrap_or_else(|| runs.iter().map(path).collect())
}

fn json_of(runs: &[Run]) -> String {
    let summary = |run: &Run| Summary::of(&run.prepared, &run.review);
    // Not a `Value`, which would sort the fields of a summary.
    let all = Compared {
        files: runs
            .iter()
            .map(|run| run.file.display().to_string())
            .collect(),
        runs: runs.iter().map(summary).collect(),
    };
    let text = serde_json::to_string_pretty(&all).expect("plain data");
    format!("{text}\n")
}

/// A name and a cell for every scene.
fn row(name: &str, runs: &[Run], cell: impl FnMut(&Run) -> String) -> Vec<String> {
    std::iter::once(name.to_string())
        .chain(runs.iter().map(cell))
        .collect()
}

fn of_runs(runs: &[Run]) -> Vec<Vec<String>> {
    let peak = |run: &Run| {
        let gravity = run.prepared.scene().record.gravity_m_per_s2;
        short(run.prepared.record().peak().1.abs() / gravity)
    };
    vec![
        row("Record", runs, |run| {
            let source = run.prepared.scene().record.source.to_string();
            let name = Path::new(&source).file_name();
            name.map_or(source.clone(), |name| name.to_string_lossy().into_owned())
        }),
        row("  peak [g]", runs, peak),
        row("Method", runs, |run| {
            run.prepared.scene().method.name().replace('_', " ")
        }),
        row("  time step [s]", runs, |run| {
            let step = run.prepared.scene().method.time_step();
            step.map_or(NONE.into(), digits)
        }),
        row("  largest error", runs, |run| match &run.review.errors {
            Errors::Exact => "exact".into(),
            Errors::NotMeasured => "not measured".into(),
            Errors::Unknown(_) => "not known".into(),
            Errors::Measured(errors, _) => percent(errors.largest(Quantity::All).0),
        }),
        row("  warnings", runs, |run| {
            run.review.warnings.len().to_string()
        }),
    ]
}

fn of_structure(runs: &[Run], index: usize) -> Vec<Vec<String>> {
    let named = |run: &Run| {
        let floors = run.prepared.floors().all();
        floors
            .get(index)
            .map_or(NONE.into(), |one| one.name.clone())
    };
    let number = |name: &str, value: &dyn Fn(&Run, &Floor) -> Option<f64>| {
        row(name, runs, |run| {
            let structure = run.prepared.floors().all().get(index);
            let value = structure.and_then(|structure| value(run, structure));
            value.map_or(NONE.into(), short)
        })
    };
    let moves = |floor: &Floor| (!floor.is_wall()).then_some(());
    vec![
        row(&format!("Structure {}", index + 1), runs, named),
        number("  period [s]", &|run, floor| {
            Some(floor.oscillation(run.prepared.scene())?.0)
        }),
        number("  peak displacement [mm]", &|run, structure| {
            moves(structure)?;
            Some(1e3 * run.review.outcome.peaks.of(index).displacement.value)
        }),
        number("  residual at end [mm]", &|run, structure| {
            moves(structure)?;
            Some(1e3 * run.review.outcome.last.of(index))
        }),
        number("  peak acceleration [g]", &|run, structure| {
            moves(structure)?;
            let gravity = run.prepared.scene().record.gravity_m_per_s2;
            Some(run.review.outcome.accelerations[index].value / gravity)
        }),
        number("  peak shear [kN]", &|run, structure| {
            moves(structure)?;
            Some(1e-3 * run.review.outcome.peaks.of(index).restoring_force.value)
        }),
        number("  transferred momentum [kN·s]", &|run, _| {
            Some(1e-3 * run.review.outcome.momentum.of(index))
        }),
    ]
}

fn of_pair(runs: &[Run], pair: usize) -> Vec<Vec<String>> {
    let gap = |run: &Run| {
        let contacts = run.prepared.scene().contacts.as_ref()?;
        contacts.get(pair).map(|contact| 1e3 * contact.gap_m)
    };
    let number = |name: &str, value: &dyn Fn(&PairOutcome) -> Option<f64>| {
        row(name, runs, |run| {
            value(&run.review.outcome.of_pair(pair)).map_or(NONE.into(), short)
        })
    };
    vec![
        row(&format!("Pair {}, gap [mm]", pair + 1), runs, |run| {
            gap(run).map_or(NONE.into(), short)
        }),
        row("  collisions", runs, |run| match gap(run) {
            Some(_) => collisions(run, pair),
            None => NONE.into(),
        }),
        number("  first [s]", &|pair| Some(pair.first?.start)),
        number("  largest impulse [kN·s]", &|pair| {
            Some(1e-3 * pair.largest?.impulse)
        }),
        number("  peak force [kN]", &|pair| {
            Some(1e-3 * pair.peak_force?.value)
        }),
        number("    at [s]", &|pair| Some(pair.peak_force?.time)),
    ]
}

/// Number of collisions, and that of the exact run where it is another.
fn collisions(run: &Run, pair: usize) -> String {
    let found = run.review.outcome.of_pair(pair).collisions;
    let errors = run
        .review
        .measured()
        .and_then(|errors| errors.pairs.get(pair));
    match errors.filter(|errors| errors.differ()) {
        Some(errors) => format!("{found} (exact {})", errors.collisions.1),
        None => found.to_string(),
    }
}
