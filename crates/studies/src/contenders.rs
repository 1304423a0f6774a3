//! The methods that compete, in the trade and for advice: to add one is a line.

use pounding_solver::{Newmark, SimultaneousImpacts, VerletImpacts};

use crate::figures::is_impulsive;
use crate::plot::{Kind, Mark, Shade};
use crate::{Method, Scene};

/// A method with all its settings but one: its time step or its tolerance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contender {
    /// Name in tables.
    pub(crate) key: &'static str,
    /// Name in figures.
    pub(crate) label: &'static str,
    /// Its line in figures; nothing where it would lie on that of another one.
    pub(crate) line: Option<(Shade, Kind, Mark)>,
    /// What its ladder changes.
    pub(crate) knob: Knob,
    /// Where it differs from another contender.
    pub(crate) differs: Differs,
    /// The method at a time step \[s\] or tolerance \[–\].
    pub(crate) method: fn(f64) -> Method,
}

/// What the ladder of a method changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Knob {
    /// The time step \[s\].
    TimeStep,
    /// The tolerance \[–\]; it acts in compliant contact only.
    Tolerance,
}

/// The scenes in which a method is not the same as another one of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Differs {
    Everywhere,
    /// Where structures can touch.
    InContact,
    /// Where contact is impulsive; elsewhere Moreau–Jean time stepping with θ = 1/2 is Newmark's average acceleration.
    InImpacts,
}

/// The method whose results the others are measured by, at its finest.
pub(crate) const REFERENCE: &str = "exact";
/// The stepping method that the exact one is held against.
pub(crate) const RIVAL: &str = "central_difference";

/// A method with a time step, by name.
#[derive(Debug, Clone, Copy)]
pub struct StepMethod(&'static Contender);

impl StepMethod {
    /// Every method with a time step, in the order of tables.
    pub fn all() -> impl Iterator<Item = Self> {
        let steps = |contender: &&Contender| contender.knob == Knob::TimeStep;
        CONTENDERS.iter().filter(steps).map(Self)
    }

    /// Those of them that are not the same as another one under an impulsive law, or a compliant one.
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

    /// Its line in figures; nothing where it would lie on that of another one.
    pub(crate) fn line(self) -> Option<(Shade, Kind, Mark)> {
        self.0.line
    }

    /// The method at a time step \[s\].
    pub fn at(self, time_step: f64) -> Method {
        (self.0.method)(time_step)
    }
}

/// Every contender, in the order of tables and legends.
pub(crate) const CONTENDERS: &[Contender] = &[
    Contender {
        key: RIVAL,
        label: "Central difference",
        line: Some((Shade::Blue, Kind::Line, Mark::Disc)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        method: |step| Method::central_difference(step, 1),
    },
    Contender {
        key: "central_difference_10_contact_substeps",
        label: "Central difference, 10 sub-steps in contact",
        line: Some((Shade::Amber, Kind::Line, Mark::Diamond)),
        knob: Knob::TimeStep,
        differs: Differs::InContact,
        method: |step| Method::central_difference(step, 10),
    },
    Contender {
        key: "velocity_verlet",
        label: "Velocity Verlet",
        line: Some((Shade::Green, Kind::Line, Mark::Diamond)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        method: |step| verlet(step, VerletImpacts::VelocityJump),
    },
    Contender {
        key: "velocity_verlet_located",
        label: "Velocity Verlet, impacts located",
        line: Some((Shade::Green, Kind::Dashed, Mark::HollowDiamond)),
        knob: Knob::TimeStep,
        differs: Differs::InImpacts,
        method: |step| verlet(step, VerletImpacts::Located),
    },
    Contender {
        key: "newmark_average_acceleration",
        label: "Newmark, average acceleration",
        line: Some((Shade::Vermilion, Kind::Line, Mark::Square)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        method: |step| newmark(step, Newmark::AVERAGE_ACCELERATION),
    },
    Contender {
        key: "newmark_linear_acceleration",
        label: "Newmark, linear acceleration",
        line: None,
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        method: |step| newmark(step, Newmark::LINEAR_ACCELERATION),
    },
    Contender {
        key: "hht",
        label: "HHT, α = −0.1",
        line: None,
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        method: |time_step_s| Method::Hht {
            time_step_s,
            alpha: -0.1,
        },
    },
    Contender {
        key: "moreau_jean",
        label: "Moreau–Jean, θ = 1/2",
        line: Some((Shade::Grey, Kind::Line, Mark::Cross)),
        knob: Knob::TimeStep,
        differs: Differs::InImpacts,
        method: |time_step_s| Method::MoreauJean {
            time_step_s,
            theta: 0.5,
        },
    },
    Contender {
        key: "rk4",
        label: "Runge–Kutta 4",
        line: Some((Shade::Rose, Kind::Line, Mark::Inverted)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        method: |time_step_s| Method::Rk4 { time_step_s },
    },
    Contender {
        key: REFERENCE,
        label: "Exact",
        line: Some((Shade::Ink, Kind::Line, Mark::Triangle)),
        knob: Knob::Tolerance,
        differs: Differs::Everywhere,
        method: |tolerance| Method::Exact {
            tolerance,
            simultaneous_impacts: SimultaneousImpacts::Together,
        },
    },
];

/// Name of a contender in figures, by its name in tables.
pub(crate) fn label_of(key: &str) -> &'static str {
    let found = CONTENDERS.iter().find(|contender| contender.key == key);
    found.map_or("", |contender| contender.label)
}

fn verlet(time_step_s: f64, impacts: VerletImpacts) -> Method {
    Method::VelocityVerlet {
        time_step_s,
        impacts,
    }
}

fn newmark(time_step_s: f64, Newmark { beta, gamma }: Newmark) -> Method {
    Method::Newmark {
        time_step_s,
        beta,
        gamma,
    }
}

impl Contender {
    /// Whether the method is run on a scene.
    pub(crate) fn enters(&self, scene: &Scene) -> bool {
        match self.differs {
            Differs::Everywhere => true,
            Differs::InContact => scene.contacts.is_some(),
            Differs::InImpacts => is_impulsive(scene),
        }
    }
}

/// Whether a contact of the scene has a force over time, and not only impulses.
pub(crate) fn is_compliant(scene: &Scene) -> bool {
    let mut contacts = scene.contacts.iter().flatten();
    contacts.any(|contact| contact.law.is_compliant())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_lines_of_methods_can_be_told_apart() {
        let lines: Vec<_> = CONTENDERS.iter().filter_map(|one| one.line).collect();
        for (n, (shade, kind, _)) in lines.iter().enumerate() {
            for other in &lines[..n] {
                assert_ne!((*shade, *kind), (other.0, other.1));
            }
        }
    }
}
