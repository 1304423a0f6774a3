//! Structures of a row, as files give them.

use pounding_text::{Refused, plain};
use std::f64::consts::PI;

use pounding_solver::{Mode, Oscillation};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::json;

use super::Building;
use super::choice::{self, Choice, also};
use super::columns::{BoucWen, Capacities, Columns, ColumnsFile, positive};
use crate::Damping;

/// A structure or a wall of a row.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(transform = or_empty_wall)]
#[expect(clippy::large_enum_variant, reason = "a row has few structures")]
pub enum Structure {
    /// A structure of one storey (single degree of freedom).
    Sdof(Sdof),
    /// A building of one or more storeys.
    Building(Building),
    /// A fixed wall; it moves with the ground. Beside a building it faces every floor.
    Wall,
}

/// A wall is a word, or an empty table: in TOML a list may hold only tables.
fn or_empty_wall(schema: &mut schemars::Schema) {
    let nothing = json!({"type": "object", "additionalProperties": false});
    let table = json!({
        "description": "A fixed wall; it moves with the ground.",
        "type": "object",
        "properties": {"wall": nothing},
        "additionalProperties": false,
        "required": ["wall"],
    });
    also(schema, table);
}

/// A structure or a wall as files give it.
#[derive(Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[expect(clippy::large_enum_variant, reason = "it is read once")]
pub(super) enum NamedStructure {
    Sdof(Sdof),
    Building(Building),
    Wall {},
}

impl Choice for NamedStructure {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"sdof": {"name": "tower", "mass_kg": 3e5, "period_s": 0.8, "damping": {"ratio": 0.05}}}"#,
        r#"{"building": {"name": "tower", "damping": {"ratio": 0.05}, "period_s": 0.8, "storeys": [{"mass_kg": 1e5, "repeat": 3}]}}"#,
    ];
}

impl<'de> Deserialize<'de> for Structure {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        choice::one(from).map(|named| match named {
            NamedStructure::Sdof(sdof) => Self::Sdof(sdof),
            NamedStructure::Building(building) => Self::Building(building),
            NamedStructure::Wall {} => Self::Wall,
        })
    }
}

impl Structure {
    /// Name for tables and figures.
    pub fn name(&self) -> &str {
        match self {
            Self::Sdof(structure) => &structure.name,
            Self::Building(building) => &building.name,
            Self::Wall => "wall",
        }
    }

    /// Fastest free oscillation, which a time step must follow; `None` for a wall.
    pub fn fastest(&self) -> Option<Oscillation> {
        match self {
            Self::Sdof(structure) => Some(structure.oscillation()),
            Self::Building(building) => building.modes().last().map(Mode::oscillation),
            Self::Wall => None,
        }
    }

    /// Damping ratio ζ \[–\] of the elastic structure; for a building that of the first mode, for a wall `None`.
    pub fn damping_ratio(&self) -> Option<f64> {
        match self {
            Self::Sdof(structure) => Some(structure.damping_ratio()),
            Self::Building(building) => building.modes().first().map(|mode| mode.damping_ratio),
            Self::Wall => None,
        }
    }

    /// Yield force of every storey \[N\], from the ground up; `None` for columns that stay elastic. A wall has no storeys.
    pub fn yield_forces(&self) -> Vec<Option<f64>> {
        match self {
            Self::Sdof(structure) => vec![structure.yield_force_n],
            Self::Building(building) => {
                let storeys = building.storeys.iter();
                storeys.map(|storey| storey.columns.yield_force_n).collect()
            }
            Self::Wall => Vec::new(),
        }
    }

    /// Longest period that counts when records are compared with a spectrum \[s\]: the natural period, or that of a rigid building on
    /// isolators by their stiffness after yielding. `None` for a wall.
    pub fn longest_period(&self) -> Option<f64> {
        match self {
            Self::Sdof(_) | Self::Wall => self.period(),
            Self::Building(building) => building.longest_period(),
        }
    }

    /// Natural period \[s\]; for a building that of the first mode, for a wall `None`.
    pub fn period(&self) -> Option<f64> {
        match self {
            Self::Sdof(structure) => Some(structure.period()),
            Self::Building(building) => building.modes().first().map(Mode::period),
            Self::Wall => None,
        }
    }
}

