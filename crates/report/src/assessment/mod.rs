//! An assessment as a folder: a page to forward, tables, figures.

mod answer;
mod bumper;
mod cautions;
mod consequences;
mod context;
mod figures;
mod gap_answers;
mod numbers;
mod of_lines;
mod page;
mod prior;
mod profiles;
mod spectra;
mod tables;
mod words;

use std::collections::BTreeMap;

use pounding_assess::{
    AssessedRun, Assessment, Bumper, BumperCase, BumperEffect, BumperRun, MotionSpectrum, Rule, RunOfCase, Scaling, TargetFit,
};
use pounding_scene::file::DrawnNeighbour;
use pounding_scene::{Error, Floors, Scene};
use pounding_text::Form;
use serde_json::Value;

use crate::animation::{Animation, FILE};
use crate::figures::Illustration;

/// A run of an assessment and the motion that it is of.
#[derive(Debug, Clone, PartialEq)]
pub struct AssessedMotion {
    /// Name of the motion.
    pub name: String,
    /// Number of the event that it is of.
    pub event: usize,
    /// Whether it shakes the row the other way round.
    pub reversed: bool,
    /// The neighbour that was drawn for it, if the scene does not know its own.
    pub neighbour: Option<DrawnNeighbour>,
    /// What bumpers make of it, if something touches without them.
    pub bumper: Option<BumperRun>,
    /// Its spectrum as it shakes the row; `None` if it cannot be computed.
    pub spectrum: Option<MotionSpectrum>,
    /// Results of the run.
    pub run: AssessedRun,
}

impl AssessedMotion {
    /// Its name, and its direction if it is reversed.
    fn shown(&self) -> String {
        let reversed = if self.reversed { ", reversed" } else { "" };
        format!("{}{reversed}", self.name)
    }
}

/// The motions of a folder that were used or left out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FolderOfMotions {
    /// How many records may be missing, in a sentence: they cannot be read, are refused, or failed.
    pub missing: Option<String>,
    /// Units that are declared for records too far apart for one unit, in a sentence without its end.
    pub units_apart: Option<String>,
    /// Files, motions and events, counted.
    pub counts: String,
    /// What tables beside the records say of them, in sentences.
    pub of_tables: Vec<String>,
    /// Files that shake nothing, for programs.
    pub left_out: Value,
    /// Sentences about failures, files that are left out, and declarations.
    pub remarks: Vec<String>,
}

/// How records are scaled.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalingAsked {
    /// The target.
    pub to: Scaling,
    /// The options of the command line that asked for it; `None` if the scene did.
    pub words: Option<String>,
}

/// An assessment with all that a page about it says.
#[derive(Debug)]
pub struct AssessmentReport {
    /// The row, of unknown neighbours with the first that was drawn.
    scene: Scene,
    /// The scene of the user.
    asked: Scene,
    floors: Floors,
    assessment: Assessment,
    motions: Vec<AssessedMotion>,
    folder: FolderOfMotions,
    stiffness: [f64; 2],
    scaling: ScalingAsked,
    fit: Option<TargetFit>,
    animation: Option<Animation>,
    bumper: Option<BumperEffect>,
    bumper_words: Option<String>,
    code: Option<Rule>,
    author: Option<String>,
    date: Option<String>,
}

/// The runs of motions, each with its case: an event beside a neighbour.
fn runs_of_cases(motions: &[AssessedMotion]) -> Vec<RunOfCase<'_>> {
    let mut drawn: Vec<Option<DrawnNeighbour>> = Vec::new();
    let mut runs = Vec::new();
    for one in motions {
        let known = drawn.iter().position(|known| *known == one.neighbour);
        let neighbour = known.unwrap_or_else(|| {
            drawn.push(one.neighbour);
            drawn.len() - 1
        });
        runs.push(RunOfCase {
            event: one.event,
            neighbour,
            run: &one.run,
        });
    }
    runs
}

/// Files of the folder.
const PAGE: &str = "report.html";
const TABLE: &str = "assess.csv";
pub(crate) const JSON: &str = "assess.json";

impl AssessmentReport {
    /// Assesses a scene under these motions; `None` without a motion.
    ///
    /// # Errors
    /// Those of [`Floors::of`].
    pub fn of(scene: Scene, motions: Vec<AssessedMotion>) -> Result<Option<Self>, Error> {
        let floors = Floors::of(&scene).map_err(|source| Error::in_scene(&scene.name, source))?;
        let runs = runs_of_cases(&motions);
        let assessment = Assessment::of(&scene, &runs)?;
        Ok(assessment.map(|assessment| Self {
            asked: scene.clone(),
            scene,
            floors,
            assessment,
            motions,
            folder: FolderOfMotions::default(),
            stiffness: [1.0; 2],
            scaling: ScalingAsked {
                to: Scaling::AsScene,
                words: None,
            },
            fit: None,
            animation: None,
            bumper: None,
            bumper_words: None,
            code: None,
            author: None,
            date: None,
        }))
    }

