//! The discrete Fourier transform. A crate for it takes sines from the platform; this one has the same bits on every machine.

use std::f64::consts::TAU;

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
}
