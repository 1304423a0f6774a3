//! The paper's scenes together with the ground motions of a list or of a folder.

use super::shaking::{Shaking, Target};
use super::world::MotionCase;
use super::{Beyond, Case, Change, Group};
use crate::paper::converged::{OF_CLAIMS, STUDIES, Scenes};
use crate::study::other_motions::{BeyondSettings, ListedMotion};
use crate::{StudyError, StudyFile};
use pounding_assess::Suite;
use pounding_scene::{Method, Scene, Simulation, Structure, parallel};
use std::path::{Path, PathBuf};

/// The paper's scenes and the ground motions for them.
#[derive(Debug)]
pub struct BeyondStudy {
    /// Path of the study, or of the folder of records.
    path: PathBuf,
    scenes: Scenes,
    motions: Vec<Shaking>,
    changes: Vec<Change>,
    /// The paper's case; `None` if it is not among the motions.
    papers: Option<Case>,
    /// Unusable motions with the reasons; `None` if every motion must be usable.
    left_out: Option<Vec<(String, String)>>,
}

impl BeyondStudy {
    /// The ground motions that a study lists, with the scenes of the other studies. `None` if no study lists ground motions.
    ///
    /// # Errors
    /// [`StudyError`] if a study is missing, or if a motion is not allowed or cannot be read.
    pub fn listed(files: &[&StudyFile]) -> Result<Option<Self>, StudyError> {
        let Some((path, settings)) = StudyFile::listing(files.iter().copied()) else {
            return Ok(None);
        };
        Self::of(files, path, settings, usize::MAX).map(|(study, _)| Some(study))
    }

    /// The scenes of a folder of studies under the records of another folder, which replace the listed motions.
    ///
    /// `scaled` applies the scaling of the study that lists motions. Records that cannot be read, vertical components, and motions under
    /// which a run fails are [left out](Beyond::left_out).
    ///
    /// # Errors
    /// [`StudyError`] if a study or the folder cannot be read, or if no usable motion is left.
    pub fn of_records(studies: &Path, records: &Path, scaled: bool) -> Result<Self, StudyError> {
        let files = StudyFile::read_all(studies)?;
        let (path, settings) = StudyFile::listing(&files).ok_or_else(|| StudyError::no_scene_of("beyond"))?;
        let (study, target) = Self::of(&files.iter().collect::<Vec<_>>(), path, settings, 1)?;
        let target = target.filter(|_| scaled);
        let like = papers_scene(&study.scenes)?;
        let suite = Suite::of(&[records.to_path_buf()], &like.record.declared())?;
        let left_out = suite.left_out.iter().map(|one| (one.name.clone(), one.reason.sentence()));
        let (mut motions, mut left_out) = (Vec::new(), left_out.collect::<Vec<_>>());
        for motion in &suite.motions {
            match Shaking::of_folder(motion, like, settings, target) {
                Ok(shaking) => motions.push(shaking),
                Err(error) => left_out.push((motion.name.clone(), error.to_string())),
            }
        }
        Self {
            path: records.to_path_buf(),
            motions,
            papers: None,
            left_out: Some(left_out),
            ..study
        }
        .any_left()
    }

    /// The first `most` motions of a list, and the target strength of the scaling.
    fn of(files: &[&StudyFile], path: &Path, settings: &BeyondSettings, most: usize) -> Result<(Self, Option<Target>), StudyError> {
        let (motions, target) = read(settings, path, most)?;
        let studies: Vec<&str> = STUDIES.into_iter().chain([OF_CLAIMS]).collect();
        let scenes = Scenes::of(files, &studies, |_| Method::EXACT)?;
        let study = Self {
            papers: papers(settings, &scenes),
            path: path.to_path_buf(),
            scenes,
            motions,
            changes: settings.changes.clone(),
            left_out: None,
        };
        Ok((study, target))
    }

    /// Refuses a study without a usable motion.
    fn any_left(self) -> Result<Self, StudyError> {
        if !self.motions.is_empty() {
            return Ok(self);
        }
        let first = self.left_out.iter().flatten().next();
        let reason = first.map(|(name, reason)| format!("; the first, {name}: {reason}"));
        let found = format!("none that shakes the scenes{}", reason.unwrap_or_default());
        Err(StudyError::refused(
            &self.path,
            "records",
            found,
            "one or more horizontal ground accelerations",
        ))
    }

    /// Drops the changes that take long.
    #[must_use]
    pub fn usual(mut self) -> Self {
        self.changes.retain(|change| !change.is_long());
        self
    }

