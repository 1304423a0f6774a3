//! `pounding init`: a scene to begin with, with a comment on every line.

use std::path::{Path, PathBuf};

use crate::new_file;

const EXAMPLES: &str = "\
Examples:
  pounding init                                   # writes scene.toml
  pounding init towers.toml --record quake.AT2    # shaken by a record of yours
  pounding run towers.toml";

/// The scene that is written; `RECORD` stands for its ground motion.
const TEMPLATE: &str = include_str!("init/scene.toml");

/// A ground motion without a file, so that the scene runs at once.
const GENERATED: &str = r#"# A motion from a formula; with a record of yours instead:
#   file = "quake.AT2"     # PEER, CSMIP, COSMOS, SMC, K-NET, ESM, GeoNet, SAC, miniSEED, columns
#   unit = "g"             # only for files that do not say it themselves
generated.stochastic = { ground = "medium", pga_m_per_s2 = 3.0, strong_from_s = 2.0, strong_until_s = 8.0, decay_per_s = 0.5, duration_s = 20.0, time_step_s = 0.01, seed = 1 }"#;

/// What is asked of `init`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The file to write.
    #[arg(value_name = "SCENE.toml", default_value = "scene.toml")]
    scene: PathBuf,
    /// The record that shakes it, seen from here; without it a motion from a formula.
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Also where the file is there already.
    #[arg(long)]
    overwrite: bool,
}

/// Writes the scene; returns what to do next.
pub(crate) fn answer(asked: &Arguments) -> Result<String, String> {
    let motion = match &asked.record {
        None => GENERATED.to_string(),
        Some(record) => of_file(record, &asked.scene)?,
    };
    let text = TEMPLATE.replace("RECORD", &motion);
    let path = asked.scene.display();
    new_file::write(&asked.scene, text.as_bytes(), asked.overwrite)?;
    Ok(format!(
        "wrote {path}\n\nnext:\n  pounding check {path}\n  pounding run {path} --out results\n"
    ))
}

/// The lines of a record, named from the folder of the scene.
fn of_file(record: &Path, scene: &Path) -> Result<String, String> {
    let found = std::fs::metadata(record)
        .map_err(|error| format!("--record {}: cannot be read: {error}", record.display()))?;
    if !found.is_file() {
        return Err(format!(
            "--record {}: found a folder, allowed is a file; `pounding run SCENE --records` takes a folder",
            record.display()
        ));
    }
    let beside = super::folder(record) == super::folder(scene);
    let named = match record.file_name() {
        Some(name) if beside => PathBuf::from(name),
        _ => std::path::absolute(record)
            .map_err(|error| format!("--record {}: {error}", record.display()))?,
    };
    // A literal string of TOML, in which a backslash is itself.
    let text = named.to_string_lossy();
    let quoted = if text.contains('\'') {
        format!("{text:?}")
    } else {
        format!("'{text}'")
    };
    Ok(format!(
        "file = {quoted}    # seen from the folder of this file"
    ))
}
