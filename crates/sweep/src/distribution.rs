//! Normal distributions, of a number or of its logarithm, perhaps cut off.

use pounding_text::{Refused, plain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantile::{probability, quantile};

/// A normal distribution, optionally truncated.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "NormalFile")]
#[schemars(with = "NormalFile")]
pub struct Normal {
    /// Mean.
    pub mean: f64,
    /// Standard deviation, > 0.
    pub standard_deviation: f64,
    /// Lower bound of all values.
    pub from: Option<f64>,
    /// Upper bound of all values.
    pub to: Option<f64>,
}

/// A normal distribution in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct NormalFile {
    /// Mean.
    mean: f64,
    /// Standard deviation, > 0.
    standard_deviation: f64,
    /// Lower bound: values below are excluded, and all others are more likely in proportion.
    from: Option<f64>,
    /// Upper bound: values above are excluded, and all others are more likely in proportion.
    to: Option<f64>,
}

/// A distribution with a normal logarithm, optionally truncated.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "LogNormalFile")]
#[schemars(with = "LogNormalFile")]
pub struct LogNormal {
    /// Median, > 0.
    pub median: f64,
    /// Standard deviation of the natural logarithm \[–\], > 0.
    pub log_standard_deviation: f64,
    /// Lower bound of all values, > 0.
    pub from: Option<f64>,
    /// Upper bound of all values.
    pub to: Option<f64>,
}

/// A distribution whose logarithm is normal, in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct LogNormalFile {
    /// Median, > 0.
    median: f64,
    /// Standard deviation of the natural logarithm, > 0.
    log_standard_deviation: f64,
    /// Lower bound, > 0: values below are excluded, and all others are more likely in proportion.
    from: Option<f64>,
    /// Upper bound: values above are excluded, and all others are more likely in proportion.
    to: Option<f64>,
}

impl TryFrom<NormalFile> for Normal {
    type Error = Refused;

    fn try_from(words: NormalFile) -> Result<Self, Refused> {
        let deviation = words.standard_deviation;
        require(true, "mean", words.mean, FINITE)?;
        require(deviation > 0.0, "standard_deviation", deviation, POSITIVE)?;
        bounds(words.from, words.to)?;
        let normal = Self {
            mean: words.mean,
            standard_deviation: deviation,
            from: words.from,
            to: words.to,
        };
        normal.standard().check(words.from, words.to)?;
        Ok(normal)
    }
}

impl TryFrom<LogNormalFile> for LogNormal {
    type Error = Refused;

    fn try_from(words: LogNormalFile) -> Result<Self, Refused> {
        let deviation = words.log_standard_deviation;
        require(words.median > 0.0, "median", words.median, POSITIVE)?;
        require(deviation > 0.0, "log_standard_deviation", deviation, POSITIVE)?;
        if let Some(from) = words.from {
            require(from > 0.0, "from", from, POSITIVE)?;
        }
        if let Some(to) = words.to {
            require(to > 0.0, "to", to, POSITIVE)?;
        }
        bounds(words.from, words.to)?;
        let log_normal = Self {
            median: words.median,
            log_standard_deviation: deviation,
            from: words.from,
            to: words.to,
        };
        log_normal.standard().check(words.from, words.to)?;
        Ok(log_normal)
    }
}

/// The kept part of a standard normal distribution, as probabilities.
#[derive(Debug, Clone, Copy)]
struct Truncation {
    from: f64,
    to: f64,
}

impl Truncation {
    /// Truncation between two bounds, if they are given.
    fn between(from: Option<f64>, to: Option<f64>) -> Self {
        Self {
            from: from.map_or(0.0, probability),
            to: to.map_or(1.0, probability),
        }
    }

    /// Refuses bounds between which next to nothing is left: quantiles there would be rounding.
    fn check(self, from: Option<f64>, to: Option<f64>) -> Result<(), Refused> {
        let allowed = "bounds with more than a millionth of the distribution between them";
        let valid = self.to - self.from > 1e-6;
        let given = from.map(|from| ("from", from)).or(to.map(|to| ("to", to)));
        given.map_or(Ok(()), |(field, found)| require(valid, field, found, allowed))
    }

    fn quantile(self, part: f64) -> f64 {
        quantile(self.from + part * (self.to - self.from))
    }
}

impl Normal {
    /// The quantile of a part of all values, up to rounding.
    pub(super) fn sample(&self, part: f64) -> f64 {
        self.mean + self.standard_deviation * self.standard().quantile(part)
    }

    fn standard(&self) -> Truncation {
        let standard = |bound: f64| (bound - self.mean) / self.standard_deviation;
        Truncation::between(self.from.map(standard), self.to.map(standard))
    }
}

impl LogNormal {
    /// The quantile of a part of all values, up to rounding.
    pub(super) fn sample(&self, part: f64) -> f64 {
        let standard = self.standard().quantile(part);
        self.median * libm::exp(self.log_standard_deviation * standard)
    }

    fn standard(&self) -> Truncation {
        let standard = |bound: f64| libm::log(bound / self.median) / self.log_standard_deviation;
        Truncation::between(self.from.map(standard), self.to.map(standard))
    }
}

/// Refuses a number that is not valid.
pub(super) fn require(valid: bool, field: &'static str, found: f64, allowed: &'static str) -> Result<(), Refused> {
    if valid && found.is_finite() {
        Ok(())
    } else {
        Err(Refused::at(field).found(plain(found)).allowed(allowed))
    }
}

pub(super) const FINITE: &str = "a finite number";
pub(super) const POSITIVE: &str = "a finite number > 0";
const ABOVE: &str = "a finite number above `from`";

/// Refuses bounds of which the upper one is not above the lower one.
pub(super) fn bounds(from: Option<f64>, to: Option<f64>) -> Result<(), Refused> {
    if let Some(from) = from {
        require(true, "from", from, FINITE)?;
    }
    let Some(to) = to else { return Ok(()) };
    require(from.is_none_or(|from| to > from), "to", to, ABOVE)
}
