//! Zeros of functions, separately in every lane.

use pounding_contact::Number;

/// Most evaluations of a search; no examined search needs a third.
const MOST_SEARCH: usize = 60;

/// Position in 0 ..= 1 at which a number rises through zero (negative at 0, not negative at 1), to within `part`, in the `wanted` lanes.
///
/// Uses the secant, with halving of the value at an end that stays (Illinois), or the middle if the secant is outside the bracket or NaN.
/// The result in a lane does not depend on others.
#[inline(always)]
pub(super) fn rise<N: Number>(wanted: N::Mask, [start, end]: [N; 2], part: f64, number: impl Fn(N) -> N) -> N {
    let like = |number: f64| start.like(number);
    let (zero, half) = (like(0.0), like(0.5));
    let (mut low, mut below) = (zero, start);
    let (mut high, mut above) = (like(1.0), end);
    // The end that moved last: −1, 1, or 0 for none yet.
    let mut moved = zero;
    // NaN before the first evaluation, to which nothing is close.
    let (mut x, mut open) = (like(f64::NAN), wanted);
    for _ in 0..MOST_SEARCH {
        let secant = high - above * (high - low) / (above - below);
        // The zero is at an end if the value there is zero, or that at the other end is infinite: the secant is then useless.
        let at_end = !above.exceeds(zero) & !secant.exceeds(high);
        let inside = secant.exceeds(low) & (high.exceeds(secant) | at_end);
        let next = N::select(inside, secant, half * (low + high));
        let near = like(part).exceeds((next - x).abs());
        x = N::select(open, next, x);
        // A secant that creeps from one end is not close to the zero: the other end must have moved, too.
        let both = low.exceeds(zero) & like(1.0).exceeds(high);
        let closed = like(part).exceeds(high - low) | (near & (both | at_end));
        open = open & !closed;
        if !N::any(open) {
            break;
        }
        let value = number(x);
        let falls_short = zero.exceeds(value);
        let again = zero.exceeds(moved);
        above = N::select(falls_short & again, half * above, above);
        below = N::select(!falls_short & moved.exceeds(zero), half * below, below);
        low = N::select(falls_short, x, low);
        below = N::select(falls_short, value, below);
        high = N::select(falls_short, high, x);
        above = N::select(falls_short, above, value);
        moved = N::select(falls_short, like(-1.0), like(1.0));
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn reference_zeros_of_cubics_with_a_known_one(
            zero in 0.0..1.0_f64, rise in 0.01..10.0_f64, curve in 0.0..50.0_f64,
        ) {
            let number = |x: f64| (x - zero) * (rise + curve * (x - zero) * (x - zero));
            let found = super::rise(true, [number(0.0), number(1.0)], 1e-9, number);
            prop_assert!((found - zero).abs() < 1e-8, "{found} {zero}");
        }
    }

    /// Secants that creep from an end at which the number is a million times as large are not zeros.
    #[test]
    fn extreme_ends_of_other_magnitudes() {
        let steep = |x: f64| (x - 0.5) / libm::pow(x + 1e-5, 1.25);
        let found = rise(true, [steep(0.0), steep(1.0)], 1e-6, steep);
        assert!((found - 0.5).abs() < 1e-5, "{found}");
        let cubed = |x: f64| 1.0 + 100.0 * (1.0 - x) * (1.0 - x) * (1.0 - x);
        let top = |x: f64| (x - 0.6) * cubed(x);
        let found = rise(true, [top(0.0), top(1.0)], 1e-2, top);
        assert!((found - 0.6).abs() < 2e-2, "{found}");
    }

    #[test]
    fn limit_ends_that_are_no_numbers_are_left_to_the_middle() {
        let number = |x: f64| if x < 0.25 { f64::NEG_INFINITY } else { x - 0.5 };
        let found = rise(true, [f64::NEG_INFINITY, 0.5], 1e-9, number);
        assert!((found - 0.5).abs() < 1e-8, "{found}");
        let at_the_end = rise(true, [-1.0, 0.0], 1e-9, |x| x - 1.0);
        assert_eq!(at_the_end.to_bits(), 1.0_f64.to_bits());
    }
}
