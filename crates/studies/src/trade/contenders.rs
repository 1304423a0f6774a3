//! The methods that compete: to add one is a line.

use pounding_contact::ContactLaw;
use pounding_solver::{
    CentralDifference, Exact, Hht, ImpactRule, Integrator, MoreauJean, Newmark, Rk4, Start, Verlet,
    VerletImpacts,
};

use crate::Scene;
use crate::figures::is_impulsive;
use crate::plot::{Kind, Mark, Shade};

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
    /// The method at a tolerance; that at a time step does not depend on it, its clock does.
    pub(crate) integrator: fn(f64) -> Integrator,
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
pub(crate) const RIVAL: &str = "central_difference_velocity_jump";

/// Every contender, in the order of tables and legends.
pub(crate) const CONTENDERS: &[Contender] = &[
    Contender {
        key: "central_difference_as_published",
        label: "Central difference, as published",
        line: Some((Shade::Blue, Kind::Line, Mark::Disc)),
        knob: Knob::TimeStep,
        differs: Differs::InImpacts,
        integrator: |_| central_difference(ImpactRule::AsPublished, 1),
    },
    Contender {
        key: RIVAL,
        label: "Central difference",
        line: Some((Shade::Blue, Kind::Dashed, Mark::Ring)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        integrator: |_| central_difference(ImpactRule::VelocityJump, 1),
    },
    Contender {
        key: "central_difference_10_contact_substeps",
        label: "Central difference, 10 sub-steps in contact",
        line: Some((Shade::Amber, Kind::Line, Mark::Diamond)),
        knob: Knob::TimeStep,
        differs: Differs::InContact,
        integrator: |_| central_difference(ImpactRule::VelocityJump, 10),
    },
    Contender {
        key: "velocity_verlet",
        label: "Velocity Verlet",
        line: Some((Shade::Green, Kind::Line, Mark::Diamond)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        integrator: |_| verlet(VerletImpacts::VelocityJump),
    },
    Contender {
        key: "velocity_verlet_located",
        label: "Velocity Verlet, impacts located",
        line: Some((Shade::Green, Kind::Dashed, Mark::HollowDiamond)),
        knob: Knob::TimeStep,
        differs: Differs::InImpacts,
        integrator: |_| verlet(VerletImpacts::Located),
    },
    Contender {
        key: "newmark_average_acceleration",
        label: "Newmark, average acceleration",
        line: Some((Shade::Vermilion, Kind::Line, Mark::Square)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        integrator: |_| Integrator::Newmark(Newmark::AVERAGE_ACCELERATION),
    },
    Contender {
        key: "newmark_linear_acceleration",
        label: "Newmark, linear acceleration",
        line: None,
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        integrator: |_| Integrator::Newmark(Newmark::LINEAR_ACCELERATION),
    },
    Contender {
        key: "hht",
        label: "HHT, α = −0.1",
        line: None,
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        integrator: |_| Integrator::Hht(Hht { alpha: -0.1 }),
    },
    Contender {
        key: "moreau_jean",
        label: "Moreau–Jean, θ = 1/2",
        line: Some((Shade::Grey, Kind::Line, Mark::Cross)),
        knob: Knob::TimeStep,
        differs: Differs::InImpacts,
        integrator: |_| Integrator::MoreauJean(MoreauJean { theta: 0.5 }),
    },
    Contender {
        key: "rk4",
        label: "Runge–Kutta 4",
        line: Some((Shade::Rose, Kind::Line, Mark::Inverted)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        integrator: |_| Integrator::Rk4(Rk4),
    },
    Contender {
        key: REFERENCE,
        label: "Exact",
        line: Some((Shade::Ink, Kind::Line, Mark::Triangle)),
        knob: Knob::Tolerance,
        differs: Differs::Everywhere,
        integrator: exact,
    },
];

fn central_difference(impacts: ImpactRule, contact_substeps: u32) -> Integrator {
    Integrator::CentralDifference(CentralDifference {
        start: Start::Consistent,
        impacts,
        contact_substeps,
    })
}

fn verlet(impacts: VerletImpacts) -> Integrator {
    Integrator::Verlet(Verlet { impacts })
}

fn exact(tolerance: f64) -> Integrator {
    Integrator::Exact(Exact {
        tolerance,
        ..Exact::default()
    })
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
    contacts.any(|contact| match contact.law {
        ContactLaw::NonlinearViscoelastic(_) => true,
        ContactLaw::Stereomechanical(_) => false,
    })
}
