//! The first instant at which a polynomial rises through zero, found by bounds.
//!
//! A stretch is skipped only if an upper bound of the polynomial is not positive there. A rise and fall between two ends cannot be missed.

use crate::span::value;

/// Capacity of every series.
pub const CAPACITY: usize = 64;

/// Largest part of a series in its last quarter, if no shorter stretch can be resolved.
pub(crate) const LOST: f64 = 1e-3;
/// The shortest piece that time resolves \[s\].
pub(crate) const SHORTEST_WAY: f64 = 1e-18;
/// Time within which a motion that turns has gone nowhere \[s\].
pub(crate) const INSTANT: f64 = 1e-15;

/// Part of the whole below which the length of a stretch is rounding.
const SHORTEST: f64 = 1e-15;
/// Steps of a search. Newton's method takes three to eight, halving fifty.
const MOST_STEPS: usize = 200;
/// Ratio of steps below which Newton's method doubles the number of digits.
const FAST: f64 = 1e-2;

/// First x in 0 ..= `length` after which the polynomial is positive, coming from values ≤ 0.
///
/// Leading coefficients that are exactly zero are known zeros at x = 0; the others decide. A polynomial that is positive from the start
/// rises at 0. A polynomial with non-finite coefficients never rises.
pub(crate) fn first_root(coefficients: &[f64], length: f64) -> Option<f64> {
    first_root_by(root_of_monotone, coefficients, length)
}

/// First root with a faster algorithm for lanes of scenes. Its results may differ from `first_root` in the last bits.
pub fn quick_first_root(coefficients: &[f64], length: f64) -> Option<f64> {
    first_root_by(quick_root_of_monotone, coefficients, length)
}

/// First root, with a function that finds the zero of a polynomial that grows from ≤ 0 at 0 to > 0 at a width.
#[inline]
fn first_root_by(rise: impl Fn(&[f64], f64) -> f64, coefficients: &[f64], length: f64) -> Option<f64> {
    let known = coefficients.iter().position(|c| *c != 0.0)?;
    let whole = &coefficients[known..];
    if whole[0] > 0.0 {
        return Some(0.0);
    }
    let most = upper_bound(whole, length);
    // With masses near the largest number a coefficient may be NaN, so that no bound holds.
    if most <= 0.0 || !most.is_finite() {
        return None;
    }
    let mut local = [0.0; CAPACITY];
    let local = &mut local[..whole.len()];
    local.copy_from_slice(whole);
    let (mut left, mut width) = (0.0, length);
    loop {
        let Bounds { most, slope, end } = bounds(local, width);
        let monotone = slope >= 0.0;
        let none = most <= 0.0 || (monotone && end <= 0.0);
        if monotone && !none {
            return Some(left + rise(local, width));
        }
        if !none {
            width *= 0.5;
            if width > SHORTEST * length {
                continue;
            }
            // A double zero as sharp as rounding: the sign at its end decides.
            if value(local, width) > 0.0 {
                return Some(left + width);
            }
        }
        left += width;
        if left >= length {
            return None;
        }
        local.copy_from_slice(whole);
        shift(local, left);
        if local[0] > 0.0 {
            return Some(left);
        }
        width = (2.0 * width).min(length - left);
    }
}

/// Upper bound of the polynomial on 0 ..= `width`.
fn upper_bound(coefficients: &[f64], width: f64) -> f64 {
    let sum = |sum: f64, c: &f64| (sum * width) + c.max(0.0);
    coefficients[0] + width * coefficients[1..].iter().rev().fold(0.0, sum)
}

/// Bounds of a polynomial on 0 ..= a width.
struct Bounds {
    /// Upper bound of the value, as in [`upper_bound`].
    most: f64,
    /// Lower bound of the slope.
    slope: f64,
    /// Value at the end.
    end: f64,
}

