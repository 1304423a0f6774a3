//! Checks a structure, field by field.

use pounding_text::Refused;
use std::fmt::{self, Display};

use super::{FINITE, NOT_NEGATIVE, POSITIVE, named, require};
use crate::{Building, Capacities, Columns, DampedStiffness, Damping, Method, Scene, Sdof, Structure};

/// A structure, or a storey of it, whose fields have names.
#[derive(Debug, Clone, Copy)]
struct FieldPlace {
    structure: usize,
    /// Key of the structure in a file.
    kind: &'static str,
    storey: Option<usize>,
}

impl FieldPlace {
    fn field(self, name: &str) -> Field<'_> {
        Field { of: self, name }
    }
}

/// A field of a structure.
#[derive(Debug, Clone, Copy)]
struct Field<'a> {
    of: FieldPlace,
    name: &'a str,
}

impl Display for Field<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FieldPlace { structure, kind, storey } = self.of;
        write!(formatter, "structures[{structure}].{kind}.")?;
        if let Some(storey) = storey {
            write!(formatter, "storeys[{storey}].")?;
        }
        formatter.write_str(self.name)
    }
}

const NAME: &str = "a name, by which results tell structures";

/// Refuses the first field of a structure that cannot be modelled.
pub(super) fn check(index: usize, structure: &Structure) -> Result<(), Refused> {
    let place = |kind| FieldPlace {
        structure: index,
        kind,
        storey: None,
    };
    match structure {
        Structure::Sdof(sdof) => check_sdof(sdof, place("sdof")),
        Structure::Building(building) => check_building(building, place("building")),
        Structure::Wall => Ok(()),
    }
}

fn check_sdof(structure: &Sdof, place: FieldPlace) -> Result<(), Refused> {
    named(place.field("name"), &structure.name, NAME)?;
    let (m, columns) = (structure.mass_kg, structure.columns());
    require(m > 0.0, place.field("mass_kg"), m, POSITIVE)?;
    check_stiffness(&columns, place)?;
    if let Damping::Modes { modes, .. } = structure.damping {
        let allowed = "damping of a structure of one storey: a ratio, rayleigh or two_frequencies";
        return require(false, place.field("damping.modes"), number(modes[0]), allowed);
    }
    check_damping(&structure.damping, place)?;
    let found = structure.damping_ratio();
    let allowed = "a damping ratio >= 0 at the structure's own frequency; closer ratios, or frequencies on either \
                   side of it, give one";
    require(found >= 0.0, place.field("damping.two_frequencies"), found, allowed)?;
    check_height(structure.height_m, place)?;
    check_capacities(&structure.capacities, structure.height_m, place)?;
    check_yielding(&columns, place)?;
    check_start(structure.initial_displacement_m, structure.initial_velocity_m_per_s, place)
}

fn check_building(building: &Building, place: FieldPlace) -> Result<(), Refused> {
    named(place.field("name"), &building.name, NAME)?;
    for (index, storey) in building.storeys.iter().enumerate() {
        let place = FieldPlace {
            storey: Some(index),
            ..place
        };
        require(storey.mass_kg > 0.0, place.field("mass_kg"), storey.mass_kg, POSITIVE)?;
        check_stiffness(&storey.columns, place)?;
        check_height(storey.height_m, place)?;
        check_capacities(&storey.capacities, storey.height_m, place)?;
        check_yielding(&storey.columns, place)?;
        check_start(storey.initial_displacement_m, storey.initial_velocity_m_per_s, place)?;
    }
    check_damping(&building.damping, place)?;
    check_damping_above_isolators(building, place)?;
    check_modes(building, place)?;
    let least = |least: f64, (damping, ground): (f64, f64)| least.min(damping).min(ground);
    let found = building.dampings().into_iter().fold(0.0, least);
    let allowed = "damping that takes energy in every storey and floor; closer ratios, or modes or frequencies further apart, \
                   give some";
    require(found >= 0.0, place.field("damping"), found, allowed)
}

