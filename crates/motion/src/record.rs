//! The ground acceleration that shakes structures.

use crate::Refused;
use pounding_text::plain;

/// Largest distance from a sample at which a time still counts as that sample's \[time steps\].
///
/// The quotient of two decimal numbers misses a whole number by a few parts in 10¹⁶. Hence 10⁻⁹ suffices for records of some millions of
/// samples, and it is far below any measured interval.
const COINCIDENCE: f64 = 1e-9;

/// Largest number of samples, for files, resampling and formulas: 80 MB, in a few copies per run.
pub(crate) const MAX_SAMPLES: usize = 10_000_000;

/// A `Record` is a uniformly sampled ground acceleration \[m/s²\] with its origin.
///
/// The first sample is at t = 0. The acceleration is linear between samples, and zero before the first and after the last. There is at
/// least one sample, and all are at most [`Record::STRONGEST`].
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    time_step: f64,
    samples: Vec<f64>,
    source: String,
}

impl Record {
    /// Largest magnitude of a sample \[m/s²\]: a hundred million g, far above any ground motion. Integrals of squares of much larger values
    /// overflow, and an infinite measure says nothing.
    pub const STRONGEST: f64 = 1e9;
    /// Longest time between two samples \[s\], eleven days: longer ones would overflow like [`Self::STRONGEST`].
    pub const LONGEST_STEP: f64 = 1e6;

    /// Makes a record of accelerations \[m/s²\] that are `time_step` \[s\] apart.
    ///
    /// `source` describes the origin in any words.
    ///
    /// # Errors
    /// Refuses an empty list, a sample beyond [`Self::STRONGEST`], and a time step that is not above zero and up to
    /// [`Self::LONGEST_STEP`].
    pub fn new(time_step: f64, samples: Vec<f64>, source: impl Into<String>) -> Result<Self, Refused> {
        checked_step(time_step)?;
        if samples.is_empty() {
            return Err(Refused::default().found("no sample").allowed_is("at least one sample"));
        }
        // NaN is not within bounds either.
        let is_ground = |sample: &f64| sample.abs() <= Self::STRONGEST;
        if let Some(index) = samples.iter().position(|sample| !is_ground(sample)) {
            let found = samples[index];
            let said = format!("the acceleration of sample {index} (the first is 0) is {} m/s²", plain(found));
            let said = Refused::that(said).allowed_are(format!("up to {:e} m/s² either way", Self::STRONGEST));
            return Err(said.help("correct its unit or its factor"));
        }
        let source = source.into();
        Ok(Self {
            time_step,
            samples,
            source,
        })
    }

    /// Returns the time between two samples \[s\], above zero.
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// Returns the ground acceleration at t = 0, Δt, 2Δt, … \[m/s²\].
    pub fn samples(&self) -> &[f64] {
        &self.samples
    }

    /// Returns the origin of the record: the comments or title lines of its file.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Returns the time of the last sample \[s\], zero for a single one.
    pub fn duration(&self) -> f64 {
        (self.samples.len() - 1) as f64 * self.time_step
    }

    /// Returns the ground acceleration \[m/s²\] at a time \[s\]: linear between samples, zero
    /// outside.
    ///
    /// A time within 10⁻⁹ of a step from a sample gives that sample exactly. A time that is NaN
    /// gives NaN.
    pub fn at(&self, time: f64) -> f64 {
        let position = time / self.time_step;
        let nearest = position.round();
        let position = if (position - nearest).abs() <= COINCIDENCE {
            nearest
        } else {
            position
        };
        if position < 0.0 || position > (self.samples.len() - 1) as f64 {
            return 0.0;
        }
        let index = whole(position);
        let left = self.samples[index];
        // The last sample needs no right neighbour: its fraction is zero.
        let right = self.samples.get(index + 1).copied().unwrap_or(left);
        left + (right - left) * (position - position.floor())
    }

    /// Returns the record sampled every `time_step` \[s\], linear between the samples of this one.
    ///
    /// Grid points that coincide with a sample take it exactly: an integer fraction of the step changes no value. A longer step skips
    /// peaks, and no filter prevents aliasing. The rest after the last grid point inside the record, which is shorter than a new step, is
    /// dropped.
    ///
    /// # Errors
    /// Refuses a time step that is not finite and above zero, or that needs more than 10⁷ samples.
    pub fn resampled(&self, time_step: f64) -> Result<Self, Refused> {
        let samples = (0..=steps(self.duration(), time_step)?)
            .map(|step| self.at(step as f64 * time_step))
            .collect();
        Self::new(time_step, samples, self.source.clone())
    }

