//! The clock of the exact method: it is set back as the run goes on, so that it tells instants as well at the end as at the start.
//!
//! A clock that runs on from t = 0 tells at 20 s instants 4e-15 s apart. That is 1e-13 of a displacement at every event, and decides
//! who hits first where floors are caught between two neighbours.

use crate::Recorder;
use crate::exact::Run;
use crate::model::sampling::Sampling;

/// A clock that shows 0 at an instant after the start.
///
/// What is ahead is known as a time on it, and set back with it, without rounding; what has passed as a [`Past`].
#[derive(Debug, Clone, Copy)]
pub(super) struct LocalClock {
    /// The instant at which it shows 0 \[s\], a whole number of units.
    zero: f64,
    /// Its unit is a power of two: what the clock is set back by has no rounding, however often.
    sampling: Sampling,
}

/// An instant that a clock has told.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Past {
    /// Where that clock showed 0 \[s\].
    zero: f64,
    /// What it showed \[s\].
    time: f64,
}

impl Past {
    /// Time since an earlier instant \[s\].
    pub(super) fn since(self, earlier: Self) -> f64 {
        (self.time - earlier.time) + (self.zero - earlier.zero)
    }

    /// Time since the start of the run, as recorders tell it \[s\].
    pub(super) fn absolute(self) -> f64 {
        self.zero + self.time
    }

    /// The same as a sum that is not rounded.
    pub(super) fn instant(self) -> [f64; 2] {
        [self.zero, self.time]
    }

    /// What its clock showed \[s\].
    pub(super) fn time(self) -> f64 {
        self.time
    }
}

impl LocalClock {
    /// Of a run whose samples arrive so.
    pub(super) fn new(sampling: Sampling) -> Self {
        Self { zero: 0.0, sampling }
    }

    /// The instant at which it shows 0 \[s\].
    pub(super) fn zero(&self) -> f64 {
        self.zero
    }

    /// An instant that it shows.
    pub(super) fn past(&self, time: f64) -> Past {
        let zero = self.zero;
        Past { zero, time }
    }

    /// What it would have shown at an instant that another one told \[s\].
    pub(super) fn shown(&self, past: Past) -> f64 {
        past.since(self.past(0.0))
    }

    /// Time since the start of the run, as recorders and errors tell it \[s\].
    pub(super) fn absolute(&self, time: f64) -> f64 {
        self.past(time).absolute()
    }
}

impl<R: Recorder> Run<'_, R> {
    /// Sets the clock back to less than a unit, and all instants ahead; returns by how much \[s\].
    ///
    /// It depends on the instant alone: what a body does has the same bits whatever others do.
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
