//! `pounding schema`: the form of a scene or sweep file, for editors.

use pounding::scene::file;
use pounding::sweep::sweep_schema;

const EXAMPLES: &str = "\
Examples:
  pounding schema > scene.schema.json
  pounding schema --sweep > sweep.schema.json

Most editors complete and check a TOML scene that begins with
  #:schema scene.schema.json
and a JSON scene by a setting of their own.";

/// The arguments of `schema`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Of a sweep instead of a scene.
    #[arg(long)]
    sweep: bool,
}

/// The JSON Schema.
pub(crate) fn run(args: &Arguments) -> String {
    if args.sweep { sweep_schema() } else { file::schema() }
}
