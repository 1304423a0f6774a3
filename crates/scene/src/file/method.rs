//! The method that integrates a scene, with its settings.

use pounding_solver::{Exact, SimultaneousImpacts, VerletImpacts};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::choice::{Choice, also};

/// A method of time integration with its settings.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[schemars(transform = or_exact)]
pub enum Method {
    /// Central difference method.
    CentralDifference {
        /// Time step \[s\], > 0.
        time_step_s: f64,
        /// Start of the first step. It has only one value and may be left out.
        #[serde(default, skip_serializing)]
        start: Start,
        /// Action of impulsive contact. It has only one value and may be left out.
        #[serde(default, skip_serializing)]
        impacts: Jumps,
        /// Number of steps into which a time step is divided for structures that touch, 1 to 1000.
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
        /// α \[–\], −1/3 (most damping of high frequencies) to 0 (no damping).
        alpha: f64,
    },
    /// Velocity Verlet method.
    VelocityVerlet {
        /// Time step \[s\], > 0.
        time_step_s: f64,
        /// Instant at which impulsive contact acts.
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
        /// Relative truncation error of a piece in compliant contact \[–\], 1e-16 to 1e-3.
        #[serde(default = "finest", skip_serializing_if = "is_finest")]
        tolerance: f64,
        /// Rule for several pairs that touch at the same instant.
        #[serde(default, skip_serializing_if = "is_default")]
        simultaneous_impacts: SimultaneousImpacts,
    },
    /// The cheapest method whose every printed number is at most this far from the exact method \[–\], > 0 and < 1. It is found when the
    /// scene is [prepared](crate::Simulation::new).
    Accuracy(f64),
}

/// Start of the central difference method; kept for older scene files.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Start {
    /// From equilibrium.
    #[default]
    Consistent,
}

/// Action of impulsive contact in the central difference method; kept for older scene files.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Jumps {
    /// Velocities jump.
    #[default]
    VelocityJump,
}

/// The exact method needs no settings.
fn or_exact(schema: &mut schemars::Schema) {
    let description = "The exact method with its usual settings.";
    let word = json!({"description": description, "type": "string", "const": "exact"});
    also(schema, word);
}

impl Choice for Method {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"central_difference": {"time_step_s": 0.001}}"#,
        r#"{"newmark": {"time_step_s": 0.001, "beta": 0.25, "gamma": 0.5}}"#,
        r#"{"hht": {"time_step_s": 0.001, "alpha": -0.1}}"#,
        r#"{"velocity_verlet": {"time_step_s": 0.001}}"#,
        r#"{"rk4": {"time_step_s": 0.001}}"#,
        r#"{"moreau_jean": {"time_step_s": 0.001, "theta": 0.5}}"#,
        r#"{"accuracy": 0.01}"#,
    ];
}

fn finest() -> f64 {
    Exact::default().tolerance
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_finest(tolerance: &f64) -> bool {
    *tolerance <= finest()
}

pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

fn one_step() -> u32 {
    1
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_one_step(n: &u32) -> bool {
    *n == one_step()
}

impl Method {
    /// The exact method with its default settings.
    pub const EXACT: Self = Self::Exact {
        tolerance: 1e-16,
        simultaneous_impacts: SimultaneousImpacts::Together,
    };

    /// The central difference method with a time step \[s\] and a number of sub-steps while structures touch.
    pub const fn central_difference(time_step_s: f64, contact_substeps: u32) -> Self {
        Self::CentralDifference {
            time_step_s,
            start: Start::Consistent,
            impacts: Jumps::VelocityJump,
            contact_substeps,
        }
    }

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

    /// Whether the method lets damping follow the tangent stiffness; a method for an accuracy is one of those that do.
    pub(crate) fn takes_tangent_damping(self) -> bool {
        matches!(self, Self::Accuracy(_)) || self.integrator().takes_tangent_damping()
    }

    /// Time step \[s\]; `None` for the exact method, and for an accuracy whose method is not yet found.
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

    /// Number of steps in a time step while structures touch.
    pub fn contact_substeps(&self) -> u32 {
        match *self {
            Self::CentralDifference { contact_substeps, .. } => contact_substeps,
            Self::Newmark { .. }
            | Self::Hht { .. }
            | Self::VelocityVerlet { .. }
            | Self::Rk4 { .. }
            | Self::MoreauJean { .. }
            | Self::Exact { .. }
            | Self::Accuracy(_) => 1,
        }
    }

    /// Returns the method with another time step \[s\]; a method without time step does not change.
    #[must_use]
    pub fn with_time_step(mut self, step: f64) -> Self {
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

    /// Time step of the method \[s\].
    ///
    /// # Panics
    /// If it has none: the exact method, and an accuracy.
    pub fn step(&self) -> f64 {
        self.time_step().expect("who asks for the step has refused methods without one")
    }
}
