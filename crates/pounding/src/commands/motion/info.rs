//! `pounding motion info`: what record files hold, where it stands, and how strong the motion is.

mod printed;

use std::path::PathBuf;
use std::sync::Arc;

use pounding::motion::{Channel, Direction, Drift, Measures, NamedFile, contents};
use pounding::scene::{Reason, record_bytes, whether_it_shakes};
use rayon::prelude::*;

use super::source::{Declared, Named, Opened, files};
use crate::commands::Failure;
use crate::commands::suite::nothing_found;
use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  pounding motion info quake.AT2
  pounding motion info records                  # every file of a folder
  pounding motion info station.v2 --component \"90 deg\"
  pounding motion info list.txt --unit cm_per_s2 --time-step 0.005
  pounding motion info records --csv > measures.csv

Of several files, what is declared holds for those that do not say it. The
exit code is 1 where a file that is named here, and not only found in a folder,
is refused. Measures are exact for an acceleration that is linear between
samples, and no baseline is corrected: a drift of the ground is pointed out.";

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
    file: Named,
    /// Its name, where the file holds several or one is asked for.
    component: Option<String>,
    found: Result<Found, String>,
}

/// A motion and its measures.
struct Found {
    opened: Opened,
    /// How it lies, or why it shakes no row.
    placed: Result<Option<Direction>, Reason>,
    measures: Measures,
    drift: Option<Drift>,
}

/// What the files hold.
pub(super) fn run(args: &Arguments) -> Result<String, Failure> {
    let files = files(&args.files)?;
    let strict = files.len() == 1;
    let motions: Vec<_> = files
        .iter()
        .flat_map(|file| motions(file, &args.declared))
        .collect();
    let progress = Progress::new();
    let line = |listed: &Listed| {
        let Listed {
            file, component, ..
        } = listed;
        let declared = args.declared.of_component(component.clone());
        let opened = if strict {
            declared.open(&file.path)
        } else {
            declared.open_one_of_several(&file.path)
        };
        progress.step(motions.len());
        let spelt = opened.as_ref().ok().and_then(Opened::component);
        Line {
            file: file.clone(),
            // What is asked for may be a part of the name.
            component: component.clone().map(|args| spelt.unwrap_or(args)),
            found: opened.map(|opened| Found {
                placed: listed.placed(&opened),
                measures: opened.record.measures(),
                drift: opened.record.drift(),
                opened,
            }),
        }
    };
    let lines: Vec<Line> = motions.par_iter().map(line).collect();
    drop(progress);
    all_refused(&lines)?;
    let printed = if args.json {
        printed::json_of(&lines, args.declared.gravity)
    } else if args.csv {
        printed::csv_of(&lines, args.declared.gravity)
    } else {
        printed::text(&lines, args.declared.gravity)
    };
    match named_refused(&lines) {
        None => Ok(printed),
        Some(message) => Err(Failure { printed, message }),
    }
}

/// A motion of a file.
struct Listed {
    file: Named,
    /// Its component, if the file holds several or one is asked for.
    component: Option<String>,
    /// All components; empty if the file is refused.
    channels: Arc<Vec<Channel>>,
}

impl Listed {
    /// How it lies, or why it shakes no row.
    fn placed(&self, opened: &Opened) -> Result<Option<Direction>, Reason> {
        let name = opened.component();
        let own = self.channels.iter().find(|channel| channel.name == name);
        let named = NamedFile::of(self.file.path.file_name().unwrap_or_default());
        own.map_or(Ok(None), |channel| {
            whether_it_shakes(channel, &named, self.channels.len() > 1)
        })
    }
}

/// The motions of a file: one, or each component, or the one that is asked for.
fn motions(file: &Named, declared: &Declared) -> Vec<Listed> {
    let found = record_bytes(&file.path).ok();
    let found = found.and_then(|bytes| contents(&bytes).ok());
    let channels = Arc::new(found.map_or_else(Vec::new, |found| found.channels));
    let components = match &declared.component {
        Some(args) => vec![Some(args.clone())],
        None if channels.len() > 1 => channels.iter().map(|one| one.name.clone()).collect(),
        None => vec![None],
    };
    let listed = |component| Listed {
        file: file.clone(),
        component,
        channels: Arc::clone(&channels),
    };
    components.into_iter().map(listed).collect()
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

/// What is said of files that were named and are refused; a folder may hold other files than records.
fn named_refused(lines: &[Line]) -> Option<String> {
    let refused = lines.iter().filter(|line| !line.file.in_folder);
    let mut reasons = refused.filter_map(|line| line.found.as_ref().err());
    let first = reasons.next()?;
    Some(match reasons.count() {
        0 => first.clone(),
        others => format!(
            "{} of the motions named are refused; the first: {first}",
            others + 1
        ),
    })
}
