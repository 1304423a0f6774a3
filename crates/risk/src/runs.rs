//! The runs of a row under motions of several intensities, in numbers.

use std::collections::BTreeMap;

use crate::state::{RunNumbers, State};
use crate::stripe::{EventShare, Stripe, Stripes};

/// A motion in one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct StripeMotion {
    /// Name of the motion.
    pub name: String,
    /// Whether it is reversed.
    pub reversed: bool,
    /// Number of its event, from 0.
    pub event: usize,
    /// Its intensity as recorded \[g\]; `None` if it was not needed.
    pub own_intensity: Option<f64>,
}

impl StripeMotion {
    /// Name for tables.
    pub fn name(&self) -> String {
        let reversed = if self.reversed { ", reversed" } else { "" };
        format!("{}{reversed}", self.name)
    }
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct StripeRun {
    /// Index of its motion.
    pub motion: usize,
    /// Index of its intensity.
    pub stripe: usize,
    /// Its numbers, or why there are none.
    pub found: Result<RunNumbers, String>,
}

/// A row under motions of several intensities.
#[derive(Debug, Clone, PartialEq)]
pub struct StripeRuns {
    /// Gaps of the row \[m\], from the left.
    pub gaps: Vec<f64>,
    /// Intensities \[g\], rising.
    pub intensities: Vec<f64>,
    /// The motions.
    pub motions: Vec<StripeMotion>,
    /// Motion after motion, and of each the intensities in rising order.
    pub runs: Vec<StripeRun>,
    /// Whether all motions stand at all intensities.
    pub same_events: bool,
}

/// The intensities at which a motion reaches a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reached {
    /// Least of them \[g\].
    pub first: f64,
    /// Whether it leaves the state again at a higher one.
    pub returns: bool,
}

impl StripeRuns {
    /// Counts the events that reach a state at each intensity. All runs of an event are one sample, which counts with their share; a run that
    /// failed counts nowhere.
    pub fn stripes(&self, is_reached: impl Fn(&RunNumbers) -> Option<bool>) -> Stripes {
        let mut counts: Vec<BTreeMap<usize, [f64; 2]>> = vec![BTreeMap::new(); self.intensities.len()];
        for run in &self.runs {
            if let Some(reached) = run.found.as_ref().ok().and_then(&is_reached) {
                let event = self.motions[run.motion].event;
                let [n, exceeding] = counts[run.stripe].entry(event).or_default();
                *n += 1.0;
                *exceeding += f64::from(u8::from(reached));
            }
        }
        let stripe = |(intensity, events): (&f64, &BTreeMap<usize, [f64; 2]>)| Stripe {
            intensity: *intensity,
            events: events
                .iter()
                .map(|(event, [n, exceeding])| EventShare {
                    event: *event,
                    share: exceeding / n,
                })
                .collect(),
        };
        Stripes {
            all: self.intensities.iter().zip(&counts).map(stripe).collect(),
            same_events: self.same_events,
        }
    }

    /// Counts the events that reach a state of the row.
    pub fn stripes_of(&self, state: State) -> Stripes {
        self.stripes(|numbers| state.is_reached(numbers, &self.gaps))
    }

    /// Counts the events that touch if every gap has this width \[m\].
    pub fn stripes_with_gaps(&self, gap: f64) -> Stripes {
        self.stripes(|numbers| Some(numbers.collapsed || numbers.required.iter().any(|required| *required > gap)))
    }

    /// For every motion, the intensities at which it reaches a state; `None` if it reaches it at none.
    pub fn reached(&self, state: State) -> Vec<Option<Reached>> {
        let mut all: Vec<Option<Reached>> = vec![None; self.motions.len()];
        for run in &self.runs {
            let reached = run.found.as_ref().ok().and_then(|numbers| state.is_reached(numbers, &self.gaps));
            match (&mut all[run.motion], reached) {
                (place @ None, Some(true)) => {
                    *place = Some(Reached {
                        first: self.intensities[run.stripe],
                        returns: false,
                    });
                }
                (Some(known), Some(false)) => known.returns = true,
                _ => (),
            }
        }
        all
    }

    /// The runs that failed, as motion, intensity \[g\] and reason.
    pub fn failed(&self) -> impl Iterator<Item = (&StripeMotion, f64, &str)> {
        self.runs.iter().filter_map(|run| {
            let reason = run.found.as_ref().err()?;
            Some((&self.motions[run.motion], self.intensities[run.stripe], reason.as_str()))
        })
    }

    /// Number of runs in which a storey collapses.
    pub fn n_collapsed(&self) -> usize {
        let collapsed = |run: &&StripeRun| run.found.as_ref().is_ok_and(|numbers| numbers.collapsed);
        self.runs.iter().filter(collapsed).count()
    }
}
