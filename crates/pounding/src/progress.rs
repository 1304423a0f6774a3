//! A bar for what takes longer than a second.

use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar on standard error that appears after a second, and only on a terminal.
#[derive(Debug)]
pub(crate) struct Progress {
    started: Instant,
    bar: ProgressBar,
}

impl Progress {
    pub(crate) fn new() -> Self {
        let style = ProgressStyle::with_template("{bar:40} {pos}/{len} runs, {elapsed}")
            .expect("the template is well formed");
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self {
            started: Instant::now(),
            bar: bar.with_style(style),
        }
    }

    /// One run of so many is done.
    pub(crate) fn step(&self, of: usize) {
        self.bar.set_length(of as u64);
        if self.bar.is_hidden() && self.started.elapsed() > Duration::from_secs(1) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// A clock on standard error for one run, which appears after a second, and only on a terminal.
#[derive(Debug)]
pub(crate) struct Waiting {
    /// Dropped when the run is over.
    running: Option<Sender<()>>,
    clock: Option<JoinHandle<()>>,
}

impl Waiting {
    pub(crate) fn new(words: &'static str) -> Self {
        let (running, over) = channel();
        let clock = thread::spawn(move || {
            let waited = over.recv_timeout(Duration::from_secs(1));
            if waited == Err(RecvTimeoutError::Timeout) {
                let style = ProgressStyle::with_template("{spinner} {msg}, {elapsed}")
                    .expect("the template is well formed");
                let bar = ProgressBar::new_spinner().with_style(style);
                bar.set_message(words);
                bar.enable_steady_tick(Duration::from_millis(200));
                // Nothing is ever sent: this waits for the end.
                let _ = over.recv();
                bar.finish_and_clear();
            }
        });
        Self {
            running: Some(running),
            clock: Some(clock),
        }
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        drop(self.running.take());
        if let Some(clock) = self.clock.take() {
            // A clock that failed is no reason for a run to fail.
            let _ = clock.join();
        }
    }
}
