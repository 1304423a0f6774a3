//! Cautions of an answer: effects outside the model, and responses that a row cannot bear, at one intensity.

use pounding_assess::{JudgedSeparations, MotionLine, wilson_of};
use pounding_risk::{AnnualFrequency, Risk};
use pounding_scene::{Error, Excess, Implausible, Simulation};
use pounding_text::{digits, percent};

use super::{RiskReport, counted, three};

/// A run of a row at that intensity, judged.
#[derive(Debug, Clone)]
pub struct JudgedRun {
    doubts: Vec<Implausible>,
    excesses: Vec<Excess>,
}

impl JudgedRun {
    /// Runs a row and judges its responses: with its structures apart, if touching alone is asked for, else as it is. `doubts` are the unusual
    /// values of the row under the motion as recorded.
    ///
    /// # Errors
    /// Those of [`Simulation::run`].
    pub fn of(prepared: &Simulation, doubts: Vec<Implausible>, apart: bool) -> Result<Self, Error> {
        let excesses = if apart {
            JudgedSeparations::of(prepared)?.excesses
        } else {
            prepared.all_excesses(&prepared.run(None)?)
        };
        Ok(Self { doubts, excesses })
    }
}

impl RiskReport<'_> {
    /// Index of the intensity that cautions are about: the one nearest to the largest median of a state, the middle one if there is none.
    pub fn judged_stripe(&self) -> usize {
        let all = &self.runs.intensities;
        let medians = self.states.iter().filter_map(|(_, risk)| Some(risk.fragility()?.median));
        let Some(median) = medians.reduce(f64::max) else {
            return all.len() / 2;
        };
        let far = |index: &usize| libm::log(all[*index] / median).abs();
        (0..all.len()).min_by(|one, other| far(one).total_cmp(&far(other))).unwrap_or(0)
    }

    /// Adds what the runs at [that intensity](Self::judged_stripe) say about the model. Runs that failed say nothing.
    #[must_use]
    pub fn with_cautions(self, lines: &[MotionLine<JudgedRun>]) -> Self {
        let found = lines.iter().filter_map(|line| Some((line, line.found.as_ref().ok()?)));
        let doubts = found
            .clone()
            .flat_map(|(line, run)| run.doubts.iter().map(|doubt| (line.motion.as_str(), doubt)));
        let at = self.runs.intensities.get(self.judged_stripe()).copied();
        let at = at.map_or_else(String::new, |at| format!("at {} g: ", three(at)));
        let excesses = Excess::gathered(found.map(|(_, run)| &run.excesses), "run");
        let excesses = excesses.iter().map(|one| format!("{at}{one}"));
        let cautions = Implausible::lines(doubts).into_iter().chain(excesses).collect();
        Self { cautions, ..self }
    }
}

/// The frequency by the shares as they are, if the bounds of the fitted one exclude it.
pub(super) fn shares_differ(risk: &Risk) -> Option<&AnnualFrequency> {
    let ([low, high], of_shares) = (risk.rate_bounds?, risk.of_shares.as_ref()?);
    (!(low..=high).contains(&of_shares.rate)).then_some(of_shares)
}

/// The frequency by the shares, in words.
pub(super) fn says_shares(of_shares: &AnnualFrequency) -> String {
    format!(
        "the shares of events alone, joined by lines, give once in {} years: {} per year",
        digits(of_shares.return_period().round()),
        three(of_shares.rate)
    )
}

/// Part of the intensities at which 95 % bounds of shares leave out the fragility by chance alone \[–\].
const BY_CHANCE: f64 = 0.05;

/// Warns of a fragility that misses the shares at more intensities than by chance. It names the intensity at which the fragility lies farthest
/// beyond the 95 % bounds of the share.
pub(super) fn says_misfit(name: &str, risk: &Risk) -> Option<String> {
    let fragility = risk.fragility()?;
    let known = risk.stripes.all.iter().filter(|stripe| stripe.n() > 0);
    let missed = known.clone().filter_map(|stripe| {
        let (low, high) = wilson_of(stripe.share(), stripe.n() as u64);
        let fitted = fragility.probability(stripe.intensity);
        let distance = (low - fitted).max(fitted - high);
        (distance > 0.0).then_some((distance, stripe, [low, high], fitted))
    });
    let (n, n_missed) = (known.count(), missed.clone().count());
    let (_, stripe, bounds, fitted) = missed.max_by(|one, other| one.0.total_cmp(&other.0))?;
    (n_missed as f64 > BY_CHANCE * n as f64).then(|| {
        let of_shares = risk.of_shares.as_ref().map(|one| format!("; {}", says_shares(one)));
        format!(
            "the lognormal fragility of {name} misses the share at {n_missed} of {n} intensities, most at {} g: {} events (95 %: {} to {}) against \
             {}{}",
            three(stripe.intensity),
            counted(stripe),
            percent(bounds[0]),
            percent(bounds[1]),
            percent(fitted),
            of_shares.unwrap_or_default()
        )
    })
}
