//! Columns of a storey, as files give them.

use pounding_text::{FaultPlace, Refused, plain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The columns of a storey.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Columns {
    /// Elastic stiffness k \[N/m\], > 0.
    pub stiffness_n_per_m: f64,
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
    /// Friction beside the stiffness, below which the storey does not move \[N\], > 0; only isolators have it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_n: Option<f64>,
}

impl Columns {
    /// Returns columns of a stiffness \[N/m\] that never yield.
    pub fn elastic(stiffness_n_per_m: f64) -> Self {
        Self {
            stiffness_n_per_m,
            yield_force_n: None,
            hardening_ratio: None,
            bouc_wen: None,
            friction_n: None,
        }
    }
}

/// What a scene says of a storey besides its mechanics as a shear building: how results are judged, and what a slab beside its columns meets.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Capacities {
    /// Whether the lowest storey stands for isolators, which have no limits of columns; absent if the scene does not say.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub isolation_layer: Option<bool>,
    /// Drift over the height of the storey that its columns bear \[–\], > 0; replaces the general limits of ductile construction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drift_capacity_ratio: Option<f64>,
    /// Shear force that the columns bear \[N\], > 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shear_capacity_n: Option<f64>,
    /// Shear force that one column bears \[N\], > 0, when a slab of the neighbour hits it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column_capacity_n: Option<f64>,
    /// Number of equal columns of the storey, ≥ 1: the bending of the one that is hit stands in series with a linear contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub columns: Option<u32>,
    /// Viscous damping of the isolators \[N·s/m\], ≥ 0: other damping leaves their storey out. Absent for storeys without isolators' words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub isolator_damping_n_s_per_m: Option<f64>,
    /// Displacement that the isolators bear \[m\], > 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub displacement_capacity_m: Option<f64>,
    /// Weight on the floor that acts on leaning storeys \[N\], ≥ 0: of a storey the sum of those above it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gravity_load_n: Option<f64>,
    /// Depth of the slab \[m\], ≥ 0, below the height of its floor: slabs whose depths overlap meet as floors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub slab_depth_m: Option<f64>,
}

/// Shape of smooth yielding: dz/dd = 1 − |z/`u_y`|ⁿ (γ + β sgn(z ḋ)), γ = 1 − β.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoucWen {
    /// n \[–\], 1 to 20: the larger, the sharper.
    pub exponent: u32,
    /// β \[–\], 0 to 1; 0.5 by default, which unloads along the elastic line.
    #[serde(default = "half")]
    pub beta: f64,
}

fn half() -> f64 {
    0.5
}

/// Yielding of columns in a file.
#[derive(Debug, Clone, Copy)]
pub(super) struct ColumnsFile {
    pub(super) yield_force_n: Option<f64>,
    pub(super) yield_displacement_m: Option<f64>,
    pub(super) yield_drift_ratio: Option<f64>,
    pub(super) hardening_ratio: Option<f64>,
    pub(super) bouc_wen: Option<BoucWen>,
    pub(super) friction_n: Option<f64>,
    pub(super) height_m: Option<f64>,
}

/// Refuses a value that is converted, if it is not > 0: the result would not show which field is wrong.
pub(super) fn positive(field: impl Into<FaultPlace>, found: f64) -> Result<f64, Refused> {
    if found > 0.0 && found.is_finite() {
        Ok(found)
    } else {
        Err(Refused::at(field).found(plain(found)).allowed("a finite number > 0"))
    }
}

fn never_yields(field: &str) -> Refused {
    let found = Refused::default().found(format!("`{field}` of columns that never yield"));
    found.help("give `yield_force_n`, `yield_displacement_m` or `yield_drift_ratio`, or delete it")
}

impl ColumnsFile {
    /// Returns columns of a stiffness \[N/m\].
    pub(super) fn columns(&self, stiffness: f64) -> Result<Columns, Refused> {
        let yield_force = self.yield_force(stiffness)?;
        if self.friction_n.is_some() && yield_force.is_some() {
            let both = Refused::at("friction_n").found("it beside columns that yield");
            return Err(both.allowed_is("one of both").help("friction holds the storey until it slides"));
        }
        if yield_force.is_none() {
            if self.hardening_ratio.is_some() {
                return Err(never_yields("hardening_ratio"));
            }
            if self.bouc_wen.is_some() {
                return Err(never_yields("bouc_wen"));
            }
        }
        Ok(Columns {
            stiffness_n_per_m: stiffness,
            yield_force_n: yield_force,
            hardening_ratio: self.hardening_ratio,
            bouc_wen: self.bouc_wen,
            friction_n: self.friction_n,
        })
    }

    fn yield_force(&self, stiffness: f64) -> Result<Option<f64>, Refused> {
        match (self.yield_force_n, self.yield_displacement_m, self.yield_drift_ratio) {
            (force, None, None) => Ok(force),
            (None, Some(displacement), None) => Ok(Some(stiffness * positive("yield_displacement_m", displacement)?)),
            (None, None, Some(ratio)) => {
                let height = self.height_m.ok_or_else(|| {
                    let alone = Refused::default().found("`yield_drift_ratio` without `height_m`, which it is a part of");
                    alone.help("add the height, or give `yield_displacement_m`")
                })?;
                let height = positive("height_m", height)?;
                let displacement = positive("yield_drift_ratio", ratio)? * height;
                Ok(Some(stiffness * displacement))
            }
            _ => {
                let several = Refused::default().found("several of `yield_force_n`, `yield_displacement_m` and `yield_drift_ratio`");
                Err(several.allowed_is("at most one").help("delete the others"))
            }
        }
    }
}
