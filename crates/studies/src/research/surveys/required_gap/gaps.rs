//! Gaps that are too narrow: where a wider one is worse.

use super::{Asked, Scan, asked, csv};
use crate::StudyError;
use crate::research::surveys::cases::{Case, Response, each, with_gap};
use crate::statistics::{quantile, sorted};
use pounding_scene::Scene;
use pounding_text::digits;
use strum::EnumCount;

/// Runs of pairs over gaps.
pub(super) struct Gaps<'a> {
    pub(super) swept: Vec<Swept<'a>>,
    pub(super) ratios: Vec<f64>,
}

/// A pair under a motion over gaps.
pub(super) struct Swept<'a> {
    pub(super) asked: Asked<'a>,
    /// Width from which on the pair does not touch \[m\].
    required: f64,
    /// Gaps over the required one, rising, with what happens there.
    runs: Vec<(f64, Response)>,
    /// Peak displacement of both standing alone \[m\].
    alone: [f64; 2],
}

/// What is compared from gap to gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
pub(super) enum Quantity {
    Impulse,
    LeftDrift,
    RightDrift,
    /// What of the drift lies beyond that alone: where it is less it counts as that.
    LeftBeyond,
    RightBeyond,
    Collisions,
}

impl Quantity {
    pub(super) const ALL: [Self; Self::COUNT] = [
        Self::LeftDrift,
        Self::RightDrift,
        Self::LeftBeyond,
        Self::RightBeyond,
        Self::Impulse,
        Self::Collisions,
    ];

    fn key(self) -> &'static str {
        match self {
            Self::Impulse => "total impulse",
            Self::LeftDrift => "peak drift of the slower structure",
            Self::RightDrift => "peak drift of the faster structure",
            Self::LeftBeyond => "drift of the slower structure, at least that alone",
            Self::RightBeyond => "drift of the faster structure, at least that alone",
            Self::Collisions => "collisions",
        }
    }

    /// The quantity of a run; drifts over those alone \[m\].
    fn of(self, response: &Response, alone: [f64; 2]) -> f64 {
        match self {
            Self::Impulse => response.impulse,
            Self::LeftDrift => response.peaks[0] / alone[0],
            Self::RightDrift => response.peaks[1] / alone[1],
            Self::LeftBeyond => (response.peaks[0] / alone[0]).max(1.0),
            Self::RightBeyond => (response.peaks[1] / alone[1]).max(1.0),
            Self::Collisions => response.collisions as f64,
        }
    }
}

/// Rises smaller than this part of where they begin are not counted.
const NOTICED: f64 = 0.01;

/// What a wider gap makes worse.
#[derive(Debug, Clone, Copy, Default)]
struct Rises {
    /// Stretches of gaps over which the quantity rises by more than [`NOTICED`].
    stretches: usize,
    /// Part of the gaps up to the required one that lie in such stretches \[–\].
    share: f64,
    /// The largest ratio of the value at a gap to that at a narrower one, and both gaps over the required one.
    worst: (f64, f64, f64),
}

impl Rises {
    fn of(values: &[(f64, f64)]) -> Self {
        let mut rises = Self {
            worst: (1.0, 0.0, 0.0),
            ..Self::default()
        };
        let Some(&first) = values.first() else {
            return rises;
        };
        let (mut start, mut last, mut least) = (first, first, first);
        let mut end = |from: (f64, f64), to: (f64, f64)| {
            if to.1 > (1.0 + NOTICED) * from.1 {
                rises.stretches += 1;
                rises.share += to.0 - from.0;
            }
        };
        let mut worst = rises.worst;
        for &value in values.iter().skip(1) {
            if value.1 < last.1 {
                end(start, last);
                start = value;
            }
            let ratio = value.1 / least.1;
            if least.1 > 0.0 && ratio > worst.0 {
                worst = (ratio, least.0, value.0);
            }
            if value.1 < least.1 {
                least = value;
            }
            last = value;
        }
        end(start, last);
        rises.worst = worst;
        rises
    }
}

impl Swept<'_> {
    /// A quantity over the gaps over the required one; drifts over those alone.
    pub(super) fn curve(&self, quantity: Quantity) -> Vec<(f64, f64)> {
        let point = |(gap, response): &(f64, Response)| (*gap, quantity.of(response, self.alone));
        self.runs.iter().map(point).collect()
    }

    /// The largest ratio of the value at a gap to that at a narrower one.
    pub(super) fn worst(&self, quantity: Quantity) -> f64 {
        Rises::of(&self.curve(quantity)).worst.0
    }
}

