//! `pounding merge`: the shards of a sweep joined to one table.

use std::path::PathBuf;

use pounding::sweep::{Parts, merge};

use super::Failure;
use super::sweep::of_table;
use crate::new_file;

const EXAMPLES: &str = "\
Examples:
  pounding merge runs.csv
  pounding merge runs.csv node1/runs.csv.parts node2/runs.csv.parts
  pounding merge runs.csv.zst runs.csv.parts

The parts of all shards must be there, in one folder or in several; what is
missing is named. The table has the bytes of a sweep that ran without shards.
The parts stay: delete them when the table is what was wanted.";

/// The arguments of `merge`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The table: CSV, compressed if the name ends in .zst.
    #[arg(value_name = "OUT")]
    out: PathBuf,
    /// Folders of parts, as shards leave them; by default OUT.parts.
    #[arg(value_name = "PARTS")]
    folders: Vec<PathBuf>,
    /// Replace a table that exists.
    #[arg(long)]
    overwrite: bool,
}

/// Joins the parts of a sweep.
pub(crate) fn run(args: &Arguments) -> Result<String, Failure> {
    let out = &args.out;
    new_file::check(out, &[], args.overwrite)?;
    let folders = if args.folders.is_empty() {
        vec![Parts::folder_of(out)]
    } else {
        args.folders.clone()
    };
    let joined = merge(out, &folders, new_file::existing(args.overwrite));
    let joined = joined?;
    new_file::say_if_unlocked(joined.is_locked);
    of_table(Vec::new(), &joined, out)
}
