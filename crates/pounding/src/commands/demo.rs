//! `pounding demo`: a scene, its record and its results, with nothing needed.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use pounding::files::holds;
use pounding::report::{Report, other_direction};
use pounding::text::{Form, Refused, Where};

use crate::folder::Out;
use crate::new_file;
use crate::progress::Waiting;

const EXAMPLES: &str = "\
Example:
  pounding demo

Writes pounding-demo/scene.toml, its record and pounding-demo/results, and ends
with the table of the run; open pounding-demo/results/report.html.";

/// Files of the folder besides the results.
const FILES: [(&str, &str); 2] = [
    (SCENE, include_str!("demo/scene.toml")),
    ("el-centro.csv", include_str!("../../assets/el-centro-1940-ns-chopra.csv")),
];
const SCENE: &str = "scene.toml";

/// The scene and its record.
pub(super) fn files() -> (&'static str, &'static str) {
    (FILES[0].1, FILES[1].1)
}

/// The arguments of `demo`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The folder to write.
    #[arg(value_name = "FOLDER", default_value = "pounding-demo")]
    folder: PathBuf,
}

/// Writes and runs the scene; returns the summary.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let top = &args.folder;
    let results = top.join("results");
    let out = Out::open(&results, false)?;
    for (name, text) in FILES {
        write(&top.join(name), text)?;
    }
    let path = top.join(SCENE);
    let message = |error: pounding::scene::Error| Refused::from(error.in_file(&path));
    let prepared = super::prepare(&path, false).map_err(message)?;
    let _waiting = Waiting::new("running and drawing");
    let report = Report::of(&prepared, true).map_err(message)?;
    let other = other_direction(&prepared);
    let report = report.with_other_direction(other);
    out.write(&report.files())?;
    let next = format!("change {0} and run it again:", path.display());
    let again = format!("pounding run {} --out {}", path.display(), results.display());
    let answer = report
        .answer()
        .say(Where::Terminal, "Results", vec![results.join("report.html").display().to_string()])
        .say(Where::Terminal, "Next", vec![next, again]);
    Ok(answer.text(Form::Brief))
}

/// Writes a file; leaves one with this text, and refuses one with another.
fn write(path: &Path, text: &str) -> Result<(), Refused> {
    match holds(path, text.as_bytes()) {
        Ok(true) => Ok(()),
        Ok(false) => {
            let other = Refused::at(path).found("another file").allowed_is("none or that of the demo");
            Err(other.help("name another folder: pounding demo FOLDER"))
        }
        Err(error) if error.kind() == ErrorKind::NotFound => new_file::write(path, text.as_bytes(), false),
        Err(error) => Err(Refused::unreadable(path, &error)),
    }
}
