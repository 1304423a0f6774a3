//! A scene under every record of a folder, until Ctrl-C.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use pounding::assess::{MotionLines, Suite, SuiteMotion, Watched};
use pounding::scene::{Error, Excess, Implausible, Scene, Simulation};
use pounding::text::{Answer, Cell, RefusalKind, Refused, Table, Where};
use serde_json::{Value, json};

pub(super) use pounding::assess::{MotionLine, nothing_found};

use super::declared::Declared;
use crate::progress::Progress;

/// Reads the records of a folder that are to shake a scene.
///
/// # Errors
/// Says that the folder cannot be read, or why nothing in it shakes a row.
pub(super) fn read(folder: &Path, declared: &Declared, scene: &Scene) -> Result<Suite, Refused> {
    Ok(Suite::in_folder(folder, &declared.of_files(scene))?)
}

/// Sentences about the records of a folder, with `hint` behind them if they leave names out.
pub(super) fn said_briefly(suite: &Suite, hint: &str) -> Vec<String> {
    let (mut said, all) = (suite.said(false), suite.said(true));
    if said != all {
        said.push(hint.into());
    }
    said
}

/// The findings of a command under one motion.
pub(super) trait UnderMotion {
    /// Unusual values in the scene or in the record.
    fn doubts(&self) -> &[Implausible];

    /// Responses beyond the model or codes.
    fn excesses(&self) -> &[Excess];

    /// The facts of this motion for programs, as an object.
    fn facts(&self, scene: &Scene) -> Value;
}

/// The answer of a command about a folder of records.
pub(super) struct OfFolder<'a, T> {
    pub(super) scene: &'a Scene,
    pub(super) suite: &'a Suite,
    pub(super) lines: &'a [MotionLine<T>],
    /// Warnings of the command besides those of motions.
    pub(super) warnings: Vec<String>,
}

/// A line of a CSV about a folder: a motion, and a number under it, or why there is none.
pub(super) struct MotionRow<N> {
    motion: String,
    /// Number of its event, from 1; `None` for a record that is left out.
    event: Option<usize>,
    reversed: Option<bool>,
    pub(super) found: N,
    refused: Option<String>,
}

impl<N> MotionRow<N> {
    /// A row for a number under a motion.
    pub(super) fn of<T>(line: &MotionLine<T>, found: N) -> Self {
        Self {
            motion: line.motion.clone(),
            event: Some(line.event + 1),
            reversed: Some(line.reversed),
            found,
            refused: None,
        }
    }

    /// Returns the row as one of shaking in this direction, whatever that of its line.
    #[must_use]
    pub(super) fn shaken(self, reversed: bool) -> Self {
        Self {
            reversed: Some(reversed),
            ..self
        }
    }
}

impl<'a, T: UnderMotion> OfFolder<'a, T> {
    /// The lines that were not refused, with their findings.
    pub(super) fn found(&self) -> impl Iterator<Item = (&'a MotionLine<T>, &'a T)> + use<'a, T> {
        self.lines.iter().filter_map(|line| Some((line, line.found.as_ref().ok()?)))
    }

    /// The parts that every answer about a folder begins with, and its facts for programs.
    pub(super) fn answer(&self) -> Answer<'a> {
        let unusual = Implausible::gathered(self.found().flat_map(|(line, found)| {
            let doubts = found.doubts().iter();
            doubts.map(|doubt| (line.motion.as_str(), doubt))
        }));
        let excesses = Excess::gathered(self.found().map(|(_, found)| found.excesses()));
        let missing = self.suite.says_missing(MotionLine::failed(self.lines).len()).into_iter();
        let warnings = missing
            .chain(excesses.iter().map(ToString::to_string))
            .chain(self.warnings.iter().cloned());
        let warnings: Vec<String> = warnings.collect();
        let motions: Vec<Value> = self.lines.iter().map(|line| self.motion(line)).collect();
        Answer::new()
            .say(Where::Terminal, "Unusual", unusual.iter().map(ToString::to_string).collect())
            .say(Where::Terminal, "Warnings", warnings.clone())
            .say(Where::Terminal, "Scene", vec![self.scene.name.clone()])
            .fact("scene", json!(self.scene))
            .fact("unusual", json!(unusual))
            .fact("records", self.suite.json())
            .fact("warnings", warnings)
            .fact("motions", motions)
            .fact("left_out", self.suite.left_out_json())
    }

    fn motion(&self, line: &MotionLine<T>) -> Value {
        let mut motion = match &line.found {
            Ok(found) => found.facts(self.scene),
            Err(reason) => json!({"refused": reason}),
        };
        motion["record"] = json!(line.motion);
        motion["event"] = json!(line.event + 1);
        motion["reversed"] = json!(line.reversed);
        motion
    }

    /// How many files became how many events, and which failed or are left out; with `details` every name.
    pub(super) fn records(&self, details: bool) -> Vec<String> {
        let said = if details {
            self.suite.said(true)
        } else {
            said_briefly(self.suite, "--details names every one")
        };
        let (counts, remarks) = said.split_at(1);
        [counts, &MotionLine::failed(self.lines), remarks].concat()
    }

    /// The table for programs. `rows` makes the rows of a motion, and `columns` adds their columns. Motions that are refused and records that
    /// are left out have a row with the reason.
    pub(super) fn table<N: Default + 'a>(
        &self,
        rows: impl Fn(&'a MotionLine<T>, &'a T) -> Vec<MotionRow<N>>,
        columns: impl FnOnce(Table<'a, MotionRow<N>>) -> Table<'a, MotionRow<N>>,
    ) -> Table<'a, MotionRow<N>> {
        let of_lines = self.lines.iter().flat_map(|line| match &line.found {
            Ok(found) => rows(line, found),
            Err(reason) => vec![MotionRow {
                refused: Some(reason.clone()),
                ..MotionRow::of(line, N::default())
            }],
        });
        let left_out = self.suite.left_out.iter().map(|one| MotionRow {
            motion: one.name.clone(),
            event: None,
            reversed: None,
            found: N::default(),
            refused: Some(one.reason.sentence()),
        });
        let table = Table::of(of_lines.chain(left_out))
            .column("record", |row| Cell::from(row.motion.as_str()))
            .column("event", |row| row.event)
            .column("reversed", |row| row.reversed);
        columns(table).column("refused", |row| Cell::from(row.refused.as_deref()))
    }
}

