//! Largest values and turns of polynomials.

use pounding_solver::formulas::{CAPACITY, quick_first_root, shift, value_and_slope};

/// Most turns in a search. A motion between two samples has one or two.
const MOST_TURNS: usize = 8;

/// The largest of a known value and the values of a polynomial between 0 and x.
pub(super) fn highest(polynomial: &[f64], x: f64, known: f64) -> f64 {
    let mut room = [0.0; CAPACITY];
    let series = &mut room[..polynomial.len()];
    series.copy_from_slice(polynomial);
    let (end, _) = value_and_slope(series, x);
    let (mut highest, mut rest) = (known.max(series[0]).max(end), x);
    for _ in 0..MOST_TURNS {
        if series[0] + rise_bound(series, 1.0, rest) <= highest {
            break;
        }
        let mut rates = [0.0; CAPACITY];
        let rates = &mut rates[..series.len() - 1];
        for (index, rate) in rates.iter_mut().enumerate() {
            *rate = (index + 1) as f64 * series[index + 1];
        }
        let Some(turn) = first_turn(rates, rest) else {
            break;
        };
        shift(series, turn);
        rest -= turn;
        // The zero is exactly there, despite rounding.
        series[1] = 0.0;
        highest = highest.max(series[0]);
    }
    highest
}

/// First instant after which a rate has the opposite sign to that just after the start.
pub(super) fn first_turn(rates: &[f64], length: f64) -> Option<f64> {
    let first = rates.iter().find(|rate| **rate != 0.0)?;
    let mut series = [0.0; CAPACITY];
    let falling = &mut series[..rates.len()];
    for (rate, coefficient) in falling.iter_mut().zip(rates) {
        *rate = -first.signum() * coefficient;
    }
    quick_first_root(falling, length)
}

/// Upper bound of the rise of a polynomial, times a sign, from 0 to x.
pub(super) fn rise_bound(coefficients: &[f64], sign: f64, x: f64) -> f64 {
    let sum = |sum: f64, coefficient: &f64| sum * x + (sign * coefficient).max(0.0);
    x * coefficients.iter().skip(1).rev().fold(0.0, sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x − 3x² + 2x³ has its maximum at (3 − √3)/6 and rises through this height again after 1.
    #[test]
    fn reference_the_largest_value_of_a_cubic() {
        let cubic = [0.25, 1.0, -3.0, 2.0];
        let at = |x: f64| 0.25 + x * (1.0 + x * (2.0 * x - 3.0));
        let top = at((3.0 - libm::sqrt(3.0)) / 6.0);
        for (x, known, wanted) in [
            (0.1, -1.0, at(0.1)),
            (0.5, -1.0, top),
            (0.9, -1.0, top),
            (1.5, -1.0, at(1.5)),
            (0.9, 0.4, 0.4),
        ] {
            let found = highest(&cubic, x, known);
            assert!((found - wanted).abs() < 1e-15, "{x} {known}: {found} {wanted}");
        }
        // Upside down it falls first, and its maximum comes later.
        let turned = cubic.map(|coefficient| -coefficient);
        let wanted = -at((3.0 + libm::sqrt(3.0)) / 6.0);
        let found = highest(&turned, 0.9, f64::NEG_INFINITY);
        assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
    }
}
