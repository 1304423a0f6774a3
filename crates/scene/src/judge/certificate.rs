//! Restitution that a contact law and a method deliver to two free masses.

use crate::Method;
use crate::judge::free_collision::{DeliveredRestitution, FreeCollision};
use pounding_contact::{Calibration, ContactLaw, FreeImpact, LawName};
use pounding_solver::{Exact, Integrator};
use pounding_text::Refused;

/// Request for a certificate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CertificateRequest {
    /// The law.
    pub law: LawName,
    /// Impact stiffness, in [`LawName::stiffness_unit`]; ignored for the impulsive law.
    pub stiffness: f64,
    /// Coefficient of restitution e \[–\].
    pub restitution: f64,
    /// Rule for choosing the damping of the law.
    pub calibration: Calibration,
}

/// Results of a law in a collision of two free masses.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// The law with its parameters.
    pub law: ContactLaw,
    /// e delivered exactly with the damping by the literature's formula; `None` if the literature has no formula.
    pub by_formula: Option<f64>,
    /// e delivered by the law's own relation, or else by integration of the free impact.
    pub by_relation: Option<f64>,
    /// e delivered by the exact method.
    pub by_exact: f64,
    /// Impulse \[N·s\] of the exact method.
    pub impulse: f64,
    /// Peak force, largest deformation and duration of the free impact; `None` for an impulsive law.
    pub impact: Option<FreeImpact>,
}

impl Certificate {
    /// Calibrates a law and lets two free masses collide.
    ///
    /// # Errors
    /// Refuses a parameter out of range, and a collision that cannot be run.
    pub fn new(wanted: &CertificateRequest, collision: &FreeCollision) -> Result<Self, Refused> {
        let pair = collision.free_pair();
        let calibrated = |calibration| wanted.law.calibrated(wanted.stiffness, wanted.restitution, calibration, &pair);
        let law = calibrated(wanted.calibration)?;
        let has_formula = wanted.law.named().formula.is_some();
        let formula = has_formula.then(|| calibrated(Calibration::Literature));
        let impact = FreeImpact::of(&law, &pair);
        let integrated = |law: &ContactLaw| Some(FreeImpact::of(law, &pair)?.restitution);
        let relation = |law: &ContactLaw| law.restitution().or_else(|| integrated(law));
        let contact = impact.map_or(0.0, |impact| impact.duration);
        let scale = if impact.is_some() { contact } else { 1.0 };
        let exact = Integrator::Exact(Exact::default());
        let run = collision.run(law, &exact, scale, 0.5, contact)?;
        Ok(Self {
            by_formula: formula.transpose()?.as_ref().and_then(relation),
            by_relation: relation(&law),
            by_exact: run.restitution(collision.speed),
            impulse: run.impulse,
            law,
            impact,
        })
    }

    /// Returns what a method delivers.
    ///
    /// # Errors
    /// [`Refused`] with the reason if the run fails.
    pub fn by(&self, collision: &FreeCollision, method: &Method) -> Result<DeliveredRestitution, Refused> {
        let duration = self.impact.map(|impact| impact.duration);
        collision.delivered(self.law, method, self.by_exact, duration)
    }
}
