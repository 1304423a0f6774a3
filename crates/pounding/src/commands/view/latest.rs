//! Of the runs of one window the latest wins: it stops the others.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::server::CONNECTIONS;

/// A flag for each run that a connection may have; a solver takes flags that live as long as the process.
static STOPS: [AtomicBool; CONNECTIONS] = [const { AtomicBool::new(false) }; CONNECTIONS];

/// The windows whose runs have the flags.
static WINDOWS: Mutex<[Option<u64>; CONNECTIONS]> = Mutex::new([None; CONNECTIONS]);

/// A run that a later one of its window stops.
#[derive(Debug)]
pub(super) struct Latest(usize);

impl Latest {
    /// Begins a run of a window and stops its others; `None` if there are as many runs as connections.
    pub(super) fn begin(window: u64) -> Option<Self> {
        let mut windows = windows();
        for (known, stop) in windows.iter().zip(&STOPS) {
            if *known == Some(window) {
                stop.store(true, Ordering::Relaxed);
            }
        }
        let free = windows.iter().position(Option::is_none)?;
        windows[free] = Some(window);
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
        windows()[self.0] = None;
    }
}

fn windows() -> MutexGuard<'static, [Option<u64>; CONNECTIONS]> {
    WINDOWS.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::Latest;

    #[test]
    fn limit_the_latest_run_of_a_window_stops_its_others_alone() {
        let (first, of_other) = (Latest::begin(1).unwrap(), Latest::begin(2).unwrap());
        let second = Latest::begin(1).unwrap();
        let stopped = [&first, &of_other, &second].map(Latest::is_stopped);
        assert_eq!(stopped, [true, false, false]);
    }
}