/// Computes all three bounds in a single pass, without dependencies between them.
fn bounds(coefficients: &[f64], width: f64) -> Bounds {
    let (mut most, mut slope, mut end) = (0.0, 0.0, 0.0);
    for (order, coefficient) in coefficients.iter().enumerate().skip(2).rev() {
        most = most * width + coefficient.max(0.0);
        slope = slope * width + (order as f64 * coefficient).min(0.0);
        end = end * width + coefficient;
    }
    let (first, second) = (coefficients[0], coefficients.get(1));
    let second = *second.unwrap_or(&0.0);
    Bounds {
        most: first + width * (most * width + second.max(0.0)),
        slope: second + width * slope,
        end: (end * width + second) * width + first,
    }
}

/// Zero of a polynomial that grows from ≤ 0 at 0 to > 0 at `width`: Newton's method within a bracket.
fn root_of_monotone(coefficients: &[f64], width: f64) -> f64 {
    let (mut low, mut high) = (0.0, width);
    let mut x = width;
    for _ in 0..MOST_STEPS {
        let (y, slope) = value_and_slope(coefficients, x);
        if y > 0.0 {
            high = x;
        } else {
            low = x;
        }
        let newton = x - y / slope;
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        let settled = (next - x).abs() <= f64::EPSILON * next.abs();
        x = next;
        if settled || low >= high {
            break;
        }
    }
    x
}

/// Zero of a growing polynomial, starting from the zero of its first three coefficients: three steps instead of eight, with other last
/// bits.
fn quick_root_of_monotone(coefficients: &[f64], width: f64) -> f64 {
    let (mut low, mut high) = (0.0, width);
    let mut x = rise_of_parabola(coefficients, width);
    let mut before = 0.0;
    for _ in 0..MOST_STEPS {
        let (y, slope) = value_and_slope(coefficients, x);
        if y > 0.0 {
            high = x;
        } else {
            low = x;
        }
        let newton = x - y / slope;
        let inside = low <= newton && newton <= high;
        let next = if inside { newton } else { 0.5 * (low + high) };
        let change = (next - x).abs();
        let fall = change / before;
        // If steps fall quadratically, the next step is this step times the square of the ratio. A halving of the bracket is no such step.
        let rest = if inside && fall < FAST { change * fall * fall } else { change };
        (x, before) = (next, if inside { change } else { 0.0 });
        if rest <= f64::EPSILON * x.abs() || low >= high {
            break;
        }
    }
    x
}

/// Approximate zero, from the first three coefficients.
fn rise_of_parabola(coefficients: &[f64], width: f64) -> f64 {
    let &[value, slope, half_curve, ..] = coefficients else {
        return width;
    };
    let root = (slope * slope - 4.0 * half_curve * value).sqrt();
    let x = -2.0 * value / (slope + root);
    if x > 0.0 && x < width { x } else { width }
}

/// Value and first derivative at x.
pub fn value_and_slope(coefficients: &[f64], x: f64) -> (f64, f64) {
    let (mut y, mut slope) = (0.0, 0.0);
    for coefficient in coefficients.iter().rev() {
        slope = slope * x + y;
        y = y * x + coefficient;
    }
    (y, slope)
}

/// Rounds of a shift that run through a polynomial together: a single round would wait for its last sum.
const AT_ONCE: usize = 4;

