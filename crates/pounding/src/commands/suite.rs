//! A scene under every record of a folder, until Ctrl-C.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use pounding::assess::{FolderUse, MotionLines, SelectionFactors, Suite, SuiteMotion, Watched};
use pounding::scene::{Error, Scene, Simulation};
use pounding::text::{RefusalKind, Refused};

pub(super) use pounding::assess::{MotionLine, nothing_found};

use super::declared::Declared;
use crate::progress::Progress;

/// Reads the records of a folder that are to shake a scene.
///
/// # Errors
/// Says that the folder cannot be read, or why nothing in it shakes a row.
pub(super) fn read(folder: &Path, declared: &Declared, scene: &Scene) -> Result<Suite, Refused> {
    Ok(Suite::in_folder(folder, declared.of_files(scene))?)
}

/// Reads the records of a folder as [`read`] does, for a command that scales each of them to an intensity.
///
/// # Errors
/// Those of [`read`], and refuses the scale factors of a selection.
pub(super) fn read_to_scale(folder: &Path, declared: &Declared, scene: &Scene) -> Result<Suite, Refused> {
    if declared.selection_factors {
        let found = Refused::at("--selection-factors").found("a factor on records that are scaled to every intensity");
        let found = found.allowed_is("--stripe in place of --records: its records are as strong as in their files");
        return Err(found.help("leave it out: it changes nothing here"));
    }
    let asked = FolderUse {
        selection_factors: SelectionFactors::WithoutEffect,
        ..declared.of_files(scene)
    };
    Ok(Suite::in_folder(folder, asked)?)
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
