//! Cautions of an answer: effects outside the model, and responses that a row cannot bear, at one intensity.

use pounding_assess::{JudgedSeparations, MotionLine};
use pounding_scene::{Error, Excess, Implausible, Simulation};

use super::RiskReport;

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
        let at = at.map_or_else(String::new, |at| format!("at {} g: ", super::answer::three(at)));
        let excesses = Excess::gathered(found.map(|(_, run)| &run.excesses), "run");
        let excesses = excesses.iter().map(|one| format!("{at}{one}"));
        let cautions = Implausible::lines(doubts).into_iter().chain(excesses).collect();
        Self { cautions, ..self }
    }
}