/// Expands a polynomial about `origin` instead of 0.
pub fn shift(coefficients: &mut [f64], origin: f64) {
    let Some((last, others)) = coefficients.split_last_mut() else {
        return;
    };
    if origin == 0.0 {
        return;
    }
    // Round `first` finishes coefficient `first`.
    for first in (0..others.len()).step_by(AT_ONCE) {
        let mut sums = [*last; AT_ONCE];
        for (index, coefficient) in others.iter_mut().enumerate().skip(first).rev() {
            let rounds = (index - first + 1).min(AT_ONCE);
            for sum in &mut sums[..rounds] {
                *coefficient += origin * *sum;
                *sum = *coefficient;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// −(x − a)(x − b)…, negative at 0 for an even number of zeros on the right.
    fn with_zeros(zeros: &[f64]) -> Vec<f64> {
        let mut p = vec![-1.0];
        for zero in zeros {
            let mut next = vec![0.0; p.len() + 1];
            for (index, c) in p.iter().enumerate() {
                next[index + 1] += c;
                next[index] -= zero * c;
            }
            p = next;
        }
        p
    }

    #[test]
    fn reference_double_crossings_are_found() {
        for separation in [1e-1, 1e-3, 1e-5, 1e-6] {
            let zeros = [0.6, 0.6 + separation];
            for search in [first_root, quick_first_root] {
                let found = search(&with_zeros(&zeros), 1.0).unwrap();
                assert!((found - 0.6).abs() < 1e-15 / separation, "{separation}: {found}");
            }
        }
        assert_eq!(first_root(&[-1.0 - 1e-12, 2.0, -1.0], 2.0), None, "a near miss");
    }

    /// Newton's method overshot an end at the zero by rounding and halved the bracket. It took the halving for convergence. The zero had an
    /// error of 2.5e-11, and a structure in a lane started there with a velocity of zero.
    #[test]
    fn issue_a_zero_at_the_end_is_found_there() {
        let polynomial = [
            -0.248_985_178_817_134_56,
            14.744_441_708_421_17,
            217.823_740_868_573_8,
            -5_740.505_198_305_289,
            -42_403.040_464_264_77,
            670_491.306_149_943_5,
            3_301_784.889_827_831_6,
            -37_292_104.514_340_01,
            -137_731_659.679_184_73,
            1_209_922_152.664_742,
            3_574_903_338.695_657,
            -25_694_358_263.400_646,
            -63_264_984_265.841_32,
            384_756_715_824.041_5,
            812_016_863_443.652_5,
            -4_279_962_328_369.284,
            -7_903_634_328_601.824,
            36_757_339_916_959.75,
            60_336_268_054_429.75,
            -251_067_790_454_177.3,
            -370_909_434_279_232.1,
            1_396_415_761_982_716.0,
        ];
        let whole = root_of_monotone(&polynomial, 0.02);
        for ulps in 0..8_u64 {
            let width = f64::from_bits(whole.to_bits() + ulps - 4);
            let found = quick_root_of_monotone(&polynomial, width);
            assert!((found - whole).abs() < 1e-17, "{found} {whole}");
        }
    }

    /// With a NaN coefficient, the search went through stretches of 1e-15 of the whole.
    #[test]
    fn issue_no_number_rises_nowhere() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for search in [first_root, quick_first_root] {
                assert_eq!(search(&[-1.0, 0.0, bad, 1.0], 0.01), None, "{bad}");
            }
        }
    }

    #[test]
    fn limit_known_zeros_at_the_start_are_left_out() {
        let half = first_root(&[0.0, -1.0, 2.0], 1.0).unwrap();
        assert!((half - 0.5).abs() < 2e-16, "{half}");
        assert_eq!(first_root(&[0.0, 0.0, 3.0], 1.0), Some(0.0));
        assert_eq!(first_root(&[0.0, 0.0, -3.0], 1.0), None);
        assert_eq!(first_root(&[0.0; 4], 1.0), None);
    }

    proptest! {
        #[test]
        fn reference_first_of_several_zeros(mut zeros in prop::collection::vec(0.01..3.0_f64, 2..7)) {
            if zeros.len() % 2 == 1 {
                zeros.pop();
            }
            zeros.sort_by(f64::total_cmp);
            prop_assume!(zeros[1] - zeros[0] > 1e-3);
            for found in [first_root, quick_first_root].map(|search| search(&with_zeros(&zeros), 1.0)) {
                if zeros[0] < 1.0 {
                    let found = found.expect("there is a rise");
                    prop_assert!((found - zeros[0]).abs() < 1e-8, "{found} of {zeros:?}");
                } else {
                    prop_assert_eq!(found, None);
                }
            }
        }

        #[test]
        fn reference_shifted_polynomials_have_the_same_values(
            coefficients in prop::collection::vec(-1.0..1.0_f64, 1..12), origin in -1.0..1.0_f64, x in -1.0..1.0_f64,
        ) {
            let mut shifted = coefficients.clone();
            shift(&mut shifted, origin);
            let (found, wanted) = (value(&shifted, x), value(&coefficients, origin + x));
            prop_assert!((found - wanted).abs() < 1e-10, "{found} {wanted}");
        }
    }
}
