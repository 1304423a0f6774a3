use nalgebra::{Matrix2, Vector2};

use crate::ModelError;

/// Viscous damping of a structure, by ratio or Rayleigh coefficients.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// Damping ratio ζ \[–\]: c = 2 ζ √(k m).
    Ratio(f64),
    /// Rayleigh damping c = α m + β k.
    Rayleigh {
        /// Mass coefficient α \[1/s\].
        alpha: f64,
        /// Stiffness coefficient β \[s\].
        beta: f64,
    },
}

impl Damping {
    /// Damping coefficient c \[N·s/m\] of a structure of mass \[kg\] and elastic stiffness \[N/m\].
    pub fn coefficient(&self, mass: f64, stiffness: f64) -> f64 {
        match *self {
            Self::Ratio(ratio) => 2.0 * ratio * (stiffness * mass).sqrt(),
            Self::Rayleigh { alpha, beta } => alpha * mass + beta * stiffness,
        }
    }

    /// Stiffness coefficient β \[s\] of Rayleigh damping; 0 for a ratio.
    pub const fn beta(&self) -> f64 {
        match self {
            Self::Ratio(_) => 0.0,
            Self::Rayleigh { beta, .. } => *beta,
        }
    }

    /// Damping ratio ζ = c/(2√(k m)) \[–\] of a structure of mass \[kg\] and elastic stiffness \[N/m\].
    pub fn ratio(&self, mass: f64, stiffness: f64) -> f64 {
        self.coefficient(mass, stiffness) / (2.0 * (stiffness * mass).sqrt())
    }

    /// Rayleigh damping that gives the `ratios` ζ at two `frequencies` \[Hz\]: ζ = α/(2ω) + βω/2 at both.
    ///
    /// # Errors
    /// [`ModelError`] unless 0 < first frequency < second, both finite.
    pub fn rayleigh_from_ratios(frequencies: [f64; 2], ratios: [f64; 2]) -> Result<Self, ModelError> {
        let omega = frequencies.map(|frequency| 2.0 * std::f64::consts::PI * frequency);
        let rows = Matrix2::new(0.5 / omega[0], 0.5 * omega[0], 0.5 / omega[1], 0.5 * omega[1]);
        let valid = 0.0 < frequencies[0] && frequencies[0] < frequencies[1] && frequencies[1].is_finite();
        let solution = valid.then(|| rows.lu().solve(&Vector2::from(ratios))).flatten();
        solution
            .map(|x| Self::Rayleigh { alpha: x[0], beta: x[1] })
            .ok_or(ModelError::OutOfRange {
                place: "rayleigh frequencies".into(),
                found: frequencies[1],
                allowed: "0 < first < second, both finite",
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_rayleigh_gives_the_ratios_asked_for() {
        let damping = Damping::rayleigh_from_ratios([1.0, 10.0], [0.05, 0.03]).unwrap();
        for (frequency, ratio) in [(1.0, 0.05), (10.0, 0.03)] {
            let omega = 2.0 * std::f64::consts::PI * frequency;
            let found = damping.ratio(3.0, 3.0 * omega * omega);
            assert!((found - ratio).abs() < 1e-15, "{frequency} Hz: {found}");
        }
    }

    #[test]
    fn limit_ratio_and_coefficient_are_inverse() {
        let found = Damping::Ratio(0.05).ratio(75e3, 2.056e6);
        assert!((found - 0.05).abs() < 1e-16, "{found}");
    }

    #[test]
    fn extreme_equal_frequencies_are_refused() {
        assert!(Damping::rayleigh_from_ratios([2.0, 2.0], [0.05, 0.05]).is_err(), "no unique answer");
        assert!(Damping::rayleigh_from_ratios([0.0, 2.0], [0.05, 0.05]).is_err(), "zero frequency");
    }
}
