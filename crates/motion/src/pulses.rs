//! Single pulses of ground acceleration.

use std::f64::consts::PI;

use crate::band_pass::below_nyquist;
use crate::record::{steps, within};
use crate::{Record, Refused};

/// Half the duration of a Ricker pulse, in periods of its peak frequency; the cut tails have 1e-8 of its peak.
const RICKER_REACH: f64 = 1.5;

/// A Ricker pulse A (1 − 2x²) exp(−x²) with x = πf(t − t₀), after which the ground is at rest at its initial position.
///
/// It starts at t = 0 with 1e-8 of its peak. The peak is on the first sample at or after t₀ = 1.5/f, and the pulse is symmetric about it.
/// Source: N. Ricker, *Geophysics* 18 (1953) 10.
#[derive(Debug, Clone, PartialEq)]
pub struct RickerPulse {
    /// Signed peak A \[m/s²\], finite.
    pub amplitude: f64,
    /// Frequency f of the peak of its Fourier spectrum \[Hz\], > 0 and below half of one over the time step.
    pub frequency: f64,
    /// Time between samples \[s\], > 0.
    pub time_step: f64,
}

impl RickerPulse {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`Refused`] with the setting, the value found and the values allowed.
    pub fn check(&self) -> Result<(), Refused> {
        let frequency = self.frequency;
        within("amplitude", self.amplitude, true, "a finite number of m/s²")?;
        within("frequency", frequency, frequency > 0.0, "a number > 0 Hz")?;
        steps(2.0 * RICKER_REACH / frequency, self.time_step)?;
        below_nyquist("frequency", frequency, self.time_step)
    }

    /// Returns the pulse as a record.
    ///
    /// # Errors
    /// Those of [`RickerPulse::check`].
    pub fn record(&self) -> Result<Record, Refused> {
        self.check()?;
        let half = cover(RICKER_REACH / self.frequency, self.time_step)?;
        let sample = |step: usize| {
            let x = PI * self.frequency * (step.abs_diff(half) as f64 * self.time_step);
            self.amplitude * (1.0 - 2.0 * x * x) * libm::exp(-x * x)
        };
        let source = format!("Ricker pulse: {} m/s² at {} Hz", self.amplitude, self.frequency);
        Record::new(self.time_step, (0..=2 * half).map(sample).collect(), source)
    }
}

/// Half a period of a sine: A·sin(πt/d) for t ≤ d, then zero. The ground keeps the velocity 2Ad/π.
///
/// The last sample, 0 m/s², is the first at or after d.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfSinePulse {
    /// Signed peak A \[m/s²\], finite.
    pub amplitude: f64,
    /// Duration d \[s\], > 0, at least two time steps.
    pub duration: f64,
    /// Time between samples \[s\], > 0.
    pub time_step: f64,
}

impl HalfSinePulse {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`Refused`] with the setting, the value found and the values allowed.
    pub fn check(&self) -> Result<(), Refused> {
        within("amplitude", self.amplitude, true, "a finite number of m/s²")?;
        let duration = self.duration;
        within("duration", duration, duration > 0.0, "a number > 0 s")?;
        let long_enough = steps(duration, self.time_step)? >= 2;
        let allowed = "at least two time steps; shorten the time step";
        within("duration", duration, long_enough, allowed)
    }

    /// Returns the pulse as a record.
    ///
    /// # Errors
    /// Those of [`HalfSinePulse::check`].
    pub fn record(&self) -> Result<Record, Refused> {
        self.check()?;
        let last = cover(self.duration, self.time_step)?;
        let sample = |step: usize| {
            // The sine of a rounded π would not be zero.
            if step == last {
                return 0.0;
            }
            self.amplitude * libm::sin(PI * (step as f64 * self.time_step / self.duration))
        };
        let source = format!("half-sine pulse: {} m/s² over {} s", self.amplitude, self.duration);
        Record::new(self.time_step, (0..=last).map(sample).collect(), source)
    }
}

/// The number of time steps that cover a duration.
fn cover(duration: f64, time_step: f64) -> Result<usize, Refused> {
    let whole = steps(duration, time_step)?;
    let reached = whole as f64 * time_step >= duration * (1.0 - f64::EPSILON);
    Ok(if reached { whole } else { whole + 1 })
}
