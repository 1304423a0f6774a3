//! How often a row is pounded, from records of several intensities and a hazard curve.

use std::collections::BTreeMap;
use std::path::PathBuf;

use pounding_assess::{AskedMeasure, FolderUse, IntensityMeasure, MotionLines, SelectionFactors, Suite};
use pounding_report::{JudgedRun, RiskAsked, RiskReport};
use pounding_risk::{HazardCurve, State};
use pounding_scene::{Floors, Scene};
use pounding_sweep::{Directions, StripeMotions, StripesAsked};
use pounding_text::{Form, Refused};
use pyo3::prelude::*;

use crate::folder::{suite_of, watched};
use crate::refused::OrRefused;
use crate::run::Given;
use crate::waiting::{Watch, wait};

/// How often the states of a row are reached, as the answer of `pounding ida`.
#[pyclass(frozen, module = "pounding._pounding")]
pub(crate) struct Ida {
    /// The answer as text, CSV and JSON.
    texts: [String; 3],
    files: BTreeMap<String, Vec<u8>>,
    refused: Option<String>,
}

#[pymethods]
impl Ida {
    /// The answer as `pounding ida` prints it.
    fn text(&self) -> &str {
        &self.texts[0]
    }

    /// The table of `pounding ida --csv`, one row per run.
    fn csv(&self) -> &str {
        &self.texts[1]
    }

    /// All results, as the JSON of `pounding ida --json`.
    fn facts(&self) -> &str {
        &self.texts[2]
    }

    /// Why the first state has no fragility or no frequency; `None` if it has.
    fn refused(&self) -> Option<&str> {
        self.refused.as_deref()
    }

    /// The files of a folder of results, by name.
    fn files(&self) -> BTreeMap<String, Vec<u8>> {
        self.files.clone()
    }
}

/// Finds how often a row reaches states. `folders` has one folder, whose records are scaled to every one of `intensities` [g] by the measure
/// `im`, or without `im` a folder for each of them. `hazard` is the text of a CSV table.
#[pyfunction]
#[pyo3(signature = (text, path, folders, intensities, im, states, gaps, hazard=None, both=false, progress=None))]
pub(crate) fn ida(
    py: Python<'_>,
    text: &str,
    path: PathBuf,
    folders: Vec<PathBuf>,
    intensities: Vec<f64>,
    im: Option<&str>,
    states: Vec<String>,
    gaps: Vec<f64>,
    hazard: Option<&str>,
    both: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Ida> {
    for (place, numbers) in [("stripes", &intensities), ("gaps", &gaps)] {
        if let Some(bad) = numbers.iter().find(|one| !(**one > 0.0 && one.is_finite())) {
            let found = Refused::at(place).found(bad.to_string());
            return Err(found.allowed_are("finite numbers > 0")).or_refused(py);
        }
    }
    let states: Result<Vec<State>, Refused> = states.iter().map(|one| one.parse()).collect();
    let question = Question {
        given: Given::of(text, path, None),
        folders,
        intensities,
        im: im.map(str::parse).transpose().or_refused(py)?,
        states: states.map_err(|refused| refused.in_field("states")).or_refused(py)?,
        gaps,
        hazard: hazard.map(HazardCurve::parse).transpose().or_refused(py)?,
        both,
    };
    wait(py, progress, |watch| question.answer(watch))?.or_refused(py)
}

/// The arguments of [`ida`], read.
struct Question<'a> {
    given: Given<'a>,
    folders: Vec<PathBuf>,
    intensities: Vec<f64>,
    im: Option<AskedMeasure>,
    states: Vec<State>,
    gaps: Vec<f64>,
    hazard: Option<HazardCurve>,
    both: bool,
}

impl Question<'_> {
    fn answer(&self, watch: &Watch) -> Result<Ida, Refused> {
        let scene = self.given.scene()?;
        let any_record = Scene {
            duration_s: None,
            ..scene.clone()
        };
        Floors::check(&any_record).map_err(|error| self.given.in_file(error))?;
        let measure = self.im.map(|im| im.of_row(&scene)).transpose()?;
        let motions = self.motions(&scene, measure)?;
        let asked = StripesAsked {
            scene: &scene,
            path: &self.given.path,
            motions: &motions,
            directions: if self.both { Directions::Both } else { Directions::AsGiven },
            states: &self.states,
            closings: !self.gaps.is_empty(),
        };
        let runs = asked.run(watched(watch, &|of| watch.step(1, of as u64)))?;
        let questions = RiskAsked {
            states: &self.states,
            gaps: &self.gaps,
            hazard: self.hazard.as_ref(),
            measure,
        };
        let report = RiskReport::of(&scene, motions.suites(), &runs, questions);
        let (stripe, apart) = (
            report.judged_stripe(),
            self.states.iter().all(|state| matches!(state, State::Touch(_))),
        );
        let judged = MotionLines::of(
            motions.suite_at(stripe),
            if self.both { &[false, true] } else { &[false] },
            watched(watch, &|_| ()),
            |motion| motions.scene_at(stripe, motion, &scene),
            |prepared, doubts| JudgedRun::of(prepared, doubts.clone(), apart),
        );
        let report = report.with_cautions(&judged.map_or_else(|_| Vec::new(), |judged| judged.lines));
        let answer = report.answer();
        Ok(Ida {
            texts: [Form::Brief, Form::Csv, Form::Json].map(|form| answer.text(form)),
            files: report.files(),
            refused: report.refused().map(ToString::to_string),
        })
    }

    /// The motions: of one folder by a measure, else of a folder for each intensity.
    fn motions(&self, scene: &Scene, measure: Option<IntensityMeasure>) -> Result<StripeMotions, Refused> {
        if let (Some(measure), [folder]) = (measure, &self.folders[..]) {
            let asked = FolderUse {
                selection_factors: SelectionFactors::WithoutEffect,
                ..(&scene.record.declared()).into()
            };
            return StripeMotions::scaled(Suite::in_folder(folder, asked)?, measure, self.intensities.clone());
        }
        let read = self.intensities.iter().zip(&self.folders);
        let read = read.map(|(one, folder)| Ok((*one, suite_of(folder, scene)?)));
        StripeMotions::own(read.collect::<Result<_, Refused>>()?)
    }
}
