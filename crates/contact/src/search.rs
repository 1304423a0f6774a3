//! Roots and maxima of functions of a single variable, by halving and golden sections: slow and safe. Never used inside a step.

/// Halvings that find even a root at 1e-50 of the interval to the last bit.
const MAX_HALVINGS: u32 = 220;
/// Sections that shrink an interval to less than the square root of rounding. A maximum is flat below this size.
const N_SECTIONS: u32 = 60;

/// The zero of an increasing function within `low..=high`; the nearer end if it has none there.
pub(crate) fn root(mut low: f64, mut high: f64, increasing: impl Fn(f64) -> f64) -> f64 {
    if increasing(low) >= 0.0 {
        return low;
    }
    for _ in 0..MAX_HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if increasing(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// The largest value within `low..=high`, ends included, of a function with a single hump.
pub(crate) fn maximum(low: f64, high: f64, hump: impl Fn(f64) -> f64) -> f64 {
    let (mut left, mut right) = (low, high);
    let mut best = hump(low).max(hump(high));
    // (√5 − 1)/2: an inner point of a section is then also an inner point of the next section.
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (right - golden * (right - left), left + golden * (right - left));
    let (mut at_a, mut at_b) = (hump(a), hump(b));
    for _ in 0..N_SECTIONS {
        best = best.max(at_a).max(at_b);
        if at_a < at_b {
            (left, a, at_a) = (a, b, at_b);
            b = left + golden * (right - left);
            at_b = hump(b);
        } else {
            (right, b, at_b) = (b, a, at_a);
            a = right - golden * (right - left);
            at_a = hump(a);
        }
    }
    best
}
