//! `pounding motion spectrum`: spectra of a record; responses by the exact method.

mod further;
mod pairs;

use std::path::{Path, PathBuf};

use pounding::report::{SpectraLabels, spectra_figure, spectra_table, spectral_columns};
use pounding::scene::{SpectralValues, Spectrum, response_spectra};
use pounding::text::{Answer, Form, Refused, Table, Where, percent, short};
use serde_json::json;

use super::source::{Declared, Opened};
use crate::commands::{part_of_one, positive};
use crate::new_file;
use crate::progress::Counter;

const EXAMPLES: &str = "\
Examples:
  pounding motion spectrum quake.AT2
  pounding motion spectrum quake.AT2 --periods 0,0.1,0.5,1,2 --damping 2%,5%
  pounding motion spectrum quake.AT2 --figure spectrum.svg
  pounding motion spectrum quake.AT2 --count 200 --csv > spectrum.csv
  pounding motion spectrum --pairs records
  pounding motion spectrum quake.AT2 --ductility 2,4
  pounding motion spectrum quake.AT2 --fourier

Without --periods and --count the table has the periods of ground-motion models
between --from and --to. A figure is drawn through 400 periods in equal ratios
and those of the table. Every value is exact for an acceleration that is linear
between samples: no time step.";

/// The arguments of `motion spectrum`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[expect(clippy::struct_excessive_bools, reason = "each is an option of the program")]
pub(super) struct Arguments {
    /// The record; with --pairs one or more files and folders.
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// Two horizontal components together: median and maximum over all directions, geometric mean.
    #[arg(long, conflicts_with = "figure")]
    pairs: bool,
    /// Yield forces at which elastic-perfectly plastic structures have these ductilities, 1 to 100.
    #[arg(long, value_name = "RATIO,…", value_delimiter = ',', allow_negative_numbers = true, conflicts_with_all = ["pairs", "figure", "fourier"])]
    ductility: Vec<f64>,
    /// Fourier amplitudes of the record at the frequencies 1/T.
    #[arg(long, conflicts_with_all = ["pairs", "figure", "damping"])]
    fourier: bool,
    /// Natural periods [s], 0 for the ground itself.
    #[arg(long, value_name = "T,T,…", value_delimiter = ',', value_parser = period, allow_negative_numbers = true, conflicts_with_all = ["from", "to", "count"])]
    periods: Vec<f64>,
    /// Shortest period [s].
    #[arg(long, value_name = "T", default_value_t = 0.02, allow_negative_numbers = true, value_parser = positive)]
    from: f64,
    /// Longest period [s].
    #[arg(long, value_name = "T", default_value_t = 10.0, allow_negative_numbers = true, value_parser = positive)]
    to: f64,
    /// Number of periods, in equal ratios; with --csv and --json 100.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    count: Option<u32>,
    /// Damping ratios, as 5% or 0.05.
    #[arg(long, value_name = "RATIO,…", value_delimiter = ',', default_value = "5%", allow_negative_numbers = true, value_parser = part_of_one)]
    damping: Vec<f64>,
    /// Draw the spectra: .png or .svg.
    #[arg(long, value_name = "PICTURE", value_parser = picture)]
    figure: Option<PathBuf>,
    /// Replace a picture that exists.
    #[arg(long, requires = "figure")]
    overwrite: bool,
    /// Print a table for a program, SI units.
    #[arg(long)]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    #[command(flatten)]
    declared: Declared,
}

impl Arguments {
    /// The record, without --pairs.
    fn file(&self) -> &Path {
        &self.files[0]
    }
}

/// A natural period of 0 or more.
fn period(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value),
        _ => Err("allowed is a finite number >= 0".into()),
    }
}

/// The name of a picture that can be drawn.
fn picture(text: &str) -> Result<PathBuf, String> {
    match Path::new(text).extension() {
        Some(ending) if ending == "png" || ending == "svg" => Ok(text.into()),
        _ => Err("allowed is a name that ends with .png or .svg".into()),
    }
}

/// Default periods of a table \[s\]: those of the models of NGA-West2 (Y. Bozorgnia et al., *Earthquake Spectra*
/// 30 (2014) 973).
const TABLE: [f64; 21] = [
    0.01, 0.02, 0.03, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.5, 10.0,
];

/// Default number of periods for programs.
const COUNT: u32 = 100;

/// Periods through which a figure is drawn. From 0.02 s to 10 s they are 1.6 % apart: the narrowest resonance at 2 % damping, 4 % wide, has
/// more than two.
const DRAWN: u32 = 400;

/// The spectra.
pub(super) fn run(args: &Arguments) -> Result<String, Refused> {
    if args.pairs {
        return pairs::run(args);
    }
    if let [_, others @ ..] = &args.files[..]
        && !others.is_empty()
    {
        let found = Refused::at("FILE").found(format!("{} files", args.files.len()));
        return Err(found
            .allowed_is("one")
            .help("give --pairs for the two horizontal components of a recording"));
    }
    if args.file().is_dir() {
        let found = Refused::at("FILE").found(format!("the folder {}", args.file().display()));
        return Err(found
            .allowed_is("a file")
            .help("give --pairs for the two horizontal components of each recording"));
    }
    if args.fourier {
        return further::fourier(args);
    }
    if !args.ductility.is_empty() {
        return further::ductilities(args);
    }
    let opened = args.declared.open(args.file())?;
    if let Some(figure) = &args.figure {
        new_file::check(figure, &args.files, args.overwrite)?;
    }
    let periods = periods(args)?;
    let drawn = args.figure.as_ref().map(|_| between(args, &periods));
    let n_drawn = drawn.as_ref().map_or(0, Vec::len);
    let runs = (periods.len() + n_drawn) * args.damping.len();
    let progress = Counter::new(0, runs as u64);
    let spectra = |periods: &[f64]| {
        let done = || progress.add(1);
        response_spectra(&opened.record, periods, &args.damping, None, &done).map_err(|refused| refused.in_file(args.file()))
    };
    let listed = spectra(&periods)?;
    let curves = drawn.map(|periods| spectra(&periods)).transpose()?;
    drop(progress);
    if let (Some(path), Some(curves)) = (&args.figure, curves) {
        draw(args, &opened, &with(curves, &listed), path)?;
    }
    Ok(answer(args, &opened, &listed).text(Form::asked(false, args.csv, args.json)))
}

