//! `pounding compare`: several scenes side by side.

mod brief;
mod rows;

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use pounding::report::{InWords, Summary, tables};
use pounding::scene::{Error, Errors, Floor, Link, PairQuantity, Quantity, QuantityGroup, QuantityKind, Review, Scene, Simulation};
use pounding::text::{Answer, Form, Grid, NONE, Refused, Where, digits, percent, short};
use serde_json::json;

use crate::progress::Waiting;
use rows::{ComparedRow, ComparedValue, changed};

const EXAMPLES: &str = "\
Examples:
  pounding compare today.toml wider-gap.toml other-law.toml
  pounding compare today.toml wider-gap.toml --details
  pounding compare today.toml wider-gap.toml --json > both.json

The first lines tell what differs, how often and how hard floors touch, the
largest drift over its limit, and the gap that the buildings need: the larger of
both directions of shaking. --details prints every floor and pair.

Structures are matched from the left, the floors of buildings and the pairs
between them storey by storey. Behind a number stands how much larger it is
than that of the first scene, whatever their signs.";

/// The arguments of `compare`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scenes, TOML or JSON files.
    #[arg(value_name = "SCENE", required = true, num_args = 2..)]
    scenes: Vec<PathBuf>,
    /// Do not measure the errors; saves the exact runs.
    #[arg(long)]
    no_error: bool,
    #[command(flatten)]
    printed: Printed,
}

/// How the answer is printed.
#[derive(Debug, clap::Args)]
struct Printed {
    /// Print every floor and pair in which the scenes differ.
    #[arg(long, conflicts_with = "json")]
    details: bool,
    /// Print what is alike in all scenes, too.
    #[arg(long, conflicts_with = "json")]
    all: bool,
    /// Print JSON, SI units: for each scene what `run --json` prints.
    #[arg(long)]
    json: bool,
}

/// A scene that ran.
struct ComparedRun {
    file: PathBuf,
    prepared: Simulation,
    review: Review,
}

impl ComparedRun {
    fn shown(&self) -> InWords<'_> {
        InWords::of(&self.prepared, &self.review)
    }
}

/// Runs the scenes; returns a column for each.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let run = |path: &PathBuf| run_scene(path, !args.no_error).map_err(|error| error.in_file(path));
    let runs: Vec<ComparedRun> = args.scenes.iter().map(run).collect::<Result<_, _>>()?;
    let Printed {
        details,
        all,
        json: is_json,
    } = args.printed;
    if is_json {
        let files: Vec<_> = runs.iter().map(|run| run.file.display().to_string()).collect();
        let summaries: Vec<_> = runs.iter().map(|run| Summary::of(&run.prepared, &run.review)).collect();
        let answer = Answer::new().fact("files", files).fact("runs", json!(summaries));
        return Ok(answer.text(Form::Json));
    }
    let (rows, said) = if details || all {
        every_row(&runs, all)
    } else {
        brief::rows(&runs)?
    };
    let headings = std::iter::once("Scene".into()).chain(names(&runs));
    let grid = Grid::of(headings, rows.iter().map(ComparedRow::cells).collect());
    let answer = Answer::new()
        .table(Where::Terminal, grid.in_blocks())
        .say(Where::Terminal, "More", said);
    Ok(answer.text(Form::Brief))
}

/// The rows of every floor, pair and link, and a sentence about those that are alike.
fn every_row(runs: &[ComparedRun], all: bool) -> (Vec<ComparedRow>, Vec<String>) {
    let mut rows = of_runs(runs);
    let (structures, pairs) = (places(runs, floor_places), places(runs, pair_places));
    let words = |what: &str, place: &ComparedPlace, all: &[ComparedPlace]| {
        let several = all.iter().any(|one| one.index == place.index && one != place);
        let floor = format!(", floor {}", place.storey + 1);
        let floor = if several { floor.as_str() } else { "" };
        format!("{what} {}{floor}", place.index + 1)
    };
    for place in &structures {
        rows.extend(of_structure(runs, *place, &words("Structure", place, &structures)));
    }
    for place in &pairs {
        rows.extend(of_pair(runs, *place, &words("Pair", place, &pairs)));
    }
    let n_links = runs.iter().map(|run| run.prepared.scene().links.len()).max().unwrap_or(0);
    for link in 0..n_links {
        rows.extend(of_link(runs, link));
    }
    let (rows, alike) = if all { (rows, 0) } else { changed(rows) };
    let alike = match alike {
        0 => Vec::new(),
        1 => vec!["1 row is alike; --all prints it".into()],
        _ => vec![format!("{alike} rows are alike; --all prints them")],
    };
    (rows, alike)
}

