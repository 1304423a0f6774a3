//! The mean period of a ground motion: its frequency content in one number.

use crate::Record;
use crate::fourier::transform;

/// Band of frequencies that count \[Hz\].
const BAND: [f64; 2] = [0.25, 20.0];

/// Largest distance of two frequencies \[Hz\].
const SPACING: f64 = 0.05;

impl Record {
    /// Returns the mean period Tm = Σ C²/f / Σ C² \[s\] over the Fourier amplitudes C of the samples at frequencies f of 0.25 to 20 Hz.
    /// `None` if all are zero, or so large that their squares are not finite.
    ///
    /// Zeros are appended until the frequencies are at most 0.05 Hz apart. Source: E. M. Rathje, N. A. Abrahamson and J. D. Bray, *J.
    /// Geotech. Geoenviron. Eng.* 124 (1998) 150. Time grows with the number of samples: 1 ms for 4 000 of them.
    pub fn mean_period(&self) -> Option<f64> {
        let n_least = 1.0 / (SPACING * self.time_step());
        let mut length = self.samples().len().next_power_of_two();
        // If the step is so short that the length would exceed a hundred million, the record itself has enough samples.
        while (length as f64) < n_least && length < 1 << 27 {
            length *= 2;
        }
        let mut terms: Vec<[f64; 2]> = self.samples().iter().map(|&a| [a, 0.0]).collect();
        terms.resize(length, [0.0; 2]);
        transform(&mut terms);
        let spacing = 1.0 / (length as f64 * self.time_step());
        let (mut over, mut under) = (0.0, 0.0);
        for (index, [real, imaginary]) in terms.iter().enumerate().take(length / 2 + 1) {
            let frequency = index as f64 * spacing;
            if (BAND[0]..=BAND[1]).contains(&frequency) {
                let square = real * real + imaginary * imaginary;
                over += square / frequency;
                under += square;
            }
        }
        (under > 0.0 && under.is_finite()).then_some(over / under)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Harmonic;

    #[test]
    fn reference_a_long_sine_has_its_own_period() {
        let harmonic = Harmonic {
            amplitude: 1.0,
            frequency: 0.8,
            phase: 0.0,
            ramp_periods: 10.0,
            duration: 100.0,
            time_step: 0.01,
        };
        let record = harmonic.record().expect("a record");
        let found = record.mean_period().expect("a motion");
        assert!((found - 1.25).abs() < 2e-3, "{found}");
        let scaled = record.scaled(-3.0).expect("a record");
        let other = scaled.mean_period().expect("a motion");
        assert!((found - other).abs() < 1e-14, "no matter how strong: {other}");
    }

    #[test]
    fn extreme_motions_without_a_mean_period() {
        let mean = |time_step, samples| {
            let record = Record::new(time_step, samples, "").expect("a record");
            record.mean_period()
        };
        assert_eq!(mean(0.01, vec![0.0; 300]), None, "nothing moves");
        assert_eq!(mean(10.0, vec![1.0, -1.0, 1.0]), None, "samples too far apart");
        let single = mean(0.01, vec![1.0]).expect("a shock has all frequencies alike");
        // ∫ df/f over the band divided by its width; the sum ends up to 0.05 Hz inside the band.
        assert!((single - libm::log(80.0) / 19.75).abs() < 5e-3, "{single}");
    }
}
