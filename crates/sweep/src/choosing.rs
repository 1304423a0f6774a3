//! Progress of the choice of a method: it may take minutes, and nobody knows at its start how many runs it takes.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

/// Runs of samples that choose and measure a method: how many are done, and about how many there will be.
pub(crate) struct Choosing {
    done: AtomicU64,
    of: AtomicU64,
    told: Box<dyn Fn(u64, u64) + Send + Sync>,
}

impl fmt::Debug for Choosing {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (done, of) = (&self.done, &self.of);
        to.debug_struct("Choosing")
            .field("done", done)
            .field("of", of)
            .finish_non_exhaustive()
    }
}

impl Choosing {
    pub(crate) fn new(told: impl Fn(u64, u64) + Send + Sync + 'static) -> Self {
        Self {
            done: AtomicU64::new(0),
            of: AtomicU64::new(0),
            told: Box::new(told),
        }
    }

    /// Counts one run as done.
    pub(crate) fn step(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        (self.told)(done, self.of.load(Ordering::Relaxed).max(done));
    }

    /// Notes that about so many runs will follow those that are done.
    pub(crate) fn expect(&self, more: u64) {
        self.of.store(self.done.load(Ordering::Relaxed) + more, Ordering::Relaxed);
    }
}
