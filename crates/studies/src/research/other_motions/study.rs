//! What is run: the paper's scenes, and the ground motions of a list or of a folder.

use super::shaking::{Shaking, Target};
use super::world::MotionCase;
use super::{Beyond, Case, Change, Group};
use crate::paper::converged::{OF_CLAIMS, STUDIES, Scenes};
use crate::study::other_motions::{BeyondSettings, ListedMotion};
use crate::{StudyError, StudyFile};
use pounding_assess::Suite;
use pounding_scene::{Method, Scene, Simulation, Structure, parallel};
use std::path::{Path, PathBuf};

/// The paper's scenes and the ground motions that are to shake them.
#[derive(Debug)]
pub struct BeyondStudy {
    /// The study, or the folder of records.
    path: PathBuf,
    scenes: Scenes,
    motions: Vec<Shaking>,
    changes: Vec<Change>,
    /// The paper's case, where it is one of them.
    papers: Option<Case>,
    /// Motions that shake nothing, with the reason; nothing where every motion has to.
    left_out: Option<Vec<(String, String)>>,
}

impl BeyondStudy {
    /// The motions that a study lists, and the scenes of the others; nothing where no study lists motions.
    ///
    /// # Errors
    /// [`StudyError`] for a study that is missing, and for a motion that is not allowed or cannot be read.
    pub fn listed(files: &[&StudyFile]) -> Result<Option<Self>, StudyError> {
        let Some((path, settings)) = StudyFile::listing(files.iter().copied()) else {
            return Ok(None);
        };
        Self::of(files, (path, settings), usize::MAX).map(|(study, _)| Some(study))
    }

    /// The scenes of a folder of studies under the records of another folder, instead of those that a study lists.
    ///
    /// `scaled` says whether they are scaled as that study does. Records that cannot be read, vertical components, and motions
    /// under which a run fails are [left out](Beyond::left_out).
    ///
    /// # Errors
    /// [`StudyError`] for studies that cannot be read, for a folder that cannot be, and where no motion is left.
    pub fn of_records(studies: &Path, records: &Path, scaled: bool) -> Result<Self, StudyError> {
        let files = StudyFile::read_all(studies)?;
        let (path, settings) = StudyFile::listing(&files).ok_or_else(|| StudyError::no_scene_of("beyond"))?;
        let (study, target) = Self::of(&files.iter().collect::<Vec<_>>(), (path, settings), 1)?;
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

    /// The first motions of a list, and the strength to which all are scaled.
    fn of(files: &[&StudyFile], (path, settings): (&Path, &BeyondSettings), most: usize) -> Result<(Self, Option<Target>), StudyError> {
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

    /// Refuses where no motion is left.
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

    /// Without the changes of the scenes that take long.
    #[must_use]
    pub fn usual(mut self) -> Self {
        self.changes.retain(|change| !change.is_long());
        self
    }

    /// Number of times that [`Self::run`] calls `done`.
    pub fn n_cases(&self) -> usize {
        2 * self.motions.len() * (1 + self.changes.len())
    }

    /// Runs every scene, also changed, under every motion in both directions; `done` is called after each case.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the cases; of a folder of records only where no motion is left.
    pub fn run(mut self, done: &(dyn Fn() + Sync)) -> Result<Beyond, StudyError> {
        let motions = std::mem::take(&mut self.motions);
        let changes: Vec<_> = std::iter::once(None).chain(self.changes.iter().copied().map(Some)).collect();
        let of_motion = |motion: &Shaking| {
            parallel::try_each(&changes, |change| {
                let world = |reversed: &bool| {
                    let world = MotionCase::new(&self.scenes, (motion, *reversed), *change);
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
        // Collected first: of several errors, the first in order is reported, not the first in time.
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

/// The motions of a list, all as strong as the first where it scales them.
///
/// # Errors
/// [`StudyError`] for a motion that is not allowed or cannot be read.
pub(crate) fn motions_of(settings: &BeyondSettings, path: &Path) -> Result<Vec<Shaking>, StudyError> {
    read(settings, path, usize::MAX).map(|(motions, _)| motions)
}

/// The first motions of a list, and the strength of the first, to which others are scaled.
fn read(settings: &BeyondSettings, path: &Path, most: usize) -> Result<(Vec<Shaking>, Option<Target>), StudyError> {
    if let Some((place, found, allowed)) = settings.fault() {
        return Err(StudyError::refused(path, place, found, allowed));
    }
    let base = path.parent().unwrap_or_else(|| Path::new(""));
    let (mut motions, mut target) = (Vec::new(), None);
    for motion in settings.motions.iter().take(most) {
        motions.push(Shaking::listed(motion, base, settings, target).map_err(|error| error.in_file(path))?);
        // To scale the first to itself would cost its last digits.
        if let [first] = &motions[..] {
            target = Target::of(settings, first).map_err(|error| {
                let allowed = "a period and damping of which the first motion has a spectrum";
                StudyError::refused(path, "output.beyond.scaled_by", error.to_string(), allowed)
            })?;
        }
    }
    Ok((motions, target))
}

/// A scene of the paper, under its record.
fn papers_scene(scenes: &Scenes) -> Result<&Scene, StudyError> {
    let first = scenes.prepared().next().map(Simulation::scene);
    first.ok_or_else(|| StudyError::no_scene_of(STUDIES[0]))
}

/// The listed motion and the direction that are those of the paper's scenes.
fn papers(settings: &BeyondSettings, scenes: &Scenes) -> Option<Case> {
    let record = &papers_scene(scenes).ok()?.record;
    let mut as_recorded = record.clone();
    as_recorded.reversed = false;
    let same = |motion: &ListedMotion| motion.record == as_recorded;
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
    // Two that the table would print alike are one.
    periods.dedup_by(|one, other| (*one - *other).abs() < 0.005);
    periods
}
