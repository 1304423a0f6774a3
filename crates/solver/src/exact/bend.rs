//! The force of columns that yield smoothly, as a power series.
//!
//! h = (1 − a) k z obeys dh = (1 − a) k (1 − |y|ⁿ s) dd. Here y = h/((1 − a) `f_y`) and s = γ + β sgn(z ḋ). This holds over the drift d,
//! and therefore in any variable in which the drift is a series. While the signs of z and of the rate of the drift stay the same, |y|ⁿ is a
//! product of series.

use crate::Smoothness;
use crate::roots::{CAPACITY, LOST, SHORTEST_WAY};
use crate::span::{Power, value};

/// Most products that |y|ⁿ takes, for n up to 31.
const PRODUCTS: usize = 8;

/// Columns that yield smoothly, over one piece.
#[derive(Debug, Clone)]
pub(super) struct Bend {
    smoothness: Smoothness,
    /// (1 − a) k \[N/m\].
    stiffness: f64,
    /// (1 − a) `f_y` \[N\].
    limit: f64,
    /// The sequence of products from |y| to |y|ⁿ. Each is a square, followed by a factor |y| if `true`.
    products: Vec<bool>,
    /// Signs of h and of the rate of the drift; 0 while unknown.
    signs: (f64, f64),
    /// Sign of the rate of the drift if its first coefficients are only rounding; else 0.
    direction: f64,
    /// Coefficients of h.
    pub(super) force: [f64; CAPACITY],
    /// Coefficients of |y| and of its powers, one per product.
    powers: [[f64; CAPACITY]; PRODUCTS + 1],
}

impl Bend {
    pub(super) fn new(smoothness: Smoothness, stiffness: f64, limit: f64) -> Self {
        // From the second binary digit of the exponent on: a square, and another factor for a digit 1.
        let mut products = Vec::new();
        let exponent = smoothness.exponent.clamp(1, 31);
        for digit in (0..exponent.ilog2()).rev() {
            products.push(false);
            if exponent >> digit & 1 == 1 {
                products.push(true);
            }
        }
        Self {
            smoothness,
            stiffness,
            limit,
            products,
            signs: (0.0, 0.0),
            direction: 0.0,
            force: [0.0; CAPACITY],
            powers: [[0.0; CAPACITY]; PRODUCTS + 1],
        }
    }

    /// Begins a piece at a force h \[N\].
    pub(super) fn begin(&mut self, force: f64) {
        self.force = [0.0; CAPACITY];
        self.force[0] = force;
        self.signs = (sign(force), self.direction);
        if self.signs.0 == 0.0 {
            self.signs.0 = self.direction;
        }
    }

    /// Forgets the direction of the next pieces; the first coefficients will determine it.
    pub(super) fn forget_direction(&mut self) {
        self.direction = 0.0;
    }

    /// Takes the direction from a coefficient of the rate of the drift that is not rounding; true if the last expansion went the other way.
    pub(super) fn goes_with(&mut self, leading: f64) -> bool {
        let known = sign(leading);
        let other = self.signs.1.total_cmp(&known).is_ne();
        if other {
            self.direction = known;
        }
        other
    }

    /// Finds coefficient `n` of h from the coefficients of the drift up to `n`.
    pub(super) fn find(&mut self, drift: &[f64; CAPACITY], n: usize) {
        if n > 0 {
            if self.signs.1 == 0.0 {
                self.signs.1 = sign(drift[n]);
            }
            if self.signs.0 == 0.0 {
                // From zero, z goes in the direction of the drift.
                self.signs.0 = self.signs.1;
            }
            let slope = |m: usize| self.slope(m);
            let sum: f64 = (1..=n).map(|j| j as f64 * drift[j] * slope(n - j)).sum();
            self.force[n] = self.stiffness * sum / n as f64;
        }
        self.raise(n);
    }

    /// Coefficient `m` of 1 − |y|ⁿ s.
    fn slope(&self, m: usize) -> f64 {
        let Smoothness { unloading, .. } = self.smoothness;
        let turn = self.signs.0 * self.signs.1;
        let bent = self.powers[self.products.len()][m] * (1.0 - unloading + unloading * turn);
        if m == 0 { 1.0 - bent } else { -bent }
    }

