//! What the number of runs leaves open.

/// Deviation that a normal variable exceeds in 2.5 % of the cases on either side \[–\].
const TWO_SIDED_95: f64 = 1.959_963_984_540_054;

/// The 95 % bounds \[–\] of the probability of what happened in `count` of `of` > 0 independent cases (E. B. Wilson,
/// *J. Am. Stat. Assoc.* 22 (1927) 209): they stay between 0 and 1, and have a width where it never or always happened.
pub fn wilson(count: u64, of: u64) -> (f64, f64) {
    let (n, z) = (of as f64, TWO_SIDED_95);
    let share = count as f64 / n;
    let whole = 1.0 + z * z / n;
    let centre = (share + z * z / (2.0 * n)) / whole;
    let half = z / whole * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
    // Between them lies the share; rounding may leave a bound on the wrong side of 0 or 1.
    ((centre - half).clamp(0.0, share), (centre + half).clamp(share, 1.0))
}

#[cfg(test)]
mod tests {
    use super::{TWO_SIDED_95, wilson};

    /// Bounds solve (p − share)² = z² p (1 − p)/n, from which Wilson derived them.
    #[test]
    fn reference_wilson_bounds_solve_their_equation() {
        for (count, of) in [(0, 10), (3, 10), (50, 300), (300, 300)] {
            let share = count as f64 / of as f64;
            let (low, high) = wilson(count, of);
            assert!(low <= share && share <= high);
            for bound in [low, high] {
                let squared = (bound - share) * (bound - share);
                let z = TWO_SIDED_95;
                let allowed = z * z * bound * (1.0 - bound) / of as f64;
                assert!((squared - allowed).abs() < 1e-15, "{count} of {of}: {bound}");
            }
        }
    }
}