/// The place of a floor or a pair in a row, whatever its number in a run.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct ComparedPlace {
    /// Number of the structure or of the contact from the left, from 0.
    index: usize,
    /// Number of the storey from the ground, from 0; for a wall that of the level.
    storey: usize,
}

/// All places of all runs, from the left, each from the ground up.
fn places(runs: &[ComparedRun], of_run: fn(&ComparedRun) -> Vec<ComparedPlace>) -> Vec<ComparedPlace> {
    let all: BTreeSet<ComparedPlace> = runs.iter().flat_map(of_run).collect();
    all.into_iter().collect()
}

/// Places of the floors of a run, in its order.
fn floor_places(run: &ComparedRun) -> Vec<ComparedPlace> {
    let floors = run.prepared.floors();
    let place = |floor: usize| ComparedPlace {
        index: floors.all()[floor].structure,
        storey: floors.storey_of(floor) - 1,
    };
    (0..floors.all().len()).map(place).collect()
}

/// Places of the pairs of a run, in its order: the storey is that of the left neighbour, or beside a wall that of the right one.
fn pair_places(run: &ComparedRun) -> Vec<ComparedPlace> {
    let floors = run.prepared.floors();
    let facing = floors.facing().iter();
    let place = facing.map(|one| {
        let wall = floors.all()[one.left].is_wall();
        let floor = if wall { one.right } else { one.left };
        ComparedPlace {
            index: one.contact,
            storey: floors.storey_of(floor) - 1,
        }
    });
    place.collect()
}

/// The floor that a run has at a place, and its number.
fn floor_at(run: &ComparedRun, place: ComparedPlace) -> Option<(usize, &Floor)> {
    let index = floor_places(run).iter().position(|one| *one == place)?;
    Some((index, &run.prepared.floors().all()[index]))
}

/// The number of the pair that a run has at a place.
fn pair_at(run: &ComparedRun, place: ComparedPlace) -> Option<usize> {
    pair_places(run).iter().position(|one| *one == place)
}

fn run_scene(path: &Path, measure: bool) -> Result<ComparedRun, Error> {
    let prepared = super::prepare(path, false)?;
    let _waiting = Waiting::new("running");
    let review = prepared.review(measure)?;
    Ok(ComparedRun {
        file: path.to_path_buf(),
        prepared,
        review,
    })
}

/// Names of the scenes that differ from each other: their own if these differ, else those of their files, else their paths.
fn names(runs: &[ComparedRun]) -> Vec<String> {
    let own = |run: &ComparedRun| run.prepared.scene().name.clone();
    let path = |run: &ComparedRun| run.file.display().to_string();
    let file = |run: &ComparedRun| {
        let name = run.file.file_name().map(|name| name.to_string_lossy());
        name.map_or_else(|| path(run), Cow::into_owned)
    };
    let ways: [&dyn Fn(&ComparedRun) -> String; 2] = [&own, &file];
    let ways = ways.map(|way| runs.iter().map(way).collect::<Vec<_>>());
    let differ = |names: &Vec<String>| names.iter().collect::<BTreeSet<_>>().len() == names.len();
    let found = ways.into_iter().find(differ);
    found.unwrap_or_else(|| runs.iter().map(path).collect())
}

/// A name and a cell for every scene.
fn row<C: Into<ComparedValue>>(name: &str, runs: &[ComparedRun], mut cell: impl FnMut(&ComparedRun) -> C) -> ComparedRow {
    ComparedRow {
        name: name.into(),
        cells: runs.iter().map(|run| cell(run).into()).collect(),
    }
}

fn of_runs(runs: &[ComparedRun]) -> Vec<ComparedRow> {
    let peak = |run: &ComparedRun| {
        let gravity = run.prepared.scene().record.gravity_m_per_s2;
        Some(run.prepared.record().peak().1.abs() / gravity)
    };
    vec![
        row("Record", runs, |run| {
            let source = run.prepared.scene().record.source.to_string();
            let name = Path::new(&source).file_name();
            name.map_or(source.clone(), |name| name.to_string_lossy().into_owned())
        }),
        row("  peak [g]", runs, peak),
        row("Method", runs, |run| run.prepared.scene().method.name().replace('_', " ")),
        row("  time step [s]", runs, |run| {
            let step = run.prepared.scene().method.time_step();
            step.map_or(String::from(NONE), digits)
        }),
        row::<String>("  largest error", runs, |run| match &run.review.errors {
            Errors::Exact => "exact".into(),
            Errors::NotMeasured => "not measured".into(),
            Errors::Doubtful | Errors::Unknown(_) => "not known".into(),
            Errors::Measured(errors, _) => percent(errors.largest(QuantityGroup::All).0),
        }),
        row("  warnings", runs, |run| run.review.warnings.len().to_string()),
    ]
}

