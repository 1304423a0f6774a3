//! Settings of the atlas of contact laws.

use pounding_contact::{Calibration, FreePair, LawName, reduced_mass};
use serde::{Deserialize, Serialize};

use pounding_scene::{Certificate, CertificateRequest, FreeCollision, Refused, Structure};

/// Settings of the atlas of contact laws.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AtlasSettings {
    /// Masses of the free pair \[kg\], > 0.
    pub masses_kg: [f64; 2],
    /// Approach speed of the free pair \[m/s\], > 0.
    pub approach_speed_m_per_s: f64,
    /// Impact stiffness of the laws with a linear spring \[N/m\], > 0.
    pub linear_stiffness_n_per_m: f64,
    /// Impact stiffness of the laws with a Hertz spring \[N/m^1.5\], > 0.
    pub hertz_stiffness_n_per_m1_5: f64,
    /// e \[–\] that all laws deliver in comparisons, 0 to 1; springs without damping deliver 1.
    pub restitution: f64,
    /// Values of e \[–\] that each law is calibrated to, for comparison with the delivered values.
    pub restitutions: Vec<f64>,
    /// Approach speeds \[m/s\] at which a law is tested after its calibration at `approach_speed_m_per_s`.
    pub approach_speeds_m_per_s: Vec<f64>,
    /// Time steps of the stepping methods, as numbers of steps per contact \[–\].
    pub steps_per_contact: Vec<f64>,
}

impl AtlasSettings {
    /// The free pair.
    pub(crate) fn collision(&self) -> FreeCollision {
        FreeCollision {
            masses: self.masses_kg,
            speed: self.approach_speed_m_per_s,
        }
    }

    /// Impact stiffness of a law, in its own unit.
    pub(crate) fn stiffness(&self, law: LawName) -> f64 {
        if is_linear(law) {
            self.linear_stiffness_n_per_m
        } else {
            self.hertz_stiffness_n_per_m1_5
        }
    }

    /// e \[–\] at which a law is compared with others.
    pub(crate) fn restitution(&self, law: LawName) -> f64 {
        if law.is_elastic() { 1.0 } else { self.restitution }
    }

    /// The certificate of a law calibrated exactly.
    pub(crate) fn certificate(&self, law: LawName, restitution: f64) -> Result<Certificate, Refused> {
        let wanted = CertificateRequest {
            law,
            stiffness: self.stiffness(law),
            restitution,
            calibration: Calibration::Exact,
        };
        Certificate::new(&wanted, &self.collision())
    }
}

/// Whether the law has a linear spring.
pub(crate) fn is_linear(law: LawName) -> bool {
    law.stiffness_unit() == Some("N/m")
}

/// The highest floors of two neighbours as a free pair, at an approach speed \[m/s\].
pub(crate) fn free_pair(two: &[Structure], approach_speed: f64) -> FreePair {
    let inverse_mass = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => 1.0 / sdof.mass_kg,
        Structure::Building(building) => building.storeys.last().map_or(0.0, |top| 1.0 / top.mass_kg),
        Structure::Wall => 0.0,
    };
    FreePair {
        reduced_mass: reduced_mass(inverse_mass(&two[0]), inverse_mass(&two[1])),
        approach_speed,
    }
}