    /// Coefficient `n` of |y| and its powers.
    fn raise(&mut self, n: usize) {
        self.powers[0][n] = self.signs.0 * self.force[n] / self.limit;
        for (index, again) in self.products.iter().enumerate() {
            let (known, rest) = self.powers.split_at_mut(index + 1);
            let (before, factor) = (&known[index], if *again { &known[0] } else { &known[index] });
            rest[0][n] = (0..=n).map(|m| before[m] * factor[n - m]).sum();
        }
    }

    /// Length up to which the series has converged to the tolerance; `None` if there is no such length.
    pub(super) fn reach(&self, power: Power, len: usize, length: f64, tolerance: f64) -> Option<f64> {
        let mut x = length;
        loop {
            let tail = self.tail(len, x);
            if tail <= tolerance && self.is_bent(len, x, tolerance) {
                return Some(x);
            }
            if power.time(x) < SHORTEST_WAY {
                return (tail <= LOST).then_some(x);
            }
            x *= 0.85;
        }
    }

    /// Last quarter of the series at x, as a part of the whole.
    fn tail(&self, len: usize, x: f64) -> f64 {
        let (mut sum, mut tail, mut weight) = (0.0, 0.0, 1.0);
        for (n, coefficient) in self.force[..len].iter().enumerate() {
            let term = n as f64 * weight * coefficient.abs();
            sum += term;
            if n + len / 4 >= len {
                tail += term;
            }
            weight *= x;
        }
        // A storey that has hardly begun to move may have its only significant terms in the last coefficients.
        if tail > NOTHING * self.limit { tail / sum } else { 0.0 }
    }

    /// Whether the series of |y|ⁿ equals that power at x. From y = 0 the series may begin beyond the last coefficient.
    fn is_bent(&self, len: usize, x: f64, tolerance: f64) -> bool {
        let at = |index: usize| value(&self.powers[index][..len], x);
        let (first, exponent) = (at(0), self.smoothness.exponent);
        let power = (0..exponent).fold(1.0, |power, _| power * first);
        let rounding = 8.0 * f64::EPSILON * f64::from(exponent);
        (power - at(self.products.len())).abs() <= tolerance.max(rounding)
    }
}

/// Part of a force, or a rate \[m/s\], that counts as zero.
pub(super) const NOTHING: f64 = 1e-20;

/// Sign of a number; 0 for 0.
pub(super) fn sign(number: f64) -> f64 {
    if number > 0.0 {
        1.0
    } else if number < 0.0 {
        -1.0
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_loading_in_closed_form() {
        // y over the drift s from 0: 1 − e^(−s) for n = 1, tanh s for n = 2.
        for (exponent, wanted) in [(1, 1.0 - libm::exp(-0.3)), (2, libm::tanh(0.3))] {
            let smoothness = Smoothness { exponent, unloading: 0.5 };
            let mut bend = Bend::new(smoothness, 1e5, 1e3);
            let mut drift = [0.0; CAPACITY];
            drift[1] = 0.01;
            bend.begin(0.0);
            for n in 0..40 {
                bend.find(&drift, n);
            }
            let found = value(&bend.force[..40], 0.3) / 1e3;
            assert!((found / wanted - 1.0).abs() < 1e-15, "{exponent}: {found} {wanted}");
        }
    }

    #[test]
    fn reference_every_exponent_is_reached_by_products() {
        for exponent in 1..=31 {
            let smoothness = Smoothness { exponent, unloading: 0.5 };
            let mut bend = Bend::new(smoothness, 1.0, 1.0);
            assert!(bend.products.len() <= PRODUCTS, "{exponent}: {:?}", bend.products);
            bend.begin(-0.9);
            bend.find(&[0.0; CAPACITY], 0);
            let wanted = (0..exponent).fold(1.0, |power, _| power * 0.9);
            let found = bend.powers[bend.products.len()][0];
            assert!((found / wanted - 1.0).abs() < 1e-14, "{exponent}: {found}");
        }
    }
}
