//! The methods that compete: to add one is a line.

use pounding_contact::ContactLaw;
use pounding_solver::{CentralDifference, Exact, Integrator, Newmark, Start};

use crate::Scene;
use crate::plot::{Kind, Mark, Shade};

/// A method with all its settings but one: its time step or its tolerance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contender {
    /// Name in tables.
    pub(crate) key: &'static str,
    /// Name in figures.
    pub(crate) label: &'static str,
    /// Its line in figures; nothing where it would hide another one.
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
}

/// The method whose results the others are measured by, at its finest.
pub(crate) const REFERENCE: &str = "exact";
/// The stepping method that the exact one is held against.
pub(crate) const RIVAL: &str = "central_difference_as_published";

/// Every contender, in the order of tables and legends.
pub(crate) const CONTENDERS: &[Contender] = &[
    Contender {
        key: RIVAL,
        label: "Central difference, as published",
        line: Some((Shade::Blue, Kind::Line, Mark::Disc)),
        knob: Knob::TimeStep,
        differs: Differs::Everywhere,
        integrator: |_| {
            Integrator::CentralDifference(CentralDifference {
                start: Start::Consistent,
            })
        },
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
        key: REFERENCE,
        label: "Exact",
        line: Some((Shade::Ink, Kind::Line, Mark::Triangle)),
        knob: Knob::Tolerance,
        differs: Differs::Everywhere,
        integrator: |tolerance| {
            Integrator::Exact(Exact {
                tolerance,
                ..Exact::default()
            })
        },
    },
];

impl Contender {
    /// Whether the method is run on a scene.
    pub(crate) fn enters(&self, _scene: &Scene) -> bool {
        match self.differs {
            Differs::Everywhere => true,
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
