//! Work on a separate thread while the caller watches for Ctrl-C and reports progress.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

/// Time between two looks for Ctrl-C.
const LOOK: Duration = Duration::from_millis(50);

/// The link between work and its waiting caller.
pub(crate) struct Watch {
    /// The flag that ends the work.
    pub(crate) stop: &'static AtomicBool,
    done: AtomicU64,
    of: AtomicU64,
}

impl Watch {
    /// Reports `more` finished items of `of`.
    pub(crate) fn step(&self, more: u64, of: u64) {
        self.of.store(of, Ordering::Relaxed);
        self.done.fetch_add(more, Ordering::Relaxed);
    }

    fn now(&self) -> (u64, u64) {
        let load = |number: &AtomicU64| number.load(Ordering::Relaxed);
        (load(&self.done), load(&self.of))
    }
}

/// Unused flags: a run needs a flag that lives as long as the process.
static FLAGS: Mutex<Vec<&'static AtomicBool>> = Mutex::new(Vec::new());

/// A flag on loan, returned when dropped.
struct Flag(&'static AtomicBool);

impl Flag {
    fn take() -> Self {
        let known = FLAGS.lock().ok().and_then(|mut flags| flags.pop());
        let flag = known.unwrap_or_else(|| Box::leak(Box::new(AtomicBool::new(false))));
        flag.store(false, Ordering::Relaxed);
        Self(flag)
    }
}

impl Drop for Flag {
    fn drop(&mut self) {
        if let Ok(mut flags) = FLAGS.lock() {
            flags.push(self.0);
        }
    }
}

/// Works without the lock of the interpreter. Calls `progress` with the number of finished items and the number of all.
///
/// # Errors
/// `KeyboardInterrupt` after Ctrl-C, or the exception of `progress`; both end the work first.
pub(crate) fn wait<T: Send>(py: Python<'_>, progress: Option<&Bound<'_, PyAny>>, work: impl FnOnce(&Watch) -> T + Send) -> PyResult<T> {
    let flag = Flag::take();
    let watch = Watch {
        stop: flag.0,
        done: AtomicU64::new(0),
        of: AtomicU64::new(0),
    };
    let over = AtomicBool::new(false);
    let caller = thread::current();
    let mut raised = None;
    let found = thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let end = End(&over, &caller);
            let found = work(&watch);
            drop(end);
            found
        });
        let mut told = (0, 0);
        while !over.load(Ordering::Acquire) {
            py.detach(|| thread::park_timeout(LOOK));
            let now = watch.now();
            let heard = py.check_signals().and_then(|()| match progress {
                Some(progress) if raised.is_none() && now != told => {
                    told = now;
                    progress.call1(now).map(drop)
                }
                Some(_) | None => Ok(()),
            });
            if let Err(error) = heard {
                watch.stop.store(true, Ordering::Relaxed);
                raised.get_or_insert(error);
            }
        }
        py.detach(|| worker.join())
    });
    match (raised, found) {
        (Some(error), _) => Err(error),
        (None, Ok(found)) => Ok(found),
        (None, Err(panic)) => std::panic::resume_unwind(panic),
    }
}

/// Tells the caller when dropped that the work is over, even after a panic.
struct End<'a>(&'a AtomicBool, &'a thread::Thread);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
        self.1.unpark();
    }
}