/// The lines of a folder that are finished, and how many there are to be.
pub(super) struct Ran<T> {
    pub(super) lines: Vec<MotionLine<T>>,
    n_cases: usize,
}

impl<T> Ran<T> {
    /// Returns the text of the lines. If somebody said stop before all were finished, it is printed here.
    ///
    /// # Errors
    /// Says that it was stopped.
    pub(super) fn answer(&self, text: String) -> Result<String, Refused> {
        let finished = self.lines.len();
        if finished == self.n_cases {
            return Ok(text);
        }
        crate::print(&text)?;
        let of = self.n_cases;
        let said = format!("stopped: of {of} runs the {finished} are printed that were finished");
        Err(Refused::that(said).kind(RefusalKind::Stopped))
    }
}

/// Whether Ctrl-C was pressed, or the system asked the program to end (SIGTERM, SIGHUP).
pub(super) static STOPPED: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C, SIGTERM and SIGHUP end the runs that have begun, and begin no other; a second one ends the program.
pub(super) fn stop_when_asked() {
    let asked = ctrlc::set_handler(|| {
        if STOPPED.swap(true, Ordering::Relaxed) {
            #[expect(clippy::exit, reason = "asked for twice")]
            std::process::exit(130);
        }
    });
    // Without a handler Ctrl-C ends the program at once, as it does elsewhere.
    let _ = asked;
}

/// Runs a scene under every motion of a suite, in these directions (whether reversed); a line each, in order.
///
/// # Errors
/// Gives the first reason if every run fails.
pub(super) fn lines<T: Send>(
    scene: &Scene,
    suite: &Suite,
    directions: &[bool],
    run: impl Fn(&Simulation) -> Result<T, Error> + Sync,
) -> Result<Ran<T>, Refused> {
    let scene = |_: &SuiteMotion| Ok((scene.clone(), ()));
    lines_of(suite, directions, scene, |prepared, ()| run(prepared))
}

/// Runs a scene for each motion as [`lines`] does, with data that the runs of a motion share.
///
/// # Errors
/// Those of [`lines`].
pub(super) fn lines_of<T: Send, K: Send + Sync>(
    suite: &Suite,
    directions: &[bool],
    scene: impl Fn(&SuiteMotion) -> Result<(Scene, K), Error> + Sync,
    run: impl Fn(&Simulation, &K) -> Result<T, Error> + Sync,
) -> Result<Ran<T>, Refused> {
    stop_when_asked();
    let progress = Progress::new();
    let step = |of| progress.step(of);
    let watched = Watched {
        stop: &STOPPED,
        step: &step,
    };
    let ran = MotionLines::of(suite, directions, watched, scene, run)?;
    Ok(Ran {
        lines: ran.lines,
        n_cases: ran.n_cases,
    })
}
