//! Quantiles of samples.

/// Quantile of sorted numbers, linear between them; `part` is 0 to 1. `None` if there are no numbers.
pub(crate) fn quantile(sorted: &[f64], part: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    let place = part * last as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to the number of samples")]
    let below = (place.floor() as usize).min(last);
    let above = (below + 1).min(last);
    let rest = place - below as f64;
    Some(sorted[below] + rest * (sorted[above] - sorted[below]))
}

/// The numbers in rising order.
pub(crate) fn sorted(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers
}

#[cfg(test)]
mod tests {
    use super::quantile;

    #[test]
    fn reference_quantiles_between_samples() {
        let samples = [1.0, 2.0, 4.0];
        for (part, wanted) in [(0.0, 1.0), (0.25, 1.5), (0.5, 2.0), (0.75, 3.0), (1.0, 4.0)] {
            assert_eq!(quantile(&samples, part), Some(wanted));
        }
        assert_eq!(quantile(&[], 0.5), None);
    }
}
