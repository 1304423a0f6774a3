//! Counts and ranks of samples, with what their number leaves open.

/// Quantile of numbers in rising order, linear between them; `part` is 0 to 1. Nothing of none.
pub(crate) fn quantile(sorted: &[f64], part: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    let place = part * last as f64;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 to the number of samples"
    )]
    let below = (place.floor() as usize).min(last);
    let above = (below + 1).min(last);
    let rest = place - below as f64;
    Some(sorted[below] + rest * (sorted[above] - sorted[below]))
}

/// Numbers in rising order.
pub(crate) fn sorted(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers
}

/// Deviation that a normal variable exceeds in 2.5 % of the cases on either side \[–\].
const TWO_SIDED_95: f64 = 1.959_963_984_540_054;

/// The 95 % bounds of the probability of what happened in `count` of `of` > 0 independent cases (E. B. Wilson,
/// *J. Am. Stat. Assoc.* 22 (1927) 209): they stay between 0 and 1, and have a width where it never or always happened.
pub(crate) fn wilson(count: usize, of: usize) -> (f64, f64) {
    let (n, z) = (of as f64, TWO_SIDED_95);
    let share = count as f64 / n;
    let whole = 1.0 + z * z / n;
    let centre = (share + z * z / (2.0 * n)) / whole;
    let half = z / whole * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
    // Between them lies the share; rounding may leave a bound on the wrong side of 0 or 1.
    (
        (centre - half).clamp(0.0, share),
        (centre + half).clamp(share, 1.0),
    )
}

#[cfg(test)]
mod tests {
    use super::{quantile, wilson};

    #[test]
    fn reference_quantiles_between_samples() {
        let samples = [1.0, 2.0, 4.0];
        for (part, wanted) in [(0.0, 1.0), (0.25, 1.5), (0.5, 2.0), (0.75, 3.0), (1.0, 4.0)] {
            assert_eq!(quantile(&samples, part), Some(wanted));
        }
        assert_eq!(quantile(&[], 0.5), None);
    }

    /// Bounds solve (p − share)² = z² p (1 − p)/n, from which Wilson derived them.
    #[test]
    fn reference_wilson_bounds_solve_their_equation() {
        for (count, of) in [(0, 10), (3, 10), (50, 300), (300, 300)] {
            let share = count as f64 / of as f64;
            let (low, high) = wilson(count, of);
            assert!(low <= share && share <= high);
            for bound in [low, high] {
                let squared = (bound - share) * (bound - share);
                let z = super::TWO_SIDED_95;
                let allowed = z * z * bound * (1.0 - bound) / of as f64;
                assert!(
                    (squared - allowed).abs() < 1e-15,
                    "{count} of {of}: {bound}"
                );
            }
        }
    }
}
