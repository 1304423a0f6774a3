//! The motions of a row at several intensities.

use pounding_assess::{IntensityMeasure, Suite, SuiteMotion};
use pounding_scene::{Error, Implausible, RecordUse, Scene};
use pounding_text::Refused;

/// The motions of all intensities.
#[derive(Debug, Clone)]
pub enum StripeMotions {
    /// Every motion is scaled to every intensity.
    Scaled {
        /// The motions.
        suite: Suite,
        /// How their intensity is measured.
        measure: IntensityMeasure,
        /// Intensities \[g\], > 0, rising.
        intensities: Vec<f64>,
    },
    /// Every intensity \[g\], > 0, rising, has other motions, which are as strong as in their files.
    Own(Vec<(f64, Suite)>),
}

impl StripeMotions {
    /// Every motion scaled to every intensity \[g\], > 0, in any order.
    ///
    /// # Errors
    /// Refuses an intensity twice.
    pub fn scaled(suite: Suite, measure: IntensityMeasure, mut intensities: Vec<f64>) -> Result<Self, Refused> {
        intensities.sort_by(f64::total_cmp);
        each_once(&intensities)?;
        Ok(Self::Scaled {
            suite,
            measure,
            intensities,
        })
    }

    /// Motions of their own for every intensity \[g\], > 0, in any order.
    ///
    /// # Errors
    /// Refuses an intensity twice.
    pub fn own(mut all: Vec<(f64, Suite)>) -> Result<Self, Refused> {
        all.sort_by(|one, other| one.0.total_cmp(&other.0));
        each_once(&all.iter().map(|one| one.0).collect::<Vec<_>>())?;
        Ok(Self::Own(all))
    }

    /// The folders of records: one, or one for each intensity.
    pub fn suites(&self) -> Vec<&Suite> {
        match self {
            Self::Scaled { suite, .. } => vec![suite],
            Self::Own(all) => all.iter().map(|one| &one.1).collect(),
        }
    }

    /// The records of an intensity, by its index.
    pub fn suite_at(&self, stripe: usize) -> &Suite {
        match self {
            Self::Scaled { suite, .. } => suite,
            Self::Own(all) => &all[stripe].1,
        }
    }

    /// The scene under a motion of an intensity, and the unusual values of the scene under the motion as recorded.
    ///
    /// # Errors
    /// Those of [`SuiteMotion::shake`] and [`IntensityMeasure::of`].
    pub fn scene_at(&self, stripe: usize, motion: &SuiteMotion, scene: &Scene) -> Result<(Scene, Vec<Implausible>), Error> {
        let scaled = |scale: f64| Scene {
            record: RecordUse {
                scale,
                scale_to: None,
                ..scene.record.clone()
            },
            ..scene.clone()
        };
        let recorded = motion.shake(&scaled(1.0), false, None)?;
        let scale = match self {
            Self::Scaled { measure, intensities, .. } => intensities[stripe] / measure.of(motion, scene)?,
            Self::Own(_) => 1.0,
        };
        Ok((scaled(scale), recorded.doubts()))
    }
}

/// Refuses an intensity twice in a rising list.
fn each_once(rising: &[f64]) -> Result<(), Refused> {
    if rising.windows(2).all(|two| two[0] < two[1]) {
        return Ok(());
    }
    Err(Refused::at("stripes").found("an intensity twice").allowed_is("each once"))
}
