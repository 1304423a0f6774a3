//! The standard normal distribution.

use std::f64::consts::{FRAC_1_SQRT_2, LN_2, PI};

/// Density φ(z) \[–\].
pub(crate) fn density(z: f64) -> f64 {
    libm::exp(-0.5 * z * z) / (2.0 * PI).sqrt()
}

/// Probability Φ(z) of a smaller value \[–\]; that of a larger one is Φ(−z).
pub(crate) fn below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}

/// Mills' ratio (1 − Φ(z))/φ(z) \[–\]; infinite where φ(z) underflows on the left.
pub(crate) fn mills(z: f64) -> f64 {
    if z < FAR {
        return below(-z) / density(z);
    }
    // Laplace's continued fraction, from within: beyond FAR some ten terms reach the last digit.
    (1..=TERMS).rev().fold(z, |inner, term| z + f64::from(term) / inner).recip()
}

/// Logarithm of Φ(z), also where Φ(z) underflows \[–\].
pub(crate) fn log_below(z: f64) -> f64 {
    if z > -FAR {
        libm::log(below(z))
    } else {
        -0.5 * (z * z + LN_2 + libm::log(PI)) + libm::log(mills(-z))
    }
}

/// Beyond it Mills' ratio comes from its continued fraction \[–\].
const FAR: f64 = 12.0;

/// Terms of the continued fraction.
const TERMS: u32 = 30;

#[cfg(test)]
mod tests {
    use super::{FAR, below, density, log_below, mills};

    /// Both branches agree where they meet, and far out the ratio approaches 1/z − 1/z³ + 3/z⁵ − 15/z⁷.
    #[test]
    fn limit_both_branches_of_mills_ratio_agree() {
        let near = below(-FAR) / density(FAR);
        assert!((mills(FAR) / near - 1.0).abs() < 1e-13, "{near}");
        let z: f64 = 100.0;
        let series = (1.0 - (1.0 - (3.0 - 15.0 / (z * z)) / (z * z)) / (z * z)) / z;
        assert!((mills(z) / series - 1.0).abs() < 1e-13);
        assert!((log_below(-FAR) / libm::log(below(-FAR)) - 1.0).abs() < 1e-14);
        assert!(log_below(-100.0).is_finite() && below(-100.0) <= 0.0);
    }

    /// Tables: Φ(1.959963984540054) = 0.975.
    #[test]
    fn reference_quantile() {
        assert!((below(1.959_963_984_540_054) - 0.975).abs() < 1e-15);
    }
}
