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
        /// How the first step begins; there is no other way, and no need to say it.
        #[serde(default, skip_serializing)]
        start: Start,
        /// How impulsive contact acts; there is no other way, and no need to say it.
        #[serde(default, skip_serializing)]
        impacts: Jumps,
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
    /// found when the scene is [prepared](crate::Simulation::new).
    Accuracy(f64),
}

/// How the central difference method begins: a word of scenes of before.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Start {
    /// From equilibrium.
    #[default]
    Consistent,
}

/// How impulsive contact acts in it: a word of scenes of before.
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

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
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
    /// The exact method with its usual settings.
    pub const EXACT: Self = Self::Exact {
        tolerance: 1e-16,
        simultaneous_impacts: SimultaneousImpacts::Together,
    };

    /// The central difference method, with so many steps in a time step \[s\] while structures touch.
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

    /// Steps that it takes in a time step while structures touch.
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

    /// The same method with another time step \[s\]; one that has none stays as it is.
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

    /// Time step \[s\] of a method that has one.
    ///
    /// # Panics
    /// If it has none: by the exact method, and of an accuracy.
    pub fn step(&self) -> f64 {
        self.time_step().expect("who asks for the step has refused methods without one")
    }
}
