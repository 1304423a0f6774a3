//! The values of a varying field: listed, at equal distances, or distributed.

use pounding_text::Refused;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::distribution::{FINITE, LogNormal, Normal, POSITIVE, bounds, require};

/// The values of a field.
#[derive(Debug, Clone, PartialEq)]
pub enum Spread {
    /// A list of numbers, or of any values of the field.
    Values(Vec<Value>),
    /// At equal distances.
    Grid(Grid),
    /// Uniformly distributed between two numbers.
    Uniform(Between),
    /// Distributed with a uniform logarithm, between two numbers > 0.
    LogUniform(Between),
    /// Normally distributed.
    Normal(Normal),
    /// Distributed with a normal logarithm.
    LogNormal(LogNormal),
}

/// Numbers at equal distances, or logarithms of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "GridFile")]
#[schemars(with = "GridFile")]
pub struct Grid {
    /// The first number.
    pub from: f64,
    /// The last one.
    pub to: f64,
    /// Number of values, including both ends, ≥ 2.
    pub count: u64,
    /// Kind of spacing.
    pub spacing: Spacing,
    /// The power of ten whose parts have at most fifteen digits here; `None` if it is not an exact 64-bit number.
    #[serde(skip_serializing)]
    parts: Option<f64>,
}

/// Kind of spacing of the numbers of a grid.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// Equal differences.
    #[default]
    Linear,
    /// Equal ratios; both ends are > 0.
    Log,
}

/// A grid in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct GridFile {
    /// The first number.
    from: f64,
    /// The last number.
    to: f64,
    /// Number of values, including both ends, ≥ 2.
    count: u64,
    /// `linear` (default), or `log`: equal ratios, for numbers > 0.
    #[serde(default)]
    spacing: Spacing,
}

/// The ends of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "BetweenFile")]
#[schemars(with = "BetweenFile")]
pub struct Between {
    /// Its lower end.
    pub from: f64,
    /// Its upper end, above the lower one.
    pub to: f64,
}

/// The ends of an interval in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct BetweenFile {
    /// The lower end.
    from: f64,
    /// The upper end.
    to: f64,
}

impl TryFrom<GridFile> for Grid {
    type Error = Refused;

    fn try_from(words: GridFile) -> Result<Self, Refused> {
        let GridFile { from, to, count, spacing } = words;
        let allowed = "a whole number >= 2; for one number use `values`";
        require(count >= 2, "count", count as f64, allowed)?;
        let (valid, allowed): (fn(f64) -> bool, _) = match spacing {
            Spacing::Linear => (|_| true, FINITE),
            Spacing::Log => (|end| end > 0.0, "a finite number > 0 with the spacing `log`"),
        };
        require(valid(from), "from", from, allowed)?;
        require(valid(to), "to", to, allowed)?;
        let apart = (to - from).is_finite() && to.total_cmp(&from).is_ne();
        require(apart, "to", to, "another number than `from`, at a finite distance")?;
        Ok(Self {
            from,
            to,
            count,
            spacing,
            parts: parts(from.abs().max(to.abs())),
        })
    }
}

/// The power of ten 10ᵏ, k from 0 to 22, with which a number has fifteen digits before its point. A whole number divided by it is the
/// 64-bit number closest to the decimal fraction.
fn parts(largest: f64) -> Option<f64> {
    let powers = (0..=22).map(|power| libm::pow(10.0, f64::from(power)));
    let mut fitting = powers.filter(|power| (1e14..1e15).contains(&(largest * power)));
    fitting.next()
}

impl TryFrom<BetweenFile> for Between {
    type Error = Refused;

    fn try_from(BetweenFile { from, to }: BetweenFile) -> Result<Self, Refused> {
        bounds(Some(from), Some(to))?;
        require((to - from).is_finite(), "to", to, "a number at a finite distance from `from`")?;
        Ok(Self { from, to })
    }
}

impl Grid {
    /// The number `index`, < count.
    pub(super) fn at(&self, index: u64) -> f64 {
        let last = self.count - 1;
        if index == 0 {
            return self.from;
        }
        if index == last {
            return self.to;
        }
        let part = index as f64 / last as f64;
        match self.spacing {
            Spacing::Linear => {
                let value = self.from + (self.to - self.from) * part;
                // Rounding turns 0.1 into 0.09999999999999999, which nobody wrote.
                self.parts.map_or(value, |parts| (value * parts).round() / parts)
            }
            Spacing::Log => self.from * libm::exp(part * libm::log(self.to / self.from)),
        }
    }
}

impl Spread {
    /// Number of values; `None` for a sampled field.
    pub(super) fn count(&self) -> Option<u64> {
        match self {
            Self::Values(values) => Some(values.len() as u64),
            Self::Grid(grid) => Some(grid.count),
            Self::Uniform(_) | Self::LogUniform(_) | Self::Normal(_) | Self::LogNormal(_) => None,
        }
    }

    /// Refuses an interval from 0 or less where its logarithm is asked for.
    pub(super) fn check(&self) -> Result<(), Refused> {
        match self {
            Self::LogUniform(Between { from, .. }) => require(*from > 0.0, "log_uniform.from", *from, POSITIVE),
            Self::Values(_) | Self::Grid(_) | Self::Uniform(_) | Self::Normal(_) | Self::LogNormal(_) => Ok(()),
        }
    }

