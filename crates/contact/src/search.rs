//! Roots and maxima of functions of one variable by halving and thirds: slow, sure, and never inside a step.

/// Halvings after which even a root at 1e-50 of the interval is known to the last bit.
const MAX_HALVINGS: u32 = 220;
/// Sections that shrink an interval to less than the square root of rounding, beyond which a maximum is flat.
const N_SECTIONS: u32 = 60;

/// Where an increasing function rises through zero within `low..=high`; the nearer end where it does not.
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

/// The largest value of a function with one hump within `low..=high`, its ends included.
pub(crate) fn maximum(low: f64, high: f64, hump: impl Fn(f64) -> f64) -> f64 {
    let (mut left, mut right) = (low, high);
    let mut best = hump(low).max(hump(high));
    // (√5 − 1)/2: one of the two inner points of a section is an inner point of the next.
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
