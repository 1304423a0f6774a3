//! The lognormal fragility of most likelihood.

use pounding_text::{Refused, digits};

use crate::normal::{below, density, log_below, mills};
use crate::stripe::{Count, Stripes};

/// A lognormal fragility: the probability that a motion of some intensity exceeds a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fragility {
    /// Median intensity θ \[g\], > 0: half of the motions exceed the state.
    pub median: f64,
    /// Dispersion β \[–\], > 0: standard deviation of the logarithm of the intensity at which a motion reaches the state.
    pub dispersion: f64,
}

/// A fragility of most likelihood, and how certain it is if all runs are independent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FragilityFit {
    /// The fragility.
    pub fragility: Fragility,
    /// Standard error of ln θ \[–\], by the expected information.
    pub error_of_log_median: f64,
    /// Standard error of β \[–\], by the expected information.
    pub error_of_dispersion: f64,
    /// Correlation of both errors \[–\].
    pub correlation: f64,
    /// Negative logarithm of the likelihood, without binomial coefficients \[–\].
    pub minus_log_likelihood: f64,
}

impl Fragility {
    /// Largest dispersion β that is given \[–\]. A motion at the 16 % quantile is then seven times weaker than the median, so that intensity tells
    /// nothing about the state.
    pub const MOST_DISPERSION: f64 = 2.0;

    /// Probability that a motion of this intensity \[g\], > 0, exceeds the state \[–\].
    pub fn probability(&self, intensity: f64) -> f64 {
        below(self.deviation(intensity))
    }

    /// Distance of an intensity from the median in standard deviations, Z \[–\].
    pub(crate) fn deviation(&self, intensity: f64) -> f64 {
        libm::log(intensity / self.median) / self.dispersion
    }

    /// Finds the fragility under which the shares of the stripes are most likely (J. W. Baker, *Earthquake Spectra* 31 (2015) 579). Shares are
    /// binomial and independent.
    ///
    /// # Errors
    /// Refuses stripes if no motion exceeds the state, or all do. Refuses motions that the intensity separates, for which β → 0 is most likely.
    /// Refuses shares that do not grow with the intensity, and β ≥ [`Self::MOST_DISPERSION`].
    pub fn of(stripes: &Stripes) -> Result<FragilityFit, Refused> {
        let counts = stripes.counts();
        if let Some(reason) = undetermined(&counts) {
            return Err(reason);
        }
        let fit = Probit::of(&counts).and_then(|found| found.fit(&counts));
        let fit = fit.ok_or_else(|| Refused::at(PLACE).found("shares without a largest likelihood"))?;
        let dispersion = fit.fragility.dispersion;
        if dispersion < Self::MOST_DISPERSION {
            return Ok(fit);
        }
        let found = Refused::at(PLACE).found(format!("a dispersion of {}", digits((dispersion * 1e3).round() * 1e-3)));
        Err(found
            .allowed_is("less than 2")
            .help("take another intensity measure, such as sa_avg, or more motions"))
    }

    /// The fragility of some counts; `None` if they determine none below [`Self::MOST_DISPERSION`].
    pub(crate) fn of_counts(counts: &[Count]) -> Option<Self> {
        if undetermined(counts).is_some() {
            return None;
        }
        let found = Probit::of(counts)?.fragility();
        (found.dispersion < Self::MOST_DISPERSION).then_some(found)
    }
}

/// Place of a refusal.
const PLACE: &str = "stripes";

/// What determines a fragility.
const PART: &str = "a part of the motions at two or more intensities";

/// Returns the reason why counts determine no fragility; `None` if they do.
fn undetermined(counts: &[Count]) -> Option<Refused> {
    let n: f64 = counts.iter().map(|one| one.n).sum();
    let exceeding: f64 = counts.iter().map(|one| one.exceeding).sum();
    let in_g = |one: &Count| digits((libm::exp(one.log_intensity) * 1e4).round() * 1e-4);
    let [Some(first), Some(last)] = [counts.first(), counts.last()] else {
        return Some(Refused::at(PLACE).found("none").allowed_are("two or more"));
    };
    let whole = |share: &str, to: &Count, help: &str| {
        let found = format!("{share} of the motions from {} to {} g", in_g(first), in_g(last));
        let found = Refused::at(PLACE)
            .found(found)
            .allowed_is("a part of them at two or more intensities");
        found.help(format!("{help} intensities than {} g", in_g(to)))
    };
    if exceeding <= 0.0 {
        return Some(whole("the state under none", last, "take higher"));
    }
    if exceeding >= n {
        return Some(whole("the state under all", first, "take lower"));
    }
    // Motions are separated if below some intensity none reaches the state and above it all do: β → 0 is ever more likely.
    let least = counts.iter().find(|one| one.exceeding > 0.0)?;
    let most = counts.iter().rev().find(|one| one.exceeding < one.n)?;
    if least.log_intensity >= most.log_intensity {
        let (found, around) = if least.log_intensity > most.log_intensity {
            let [none, all] = [most, least].map(in_g);
            (
                format!("the state under no motion up to {none} g and under all from {all} g"),
                "them",
            )
        } else {
            (format!("the state under a part of the motions at {} g alone", in_g(least)), "it")
        };
        let found = Refused::at(PLACE).found(format!("{found}, so that β → 0")).allowed_is(PART);
        return Some(found.help(format!("take more intensities around {around}, or more motions")));
    }
    let mean = counts.iter().map(|one| one.n * one.log_intensity).sum::<f64>() / n;
    let growth: f64 = counts
        .iter()
        .map(|one| (one.exceeding - one.n * exceeding / n) * (one.log_intensity - mean))
        .sum();
    (growth <= 0.0).then(|| {
        let found = Refused::at(PLACE).found("shares that do not grow with the intensity");
        found
            .allowed_are("shares that do")
            .help("take another intensity measure, or more intensities")
    })
}