    /// The quantile of a sampled field for a part > 0 and < 1; `None` for other fields.
    pub(super) fn sample(&self, part: f64) -> Option<f64> {
        let within = |value: f64, from: Option<f64>, to: Option<f64>| {
            // Rounding must not leave the bounds.
            let value = from.map_or(value, |from| value.max(from));
            to.map_or(value, |to| value.min(to))
        };
        match self {
            Self::Values(_) | Self::Grid(_) => None,
            Self::Uniform(Between { from, to }) => Some(within(from + part * (to - from), Some(*from), Some(*to))),
            Self::LogUniform(Between { from, to }) => {
                let value = from * libm::exp(part * libm::log(to / from));
                Some(within(value, Some(*from), Some(*to)))
            }
            Self::Normal(normal) => Some(within(normal.sample(part), normal.from, normal.to)),
            Self::LogNormal(normal) => Some(within(normal.sample(part), normal.from, normal.to)),
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::super::file::Vary;
    use super::Spread;

    fn spread(words: &serde_json::Value) -> Result<Spread, String> {
        let mut whole = json!({"field": "x"});
        whole
            .as_object_mut()
            .expect("a table")
            .extend(words.as_object().expect("a table").clone());
        let vary: Vary = serde_json::from_value(whole).map_err(|error| error.to_string())?;
        Ok(vary.spread)
    }

    #[test]
    fn reference_numbers_of_grids() {
        let numbers = |words| match spread(&words) {
            Ok(Spread::Grid(grid)) => (0..grid.count).map(|index| grid.at(index)).collect(),
            other => panic!("{other:?}"),
        };
        let linear: Vec<f64> = numbers(json!({"grid": {"from": 0.0, "to": 0.3, "count": 4}}));
        assert_eq!(linear, [0.0, 0.1, 0.2, 0.3]);
        let linear: Vec<f64> = numbers(json!({"grid": {"from": 0.0, "to": 0.12, "count": 7}}));
        assert_eq!(linear, [0.0, 0.02, 0.04, 0.06, 0.08, 0.1, 0.12]);
        let linear: Vec<f64> = numbers(json!({"grid": {"from": 1e6, "to": -1e-3, "count": 3}}));
        assert_eq!(linear, [1e6, 499_999.999_5, -1e-3]);
        let log = numbers(json!({"grid": {"from": 1.0, "to": 1e3, "count": 4, "spacing": "log"}}));
        let near = log.iter().zip([1.0, 10.0, 100.0, 1e3]);
        assert!(near.clone().all(|(a, b): (&f64, f64)| (a / b - 1.0).abs() < 1e-14), "{log:?}");
    }

    #[test]
    fn limit_samples_keep_their_bounds_and_their_order() {
        for words in [
            json!({"uniform": {"from": -1.0, "to": 3.0}}),
            json!({"log_uniform": {"from": 1e-3, "to": 10.0}}),
            json!({"normal": {"mean": 1.0, "standard_deviation": 0.5, "from": 0.2, "to": 3.0}}),
            json!({"log_normal": {"median": 1.0, "log_standard_deviation": 0.4, "from": 0.3, "to": 2.5}}),
        ] {
            let spread = spread(&words).expect("a spread");
            let samples: Vec<f64> = [1e-17, 0.01, 0.3, 0.5, 0.7, 0.99, 1.0 - 1e-16]
                .iter()
                .filter_map(|part| spread.sample(*part))
                .collect();
            assert!(samples.is_sorted() && samples.len() == 7, "{words} {samples:?}");
            assert!(samples[0] >= -1.0 && samples[6] <= 10.0, "{words} {samples:?}");
        }
    }

    #[test]
    fn reference_medians_and_deviations() {
        let at = |words: &_, part| spread(words).expect("a spread").sample(part).expect("a number");
        let normal = json!({"normal": {"mean": 2.0, "standard_deviation": 0.5}});
        assert!((at(&normal, 0.5) - 2.0).abs() < 1e-15);
        // One standard deviation above the mean.
        assert!((at(&normal, 0.841_344_746_068_543) - 2.5).abs() < 1e-13);
        let log = json!({"log_normal": {"median": 2.0, "log_standard_deviation": 0.5}});
        let wanted = 2.0 * libm::exp(0.5);
        assert!((at(&log, 0.841_344_746_068_543) - wanted).abs() < 1e-13);
    }

    #[test]
    fn extreme_words_that_are_refused() {
        for (words, message) in [
            (json!({}), "found no values"),
            (json!({"values": []}), "values: found an empty list"),
            (
                json!({"values": [1], "uniform": {"from": 0.0, "to": 1.0}}),
                "found both `values` and `uniform`",
            ),
            (json!({"grid": {"from": 0.0, "to": 1.0, "count": 1}}), "count: found 1"),
            (json!({"grid": {"from": 1.0, "to": 1.0, "count": 3}}), "to: found 1"),
            (
                json!({"grid": {"from": 0.0, "to": 1.0, "count": 3, "spacing": "log"}}),
                "from: found 0",
            ),
            (json!({"uniform": {"from": 2.0, "to": 1.0}}), "to: found 1"),
            (json!({"log_uniform": {"from": 0.0, "to": 1.0}}), "log_uniform.from: found 0"),
            (
                json!({"normal": {"mean": 0.0, "standard_deviation": 0.0}}),
                "standard_deviation: found 0",
            ),
            (
                json!({"normal": {"mean": 0.0, "standard_deviation": 1.0, "from": 9.0}}),
                "from: found 9",
            ),
            (
                json!({"log_normal": {"median": 0.0, "log_standard_deviation": 1.0}}),
                "median: found 0",
            ),
        ] {
            let found = spread(&words).expect_err("refused");
            assert!(found.starts_with(message), "{words}: {found}");
        }
    }
}
