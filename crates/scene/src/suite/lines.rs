//! A scene under every motion of a folder: what became of each, and what is said of those that are left out.

use std::sync::atomic::{AtomicBool, Ordering};

use super::{Motion, Suite};
use crate::{Error, Scene, Simulation, parallel};

/// What became of a scene under one motion in one direction.
#[derive(Debug, Clone)]
pub struct Line<T> {
    /// Name of the motion.
    pub motion: String,
    /// Number of the event that the motion is of.
    pub event: usize,
    /// Whether it shakes the other way round.
    pub reversed: bool,
    /// What came of it, or why it shakes nothing.
    pub found: Result<T, String>,
}

impl<T> Line<T> {
    /// Name for tables.
    pub fn name(&self) -> String {
        let reversed = if self.reversed { " rev." } else { "" };
        format!("{}{reversed}", self.motion)
    }
}

/// Lines of a folder, and of how many cases they are.
#[derive(Debug, Clone)]
pub struct Lines<T> {
    /// The lines that are finished, in the order of the cases.
    pub lines: Vec<Line<T>>,
    /// Number of cases; more than lines where somebody said stop.
    pub n_cases: usize,
}

/// Who ends a folder of runs, and who is told of each, with the number of all.
#[derive(Clone, Copy)]
#[expect(missing_debug_implementations, reason = "what is told of progress is a closure")]
pub struct Watched<'a> {
    /// Whoever sets it ends runs that have begun, and no other begins.
    pub stop: &'static AtomicBool,
    /// Is told of each run.
    pub step: &'a (dyn Fn(usize) + Sync),
}

/// A motion in one direction, and the scene that it is to shake.
struct Case<'m, K> {
    motion: &'m Motion,
    scene: &'m Result<(Scene, K), String>,
    reversed: bool,
}

impl<K> Case<'_, K> {
    /// What becomes of it; `None` if somebody ended its run.
    fn line<T>(&self, stop: &'static AtomicBool, run: impl Fn(&Simulation, &K) -> Result<T, Error>) -> Option<Line<T>> {
        let found = match self.scene {
            Err(reason) => Err(reason.clone()),
            Ok((scene, known)) => {
                let prepared = self.motion.shake(scene, self.reversed, Some(stop));
                let found = prepared.and_then(|prepared| run(&prepared, known));
                if found.as_ref().is_err_and(Error::is_stopped) {
                    return None;
                }
                found.map_err(|error| error.reason())
            }
        };
        Some(Line {
            motion: self.motion.name.clone(),
            event: self.motion.event,
            reversed: self.reversed,
            found,
        })
    }
}

/// What comes of every case, in order, up to where somebody says stop; nothing of a case that this ended.
fn until_stopped<C: Sync, L: Send>(cases: &[C], stopped: &AtomicBool, line: impl Fn(&C) -> Option<L> + Sync) -> Vec<L> {
    let unless = |case: &C| (!stopped.load(Ordering::Relaxed)).then(|| line(case))?;
    let lines = parallel::each(cases, unless);
    lines.into_iter().flatten().collect()
}

/// Runs a scene under every motion of a suite, in these directions (whether reversed); a line each, in order. Every motion has a
/// scene of its own, and what its runs have to know besides.
///
/// # Errors
/// Gives the first reason if every run fails.
pub fn lines_of<T: Send, K: Send + Sync>(
    suite: &Suite,
    directions: &[bool],
    watched: Watched<'_>,
    scene: impl Fn(&Motion) -> Result<(Scene, K), Error> + Sync,
    run: impl Fn(&Simulation, &K) -> Result<T, Error> + Sync,
) -> Result<Lines<T>, String> {
    // Once for both directions: to scale a record takes its spectrum.
    let scene = |motion: &Motion| scene(motion).map_err(|error| error.reason());
    let scenes: Vec<Result<(Scene, K), String>> = parallel::each(&suite.motions, scene);
    let under = suite.motions.iter().zip(&scenes);
    let cases: Vec<Case<'_, K>> = under
        .flat_map(|(motion, scene)| {
            directions.iter().map(move |reversed| Case {
                motion,
                scene,
                reversed: *reversed,
            })
        })
        .collect();
    let line = |case: &Case<'_, K>| {
        let line = case.line(watched.stop, &run);
        (watched.step)(cases.len());
        line
    };
    let lines = until_stopped(&cases, watched.stop, line);
    match nothing_found(lines.iter().map(|line| &line.found)) {
        Some(first) => Err(format!(
            "none of the {} motions shakes the row; the first, {}: {first}",
            suite.motions.len(),
            suite.motions[0].name
        )),
        None => Ok(Lines {
            lines,
            n_cases: cases.len(),
        }),
    }
}

/// The first reason, where there are nothing but reasons.
pub fn nothing_found<'a, T: 'a, E: 'a>(mut found: impl Iterator<Item = &'a Result<T, E>>) -> Option<&'a E> {
    let first = found.next()?.as_ref().err()?;
    found.all(Result::is_err).then_some(first)
}

/// Names the runs that failed, with the reason. The direction is told if the other one did not fail for the same reason.
pub fn failed<T>(lines: &[Line<T>]) -> Vec<String> {
    let said = |line: &Line<T>| {
        let reason = line.found.as_ref().err()?;
        let mut same = lines.iter().filter(|other| other.motion == line.motion);
        let both = same.all(|other| other.found.as_ref().err() == Some(reason));
        let direction = match (both, line.reversed) {
            (true, _) => "",
            (false, true) => ", reversed",
            (false, false) => ", as given",
        };
        Some(format!("{}{direction}: {reason}", line.motion))
    };
    let mut said: Vec<String> = lines.iter().filter_map(said).collect();
    said.dedup();
    said
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering};

    use super::{Line, failed, nothing_found, until_stopped};

    fn line(motion: &str, reversed: bool, found: Result<(), &str>) -> Line<()> {
        Line {
            motion: motion.into(),
            event: 0,
            reversed,
            found: found.map_err(String::from),
        }
    }

    /// Ctrl-C lost what was done.
    #[test]
    fn issue_what_is_finished_when_stopped_is_kept() {
        let (stopped, cases) = (AtomicBool::new(false), (0..10_000).collect::<Vec<_>>());
        let line = |case: &i32| {
            stopped.fetch_or(*case >= 5, Ordering::Relaxed);
            Some(*case)
        };
        let kept = until_stopped(&cases, &stopped, line);
        assert!((1..10_000).contains(&kept.len()), "{}", kept.len());
        assert!(kept.is_sorted(), "in the order of the cases");
        stopped.store(false, Ordering::Relaxed);
        assert_eq!(until_stopped(&cases, &stopped, |case| Some(*case)), cases);
    }

    /// A motion that failed only when reversed was said nowhere.
    #[test]
    fn issue_what_fails_in_one_direction_is_said() {
        let lines = [
            line("a", false, Ok(())),
            line("a", true, Err("diverges")),
            line("b", false, Err("no record")),
            line("b", true, Err("no record")),
            line("c", false, Err("one")),
            line("c", true, Err("another")),
        ];
        let wanted = ["a, reversed: diverges", "b: no record", "c, as given: one", "c, reversed: another"];
        assert_eq!(failed(&lines), wanted);
        assert_eq!(failed(&[line("d", true, Err("x"))]), ["d: x"]);
        assert_eq!(nothing_found(lines.iter().map(|line| &line.found)), None);
        let refused = lines[2..].iter().map(|line| &line.found);
        assert_eq!(nothing_found(refused).map(String::as_str), Some("no record"));
    }
}
