//! Results of the scenes under one ground motion in one direction.

use super::Change;
use super::shaking::Shaking;
use crate::paper::claims::{Claim, SceneRun, verdicts};
use crate::paper::converged::{OF_CLAIMS, Scenes};
use crate::{Completed, StudyError};
use pounding_motion::Record;
use pounding_scene::{Scene, Simulation, Structure};

/// Numbers and verdicts under one motion in one direction.
#[derive(Debug)]
pub(super) struct MotionCase {
    /// One row per structure of every scene.
    pub(super) rows: Vec<StructureResult>,
    /// The claims of the paper that exact runs can test, in their order.
    pub(super) claims: Vec<Claim>,
}

/// Results of one structure of one scene.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct StructureResult {
    /// Number of the paper's table.
    pub(super) table: String,
    pub(super) scene: String,
    /// Number of the structure from the left, counted from 1.
    pub(super) number: usize,
    pub(super) structure: String,
    /// Transferred momentum \[N·s\].
    pub(super) momentum: f64,
    /// Signed peak displacement \[m\]; for a building that of its roof.
    pub(super) displacement: f64,
    /// Peak displacement of the structure without neighbours, without sign \[m\].
    pub(super) alone: f64,
    /// Signed peak shear force \[N\]; for a building that of its first storey.
    pub(super) shear: f64,
    /// Signed displacement that remains at the end \[m\]; `None` if the structure cannot yield.
    pub(super) residual: Option<f64>,
    /// Number of collisions of the structure.
    pub(super) collisions: usize,
    /// Start \[s\] and impulse \[N·s\] of the structure's first collision.
    pub(super) first: Option<(f64, f64)>,
}

impl StructureResult {
    /// Peak displacement over the one without neighbours; `None` if the structure does not move without them.
    pub(super) fn amplification(&self) -> Option<f64> {
        (self.alone > 0.0).then(|| self.displacement.abs() / self.alone)
    }
}

impl MotionCase {
    /// Runs every scene, unchanged or with a change.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the scenes.
    pub(super) fn new(scenes: &Scenes, shaking: &Shaking, reversed: bool, change: Option<Change>) -> Result<Self, StudyError> {
        let directed = shaking.directed(reversed);
        let record = match change {
            None => directed,
            Some(change) => change.of_record(directed),
        };
        // Only this place replaces the row or its structures.
        let turned = |scene: &Scene| {
            let mut scene = scene.clone();
            scene.duration_s = Some(shaking.duration);
            change.into_iter().fold(scene, |scene, change| change.of_scene(scene))
        };
        let runs = scenes.shaken(&record, turned)?.run(None)?;
        let mut alone = Alone {
            record: &record,
            known: Vec::new(),
        };
        let mut rows = Vec::new();
        // The scenes of the claims' own study repeat those of Tables 6 and 7.
        for study in runs.iter().filter(|study| study.file.id != OF_CLAIMS) {
            for index in 0..study.prepared.len() {
                rows.extend(of_scene(study, index, &mut alone)?);
            }
        }
        Ok(Self {
            rows,
            claims: verdicts(&runs)?.into_iter().flatten().collect(),
        })
    }
}

/// Results of the structures of a study's scene at an index of its list.
fn of_scene(study: &Completed, index: usize, alone: &mut Alone<'_>) -> Result<Vec<StructureResult>, StudyError> {
    let (scene, run) = (&study.file.study.scenes[index], SceneRun::of(study, index));
    let id = &study.file.id;
    let row = |(place, structure): (usize, &Structure)| {
        let (collisions, first) = run.collisions(place);
        let yields = structure.yield_forces().iter().any(Option::is_some);
        Ok(StructureResult {
            table: id.strip_prefix("table-").unwrap_or(id).into(),
            scene: scene.name.clone(),
            number: place + 1,
            structure: structure.name().into(),
            momentum: run.momentum(place),
            displacement: run.peak_displacement(place),
            alone: alone.displacement(&study.prepared[index], structure)?,
            shear: run.peak_shear(place),
            residual: run.residual(place).filter(|_| yields),
            collisions,
            first,
        })
    };
    scene.structures.iter().enumerate().map(row).collect()
}

/// Runs of structures without neighbours; each structure runs once.
struct Alone<'a> {
    record: &'a Record,
    known: Vec<(Structure, f64)>,
}

impl Alone<'_> {
    /// Peak displacement of a structure without neighbours, without sign \[m\].
    fn displacement(&mut self, prepared: &Simulation, structure: &Structure) -> Result<f64, StudyError> {
        let known = self.known.iter().find(|(known, _)| known == structure);
        if let Some((_, displacement)) = known {
            return Ok(*displacement);
        }
        let scene = Scene {
            structures: vec![structure.clone()],
            contacts: None,
            neighbour: None,
            p_delta: None,
            collapse_drift_ratio: None,
            links: Vec::new(),
            arrivals_s: None,
            ..prepared.scene().clone()
        };
        let alone = prepared.variant(&scene, self.record.clone())?;
        let outcome = alone.run(None)?;
        // The last floor is the roof; a wall has just one node.
        let roof = alone.floors().all().len() - 1;
        let displacement = outcome.peaks.of(roof).displacement.value.abs();
        self.known.push((structure.clone(), displacement));
        Ok(displacement)
    }
}
