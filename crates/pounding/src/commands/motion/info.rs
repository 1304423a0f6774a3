//! `pounding motion info`: what record files hold, where it stands, and how strong the motion is.

mod printed;

use std::path::{Path, PathBuf};

use pounding::assess::{HorizontalPair, LeftOut, LeftOutReason, Suite, SuiteMotion};
use pounding::motion::{Direction, Drift, Measures};
use pounding::report::MeasuredRecord;
use pounding::scene::{PairValues, pair_spectra};
use pounding::text::{Form, Naming, Refused};
use rayon::prelude::*;

use super::source::{Declared, Opened};
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

/// The arguments of `motion info`.
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
struct ListedMotion {
    path: PathBuf,
    /// Whether the file itself is named, and not only its folder.
    named: bool,
    /// The name of the component, if the file holds several or if one is asked for.
    component: Option<String>,
    found: Result<MeasuredMotion, Refused>,
}

/// A motion and its measures.
struct MeasuredMotion {
    opened: Opened,
    /// The direction of the motion and the number of its event, or why it shakes no row.
    placed: Result<(Option<Direction>, usize), LeftOutReason>,
    measures: Measures,
    drift: Option<Drift>,
}

impl MeasuredMotion {
    /// The record with its measures.
    fn measured(&self) -> MeasuredRecord<'_> {
        MeasuredRecord {
            record: &self.opened.record,
            measures: self.measures,
            drift: self.drift,
        }
    }
}

/// Reads the files; returns what they hold.
pub(super) fn run(args: &Arguments) -> Result<String, Failure> {
    let listed = Suite::listed(&args.files, args.declared.of_folder());
    let (suite, _) = listed?;
    if suite.n_entries == 0 {
        let found = Refused::at(args.files[0].as_path()).found("no file");
        return Err(found.allowed_is("a folder with one record or more").into());
    }
    let motions = motions_of(args, &suite);
    all_refused(&motions)?;
    let pairs = peaks_of_pairs(args, &suite)?;
    let printed = printed::answer(&motions, &suite, &pairs, args.declared.gravity).text(Form::asked(false, args.csv, args.json));
    match named_refused(&motions) {
        None => Ok(printed),
        Some(refused) => Err(Failure { printed, refused }),
    }
}

/// Every motion, whether it shakes rows or not, and every file that holds none, in the order of the files.
fn motions_of(args: &Arguments, suite: &Suite) -> Vec<ListedMotion> {
    let progress = Progress::new();
    let used = suite.motions.iter();
    let used = used.map(|one| (Some(one), Ok((one.direction, one.event)), &*one.path));
    let others = suite.left_out.iter();
    let others = others.map(|one| (one.motion.as_deref(), Err(one), &*one.path));
    let mut all: Vec<_> = used.chain(others).collect();
    let order = |path: &Path| suite.files.iter().position(|file| path.starts_with(file));
    all.sort_by_key(|(.., path)| order(path).unwrap_or(usize::MAX));
    let listed = |(motion, placed, path): &(Option<&SuiteMotion>, Result<_, &LeftOut>, &Path)| {
        let named = args.files.iter().any(|file| file == path);
        let whole = |one: &LeftOut| path.file_name().is_some_and(|name| *name == *one.name);
        let chosen = motion.and_then(SuiteMotion::component).map(String::from);
        let declared = || args.declared.of_component(chosen.clone());
        let opened = match (motion, placed) {
            (None, Err(one)) if !named || !whole(one) => Err(Refused::at(Path::new(&one.name)).is(one.reason.sentence())),
            // Of a single file everything that is declared must be true.
            (Some(_), _) if named && args.files.len() == 1 && !args.declared.has_axis() => declared().open(path),
            (Some(motion), _) => args.declared.use_motion(motion),
            (None, _) if args.files.len() == 1 => args.declared.open(path),
            (None, _) => args.declared.open_one_of_several(path),
        };
        progress.step(all.len());
        // The option may give a part of the name.
        let spelt = opened.as_ref().ok().and_then(Opened::component);
        ListedMotion {
            path: path.to_path_buf(),
            named,
            component: chosen.map(|chosen| spelt.unwrap_or(chosen)),
            found: opened.map(|opened| MeasuredMotion {
                placed: placed.map_err(|one| one.reason.clone()),
                measures: opened.record.measures(),
                drift: opened.record.drift(),
                opened,
            }),
        }
    };
    all.par_iter().map(listed).collect()
}

/// Name of each pair of horizontal components, and its peak ground accelerations.
fn peaks_of_pairs(args: &Arguments, suite: &Suite) -> Result<Vec<(String, PairValues)>, Refused> {
    let peaks = |pair: &HorizontalPair<'_>| {
        let [one, other] = args.declared.use_pair(pair)?;
        let found = pair_spectra([&one, &other], &[0.0], &[0.0], None, &|| ())?;
        Ok((pair.name(), found[0].values[0]))
    };
    suite.pairs().iter().map(peaks).collect()
}

/// Refuses files if none can be read.
fn all_refused(motions: &[ListedMotion]) -> Result<(), Refused> {
    match nothing_found(motions.iter().map(|motion| &motion.found)) {
        None => Ok(()),
        Some(refused) if motions.len() == 1 => Err(refused.clone()),
        Some(first) => {
            let none = format!("none of the {} motions is read; the first: ", motions.len());
            Err(Refused::that(none).and(first).by(Naming::Option))
        }
    }
}

/// Says which files are refused although they were named; a folder may hold files that are no records.
fn named_refused(motions: &[ListedMotion]) -> Option<Refused> {
    let refused = motions.iter().filter(|motion| motion.named);
    let mut reasons = refused.filter_map(|motion| motion.found.as_ref().err());
    let first = reasons.next()?;
    Some(match reasons.count() {
        0 => first.clone(),
        others => {
            let some = format!("{} of the motions named are refused; the first: ", others + 1);
            Refused::that(some).and(first).by(Naming::Option)
        }
    })
}