impl<'a> Gaps<'a> {
    pub(super) fn of(scan: &Scan, template: &Scene, cases: &'a [Case]) -> Result<Self, StudyError> {
        let all = asked(cases, &scan.longer_periods_s, &scan.period_ratios);
        let swept = each(&all, |one| {
            let scene = one.scene(template);
            let separation = one.case.prepared(&scene)?.separations()?[0];
            let required = separation.required;
            let run = |index: usize| {
                let part = index as f64 / scan.n_gaps as f64;
                let response = one.case.run(&with_gap(&scene, part * required))?;
                Ok((part, response))
            };
            let runs: Result<Vec<_>, StudyError> = (0..scan.n_gaps).map(run).collect();
            Ok(Swept {
                asked: *one,
                required,
                runs: runs?,
                alone: separation.peaks,
            })
        })?;
        Ok(Self {
            swept,
            ratios: scan.period_ratios.clone(),
        })
    }

    /// A row per pair, motion and quantity.
    pub(super) fn table(&self) -> Vec<u8> {
        let header = [
            "period_ratio",
            "longer_period_s",
            "motion",
            "direction",
            "required_m",
            "quantity",
            "rising_stretches",
            "rising_share_of_gaps",
            "worst_ratio",
            "narrower_gap_over_required",
            "wider_gap_over_required",
        ];
        let mut rows = Vec::new();
        for one in &self.swept {
            for quantity in Quantity::ALL {
                let rises = Rises::of(&one.curve(quantity));
                let (worst, narrower, wider) = rises.worst;
                let mut row = vec![
                    digits(one.asked.ratio),
                    digits(one.asked.longer),
                    one.asked.case.name.clone(),
                    one.asked.case.direction().into(),
                    digits(one.required),
                    quantity.key().into(),
                    rises.stretches.to_string(),
                ];
                row.extend([rises.share, worst, narrower, wider].map(digits));
                rows.push(row);
            }
        }
        csv(&header, &rows)
    }

    /// A row per ratio of periods and quantity, those of all ratios first.
    pub(super) fn summary(&self) -> Vec<u8> {
        let header = [
            "period_ratio",
            "quantity",
            "cases",
            "cases_with_a_rise",
            "median_rising_stretches",
            "median_rising_share_of_gaps",
            "median_worst_ratio",
            "quantile_95_worst_ratio",
            "largest_worst_ratio",
        ];
        let mut rows = Vec::new();
        let ratios = std::iter::once(None).chain(self.ratios.iter().copied().map(Some));
        for ratio in ratios {
            for quantity in Quantity::ALL {
                let own = self
                    .swept
                    .iter()
                    .filter(|one| ratio.is_none_or(|ratio| one.asked.ratio.total_cmp(&ratio).is_eq()));
                let rises: Vec<Rises> = own.map(|one| Rises::of(&one.curve(quantity))).collect();
                let of = |number: fn(&Rises) -> f64| sorted(rises.iter().map(number));
                let stretches = of(|rises| rises.stretches as f64);
                let shares = of(|rises| rises.share);
                let worst = of(|rises| rises.worst.0);
                let rising = rises.iter().filter(|rises| rises.stretches > 0).count();
                let known = |numbers: &[f64], part| quantile(numbers, part).map_or_else(String::new, digits);
                rows.push(vec![
                    ratio.map_or_else(|| "all".into(), digits),
                    quantity.key().into(),
                    rises.len().to_string(),
                    rising.to_string(),
                    known(&stretches, 0.5),
                    known(&shares, 0.5),
                    known(&worst, 0.5),
                    known(&worst, 0.95),
                    known(&worst, 1.0),
                ]);
            }
        }
        csv(&header, &rows)
    }
}

#[cfg(test)]
mod tests {
    use super::Rises;

    #[test]
    fn reference_rises_of_a_curve_by_hand() {
        // Falls, rises by half, falls, rises to twice the least, ends lower.
        let values = [4.0, 2.0, 3.0, 1.5, 1.5, 2.0, 3.0, 0.5];
        let values: Vec<_> = values.iter().zip(0..).map(|(y, x)| (f64::from(x), *y)).collect();
        let rises = Rises::of(&values);
        assert_eq!(rises.stretches, 2);
        assert_eq!((rises.share, rises.worst), (1.0 + 3.0, (2.0, 3.0, 6.0)));
    }

    #[test]
    fn limit_what_falls_has_no_rises() {
        for values in [&[][..], &[(0.0, 1.0)], &[(0.0, 3.0), (0.5, 3.0), (1.0, 0.0)]] {
            let rises = Rises::of(values);
            assert_eq!((rises.stretches, rises.worst.0), (0, 1.0));
        }
    }
}
