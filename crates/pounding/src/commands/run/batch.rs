//! `pounding run --records`: the scene under every record of a folder, a line each.

mod motion;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use pounding::assess::{Distribution, Effects, MotionLine};
use pounding::report::{FILES_OF_RECORDS, OfFolder, SCHEMA_VERSION, Site};
use pounding::scene::{Error, Floors, PairQuantity, Scene};
use pounding::text::{Answer, Cell, Form, Grid, NONE, Refused, Shown, Table, Where, instant, percent, short, two_decimals};

use super::Arguments;
use crate::commands::suite;
use motion::{RunUnderMotion, between, push_of};

/// The runs of a folder.
type Runs<'a> = OfFolder<'a, RunUnderMotion>;

/// The scene under every record of a folder.
pub(super) fn run(args: &Arguments, folder: &Path) -> Result<String, Refused> {
    let path = &args.scene;
    let scene: Scene = super::super::read(path).map_err(|error: Error| error.in_file(path))?;
    let directions: &[bool] = if args.suite.both {
        &[false, true]
    } else {
        &[scene.record.reversed]
    };
    let out = args.results.open_beside(&[folder], vec![path.clone()])?;
    let any_record = Scene {
        duration_s: None,
        ..scene.clone()
    };
    Floors::check(&any_record).map_err(|error| error.in_file(path))?;
    let records = suite::read(folder, &args.declared, &scene)?;
    let ran = suite::lines(&scene, &records, directions, |prepared| {
        let review = prepared.review(!args.model.no_error)?;
        // The effects of a motion are those of both directions.
        let once = prepared.scene().record.reversed == directions[0];
        let effects = (args.effects && once).then(|| Effects::of(prepared));
        Ok(RunUnderMotion::new(prepared, &review, effects.transpose()?))
    })?;
    let runs = OfFolder {
        scene: &scene,
        suite: &records,
        lines: &ran.lines,
    };
    let mut answer = answer(&runs);
    if let Some(out) = out {
        out.write(&files(&answer))?;
        answer = answer.say(Where::Terminal, "Results", vec![out.path().display().to_string()]);
    }
    ran.answer(answer.text(args.form()))
}

/// The files of a folder of results, by name: the lines for programs and for people.
fn files(answer: &Answer<'_>) -> BTreeMap<String, Vec<u8>> {
    let texts = [Form::Csv, Form::Json, Form::Details].map(|form| answer.text(form).into_bytes());
    FILES_OF_RECORDS.map(String::from).into_iter().zip(texts).collect()
}

fn answer<'a>(runs: &'a Runs<'_>) -> Answer<'a> {
    let several = runs.found().any(|(_, run)| run.pairs.len() > 1);
    let answer = runs
        .answer()
        .table(Where::Terminal, lines(runs))
        .say(Where::Terminal, "Result", result(runs))
        .say(Where::Terminal, "Warnings", runs.warnings());
    effects(runs, answer)
        .say(Where::Terminal, "Records", runs.records(true))
        .say(
            Where::Terminal,
            "Notes",
            [Some(NOTES), several.then_some(OF_PAIRS)]
                .into_iter()
                .flatten()
                .map(String::from)
                .collect(),
        )
        .fact("schema_version", SCHEMA_VERSION)
        .with_csv(|| {
            let table = runs.table(
                |line, run| run.rows(runs.scene, line),
                |table| {
                    Site::columns(table, |row| &row.found.site)
                        .column("quantity", |row| Cell::from(row.found.quantity.as_str()))
                        .column("value", |row| Cell::exact(row.found.value))
                },
            );
            table.csv()
        })
}

const OF_PAIRS: &str =
    "Below a record, the pair of the largest impulse; leaning: in a touch of more than 0.25 s, longer than a blow, which is a push.";

const NOTES: &str = "Scale: what the record was multiplied by. Impulse, force and displ.: the largest of all collisions and structures; \
                     force, of the laws that have one. Error: the largest distance of a \
                     printed number from the exact run; ! marks a run with warnings, which a run of that record alone prints. \
                     --csv has every structure and pair.";

