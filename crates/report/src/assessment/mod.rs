//! An assessment as a folder: a page to forward, tables, figures.

mod facts;
mod figures;
mod page;
mod sketch;
mod words;

use std::collections::BTreeMap;

use pounding_scene::{AssessedRun, Assessment, Error, Floors, Scene, in_scene};
use serde_json::Value;

/// A run of an assessment and the motion that it is of.
#[derive(Debug, Clone, PartialEq)]
pub struct AssessedMotion {
    /// Name of the motion.
    pub name: String,
    /// Whether it shakes the row the other way round.
    pub reversed: bool,
    /// What it does.
    pub run: AssessedRun,
}

/// An assessment with all that a page about it says.
#[derive(Debug)]
pub struct AssessmentReport {
    scene: Scene,
    floors: Floors,
    assessment: Assessment,
    motions: Vec<AssessedMotion>,
    remarks: Vec<String>,
    stiffness: [f64; 2],
    scaling: Option<String>,
    author: Option<String>,
    date: Option<String>,
}

/// Files of the folder.
const PAGE: &str = "report.html";
const TABLE: &str = "assess.csv";
const JSON: &str = "assess.json";

impl AssessmentReport {
    /// Of a scene under these motions; `None` without one.
    ///
    /// # Errors
    /// Those of [`Floors::of`].
    pub fn of(scene: Scene, motions: Vec<AssessedMotion>) -> Result<Option<Self>, Error> {
        let floors = Floors::of(&scene).map_err(|source| in_scene(&scene, source))?;
        let runs: Vec<&AssessedRun> = motions.iter().map(|one| &one.run).collect();
        let assessment = Assessment::of(&scene, &runs)?;
        Ok(assessment.map(|assessment| Self {
            scene,
            floors,
            assessment,
            motions,
            remarks: Vec::new(),
            stiffness: [1.0; 2],
            scaling: None,
            author: None,
            date: None,
        }))
    }

    /// With what is said of the records: those left out, those of unknown direction.
    #[must_use]
    pub fn with_remarks(self, remarks: Vec<String>) -> Self {
        Self { remarks, ..self }
    }

    /// With the range of the stiffness of contact, as factors on that of the scene.
    #[must_use]
    pub fn with_stiffness(self, stiffness: [f64; 2]) -> Self {
        Self { stiffness, ..self }
    }

    /// With what records were scaled to, in the words of the command line; `None` if the scene says it.
    #[must_use]
    pub fn with_scaling(self, scaling: Option<String>) -> Self {
        Self { scaling, ..self }
    }

    /// With an author and a date for the page.
    #[must_use]
    pub fn signed(self, author: Option<String>, date: Option<String>) -> Self {
        Self {
            author,
            date,
            ..self
        }
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

    /// What is said of records.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// The files of a folder, by name: `report.html`, `assess.csv`, `assess.json` and the figures as SVG and PNG.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let drawn = figures::all(self);
        let mut files = BTreeMap::from([
            (PAGE.into(), page::html(self, &drawn).into_bytes()),
            (TABLE.into(), self.to_csv().into_bytes()),
            (
                JSON.into(),
                pounding_text::json_text(&self.to_json()).into_bytes(),
            ),
        ]);
        for figure in drawn {
            if let Ok((svg, png)) = figure.drawn {
                files.insert(format!("{}.svg", figure.name), svg.into_bytes());
                files.insert(format!("{}.png", figure.name), png);
            }
        }
        files
    }

    /// Everything for machines, SI units.
    pub fn to_json(&self) -> Value {
        facts::json(self)
    }

    /// A line per number, SI units: record, reversed, building, floor, neighbour, quantity, value.
    pub fn to_csv(&self) -> String {
        facts::csv(self)
    }

    /// Whether a folder of an assessment can have a file of this name.
    pub fn has_file(name: &str) -> bool {
        let is_figure = |(stem, end): (&str, &str)| {
            figures::NAMES.contains(&stem) && matches!(end, "svg" | "png")
        };
        [PAGE, TABLE, JSON].contains(&name) || name.rsplit_once('.').is_some_and(is_figure)
    }
}
