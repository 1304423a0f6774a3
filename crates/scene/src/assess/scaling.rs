//! How the records of an assessment are scaled before they shake a row.

use pounding_motion::{Record, RecordError};

use super::design::DesignSpectrum;
use crate::{
    Error, Motion, MotionError, RecordUse, ScaleTo, Scene, Structure, in_scene, periods_between,
    response_spectrum,
};

/// What records are scaled to.
#[derive(Debug, Clone, PartialEq)]
pub enum Scaling {
    /// As the scene scales its own record.
    AsScene,
    /// Not at all.
    Unscaled,
    /// To a peak or a spectral acceleration.
    To(ScaleTo),
    /// To a spectrum: by the factor whose spectrum is, on average of the logarithms between 0.2 of the shortest and twice the longest
    /// first period of the row, the wanted one.
    Target(DesignSpectrum),
}

/// Periods at which a record's spectrum is compared with its target.
const PERIODS: u32 = 30;

/// Part of the shortest and multiple of the longest period between which it is compared; of ASCE 7-16, 16.2.3.1, and EN 1998-1, 3.2.3.1.2.
const BETWEEN: [f64; 2] = [0.2, 2.0];

/// Damping ratio of target spectra \[–\].
const DAMPING: f64 = 0.05;

impl Scaling {
    /// A scene whose records are scaled so.
    pub(crate) fn scene(&self, scene: &Scene) -> Scene {
        let mut scaled = scene.clone();
        match self {
            Self::AsScene => {}
            Self::Unscaled | Self::Target(_) => scaled.record = unscaled(&scene.record),
            Self::To(target) => {
                scaled.record = RecordUse {
                    scale_to: Some(*target),
                    ..unscaled(&scene.record)
                }
            }
        }
        scaled
    }

    /// The scene as a motion is to shake it.
    ///
    /// # Errors
    /// Those of reading the motion and of its spectrum.
    pub fn applied(&self, scene: &Scene, motion: &Motion) -> Result<Scene, Error> {
        let mut scaled = self.scene(scene);
        if let Self::Target(target) = self {
            let (_, ground) = motion.used_as(&scaled.record, &scene.name)?;
            scaled.record.scale = factor(&ground.record, target, scene)?;
        }
        Ok(scaled)
    }
}

fn unscaled(record: &RecordUse) -> RecordUse {
    RecordUse {
        scale_to: None,
        scale: 1.0,
        ..record.clone()
    }
}

/// The factor that brings a record's spectrum to its target.
fn factor(record: &Record, target: &DesignSpectrum, scene: &Scene) -> Result<f64, Error> {
    const PLACE: &str = "record.scale";
    let refused = |error: MotionError| in_scene(scene, error.into());
    let of_row = scene.structures.iter().filter_map(Structure::period);
    let (shortest, longest) = of_row.fold((f64::INFINITY, 0.0_f64), |(least, most), period| {
        (least.min(period), most.max(period))
    });
    let periods = periods_between(BETWEEN[0] * shortest, BETWEEN[1] * longest, PERIODS);
    let found = response_spectrum(record, &periods, DAMPING)
        .map_err(|error| refused(MotionError::of_spectrum(PLACE, error)))?;
    let gravity = scene.record.gravity_m_per_s2;
    let logs = periods.iter().zip(&found).map(|(period, found)| {
        libm::log(target.acceleration(*period) * gravity / found.pseudo_acceleration)
    });
    let factor = libm::exp(logs.sum::<f64>() / f64::from(PERIODS));
    if factor.is_finite() {
        return Ok(factor);
    }
    let nothing = RecordError::AllZero {
        target: target.acceleration(longest) * gravity,
    };
    Err(refused(MotionError::of(PLACE, &nothing)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = r#"{
        "name": "two",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
        "structures": [
            {"sdof": {"name": "left", "mass_kg": 1e5, "period_s": 0.8, "damping": {"ratio": 0.05}}},
            {"sdof": {"name": "right", "mass_kg": 1e5, "period_s": 0.3, "damping": {"ratio": 0.05}}}
        ]
    }"#;

    /// A target of twice the record's own spectrum doubles it; what the spectrum is outside the row's periods does not matter.
    #[test]
    fn reference_the_factor_is_the_ratio_of_the_spectra() {
        let scene: Scene = serde_json::from_str(SCENE).expect("a scene");
        let samples = (0..200)
            .map(|index| libm::sin(0.3 * f64::from(index)))
            .collect();
        let record = Record::new(0.02, samples, "a sine").expect("a record");
        let periods = periods_between(0.2 * 0.3, 2.0 * 0.8, PERIODS);
        let own = response_spectrum(&record, &periods, DAMPING).expect("a spectrum");
        let gravity = scene.record.gravity_m_per_s2;
        let point =
            |one: &crate::SpectralValues| [one.period, 2.0 * one.pseudo_acceleration / gravity];
        let mut points: Vec<[f64; 2]> = own.iter().map(point).collect();
        points.push([10.0, 1e6]);
        let found = factor(&record, &DesignSpectrum::Table(points), &scene).expect("a factor");
        assert!((found - 2.0).abs() < 1e-9, "{found}");
    }
}
