//! An assessment of the runs under a folder of records.

use pounding_assess::{AssessedRun, MotionLine, MotionSpectrum, Suite};
use pounding_scene::{Error, Scene};

use super::{AssessedMotion, AssessmentReport, FolderOfMotions};

impl FolderOfMotions {
    /// What became of the records of a folder, in these runs.
    pub fn of<T>(suite: &Suite, lines: &[MotionLine<T>], details: bool) -> Self {
        let failed = MotionLine::failed(lines);
        Self {
            missing: suite.says_missing(failed.len()),
            units_apart: suite.says_units_apart(),
            counts: suite.counts(),
            of_tables: suite.of_tables.clone(),
            left_out: suite.left_out_json(),
            remarks: failed.into_iter().chain(suite.remarks(details)).collect(),
        }
    }
}

impl AssessmentReport {
    /// Assesses a scene under the motions of a folder; `None` if no run was finished.
    ///
    /// # Errors
    /// Those of [`Self::of`].
    pub fn of_lines(
        scene: Scene,
        suite: &Suite,
        lines: &[MotionLine<(AssessedRun, Option<MotionSpectrum>)>],
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
        let folder = FolderOfMotions::of(suite, lines, true);
        let report = Self::of(scene, found.collect())?;
        Ok(report.map(|report| report.with_folder(folder)))
    }
}