/// The fragility as Φ(level + slope (x − centre)) of the logarithm x of the intensity. Its likelihood is concave in level and slope, but not in ln θ
/// and β: Newton's steps find the one maximum from anywhere.
#[derive(Debug, Clone, Copy)]
struct Probit {
    level: f64,
    slope: f64,
    /// Mean of x.
    centre: f64,
}

/// Gradient of the log-likelihood, and its curvature with the sign turned.
#[derive(Debug, Default, Clone, Copy)]
struct Slopes {
    gradient: [f64; 2],
    curvature: Symmetric,
}

/// A symmetric matrix of two rows: first diagonal, off the diagonal, second diagonal.
type Symmetric = [f64; 3];

/// Returns the solution of two linear equations; `None` of a singular matrix.
fn solved([a, b, c]: Symmetric, [u, v]: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = a * c - b * b;
    (determinant > 0.0).then(|| [(c * u - b * v) / determinant, (a * v - b * u) / determinant])
}

/// Most steps of Newton; ten are usual.
const MOST_STEPS: usize = 200;

impl Probit {
    fn of(counts: &[Count]) -> Option<Self> {
        let n: f64 = counts.iter().map(|one| one.n).sum();
        let centre = counts.iter().map(|one| one.n * one.log_intensity).sum::<f64>() / n;
        let mut found = Self {
            level: 0.0,
            slope: 0.0,
            centre,
        };
        let mut likelihood = found.log_likelihood(counts);
        for _ in 0..MOST_STEPS {
            let Slopes { gradient, curvature } = found.slopes(counts);
            let step = solved(curvature, gradient)?;
            let size = (step[0].abs() + step[1].abs()) / (1.0 + found.level.abs() + found.slope.abs());
            let taken = |part: f64| Self {
                level: found.level + part * step[0],
                slope: found.slope + part * step[1],
                centre,
            };
            // Near the maximum a difference of likelihoods is rounding.
            let mut part = 1.0;
            while size > 1e-6 && taken(part).log_likelihood(counts) <= likelihood && part > 1e-9 {
                part *= 0.5;
            }
            found = taken(part);
            likelihood = found.log_likelihood(counts);
            if size < 1e-14 {
                break;
            }
        }
        (found.slope > 0.0 && found.slope.is_finite() && found.level.is_finite()).then_some(found)
    }

    fn deviation(&self, count: &Count) -> f64 {
        self.level + self.slope * (count.log_intensity - self.centre)
    }

    fn log_likelihood(&self, counts: &[Count]) -> f64 {
        let of = |one: &Count| {
            let z = self.deviation(one);
            // A count of zero times the logarithm of zero is zero.
            let term = |n: f64, z: f64| if n > 0.0 { n * log_below(z) } else { 0.0 };
            term(one.exceeding, z) + term(one.n - one.exceeding, -z)
        };
        counts.iter().map(of).sum()
    }

    fn slopes(&self, counts: &[Count]) -> Slopes {
        let mut all = Slopes::default();
        for one in counts {
            let (z, x) = (self.deviation(one), one.log_intensity - self.centre);
            let [of_exceeding, of_others] = [mills(-z), mills(z)].map(f64::recip);
            let (exceeding, others) = (one.exceeding, one.n - one.exceeding);
            let gradient = exceeding * of_exceeding - others * of_others;
            let curvature = exceeding * of_exceeding * (of_exceeding + z) + others * of_others * (of_others - z);
            all.add(x, gradient, curvature);
        }
        all
    }

    fn fragility(&self) -> Fragility {
        Fragility {
            median: libm::exp(self.centre - self.level / self.slope),
            dispersion: self.slope.recip(),
        }
    }

    /// The fragility with its errors; `None` if the information is singular.
    fn fit(&self, counts: &[Count]) -> Option<FragilityFit> {
        let mut information = Slopes::default();
        for one in counts {
            let (z, x) = (self.deviation(one), one.log_intensity - self.centre);
            let expected = one.n * density(z) / (mills(z) * below(z));
            // Without an expected effect beyond the range of numbers.
            information.add(x, 0.0, if expected.is_finite() { expected } else { 0.0 });
        }
        // Covariance of level and slope, and by the chain rule of ln θ = centre − level/slope and β = 1/slope.
        let by_level = solved(information.curvature, [1.0, 0.0])?;
        let by_slope = solved(information.curvature, [0.0, 1.0])?;
        let of = |one: [f64; 2], other: [f64; 2]| {
            let turned = [
                by_level[0] * other[0] + by_slope[0] * other[1],
                by_level[1] * other[0] + by_slope[1] * other[1],
            ];
            one[0] * turned[0] + one[1] * turned[1]
        };
        let log_median = [-self.slope.recip(), self.level / (self.slope * self.slope)];
        let dispersion = [0.0, -(self.slope * self.slope).recip()];
        let [error_of_log_median, error_of_dispersion] = [log_median, dispersion].map(|one| of(one, one).sqrt());
        Some(FragilityFit {
            fragility: self.fragility(),
            error_of_log_median,
            error_of_dispersion,
            correlation: of(log_median, dispersion) / (error_of_log_median * error_of_dispersion),
            minus_log_likelihood: -self.log_likelihood(counts),
        })
    }
}

impl Slopes {
    fn add(&mut self, x: f64, gradient: f64, curvature: f64) {
        self.gradient[0] += gradient;
        self.gradient[1] += gradient * x;
        self.curvature[0] += curvature;
        self.curvature[1] += curvature * x;
        self.curvature[2] += curvature * x * x;
    }
}
