//! What equations (1) to (4) of the paper leave open, as its numbers show its program to have chosen, and as the paper describes it.

use crate::listed::listed;
use pounding_motion::Record;
use pounding_solver::Clock;

listed! {
    /// A choice: its name in tables; what the program does, and what the paper describes, in words.
    pub(crate) enum Choice { texts: [&'static str; 3];
        /// How the first step begins: a [`Start`].
        Start = ["start", "", "consistent"],
        /// Whether loads are rounded to five decimals of m/s².
        Loads = ["loads", "rounded", "as recorded"],
        /// Whether the load at the end of the record acts: only where steps are those of the record, or always.
        LastLoad = ["last_load", "of whole steps", "used"],
        /// How long a run lasts: the loads end, and it goes on for as long again, until the motion has died out; or as long as the loads.
        Length = ["length", "runs on", "of loads"],
        /// Which overlaps of impulsive pairs are impacts: all, so that a pair that parts is pulled together; or those of pairs that
        /// approach.
        Impacts = ["impacts", "of any overlap", "on approach"],
        /// The velocity of a structure that two pairs hit in one step, as the second pair sees it: after the impact of the first, or before
        /// both.
        Velocities = ["velocities", "handed on", "before both"],
        /// The force on a structure that two pairs touch in one step: that of the second alone, which replaces the other; or the sum.
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
    /// Which of [`Choice::ALL`] are as the paper describes them; the first is said by `start`.
    pub(crate) described: [bool; Choice::ALL.len()],
}

impl Program {
    /// The method as the paper describes it.
    pub(crate) const DESCRIBED: Self = Self {
        start: Start::Consistent,
        described: [true; Choice::ALL.len()],
    };

    /// What gives the printed numbers, with one of the two starts.
    pub(crate) const fn printed(start: Start) -> Self {
        Self {
            start,
            described: [false; Choice::ALL.len()],
        }
    }

    /// Whether a choice, except the start, is as the paper describes it.
    pub(crate) const fn is_described(self, choice: Choice) -> bool {
        self.described[choice as usize]
    }

    /// The same with a choice as the paper describes it.
    pub(crate) fn with_described(mut self, choice: Choice) -> Self {
        if choice == Choice::Start {
            self.start = Self::DESCRIBED.start;
        }
        self.described[choice as usize] = true;
        self
    }

    /// What it chooses, in words.
    pub(crate) fn words(self, choice: Choice) -> &'static str {
        match choice.texts() {
            _ if choice == Choice::Start => self.start.words(),
            [_, _, described] if self.is_described(choice) => described,
            [_, printed, _] => printed,
        }
    }

    /// The accelerations \[m/s²\] of the steps that are loaded, from t = 0 on: samples of the record, and means of them between.
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
