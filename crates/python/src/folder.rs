//! A row under all records of a folder.

use std::path::{Path, PathBuf};

use pounding_assess::{AssessedRun, DesignSpectrum, MotionLines, Rule, Scaling, Suite, Watched};
use pounding_report::{AssessmentReport, GapsUnderMotion, OfFolder, ScalingAsked, gaps_table};
use pounding_scene::file::ScaleTo;
use pounding_scene::{Error, Floors, Method, Scene};
use pounding_text::{Form, Refused};
use pyo3::prelude::*;

use crate::refused::OrRefused;
use crate::run::Given;
use crate::table::Table;
use crate::waiting::{Watch, wait};

/// An assessment of a row under a folder of records.
#[pyclass(frozen, module = "pounding._pounding")]
pub(crate) struct Assessment {
    report: AssessmentReport,
}

/// Both directions of shaking: the values of `reversed`.
const BOTH: [bool; 2] = [false, true];

/// Assesses a row under a folder of records, in both directions, by the exact method. `scale` is `scene`, `none` or a `scale_to` table as
/// JSON. `target` is the name or the file of a spectrum.
#[pyfunction]
#[pyo3(signature = (text, path, folder, scale, target=None, stiffness=None, code=None, progress=None))]
pub(crate) fn assess(
    py: Python<'_>,
    text: &str,
    path: PathBuf,
    folder: PathBuf,
    scale: &str,
    target: Option<&str>,
    stiffness: Option<[f64; 2]>,
    code: Option<&str>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Assessment> {
    let [from, to] = stiffness.unwrap_or([1.0; 2]);
    if !(from > 0.0 && from <= 1.0 && to >= 1.0 && to.is_finite()) {
        let found = Refused::at("stiffness").found(format!("{from} and {to}"));
        return Err(found.allowed_are("two factors with 1 between them")).or_refused(py);
    }
    let scaling = scaling(scale, target).or_refused(py)?;
    let known = |word| Rule::of_code(word).map_err(|said| Refused::at("code").found(format!("`{word}`, {said}")));
    let code = code.map(known).transpose().or_refused(py)?;
    let given = Given::of(text, path, None);
    let found = wait(py, progress, |watch| -> Result<Assessment, Refused> {
        let scene = Scene {
            method: Method::EXACT,
            ..given.scene()?.seeking_gaps()
        };
        Floors::check(&scene).map_err(|error| given.in_file(error))?;
        let range = stiffness.unwrap_or_else(|| AssessedRun::stiffness_range(&scene));
        let mut suite = suite_of(&folder, &scene)?;
        let scaling = scaling.raised(&scene, &mut suite, None);
        let lines = MotionLines::of(
            &suite,
            &BOTH,
            watched(watch, &|of| watch.step(1, of as u64)),
            |motion| scaling.applied(&scene, motion),
            |prepared, spectrum| Ok((AssessedRun::of(prepared, None, [range[0], 1.0, range[1]])?, spectrum.clone())),
        )?;
        let report = AssessmentReport::of_lines(scene, &suite, &lines.lines)?;
        let report = report.ok_or("stopped")?.with_stiffness(range);
        let report = report.with_code(code.or_else(|| scaling.code()));
        let report = report.with_scaling(ScalingAsked {
            to: scaling.clone(),
            words: None,
        });
        Ok(Assessment { report })
    })?;
    found.or_refused(py)
}

/// Reads the records of a folder; the scene declares what their files do not say.
pub(crate) fn suite_of(folder: &Path, scene: &Scene) -> Result<Suite, Refused> {
    Ok(Suite::in_folder(folder, &scene.record.declared())?)
}

pub(crate) fn watched<'a>(watch: &Watch, step: &'a (dyn Fn(usize) + Sync)) -> Watched<'a> {
    Watched { stop: watch.stop, step }
}

/// The scaling of the records.
fn scaling(scale: &str, target: Option<&str>) -> Result<Scaling, Refused> {
    match (target, scale) {
        (Some(target), _) => Ok(Scaling::Target(DesignSpectrum::named(target)?.into())),
        (None, "scene") => Ok(Scaling::AsScene),
        (None, "none") => Ok(Scaling::Unscaled),
        (None, table) => {
            let to = pounding_scene::file::parse::<ScaleTo>(table.as_bytes(), "scale.json".as_ref())?;
            Ok(Scaling::To(to))
        }
    }
}

#[pymethods]
impl Assessment {
    /// All results, as the JSON of `pounding assess --json`.
    fn facts(&self) -> String {
        self.report.answer().text(Form::Json)
    }

    /// The table of `pounding assess --csv`, one row per number.
    fn csv(&self) -> String {
        self.report.answer().text(Form::Csv)
    }

    /// Implausible values of the scene and of its records.
    fn unusual(&self) -> Vec<String> {
        let unusual = self.report.unusual();
        unusual.iter().map(ToString::to_string).collect()
    }

    /// Whether the gaps are enough, in sentences.
    fn answers(&self) -> Vec<String> {
        self.report.answers()
    }

    /// The whole answer: the gaps, the proposals and the effects of touching.
    fn sentences(&self) -> Vec<String> {
        self.report.sentences()
    }

    /// The motions in a few lines.
    fn shaking(&self) -> Vec<String> {
        self.report.shaking()
    }

    /// Remarks on records that are left out, or whose direction is unknown.
    fn remarks(&self) -> Vec<String> {
        self.report.remarks().to_vec()
    }

    /// Warnings about the results, and how much stronger all records were made to reach their target.
    fn warnings(&self) -> Vec<String> {
        self.report.raised().into_iter().chain(self.report.warnings()).collect()
    }

    /// The files of a report, by name.
    fn files(&self, py: Python<'_>) -> std::collections::BTreeMap<String, Vec<u8>> {
        py.detach(|| self.report.files())
    }
}

/// The gaps that a row needs under a folder of records, in both directions, one row per motion, direction and gap. Returns also the
/// implausible values, and the remarks on records that are left out or whose direction is unknown.
#[pyfunction]
#[pyo3(signature = (text, path, folder, progress=None))]
pub(crate) fn required_gap(
    py: Python<'_>,
    text: &str,
    path: PathBuf,
    folder: PathBuf,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(Table, Vec<String>)> {
    let given = Given::of(text, path, None);
    let found = wait(py, progress, |watch| -> Result<_, Refused> {
        let scene = given.scene()?;
        let apart = scene.apart();
        Floors::check(&apart).map_err(|error| given.in_file(error))?;
        let suite = suite_of(&folder, &scene)?;
        let lines = MotionLines::of(
            &suite,
            &BOTH,
            watched(watch, &|of| watch.step(1, of as u64)),
            |_| Ok::<_, Error>((apart.clone(), ())),
            |prepared, ()| GapsUnderMotion::of(prepared),
        )?;
        let folder = OfFolder {
            scene: &scene,
            suite: &suite,
            lines: &lines.lines,
        };
        let unusual = folder.unusual().iter().map(ToString::to_string).collect();
        let said = [unusual, folder.warnings(), folder.records(true)].concat();
        Ok((Table::of_found(&gaps_table(&folder)), said))
    })?;
    found.or_refused(py)
}
