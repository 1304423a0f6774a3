//! `pounding run --records`: the scene under every record of a folder, a line each.

mod data;
mod effects;

use pounding::text::Refused;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use pounding::report::{CollisionSummary, FILES_OF_RECORDS, PairSummary, StructureSummary};
use pounding::scene::lines::failed;
use pounding::scene::{
    Effects, Error, Errors, Excess, FloorQuantity, Floors, Implausible, PairOutcome, PairQuantity, QuantityGroup, Review, Scene,
    Simulation, Suite,
};
use pounding::text::{Form, digits};

use super::Arguments;
use crate::commands::suite;
use crate::text::{NONE, paragraph, percent, short, table};

/// What became of the scene under one motion in one direction.
type Line = suite::Line<Found>;

/// What is printed of a run.
struct Found {
    /// Peak ground acceleration \[m/s²\], without sign.
    pga: f64,
    /// What the record was multiplied by, all scales together.
    scale: f64,
    /// Largest error, where it was measured.
    error: Option<f64>,
    /// Why it was not, in a word.
    why: &'static str,
    /// What looks wrong.
    unusual: Vec<Implausible>,
    /// What is beyond the model or codes.
    excesses: Vec<Excess>,
    warnings: Vec<String>,
    /// The collisions of all pairs.
    all: PairOutcome,
    structures: Vec<StructureSummary>,
    pairs: Vec<PairSummary>,
    /// What pounding does to every storey, in both directions, where that was asked for.
    effects: Option<Effects>,
    floors: Floors,
    /// Names of the structures.
    names: Vec<String>,
}

impl Found {
    fn new(prepared: &Simulation, review: &Review, effects: Option<Effects>) -> Self {
        let (error, why) = match &review.errors {
            Errors::Measured(errors, _) => (Some(errors.largest(QuantityGroup::All).0), ""),
            Errors::Exact => (None, "exact"),
            Errors::Doubtful | Errors::NotMeasured | Errors::Unknown(_) => (None, NONE),
        };
        Self {
            pga: prepared.record().peak().1.abs(),
            scale: prepared.scale(),
            error,
            why,
            unusual: prepared.doubts(),
            excesses: review.excesses.clone(),
            warnings: review.notices(),
            all: PairOutcome::of(review.outcome.collisions.all()),
            structures: StructureSummary::of_run(prepared, review),
            pairs: PairSummary::of_run(prepared, review),
            effects,
            floors: prepared.floors().clone(),
            names: prepared.scene().structures.iter().map(|one| one.name().into()).collect(),
        }
    }

    /// The largest pounding force \[N\] of the pairs that have one: an impulse has none.
    fn force(&self) -> Option<f64> {
        let forces = self.pairs.iter().filter_map(|pair| pair.number(PairQuantity::PeakForceN));
        forces.max_by(f64::total_cmp)
    }

    /// The pair with the largest impulse, where anything touches.
    fn hardest(&self) -> Option<&PairSummary> {
        let hits = self.pairs.iter();
        let hits = hits.filter_map(|pair| Some((pair.largest?.impulse_n_s, pair)));
        // Of equal ones the first.
        let harder = |most: (f64, _), next: (f64, _)| if next.0 > most.0 { next } else { most };
        hits.reduce(harder).map(|(_, pair)| pair)
    }

    /// Whether exact motion touches, where this run does not.
    fn misses(&self) -> bool {
        let errors = self.pairs.iter().filter_map(|pair| pair.errors.as_ref());
        self.all.collisions == 0 && errors.map(|errors| errors.exact_collisions).sum::<usize>() > 0
    }

    /// The largest peak displacement of a structure \[m\], without sign.
    fn displacement(&self) -> f64 {
        let peaks = self.structures.iter();
        let peaks = peaks.filter_map(|one| one.numbers.get(FloorQuantity::PeakDisplacementM));
        peaks.map(f64::abs).fold(0.0, f64::max)
    }
}