/// A structure of one storey.
///
/// A file may give the period instead of the stiffness, and the yield displacement or drift ratio instead of the yield
/// force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "SdofFile")]
#[schemars(with = "SdofFile")]
pub struct Sdof {
    /// Name for tables and figures.
    pub name: String,
    /// Mass m \[kg\], > 0.
    pub mass_kg: f64,
    /// Elastic stiffness k \[N/m\], > 0.
    pub stiffness_n_per_m: f64,
    /// Viscous damping. It does not change if the columns yield.
    pub damping: Damping,
    /// Yield force \[N\], > 0; absent for elastic columns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub yield_force_n: Option<f64>,
    /// Ratio of the stiffness after yielding to the stiffness before \[–\], 0 ≤ a < 1; absent for perfectly plastic and for elastic
    /// columns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardening_ratio: Option<f64>,
    /// Smooth yielding; absent if columns yield at one point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bouc_wen: Option<BoucWen>,
    /// Height of the mass above the ground \[m\], > 0. Drift ratios need it. Beside a building it decides which floors face each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height_m: Option<f64>,
    /// What the scene says of the limits of the structure.
    #[serde(flatten)]
    pub capacities: Capacities,
    /// Displacement at t = 0 \[m\].
    #[serde(skip_serializing_if = "super::is_zero")]
    pub initial_displacement_m: f64,
    /// Velocity at t = 0 \[m/s\].
    #[serde(skip_serializing_if = "super::is_zero")]
    pub initial_velocity_m_per_s: f64,
}

/// A structure of one storey as files give it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
pub struct SdofFile {
    /// Name for tables and figures.
    name: String,
    /// Mass \[kg\], > 0.
    pub(super) mass_kg: f64,
    /// Elastic stiffness \[N/m\], > 0; or `period_s`.
    pub(super) stiffness_n_per_m: Option<f64>,
    /// Natural period \[s\], > 0; or `stiffness_n_per_m`.
    pub(super) period_s: Option<f64>,
    /// Viscous damping.
    #[serde(deserialize_with = "choice::one")]
    pub(super) damping: Damping,
    /// Yield force \[N\], > 0. Columns without yield force, yield displacement and yield drift ratio stay elastic.
    pub(super) yield_force_n: Option<f64>,
    /// Displacement at which the columns yield \[m\], > 0.
    pub(super) yield_displacement_m: Option<f64>,
    /// Displacement at which the columns yield over `height_m` \[–\], > 0.
    pub(super) yield_drift_ratio: Option<f64>,
    /// Ratio of the stiffness after yielding to the stiffness before \[–\], 0 to less than 1; 0 by default.
    pub(super) hardening_ratio: Option<f64>,
    /// Smooth yielding; by default columns yield at one point.
    bouc_wen: Option<BoucWen>,
    /// Height of the mass above the ground \[m\], > 0. Drift ratios need it. Beside a building it decides which floors face each other.
    pub(super) height_m: Option<f64>,
    /// Whether the structure stands on isolators, which have no limits of columns.
    isolation_layer: Option<bool>,
    /// Displacement over `height_m` that the columns bear \[–\], > 0; by default that of ductile construction, 0.025 and a ductility of 6.
    drift_capacity_ratio: Option<f64>,
    /// Shear force that the columns bear \[N\], > 0; by default it is not judged.
    shear_capacity_n: Option<f64>,
    /// Shear force that one column bears \[N\], > 0, when a slab of the neighbour hits it; by default it is not judged.
    column_capacity_n: Option<f64>,
    /// Number of equal columns, ≥ 1: the bending of the one that a slab hits stands in series with a linear contact. By default columns do
    /// not bend there.
    columns: Option<u32>,
    /// Weight on the floor that acts on the leaning storeys below (P-Δ) \[N\], ≥ 0; by default none.
    gravity_load_n: Option<f64>,
    /// Depth of the slab below the height of its floor \[m\], ≥ 0: slabs whose depths overlap meet as floors. By default only floors at one
    /// height do.
    slab_depth_m: Option<f64>,
    /// Displacement at t = 0 \[m\].
    #[serde(default)]
    pub(super) initial_displacement_m: f64,
    /// Velocity at t = 0 \[m/s\].
    #[serde(default)]
    pub(super) initial_velocity_m_per_s: f64,
}

/// Sets a number of a structure of one storey, as files give it.
pub type SetNumber = fn(&mut SdofFile, f64);

impl TryFrom<SdofFile> for Sdof {
    type Error = Refused;

    fn try_from(mut words: SdofFile) -> Result<Self, Refused> {
        let columns = words.columns()?;
        let name = std::mem::take(&mut words.name);
        Ok(words.sdof(name, columns))
    }
}

impl SdofFile {
    /// Returns a function that sets the field with this name, counted from the structure; `None` if the field is not a single number.
    pub fn setter(field: &str) -> Option<SetNumber> {
        Some(match field {
            "mass_kg" => |words, number| words.mass_kg = number,
            "stiffness_n_per_m" => |words, number| words.stiffness_n_per_m = Some(number),
            "period_s" => |words, number| words.period_s = Some(number),
            "damping.ratio" => |words, number| words.damping = Damping::Ratio(number),
            "yield_force_n" => |words, number| words.yield_force_n = Some(number),
            "yield_displacement_m" => |words, number| words.yield_displacement_m = Some(number),
            "yield_drift_ratio" => |words, number| words.yield_drift_ratio = Some(number),
            "hardening_ratio" => |words, number| words.hardening_ratio = Some(number),
            "height_m" => |words, number| words.height_m = Some(number),
            "initial_displacement_m" => |words, number| words.initial_displacement_m = number,
            "initial_velocity_m_per_s" => |words, number| words.initial_velocity_m_per_s = number,
            _ => return None,
        })
    }

