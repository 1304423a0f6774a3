//! Questions about a scene beyond one run.

use std::path::PathBuf;

use pounding_assess::Effects;
use pounding_contact::{Calibration, LawName};
use pounding_report::{OpenSees, OpenSeesError, Sketch, advice_answer, certificate};
use pounding_scene::{
    Certificate, CertificateRequest, Error, Floors, FreeCollision, Goal, Method, QuantityGroup, Scene, SharedMotion, Simulation, StepMethod,
};
use pounding_text::{Form, Refused, json_text};
use pyo3::prelude::*;
use serde_json::Value;

use crate::record::Record;
use crate::refused::OrRefused;
use crate::run::Given;
use crate::waiting::wait;

/// Text for people, in which letters that steer a terminal or the direction of writing are spelt.
#[pyfunction]
pub(crate) fn visible(text: &str) -> String {
    pounding_text::visible(text).into_owned()
}

/// The text of a JSON or TOML file, read within the bounds of the program.
#[pyfunction]
pub(crate) fn read_words(py: Python<'_>, path: PathBuf) -> PyResult<String> {
    let read = || -> Result<Vec<u8>, Error> { Ok(pounding_scene::file::bytes(&path).map_err(|error| Refused::unreadable(&path, &error))?) };
    let bytes = py.detach(read).or_refused(py)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let found = Refused::at(path.as_path()).found(format!("byte {at} that is no UTF-8"));
        found.allowed_is("text in UTF-8").help("save the file as such")
    });
    text.or_refused(py)
}

/// Converts a JSON or TOML text to JSON without checking its contents.
#[pyfunction]
pub(crate) fn words_of(py: Python<'_>, text: &str, path: PathBuf) -> PyResult<String> {
    let words = pounding_scene::file::parse::<Value>(text.as_bytes(), &path);
    Ok(words.or_refused(py)?.to_string())
}

/// Reads and checks a scene under any record. Returns its words with all defaults, as JSON.
#[pyfunction]
pub(crate) fn check_scene(py: Python<'_>, text: &str, path: PathBuf) -> PyResult<String> {
    let given = Given::of(text, path, None);
    let check = || -> Result<String, Error> {
        let scene = given.scene()?;
        let exact = Scene {
            method: Method::EXACT,
            duration_s: None,
            // A row whose floors face columns can be asked for its gaps.
            seeks_gaps: scene.contacts.is_some(),
            ..scene.clone()
        };
        Simulation::shaken(&exact, at_rest()).map_err(|error| given.in_file(error))?;
        Ok(json_text(&scene))
    };
    check().or_refused(py)
}

/// A ground at rest, for checks of scenes.
fn at_rest() -> SharedMotion {
    let record = pounding_motion::Record::new(1.0, vec![0.0; 2], "at rest");
    pounding_scene::GroundMotion {
        record: record.expect("two samples a second apart"),
        scale: 1.0,
        origin: None,
    }
    .into()
}

/// The row of a scene as SVG.
#[pyfunction]
pub(crate) fn sketch_scene(py: Python<'_>, text: &str, path: PathBuf) -> PyResult<String> {
    let scene = Given::of(text, path, None).scene().or_refused(py)?;
    let seeks_gaps = scene.contacts.is_some();
    let scene = Scene { seeks_gaps, ..scene };
    let floors = Floors::of(&scene).map_err(|refused| Error::in_scene(&scene.name, refused));
    let sketch = Sketch {
        scene: &scene,
        floors: &floors.or_refused(py)?,
        touched: &[],
    };
    sketch.svg().map_err(|error| error.to_string()).or_refused(py)
}

/// Effects of pounding on every storey, in both directions of shaking, as JSON.
#[pyfunction]
#[pyo3(signature = (text, path, record=None))]
pub(crate) fn effects(py: Python<'_>, text: &str, path: PathBuf, record: Option<&Record>) -> PyResult<String> {
    let given = Given::of(text, path, record);
    let found = wait(py, None, |watch| -> Result<String, Error> {
        let effects = Effects::of(&given.simulation(watch)?);
        Ok(json_text(&effects.map_err(|error| given.in_file(error))?))
    })?;
    found.or_refused(py)
}

/// Periods from `first` to `last` [s], rising by a constant ratio.
#[pyfunction]
pub(crate) fn periods_between(first: f64, last: f64, count: u32) -> Vec<f64> {
    pounding_scene::periods_between(first, last, count)
}