    /// With the scene of the user, if its neighbour is not known.
    #[must_use]
    pub fn asked_of(self, asked: Scene) -> Self {
        Self { asked, ..self }
    }

    /// With bumpers that the motions were run with, and how they were asked for if not by default. Runs that are not believed do not count.
    #[must_use]
    pub fn with_bumpers(self, bumpers: &[Bumper], words: Option<String>) -> Self {
        let runs = runs_of_cases(&self.motions);
        let of_case = |(motion, run): (&AssessedMotion, &RunOfCase<'_>)| {
            let believed = motion.run.disbelieved_alone.is_none() && motion.run.disbelieved_beside.is_none();
            believed.then_some(())?;
            Some((run.case(), motion.bumper.clone()?, motion.run.clone()))
        };
        let runs: Vec<_> = self.motions.iter().zip(&runs).filter_map(of_case).collect();
        let runs: Vec<BumperCase<'_>> = runs
            .iter()
            .map(|(case, with, without)| BumperCase {
                case: *case,
                without,
                with,
            })
            .collect();
        let bumper = BumperEffect::of(&self.floors, bumpers, &runs);
        Self {
            bumper,
            bumper_words: words,
            ..self
        }
    }

    /// With the code whose width is told in a sentence.
    #[must_use]
    pub fn with_code(self, code: Option<Rule>) -> Self {
        Self { code, ..self }
    }

    /// With the hardest collision in motion.
    #[must_use]
    pub fn with_animation(self, animation: Option<Animation>) -> Self {
        Self { animation, ..self }
    }

    /// Returns the report with the motions of the folder that were used or left out.
    #[must_use]
    pub fn with_folder(self, folder: FolderOfMotions) -> Self {
        Self { folder, ..self }
    }

    /// With the range of the stiffness of contact, as factors on that of the scene.
    #[must_use]
    pub fn with_stiffness(self, stiffness: [f64; 2]) -> Self {
        Self { stiffness, ..self }
    }

    /// Returns the report with the target of scaling.
    #[must_use]
    pub fn with_scaling(self, scaling: ScalingAsked) -> Self {
        let target = scaling.to.target();
        let fit = target.and_then(|target| TargetFit::of(&self.asked, target, &self.spectra()));
        Self { scaling, fit, ..self }
    }

    /// Spectra of the motions, each once.
    fn spectra(&self) -> Vec<&MotionSpectrum> {
        let mut once: Vec<&AssessedMotion> = Vec::new();
        for one in &self.motions {
            if once.last().is_none_or(|last| last.name != one.name) {
                once.push(one);
            }
        }
        let spectra = once.into_iter();
        spectra.filter_map(|one| one.spectrum.as_ref()).collect()
    }

    /// With an author and a date for the page.
    #[must_use]
    pub fn signed(self, author: Option<String>, date: Option<String>) -> Self {
        Self { author, date, ..self }
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Its floors.
    pub fn floors(&self) -> &Floors {
        &self.floors
    }

    /// What was found.
    pub fn assessment(&self) -> &Assessment {
        &self.assessment
    }

    /// Every run.
    pub fn motions(&self) -> &[AssessedMotion] {
        &self.motions
    }

    /// The range of the stiffness of contact, as factors on that of the scene \[–\].
    pub fn stiffness(&self) -> [f64; 2] {
        self.stiffness
    }

    /// Names files that are left out, declarations, and records of unknown direction.
    pub fn remarks(&self) -> &[String] {
        &self.folder.remarks
    }

    /// The files of a folder, by name: `report.html`, `assess.csv`, `assess.json`, `animation.svg` and the figures as SVG and PNG.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let (drawn, answer) = (figures::all(self), self.answer());
        let mut files = BTreeMap::from([
            (PAGE.into(), page::html(self, &drawn).into_bytes()),
            (TABLE.into(), answer.text(Form::Csv).into_bytes()),
            (JSON.into(), answer.text(Form::Json).into_bytes()),
        ]);
        if let Some(animation) = &self.animation {
            files.insert(FILE.into(), animation.svg.clone().into_bytes());
        }
        files.extend(Illustration::files(drawn));
        files
    }

    /// Whether a folder of an assessment can have a file of this name.
    pub fn has_file(name: &str) -> bool {
        [PAGE, TABLE, JSON, FILE].contains(&name) || Illustration::has_file(&figures::NAMES, name)
    }
}
