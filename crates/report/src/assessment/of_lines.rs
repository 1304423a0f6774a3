//! An assessment of the runs under a folder of records.

use pounding_scene::lines::{Line, count, left_out, untold};
use pounding_scene::{AssessedRun, Error, MotionSpectrum, Scene};

use super::{AssessedMotion, AssessmentReport, FolderOfMotions};

/// What is said of motions that are left out, and of those whose direction nothing tells.
pub fn remarks<T>(lines: &[Line<T>]) -> Vec<String> {
    let untold = untold(lines).map(|said| format!("direction {said}"));
    left_out(lines).into_iter().chain(untold).collect()
}

impl FolderOfMotions {
    /// What became of the motions of a folder.
    pub fn of_lines<T>(lines: &[Line<T>]) -> Self {
        Self {
            vertical: count(lines, |line| line.vertical),
            failed: count(lines, |line| {
                let mut same = lines.iter().filter(|other| other.motion == line.motion);
                !line.vertical && same.all(|other| other.found.is_err())
            }),
            remarks: remarks(lines),
        }
    }
}

impl AssessmentReport {
    /// Of a scene under the motions of a folder, with what became of each; `None` if no run was finished.
    ///
    /// # Errors
    /// Those of [`Self::of`].
    pub fn of_lines(
        scene: Scene,
        lines: &[Line<(AssessedRun, Option<MotionSpectrum>)>],
    ) -> Result<Option<Self>, Error> {
        let found = lines.iter().filter_map(|line| {
            let (run, spectrum) = line.found.as_ref().ok()?.clone();
            Some(AssessedMotion {
                name: line.motion.clone(),
                event: line.event,
                reversed: line.reversed,
                neighbour: None,
                bumper: None,
                spectrum,
                run,
            })
        });
        let folder = FolderOfMotions::of_lines(lines);
        let report = Self::of(scene, found.collect())?;
        Ok(report.map(|report| report.with_folder(folder)))
    }
}
