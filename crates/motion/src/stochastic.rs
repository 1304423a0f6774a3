//! Seeded stochastic ground motion by spectral representation.

use std::f64::consts::TAU;

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use crate::band_pass::below_nyquist;
use crate::record::{steps, within};
use crate::{Envelope, GroundFilter, Record, Refused};

/// Random sequence of all seeds; nothing depends on its value.
const STREAM: u128 = 0x0123_4567_89ab_cdef_0011_2233_4455_6677;

/// Largest number of terms × samples: about half a minute of work.
const MOST_PRODUCTS: f64 = 1e10;

/// A ground motion with random phases: noise that the ground has filtered, under an envelope.
///
/// a(t) = e(t) Σ √(4 S(nΔω) Δω) cos(nΔω t + φₙ) for n ≥ 1 up to the cutoff, with Δω = 2π/duration and φₙ uniform over a turn (M. Shinozuka
/// and G. Deodatis, *Appl. Mech. Rev.* 44 (1991) 191). For every seed the variance of a strong part is that of the density S up to the
/// cutoff, and its values are nearly normal. Equal settings and seeds give equal bits on every machine. A shorter time step that divides
/// the duration samples the same motion, except for the final correction and scaling.
///
/// The high-pass filter alone does not bring the ground to rest at the end. An envelope that comes and goes within few periods of the
/// filter leaves a tenth of the peak velocity and more. A straight line times the envelope is therefore subtracted, such that velocity and
/// displacement end at zero. This weakens the motion at periods above the duration of the strong shaking.
///
/// Time grows with samples times terms: 0.03 s for 40 s at 0.005 s up to 25 Hz.
#[derive(Debug, Clone, PartialEq)]
pub struct StochasticMotion {
    /// The ground.
    pub ground: GroundFilter,
    /// Largest magnitude \[m/s²\], ≥ 0, to which every motion is scaled.
    pub peak: f64,
    /// The strength of the motion over time.
    pub envelope: Envelope,
    /// Highest frequency \[Hz\], below half of one over the time step and at least one over the duration; 25 is usual.
    pub cutoff: f64,
    /// Duration \[s\], > 0; frequencies are one over it apart, so several times 2π/`ω_f` resolve the high-pass filter.
    pub duration: f64,
    /// Time between samples \[s\], > 0.
    pub time_step: f64,
    /// Seed of the phases.
    pub seed: u64,
}

