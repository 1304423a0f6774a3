//! `pounding motion spectrum`: response spectra of a record, by the exact method.

use std::path::{Path, PathBuf};

use pounding::studies::{
    Shown, SpectralValues, Spectrum, response_spectrum_watched, spectra_figure,
};
use serde_json::{Value, json};

use super::source::{Declared, Opened};
use crate::commands::{json_text, part_of_one, positive};
use crate::new_file;
use crate::progress::Progress;
use crate::text::{paragraph, percent, short, table};

const EXAMPLES: &str = "\
Examples:
  pounding motion spectrum quake.AT2
  pounding motion spectrum quake.AT2 --periods 0,0.1,0.5,1,2 --damping 2%,5%
  pounding motion spectrum quake.AT2 --count 400 --figure spectrum.svg
  pounding motion spectrum quake.AT2 --count 200 --csv > spectrum.csv

Periods without --periods rise in equal ratios. Every value is exact for an
acceleration that is linear between samples: no time step.";

/// What is asked of `motion spectrum`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The record.
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Natural periods [s], 0 for the ground itself.
    #[arg(long, value_name = "T,T,…", value_delimiter = ',', value_parser = period, conflicts_with_all = ["from", "to", "count"])]
    periods: Vec<f64>,
    /// Shortest period [s].
    #[arg(long, value_name = "T", default_value_t = 0.02, value_parser = positive)]
    from: f64,
    /// Longest period [s].
    #[arg(long, value_name = "T", default_value_t = 10.0, value_parser = positive)]
    to: f64,
    /// Number of periods.
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    count: u32,
    /// Damping ratios, as 5% or 0.05.
    #[arg(long, value_name = "RATIO,…", value_delimiter = ',', default_value = "5%", value_parser = part_of_one)]
    damping: Vec<f64>,
    /// Draw the spectra: .png or .svg.
    #[arg(long, value_name = "PICTURE", value_parser = picture)]
    figure: Option<PathBuf>,
    /// Write over a picture that is there already.
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

/// The spectra.
pub(super) fn answer(asked: &Arguments) -> Result<String, String> {
    let opened = asked.declared.open(&asked.file)?;
    let periods = periods(asked)?;
    let progress = Progress::new();
    let runs = periods.len() * asked.damping.len();
    let spectrum = |damping_ratio: &f64| {
        let done = || progress.step(runs);
        let values = response_spectrum_watched(&opened.record, &periods, *damping_ratio, &done)
            .map_err(|error| format!("{}: {error}", asked.file.display()))?;
        Ok(Spectrum {
            damping_ratio: *damping_ratio,
            values,
        })
    };
    let spectra: Vec<Spectrum> = asked
        .damping
        .iter()
        .map(spectrum)
        .collect::<Result<_, String>>()?;
    drop(progress);
    if let Some(path) = &asked.figure {
        draw(asked, &spectra, path)?;
    }
    Ok(if asked.json {
        json_of(asked, &spectra)
    } else if asked.csv {
        csv_of(&spectra)
    } else {
        text(asked, &opened, &spectra)
    })
}

/// The periods that are asked for.
fn periods(asked: &Arguments) -> Result<Vec<f64>, String> {
    if !asked.periods.is_empty() {
        return Ok(asked.periods.clone());
    }
    if asked.from >= asked.to && asked.count > 1 {
        return Err(format!(
            "--from: found {}, allowed less than --to, which is {}; exchange them, or ask for --count 1",
            asked.from, asked.to
        ));
    }
    Ok(pounding::studies::periods_between(
        asked.from,
        asked.to,
        asked.count,
    ))
}

fn draw(asked: &Arguments, spectra: &[Spectrum], path: &Path) -> Result<(), String> {
    let mut values = spectra.iter().flat_map(|spectrum| &spectrum.values);
    if values.all(|values| values.period <= 0.0) {
        return Err(format!(
            "--figure {}: found no period > 0, which its logarithmic axis needs; add some to --periods",
            path.display()
        ));
    }
    let name = asked.file.file_name().unwrap_or_default();
    let title = match &asked.declared.component {
        Some(component) => format!("{} {component}", name.to_string_lossy()),
        None => name.to_string_lossy().into_owned(),
    };
    let shown = Shown {
        title: &title,
        gravity: asked.declared.gravity,
    };
    let (svg, png) = spectra_figure(spectra, shown)
        .map_err(|error| format!("--figure {}: {error}", path.display()))?;
    let is_png = path.extension().is_some_and(|ending| ending == "png");
    let bytes = if is_png { &png } else { svg.as_bytes() };
    new_file::write(path, bytes, asked.overwrite)
}

