//! Gaps that are too narrow, where a wider gap can be worse.

use super::{PairCase, Scan, any_and_each, asked, words_of};
use crate::StudyError;
use crate::files::direction;
use crate::listed::listed;
use crate::research::surveys::cases::{Case, Response, with_gap};
use crate::statistics::{quantile, sorted};
use pounding_assess::Separation;
use pounding_scene::{Scene, parallel};
use pounding_text::Table;

/// Runs of pairs over a range of gaps.
pub(super) struct Gaps<'a> {
    pub(super) swept: Vec<Swept<'a>>,
    pub(super) ratios: Vec<f64>,
}

/// A pair under a motion, over a range of gaps.
pub(super) struct Swept<'a> {
    pub(super) asked: PairCase<'a>,
    /// Smallest gap at which the pair does not touch \[m\].
    required: f64,
    /// Rising gaps, relative to the required one, with the results at each.
    runs: Vec<(f64, Response)>,
    /// Peak displacements of both structures without neighbours \[m\].
    alone: [f64; 2],
}

listed! {
    /// A quantity to compare from gap to gap.
    pub(super) enum Quantity { key: &'static str;
        LeftDrift = "peak drift of the slower structure",
        RightDrift = "peak drift of the faster structure",
        /// The drift over the one without neighbours, at least 1.
        LeftBeyond = "drift of the slower structure, at least that alone",
        RightBeyond = "drift of the faster structure, at least that alone",
        Impulse = "total impulse",
        Collisions = "collisions",
    }
}

impl Quantity {
    /// The quantity of a run. Drifts are relative to those without neighbours, `alone` \[m\].
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

/// Smallest rise that counts, relative to its start \[–\].
const NOTICED: f64 = 0.01;

/// Rises of a quantity with a wider gap.
#[derive(Debug, Clone, Copy, Default)]
struct Rises {
    /// Stretches of gaps over which the quantity rises by more than [`NOTICED`].
    stretches: usize,
    /// Part of the gaps up to the required one within such stretches \[–\].
    share: f64,
    /// The largest ratio of a value to that at a narrower gap, then the narrower and the wider gap over the required one.
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
    /// The quantity over the relative gap; drifts are relative to those without neighbours.
    pub(super) fn curve(&self, quantity: Quantity) -> Vec<(f64, f64)> {
        let point = |(gap, response): &(f64, Response)| (*gap, quantity.of(response, self.alone));
        self.runs.iter().map(point).collect()
    }

    /// The largest ratio of a value to that at a narrower gap.
    pub(super) fn worst(&self, quantity: Quantity) -> f64 {
        Rises::of(&self.curve(quantity)).worst.0
    }
}

impl<'a> Gaps<'a> {
    pub(super) fn of(scan: &Scan, template: &Scene, cases: &'a [Case]) -> Result<Self, StudyError> {
        let all = asked(cases, &scan.longer_periods_s, &scan.period_ratios);
        let swept = parallel::try_each(&all, |one| -> Result<_, StudyError> {
            let scene = one.scene(template);
            let separation = Separation::of(&one.case.prepared(&scene)?)?[0];
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

    /// Table with one row per pair, motion and quantity.
    pub(super) fn table(&self) -> String {
        let of_pair = |one| Quantity::ALL.map(|quantity| (one, quantity, Rises::of(&Swept::curve(one, quantity))));
        Table::of(self.swept.iter().flat_map(of_pair))
            .column("period_ratio", |(one, ..): &(&Swept<'_>, _, _)| one.asked.ratio)
            .column("longer_period_s", |(one, ..)| one.asked.longer)
            .column("motion", |(one, ..)| one.asked.case.name.clone())
            .column("direction", |(one, ..)| direction(one.asked.case.reversed))
            .column("required_m", |(one, ..)| one.required)
            .column("quantity", |(_, quantity, _)| quantity.key())
            .column("rising_stretches", |(.., rises)| rises.stretches)
            .column("rising_share_of_gaps", |(.., rises)| rises.share)
            .column("worst_ratio", |(.., rises)| rises.worst.0)
            .column("narrower_gap_over_required", |(.., rises)| rises.worst.1)
            .column("wider_gap_over_required", |(.., rises)| rises.worst.2)
            .csv()
    }

    /// Table with one row per ratio of periods and quantity; rows over all ratios are first.
    pub(super) fn summary(&self) -> String {
        let rises = |(ratio, quantity)| {
            let own = self.swept.iter().filter(|one| one.asked.is_of(ratio));
            let rises: Vec<_> = own.map(|one| Rises::of(&one.curve(quantity))).collect();
            (ratio, quantity, rises)
        };
        let of_ratio = |ratio| Quantity::ALL.map(|quantity| rises((ratio, quantity)));
        let part = |rises: &[Rises], number: fn(&Rises) -> f64, part| quantile(&sorted(rises.iter().map(number)), part);
        Table::of(any_and_each(&self.ratios).flat_map(of_ratio))
            .column("period_ratio", |(ratio, ..)| words_of(*ratio))
            .column("quantity", |(_, quantity, _)| quantity.key())
            .column("cases", |(.., rises)| rises.len())
            .column("cases_with_a_rise", |(.., rises)| {
                rises.iter().filter(|one| one.stretches > 0).count()
            })
            .column("median_rising_stretches", |(.., rises)| {
                part(rises, |one| one.stretches as f64, 0.5)
            })
            .column("median_rising_share_of_gaps", |(.., rises)| part(rises, |one| one.share, 0.5))
            .column("median_worst_ratio", |(.., rises)| part(rises, |one| one.worst.0, 0.5))
            .column("quantile_95_worst_ratio", |(.., rises)| part(rises, |one| one.worst.0, 0.95))
            .column("largest_worst_ratio", |(.., rises)| part(rises, |one| one.worst.0, 1.0))
            .csv()
    }
}

#[cfg(test)]
mod tests {
    use super::Rises;

    #[test]
    fn reference_rises_of_a_curve_by_hand() {
        // The values fall, rise by half, fall, rise to twice the least, and end lower.
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