    /// Gives a structure these numbers, and keeps its name; `None` if they are refused, as when a file is read.
    pub fn renumber(&self, structure: &mut Sdof) -> Option<()> {
        let columns = self.columns().ok()?;
        let name = std::mem::take(&mut structure.name);
        *structure = self.sdof(name, columns);
        Some(())
    }

    fn sdof(&self, name: String, columns: Columns) -> Sdof {
        Sdof {
            name,
            mass_kg: self.mass_kg,
            stiffness_n_per_m: columns.stiffness_n_per_m,
            damping: self.damping,
            yield_force_n: columns.yield_force_n,
            hardening_ratio: columns.hardening_ratio,
            bouc_wen: columns.bouc_wen,
            height_m: self.height_m,
            capacities: Capacities {
                isolation_layer: self.isolation_layer,
                drift_capacity_ratio: self.drift_capacity_ratio,
                shear_capacity_n: self.shear_capacity_n,
                column_capacity_n: self.column_capacity_n,
                columns: self.columns,
                slab_depth_m: self.slab_depth_m,
                gravity_load_n: self.gravity_load_n,
                isolator_damping_n_s_per_m: None,
                displacement_capacity_m: None,
            },
            initial_displacement_m: self.initial_displacement_m,
            initial_velocity_m_per_s: self.initial_velocity_m_per_s,
        }
    }

    fn columns(&self) -> Result<Columns, Refused> {
        let columns = ColumnsFile {
            yield_force_n: self.yield_force_n,
            yield_displacement_m: self.yield_displacement_m,
            yield_drift_ratio: self.yield_drift_ratio,
            hardening_ratio: self.hardening_ratio,
            bouc_wen: self.bouc_wen,
            friction_n: None,
            height_m: self.height_m,
        };
        columns.columns(self.stiffness()?)
    }

    fn stiffness(&self) -> Result<f64, Refused> {
        match (self.stiffness_n_per_m, self.period_s) {
            (None, None) => Err(Refused::default()
                .found("neither `stiffness_n_per_m` nor `period_s`")
                .allowed_is("one of them")
                .help("add the one that is known")),
            (Some(_), Some(_)) => Err(Refused::default()
                .found("both `stiffness_n_per_m` and `period_s`")
                .allowed_is("one of them")
                .help("delete the other")),
            (Some(stiffness), None) => Ok(stiffness),
            (None, Some(period)) => {
                let omega = 2.0 * PI / positive("period_s", period)?;
                let stiffness = positive("mass_kg", self.mass_kg)? * omega * omega;
                if stiffness > 0.0 && stiffness.is_finite() {
                    Ok(stiffness)
                } else {
                    let [period, stiffness] = [period, stiffness].map(plain);
                    let found = format!("{period}, with which the stiffness is {stiffness} N/m");
                    let far = Refused::at("period_s").found(found);
                    Err(far.allowed_is("a period whose stiffness is a finite number > 0"))
                }
            }
        }
    }
}

impl Sdof {
    /// Columns of the structure.
    pub fn columns(&self) -> Columns {
        Columns {
            stiffness_n_per_m: self.stiffness_n_per_m,
            yield_force_n: self.yield_force_n,
            hardening_ratio: self.hardening_ratio,
            bouc_wen: self.bouc_wen,
            friction_n: None,
        }
    }

    /// Damping coefficient c \[N·s/m\].
    pub fn damping_coefficient(&self) -> f64 {
        self.damping.to_solver().coefficient(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Damping ratio ζ \[–\] of the elastic structure.
    pub fn damping_ratio(&self) -> f64 {
        self.damping.to_solver().ratio(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Ductility demand |u|/`u_y` \[–\] of a displacement \[m\]; `None` for columns that stay elastic.
    pub fn ductility(&self, displacement: f64) -> Option<f64> {
        self.yield_force_n.map(|force| displacement.abs() * self.stiffness_n_per_m / force)
    }

    /// Free oscillation of the structure.
    pub fn oscillation(&self) -> Oscillation {
        Oscillation {
            angular_frequency: (self.stiffness_n_per_m / self.mass_kg).sqrt(),
            damping_ratio: self.damping_ratio(),
        }
    }

    /// Natural period T = 2π√(m/k) \[s\].
    pub fn period(&self) -> f64 {
        2.0 * PI * (self.mass_kg / self.stiffness_n_per_m).sqrt()
    }
}