fn text(asked: &Arguments, opened: &Opened, spectra: &[Spectrum]) -> String {
    let gravity = asked.declared.gravity;
    let (time, peak) = opened.record.peak();
    let record = format!(
        "{}\n{}, {} samples, {} s apart, peak {} g at {} s",
        asked.file.display(),
        opened.file.format().name(),
        opened.record.samples().len(),
        opened.record.time_step(),
        short(peak / gravity),
        short(time)
    );
    let mut parts = vec![paragraph("Record", &record)];
    parts.extend(spectra.iter().map(|spectrum| table_of(spectrum, gravity)));
    parts.push(paragraph("Notes", NOTES));
    if let Some(path) = &asked.figure {
        parts.push(paragraph("Figure", &path.display().to_string()));
    }
    parts.join("\n")
}

const NOTES: &str = "Sd: largest displacement relative to the ground; pseudo-Sv = (2π/T) Sd; pseudo-Sa = (2π/T)² Sd, times the mass \
                     the largest restoring force; Sa: largest absolute acceleration.";

fn table_of(spectrum: &Spectrum, gravity: f64) -> String {
    let header = [
        ["Period", "[s]"],
        ["Sd", "[mm]"],
        ["pseudo-Sv", "[m/s]"],
        ["pseudo-Sa", "[g]"],
        ["Sa", "[g]"],
    ];
    let row = |values: &SpectralValues| {
        vec![
            short(values.period),
            short(values.displacement * 1e3),
            short(values.pseudo_velocity),
            short(values.pseudo_acceleration / gravity),
            short(values.absolute_acceleration / gravity),
        ]
    };
    let rows: Vec<_> = spectrum.values.iter().map(row).collect();
    let damping = paragraph("Damping", &percent(spectrum.damping_ratio));
    format!("{damping}{}", table(&header, &rows))
}

/// Values of a structure with their names, SI units.
fn numbers(values: &SpectralValues) -> [(&'static str, f64); 5] {
    [
        ("period_s", values.period),
        ("sd_m", values.displacement),
        ("pseudo_sv_m_per_s", values.pseudo_velocity),
        ("pseudo_sa_m_per_s2", values.pseudo_acceleration),
        ("sa_m_per_s2", values.absolute_acceleration),
    ]
}

/// One row per damping ratio and period.
fn csv_of(spectra: &[Spectrum]) -> String {
    let line = |damping: &str, cells: [String; 5]| format!("{damping},{}\n", cells.join(","));
    let rows = spectra.iter().flat_map(|spectrum| {
        let damping = spectrum.damping_ratio.to_string();
        let values = spectrum.values.iter().map(numbers);
        values.map(move |numbers| line(&damping, numbers.map(|(_, value)| value.to_string())))
    });
    let values = spectra.iter().flat_map(|spectrum| &spectrum.values);
    let names = values.take(1).map(numbers);
    let header = names.map(|numbers| line("damping_ratio", numbers.map(|(name, _)| name.into())));
    header.chain(rows).collect()
}

fn json_of(asked: &Arguments, spectra: &[Spectrum]) -> String {
    let values = |values: &SpectralValues| -> Value {
        let numbers = numbers(values).map(|(name, value)| (name.to_string(), json!(value)));
        numbers
            .into_iter()
            .collect::<serde_json::Map<_, _>>()
            .into()
    };
    let spectrum = |spectrum: &Spectrum| {
        json!({
            "damping_ratio": spectrum.damping_ratio,
            "values": spectrum.values.iter().map(values).collect::<Vec<_>>(),
        })
    };
    let all = json!({
        "file": asked.file.display().to_string(),
        "component": asked.declared.component,
        "gravity_m_per_s2": asked.declared.gravity,
        "spectra": spectra.iter().map(spectrum).collect::<Vec<_>>(),
    });
    json_text(&all)
}