/// The scene under every record of a folder.
pub(super) fn run(args: &Arguments, folder: &Path) -> Result<String, Refused> {
    let path = &args.scene;
    let scene: Scene = super::super::read(path).map_err(|error: Error| error.in_file(path))?;
    let directions: &[bool] = if args.suite.both {
        &[false, true]
    } else {
        &[scene.record.reversed]
    };
    let out = args.results.open()?;
    if let Some(out) = &out {
        out.keep(&[super::super::inputs_in(folder), vec![path.clone()]].concat())?;
        out.apart_from(folder)?;
    }
    let records = suite::read(folder, &args.declared, &scene)?;
    let ran = suite::lines(&scene, &records, directions, |prepared| {
        let review = prepared.review(!args.model.no_error)?;
        // They are of both directions.
        let once = prepared.scene().record.reversed == directions[0];
        let effects = (args.effects && once).then(|| Effects::of(prepared));
        Ok(Found::new(prepared, &review, effects.transpose()?))
    })?;
    let lines = &ran.lines;
    let mut answer = match args.form() {
        Form::Brief | Form::Details => text(&scene, &records, lines),
        Form::Csv => data::csv(&records, lines),
        Form::Json => data::json(&scene, &records, lines),
    };
    if let Some(out) = out {
        out.write(&files(&scene, &records, lines))?;
        if args.form().is_for_people() {
            let results = paragraph("Results", &out.path().display().to_string());
            answer = format!("{answer}\n{results}");
        }
    }
    ran.answer(answer)
}

/// The files of a folder of results, by name: the lines for programs and for people.
fn files(scene: &Scene, records: &Suite, lines: &[Line]) -> BTreeMap<String, Vec<u8>> {
    let texts = [
        data::csv(records, lines),
        data::json(scene, records, lines),
        text(scene, records, lines),
    ];
    let texts = texts.map(String::into_bytes);
    FILES_OF_RECORDS.map(String::from).into_iter().zip(texts).collect()
}

fn text(scene: &Scene, records: &Suite, lines: &[Line]) -> String {
    let mut parts: Vec<String> = crate::text::unusual(&unusual(lines)).into_iter().collect();
    let warnings = warnings(records, lines);
    if !warnings.is_empty() {
        parts.push(paragraph("Warnings", &warnings.join("\n")));
    }
    parts.extend([
        paragraph("Scene", &scene.name),
        runs(scene, lines),
        paragraph("Result", &result(lines)),
    ]);
    parts.extend(effects::text(lines));
    parts.push(suite::records(records, lines, true));
    let found = lines.iter().filter_map(|line| line.found.as_ref().ok());
    let several = found.into_iter().any(|found| found.pairs.len() > 1);
    let notes = if several { format!("{NOTES}\n{OF_PAIRS}") } else { NOTES.into() };
    parts.push(paragraph("Notes", &notes));
    parts.join("\n")
}

/// What looks wrong in the scene and in its records, a line for each kind.
fn unusual(lines: &[Line]) -> Vec<Implausible> {
    let found = lines.iter().filter_map(|line| Some((line, line.found.as_ref().ok()?)));
    Implausible::gathered(found.flat_map(|(line, found)| {
        let doubts = found.unusual.iter();
        doubts.map(|doubt| (line.motion.as_str(), doubt))
    }))
}

/// Responses beyond the model or codes over all runs.
fn warnings(records: &Suite, lines: &[Line]) -> Vec<String> {
    let found = lines.iter().filter_map(|line| line.found.as_ref().ok());
    let all = Excess::gathered(found.map(|found| &found.excesses));
    let missing = records.says_missing(failed(lines).len()).into_iter();
    missing.chain(all.iter().map(ToString::to_string)).collect()
}

const OF_PAIRS: &str =
    "Below a record, the pair of the largest impulse; leaning: in a touch of more than 0.25 s, which is a push and no blow.";

const NOTES: &str = "Scale: what the record was multiplied by. Impulse, force and displ.: the largest of all collisions and structures; \
                     force, of the laws that have one. Error: the largest distance of a \
                     printed number from the exact run; ! marks a run with warnings, which a run of that record alone prints. \
                     --csv has every structure and pair.";

