//! Of the runs of one window, and of its reports, the latest wins: it stops the others.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::server::CONNECTIONS;

/// A flag for each run that a connection may have; a solver takes flags that live as long as the process.
static STOPS: [AtomicBool; CONNECTIONS] = [const { AtomicBool::new(false) }; CONNECTIONS];

/// A window, and its kind of work: a report and a run do not stop each other.
type Owner = (u64, Work);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Work {
    Run,
    Report,
}

/// The owners of the flags.
static OWNERS: Mutex<[Option<Owner>; CONNECTIONS]> = Mutex::new([None; CONNECTIONS]);

/// A run that a later one of its window stops.
#[derive(Debug)]
pub(super) struct Latest(usize);

impl Latest {
    /// Begins a run of an owner and stops its others; `None` if there are as many runs as connections.
    pub(super) fn begin(owner: Owner) -> Option<Self> {
        let mut owners = owners();
        for (known, stop) in owners.iter().zip(&STOPS) {
            if *known == Some(owner) {
                stop.store(true, Ordering::Relaxed);
            }
        }
        let free = owners.iter().position(Option::is_none)?;
        owners[free] = Some(owner);
        STOPS[free].store(false, Ordering::Relaxed);
        Some(Self(free))
    }

    /// Whether a later run of its window has begun.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop().load(Ordering::Relaxed)
    }

    /// The flag for its runs.
    pub(super) fn stop(&self) -> &'static AtomicBool {
        &STOPS[self.0]
    }
}

impl Drop for Latest {
    fn drop(&mut self) {
        owners()[self.0] = None;
    }
}

fn owners() -> MutexGuard<'static, [Option<Owner>; CONNECTIONS]> {
    OWNERS.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::{Latest, Work};

    #[test]
    fn limit_the_latest_run_of_a_window_stops_its_others_alone() {
        let begin = |window, work| Latest::begin((window, work)).unwrap();
        let (first, of_other, report) = (begin(1, Work::Run), begin(2, Work::Run), begin(1, Work::Report));
        let second = begin(1, Work::Run);
        let stopped = [&first, &of_other, &report, &second].map(Latest::is_stopped);
        assert_eq!(stopped, [true, false, false, false]);
    }
}
