//! How the records of an assessment are scaled before they shake a row.

use std::fmt;

use pounding_motion::Record;
use pounding_scene::file::ScaleTo;
use pounding_scene::{Error, RecordUse, STANDARD_GRAVITY, Scene, Structure, pair_spectra, periods_between, response_spectrum};
use pounding_text::{digits, percent, short};

use crate::design::DesignSpectrum;
use crate::rule::Rule;
use crate::suite::SuiteMotion;

/// Target to which records are scaled.
#[derive(Debug, Clone, PartialEq)]
pub enum Scaling {
    /// Scales records as the scene scales its own record.
    AsScene,
    /// Does not scale records.
    Unscaled,
    /// Scales records to a peak or a spectral acceleration.
    To(ScaleTo),
    /// Scales records to a spectrum. With the factor of a record, its spectrum equals the target on average, in logarithms.
    Target(SpectrumTarget),
    /// Scales records to a spectrum and then raises all of them by one factor, so that their mean spectrum has enough of it.
    Raised {
        /// The spectrum.
        target: SpectrumTarget,
        /// Factor on all records after their own \[–\], > 1.
        by: f64,
        /// Least part of the target that the mean spectrum has before \[–\].
        from: f64,
    },
}

/// A spectrum to which records are scaled, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumTarget {
    /// The spectrum.
    pub spectrum: DesignSpectrum,
    /// Shortest and longest period at which records are compared with it \[s\], > 0; by default 0.2 times the shortest and 2 times the longest
    /// first period of the row.
    pub periods: Option<[f64; 2]>,
    /// Which records have a common factor.
    pub factors: TargetFactors,
    /// Whether the spectrum of the maximum direction (`RotD100`) of both horizontal components is compared with it, as ASCE 7-16, 16.2.3.2,
    /// asks; both components then have one factor. By default each component has its own spectrum.
    pub maximum_direction: bool,
}

/// Which records have a common factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TargetFactors {
    /// Each record has its own.
    Each,
    /// All records have one, the geometric mean of their own; [`Scaling::raised`] finds it.
    Common,
    /// All records have this one \[–\], > 0.
    Known(f64),
}

impl From<DesignSpectrum> for SpectrumTarget {
    fn from(spectrum: DesignSpectrum) -> Self {
        Self {
            spectrum,
            periods: None,
            factors: TargetFactors::Each,
            maximum_direction: false,
        }
    }
}

impl SpectrumTarget {
    /// Shortest and longest period at which records are compared with it \[s\].
    fn ends(&self, scene: &Scene) -> [f64; 2] {
        self.periods.unwrap_or_else(|| ends_of(scene))
    }

    /// Periods that find the factor of a record \[s\], in rising order.
    fn periods_of(&self, scene: &Scene) -> Vec<f64> {
        let [first, last] = self.ends(scene);
        periods_between(first, last, PERIODS)
    }

    /// Periods at which the mean of records is compared with the target \[s\], in rising order: close together, and the corners of the
    /// target, where it may exceed its surroundings.
    pub(crate) fn checked_periods(&self, scene: &Scene) -> Vec<f64> {
        let [first, last] = self.ends(scene);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "some hundred: periods are between 1e-6 and 1e6 s"
        )]
        let count = (libm::log(last / first) / libm::log(CLOSE)).ceil() as u32 + 1;
        let mut periods = periods_between(first, last, count);
        let corners = self.spectrum.corners().into_iter();
        periods.extend(corners.filter(|period| (first..=last).contains(period)));
        periods.sort_by(f64::total_cmp);
        periods.dedup();
        periods
    }
}

impl fmt::Display for SpectrumTarget {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.spectrum.fmt(to)?;
        if let Some([first, last]) = self.periods {
            write!(to, " from {} to {} s", digits(first), digits(last))?;
        }
        if self.maximum_direction {
            to.write_str(" in the maximum direction")?;
        }
        match self.factors {
            TargetFactors::Each => Ok(()),
            TargetFactors::Common => to.write_str(", all by one factor"),
            TargetFactors::Known(factor) => write!(to, ", all × {}", short(factor)),
        }
    }
}

/// Number of periods at which a record's spectrum is compared with its target to find its factor.
const PERIODS: u32 = 30;

/// Number of periods of the spectrum of a record without a target.
const SHOWN: u32 = 100;

/// Ratio of adjacent periods at which the mean of records is compared with the target. A response with 5 % of damping has no dip between
/// them.
const CLOSE: f64 = 1.01;

/// Factors on the shortest and the longest first period of the row: spectra are compared between these periods. ASCE 7-16, 16.2.3.1, and EN
/// 1998-1, 3.2.3.1.2.
pub(crate) const BETWEEN: [f64; 2] = [0.2, 2.0];

/// Damping ratio of target spectra \[–\].
pub(crate) const DAMPING: f64 = 0.05;

