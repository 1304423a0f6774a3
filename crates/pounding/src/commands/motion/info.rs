//! `pounding motion info`: what record files hold, where it stands, and how strong the motion is.

mod printed;

use std::path::{Path, PathBuf};

use pounding::motion::{Measures, components};
use rayon::prelude::*;

use super::source::{Declared, Opened, files};
use crate::commands::suite::nothing_found;
use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  pounding motion info quake.AT2
  pounding motion info records                  # every file of a folder
  pounding motion info station.v2 --component \"90 Deg\"
  pounding motion info list.txt --unit cm_per_s2 --time-step 0.005
  pounding motion info records --csv > measures.csv

Of several files, what is declared holds for those that do not say it.
Measures are exact for an acceleration that is linear between samples, and no
baseline is corrected: a large PGV or PGD tells of an offset.";

/// What is asked of `motion info`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// Record files, and folders of them.
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// Print a table for a program, SI units.
    #[arg(long)]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    #[command(flatten)]
    declared: Declared,
}

/// One component of one file.
struct Line {
    file: PathBuf,
    /// Its name, where the file holds several.
    component: Option<String>,
    found: Result<Found, String>,
}

/// A motion and its measures.
struct Found {
    opened: Opened,
    measures: Measures,
}

/// What the files hold.
pub(super) fn answer(asked: &Arguments) -> Result<String, String> {
    let files = files(&asked.files)?;
    let strict = files.len() == 1;
    let motions: Vec<_> = files
        .iter()
        .flat_map(|file| motions(file, &asked.declared))
        .collect();
    let progress = Progress::new();
    let line = |(file, component): &(PathBuf, Option<String>)| {
        let declared = asked.declared.of_component(component.clone());
        let opened = if strict {
            declared.open(file)
        } else {
            declared.open_one_of_several(file)
        };
        progress.step(motions.len());
        Line {
            file: file.clone(),
            component: component.clone(),
            found: opened.map(|opened| Found {
                measures: opened.record.measures(),
                opened,
            }),
        }
    };
    let lines: Vec<Line> = motions.par_iter().map(line).collect();
    all_refused(&lines)?;
    Ok(if asked.json {
        printed::json_of(&lines, asked.declared.gravity)
    } else if asked.csv {
        printed::csv_of(&lines, asked.declared.gravity)
    } else {
        printed::text(&lines, asked.declared.gravity)
    })
}

/// The motions of a file: one, or each component that is asked for.
fn motions(file: &Path, declared: &Declared) -> Vec<(PathBuf, Option<String>)> {
    let names = std::fs::read(file)
        .ok()
        .and_then(|bytes| components(&bytes).ok())
        .filter(|names| names.len() > 1);
    let components = match (names, &declared.component) {
        (Some(_), Some(asked)) => vec![Some(asked.clone())],
        (Some(names), None) => names.into_iter().map(Some).collect(),
        (None, _) => vec![None],
    };
    let motion = |component| (file.to_path_buf(), component);
    components.into_iter().map(motion).collect()
}

/// The reason, where nothing was read.
fn all_refused(lines: &[Line]) -> Result<(), String> {
    match nothing_found(lines.iter().map(|line| &line.found)) {
        None => Ok(()),
        Some(reason) if lines.len() == 1 => Err(reason.into()),
        Some(first) => Err(format!(
            "none of the {} motions is read; the first: {first}",
            lines.len()
        )),
    }
}
