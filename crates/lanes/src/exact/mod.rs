//! The exact method of many scenes at once: free flight and compliant contact in lanes, other events scene by scene.
//!
//! A lane flies from sample to sample of the record with the weights of the exact solution for a load that is linear between samples.
//! Bounds show where a gap may close, or a displacement may turn beyond its extremes. A scene runs through such an interval alone
//! ([`scene`]), by power series to its turns, touches and impacts. Scenes in compliant contact, in any combination, fill lanes again
//! ([`press`]) and advance by an error-controlled Runge–Kutta method. Sources: N. C. Nigam and P. C. Jennings, *Bull. Seismol. Soc. Am.* 59
//! (1969) 909; J. R. Dormand and P. J. Prince, *J. Comput. Appl. Math.* 6 (1980) 19.
//!
//! Power series in contact, as in the exact method alone, would take ten times as long here at a tolerance of 1e-6.

mod dormand_prince;
mod fly;
mod group;
mod pair;
mod press;
mod pressed;
mod pressing;
mod rest;
mod rises;
mod scene;
mod search;

use fearless_simd::{Level, dispatch};

use super::{Excitations, SceneSums};
use pounding_solver::{Budget, Clock, Elastic, Exact, Pair, Row, RunError, Support};

/// Smallest tolerance of compliant contact. For a smaller tolerance, run the scene alone.
const FINEST: f64 = 1e-12;
/// Largest tolerance of compliant contact: with 1e-3 the impulse of a Kelvin–Voigt contact can have an error of 12 %.
const COARSEST: f64 = 1e-4;

/// Ground motions, with samples at common instants, under which many rows of two elastic structures run by the exact method.
///
/// Impacts and free flight are exact to rounding, as in [`Exact`], but with other last bits. Compliant contact has errors of about the
/// tolerance. Histories and a ledger are available only in a run of a scene alone.
#[derive(Debug, Clone)]
pub struct ExactSideBySide<'a> {
    tolerance: f64,
    excitations: Excitations<'a>,
    /// Time between two samples of the records \[s\], and number of such intervals before the end.
    step: f64,
    n_whole: usize,
    /// Time from the last sample before the end to the end \[s\]; `None` if the end is at a sample.
    rest: Option<f64>,
    pub(super) level: Level,
    budget: Budget,
    /// Whether the closing of neighbours is recorded.
    closings: bool,
}

/// The ground between two samples of the record.
#[derive(Debug, Clone, Copy)]
struct Interval {
    /// Duration \[s\].
    length: f64,
    /// Acceleration at the start \[m/s²\] and its slope \[m/s³\].
    value: f64,
    slope: f64,
    /// Whether the acceleration jumps at the start of the interval, after a record that does not end with zero.
    jumps: bool,
}

impl<'a> ExactSideBySide<'a> {
    /// Takes the ground motions for a clock; only the end of the clock matters.
    ///
    /// # Errors
    /// [`RunError::Setting`] if a tolerance is out of range, or the records have different times between samples.
    pub fn new(settings: Exact, excitations: impl Into<Excitations<'a>>, clock: Clock) -> Result<Self, RunError> {
        settings.check()?;
        let (excitations, end) = (excitations.into(), clock.time(clock.n_steps));
        let step = excitations.time_step()?;
        let part = end / step;
        // An end within rounding of a sample counts as at the sample.
        let whole = if (part - part.round()).abs() < 1e-9 * part {
            part.round()
        } else {
            part.floor()
        };
        let rest = end - whole * step;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number of samples >= 0"
        )]
        let n_whole = whole as usize;
        Ok(Self {
            tolerance: settings.tolerance.min(COARSEST),
            excitations,
            step,
            n_whole,
            rest: (rest > 1e-9 * end).then_some(rest),
            level: Level::new(),
            budget: Budget::default(),
            closings: false,
        })
    }

    /// Also ends runs when the budget's `stop` is set; unfinished scenes are then not told. The rest of the budget is ignored.
    #[must_use]
    pub fn within(self, budget: Budget) -> Self {
        Self { budget, ..self }
    }

    /// Also records how far neighbours come towards each other ([`PairSums::closing`](super::PairSums::closing)).
    #[must_use]
    pub fn with_closings(self, closings: bool) -> Self {
        Self { closings, ..self }
    }

    /// Whether a row can run in lanes. It needs two structures of one storey, or a structure and a wall, whose floors can touch. The ground
    /// motion must arrive at both at once. The tolerance must be at least 1e-12, unless the contact is impulsive, which needs no tolerance.
    pub fn takes(row: &Row<Elastic>, settings: Exact) -> bool {
        let on_ground = |node: usize| row.nodes()[node].support == Support::Ground && row.arrival(node) == 0.0;
        let two = row.nodes().len() == 2 && row.pairs().len() == 1 && row.is_chain();
        let is_flown = |pair: &Pair| {
            let of_pair = pair.law.form(1.0, 1.0);
            of_pair.is_none_or(|form| form.second.is_none() && settings.tolerance >= FINEST)
        };
        two && (0..2).all(on_ground) && row.pairs().iter().all(is_flown)
    }

    /// Runs rows that [`takes`](Self::takes) accepts to the end of the clock. The results of each go to its index among the scenes of
    /// `tallies` ([`SceneSums::begin`]).
    ///
    /// A scene is not told, and needs a run alone, if
    ///
    /// - bounces do not end, or neighbours press from the start;
    /// - only rounding decides whether neighbours at rest part;
    /// - a period is shorter than about six samples;
    /// - a structure moves further than 1 km.
    ///
    /// The results of a scene do not depend on the others. If each scene has its own ground motion, the motions must be as many as the
    /// rows, in the order of the rows; otherwise nothing is told.
    pub fn run(&self, rows: &[(usize, &Row<Elastic>)], tallies: &mut SceneSums) {
        if !self.excitations.are_for(rows.len()) {
            return;
        }
        dispatch!(self.level, simd => group::run(simd, self, rows, tallies));
    }
}

impl ExactSideBySide<'_> {
    /// Number of intervals before the end.
    fn n_intervals(&self) -> usize {
        self.n_whole + usize::from(self.rest.is_some())
    }

    /// Duration of an interval \[s\].
    fn length(&self, index: usize) -> f64 {
        match self.rest {
            Some(rest) if index == self.n_whole => rest,
            _ => self.step,
        }
    }

    /// An interval of this length \[s\] in the motion of a scene.
    fn interval(&self, index: usize, length: f64, scene: usize) -> Interval {
        let samples = self.excitations.of_scene(scene).samples();
        match samples.get(index..index + 2) {
            Some(&[value, last]) => Interval {
                length,
                value,
                slope: (last - value) / self.step,
                jumps: false,
            },
            _ => Interval {
                length,
                value: 0.0,
                slope: 0.0,
                jumps: index + 1 == samples.len() && samples[index] != 0.0,
            },
        }
    }
}
