//! The required width of a gap against design rules, and the effect of a wider gap that is still too narrow.
//!
//! Structures at rest touch exactly if the gap is narrower than their largest closing without neighbours: until they first touch, each
//! moves as if it were alone. Touching is therefore monotone in the gap, and the required width needs no search. The effect of touching is
//! not monotone: [`gaps`] looks for wider gaps that are worse than narrower ones.

mod figure;
mod gaps;

use super::cases::{Case, rows, sdof, set_period};
use crate::files::{Files, direction, drawn};
use crate::statistics::{quantile, sorted};
use crate::study::surveys::{RequiredGap, Scan};
use crate::{StudyError, StudyFile};
use pounding_assess::{Rule, Separation};
use pounding_scene::{Scene, parallel};
use pounding_text::{Table, digits};

/// A pair under a motion.
#[derive(Debug, Clone, Copy)]
struct PairCase<'a> {
    case: &'a Case,
    longer: f64,
    ratio: f64,
}

/// Every pair under every motion, pair by pair.
fn asked<'a>(cases: &'a [Case], longer: &[f64], ratios: &[f64]) -> Vec<PairCase<'a>> {
    let mut all = Vec::new();
    for &ratio in ratios {
        for &longer in longer {
            let of = |case| PairCase { case, longer, ratio };
            all.extend(cases.iter().map(of));
        }
    }
    all
}

impl PairCase<'_> {
    /// The template with both periods set.
    fn scene(self, template: &Scene) -> Scene {
        let mut scene = template.clone();
        set_period(sdof(&mut scene, 0), self.longer);
        set_period(sdof(&mut scene, 1), self.longer * self.ratio);
        scene
    }

    /// Whether the pair has this ratio of periods; `None` accepts all ratios.
    fn is_of(self, ratio: Option<f64>) -> bool {
        ratio.is_none_or(|ratio| self.ratio.total_cmp(&ratio).is_eq())
    }
}

pub(super) fn files(settings: &RequiredGap, file: &StudyFile, cases: &[Case]) -> Result<Files, StudyError> {
    let template = &rows(file, 2)?[0];
    let widths = Widths::of(settings, template, cases)?;
    let gaps = gaps::Gaps::of(&settings.scan, template, cases)?;
    Ok(Files::from([
        ("widths.csv".into(), widths.table().into_bytes()),
        ("rules.csv".into(), widths.rules().into_bytes()),
        ("rules.png".into(), drawn(&figure::rules(&widths), &file.path)?),
        ("unsafe.png".into(), drawn(&figure::shares(&widths), &file.path)?),
        ("gaps.csv".into(), gaps.table().into_bytes()),
        ("wider-and-worse.csv".into(), gaps.summary().into_bytes()),
        ("wider-and-worse.png".into(), drawn(&figure::gaps(&gaps), &file.path)?),
    ]))
}

/// Required widths, ratio by ratio.
struct Widths<'a> {
    found: Vec<(PairCase<'a>, Separation)>,
    ratios: Vec<f64>,
}

/// Score of a rule over some pairs and motions.
struct Score {
    cases: usize,
    /// Number of cases in which the rule gives a gap that is too narrow.
    unsafe_cases: usize,
    /// Required gap over the gap of the rule \[–\], in rising order.
    ratios: Vec<f64>,
}

impl Score {
    fn share(&self) -> f64 {
        self.unsafe_cases as f64 / self.cases as f64
    }

    /// Quantile of the required gap over the gap of the rule.
    fn quantile(&self, part: f64) -> f64 {
        quantile(&self.ratios, part).unwrap_or(0.0)
    }
}

impl<'a> Widths<'a> {
    fn of(settings: &RequiredGap, template: &Scene, cases: &'a [Case]) -> Result<Self, StudyError> {
        let all = asked(cases, &settings.longer_periods_s, &settings.period_ratios);
        let found = parallel::try_each(&all, |one| -> Result<_, StudyError> {
            let prepared = one.case.prepared(&one.scene(template))?;
            Ok(Separation::of(&prepared)?[0])
        })?;
        Ok(Self {
            found: all.into_iter().zip(found).collect(),
            ratios: settings.period_ratios.clone(),
        })
    }

    /// Score of a rule for one ratio of periods, or for all with `None`.
    fn score(&self, rule: Rule, ratio: Option<f64>) -> Score {
        let own = self.found.iter().filter(|(asked, _)| asked.is_of(ratio));
        let ratios = sorted(own.map(|(_, one)| one.required / width_of(rule, one)));
        Score {
            cases: ratios.len(),
            unsafe_cases: ratios.iter().filter(|ratio| **ratio > 1.0).count(),
            ratios,
        }
    }

    /// Table with one row per pair and motion; the widths of other rules follow from the peaks.
    fn table(&self) -> String {
        Table::of(&self.found)
            .column("period_ratio", |(asked, _)| asked.ratio)
            .column("longer_period_s", |(asked, _)| asked.longer)
            .column("motion", |(asked, _)| asked.case.name.clone())
            .column("direction", |(asked, _)| direction(asked.case.reversed))
            .column("required_m", |(_, one)| one.required)
            .column("time_s", |(_, one)| one.time)
            .column("peak_left_m", |(_, one)| one.peaks[0])
            .column("peak_right_m", |(_, one)| one.peaks[1])
            .column("ddc_m", |(_, one)| width_of(Rule::Ddc, one))
            .csv()
    }

    /// Table with one row per rule and ratio of periods; the row over all ratios is first.
    fn rules(&self) -> String {
        let of_ratio = |ratio| Rule::COMMON.into_iter().map(move |rule| (ratio, rule, self.score(rule, ratio)));
        Table::of(any_and_each(&self.ratios).flat_map(of_ratio))
            .column("period_ratio", |(ratio, ..)| words_of(*ratio))
            .column("rule", |(_, rule, _)| name_of(*rule))
            .column("cases", |(.., score)| score.cases)
            .column("unsafe_cases", |(.., score)| score.unsafe_cases)
            .column("unsafe_share", |(.., score)| score.share())
            .column("median", |(.., score)| score.quantile(0.5))
            .column("quantile_95", |(.., score)| score.quantile(0.95))
            .column("largest", |(.., score)| score.quantile(1.0))
            .csv()
    }
}

/// `None` for all ratios of periods together, then each ratio.
fn any_and_each(ratios: &[f64]) -> impl Iterator<Item = Option<f64>> {
    std::iter::once(None).chain(ratios.iter().copied().map(Some))
}

/// A ratio of periods in a table, or the word for all of them.
fn words_of(ratio: Option<f64>) -> String {
    ratio.map_or_else(|| "all".into(), digits)
}

/// Name of a rule in the table of results, which has no editions.
fn name_of(rule: Rule) -> &'static str {
    if rule == Rule::Eurocode8 {
        "EC 8"
    } else if rule == Rule::Asce7 {
        "ASCE 7"
    } else {
        rule.name()
    }
}

/// Width by a rule that needs no heights \[m\].
fn width_of(rule: Rule, one: &Separation) -> f64 {
    rule.width(one).unwrap_or(f64::NAN)
}
