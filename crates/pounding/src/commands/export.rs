//! `pounding export`: a scene as a script for another program, so that anyone can check this one.

use std::path::PathBuf;

use pounding::report::{OpenSees, OpenSeesError};
use pounding::scene::{Error, Method, Scene, Simulation};
use pounding::text::{Answer, Form, Part, Refused, Where};

use super::positive;
use crate::new_file;
use crate::progress::Waiting;

const EXAMPLES: &str = "\
Examples:
  pounding export --opensees scene.toml --out check.py
  pip install openseespy
  python3 check.py           # OpenSees beside the exact numbers
  python3 check.py 1e-5      # the same with another time step

The script holds the row with buildings of any number of storeys, the processed
ground motion, which may travel along it, and the numbers of the exact method.
OpenSees steps by Newmark's method of average acceleration, and
its differences fall with the time step. Contact laws with an equal in
OpenSees: linear_spring, hertz, nonlinear_viscoelastic, hertz_damp and
modified_kelvin; the last two are not clamped there where something drives the
neighbours apart faster than they met.";

/// The arguments of `export`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Write a script for OpenSeesPy.
    #[arg(long, required = true)]
    opensees: bool,
    /// The file to write; by default the script is printed.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Replace a file that exists.
    #[arg(long, requires = "out")]
    overwrite: bool,
    /// Time step of OpenSees [s]; by default a fine one.
    #[arg(long, value_name = "DT", allow_negative_numbers = true, value_parser = positive)]
    time_step: Option<f64>,
    /// Take a material that pulls for Kelvin–Voigt contacts.
    #[arg(long)]
    approximate: bool,
}

/// Writes the script, or returns it.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let path = &args.scene;
    let message = |error: Error| Refused::from(error.in_file(path));
    let mut scene: Scene = super::read(path).map_err(message)?;
    // The method of the scene does not matter: the script has another.
    scene.method = Method::EXACT;
    let prepared = Simulation::new(&scene, super::folder(path)).map_err(message)?;
    let waiting = Waiting::new("running the exact method");
    let asked = OpenSees {
        time_step: args.time_step,
        approximate: args.approximate,
    };
    let script = asked.script(&prepared).map_err(|error| match error {
        OpenSeesError::NotModelled(what) => Refused::at(&**path).is(what.clone()),
        OpenSeesError::Run(error) => message(error),
    })?;
    drop(waiting);
    let Some(out) = &args.out else {
        return Ok(script);
    };
    new_file::check(out, &super::inputs(path, &prepared), args.overwrite)?;
    new_file::write(out, script.as_bytes(), args.overwrite)?;
    let out = out.display().to_string();
    let next = format!("next:\n  pip install openseespy\n  python3 {out}\n");
    let answer = Answer::new()
        .say(Where::Terminal, "Wrote", vec![out])
        .part(Where::Terminal, Part::Markup(next));
    Ok(answer.text(Form::Brief))
}
