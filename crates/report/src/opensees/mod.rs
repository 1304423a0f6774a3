//! A scene as a script for OpenSeesPy, so that anyone can compare both programs.

mod link;
mod material;
mod row;
mod script;

use pounding_scene::{Error, FloorPair, RunResult, Simulation, Structure};
use pounding_solver::{Collision, Pair};

use material::Material;
use row::ScriptRow;

/// How a scene becomes a script.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct OpenSees {
    /// Time step of OpenSees \[s\]; by default a fine one.
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
    /// Names the field that the script does not model, or gives the failure of the exact run.
    pub fn script(self, prepared: &Simulation) -> Result<String, OpenSeesError> {
        let damped = prepared.scene().structures.iter().position(Structure::has_tangent_damping);
        if let Some(index) = damped {
            return Err(OpenSeesError::NotModelled(format!(
                "structures[{index}]: found damping on the tangent stiffness, allowed is the initial one: the script has a dashpot in every storey"
            )));
        }
        let mut floors = prepared.floors().all().iter();
        if let Some(floor) = floors.find(|floor| floor.made_of.is_some_and(|made| made.columns.friction_n.is_some())) {
            return Err(OpenSeesError::NotModelled(format!(
                "structures[{}]: found isolators with yield_displacement_m = 0, allowed is a number > 0: no material of the script sticks",
                floor.structure
            )));
        }
        let row = ScriptRow::of(prepared);
        let materials = materials(prepared, &row, self.approximate).map_err(OpenSeesError::NotModelled)?;
        let prepared = &prepared.exact().map_err(OpenSeesError::Run)?;
        let exact = &prepared.run(None).map_err(OpenSeesError::Run)?;
        let steps = || time_step(prepared, exact);
        Ok(script::script(&script::Contents {
            prepared,
            row,
            materials,
            exact,
            time_step: self.time_step.unwrap_or_else(steps),
        }))
    }
}

/// The material of every pair.
fn materials(prepared: &Simulation, row: &ScriptRow, approximate: bool) -> Result<Vec<Material>, String> {
    let facing = prepared.floors().facing();
    let material = |(pair, facing): (&Pair, &FloorPair)| {
        if facing.column.is_some() {
            let place = format!("contacts[{}]", facing.contact);
            return Err(format!(
                "{place}: found a slab beside a column, allowed are floors that meet floors (levels): an element of the script joins two nodes"
            ));
        }
        let sides = [pair.left(), pair.right()].map(|side| row.floors[side].as_ref());
        let inverse: f64 = sides.into_iter().flatten().map(|one| one.mass.recip()).sum();
        Material::of(pair, inverse.recip(), approximate).map_err(|allowed| {
            let law = pair.law.name();
            format!("contacts[{}].law: found {law}, {allowed}", facing.contact)
        })
    };
    prepared.pairs().iter().zip(facing).map(material).collect()
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
