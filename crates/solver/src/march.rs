//! The loop of every stepping method.

use crate::impact::impacts::Impacts;
use crate::model::ground::{Ground, Now, Shaking};
use crate::{Clock, Course, Excitation, Recorder, RestoringForce, Row, RunError, State, Work};

/// A stepping method with all its memory, allocated once.
pub(crate) trait Stepping<Column: RestoringForce> {
    /// First step: 0 for a method that finds the velocity at a node in the step after it.
    const FIRST: usize = 1;
    /// Parts of a step at whose ends the method needs the ground.
    const PARTS: usize = 1;

    /// Tangent stiffness of the columns below a node after the last step \[N/m\], for damping that follows it. Infinite for methods that refuse
    /// such damping.
    fn tangent(&self, _node: usize) -> f64 {
        f64::INFINITY
    }

    /// Takes a step and reports it.
    fn step<R: Recorder>(&mut self, row: &Row<Column>, step: ClockStep<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError>;
}

/// A step of the clock.
#[derive(Clone, Copy)]
pub(crate) struct ClockStep<'a> {
    shaking: &'a Shaking<'a>,
    /// Number of the step; step 1 begins at t = 0.
    pub(crate) number: usize,
    pub(crate) clock: Clock,
    /// Parts at whose ends the ground is known.
    parts: usize,
}

/// Integrates a row by a method that begins with the ground at t = 0. `substeps` is the largest number of substeps of a step.
pub(crate) fn march<Column, Method, R>(
    row: &Row<Column>,
    excitation: Excitation<'_>,
    Course { clock, budget }: Course,
    substeps: usize,
    begin: impl FnOnce(Ground<'_>) -> Method,
    recorder: &mut R,
) -> Result<Work, RunError>
where
    Column: RestoringForce,
    Method: Stepping<Column>,
    R: Recorder,
{
    let parts = Clock {
        time_step: clock.time_step / Method::PARTS as f64,
        n_steps: clock.n_steps * Method::PARTS,
    };
    let guard = clock.within(budget).begin(row.nodes().len() * substeps);
    let shaking = row.shaken(excitation, parts);
    let mut method = begin(shaking.at(0));
    let mut work = Work::default();
    // The row with the damping of the last known tangent.
    let mut present = row.has_tangent_damping().then(|| row.clone());
    for number in Method::FIRST..=clock.n_steps {
        guard.step(number, clock)?;
        let step = ClockStep {
            shaking: &shaking,
            number,
            clock,
            parts: Method::PARTS,
        };
        method.step(present.as_ref().unwrap_or(row), step, &mut work, recorder)?;
        if let Some(present) = &mut present {
            present.take_damping(row, |node| method.tangent(node));
        }
        work.steps += 1;
        if recorder.fallen().is_some() {
            break;
        }
    }
    Ok(work)
}

impl<'a> ClockStep<'a> {
    /// The ground at a node of the clock, or of its parts.
    #[inline]
    pub(crate) fn ground(&self, node: usize) -> Ground<'a> {
        self.shaking.at(node)
    }

    /// The ground at both ends and in the middle, for a method whose steps have two parts.
    #[inline]
    pub(crate) fn parts(&self) -> [Ground<'a>; 3] {
        [2, 1, 0].map(|before| self.ground(2 * self.number - before))
    }

    /// The ground at both ends, for a method whose steps have one part.
    #[inline]
    pub(crate) fn ends(&self) -> [Ground<'a>; 2] {
        [self.number - 1, self.number].map(|node| self.ground(node))
    }

    /// Times of both ends \[s\].
    #[inline]
    pub(crate) fn times(&self) -> [f64; 2] {
        [self.number - 1, self.number].map(|node| self.clock.time(node))
    }

    /// The ground at a part of the step after a node.
    pub(crate) fn within(&self, node: usize, part: f64) -> Ground<'a> {
        self.shaking.within(node, part)
    }

    /// An instant counted from the start of the step \[s\].
    #[inline]
    pub(crate) fn at(&self, instant: f64) -> Now<'a> {
        let [start, end] = self.times();
        if instant < self.clock.time_step {
            let part = instant / self.clock.time_step;
            Now {
                ground: self.within(self.number - 1, part),
                time: start + instant,
            }
        } else {
            Now {
                ground: self.ground(self.number),
                time: end,
            }
        }
    }

    /// Whether all grounds move alike.
    pub(crate) fn is_common(&self) -> bool {
        matches!(self.shaking, Shaking::Common(_))
    }

    /// Error of a run in which the displacement of a structure is no longer finite.
    pub(crate) fn diverged(&self, structure: usize) -> RunError {
        RunError::Diverged {
            structure,
            time: self.clock.time(self.number),
            time_step: self.clock.time_step,
        }
    }

    /// End of the step.
    #[inline]
    pub(crate) fn end(&self) -> Now<'a> {
        Now {
            ground: self.ground(self.parts * self.number),
            time: self.clock.time(self.number),
        }
    }

    /// Counts the pairs that overlap after the step and applies the jumps of impulsive pairs; true if any jumped.
    pub(crate) fn collide<Column: RestoringForce, R: Recorder>(
        &self,
        row: &Row<Column>,
        states: &mut [State],
        impacts: &mut Impacts,
        work: &mut Work,
        recorder: &mut R,
    ) -> Result<bool, RunError> {
        let end = self.end();
        work.touching_steps += row.n_overlaps(states, end.ground);
        impacts.after_step(row, states, end, recorder)
    }
}
