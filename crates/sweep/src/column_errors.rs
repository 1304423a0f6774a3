//! Errors of the numbers of a sweep, column by column.

/// Errors of measured runs, |a − b| / max(|a|, |b|) of a number and the exact number \[–\].
///
/// For peaks the magnitudes count. The error is 1 if only one of both runs touches. Residual displacements and least openings are relative
/// to at least [`LEAST_PART`](pounding_scene::RunValues::LEAST_PART) of the peak displacement.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnErrors {
    /// Name of the column.
    pub name: String,
    /// Number of measured runs that have this number.
    pub runs: usize,
    /// Errors that 50, 90, 95 and 99 % of the runs do not exceed.
    pub quantiles: [f64; 4],
    /// The largest.
    pub largest: f64,
}

/// Parts of the runs of [`ColumnErrors::quantiles`].
const PARTS: [f64; 4] = [0.5, 0.9, 0.95, 0.99];

impl ColumnErrors {
    pub(super) fn of(name: String, mut errors: Vec<f64>) -> Self {
        errors.retain(|error| !error.is_nan());
        errors.sort_by(f64::total_cmp);
        Self {
            name,
            runs: errors.len(),
            quantiles: PARTS.map(|part| at_most(&errors, part)),
            largest: errors.last().copied().unwrap_or(0.0),
        }
    }
}

/// The value that a part of the sorted errors does not exceed.
pub(super) fn at_most(sorted: &[f64], part: f64) -> f64 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a number from 0 to the number of errors"
    )]
    let place = (part * sorted.len() as f64).ceil() as usize;
    sorted.get(place.max(1) - 1).copied().unwrap_or(0.0)
}

/// Distance of two numbers of a table, relative to the larger one or to their least scale.
pub(super) fn distance(a: f64, b: f64, least: f64) -> f64 {
    match (a.is_nan(), b.is_nan()) {
        (true, true) => 0.0,
        // The smallest number avoids a division by zero.
        (false, false) => (a - b).abs() / a.abs().max(b.abs()).max(least).max(f64::MIN_POSITIVE),
        (true, false) | (false, true) => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_quantiles_and_distances() {
        let errors: Vec<_> = (1..=100).map(f64::from).collect();
        let of = ColumnErrors::of("x".into(), errors);
        let bits = |numbers: [f64; 4]| numbers.map(f64::to_bits);
        assert_eq!(bits(of.quantiles), bits([50.0, 90.0, 95.0, 99.0]));
        for (a, b, least, wanted) in [
            (0.0, 0.0, 0.0, 0.0),
            (1.0, 0.0, 0.0, 1.0),
            (f64::NAN, 2.0, 0.0, 1.0),
            (f64::NAN, f64::NAN, 0.0, 0.0),
            (2.0, 1.5, 0.0, 0.25),
            (-2.0, 2.0, 0.0, 2.0),
            (0.5, 0.25, 1.0, 0.25),
        ] {
            let found = distance(a, b, least);
            assert_eq!(found.to_bits(), f64::to_bits(wanted), "{a} {b} {least}");
        }
    }
}
