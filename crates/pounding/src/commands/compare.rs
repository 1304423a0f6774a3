//! `pounding compare`: several scenes side by side.

use std::collections::BTreeMap;
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

/// A scene that ran.
struct Run {
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
    let mut rows = vec![row("Scene", &runs, |run| run.prepared.scene().name.clone())];
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
    Ok(Run { prepared, review })
}

fn json_of(runs: &[Run]) -> String {
    let summary = |run: &Run| Summary::of(&run.prepared, &run.review);
    let summaries: Vec<Summary> = runs.iter().map(summary).collect();
    // Not a `Value`, which would sort the fields of a summary.
    let all = BTreeMap::from([("runs", summaries)]);
    let text = serde_json::to_string_pretty(&all).expect("plain data");
    format!("{text}\n")
}

/// A name and a cell for every scene.
fn row(name: &str, runs: &[Run], cell: impl Fn(&Run) -> String) -> Vec<String> {
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
            Some(_) => run.review.outcome.of_pair(pair).collisions.to_string(),
            None => NONE.into(),
        }),
        number("  first [s]", &|pair| Some(pair.first?.start)),
        number("  largest impulse [kN·s]", &|pair| {
            Some(1e-3 * pair.largest?.impulse)
        }),
        number("  peak force [kN]", &|pair| Some(1e-3 * pair.peak_force?)),
    ]
}
