//! What a user writes: a row of structures under a record, with its settings.

use pounding_contact::ContactLaw;
use pounding_solver::{
    Damping as SolverDamping, Exact, ImpactRule, Oscillation, SimultaneousImpacts, Start,
    VerletImpacts,
};
use serde::{Deserialize, Serialize};

/// One row of structures under one record, with the method that integrates it.
///
/// Structures stand left to right. Checking happens when the scene is [prepared](crate::Prepared).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Name, unique within its study.
    pub name: String,
    /// The record and how it is used.
    pub record: RecordUse,
    /// Duration of the run \[s\], a whole number of time steps.
    pub duration_s: f64,
    /// The structures and walls, from left to right.
    pub structures: Vec<Structure>,
    /// One contact between each structure and its right neighbour; absent when the structures stand apart.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contacts: Option<Vec<Contact>>,
    /// The method of time integration.
    pub method: Method,
}

impl Scene {
    /// Of every structure and wall the time step \[s\] from which on it grows without bound, though it touch nobody;
    /// nothing for a wall, and for a method without such a limit.
    pub(crate) fn critical_time_steps(&self) -> impl Iterator<Item = Option<f64>> {
        let integrator = self.method.time_step().map(|_| self.method.integrator());
        self.structures
            .iter()
            .map(move |structure| match structure {
                Structure::Sdof(sdof) => integrator?.critical_time_step(&sdof.oscillation()),
                Structure::Wall => None,
            })
    }