impl StochasticMotion {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`Refused`] with the setting, the value found and the values allowed.
    pub fn check(&self) -> Result<(), Refused> {
        self.ground.check()?;
        self.envelope.check()?;
        let peak = self.peak;
        within("peak", peak, peak >= 0.0, "a finite number >= 0 m/s²")?;
        let (cutoff, duration) = (self.cutoff, self.duration);
        within("duration", duration, duration > 0.0, "a number > 0 s")?;
        let whole = steps(duration, self.time_step)? as f64 * self.time_step;
        let allowed = "at least one over the duration (of whole time steps), in Hz";
        within("cutoff", cutoff, cutoff * whole >= 1.0, allowed)?;
        below_nyquist("cutoff", cutoff, self.time_step)?;
        let few = cutoff * duration * (duration / self.time_step) <= MOST_PRODUCTS;
        let allowed = "one for which cutoff × duration × number of samples is at most 1e10";
        within("duration", duration, few, allowed)
    }

    /// Returns the motion as a record.
    ///
    /// # Errors
    /// Those of [`StochasticMotion::check`], and samples that are not finite.
    pub fn record(&self) -> Result<Record, Refused> {
        self.check()?;
        // Any density will do, because the peak is scaled.
        self.shaped(1.0)?.scaled_to_peak(self.peak)
    }

    /// The motion under its envelope, at rest at the end, from white noise of a two-sided spectral density S₀ over circular frequency
    /// \[m²/s³\]. Its peak differs between seeds.
    fn shaped(&self, density: f64) -> Result<Record, Refused> {
        let mut samples = self.stationary(density)?;
        let factor = |step: usize| self.envelope.at(step as f64 * self.time_step);
        let factors: Vec<f64> = (0..samples.len()).map(factor).collect();
        for (sample, factor) in samples.iter_mut().zip(&factors) {
            *sample *= factor;
        }
        let record = Record::new(self.time_step, samples, self.describe())?;
        brought_to_rest(&record, &factors)
    }

    /// One period of the stationary motion \[m/s²\], with its first sample repeated at the end.
    fn stationary(&self, density: f64) -> Result<Vec<f64>, Refused> {
        let n_steps = steps(self.duration, self.time_step)?;
        let period = n_steps as f64 * self.time_step;
        let n_terms = steps(self.cutoff, 1.0 / period)?;
        // Every cosine takes its values from this table: all frequencies are multiples of the lowest.
        let turn = |step: usize| TAU * (step as f64 / n_steps as f64);
        let table: Vec<[f64; 2]> = (0..n_steps).map(|step| [libm::cos(turn(step)), libm::sin(turn(step))]).collect();
        let mut random = Pcg64::new(u128::from(self.seed), STREAM);
        let mut samples = vec![0.0; n_steps];
        let spacing = TAU / period;
        for term in 1..=n_terms {
            let passes = self.ground.passes(term as f64 * spacing);
            let amplitude = (4.0 * density * passes * spacing).sqrt();
            let phase = TAU * uniform(&mut random);
            let [cosine, sine] = [libm::cos(phase), libm::sin(phase)].map(|part| amplitude * part);
            let mut place = 0;
            for sample in &mut samples {
                let [table_cosine, table_sine] = table[place];
                *sample += cosine * table_cosine - sine * table_sine;
                place += term;
                if place >= n_steps {
                    place -= n_steps;
                }
            }
        }
        samples.extend(samples.first().copied());
        Ok(samples)
    }

    fn describe(&self) -> String {
        let ground = &self.ground;
        let Envelope {
            strong_from,
            strong_until,
            decay,
        } = self.envelope;
        format!(
            "stochastic motion, seed {}: ground {} rad/s and {}, high-pass {} rad/s and {}, peak {} m/s², strong from \
             {strong_from} s to {strong_until} s, then decaying at {decay} 1/s, up to {} Hz",
            self.seed,
            ground.angular_frequency,
            ground.damping_ratio,
            ground.high_pass_angular_frequency,
            ground.high_pass_damping_ratio,
            self.peak,
            self.cutoff,
        )
    }
}

/// A uniform number in [0, 1), a multiple of 2⁻⁵³.
fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// The record minus (p + q·t) times weights, with p and q such that velocity and displacement end at zero, to rounding.
///
/// There is one weight ≥ 0 for every sample. If fewer than two are above zero, the record stays unchanged.
fn brought_to_rest(record: &Record, weights: &[f64]) -> Result<Record, Refused> {
    let middle = 0.5 * (weights.len() - 1) as f64;
    let tilted = |(index, weight): (usize, &f64)| weight * (index as f64 - middle);
    let tilted: Vec<f64> = weights.iter().enumerate().map(tilted).collect();
    let end = end_of(record);
    let of_level = end_of(&with(record, weights.to_vec())?);
    let of_tilt = end_of(&with(record, tilted.clone())?);
    let cross = |left: [f64; 2], right: [f64; 2]| left[0] * right[1] - left[1] * right[0];
    let determinant = cross(of_level, of_tilt);
    if determinant == 0.0 {
        return Ok(record.clone());
    }
    let level = cross(end, of_tilt) / determinant;
    let tilt = cross(of_level, end) / determinant;
    let shapes = weights.iter().zip(&tilted);
    let samples = record.samples().iter().zip(shapes);
    let less = |(sample, (weight, tilted))| sample - level * weight - tilt * tilted;
    with(record, samples.map(less).collect())
}

/// Replaces the samples of a record.
fn with(record: &Record, samples: Vec<f64>) -> Result<Record, Refused> {
    Record::new(record.time_step(), samples, record.source())
}

/// Velocity \[m/s\] and displacement \[m\] at the end of a record.
fn end_of(record: &Record) -> [f64; 2] {
    let integrated = record.integrated();
    let last = |values: Vec<f64>| values.last().copied().unwrap_or(0.0);
    [last(integrated.velocity), last(integrated.displacement)]
}

#[cfg(test)]
mod tests;
