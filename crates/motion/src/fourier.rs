//! The discrete Fourier transform. A crate for it takes sines from the platform; this one has the same bits on every machine.

use std::f64::consts::TAU;

use crate::Record;

/// The discrete Fourier transform of 2ⁿ numbers, in place (J. W. Cooley and J. W. Tukey, 1965).
pub(crate) fn transform(terms: &mut [[f64; 2]]) {
    let length = terms.len();
    if length < 2 {
        return;
    }
    let unused = usize::BITS - length.trailing_zeros();
    for index in 0..length {
        let other = index.reverse_bits() >> unused;
        if index < other {
            terms.swap(index, other);
        }
    }
    let turns: Vec<[f64; 2]> = (0..length / 2)
        .map(|index| TAU * (index as f64 / length as f64))
        .map(|angle| [libm::cos(angle), -libm::sin(angle)])
        .collect();
    let mut half = 1;
    while half < length {
        let stride = length / (2 * half);
        for block in terms.chunks_exact_mut(2 * half) {
            let (left, right) = block.split_at_mut(half);
            for ((one, other), turn) in left.iter_mut().zip(right).zip(turns.iter().step_by(stride)) {
                let turned = [other[0] * turn[0] - other[1] * turn[1], other[0] * turn[1] + other[1] * turn[0]];
                *other = [one[0] - turned[0], one[1] - turned[1]];
                *one = [one[0] + turned[0], one[1] + turned[1]];
            }
        }
        half *= 2;
    }
}

/// The sum of harmonics whose [`transform`] this is, in place.
pub(crate) fn inverse(terms: &mut [[f64; 2]]) {
    // The conjugate of the transform of the conjugate.
    let length = terms.len() as f64;
    for term in terms.iter_mut() {
        term[1] = -term[1];
    }
    transform(terms);
    for term in terms.iter_mut() {
        *term = [term[0] / length, -term[1] / length];
    }
}

impl Record {
    /// Fourier amplitude |Δt Σ a exp(−2πi f t)| \[m/s\] of the samples at a frequency f ≥ 0 \[Hz\]. Frequencies above half the sampling
    /// rate mirror those below it.
    pub fn fourier_amplitude(&self, frequency: f64) -> f64 {
        let mut sum = [0.0; 2];
        for (index, sample) in self.samples().iter().enumerate() {
            // Whole turns are taken off before π enters.
            let (sine, cosine) = libm::sincos(TAU * (frequency * self.time_step() * index as f64).fract());
            sum[0] += sample * cosine;
            sum[1] += sample * sine;
        }
        self.time_step() * libm::hypot(sum[0], sum[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_the_transform_is_the_sum_of_its_definition() {
        let numbers = [1.0, -2.0, 0.5, 3.0, 0.0, -1.5, 2.5, 4.0].map(|number| [number, 0.25]);
        let mut fast = numbers;
        transform(&mut fast);
        for (index, found) in fast.iter().enumerate() {
            let mut sum = [0.0; 2];
            for (other, number) in numbers.iter().enumerate() {
                let angle = TAU * (index * other % 8) as f64 / 8.0;
                let (cosine, sine) = (libm::cos(angle), libm::sin(angle));
                sum[0] += number[0] * cosine + number[1] * sine;
                sum[1] += number[1] * cosine - number[0] * sine;
            }
            let apart = (found[0] - sum[0]).abs() + (found[1] - sum[1]).abs();
            assert!(apart < 1e-13, "{index}: {found:?}, {sum:?}");
        }
    }

    #[test]
    fn limit_the_inverse_returns_the_numbers() {
        let numbers = [1.0, -2.0, 0.5, 3.0, 0.0, -1.5, 2.5, 4.0].map(|number| [number, 0.25 - number]);
        let mut both = numbers;
        transform(&mut both);
        inverse(&mut both);
        for (found, number) in both.iter().zip(numbers) {
            assert!((found[0] - number[0]).abs() + (found[1] - number[1]).abs() < 1e-14, "{both:?}");
        }
    }

    /// A half sine of amplitude A and duration d has |F| = 2 A b cos(π f d) / (b² − ω²), b = π/d; its samples add O(Δt²).
    #[test]
    fn reference_amplitudes_of_a_half_sine() {
        let (amplitude, duration, n) = (2.5, 0.4, 4000);
        let step = duration / f64::from(n);
        let samples = (0..=n).map(|index| amplitude * libm::sin(std::f64::consts::PI * f64::from(index) / f64::from(n)));
        let record = Record::new(step, samples.collect(), "").expect("a record");
        let b = std::f64::consts::PI / duration;
        for frequency in [0.0, 0.7, 2.0, 5.5] {
            let omega = TAU * frequency;
            let wanted = (2.0 * amplitude * b * libm::cos(0.5 * omega * duration) / (b * b - omega * omega)).abs();
            let found = record.fourier_amplitude(frequency);
            assert!((found - wanted).abs() < 1e-6, "{frequency}: {found} against {wanted}");
        }
    }

    #[test]
    fn limit_amplitudes_are_those_of_the_transform() {
        let samples: Vec<f64> = (0..64).map(|index| f64::from(index * 37 % 64) - 30.0).collect();
        let record = Record::new(0.02, samples.clone(), "").expect("a record");
        let mut terms: Vec<[f64; 2]> = samples.iter().map(|one| [*one, 0.0]).collect();
        transform(&mut terms);
        for (index, [real, imaginary]) in terms.iter().enumerate().take(33) {
            let found = record.fourier_amplitude(index as f64 / (64.0 * 0.02));
            assert!((found - 0.02 * libm::hypot(*real, *imaginary)).abs() < 1e-12, "{index}: {found}");
        }
    }
}