/// Refuses damping on the tangent stiffness under a method that does not take it, and of columns whose tangent changes smoothly.
pub(super) fn check_tangent_damping(scene: &Scene) -> Result<(), Refused> {
    for (index, structure) in scene.structures.iter().enumerate() {
        let (kind, damping, bends) = match structure {
            Structure::Sdof(sdof) => ("sdof", sdof.damping, sdof.bouc_wen.is_some()),
            Structure::Building(building) => {
                let bends = building.storeys.iter().any(|one| one.columns.bouc_wen.is_some());
                ("building", building.damping, bends)
            }
            Structure::Wall => continue,
        };
        let method = scene.method;
        let found = match damping.stiffness() {
            DampedStiffness::Tangent if bends => "tangent, beside Bouc–Wen columns, whose tangent never jumps".into(),
            DampedStiffness::Tangent if !method.takes_tangent_damping() => {
                format!("tangent, under the method {}, which keeps its damping", method.name())
            }
            DampedStiffness::Initial | DampedStiffness::Tangent => continue,
        };
        let place = format!("structures[{index}].{kind}.damping.{}.stiffness", damping.name());
        let allowed = Refused::at(place).found(found).allowed("initial");
        return Err(allowed.help("exact, newmark and rk4 take tangent, of columns with one yield point"));
    }
    Ok(())
}

/// Refuses friction that sticks under a method that does not take it.
pub(super) fn check_friction(scene: &Scene) -> Result<(), Refused> {
    let sticks = |structure: &Structure| match structure {
        Structure::Building(building) => building.storeys.iter().any(|one| one.columns.friction_n.is_some()),
        Structure::Sdof(_) | Structure::Wall => false,
    };
    let takes = !matches!(scene.method, Method::Accuracy(_)) && scene.method.integrator().takes_friction();
    match scene.structures.iter().position(sticks) {
        Some(index) if !takes => {
            let place = format!("structures[{index}].building.storeys[0].isolator.friction_pendulum.yield_displacement_m");
            let found = Refused::at(place).found(format!(
                "0, under the method {}, which cannot let isolators stick",
                scene.method.name()
            ));
            Err(found
                .allowed("a number > 0, or the exact method")
                .help("leave `method` out: the exact method is the default"))
        }
        Some(_) | None => Ok(()),
    }
}

const ABOVE_ISOLATORS: &str = "a ratio, or rayleigh with alpha_per_s = 0: the damping of the building above its isolators";

/// Refuses damping that would give isolators dampers that nobody built.
fn check_damping_above_isolators(building: &Building, place: FieldPlace) -> Result<(), Refused> {
    if building.isolator_damping().is_none() {
        return Ok(());
    }
    match building.damping {
        Damping::Ratio(_) => Ok(()),
        Damping::Rayleigh { alpha_per_s, .. } => require(
            alpha_per_s <= 0.0,
            place.field("damping.rayleigh.alpha_per_s"),
            alpha_per_s,
            ABOVE_ISOLATORS,
        ),
        Damping::TwoFrequencies { ratios, .. } => require(false, place.field("damping.two_frequencies"), ratios[0], ABOVE_ISOLATORS),
        Damping::Modes { ratios, .. } => require(false, place.field("damping.modes"), ratios[0], ABOVE_ISOLATORS),
    }
}

/// Refuses modes that the building does not have.
fn check_modes(building: &Building, place: FieldPlace) -> Result<(), Refused> {
    let Damping::Modes { modes, .. } = building.damping else {
        return Ok(());
    };
    let [first, second] = modes;
    let most = building.storeys.len();
    let allowed = "a mode of the building, counted from 1; it has as many as storeys";
    let valid = (1..=most).contains(&first);
    require(valid, place.field("damping.modes.modes[0]"), number(first), allowed)?;
    let allowed = "a mode above the first of the two; a building has as many modes as storeys";
    let valid = (first + 1..=most).contains(&second);
    require(valid, place.field("damping.modes.modes[1]"), number(second), allowed)
}

/// Converts a count for messages.
fn number(count: usize) -> f64 {
    count as f64
}

fn check_stiffness(columns: &Columns, place: FieldPlace) -> Result<(), Refused> {
    let k = columns.stiffness_n_per_m;
    require(k > 0.0, place.field("stiffness_n_per_m"), k, POSITIVE)
}

fn check_height(height: Option<f64>, place: FieldPlace) -> Result<(), Refused> {
    let Some(height) = height else { return Ok(()) };
    require(height > 0.0, place.field("height_m"), height, POSITIVE)
}