/// The cheapest method and time step for an accuracy, as the JSON of `pounding advise --json`.
#[pyfunction]
#[pyo3(signature = (text, path, error, quantity, record=None, progress=None))]
pub(crate) fn advise(
    py: Python<'_>,
    text: &str,
    path: PathBuf,
    error: f64,
    quantity: &str,
    record: Option<&Record>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let known = QuantityGroup::EVERY.into_iter();
    let names = QuantityGroup::EVERY.map(QuantityGroup::name).join("`, `");
    let found = known.clone().find(|group| group.name() == quantity);
    let quantity = found.ok_or_else(|| unknown("quantity", quantity, &names));
    let quantity = quantity.or_refused(py)?;
    if !(error > 0.0 && error < 1.0) {
        let found = Refused::at("error").found(error.to_string());
        return Err(found.allowed_is("more than 0 and less than 1")).or_refused(py);
    }
    let given = Given::of(text, path, record);
    let found = wait(py, progress, |watch| -> Result<String, Error> {
        let scene = Scene {
            method: Method::EXACT,
            ..given.scene()?
        };
        let simulation = given.simulation_of(&scene, watch)?;
        let goal = Goal { error, quantity };
        let advice = pounding_scene::Advice::of(&simulation, goal, &|of| watch.step(1, of as u64));
        let advice = advice.map_err(|error| given.in_file(error))?;
        Ok(advice_answer(&simulation, &advice, String::new()).text(Form::Json))
    })?;
    found.or_refused(py)
}

/// Restitution that a contact law and the methods deliver in a free impact, as the JSON of `pounding certify --json`.
#[pyfunction]
#[pyo3(signature = (law, restitution, masses, speed, stiffness=None, literature=false, time_step=None, method=None))]
pub(crate) fn certify(
    py: Python<'_>,
    law: &str,
    restitution: f64,
    masses: [f64; 2],
    speed: f64,
    stiffness: Option<f64>,
    literature: bool,
    time_step: Option<f64>,
    method: Option<&str>,
) -> PyResult<String> {
    let names = LawName::ALL.map(LawName::name).join("`, `");
    let named = LawName::from_name(law);
    let law = named.ok_or_else(|| unknown("law", law, &names));
    let law = law.or_refused(py)?;
    let method = method.map(|method| {
        let names: Vec<_> = StepMethod::all().map(StepMethod::name).collect();
        let named = StepMethod::all().find(|one| one.name() == method);
        named.ok_or_else(|| unknown("method", method, &names.join("`, `")))
    });
    let method = method.transpose().or_refused(py)?;
    for (name, number) in [("masses[0]", masses[0]), ("masses[1]", masses[1]), ("speed", speed)] {
        if !(number > 0.0 && number.is_finite()) {
            let found = Refused::at(name).found(number.to_string());
            return Err(found.allowed_is("a finite number > 0")).or_refused(py);
        }
    }
    let wanted = CertificateRequest {
        law,
        stiffness: stiffness.unwrap_or_else(|| Certificate::usual_stiffness(law)),
        restitution,
        calibration: if literature { Calibration::Literature } else { Calibration::Exact },
    };
    let collision = FreeCollision { masses, speed };
    let found = wait(py, None, |_| -> Result<String, Refused> {
        Ok(certificate(&wanted, &collision, time_step, method)?.text(Form::Json))
    })?;
    found.or_refused(py)
}

/// The contact laws, each with its name, its force and the unit of its stiffness.
#[pyfunction]
pub(crate) fn laws() -> Vec<(&'static str, &'static str, &'static str)> {
    let law = |law: &LawName| {
        let unit = law.stiffness_unit().unwrap_or("");
        (law.name(), law.about().force, unit)
    };
    LawName::ALL.iter().map(law).collect()
}

/// The scene as a script for OpenSeesPy.
#[pyfunction]
#[pyo3(signature = (text, path, record=None, time_step=None, approximate=false))]
pub(crate) fn opensees(
    py: Python<'_>,
    text: &str,
    path: PathBuf,
    record: Option<&Record>,
    time_step: Option<f64>,
    approximate: bool,
) -> PyResult<String> {
    let given = Given::of(text, path, record);
    let asked = OpenSees { time_step, approximate };
    let found = wait(py, None, |watch| -> Result<String, Refused> {
        let scene = Scene {
            method: Method::EXACT,
            ..given.scene()?
        };
        let simulation = given.simulation_of(&scene, watch)?;
        asked.script(&simulation).map_err(|error| match error {
            OpenSeesError::NotModelled(what) => what.into(),
            OpenSeesError::Run(error) => given.in_file(error).into(),
        })
    })?;
    found.or_refused(py)
}

/// The refusal of a word that is not among the allowed ones.
fn unknown(place: &'static str, found: &str, names: &str) -> Refused {
    Refused::at(place).found(format!("`{found}`")).allowed_are(format!("`{names}`"))
}
