//! The lines of a certificate, for people and for programs.

use pounding_contact::{Clamp, LawName};

use crate::accuracy::methods::StepMethod;
use crate::judge::certificate::{Certificate, CertificateRequest};
use crate::judge::free_collision::{DeliveredRestitution, FreeCollision};

/// A line of a certificate.
#[derive(Debug, Clone, PartialEq)]
pub struct CertificateFact {
    /// Name in CSV and JSON, with its unit.
    pub key: &'static str,
    /// Name in text.
    pub words: &'static str,
    /// Unit; empty for words and for numbers without a unit.
    pub unit: &'static str,
    /// Value of the line.
    pub said: CertificateValue,
}

/// Value of a line of a certificate.
#[derive(Debug, Clone, PartialEq)]
pub enum CertificateValue {
    /// A number; `None` if it does not exist.
    Number(Option<f64>),
    /// Words.
    Words(String),
}

/// Result of one method, or the reason why it fails.
#[derive(Debug, Clone)]
pub struct DeliveredBy {
    /// The method.
    pub method: StepMethod,
    /// Time step \[s\].
    pub step: f64,
    /// Delivered restitution, or the reason why the run fails.
    pub delivered: Result<DeliveredRestitution, String>,
}

impl Certificate {
    /// Default impact stiffness, in the unit of the law; NaN for the impulsive law, which ignores it.
    pub fn usual_stiffness(law: LawName) -> f64 {
        law.stiffness().map_or(f64::NAN, |stiffness| stiffness.usual)
    }

    /// Lines of the certificate.
    ///
    /// # Panics
    /// Never: a law is plain data.
    pub fn facts(&self, wanted: &CertificateRequest, collision: &FreeCollision) -> Vec<CertificateFact> {
        let certificate = self;
        let named = |key, words, text: &str| CertificateFact {
            key,
            words,
            unit: "",
            said: CertificateValue::Words(text.into()),
        };
        let number = |(key, words, unit, number)| CertificateFact {
            key,
            words,
            unit,
            said: CertificateValue::Number(number),
        };
        let mut facts = vec![named("law", "law", wanted.law.name())];
        let [left, right] = collision.masses.map(Some);
        let (e, delivered) = (Some(wanted.restitution), certificate.by_relation);
        let (v, impulse) = (Some(collision.speed), Some(certificate.impulse));
        let by_exact = Some(certificate.by_exact);
        let [peak, deepest, duration] = match certificate.impact {
            Some(impact) => [impact.peak_force, impact.max_deformation, impact.force_duration].map(Some),
            None => [None; 3],
        };
        let numbers = [
            ("mass_left_kg", "left mass", "kg", left),
            ("mass_right_kg", "right mass", "kg", right),
            ("approach_speed_m_per_s", "approach speed", "m/s", v),
            ("restitution_asked", "e asked", "", e),
            (
                "restitution_by_formula",
                "e by the literature's formula",
                "",
                certificate.by_formula,
            ),
            ("restitution_delivered", "e delivered", "", delivered),
            ("restitution_by_exact_method", "e by the exact method", "", by_exact),
            ("impulse_n_s", "impulse", "N·s", impulse),
            ("peak_force_n", "peak force", "N", peak),
            ("max_deformation_m", "largest deformation", "m", deepest),
            ("contact_duration_s", "duration of collision", "s", duration),
        ];
        facts.extend(numbers.map(number));
        let parameters = serde_json::to_string(&certificate.law).expect("a law is plain data");
        let clamp = match certificate.law.clamp() {
            Clamp::Never => "never",
            Clamp::DrivenApart => "only where something else drives the pair apart; clamped",
            Clamp::EveryCollision => "at the end of every collision; clamped",
        };
        facts.push(named("would_pull", "would pull", clamp));
        facts.push(named("parameters", "parameters", &parameters));
        facts
    }

    /// Results of methods at a time step \[s\]: of one method, or of all that differ under this law.
    pub fn lines(&self, collision: &FreeCollision, step: f64, method: Option<StepMethod>) -> Vec<DeliveredBy> {
        let line = |method: StepMethod| {
            let delivered = self.by(collision, &method.at(step));
            DeliveredBy {
                method,
                step,
                delivered: delivered.map_err(|error| error.to_string()),
            }
        };
        match method {
            Some(method) => vec![line(method)],
            None => StepMethod::differing(self.law.impulsive().is_some()).map(line).collect(),
        }
    }
}

/// A number that a method delivers.
#[derive(Debug)]
pub struct DeliveredNumber {
    /// Its name in files.
    pub key: &'static str,
    /// Its name above a column.
    pub heading: &'static str,
    /// Takes it from what a method delivers.
    pub of: fn(&DeliveredRestitution) -> Option<f64>,
}

impl DeliveredBy {
    /// The numbers that a method delivers.
    pub const NUMBERS: [DeliveredNumber; 4] = [
        DeliveredNumber {
            key: "steps_per_contact",
            heading: "Steps per contact",
            of: |delivered| delivered.steps_per_contact,
        },
        DeliveredNumber {
            key: "least_restitution",
            heading: "Least e",
            of: |delivered| Some(delivered.range[0]),
        },
        DeliveredNumber {
            key: "largest_restitution",
            heading: "Largest e",
            of: |delivered| Some(delivered.range[1]),
        },
        DeliveredNumber {
            key: "largest_error",
            heading: "Error",
            of: |delivered| Some(delivered.error),
        },
    ];
}