fn runs(scene: &Scene, lines: &[Line]) -> String {
    let header = [
        ["Record", ""],
        ["PGA", "[g]"],
        ["Scale", ""],
        ["Colli-", "sions"],
        ["First", "[s]"],
        ["Impulse", "[kN·s]"],
        ["Force", "[kN]"],
        ["Displ.", "[mm]"],
        ["Error", ""],
    ];
    let rows = |line: &Line| {
        let found = line.found.as_ref().ok()?;
        let PairOutcome {
            collisions,
            first,
            largest,
            ..
        } = found.all;
        let mark = if found.warnings.is_empty() { "" } else { "!" };
        let row = vec![
            line.name(),
            short(found.pga / scene.record.gravity_m_per_s2),
            short(found.scale),
            collisions.to_string(),
            first.map_or(NONE.into(), |first| digits((first.start * 1e4).round() * 1e-4)),
            largest.map_or(NONE.into(), |largest| short(largest.impulse / 1e3)),
            found.force().map_or(NONE.into(), |force| short(force / 1e3)),
            short(1e3 * found.displacement()),
            format!("{}{mark}", found.error.map_or(found.why.into(), percent)),
        ];
        let several = found.pairs.len() > 1;
        let hardest = found.hardest().filter(|_| several).map(|pair| {
            let mut row = vec![format!("  at {}", between(pair))];
            row.resize(header.len(), String::new());
            row
        });
        Some(std::iter::once(row).chain(hardest))
    };
    let rows = lines.iter().filter_map(rows).flatten();
    table(&header, &rows.collect::<Vec<_>>())
}

/// A pair by its names; that its largest impulse is a push, where it is.
fn between(pair: &PairSummary) -> String {
    let start = |one: Option<CollisionSummary>| one.map(|one| one.start_s.to_bits());
    let leans = pair.leaning.is_some() && start(pair.leaning) == start(pair.largest);
    let leans = if leans { " (leaning)" } else { "" };
    format!("{} – {}{leans}", pair.left, pair.right)
}

/// Under how many events they touch, and where hardest.
fn result(lines: &[Line]) -> String {
    let found = lines.iter().filter_map(|line| line.found.as_ref().ok());
    if let Some(said) = found.clone().find_map(|one| one.floors.says_no_contact()) {
        return said.into();
    }
    let all = found.count();
    let hits = lines.iter().filter_map(|line| {
        let hardest = line.found.as_ref().ok()?.hardest()?;
        Some((line, hardest, hardest.largest?.impulse_n_s))
    });
    let hits: Vec<_> = hits.collect();
    let events = |lines: &mut dyn Iterator<Item = &Line>| {
        let events: BTreeSet<usize> = lines.map(|line| line.event).collect();
        events.len()
    };
    let finished = events(&mut lines.iter().filter(|line| line.found.is_ok()));
    let mut touch = format!(
        "they touch under {} of {finished} event{} ({} of {all} runs)",
        events(&mut hits.iter().map(|(line, ..)| *line)),
        if finished == 1 { "" } else { "s" },
        hits.len()
    );
    let missed = lines.iter().filter(|line| line.found.as_ref().is_ok_and(Found::misses));
    let missed: Vec<String> = missed.map(Line::name).collect();
    if !missed.is_empty() {
        touch = format!(
            "{touch};\nthe steps miss the touches that exact motion has under {}: {}",
            missed.len(),
            missed.join(", ")
        );
    }
    match hits.iter().max_by(|a, b| a.2.total_cmp(&b.2)) {
        None => touch,
        Some((line, pair, impulse)) => {
            let reversed = if line.reversed { ", reversed" } else { "" };
            let several = line.found.iter().any(|found| found.pairs.len() > 1);
            let between = several.then(|| format!(", at {}", between(pair)));
            let between = between.unwrap_or_default();
            format!(
                "{touch}\nthe hardest collision is that under {}{reversed}: {} kN·s{between}",
                line.motion,
                short(impulse / 1e3)
            )
        }
    }
}
