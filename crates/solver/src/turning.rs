//! Turns inside a span of a motion given as series.

use crate::roots::{CAPACITY, first_root, shift};

/// Calls `each` for every x between the first and the last at which a polynomial changes sign, in ascending order.
///
/// The search uses bounds, so that no two changes are missed.
pub(crate) fn sign_changes(coefficients: &[f64], [first, last]: [f64; 2], mut each: impl FnMut(f64)) {
    let mut local = [0.0; CAPACITY];
    let local = &mut local[..coefficients.len()];
    local.copy_from_slice(coefficients);
    shift(local, first);
    let mut origin = first;
    // A polynomial has at most as many zeros as coefficients.
    for _ in 0..coefficients.len() {
        if local.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0) {
            for coefficient in local.iter_mut() {
                *coefficient = -*coefficient;
            }
        }
        let Some(x) = first_root(local, last - origin) else {
            return;
        };
        origin += x;
        if origin >= last {
            return;
        }
        each(origin);
        shift(local, x);
        // The rounding of this zero is not another zero.
        local[0] = 0.0;
    }
}

/// Bound of the sum of all terms of a polynomial except the first, on 0 ..= x.
pub(crate) fn reach(coefficients: impl DoubleEndedIterator<Item = f64>, x: f64) -> f64 {
    coefficients.rev().fold(0.0, |sum, c| (sum + c.abs()) * x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(coefficients: &[f64], range: [f64; 2]) -> Vec<f64> {
        let mut all = Vec::new();
        sign_changes(coefficients, range, |x| all.push(x));
        all
    }

    /// (x − 1)(x − 2)(x − 3), and squares, which touch zero without a change of sign.
    #[test]
    fn reference_zeros_of_known_polynomials() {
        let cubic = [-6.0, 11.0, -6.0, 1.0];
        let close = |found: &[f64], wanted: &[f64]| {
            assert_eq!(found.len(), wanted.len(), "{found:?}, {wanted:?}");
            for (found, wanted) in found.iter().zip(wanted) {
                assert!((found - wanted).abs() < 1e-14, "{found}, {wanted}");
            }
        };
        close(&found(&cubic, [0.0, 4.0]), &[1.0, 2.0, 3.0]);
        close(&found(&cubic.map(|c| -c), [0.0, 4.0]), &[1.0, 2.0, 3.0]);
        close(&found(&cubic, [1.5, 2.5]), &[2.0]);
        close(&found(&cubic, [0.0, 0.5]), &[]);
        // Two changes of sign between ends of the same sign.
        close(&found(&[0.1875, -1.0, 1.0], [0.0, 1.0]), &[0.25, 0.75]);
        close(&found(&[0.0, 1.0], [0.0, 1.0]), &[]);
        close(&found(&[0.0; 4], [0.0, 1.0]), &[]);
    }

    #[test]
    fn limit_no_value_is_beyond_the_reach() {
        let coefficients = [0.3, -2.0, 1.5, 4.0];
        let reach = reach(coefficients[1..].iter().copied(), 0.5);
        assert!((reach - (1.0 + 0.375 + 0.5)).abs() < 1e-15, "{reach}");
    }
}