fn check_capacities(told: &Capacities, height: Option<f64>, place: FieldPlace) -> Result<(), Refused> {
    if let Some(ratio) = told.drift_capacity_ratio {
        let field = place.field("drift_capacity_ratio");
        require(ratio > 0.0, field, ratio, POSITIVE)?;
        require(
            height.is_some(),
            field,
            ratio,
            "a capacity of a storey with height_m, of which it is a part",
        )?;
    }
    let force = told.shear_capacity_n.unwrap_or(1.0);
    require(force > 0.0, place.field("shear_capacity_n"), force, POSITIVE)?;
    let force = told.column_capacity_n.unwrap_or(1.0);
    require(force > 0.0, place.field("column_capacity_n"), force, POSITIVE)?;
    let viscous = told.isolator_damping_n_s_per_m.unwrap_or(0.0);
    require(viscous >= 0.0, place.field("isolator_damping_n_s_per_m"), viscous, NOT_NEGATIVE)?;
    let capacity = told.displacement_capacity_m.unwrap_or(1.0);
    require(capacity > 0.0, place.field("displacement_capacity_m"), capacity, POSITIVE)?;
    let load = told.gravity_load_n.unwrap_or(0.0);
    require(load >= 0.0, place.field("gravity_load_n"), load, NOT_NEGATIVE)?;
    let depth = told.slab_depth_m.unwrap_or(0.0);
    require(depth >= 0.0, place.field("slab_depth_m"), depth, NOT_NEGATIVE)?;
    let columns = f64::from(told.columns.unwrap_or(1));
    require(columns >= 1.0, place.field("columns"), columns, "a whole number from 1")
}

fn check_yielding(columns: &Columns, place: FieldPlace) -> Result<(), Refused> {
    if let Some(force) = columns.yield_force_n {
        require(force > 0.0, place.field("yield_force_n"), force, POSITIVE)?;
    }
    if let Some(ratio) = columns.hardening_ratio {
        let allowed = "a number >= 0 and < 1";
        let valid = (0.0..1.0).contains(&ratio);
        require(valid, place.field("hardening_ratio"), ratio, allowed)?;
    }
    if let Some(friction) = columns.friction_n {
        require(friction > 0.0, place.field("friction_n"), friction, POSITIVE)?;
    }
    if let Some(smooth) = columns.bouc_wen {
        let valid = (1..=20).contains(&smooth.exponent);
        let found = f64::from(smooth.exponent);
        require(valid, place.field("bouc_wen.exponent"), found, "a whole number from 1 to 20")?;
        let valid = (0.0..=1.0).contains(&smooth.beta);
        require(valid, place.field("bouc_wen.beta"), smooth.beta, "0 to 1")?;
    }
    Ok(())
}

fn check_start(displacement: f64, velocity: f64, place: FieldPlace) -> Result<(), Refused> {
    require(true, place.field("initial_displacement_m"), displacement, FINITE)?;
    require(true, place.field("initial_velocity_m_per_s"), velocity, FINITE)
}

fn check_damping(damping: &Damping, place: FieldPlace) -> Result<(), Refused> {
    let check_ratios = |of: &str, ratios: [f64; 2]| {
        for (index, ratio) in ratios.into_iter().enumerate() {
            let name = format!("damping.{of}.ratios[{index}]");
            require(ratio >= 0.0, place.field(&name), ratio, NOT_NEGATIVE)?;
        }
        Ok(())
    };
    match *damping {
        Damping::Ratio(ratio) => require(ratio >= 0.0, place.field("damping.ratio"), ratio, NOT_NEGATIVE),
        Damping::Rayleigh { alpha_per_s, beta_s, .. } => {
            for (field, found) in [("damping.rayleigh.alpha_per_s", alpha_per_s), ("damping.rayleigh.beta_s", beta_s)] {
                require(found >= 0.0, place.field(field), found, NOT_NEGATIVE)?;
            }
            Ok(())
        }
        Damping::TwoFrequencies {
            frequencies_hz: [first, second],
            ratios,
            ..
        } => {
            let [lower, upper] = [
                "damping.two_frequencies.frequencies_hz[0]",
                "damping.two_frequencies.frequencies_hz[1]",
            ];
            require(first > 0.0, place.field(lower), first, POSITIVE)?;
            let allowed = "a finite number above the first frequency";
            require(second > first, place.field(upper), second, allowed)?;
            check_ratios("two_frequencies", ratios)
        }
        Damping::Modes { ratios, .. } => check_ratios("modes", ratios),
    }
}
