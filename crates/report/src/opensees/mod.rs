//! A scene as a script for OpenSeesPy, so that anyone can check these programs by each other.

mod material;
mod script;

use pounding_scene::{Contact, Error, RunResult, Scene, Simulation, Structure};
use pounding_solver::Collision;

use material::Material;

/// How a scene becomes a script.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct OpenSees {
    /// Time step of OpenSees \[s\]; without it a fine one.
    pub time_step: Option<f64>,
    /// Whether Kelvin–Voigt contacts take a material that pulls.
    pub approximate: bool,
}

/// Why there is no script.
#[derive(Debug)]
pub enum OpenSeesError {
    /// A field that the script does not model, with what is allowed.
    NotModelled(String),
    /// The exact run fails.
    Run(Error),
}

impl OpenSees {
    /// The script: the row, the ground motion as the scene uses it, and the numbers of the exact method, whatever the method of the scene.
    ///
    /// # Errors
    /// Names the field that the script does not model, or says why the exact run fails.
    pub fn script(self, prepared: &Simulation) -> Result<String, OpenSeesError> {
        let scene = prepared.scene();
        one_storey(scene).map_err(OpenSeesError::NotModelled)?;
        let materials = materials(scene, self.approximate).map_err(OpenSeesError::NotModelled)?;
        let prepared = &prepared.exact().map_err(OpenSeesError::Run)?;
        let exact = &prepared.run(None).map_err(OpenSeesError::Run)?;
        let steps = || time_step(prepared, exact);
        Ok(script::script(&script::Contents {
            prepared,
            materials,
            exact,
            time_step: self.time_step.unwrap_or_else(steps),
        }))
    }
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
fn materials(scene: &Scene, approximate: bool) -> Result<Vec<Material>, String> {
    let mass = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => Some(sdof.mass_kg),
        Structure::Building(_) | Structure::Wall => None,
    };
    let contacts = scene.contacts.iter().flatten().enumerate();
    let material = |(index, contact): (usize, &Contact)| {
        let pair = scene.structures.get(index..index + 2).unwrap_or_default();
        let inverse: f64 = pair.iter().filter_map(mass).map(f64::recip).sum();
        Material::of(contact, inverse.recip(), approximate).map_err(|allowed| {
            format!(
                "contacts[{index}].law: found {}, {allowed}",
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
