//! The clock of the exact method. It is set back as the run goes on, so that its resolution is the same at the end as at the start.
//!
//! A clock that runs from t = 0 resolves 4e-15 s at 20 s. This is 1e-13 of a displacement at every event, and can decide which neighbour a
//! floor between two of them hits first.

use crate::Recorder;
use crate::exact::ExactRun;
use crate::model::sampling::Sampling;

/// A clock that shows 0 at some instant after the start.
///
/// Future instants are times on this clock, set back with it without rounding. Past instants are [`Past`] values.
#[derive(Debug, Clone, Copy)]
pub(super) struct LocalClock {
    /// The instant at which the clock shows 0 \[s\], a whole number of units.
    zero: f64,
    /// The unit of the clock is a power of two: setting the clock back never rounds.
    sampling: Sampling,
}

/// An instant on a clock that may have been set back since.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Past {
    /// The instant at which the clock showed 0 \[s\].
    zero: f64,
    /// The time that the clock showed \[s\].
    time: f64,
}

impl Past {
    /// Time since an earlier instant \[s\].
    pub(super) fn since(self, earlier: Self) -> f64 {
        (self.time - earlier.time) + (self.zero - earlier.zero)
    }

    /// Time since the start of the run, as recorders see it \[s\].
    pub(super) fn absolute(self) -> f64 {
        self.zero + self.time
    }

    /// Time since the start of the run as an unrounded sum \[s\].
    pub(super) fn instant(self) -> [f64; 2] {
        [self.zero, self.time]
    }

    /// The time that the clock showed \[s\].
    pub(super) fn time(self) -> f64 {
        self.time
    }
}

impl LocalClock {
    /// A clock for samples with these arrival times.
    pub(super) fn new(sampling: Sampling) -> Self {
        Self { zero: 0.0, sampling }
    }

    /// The instant at which the clock shows 0 \[s\].
    pub(super) fn zero(&self) -> f64 {
        self.zero
    }

    /// The instant at which this clock shows `time`.
    pub(super) fn past(&self, time: f64) -> Past {
        let zero = self.zero;
        Past { zero, time }
    }

    /// Time on this clock of an instant from another clock \[s\].
    pub(super) fn shown(&self, past: Past) -> f64 {
        past.since(self.past(0.0))
    }

    /// Time since the start of the run, as recorders and errors see it \[s\].
    pub(super) fn absolute(&self, time: f64) -> f64 {
        self.past(time).absolute()
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Sets the clock, and all future instants, back to less than a unit; returns the difference \[s\].
    ///
    /// The result depends only on the instant: a body keeps the same bits whatever the others do.
    pub(super) fn set_clock(&mut self, now: f64) -> f64 {
        let [by, _] = self.agenda.clock.sampling.split(now);
        if by == 0.0 {
            return by;
        }
        self.agenda.clock.zero += by;
        self.agenda.end -= by;
        for body in &mut self.moving.bodies {
            body.end -= by;
        }
        for contact in &mut self.touching.contacts {
            contact.set_back(by);
        }
        for member in &mut self.moving.members {
            if let Some(ahead) = &mut member.ahead {
                ahead.set_back(by);
            }
        }
        by
    }
}