/// A line of the table: a run, or below it the pair that collides hardest.
struct RunLine<'a> {
    name: String,
    /// `None` for a pair.
    run: Option<&'a RunUnderMotion>,
}

impl RunLine<'_> {
    /// A cell of the run; an empty one for a pair.
    fn cell<S: Into<Shown>>(&self, text: impl Fn(&RunUnderMotion) -> S) -> Shown {
        self.run.map_or_else(|| "".into(), |run| text(run).into())
    }
}

fn lines(runs: &Runs<'_>) -> Grid {
    let rows = runs.found().flat_map(|(line, run)| {
        let hardest = run.hardest().filter(|_| run.pairs.len() > 1);
        let pair = hardest.map(|(pair, _)| RunLine {
            name: format!("  at {}", between(pair)),
            run: None,
        });
        let run = RunLine {
            name: line.name(),
            run: Some(run),
        };
        std::iter::once(run).chain(pair)
    });
    let gravity = runs.scene.record.gravity_m_per_s2;
    Table::of(rows)
        .shown("Record", |row| Shown::from(row.name.as_str()))
        .shown_in("g", "PGA", move |row| row.cell(|run| short(run.pga / gravity)))
        .shown("Scale", |row| row.cell(|run| short(run.scale)))
        .shown("Collisions", |row| row.cell(|run| run.all.collisions))
        .shown_in("s", "First", |row| row.cell(|run| run.all.first.map(|first| instant(first.start))))
        .shown_in("kN·s", "Impulse", |row| {
            row.cell(|run| run.all.largest.map(|largest| short(1e-3 * largest.impulse)))
        })
        .shown_in("kN", "Force", |row| row.cell(|run| run.force().map(|force| short(1e-3 * force))))
        .shown_in("mm", "Displ.", |row| row.cell(|run| short(1e3 * run.displacement())))
        .shown("Error", |row| {
            row.cell(|run| {
                let mark = if run.warnings.is_empty() { "" } else { "!" };
                format!("{}{mark}", run.error.map_or(run.why.into(), percent))
            })
        })
        .grid()
}

/// Under how many events structures touch, and where hardest.
fn result(runs: &Runs<'_>) -> Vec<String> {
    if let Some(said) = runs.found().find_map(|(_, run)| run.floors.says_no_contact()) {
        return vec![said.into()];
    }
    let all = runs.found().count();
    let hits = runs.found().filter_map(|(line, run)| Some((line, run, run.hardest()?)));
    let hits: Vec<_> = hits.collect();
    let events =
        |lines: &mut dyn Iterator<Item = &MotionLine<RunUnderMotion>>| lines.map(|line| line.event).collect::<BTreeSet<usize>>().len();
    let finished = events(&mut runs.found().map(|(line, _)| line));
    let touch = format!(
        "they touch under {} of {finished} event{} ({} of {all} runs)",
        events(&mut hits.iter().map(|(line, ..)| *line)),
        if finished == 1 { "" } else { "s" },
        hits.len()
    );
    let missed = runs.found().filter(|(_, run)| run.misses());
    let missed: Vec<String> = missed.map(|(line, _)| line.name()).collect();
    let missed = (!missed.is_empty()).then(|| {
        let n = missed.len();
        format!("the steps miss the touches that exact motion has under {n}: {}", missed.join(", "))
    });
    let hardest = hits.iter().max_by(|one, other| one.2.1.total_cmp(&other.2.1));
    let hardest = hardest.map(|(line, run, (pair, impulse))| {
        let several = run.pairs.len() > 1;
        let between = if several {
            format!(", at {}", between(pair))
        } else {
            String::new()
        };
        format!(
            "{} is that under {}: {} kN·s{between}",
            if let Some(lasts) = push_of(pair) {
                format!("the largest impulse is no blow, but a push of {} s, and", short(lasts))
            } else {
                "the hardest collision".into()
            },
            line.name(),
            short(impulse / 1e3)
        )
    });
    let collapsed = runs.found().filter(|(_, run)| run.collapse.is_some());
    let collapsed = told("a storey collapses", collapsed.map(|(line, _)| line), finished);
    let off = |pair: usize| {
        let (_, first) = runs.found().next()?;
        let is_off = |run: &RunUnderMotion| run.pairs[pair].number(PairQuantity::UnseatedS).is_some();
        let lines = runs.found().filter(|(_, run)| is_off(run)).map(|(line, _)| line);
        let [support, deck] = first.floors.of_seat(pair);
        told(&format!("{deck} leaves its seat on {support}"), lines, finished)
    };
    let n_pairs = runs.found().next().map_or(0, |(_, run)| run.pairs.len());
    let unseated = (0..n_pairs).filter_map(off);
    let first = [collapsed].into_iter().flatten().chain(unseated);
    first.chain([Some(touch), missed, hardest].into_iter().flatten()).collect()
}

