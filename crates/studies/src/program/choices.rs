//! The choices that equations (1) to (4) of the paper leave open: as its numbers show its program to make them, and as the paper describes
//! them.

use crate::listed::listed;
use pounding_motion::Record;
use pounding_solver::Clock;

listed! {
    /// A choice: its name in tables, the program's value and the described value in words.
    pub(crate) enum Choice { texts: [&'static str; 3];
        /// How the first step begins; the values are those of [`Start`].
        Start = ["start", "", "consistent"],
        /// Whether loads are rounded to five decimals of m/s².
        Loads = ["loads", "rounded", "as recorded"],
        /// When the load at the end of the record acts: only if the steps are those of the record, or always.
        LastLoad = ["last_load", "of whole steps", "used"],
        /// How long a run lasts: twice as long as the loads, until the motion has died out; or as long as the loads.
        Length = ["length", "runs on", "of loads"],
        /// Which overlaps of impulsive pairs are impacts: all, which pulls a parting pair together; or only those of approaching pairs.
        Impacts = ["impacts", "of any overlap", "on approach"],
        /// Which velocity the second pair sees if two pairs hit a structure in one step: the one after the first impact, or the one before
        /// both.
        Velocities = ["velocities", "handed on", "before both"],
        /// Which force acts if two pairs touch a structure in one step: the second one, which replaces the first; or the sum.
        Forces = ["forces", "replaced", "added"],
    }
}

listed! {
    /// How the first step begins; u₋₁ is the displacement one step before t = 0.
    pub(crate) enum Start { words: &'static str;
        /// u₋₁ = u₀ = 0.
        FirstLoadUsed = "first load used",
        /// u₀ = u₁ = 0; the first equation is that of step 1.
        FirstLoadSkipped = "first load skipped",
        /// u₀ = 0 and u₋₁ = Δt² ü₀/2, as textbooks begin.
        Consistent = "consistent",
    }
}

/// The choices of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Program {
    pub(crate) start: Start,
    /// Which of [`Choice::ALL`] are as the paper describes them. The first entry follows from `start`.
    pub(crate) described: [bool; Choice::ALL.len()],
}

impl Program {
    /// The method as the paper describes it.
    pub(crate) const DESCRIBED: Self = Self {
        start: Start::Consistent,
        described: [true; Choice::ALL.len()],
    };

    /// The choices behind the printed numbers, with a given start.
    pub(crate) const fn printed(start: Start) -> Self {
        Self {
            start,
            described: [false; Choice::ALL.len()],
        }
    }

    /// Whether a choice is as the paper describes it; not for the start.
    pub(crate) const fn is_described(self, choice: Choice) -> bool {
        self.described[choice as usize]
    }

    /// Replaces one choice by the one that the paper describes.
    pub(crate) fn with_described(mut self, choice: Choice) -> Self {
        if choice == Choice::Start {
            self.start = Self::DESCRIBED.start;
        }
        self.described[choice as usize] = true;
        self
    }

    /// The value of a choice in words.
    pub(crate) fn words(self, choice: Choice) -> &'static str {
        match choice.texts() {
            _ if choice == Choice::Start => self.start.words(),
            [_, _, described] if self.is_described(choice) => described,
            [_, printed, _] => printed,
        }
    }

    /// The accelerations of the loaded steps, from t = 0 \[m/s²\]: samples of the record, and means of them in between.
    pub(crate) fn accelerations(self, record: &Record, clock: Clock) -> Vec<f64> {
        let as_recorded = self.is_described(Choice::Loads);
        let load = |sample: &f64| if as_recorded { *sample } else { (sample * 1e5).round() / 1e5 };
        let samples: Vec<f64> = record.samples().iter().map(load).collect();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "scenes are refused whose step does not divide their record's"
        )]
        let per_sample = (record.time_step() / clock.time_step).round() as usize;
        let uses_last = per_sample == 1 || self.is_described(Choice::LastLoad);
        let n_steps = clock.n_steps + usize::from(uses_last);
        let at = |step: usize| {
            let sample = |index: usize| samples.get(index).copied().unwrap_or(0.0);
            let (index, rest) = (step / per_sample, step % per_sample);
            let part = rest as f64 / per_sample as f64;
            (1.0 - part) * sample(index) + part * sample(index + 1)
        };
        (0..n_steps).map(at).collect()
    }
}
