//! The mean spectrum of the records that shake a row, compared with the spectrum to which they were scaled.

use pounding_scene::{Scene, Structure};

use crate::scaling::{BETWEEN, MotionSpectrum, SpectrumTarget};

/// The mean spectrum of some motions beside their target, for 5 % of damping.
#[derive(Debug, Clone, PartialEq)]
pub struct TargetFit {
    /// Periods in rising order \[s\], each in the range of the target, or between 0.2 and 2 times the first period of some structure.
    pub periods: Vec<f64>,
    /// Target at these periods \[g\].
    pub target: Vec<f64>,
    /// Mean of the motions at these periods \[g\].
    pub mean: Vec<f64>,
    /// Ratio of the mean peak ground acceleration to the target at period 0 \[–\].
    pub peak_share: f64,
}

impl TargetFit {
    /// Least part of the target that the mean spectrum must reach at every period \[–\]: EN 1998-1, 3.2.3.1.2 (4) c, and ASCE 7-16,
    /// 16.2.3.2.
    pub const LEAST_SHARE: f64 = 0.9;

    /// Compares the motions that shake a scene with their target; `None` if there are no motions or no periods.
    pub fn of(scene: &Scene, target: &SpectrumTarget, spectra: &[&MotionSpectrum]) -> Option<Self> {
        let n = spectra.len() as f64;
        let gravity = scene.record.gravity_m_per_s2;
        let structures = || scene.structures.iter().filter_map(Structure::longest_period);
        let counts = |period: f64| {
            let [from, to] = BETWEEN;
            // Rounding must not lose the ends of the range.
            target.periods.is_some() || structures().any(|own| period > from * own * (1.0 - 1e-9) && period < to * own * (1.0 + 1e-9))
        };
        let periods = target.checked_periods(scene).into_iter().enumerate();
        let counted: Vec<(usize, f64)> = periods.filter(|(_, period)| counts(*period)).collect();
        let mean = |index: usize| {
            let values = spectra.iter().map(|one| one.accelerations[index]);
            values.sum::<f64>() / n / gravity
        };
        let peak = spectra.iter().map(|one| one.peak).sum::<f64>() / n / gravity;
        (!spectra.is_empty() && !counted.is_empty()).then(|| Self {
            periods: counted.iter().map(|(_, period)| *period).collect(),
            target: counted.iter().map(|(_, period)| target.spectrum.acceleration(*period)).collect(),
            mean: counted.iter().map(|(index, _)| mean(*index)).collect(),
            peak_share: peak / target.spectrum.acceleration(0.0),
        })
    }

    /// Returns the least part of the target that the mean spectrum reaches \[–\], and its period \[s\].
    pub fn least(&self) -> (f64, f64) {
        let shares = self.mean.iter().zip(&self.target);
        let shares = shares.map(|(mean, target)| mean / target);
        let all = shares.zip(self.periods.iter().copied());
        let least = all.min_by(|one, other| one.0.total_cmp(&other.0));
        least.unwrap_or((1.0, 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::DesignSpectrum;

    /// Structures of 4 s, from 0.8 to 8 s, and of 0.1 s, from 0.02 to 0.2 s.
    const SCENE: &str = r#"{
        "name": "two",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}},
                   "gravity_m_per_s2": 10.0},
        "structures": [
            {"sdof": {"name": "left", "mass_kg": 1e5, "period_s": 4.0, "damping": {"ratio": 0.05}}},
            {"sdof": {"name": "right", "mass_kg": 1e5, "period_s": 0.1, "damping": {"ratio": 0.05}}}
        ]
    }"#;

    fn flat(peak: f64, value: f64, scene: &Scene, target: &SpectrumTarget) -> MotionSpectrum {
        MotionSpectrum {
            peak,
            periods: target.checked_periods(scene),
            accelerations: vec![value; target.checked_periods(scene).len()],
        }
    }

    /// EN 1998-1, 3.2.3.1.2 (4): the mean of 2 and 4 m/s² is 0.3 g; a plateau of 0.4 g leaves three quarters of it.
    #[test]
    fn reference_the_mean_spectrum_is_held_against_the_target() {
        let scene: Scene = serde_json::from_str(SCENE).expect("a scene");
        let target = SpectrumTarget::from(DesignSpectrum::Table(vec![[0.0, 0.2], [0.02, 0.4], [10.0, 0.4]]));
        let motions = [flat(1.0, 2.0, &scene, &target), flat(3.0, 4.0, &scene, &target)];
        let all: Vec<&MotionSpectrum> = motions.iter().collect();
        let fit = TargetFit::of(&scene, &target, &all).expect("two motions");
        let (share, _) = fit.least();
        assert!((share - 0.75).abs() < 1e-12, "{share}");
        assert!((fit.peak_share - 1.0).abs() < 1e-12, "{}", fit.peak_share);
        assert_eq!(TargetFit::of(&scene, &target, &[]), None);
    }

    /// The least part of thirty periods was 79 %, and at other periods it was 78 %. Here the target doubles within one per cent of a
    /// period, so that the mean reaches half of it.
    #[test]
    fn issue_the_least_share_is_that_of_all_periods() {
        let scene: Scene = serde_json::from_str(SCENE).expect("a scene");
        let narrow = [[0.0, 0.1], [3.0, 0.1], [3.01, 0.2], [3.02, 0.1], [10.0, 0.1]];
        let target = SpectrumTarget::from(DesignSpectrum::Table(narrow.to_vec()));
        let motion = flat(1.0, 1.0, &scene, &target);
        let fit = TargetFit::of(&scene, &target, &[&motion]).expect("a motion");
        let (share, period) = fit.least();
        assert!((share - 0.5).abs() < 1e-12, "{share} at {period} s");
        // Adjacent periods differ by one per cent at most.
        let close = |two: &[f64]| two[1] < 1.0101 * two[0] || (two[0] < 0.21 && two[1] > 0.79);
        assert!(fit.periods.windows(2).all(close), "{:?}", fit.periods);
    }

    /// Periods between the ranges of two structures, whose periods differ by a factor of forty, do not count.
    #[test]
    fn limit_periods_of_no_structure_do_not_count() {
        let scene: Scene = serde_json::from_str(SCENE).expect("a scene");
        let target = SpectrumTarget::from(DesignSpectrum::Table(vec![[0.0, 0.1]]));
        let motion = flat(1.0, 1.0, &scene, &target);
        let fit = TargetFit::of(&scene, &target, &[&motion]).expect("a motion");
        let between = |period: &&f64| (0.201..0.799).contains(*period);
        assert_eq!(fit.periods.iter().find(between), None);
        assert!(fit.periods.len() > 10, "{}", fit.periods.len());
    }
}