/// Strength of a motion that shakes a row.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSpectrum {
    /// Peak ground acceleration \[m/s²\].
    pub peak: f64,
    /// Periods in rising order \[s\]: with a target those at which the mean of records is compared with it.
    pub periods: Vec<f64>,
    /// Pseudo-accelerations \[m/s²\] for 5 % of damping, at these periods.
    pub accelerations: Vec<f64>,
}

impl MotionSpectrum {
    /// Strength of the motion multiplied by a factor.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            peak: factor * self.peak,
            periods: self.periods.clone(),
            accelerations: self.accelerations.iter().map(|one| factor * one).collect(),
        }
    }
}

impl fmt::Display for Scaling {
    /// Describes the scaling in words.
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let both = |g: f64| format!("{} g = {} m/s²", digits(g), short(g * STANDARD_GRAVITY));
        match self {
            Self::AsScene => to.write_str("as the scene scales its own record"),
            Self::Unscaled => to.write_str("not at all"),
            Self::To(ScaleTo::PgaG(g)) => {
                write!(to, "to a peak ground acceleration of {}", both(*g))
            }
            Self::To(ScaleTo::Sa {
                period_s,
                damping_ratio,
                sa_g,
            }) => write!(
                to,
                "to a spectral acceleration of {} at {} s, {} of damping",
                both(*sa_g),
                digits(*period_s),
                percent(*damping_ratio)
            ),
            Self::Target(spectrum) => write!(to, "to the spectrum of {spectrum}"),
            Self::Raised { target, by, .. } => write!(to, "to the spectrum of {target}, then all × {}", digits(*by)),
        }
    }
}

impl Scaling {
    /// The rule for gaps of the code whose spectrum is the target.
    pub fn code(&self) -> Option<Rule> {
        match self.target()?.spectrum {
            DesignSpectrum::Eurocode8 { .. } => Some(Rule::Eurocode8),
            DesignSpectrum::Asce7 { .. } => Some(Rule::Asce7),
            DesignSpectrum::Table(_) => None,
        }
    }

    /// The spectrum to which records are scaled, if there is one.
    pub fn target(&self) -> Option<&SpectrumTarget> {
        match self {
            Self::Target(target) | Self::Raised { target, .. } => Some(target),
            Self::AsScene | Self::Unscaled | Self::To(_) => None,
        }
    }

    /// Factor on all records after their own \[–\].
    pub(crate) fn raise(&self) -> f64 {
        match self {
            Self::Raised { by, .. } => *by,
            Self::AsScene | Self::Unscaled | Self::To(_) | Self::Target(_) => 1.0,
        }
    }

    /// Returns the scene with this scaling of its record.
    fn scene(&self, scene: &Scene) -> Scene {
        let mut scaled = scene.clone();
        match self {
            Self::AsScene => {}
            Self::Unscaled | Self::Target(_) | Self::Raised { .. } => scaled.record = unscaled(&scene.record),
            Self::To(target) => {
                scaled.record = RecordUse {
                    scale_to: Some(*target),
                    ..unscaled(&scene.record)
                }
            }
        }
        scaled
    }

    /// Returns the scene for a motion, and the strength of the motion as it shakes the scene; `None` without a target if a spectrum cannot be
    /// computed.
    ///
    /// # Errors
    /// Refuses a motion that cannot be used in the scene, and a spectrum that cannot be computed.
    pub fn applied(&self, scene: &Scene, motion: &SuiteMotion) -> Result<(Scene, Option<MotionSpectrum>), Error> {
        let mut scaled = self.scene(scene);
        let (_, ground) = motion.used_as(&scaled.record, &scene.name)?;
        let Some(target) = self.target() else {
            let [first, last] = ends_of(scene);
            let periods = periods_between(first, last, SHOWN);
            let spectrum = accelerations(&ground.record, &periods, scene)
                .ok()
                .map(|accelerations| MotionSpectrum {
                    peak: ground.record.peak().1.abs(),
                    periods,
                    accelerations,
                });
            return Ok((scaled, spectrum));
        };
        let unscaled = scaled.record.clone();
        let spectrum = |periods: &[f64]| {
            if target.maximum_direction {
                maximum_direction(motion, &unscaled, periods, scene)
            } else {
                accelerations(&ground.record, periods, scene)
            }
        };
        let own = match target.factors {
            TargetFactors::Known(factor) => factor,
            TargetFactors::Each | TargetFactors::Common => {
                let unscaled = spectrum(&target.periods_of(scene))?;
                factor(&unscaled, target, scene)?
            }
        };
        scaled.record.scale = own * self.raise();
        let periods = target.checked_periods(scene);
        let unscaled = MotionSpectrum {
            peak: ground.record.peak().1.abs(),
            accelerations: spectrum(&periods)?,
            periods,
        };
        Ok((scaled.clone(), Some(unscaled.scaled(scaled.record.scale))))
    }
}

/// The use of a record without its scale.
pub(crate) fn unscaled(record: &RecordUse) -> RecordUse {
    RecordUse {
        scale_to: None,
        scale: 1.0,
        ..record.clone()
    }
}

