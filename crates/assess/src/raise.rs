//! Records that are raised together, because their mean spectrum stays below the target.

use pounding_scene::{Implausible, Scene, parallel};

use crate::scaling::{MotionSpectrum, Scaling, SpectrumTarget, TargetFactors};
use crate::suite::Suite;
use crate::target_fit::TargetFit;

impl Scaling {
    /// Largest factor by which records are raised to their target \[–\]. If more is needed, they belong to other earthquakes.
    pub const MOST_RAISED: f64 = Implausible::USUAL_FACTORS[1];

    /// Returns the scaling that raises all motions of a suite, if their mean spectrum has less than [`TargetFit::LEAST_SHARE`] of the target
    /// somewhere. Scaling each record on average leaves the mean below the target at some periods, and a code does not take such a suite.
    ///
    /// Motions that need a factor above `most` leave the suite. The scaling
    /// stays as it is if the raise would be more than [`Self::MOST_RAISED`]. The common factor of [`TargetFactors::Common`] is found here, too,
    /// of all motions before any leaves.
    #[must_use]
    pub fn raised(&self, scene: &Scene, suite: &mut Suite, most: Option<f64>) -> Self {
        if self.target().is_none() && most.is_none() {
            return self.clone();
        }
        let scaling = self.with_common_factor(scene, suite);
        scaling.raised_each(scene, suite, most)
    }

    /// Finds the common factor of all motions: of least squares of the logarithms of all their spectra.
    fn with_common_factor(&self, scene: &Scene, suite: &Suite) -> Self {
        let Self::Target(target) = self else {
            return self.clone();
        };
        if target.factors != TargetFactors::Common {
            return self.clone();
        }
        let of_each = Self::Target(SpectrumTarget {
            factors: TargetFactors::Each,
            ..target.clone()
        });
        let logs = parallel::each(&suite.motions, |motion| {
            let (scaled, _) = of_each.applied(scene, motion).ok()?;
            Some(libm::log(scaled.record.scale.abs()))
        });
        let logs: Vec<f64> = logs.into_iter().flatten().collect();
        let factor = libm::exp(logs.iter().sum::<f64>() / logs.len().max(1) as f64);
        Self::Target(SpectrumTarget {
            factors: TargetFactors::Known(factor),
            ..target.clone()
        })
    }

    fn raised_each(&self, scene: &Scene, suite: &mut Suite, most: Option<f64>) -> Self {
        // A motion that cannot be scaled fails in its run, which says why.
        let found = parallel::each(&suite.motions, |motion| {
            let (scaled, spectrum) = self.applied(scene, motion).ok()?;
            let (_, ground) = motion.used_as(&scaled.record, &scene.name).ok()?;
            Some((ground.scale.abs(), spectrum))
        });
        let mut used: Vec<usize> = (0..found.len()).collect();
        let mut dropped = Vec::new();
        let raised = loop {
            let spectra: Vec<&MotionSpectrum> = used.iter().filter_map(|index| found[*index].as_ref()?.1.as_ref()).collect();
            let raised = self.reaching(scene, &spectra);
            let factor = |index: usize| found[index].as_ref().map_or(1.0, |(own, _)| own * raised.raise());
            let (strong, others) = used.iter().partition(|index| most.is_some_and(|most| factor(**index) > most));
            used = others;
            let strong: Vec<usize> = strong;
            if strong.is_empty() {
                break raised;
            }
            dropped.extend(strong.into_iter().map(|index| (index, factor(index))));
        };
        suite.leave_out_scaled(&dropped, most.unwrap_or_default());
        raised
    }

    /// Returns the scaling that raises motions of these spectra to their target.
    fn reaching(&self, scene: &Scene, spectra: &[&MotionSpectrum]) -> Self {
        let fit = self
            .target()
            .and_then(|target| Some((target, TargetFit::of(scene, target, spectra)?)));
        let Some((target, fit)) = fit else {
            return self.clone();
        };
        let (from, _) = fit.least();
        // Rounded up to a per cent, so that the mean certainly has as much.
        let by = (100.0 * TargetFit::LEAST_SHARE / from).ceil() / 100.0;
        if from >= TargetFit::LEAST_SHARE || by > Self::MOST_RAISED || !by.is_finite() {
            return self.clone();
        }
        Self::Raised {
            target: target.clone(),
            by,
            from,
        }
    }
}
