//! Ground motions as scenes use them.

use std::path::{Path, PathBuf};

use pounding_motion::Record as Samples;
use pounding_report::{MeasuredRecord, spectra_table};
use pounding_scene::file::record_bytes;
use pounding_scene::{Error, GroundMotion, RecordUse, SharedMotion, Source, response_spectra};
use pounding_text::{Naming, Refused, json_text};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde_json::json;

use crate::array::Array;
use crate::refused::OrRefused;
use crate::table::Table;
use crate::waiting::wait;

/// The raw form of a ground motion, which is read again for each other use.
#[derive(Debug, Clone, PartialEq)]
enum Raw {
    File { path: PathBuf, bytes: Vec<u8> },
    Samples(Samples),
    Formula,
}

/// A ground motion with its source, used as the table `record` of a scene says.
#[pyclass(frozen, module = "pounding._pounding")]
#[derive(Debug)]
pub(crate) struct Record {
    words: String,
    raw: Raw,
    pub(crate) motion: SharedMotion,
}

/// Name of the text that holds the words; no message shows it.
const WORDS: &str = "record.json";

impl Record {
    fn new(raw: Raw, words: String) -> Result<Self, Error> {
        let mut record: RecordUse = pounding_scene::file::parse(words.as_bytes(), WORDS.as_ref())?;
        if let Source::File(file) = &mut record.source {
            file.naming = Naming::Argument;
        }
        let motion = match (&raw, &record.source) {
            (Raw::File { path, bytes }, _) => GroundMotion::of_bytes(&record, path, bytes, "record")?,
            (Raw::Samples(samples), _) => GroundMotion::of_record(&record, samples.clone())?,
            (Raw::Formula, Source::Generated(generated)) => GroundMotion::of_formula(&record, generated)?,
            (Raw::Formula, Source::File(_)) => GroundMotion::of(&record, Path::new(""), "record")?,
        };
        Ok(Self {
            words,
            raw,
            motion: motion.into(),
        })
    }

    fn samples(&self) -> &Samples {
        self.motion.record()
    }
}

#[pymethods]
impl Record {
    /// Reads a file. `raw` is its content if the file need not be opened. `words` is the table `record` as JSON.
    #[staticmethod]
    #[pyo3(signature = (path, words, raw=None))]
    fn of_file(py: Python<'_>, path: PathBuf, words: String, raw: Option<&[u8]>) -> PyResult<Self> {
        wait(py, None, move |_| {
            let read = match raw {
                Some(raw) => Ok(raw.to_vec()),
                None => record_bytes(&path),
            };
            let bytes = read.map_err(|error| Refused::unreadable(&path, &error))?;
            Self::new(Raw::File { path, bytes }, words)
        })?
        .or_refused(py)
    }

    /// Takes samples in m/s² as the bytes of 64-bit numbers, `time_step` s apart.
    #[staticmethod]
    fn of_samples(py: Python<'_>, samples: &Bound<'_, PyBytes>, time_step: f64, words: String) -> PyResult<Self> {
        let numbers = samples.as_bytes().chunks_exact(8);
        let number = |bytes: &[u8]| f64::from_ne_bytes(bytes.try_into().unwrap_or_default());
        let samples = Samples::new(time_step, numbers.map(number).collect(), "an array");
        let samples = samples.or_refused(py)?;
        Self::new(Raw::Samples(samples), words).or_refused(py)
    }

    /// Makes a motion from the formula that `words` name.
    #[staticmethod]
    fn of_formula(py: Python<'_>, words: String) -> PyResult<Self> {
        Self::new(Raw::Formula, words).or_refused(py)
    }

    /// The motion used in another way.
    fn used(&self, py: Python<'_>, words: String) -> PyResult<Self> {
        let raw = self.raw.clone();
        wait(py, None, move |_| Self::new(raw, words))?.or_refused(py)
    }

    /// The table `record` as JSON.
    #[getter]
    fn words(&self) -> &str {
        &self.words
    }

    /// Kind of the source: `file`, `samples` or `formula`.
    #[getter]
    fn kind(&self) -> &'static str {
        match self.raw {
            Raw::File { .. } => "file",
            Raw::Samples(_) => "samples",
            Raw::Formula => "formula",
        }
    }

    /// The file; `None` for another kind of source.
    #[getter]
    fn path(&self) -> Option<PathBuf> {
        match &self.raw {
            Raw::File { path, .. } => Some(path.clone()),
            Raw::Samples(_) | Raw::Formula => None,
        }
    }

    /// The bytes of the file, or of the given samples; empty for a formula.
    #[getter]
    fn raw<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        match &self.raw {
            Raw::File { bytes, .. } => PyBytes::new(py, bytes),
            Raw::Samples(samples) => {
                let samples = samples.samples().iter();
                let bytes: Vec<u8> = samples.flat_map(|one| one.to_ne_bytes()).collect();
                PyBytes::new(py, &bytes)
            }
            Raw::Formula => PyBytes::new(py, &[]),
        }
    }

    /// Time between the given samples [s]; `None` for a source other than `samples`.
    #[getter]
    fn raw_time_step(&self) -> Option<f64> {
        match &self.raw {
            Raw::Samples(samples) => Some(samples.time_step()),
            Raw::File { .. } | Raw::Formula => None,
        }
    }

    /// Ground acceleration as used [m/s²].
    #[getter]
    fn acceleration(&self) -> Array {
        Array::motion(&self.motion)
    }

    /// Time between two samples as used [s].
    #[getter]
    fn time_step(&self) -> f64 {
        self.samples().time_step()
    }

    /// Time of the last sample [s].
    #[getter]
    fn duration(&self) -> f64 {
        self.samples().duration()
    }

    /// Factor on the values of the source [–].
    #[getter]
    fn scale_factor(&self) -> f64 {
        self.motion.scale()
    }

    /// Location and contents of the record, measures, unit and format, as JSON.
    fn facts(&self) -> String {
        let origin = self.motion.origin.as_deref();
        let mut facts = MeasuredRecord::of(self.samples()).json(origin);
        facts["source"] = json!(self.samples().source());
        facts["component"] = json!(origin.and_then(|origin| origin.file.component()));
        json_text(&facts)
    }

    /// Response spectra at some periods [s] for some damping ratios [–], one row per combination.
    fn spectrum(&self, py: Python<'_>, periods: Vec<f64>, damping_ratios: Vec<f64>) -> PyResult<Table> {
        let of = (periods.len() * damping_ratios.len()) as u64;
        let spectra = wait(py, None, |watch| {
            let (stop, done) = (Some(watch.stop), || watch.step(1, of));
            response_spectra(self.samples(), &periods, &damping_ratios, stop, &done)
        })?
        .or_refused(py)?;
        Ok(Table::of_found(&spectra_table(&spectra)))
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.words == other.words && self.raw == other.raw
    }
}