/// Shortest and longest period at which records are compared with a spectrum \[s\]; at least one structure of the scene moves.
fn ends_of(scene: &Scene) -> [f64; 2] {
    // Before they yield, isolators are stiff: that period says little about the building.
    let periods = || scene.structures.iter().filter_map(Structure::longest_period);
    let [shortest, longest] = [periods().fold(f64::INFINITY, f64::min), periods().fold(0.0, f64::max)];
    [BETWEEN[0] * shortest, BETWEEN[1] * longest]
}

/// Field of the scene that scales a record.
pub(crate) const PLACE: &str = "record.scale";

/// The spectrum of a record at some periods \[m/s²\].
pub(crate) fn accelerations(record: &Record, periods: &[f64], scene: &Scene) -> Result<Vec<f64>, Error> {
    let found = response_spectrum(record, periods, DAMPING).map_err(|refused| Error::in_scene(&scene.name, refused.in_field(PLACE)))?;
    Ok(found.iter().map(|one| one.pseudo_acceleration).collect())
}

/// The spectrum of the maximum direction of a motion's recording at some periods \[m/s²\].
fn maximum_direction(motion: &SuiteMotion, record: &RecordUse, periods: &[f64], scene: &Scene) -> Result<Vec<f64>, Error> {
    let refused = |refused: pounding_motion::Refused| Error::in_scene(&scene.name, refused.in_field(PLACE));
    let Some([one, other]) = motion.both_components(record, &scene.name)? else {
        let found = pounding_motion::Refused::default().found("a motion without a second horizontal component");
        return Err(refused(
            found.allowed_is("a pair, whose maximum direction is compared with the target"),
        ));
    };
    let found = pair_spectra([&one, &other], periods, &[DAMPING], None, &|| ()).map_err(refused)?;
    Ok(found[0].values.iter().map(|one| one.rotd100).collect())
}

/// The factor that brings a spectrum to its target.
///
/// The mean of the logarithms of the ratios is the factor of least squares of these logarithms.
fn factor(found: &[f64], target: &SpectrumTarget, scene: &Scene) -> Result<f64, Error> {
    let periods = target.periods_of(scene);
    let gravity = scene.record.gravity_m_per_s2;
    let both = periods.iter().zip(found);
    let logs = both.map(|(period, found)| libm::log(target.spectrum.acceleration(*period) * gravity / found));
    let factor = libm::exp(logs.sum::<f64>() / f64::from(PERIODS));
    if factor.is_finite() {
        return Ok(factor);
    }
    Err(Error::in_scene(&scene.name, pounding_motion::at_rest().in_field(PLACE)))
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

    /// A target of twice the record's own spectrum doubles the record. The target outside the row's periods does not matter.
    #[test]
    fn reference_the_factor_is_the_ratio_of_the_spectra() {
        let scene: Scene = serde_json::from_str(SCENE).expect("a scene");
        let samples = (0..200).map(|index| libm::sin(0.3 * f64::from(index))).collect();
        let record = Record::new(0.02, samples, "a sine").expect("a record");
        let periods = periods_between(0.2 * 0.3, 2.0 * 0.8, PERIODS);
        let own = response_spectrum(&record, &periods, DAMPING).expect("a spectrum");
        let gravity = scene.record.gravity_m_per_s2;
        let point = |one: &pounding_scene::SpectralValues| [one.period, 2.0 * one.pseudo_acceleration / gravity];
        let mut points: Vec<[f64; 2]> = own.iter().map(point).collect();
        points.push([10.0, 1e6]);
        let found = accelerations(&record, &periods, &scene).expect("a spectrum");
        let found = factor(&found, &DesignSpectrum::Table(points).into(), &scene).expect("a factor");
        assert!((found - 2.0).abs() < 1e-9, "{found}");
    }

    /// The target is three times the record's spectrum from 0.5 to 1 s, and beyond something else.
    #[test]
    fn reference_a_range_of_periods_decides_alone() {
        let scene: Scene = serde_json::from_str(SCENE).expect("a scene");
        let samples = (0..200).map(|index| libm::sin(0.3 * f64::from(index))).collect();
        let record = Record::new(0.02, samples, "a sine").expect("a record");
        let periods = periods_between(0.5, 1.0, PERIODS);
        let own = accelerations(&record, &periods, &scene).expect("a spectrum");
        let gravity = scene.record.gravity_m_per_s2;
        let mut points: Vec<[f64; 2]> = vec![[0.1, 9.0]];
        points.extend(periods.iter().zip(&own).map(|(period, own)| [*period, 3.0 * own / gravity]));
        points.push([1.1, 7.0]);
        let target = SpectrumTarget {
            periods: Some([0.5, 1.0]),
            ..DesignSpectrum::Table(points).into()
        };
        let found = factor(&own, &target, &scene).expect("a factor");
        assert!((found - 3.0).abs() < 1e-9, "{found}");
        assert!(target.checked_periods(&scene).iter().all(|period| (0.5..=1.0).contains(period)));
        assert!(target.to_string().ends_with("from 0.5 to 1 s"), "{target}");
    }
}
