//! `pounding export`: a scene as a script for another program, so that anyone can check this one.

mod material;
mod opensees;

use std::path::PathBuf;

use pounding::scene::{Contact, Error, Method, RunResult, Scene, Simulation, Structure};
use pounding::solver::Collision;

use super::positive;
use crate::new_file;
use crate::progress::Waiting;
use material::Material;

const EXAMPLES: &str = "\
Examples:
  pounding export --opensees scene.toml --out check.py
  pip install openseespy
  python3 check.py           # OpenSees beside the exact numbers
  python3 check.py 1e-5      # the same with another time step

The script holds the row, the processed ground motion and the numbers of the
exact method. OpenSees steps by Newmark's method of average acceleration, and
its differences fall with the time step. Contact laws with an equal in
OpenSees: linear_spring, hertz, nonlinear_viscoelastic, hertz_damp and
modified_kelvin; the last two are not clamped there where something drives the
neighbours apart faster than they met.";

/// What is asked of `export`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Write a script for OpenSeesPy.
    #[arg(long, required = true)]
    opensees: bool,
    /// The file to write; without it the script is printed.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Write over a file that is there already.
    #[arg(long, requires = "out")]
    overwrite: bool,
    /// Time step of OpenSees [s]; without it a fine one.
    #[arg(long, value_name = "DT", allow_negative_numbers = true, value_parser = positive)]
    time_step: Option<f64>,
    /// Take a material that pulls for Kelvin–Voigt contacts.
    #[arg(long)]
    approximate: bool,
}

/// Writes the script, or returns it.
pub(crate) fn run(args: &Arguments) -> Result<String, String> {
    let path = &args.scene;
    let message = |error: Error| error.in_file(path).to_string();
    let mut scene: Scene = super::read(path).map_err(message)?;
    // The method of the scene does not matter: the script steps by its own.
    scene.method = Method::EXACT;
    one_storey(&scene).map_err(|what| format!("{}: {what}", path.display()))?;
    let materials = materials(&scene, args)?;
    let _waiting = Waiting::new("running the exact method");
    let prepared = Simulation::new(&scene, super::folder(path)).map_err(message)?;
    let exact = prepared.run(None).map_err(message)?;
    let script = opensees::script(&opensees::Contents {
        prepared: &prepared,
        materials,
        exact: &exact,
        time_step: args
            .time_step
            .unwrap_or_else(|| time_step(&prepared, &exact)),
    });
    let Some(out) = &args.out else {
        return Ok(script);
    };
    new_file::check(out, &super::inputs(path, &prepared), args.overwrite)?;
    new_file::write(out, script.as_bytes(), args.overwrite)?;
    let out = out.display();
    Ok(format!(
        "wrote {out}\n\nnext:\n  pip install openseespy\n  python3 {out}\n"
    ))
}

/// Refuses what the script does not model.
fn one_storey(scene: &Scene) -> Result<(), String> {
    if scene.arrivals_s.is_some() {
        return Err(
            "arrivals_s: found a ground motion that travels along the row, which the script does not model; allowed is one \
             that shakes all structures at once: leave the field out"
                .into(),
        );
    }
    for (index, structure) in scene.structures.iter().enumerate() {
        let found = match structure {
            Structure::Building(_) => "a building of several storeys",
            Structure::Sdof(sdof) if sdof.bouc_wen.is_some() => "columns that yield smoothly",
            Structure::Sdof(sdof) if sdof.hardening_ratio.is_some() => "columns that harden",
            Structure::Sdof(_) | Structure::Wall => continue,
        };
        return Err(format!(
            "structures[{index}]: found {found}, which the script does not model; allowed are elastic and perfectly plastic \
             structures of one storey"
        ));
    }
    Ok(())
}

/// The material of every contact of a scene.
fn materials(scene: &Scene, args: &Arguments) -> Result<Vec<Material>, String> {
    let mass = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => Some(sdof.mass_kg),
        Structure::Building(_) | Structure::Wall => None,
    };
    let contacts = scene.contacts.iter().flatten().enumerate();
    let material = |(index, contact): (usize, &Contact)| {
        let pair = scene.structures.get(index..index + 2).unwrap_or_default();
        let inverse: f64 = pair.iter().filter_map(mass).map(f64::recip).sum();
        Material::of(contact, inverse.recip(), args.approximate).map_err(|allowed| {
            format!(
                "{}: contacts[{index}].law: found {}, {allowed}",
                args.scene.display(),
                contact.law.name()
            )
        })
    };
    contacts.map(material).collect()
}

/// Time steps that are chosen \[s\]: in the last 20 s are two million steps, a minute or two.
const TIME_STEPS: [f64; 7] = [1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5];
/// Steps in the shortest period, and in the hardest touch.
const STEPS: f64 = 200.0;

/// A time step \[s\] that follows the shortest period and the hardest touch.
fn time_step(prepared: &Simulation, exact: &RunResult) -> f64 {
    let structures = prepared.scene().structures.iter();
    let shortest = structures.filter_map(Structure::period);
    let force = |one: &Collision| one.peak_force.unwrap_or(0.0);
    let collisions = exact.collisions.all().iter();
    let hardest = collisions.max_by(|a, b| force(a).total_cmp(&force(b)));
    let touch = hardest.map(|one| one.end - one.start);
    let wanted = shortest.chain(touch).fold(f64::INFINITY, f64::min) / STEPS;
    let fits = TIME_STEPS.into_iter().find(|step| *step <= wanted);
    fits.unwrap_or(TIME_STEPS[TIME_STEPS.len() - 1])
}