    /// Returns the record with every acceleration multiplied by `factor`, which may be negative or
    /// zero.
    ///
    /// # Errors
    /// Refuses a factor that is not finite, or one that makes a sample so.
    pub fn scaled(&self, factor: f64) -> Result<Self, Refused> {
        if !factor.is_finite() {
            let found = Refused::default().found(format!("a factor of {}", plain(factor)));
            let found = found.allowed_is("a finite one");
            return Err(found.help("take a lower target, or a stronger motion"));
        }
        let samples = self.samples.iter().map(|sample| factor * sample).collect();
        Self::new(self.time_step, samples, self.source.clone())
    }

    /// Returns the record with its samples `factor` times as far apart: slower above 1, faster below.
    ///
    /// # Errors
    /// Refuses a factor that makes the time step zero, negative or NaN.
    pub fn stretched(&self, factor: f64) -> Result<Self, Refused> {
        let time_step = factor * self.time_step;
        Self::new(time_step, self.samples.clone(), self.source.clone())
    }

    /// Returns the record with every acceleration multiplied by one factor ≥ 0, such that the largest magnitude is `target` \[m/s²\], ≥ 0,
    /// up to rounding.
    ///
    /// # Errors
    /// Refuses a target that is negative or not finite, and a record of zeros.
    pub fn scaled_to_peak(&self, target: f64) -> Result<Self, Refused> {
        let allowed = "a finite number >= 0 m/s²";
        within("target", target, target >= 0.0, allowed)?;
        let peak = self.peak().1.abs();
        if peak == 0.0 {
            return Err(at_rest());
        }
        self.scaled(target / peak)
    }

    /// Returns the record with the sign of every acceleration changed: the shaking in the opposite direction.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let samples = self.samples.iter().map(|sample| -sample).collect();
        Self { samples, ..self.clone() }
    }

    /// Returns the time \[s\] and the signed value \[m/s²\] of the largest absolute acceleration.
    ///
    /// Of several equal ones it is the first.
    pub fn peak(&self) -> (f64, f64) {
        let mut peak = (0, self.samples[0]);
        for (index, &sample) in self.samples.iter().enumerate() {
            if sample.abs() > peak.1.abs() {
                peak = (index, sample);
            }
        }
        (peak.0 as f64 * self.time_step, peak.1)
    }
}

/// The number of whole time steps \[s\] in a finite duration ≥ 0 \[s\].
///
/// # Errors
/// Refuses a time step that is not finite and above zero, or more steps than fit in memory.
pub(crate) fn steps(duration: f64, time_step: f64) -> Result<usize, Refused> {
    checked_step(time_step)?;
    let steps = (duration / time_step + COINCIDENCE).floor();
    if steps >= MAX_SAMPLES as f64 {
        let duration = plain(duration);
        let found = format!("{time_step:?} s, which over {duration} s makes more than {MAX_SAMPLES} samples");
        return Err(Refused::at("time_step").found(found).allowed_is("a longer step"));
    }
    Ok(whole(steps))
}

/// Refuses a setting that is not finite or not valid.
pub(crate) fn within(setting: &'static str, found: f64, valid: bool, allowed: &'static str) -> Result<(), Refused> {
    if valid && found.is_finite() {
        Ok(())
    } else {
        Err(Refused::at(setting).found(plain(found)).allowed(allowed))
    }
}

/// The refusal to scale a motion at rest.
pub fn at_rest() -> Refused {
    let found = Refused::default().found("a motion without any acceleration");
    found.allowed_is("one that a factor can scale").help("take another")
}

fn checked_step(time_step: f64) -> Result<(), Refused> {
    if time_step > 0.0 && time_step <= Record::LONGEST_STEP {
        Ok(())
    } else {
        let found = Refused::at("time_step").found(format!("{} s", plain(time_step)));
        let allowed = format!("more than 0 s and up to {:e} s", Record::LONGEST_STEP);
        Err(found.allowed_are(allowed).help("correct it"))
    }
}

/// The whole part of a number of time steps; negative numbers and NaN give 0.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "callers have bounded the number; the cast saturates and never panics"
)]
fn whole(steps: f64) -> usize {
    steps as usize
}