#[expect(single_use_lifetimes, reason = "an anonymous one is unstable here")]
/// What happens under these motions, in how many of `of` events, in a sentence; `None` if it happens under none.
fn told<'a>(what: &str, lines: impl Iterator<Item = &'a MotionLine<RunUnderMotion>>, of: usize) -> Option<String> {
    let lines: Vec<_> = lines.collect();
    let n = lines.iter().map(|line| line.event).collect::<BTreeSet<usize>>().len();
    let s = if of == 1 { "" } else { "s" };
    let first = lines.first()?;
    Some(format!("{what} under {n} of {of} event{s}, first {}", first.name()))
}

/// Adds the effects of pounding on every storey, if they were asked for.
fn effects<'a>(runs: &Runs<'_>, answer: Answer<'a>) -> Answer<'a> {
    let all = runs
        .found()
        .filter_map(|(line, run)| Some((line.event, run, run.effects.as_ref()?)));
    let all: Vec<_> = all.collect();
    let Some((_, first, _)) = all.first() else {
        return answer;
    };
    let floors = &first.floors;
    let ratio = |floor: usize, response: usize| {
        let both = all
            .iter()
            .flat_map(|(event, _, one)| [(event, &one.as_given[floor]), (event, &one.reversed[floor])]);
        let ratios = both.filter_map(|(event, one)| Some(([*event, 0], one.responses()[response]?.amplification?.value)));
        let all = Distribution::of_cases(ratios);
        all.map_or(NONE.into(), |all| {
            if all.has_quantiles() {
                format!("{} / {}", two_decimals(all.median()), two_decimals(all.p84()))
            } else {
                two_decimals(all.largest())
            }
        })
    };
    let events = all.iter().map(|(event, ..)| event).collect::<BTreeSet<_>>().len();
    let heading = match events {
        n if n >= Distribution::ENOUGH => "Storey, median / 84 %".into(),
        1 => "Storey, the only event".into(),
        n => format!("Storey, largest of {n} events"),
    };
    let table = Table::of(floors.by_structure().filter(|floor| !floors.all()[*floor].is_wall()))
        .shown(heading, |floor| floors.storey_name(*floor))
        .shown("Drift × alone", |floor| ratio(*floor, 0))
        .shown("Shear × alone", |floor| ratio(*floor, 1))
        .shown("Acceleration of its floor × alone", |floor| ratio(*floor, 2));
    let notes = format!(
        "peaks beside the neighbours over those of the same building alone, by the exact method, under {} motions in both directions, which \
         count once for each event; for the contact stiffness of the scene, on which accelerations depend: `pounding assess` gives their range; \
         --csv has every motion, --json also how far a change of the record by 1 % moves each number",
        all.len()
    );
    answer
        .table(Where::Terminal, table.grid())
        .say(Where::Terminal, "Effects", vec![notes])
}
