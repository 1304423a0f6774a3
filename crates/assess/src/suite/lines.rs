//! A scene under every motion of a folder: a result or a reason for each motion.

use std::sync::atomic::{AtomicBool, Ordering};

use pounding_scene::{Error, Scene, Simulation, parallel};

use super::{Suite, SuiteMotion};

/// Result of a scene under one motion in one direction.
#[derive(Debug, Clone)]
pub struct MotionLine<T> {
    /// Name of the motion.
    pub motion: String,
    /// Number of the event of the motion.
    pub event: usize,
    /// Whether the motion is reversed.
    pub reversed: bool,
    /// Result, or the reason why there is none.
    pub found: Result<T, String>,
}

impl<T> MotionLine<T> {
    /// Name for tables.
    pub fn name(&self) -> String {
        let reversed = if self.reversed { ", reversed" } else { "" };
        format!("{}{reversed}", self.motion)
    }

    /// Names the runs that failed, with the reason. Names the direction unless both directions failed for the same reason.
    pub fn failed(lines: &[Self]) -> Vec<String> {
        let said = |line: &Self| {
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
}

/// Results of a scene under the motions of a folder.
#[derive(Debug, Clone)]
pub struct MotionLines<T> {
    /// Finished lines, in the order of the cases.
    pub lines: Vec<MotionLine<T>>,
    /// Number of cases; larger than the number of lines if the work was stopped.
    pub n_cases: usize,
}

impl<T: Send> MotionLines<T> {
    /// Runs a scene under every motion of a suite, in the given directions (`true` for reversed), and returns a line for each in order.
    /// `scene` makes the scene of a motion and what its runs must know; `run` makes the result.
    ///
    /// # Errors
    /// Returns the first reason if every run fails.
    pub fn of<K: Send + Sync>(
        suite: &Suite,
        directions: &[bool],
        watched: Watched<'_>,
        scene: impl Fn(&SuiteMotion) -> Result<(Scene, K), Error> + Sync,
        run: impl Fn(&Simulation, &K) -> Result<T, Error> + Sync,
    ) -> Result<Self, String> {
        // Once for both directions, because scaling may take the record's spectrum.
        let scene = |motion: &SuiteMotion| scene(motion).map_err(|error| error.reason());
        let scenes: Vec<Result<(Scene, K), String>> = parallel::each(&suite.motions, scene);
        let under = suite.motions.iter().zip(&scenes);
        let cases: Vec<MotionCase<'_, K>> = under
            .flat_map(|(motion, scene)| {
                directions.iter().map(move |reversed| MotionCase {
                    motion,
                    scene,
                    reversed: *reversed,
                })
            })
            .collect();
        let line = |case: &MotionCase<'_, K>| {
            let line = case.line(watched.stop, &run);
            (watched.step)(cases.len());
            line
        };
        let lines = until_stopped(&cases, watched.stop, line);
        match nothing_found(lines.iter().map(|line| &line.found)) {
            Some(first) => Err(format!(
                "there is a result under none of the {} motions; the first, {}: {first}",
                suite.motions.len(),
                suite.motions[0].name
            )),
            None => Ok(Self {
                lines,
                n_cases: cases.len(),
            }),
        }
    }
}

/// Who can stop the runs of a folder, and who follows their progress.
#[derive(Clone, Copy)]
#[expect(missing_debug_implementations, reason = "what is told of progress is a closure")]
pub struct Watched<'a> {
    /// Setting it ends the runs that have begun; no other run begins.
    pub stop: &'static AtomicBool,
    /// Is called after each run with the number of all runs.
    pub step: &'a (dyn Fn(usize) + Sync),
}

/// A motion in one direction, and its scene.
struct MotionCase<'m, K> {
    motion: &'m SuiteMotion,
    scene: &'m Result<(Scene, K), String>,
    reversed: bool,
}

impl<K> MotionCase<'_, K> {
    /// Runs the case; `None` if the run was stopped.
    fn line<T>(&self, stop: &'static AtomicBool, run: impl Fn(&Simulation, &K) -> Result<T, Error>) -> Option<MotionLine<T>> {
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
        Some(MotionLine {
            motion: self.motion.name.clone(),
            event: self.motion.event,
            reversed: self.reversed,
            found,
        })
    }
}

/// Runs all cases and returns their results in order. After a stop no further case begins, and a case that was stopped has no result.
fn until_stopped<C: Sync, L: Send>(cases: &[C], stopped: &AtomicBool, line: impl Fn(&C) -> Option<L> + Sync) -> Vec<L> {
    let unless = |case: &C| (!stopped.load(Ordering::Relaxed)).then(|| line(case))?;
    let lines = parallel::each(cases, unless);
    lines.into_iter().flatten().collect()
}

/// Returns the first error if all results are errors.
pub fn nothing_found<'a, T: 'a, E: 'a>(mut found: impl Iterator<Item = &'a Result<T, E>>) -> Option<&'a E> {
    let first = found.next()?.as_ref().err()?;
    found.all(Result::is_err).then_some(first)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering};

    use super::{MotionLine, nothing_found, until_stopped};

    fn line(motion: &str, reversed: bool, found: Result<(), &str>) -> MotionLine<()> {
        MotionLine {
            motion: motion.into(),
            event: 0,
            reversed,
            found: found.map_err(String::from),
        }
    }

    /// Ctrl-C lost the finished results.
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

    /// A motion that failed only when reversed was not reported.
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
        assert_eq!(MotionLine::failed(&lines), wanted);
        assert_eq!(MotionLine::failed(&[line("d", true, Err("x"))]), ["d: x"]);
        assert_eq!(nothing_found(lines.iter().map(|line| &line.found)), None);
        let refused = lines[2..].iter().map(|line| &line.found);
        assert_eq!(nothing_found(refused).map(String::as_str), Some("no record"));
    }
}
