//! The methods that studies compare and that advice chooses from: a new one is an entry in the list.

use pounding_solver::{Newmark, SimultaneousImpacts, VerletImpacts};

use crate::{Method, Scene};

/// A method with all its settings but one: its time step or its tolerance.
#[derive(Debug, Clone, Copy)]
pub struct ComparedMethod {
    /// Name in tables.
    pub key: &'static str,
    /// Name in figures.
    pub label: &'static str,
    /// Setting that its ladder changes.
    pub knob: MethodSetting,
    /// Scenes in which it differs from the other methods of the list.
    pub(crate) differs: Differs,
    /// The method at a time step \[s\] or tolerance \[–\].
    pub method: fn(f64) -> Method,
}

/// Setting that the ladder of a method changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MethodSetting {
    /// The time step \[s\].
    TimeStep,
    /// The tolerance \[–\], which matters only in compliant contact.
    Tolerance,
}

/// Scenes in which a method differs from the other methods of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Differs {
    Everywhere,
    /// Scenes in which structures can touch.
    InContact,
    /// Scenes with impulsive contact. Elsewhere Moreau–Jean time stepping with θ = 1/2 is Newmark's average acceleration.
    InImpacts,
}

/// A method with a time step, by name.
#[derive(Debug, Clone, Copy)]
pub struct StepMethod(&'static ComparedMethod);

impl StepMethod {
    /// Every method with a time step, in the order of tables.
    pub fn all() -> impl Iterator<Item = Self> {
        let steps = |contender: &&ComparedMethod| contender.knob == MethodSetting::TimeStep;
        ComparedMethod::ALL.iter().filter(steps).map(Self)
    }

    /// Every method with a time step that differs from the others under an impulsive law, or under a compliant one.
    pub fn differing(impulsive: bool) -> impl Iterator<Item = Self> {
        let differs = move |method: &Self| impulsive || method.0.differs != Differs::InImpacts;
        Self::all().filter(differs)
    }

    /// Name in tables.
    pub fn name(self) -> &'static str {
        self.0.key
    }

    /// Name in text.
    pub fn label(self) -> &'static str {
        self.0.label
    }

    /// The method at a time step \[s\].
    pub fn at(self, time_step: f64) -> Method {
        (self.0.method)(time_step)
    }
}

fn verlet(time_step_s: f64, impacts: VerletImpacts) -> Method {
    Method::VelocityVerlet { time_step_s, impacts }
}

fn newmark(time_step_s: f64, Newmark { beta, gamma }: Newmark) -> Method {
    Method::Newmark { time_step_s, beta, gamma }
}

impl ComparedMethod {
    /// Key of the method that is the reference for the others, at its finest tolerance.
    pub const REFERENCE: &str = "exact";

    /// Key of the stepping method that the exact method is compared with.
    pub const RIVAL: &str = "central_difference";

    /// Every method, in the order of tables and legends.
    pub const ALL: &[Self] = &[
        Self {
            key: Self::RIVAL,
            label: "Central difference",
            knob: MethodSetting::TimeStep,
            differs: Differs::Everywhere,
            method: |step| Method::central_difference(step, 1),
        },
        Self {
            key: "central_difference_10_contact_substeps",
            label: "Central difference, 10 sub-steps in contact",
            knob: MethodSetting::TimeStep,
            differs: Differs::InContact,
            method: |step| Method::central_difference(step, 10),
        },
        Self {
            key: "velocity_verlet",
            label: "Velocity Verlet",
            knob: MethodSetting::TimeStep,
            differs: Differs::Everywhere,
            method: |step| verlet(step, VerletImpacts::VelocityJump),
        },
        Self {
            key: "velocity_verlet_located",
            label: "Velocity Verlet, impacts located",
            knob: MethodSetting::TimeStep,
            differs: Differs::InImpacts,
            method: |step| verlet(step, VerletImpacts::Located),
        },
        Self {
            key: "newmark_average_acceleration",
            label: "Newmark, average acceleration",
            knob: MethodSetting::TimeStep,
            differs: Differs::Everywhere,
            method: |step| newmark(step, Newmark::AVERAGE_ACCELERATION),
        },
        Self {
            key: "newmark_linear_acceleration",
            label: "Newmark, linear acceleration",
            knob: MethodSetting::TimeStep,
            differs: Differs::Everywhere,
            method: |step| newmark(step, Newmark::LINEAR_ACCELERATION),
        },
        Self {
            key: "hht",
            label: "HHT, α = −0.1",
            knob: MethodSetting::TimeStep,
            differs: Differs::Everywhere,
            method: |time_step_s| Method::Hht { time_step_s, alpha: -0.1 },
        },
        Self {
            key: "moreau_jean",
            label: "Moreau–Jean, θ = 1/2",
            knob: MethodSetting::TimeStep,
            differs: Differs::InImpacts,
            method: |time_step_s| Method::MoreauJean { time_step_s, theta: 0.5 },
        },
        Self {
            key: "rk4",
            label: "Runge–Kutta 4",
            knob: MethodSetting::TimeStep,
            differs: Differs::Everywhere,
            method: |time_step_s| Method::Rk4 { time_step_s },
        },
        Self {
            key: Self::REFERENCE,
            label: "Exact",
            knob: MethodSetting::Tolerance,
            differs: Differs::Everywhere,
            method: |tolerance| Method::Exact {
                tolerance,
                simultaneous_impacts: SimultaneousImpacts::Together,
            },
        },
    ];

    /// Name of a method in figures, by its name in tables; empty if there is no such method.
    pub fn label_of(key: &str) -> &'static str {
        let found = Self::ALL.iter().find(|contender| contender.key == key);
        found.map_or("", |contender| contender.label)
    }

    /// Whether the method is run on a scene.
    pub(crate) fn enters(&self, scene: &Scene) -> bool {
        match self.differs {
            Differs::Everywhere => true,
            Differs::InContact => scene.contacts.is_some(),
            Differs::InImpacts => scene.is_impulsive(),
        }
    }
}