/// The periods that are asked for.
fn periods(args: &Arguments) -> Result<Vec<f64>, Refused> {
    if !args.periods.is_empty() {
        return Ok(args.periods.clone());
    }
    let (from, to) = (args.from, args.to);
    if from >= to && args.count != Some(1) {
        let found = Refused::at("--from").found(from.to_string());
        let found = found.allowed(format!("less than --to, which is {to}"));
        return Err(found.help("exchange them, or ask for --count 1"));
    }
    Ok(match args.count {
        Some(count) => pounding::scene::periods_between(from, to, count),
        None if args.csv || args.json => pounding::scene::periods_between(from, to, COUNT),
        None => {
            let inside = TABLE.into_iter().filter(|period| from < *period && *period < to);
            [from].into_iter().chain(inside).chain([to]).collect()
        }
    })
}

/// Periods of a figure, from the shortest to the longest of a table; the default ones if a table has fewer than two.
fn between(args: &Arguments, periods: &[f64]) -> Vec<f64> {
    let positive = || periods.iter().copied().filter(|period| *period > 0.0);
    let (mut from, mut to) = (positive().fold(f64::INFINITY, f64::min), positive().fold(0.0, f64::max));
    if from >= to {
        (from, to) = (args.from.min(from), args.to.max(to));
    }
    pounding::scene::periods_between(from, to, DRAWN)
}

/// Adds the values of a table to curves.
fn with(mut curves: Vec<Spectrum>, listed: &[Spectrum]) -> Vec<Spectrum> {
    for (curve, listed) in curves.iter_mut().zip(listed) {
        curve.values.extend(&listed.values);
        let by_period = |a: &SpectralValues, b: &SpectralValues| a.period.total_cmp(&b.period);
        curve.values.sort_by(by_period);
        curve.values.dedup_by_key(|values| values.period.to_bits());
    }
    curves
}

fn draw(args: &Arguments, opened: &Opened, spectra: &[Spectrum], path: &Path) -> Result<(), Refused> {
    let name = args.file().file_name().unwrap_or_default();
    let title = match component(args, opened) {
        Some(component) => format!("{} {component}", name.to_string_lossy()),
        None => name.to_string_lossy().into_owned(),
    };
    let shown = SpectraLabels {
        title: &title,
        gravity: args.declared.gravity,
    };
    let (svg, png) = spectra_figure(spectra, shown).map_err(|error| format!("--figure {}: {error}", path.display()))?;
    let is_png = path.extension().is_some_and(|ending| ending == "png");
    let bytes = if is_png { &png } else { svg.as_bytes() };
    new_file::write(path, bytes, args.overwrite)
}

/// The component that was asked for, as the file spells it.
fn component(args: &Arguments, opened: &Opened) -> Option<String> {
    let declared = args.declared.component.clone()?;
    Some(opened.component().unwrap_or(declared))
}

/// The record in words.
fn record(args: &Arguments, opened: &Opened) -> Vec<String> {
    let (time, peak) = opened.record.peak();
    let record = format!(
        "{}, {} samples, {} s apart, peak {} g at {} s",
        opened.file().format().name(),
        opened.record.samples().len(),
        opened.record.time_step(),
        short(peak / args.declared.gravity),
        short(time)
    );
    vec![args.file().display().to_string(), record]
}

fn answer<'a>(args: &Arguments, opened: &Opened, spectra: &'a [Spectrum]) -> Answer<'a> {
    let gravity = args.declared.gravity;
    let numbers = |spectrum: &'a Spectrum| spectral_columns(Table::of(&spectrum.values).gravity(gravity), |values| values);
    let answer = Answer::new().say(Where::Terminal, "Record", record(args, opened));
    let answer = spectra.iter().fold(answer, |answer, spectrum| {
        let damping = vec![percent(spectrum.damping_ratio)];
        answer
            .say(Where::Terminal, "Damping", damping)
            .table(Where::Terminal, numbers(spectrum).grid())
    });
    let figure = args.figure.iter().map(|path| path.display().to_string());
    let json = |spectrum: &'a Spectrum| json!({"damping_ratio": spectrum.damping_ratio, "values": numbers(spectrum).json()});
    answer
        .say(Where::Terminal, "Notes", vec![NOTES.into()])
        .say(Where::Terminal, "Figure", figure.collect())
        .fact("file", args.file().display().to_string())
        .fact("component", component(args, opened))
        .fact("gravity_m_per_s2", gravity)
        .fact("spectra", spectra.iter().map(json).collect::<Vec<_>>())
        .with_csv(move || spectra_table(spectra).csv())
}

const NOTES: &str = "Sd: largest displacement relative to the ground; pseudo-Sv = (2π/T) Sd; pseudo-Sa = (2π/T)² Sd, times the mass \
                     the largest restoring force; Sa: largest absolute acceleration.";
