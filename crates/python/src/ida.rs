//! How often a row is pounded, from records of several intensities and a hazard curve.

use std::collections::BTreeMap;
use std::path::PathBuf;

use pounding_assess::{AskedMeasure, FolderUse, MotionLines, SelectionFactors, Suite, Watched};
use pounding_report::{JudgedRun, RiskAsked, RiskReport};
use pounding_risk::{HazardCurve, State};
use pounding_scene::{Floors, Scene};
use pounding_sweep::{Directions, StripeMotions, StripesAsked};
use pounding_text::{Form, Refused};
use pyo3::prelude::*;

use crate::folder::suite_of;
use crate::refused::OrRefused;
use crate::run::Given;
use crate::waiting::wait;

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
    let states = states.map_err(|refused| refused.in_field("states")).or_refused(py)?;
    let im: Option<AskedMeasure> = im.map(str::parse).transpose().or_refused(py)?;
    let hazard = hazard.map(HazardCurve::parse).transpose().or_refused(py)?;
    let given = Given::of(text, path, None);
    let found = wait(py, progress, |watch| -> Result<Ida, Refused> {
        let scene = given.scene()?;
        let any_record = Scene {
            duration_s: None,
            ..scene.clone()
        };
        Floors::check(&any_record).map_err(|error| given.in_file(error))?;
        let measure = im.map(|im| im.of_row(&scene)).transpose()?;
        let motions = match (measure, &folders[..]) {
            (Some(measure), [folder]) => {
                let asked = FolderUse {
                    selection_factors: SelectionFactors::WithoutEffect,
                    ..(&scene.record.declared()).into()
                };
                StripeMotions::scaled(Suite::in_folder(folder, asked)?, measure, intensities)?
            }
            _ => {
                let read = intensities.iter().zip(&folders).map(|(one, folder)| Ok((*one, suite_of(folder, &scene)?)));
                StripeMotions::own(read.collect::<Result<_, Refused>>()?)?
            }
        };
        let asked = StripesAsked {
            scene: &scene,
            path: &given.path,
            motions: &motions,
            directions: if both { Directions::Both } else { Directions::AsGiven },
            states: &states,
            closings: !gaps.is_empty(),
        };
        let step = |of: usize| watch.step(1, of as u64);
        let watched = Watched {
            stop: watch.stop,
            step: &step,
        };
        let runs = asked.run(watched)?;
        let questions = RiskAsked {
            states: &states,
            gaps: &gaps,
            hazard: hazard.as_ref(),
            measure,
        };
        let report = RiskReport::of(&scene, motions.suites(), &runs, questions);
        let (stripe, apart) = (report.judged_stripe(), states.iter().all(|state| matches!(state, State::Touch(_))));
        let judged = MotionLines::of(
            motions.suite_at(stripe),
            if both { &[false, true] } else { &[false] },
            Watched {
                stop: watch.stop,
                step: &|_| (),
            },
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
    })?;
    found.or_refused(py)
}
