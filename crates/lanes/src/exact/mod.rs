//! The exact method of many scenes at once: free flight and compliant contact in lanes, other events scene by scene.
//!
//! A lane flies from sample to sample of the record with the weights of the exact solution for a load that is linear between
//! samples. Bounds say where a gap may close, or a displacement may turn beyond what was reached; a scene goes through
//! such an interval alone ([`scene`]), by power series to its turns, touches and impacts. Scenes in compliant contact fill lanes
//! again, whichever they are ([`press`]), and go by an error-controlled Runge–Kutta method. Sources: N. C. Nigam and
//! P. C. Jennings, *Bull. Seismol. Soc. Am.* 59 (1969) 909; J. R. Dormand and P. J. Prince, *J. Comput. Appl. Math.* 6 (1980) 19.
//!
//! Series, as the exact method has them alone, take ten times as long here at a tolerance of 1e-6.

mod contact;
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

/// Smallest tolerance that compliant contact can be followed to; who asks for less wants the bits of a run alone.
const FINEST: f64 = 1e-12;
/// Largest tolerance that it is followed to: with 1e-3 a contact by a Kelvin–Voigt element can end 12 % off.
const COARSEST: f64 = 1e-4;

/// Ground motions, with samples at the same instants, under which many rows of two elastic structures run by the exact method.
///
/// Impacts and free flight are carried to rounding, as [`Exact`] alone does, but not in the same bits; compliant contact to errors
/// of about the tolerance. Who wants histories, or a ledger, runs a scene alone.
#[derive(Debug, Clone)]
pub struct ExactSideBySide<'a> {
    tolerance: f64,
    excitations: Excitations<'a>,
    /// Between two samples of the records \[s\], and how many such intervals are before the end.
    step: f64,
    n_whole: usize,
    /// From the last sample before the end to the end \[s\]; nothing where a sample is there.
    rest: Option<f64>,
    pub(super) level: Level,
    budget: Budget,
    /// Whether neighbours are followed where they come close.
    closings: bool,
}

/// The ground between two samples of the record.
#[derive(Debug, Clone, Copy)]
struct Interval {
    /// Its duration \[s\].
    length: f64,
    /// Acceleration at the start \[m/s²\] and its slope \[m/s³\].
    value: f64,
    slope: f64,
    /// Whether the acceleration jumps where the interval begins, behind a record that does not end with zero.
    jumps: bool,
}

impl<'a> ExactSideBySide<'a> {
    /// Takes the ground motions for a clock, of which only the end counts.
    ///
    /// # Errors
    /// [`RunError::Setting`] for a tolerance out of range, and for records whose samples are not equally far apart.
    pub fn new(settings: Exact, excitations: impl Into<Excitations<'a>>, clock: Clock) -> Result<Self, RunError> {
        settings.check()?;
        let (excitations, end) = (excitations.into(), clock.time(clock.n_steps));
        let step = excitations.time_step()?;
        let part = end / step;
        // An end that rounding puts beside a sample is at that sample.
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

    /// The same, but runs end when somebody sets the budget's `stop`: then scenes are not told. Nothing else of it counts here.
    #[must_use]
    pub fn within(self, budget: Budget) -> Self {
        Self { budget, ..self }
    }

    /// The same, and tells how far neighbours come towards each other ([`PairSums::closing`](super::PairSums::closing)).
    #[must_use]
    pub fn with_closings(self, closings: bool) -> Self {
        Self { closings, ..self }
    }

    /// Whether a row can run side by side with others: two structures of one storey, or one and a wall, whose floors can touch; the ground
    /// motion arrives at both at once; and a tolerance of 1e-12 or more, or an impulsive contact, which has none.
    pub fn takes(row: &Row<Elastic>, settings: Exact) -> bool {
        let on_ground = |node: usize| row.nodes()[node].support == Support::Ground && row.arrival(node) == 0.0;
        let two = row.nodes().len() == 2 && row.pairs().len() == 1 && row.is_chain();
        let is_flown = |pair: &Pair| settings.tolerance >= FINEST || !pair.law.is_compliant();
        two && (0..2).all(on_ground) && row.pairs().iter().all(is_flown)
    }

    /// Runs rows that it [takes](Self::takes) to the end of the clock, and tells what happened in each at its place among the
    /// scenes of `tallies` ([`SceneSums::begin`]).
    ///
    /// A run of it alone says what happens in a scene that is not told:
    ///
    /// - bounces do not end, or neighbours press from the start;
    /// - only rounding decides whether neighbours at rest part;
    /// - a period is shorter than some six samples;
    /// - a structure goes further than 1 km.
    ///
    /// What is told of a scene does not depend on the others. Where each has a ground motion of its own, there are as many of them as
    /// rows, in their order; otherwise nothing is told.
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

    /// An interval of this length \[s\] of the motion of a scene.
    fn interval(&self, (index, length): (usize, f64), scene: usize) -> Interval {
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
