//! Progress of work that takes longer than a second, on standard error: a bar on a terminal, and for many runs a line now and then in the
//! log of a job.

use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{FormattedDuration, HumanCount, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

/// How long work may take before its progress is shown.
const PATIENCE: Duration = Duration::from_secs(1);
/// How often the bar moves, so that long work does not look dead.
const TICK: Duration = Duration::from_millis(200);
/// How long a log waits for its first line, and for each of the others.
const FIRST_LINE: Duration = Duration::from_secs(10);
const LINES: Duration = Duration::from_secs(60);

/// Message of runs.
const RUNNING: &str = "running";

/// Style for one run, and for runs whose number is not known yet.
const CLOCK: &str = "{spinner} {msg}, {elapsed}";
/// Style for a known number of runs.
const BAR: &str = "{bar:40} {pos}/{len} runs, {elapsed}, about {eta} left";
/// Style while a method is chosen.
const CHOOSING_BAR: &str = "{bar:30} choosing a method: {pos} of about {len} sampled runs, {elapsed}, about {eta} left";
/// Style for many runs, with the time that is left.
const LONG_BAR: &str = "{bar:30} {human_pos}/{human_len} runs, {rate}, {elapsed}, {eta} left";

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).expect("the template is well formed")
}

/// Progress that appears after a second and disappears when it is dropped.
#[derive(Debug)]
struct Shown {
    bar: ProgressBar,
    /// Dropped when the work is over.
    working: Option<Sender<()>>,
    clock: Option<JoinHandle<()>>,
}

impl Shown {
    fn new(words: &'static str, log: Log) -> Self {
        let hidden = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let bar = hidden.with_style(style(CLOCK)).with_message(words);
        let (working, over) = channel();
        let shown = bar.clone();
        let clock = thread::spawn(move || {
            // No message is ever sent: the end of the work ends the waiting.
            let goes_on = |wait| over.recv_timeout(wait) == Err(RecvTimeoutError::Timeout);
            if std::io::stderr().is_terminal() {
                if goes_on(PATIENCE) {
                    shown.set_draw_target(ProgressDrawTarget::stderr());
                    shown.enable_steady_tick(TICK);
                }
            } else if log == Log::Lines {
                let mut wait = FIRST_LINE;
                while goes_on(wait) {
                    line(&shown);
                    wait = LINES;
                }
            }
        });
        Self {
            bar,
            working: Some(working),
            clock: Some(clock),
        }
    }
}

/// Lines in a log, if standard error is no terminal.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Log {
    Nothing,
    Lines,
}

/// The progress as a line.
fn line(bar: &ProgressBar) {
    let passed = FormattedDuration(bar.elapsed());
    let Some(of) = bar.length() else {
        crate::say(&format!("{}, {passed}", bar.message()));
        return;
    };
    let [done, of] = [bar.position(), of].map(HumanCount);
    let what = match bar.message() {
        message if message == RUNNING => String::new(),
        message => format!("{message}: "),
    };
    // The time that is left is not known before some runs are done.
    let left = match bar.eta() {
        Duration::ZERO => String::new(),
        left => format!(", {} left", FormattedDuration(left)),
    };
    crate::say(&format!("{what}{done} of {of} runs, {passed}{left}"));
}

impl Drop for Shown {
    fn drop(&mut self) {
        drop(self.working.take());
        if let Some(clock) = self.clock.take() {
            // A clock that failed is no reason for a run to fail.
            let _ = clock.join();
        }
        self.bar.finish_and_clear();
    }
}

/// A bar of runs.
#[derive(Debug)]
pub(crate) struct Progress(Shown);

impl Progress {
    pub(crate) fn new() -> Self {
        Self(Shown::new(RUNNING, Log::Nothing))
    }

    /// A bar of so many runs, before the first is done.
    pub(crate) fn of(runs: usize) -> Self {
        let progress = Self::new();
        progress.0.bar.set_style(style(BAR));
        progress.0.bar.set_length(runs as u64);
        progress
    }

    /// Counts one run as done; `of` is the number of all.
    pub(crate) fn step(&self, of: usize) {
        let bar = &self.0.bar;
        if bar.length() != Some(of as u64) {
            bar.set_style(style(BAR));
            bar.set_length(of as u64);
        }
        bar.inc(1);
    }
}

/// A bar of many runs; some may have been done before.
#[derive(Debug)]
pub(crate) struct Counter(Shown);

impl Counter {
    /// A bar that begins at `done` runs.
    pub(crate) fn new(done: u64, of: u64) -> Self {
        let shown = Shown::new(RUNNING, Log::Lines);
        let rate = |state: &ProgressState, to: &mut dyn std::fmt::Write| {
            // A line that cannot be written is lost.
            let _ = write!(to, "{:.0} a second", state.per_sec());
        };
        let style = style(LONG_BAR).with_key("rate", rate);
        shown.bar.set_style(style);
        shown.bar.set_length(of);
        // The rate counts only the runs of this process.
        shown.bar.set_position(done);
        shown.bar.reset_eta();
        Self(shown)
    }

    /// Counts more runs as done.
    pub(crate) fn add(&self, runs: u64) {
        self.0.bar.inc(runs);
    }
}

/// A clock while a sweep is read, and a bar of sampled runs while its method is chosen.
#[derive(Debug)]
pub(crate) struct Choosing(Shown);

impl Choosing {
    pub(crate) fn new() -> Self {
        Self(Shown::new("reading", Log::Lines))
    }

    /// Returns what shows the number of sampled runs that are done, of about so many.
    pub(crate) fn follow(&self) -> impl Fn(u64, u64) + Send + Sync + 'static {
        let bar = self.0.bar.clone();
        move |done, of| {
            if bar.length().is_none() {
                bar.set_message("choosing a method");
                bar.set_style(style(CHOOSING_BAR));
                bar.reset_eta();
            }
            bar.set_length(of);
            bar.set_position(done);
        }
    }
}

/// A clock of one run.
#[derive(Debug)]
pub(crate) struct Waiting {
    _shown: Shown,
}

impl Waiting {
    pub(crate) fn new(words: &'static str) -> Self {
        Self {
            _shown: Shown::new(words, Log::Nothing),
        }
    }
}
