//! The required width of every pair under every motion, and what the rules ask for.

use super::{Asked, RequiredGap, asked, csv};
use crate::StudyError;
use crate::research::surveys::cases::{Case, each};
use crate::statistics::{quantile, sorted};
use pounding_scene::{Rule, Scene, Separation};
use pounding_text::digits;

/// Required widths, ratio after ratio.
pub(super) struct Widths<'a> {
    found: Vec<(Asked<'a>, Separation)>,
    pub(super) ratios: Vec<f64>,
}

/// How a rule does over some pairs and motions.
pub(super) struct Score {
    pub(super) cases: usize,
    /// Where it asks for less than is required.
    pub(super) unsafe_cases: usize,
    /// Required over asked for \[–\], in rising order.
    ratios: Vec<f64>,
}

impl Score {
    pub(super) fn share(&self) -> f64 {
        self.unsafe_cases as f64 / self.cases as f64
    }

    /// Quantile of required over asked for.
    pub(super) fn quantile(&self, part: f64) -> f64 {
        quantile(&self.ratios, part).unwrap_or(0.0)
    }
}

impl<'a> Widths<'a> {
    pub(super) fn of(settings: &RequiredGap, template: &Scene, cases: &'a [Case]) -> Result<Self, StudyError> {
        let all = asked(cases, &settings.longer_periods_s, &settings.period_ratios);
        let found = each(&all, |one| {
            let prepared = one.case.prepared(&one.scene(template))?;
            Ok(prepared.separations()?[0])
        })?;
        Ok(Self {
            found: all.into_iter().zip(found).collect(),
            ratios: settings.period_ratios.clone(),
        })
    }

    /// How a rule does where the ratio of periods is the one asked for, or anywhere.
    pub(super) fn score(&self, rule: Rule, ratio: Option<f64>) -> Score {
        let of = |(asked, _): &&(Asked<'_>, Separation)| ratio.is_none_or(|ratio| asked.ratio.total_cmp(&ratio).is_eq());
        let own = self.found.iter().filter(of);
        let ratios = sorted(own.map(|(_, one)| one.required / width_of(rule, one)));
        Score {
            cases: ratios.len(),
            unsafe_cases: ratios.iter().filter(|ratio| **ratio > 1.0).count(),
            ratios,
        }
    }

    /// A row per pair and motion; what other rules ask for follows from the peaks.
    pub(super) fn table(&self) -> Vec<u8> {
        let header = [
            "period_ratio",
            "longer_period_s",
            "motion",
            "direction",
            "required_m",
            "time_s",
            "peak_left_m",
            "peak_right_m",
            "ddc_m",
        ];
        let row = |(asked, one): &(Asked<'_>, Separation)| {
            let mut row = vec![
                digits(asked.ratio),
                digits(asked.longer),
                asked.case.name.clone(),
                asked.case.direction().into(),
            ];
            let ddc = width_of(Rule::Ddc, one);
            let own = [one.required, one.time, one.peaks[0], one.peaks[1], ddc];
            row.extend(own.map(digits));
            row
        };
        csv(&header, &self.found.iter().map(row).collect::<Vec<_>>())
    }

    /// A row per rule and ratio of periods, that of all of them first.
    pub(super) fn rules(&self) -> Vec<u8> {
        let header = [
            "period_ratio",
            "rule",
            "cases",
            "unsafe_cases",
            "unsafe_share",
            "median",
            "quantile_95",
            "largest",
        ];
        let mut rows = Vec::new();
        let ratios = std::iter::once(None).chain(self.ratios.iter().copied().map(Some));
        for ratio in ratios {
            for rule in Rule::COMMON {
                let score = self.score(rule, ratio);
                let mut row = vec![ratio.map_or_else(|| "all".into(), digits), rule.name().into()];
                row.extend([score.cases, score.unsafe_cases].map(|count| count.to_string()));
                let quantiles = [0.5, 0.95, 1.0].map(|part| score.quantile(part));
                row.push(digits(score.share()));
                row.extend(quantiles.map(digits));
                rows.push(row);
            }
        }
        csv(&header, &rows)
    }
}

/// Width of a rule that asks for no heights \[m\].
fn width_of(rule: Rule, one: &Separation) -> f64 {
    rule.width(one).unwrap_or(f64::NAN)
}
