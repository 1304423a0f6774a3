//! Harmonic ground motion.

use std::f64::consts::{PI, TAU};

use crate::band_pass::below_nyquist;
use crate::record::{steps, within};
use crate::{Record, Refused};

/// A harmonic ground acceleration A·sin(2πft + φ) with optional ramps at its start and end.
///
/// Between samples the record is linear. This reduces its amplitude by up to (πfΔt)²/2 of itself: 1.2 % at twenty samples per period.
#[derive(Debug, Clone, PartialEq)]
pub struct Harmonic {
    /// Amplitude A \[m/s²\], finite; a negative one shifts the phase by half a period.
    pub amplitude: f64,
    /// Frequency f \[Hz\], > 0 and below half of one over the time step.
    pub frequency: f64,
    /// Phase φ at t = 0 \[rad\], finite; 0 starts from zero acceleration, upwards.
    pub phase: f64,
    /// Number of periods \[–\], ≥ 0, in which the amplitude rises from zero, and falls to zero before the end, like (1 − cos)/2.
    ///
    /// A motion that starts and ends abruptly (0) leaves the ground with a velocity.
    pub ramp_periods: f64,
    /// Duration \[s\], ≥ 0, at least both ramps.
    pub duration: f64,
    /// Time between samples \[s\], > 0.
    pub time_step: f64,
}

impl Harmonic {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`Refused`] with the setting, the value found and the values allowed.
    pub fn check(&self) -> Result<(), Refused> {
        within("amplitude", self.amplitude, true, "a finite number of m/s²")?;
        within("phase", self.phase, true, "a finite number of rad")?;
        let frequency = self.frequency;
        within("frequency", frequency, frequency > 0.0, "a number > 0 Hz")?;
        let duration = self.duration;
        within("duration", duration, duration >= 0.0, "a number >= 0 s")?;
        steps(duration, self.time_step)?;
        below_nyquist("frequency", frequency, self.time_step)?;
        let fits = self.ramp_periods >= 0.0 && 2.0 * self.ramp() <= duration;
        let allowed = "a number >= 0, such that two ramps fit into the duration";
        within("ramp_periods", self.ramp_periods, fits, allowed)
    }

    /// Returns the motion as a record.
    ///
    /// # Errors
    /// Those of [`Harmonic::check`].
    pub fn record(&self) -> Result<Record, Refused> {
        self.check()?;
        let sample = |step: usize| {
            let time = step as f64 * self.time_step;
            let angle = TAU * (self.frequency * time) + self.phase;
            self.amplitude * self.rise(time) * self.rise(self.duration - time) * libm::sin(angle)
        };
        let samples = (0..=steps(self.duration, self.time_step)?).map(sample).collect();
        let source = format!(
            "harmonic motion: {} m/s² at {} Hz, phase {} rad, ramps of {} periods",
            self.amplitude, self.frequency, self.phase, self.ramp_periods
        );
        Record::new(self.time_step, samples, source)
    }

    /// Duration of a ramp \[s\].
    fn ramp(&self) -> f64 {
        self.ramp_periods / self.frequency
    }

    /// Share of the amplitude some time \[s\] after zero.
    fn rise(&self, time: f64) -> f64 {
        // Rounding may put the last sample behind the end, and a ramp may have no length.
        let time = time.max(0.0);
        if time >= self.ramp() {
            1.0
        } else {
            0.5 - 0.5 * libm::cos(PI * time / self.ramp())
        }
    }
}