    /// Number of calls of `done` by [`Self::run`].
    pub fn n_cases(&self) -> usize {
        2 * self.motions.len() * (1 + self.changes.len())
    }

    /// Runs every scene and every changed scene under every motion in both directions. Calls `done` after each case.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the cases. For a folder of records only if no motion is left.
    pub fn run(mut self, done: &(dyn Fn() + Sync)) -> Result<Beyond, StudyError> {
        let motions = std::mem::take(&mut self.motions);
        let changes: Vec<_> = std::iter::once(None).chain(self.changes.iter().copied().map(Some)).collect();
        let of_motion = |motion: &Shaking| {
            parallel::try_each(&changes, |change| {
                let world = |reversed: &bool| {
                    let world = MotionCase::new(&self.scenes, motion, *reversed, *change);
                    done();
                    world
                };
                let [recorded, reversed] = parallel::both(&[false, true], world);
                Ok::<_, StudyError>([recorded?, reversed?])
            })
        };
        let ran = parallel::each(&motions, of_motion);
        let worlds = Vec::new;
        let mut groups: Vec<_> = changes.iter().map(|&change| Group { change, worlds: worlds() }).collect();
        // All results are collected first, so the reported error is the first in order, not the first in time.
        for (motion, worlds) in motions.into_iter().zip(ran) {
            match (worlds, &mut self.left_out) {
                (Ok(worlds), _) => {
                    self.motions.push(motion);
                    for (group, both) in groups.iter_mut().zip(worlds) {
                        group.worlds.push(both);
                    }
                }
                (Err(error), Some(left_out)) => left_out.push((motion.name, error.to_string())),
                (Err(error), None) => return Err(error),
            }
        }
        let left = self.any_left()?;
        Ok(Beyond {
            periods: periods(&left.scenes),
            path: left.path,
            motions: left.motions,
            groups,
            papers: left.papers,
            left_out: left.left_out.unwrap_or_default(),
        })
    }
}

/// The motions of a list; if the list scales them, all are as strong as the first.
///
/// # Errors
/// [`StudyError`] if a motion is not allowed or cannot be read.
pub(crate) fn motions_of(settings: &BeyondSettings, path: &Path) -> Result<Vec<Shaking>, StudyError> {
    read(settings, path, usize::MAX).map(|(motions, _)| motions)
}

/// The first `most` motions of a list, and the strength of the first, to which the others are scaled.
fn read(settings: &BeyondSettings, path: &Path, most: usize) -> Result<(Vec<Shaking>, Option<Target>), StudyError> {
    if let Some((place, found, allowed)) = settings.fault() {
        return Err(StudyError::refused(path, place, found, allowed));
    }
    let base = path.parent().unwrap_or_else(|| Path::new(""));
    let (mut motions, mut target) = (Vec::new(), None);
    for motion in settings.motions.iter().take(most) {
        motions.push(Shaking::listed(motion, base, settings, target).map_err(|error| error.in_file(path))?);
        // The first motion is not scaled to itself: that would change its last digits.
        if let [first] = &motions[..] {
            target = Target::of(settings, first).map_err(|error| {
                let allowed = "a period and a damping ratio for which the first motion has a spectrum";
                StudyError::refused(path, "output.beyond.scaled_by", error.to_string(), allowed)
            })?;
        }
    }
    Ok((motions, target))
}

/// The first scene of the paper's studies.
fn papers_scene(scenes: &Scenes) -> Result<&Scene, StudyError> {
    let first = scenes.prepared().next().map(Simulation::scene);
    first.ok_or_else(|| StudyError::no_scene_of(STUDIES[0]))
}

/// The motion and direction of the paper's scenes, if the list has that motion.
fn papers(settings: &BeyondSettings, scenes: &Scenes) -> Option<Case> {
    let record = &papers_scene(scenes).ok()?.record;
    let mut as_given = record.clone();
    as_given.reversed = false;
    let same = |motion: &ListedMotion| motion.record == as_given;
    Some(Case {
        motion: settings.motions.iter().position(same)?,
        reversed: record.reversed,
    })
}

/// Natural periods of the structures, the shortest first \[s\].
fn periods(scenes: &Scenes) -> Vec<f64> {
    let structures = scenes.prepared().flat_map(|scene| &scene.scene().structures);
    let mut periods: Vec<f64> = structures.filter_map(Structure::period).collect();
    periods.sort_by(f64::total_cmp);
    // Two periods that the table would print alike are merged.
    periods.dedup_by(|one, other| (*one - *other).abs() < 0.005);
    periods
}