    /// The least of them and its structure.
    pub(crate) fn critical_time_step(&self) -> Option<(usize, f64)> {
        let limits = self.critical_time_steps().enumerate();
        limits
            .filter_map(|(index, limit)| Some((index, limit?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

/// A record and how a scene uses it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordUse {
    /// File, relative to the folder of the file that names it.
    pub file: String,
    /// What one g of the file is worth \[m/s²\].
    pub gravity_m_per_s2: f64,
    /// Factor on the ground acceleration \[–\].
    #[serde(default = "one")]
    pub scale: f64,
    /// Whether the shaking is reversed (left becomes right).
    #[serde(default)]
    pub reversed: bool,
}

fn one() -> f64 {
    1.0
}

/// A structure or a wall of a row.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Structure {
    /// A structure of one storey (single degree of freedom).
    Sdof(Sdof),
    /// A fixed wall; it moves with the ground.
    Wall,
}

impl Structure {
    /// Name for tables and figures.
    pub fn name(&self) -> &str {
        match self {
            Self::Sdof(structure) => &structure.name,
            Self::Wall => "wall",
        }
    }
}

/// A structure of one storey.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sdof {
    /// Name for tables and figures.
    pub name: String,
    /// Mass m \[kg\], > 0.
    pub mass_kg: f64,
    /// Elastic stiffness k \[N/m\], > 0.
    pub stiffness_n_per_m: f64,
    /// Viscous damping; it stays that of the elastic structure when the columns yield.
    pub damping: Damping,
    /// Yield force \[N\], > 0; absent for elastic columns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_force_n: Option<f64>,
    /// Displacement at t = 0 \[m\].
    #[serde(default)]
    pub initial_displacement_m: f64,
    /// Velocity at t = 0 \[m/s\].
    #[serde(default)]
    pub initial_velocity_m_per_s: f64,
}

impl Sdof {
    /// Damping coefficient c \[N·s/m\].
    pub fn damping_coefficient(&self) -> f64 {
        self.damping
            .to_solver()
            .coefficient(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Damping ratio ζ \[–\] of the elastic structure.
    pub fn damping_ratio(&self) -> f64 {
        self.damping
            .to_solver()
            .ratio(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Its free oscillation.
    pub fn oscillation(&self) -> Oscillation {
        Oscillation {
            angular_frequency: (self.stiffness_n_per_m / self.mass_kg).sqrt(),
            damping_ratio: self.damping_ratio(),
        }
    }

    /// Natural period T = 2π√(m/k) \[s\].
    pub fn period(&self) -> f64 {
        2.0 * std::f64::consts::PI * (self.mass_kg / self.stiffness_n_per_m).sqrt()
    }
}

/// How the viscous damping of a structure is given.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Damping {
    /// Damping ratio ζ \[–\], ≥ 0.
    Ratio(f64),
    /// Rayleigh damping c = α m + β k.
    Rayleigh {
        /// Mass coefficient α \[1/s\], ≥ 0.
        alpha_per_s: f64,
        /// Stiffness coefficient β \[s\], ≥ 0.
        beta_s: f64,
    },
}

impl Damping {
    fn to_solver(self) -> SolverDamping {
        match self {
            Self::Ratio(ratio) => SolverDamping::Ratio(ratio),
            Self::Rayleigh {
                alpha_per_s,
                beta_s,
            } => SolverDamping::Rayleigh {
                alpha: alpha_per_s,
                beta: beta_s,
            },
        }
    }
}

/// What lies between two neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Gap at rest \[m\], ≥ 0.
    pub gap_m: f64,
    /// The contact law.
    pub law: ContactLaw,
}

/// A method of time integration with its settings.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Method {
    /// Central difference method.
    CentralDifference {
        /// Time step \[s\], > 0.
        time_step_s: f64,
        /// How the first step begins.
        start: Start,
        /// How impulsive contact acts.
        #[serde(default, skip_serializing_if = "is_default")]
        impacts: ImpactRule,
        /// Steps into which a time step is divided for structures that touch, 1 to 1000.
        #[serde(default = "one_step", skip_serializing_if = "is_one_step")]
        contact_substeps: u32,
    },
    /// Newmark's method.
    Newmark {
        /// Time step \[s\], > 0.
        time_step_s: f64,
        /// β \[–\]: 1/4 is average acceleration, 1/6 linear acceleration.
        beta: f64,
        /// γ \[–\]: 1/2 for order two.
        gamma: f64,
    },
    /// HHT-α method.
    Hht {
        /// Time step \[s\], > 0.
        time_step_s: f64,
        /// α \[–\], −1/3 (most damping of what the step cannot follow) to 0 (none).
        alpha: f64,
    },
    /// Velocity Verlet method.
    VelocityVerlet {
        /// Time step \[s\], > 0.
        time_step_s: f64,
        /// When impulsive contact acts.
        #[serde(default, skip_serializing_if = "is_default")]
        impacts: VerletImpacts,
    },
    /// Classical Runge–Kutta method.
    Rk4 {
        /// Time step \[s\], > 0.
        time_step_s: f64,
    },
    /// Moreau–Jean time stepping.
    MoreauJean {
        /// Time step \[s\], > 0.
        time_step_s: f64,
        /// θ \[–\], 1/2 (order two while nothing touches) to 1.
        theta: f64,
    },
    /// Event-driven integration with power series; it has no time step.
    Exact {
        /// Relative size of what a piece in compliant contact leaves out \[–\], 1e-16 to 1e-3.
        #[serde(default = "finest", skip_serializing_if = "is_finest")]
        tolerance: f64,
        /// What happens when several pairs touch at the same instant.
        #[serde(default, skip_serializing_if = "is_default")]
        simultaneous_impacts: SimultaneousImpacts,
    },
    /// The cheapest method that is no further than this from the exact one in anything printed \[–\], > 0 and < 1,
    /// found when the scene is [prepared](crate::Prepared::new).
    Accuracy(f64),
}

fn finest() -> f64 {
    Exact::default().tolerance
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes a reference"
)]
fn is_finest(tolerance: &f64) -> bool {
    *tolerance <= finest()
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

fn one_step() -> u32 {
    1
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes a reference"
)]
fn is_one_step(n: &u32) -> bool {
    *n == one_step()
}

impl Method {
    /// The exact method with its usual settings.
    pub const EXACT: Self = Self::Exact {
        tolerance: 1e-16,
        simultaneous_impacts: SimultaneousImpacts::Together,
    };

    /// Name as scene files spell it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::CentralDifference { .. } => "central_difference",
            Self::Newmark { .. } => "newmark",
            Self::Hht { .. } => "hht",
            Self::VelocityVerlet { .. } => "velocity_verlet",
            Self::Rk4 { .. } => "rk4",
            Self::MoreauJean { .. } => "moreau_jean",
            Self::Exact { .. } => "exact",
            Self::Accuracy(_) => "accuracy",
        }
    }

    /// Time step \[s\]; nothing for the exact method, and for an accuracy whose method is not yet found.
    pub fn time_step(&self) -> Option<f64> {
        match *self {
            Self::CentralDifference { time_step_s, .. }
            | Self::Newmark { time_step_s, .. }
            | Self::Hht { time_step_s, .. }
            | Self::VelocityVerlet { time_step_s, .. }
            | Self::Rk4 { time_step_s }
            | Self::MoreauJean { time_step_s, .. } => Some(time_step_s),
            Self::Exact { .. } | Self::Accuracy(_) => None,
        }
    }

    /// The same method with another time step \[s\]; one that has none stays as it is.
    #[must_use]
    pub(crate) fn with_time_step(mut self, step: f64) -> Self {
        match &mut self {
            Self::CentralDifference { time_step_s, .. }
            | Self::Newmark { time_step_s, .. }
            | Self::Hht { time_step_s, .. }
            | Self::VelocityVerlet { time_step_s, .. }
            | Self::Rk4 { time_step_s }
            | Self::MoreauJean { time_step_s, .. } => *time_step_s = step,
            Self::Exact { .. } | Self::Accuracy(_) => {}
        }
        self
    }

    /// Time step \[s\] where a study shows something per step: it [asks](crate::Output) for methods that have one.
    pub(crate) fn step(&self) -> f64 {
        self.time_step()
            .expect("a study that shows steps was refused scenes without them")
    }
}
