//! The motion between samples: the band-limited one in place of straight lines.
//!
//! A record of a motion that holds nothing above half its sampling rate determines that motion (Whittaker, Shannon): it is the sum of a sinc at
//! every sample. Straight lines between the samples keep sinc²(fΔt) of a frequency f, and add images of it at 1/Δt ± f.

use crate::fourier::{inverse, transform};
use crate::record::MAX_SAMPLES;
use crate::{Record, Refused};

/// Root mean square error of straight lines between the finer samples, relative to the motion \[–\]: half a unit of the third digit.
const STRAIGHT: f64 = 5e-4;
/// Largest number of finer samples for each sample; at half the sampling rate it leaves an error of 2e-4.
const FINEST: usize = 64;
/// Part of the peak from which a first or last sample is a jump that rings \[–\].
const JUMP: f64 = 0.02;

impl Record {
    /// Returns the band-limited motion through the samples, sampled so finely that straight lines keep it within 0.05 % (root mean square).
    ///
    /// Every sample stays, and a whole number of samples, a power of two, comes after each. The motion is zero before the first sample and
    /// after the last, where it also rings if the record [jumps](Self::jumps) there. The transform has a period of at least twice the record.
    ///
    /// # Errors
    /// Refuses a record that needs more than 10⁷ finer samples.
    pub fn band_limited(&self) -> Result<Self, Refused> {
        let samples = self.samples();
        let n_padded = (2 * samples.len()).next_power_of_two();
        let mut spectrum: Vec<[f64; 2]> = samples.iter().map(|&sample| [sample, 0.0]).collect();
        spectrum.resize(n_padded, [0.0; 2]);
        transform(&mut spectrum);
        let factor = factor(&spectrum);
        let n_finer = (samples.len() - 1) * factor + 1;
        if n_finer > MAX_SAMPLES {
            let found = Refused::at("interpolation").found(format!("band_limited, which needs {n_finer} samples"));
            return Err(found
                .allowed(format!("up to {MAX_SAMPLES}"))
                .help("shorten the record, or take \"linear\""));
        }
        let mut values = finer(&spectrum, factor);
        values.truncate(n_finer);
        // The transform returns samples with its rounding.
        for (index, sample) in samples.iter().enumerate() {
            values[index * factor] = *sample;
        }
        Self::new(self.time_step() / factor as f64, values, self.source())
    }

    /// Returns the larger of the first and the last acceleration as a part of the peak, if it is a jump from rest: a band-limited motion rings
    /// there. `None` if the record begins and ends near zero.
    pub fn jumps(&self) -> Option<f64> {
        let (_, peak) = self.peak();
        let samples = self.samples();
        let end = samples[0].abs().max(samples[samples.len() - 1].abs());
        (end > JUMP * peak.abs()).then(|| end / peak.abs())
    }
}

/// Least power of two of samples for each sample, such that straight lines between them keep the motion of this spectrum.
fn factor(spectrum: &[[f64; 2]]) -> usize {
    let n = spectrum.len();
    // The upper half of the spectrum is that of negative frequencies.
    let powers = || {
        (0..=n / 2).map(|k| {
            let [real, imaginary] = spectrum[k];
            (k as f64 / n as f64, real * real + imaginary * imaginary)
        })
    };
    let all: f64 = powers().map(|(_, power)| power).sum();
    let mut factor = 1;
    loop {
        let lost = powers().map(|(cycles, power)| {
            let part = lost(cycles / factor as f64);
            power * part * part
        });
        if lost.sum::<f64>() <= STRAIGHT * STRAIGHT * all || factor == FINEST {
            return factor;
        }
        factor *= 2;
    }
}

/// What straight lines lose of a frequency, 1 − sinc². `cycles` is its number of cycles from sample to sample.
fn lost(cycles: f64) -> f64 {
    let angle = std::f64::consts::PI * cycles;
    let sinc = if angle == 0.0 { 1.0 } else { libm::sin(angle) / angle };
    1.0 - sinc * sinc
}

/// The motion of a spectrum, at `factor` instants for each sample.
fn finer(spectrum: &[[f64; 2]], factor: usize) -> Vec<f64> {
    let n = spectrum.len();
    let mut finer = vec![[0.0; 2]; factor * n];
    finer[..n / 2].copy_from_slice(&spectrum[..n / 2]);
    let negative = factor * n - n / 2;
    finer[negative..].copy_from_slice(&spectrum[n / 2..]);
    if factor > 1 {
        // Half the sampling rate is a positive and a negative frequency.
        let half = spectrum[n / 2].map(|part| 0.5 * part);
        (finer[n / 2], finer[negative]) = (half, half);
    }
    inverse(&mut finer);
    finer.into_iter().map(|[real, _]| factor as f64 * real).collect()
}