/// A row for a number of a place; an instant is a text, so that no change stands behind it.
fn number(runs: &[ComparedRun], quantity: Quantity, value: impl Fn(&ComparedRun) -> Option<f64>) -> ComparedRow {
    let about = quantity.about();
    let indent = if about.kind == QuantityKind::Instant { "    " } else { "  " };
    let name = format!("{indent}{} {}", about.heading.to_lowercase(), about.shown_unit());
    if about.is_instant() {
        row(name.trim_end(), runs, |run| value(run).map_or(NONE.into(), short))
    } else {
        row(name.trim_end(), runs, value)
    }
}

fn of_structure(runs: &[ComparedRun], place: ComparedPlace, heading: &str) -> Vec<ComparedRow> {
    let name = row(heading, runs, |run| {
        floor_at(run, place).map_or(String::from(NONE), |(_, floor)| floor.name.clone())
    });
    let is_storey = |run: &ComparedRun| floor_at(run, place).is_some_and(|(_, floor)| floor.storey.is_some());
    let has_storeys = runs.iter().any(is_storey);
    let all = tables::STRUCTURES_BESIDE.iter().map(|one| (*one, one.about().on_ground.is_some()));
    let rows = all
        .filter(|(_, is_of_storey)| has_storeys || !is_of_storey)
        .map(|(quantity, is_of_storey)| {
            number(runs, quantity.into(), |run| {
                let (floor, _) = floor_at(run, place).filter(|_| is_storey(run) || !is_of_storey)?;
                let shown = run.shown();
                shown.value(shown.of_storey(quantity, floor), floor)
            })
        });
    std::iter::once(name).chain(rows).collect()
}

fn of_pair(runs: &[ComparedRun], place: ComparedPlace, heading: &str) -> Vec<ComparedRow> {
    let index = |run: &ComparedRun| pair_at(run, place);
    let name = row(heading, runs, |run| {
        let names = index(run).map(|index| run.prepared.floors().names(index));
        names.map_or(String::from(NONE), |[left, right]| format!("{left} – {right}"))
    });
    let rows = tables::PAIRS_BESIDE.iter().map(|one| {
        let quantity = (*one).into();
        if *one == PairQuantity::Collisions {
            let counted = |run: &ComparedRun| index(run).map_or(String::from(NONE), |index| collisions(run, index));
            return row("  collisions", runs, counted);
        }
        number(runs, quantity, |run| run.shown().value(quantity, index(run)?))
    });
    let law = row("  law", runs, |run| {
        match index(run).map(|index| &run.prepared.pairs()[index].law) {
            None => NONE.into(),
            Some(law) if law.is_compliant() => law.name().replace('_', " "),
            // A cell has no room for the name of the only impulsive law.
            Some(_) => String::from("impulsive"),
        }
    });
    [name, law].into_iter().chain(rows).collect()
}

fn of_link(runs: &[ComparedRun], link: usize) -> Vec<ComparedRow> {
    let text = |name: &str, of: fn(&Link, &Scene) -> String| {
        row(name, runs, |run| {
            let scene = run.prepared.scene();
            scene.links.get(link).map_or(String::from(NONE), |link| of(link, scene))
        })
    };
    let name = text(&format!("Link {}", link + 1), |link, scene| link.names(scene).join(" – "));
    let law = text("  law", |link, _| link.law.name().into());
    let rows = tables::LINKS.iter().map(|one| {
        let quantity = (*one).into();
        let has = |run: &ComparedRun| link < run.prepared.scene().links.len();
        number(runs, quantity, |run| run.shown().value(quantity, Some(link).filter(|_| has(run))?))
    });
    [name, law].into_iter().chain(rows).collect()
}

/// Number of collisions, and that of the exact run if it differs.
fn collisions(run: &ComparedRun, pair: usize) -> String {
    let shown = run.shown();
    let found = shown.text(PairQuantity::Collisions, pair).unwrap_or_default();
    match shown.error(PairQuantity::Collisions, pair) {
        Some(exact) if exact.starts_with("exact") => format!("{found} ({exact})"),
        _ => found,
    }
}
