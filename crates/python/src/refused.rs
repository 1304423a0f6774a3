//! Refusals as Python exceptions, with the program's own words.

use pounding_scene::Error;
use pounding_text::Refusal;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// `pounding.Refused` with a message and its parts.
pub(crate) fn refused(py: Python<'_>, message: &str) -> PyErr {
    let made = || -> PyResult<PyErr> {
        let Refusal {
            message,
            place,
            found,
            allowed,
            help,
        } = message.into();
        let parts = PyDict::new(py);
        parts.set_item("place", place)?;
        parts.set_item("found", found)?;
        parts.set_item("allowed", allowed)?;
        parts.set_item("help", help)?;
        let class = py.import("pounding._errors")?.getattr("Refused")?;
        Ok(PyErr::from_value(class.call((message,), Some(&parts))?))
    };
    made().unwrap_or_else(|error| error)
}

/// What is said of an error: of words that Python made there is no line and no column.
pub(crate) fn said(error: &Error) -> String {
    if let Error::Form {
        path, place, fault, ..
    } = error
        && !path.is_file()
    {
        return place
            .as_ref()
            .map_or_else(|| fault.to_string(), |place| format!("{place}: {fault}"));
    }
    if let Error::Scene { source, .. } = error {
        return source.to_string();
    }
    error.to_string()
}

/// An error as an exception.
pub(crate) trait OrRefused<T> {
    fn or_refused(self, py: Python<'_>) -> PyResult<T>;
}

impl<T> OrRefused<T> for Result<T, Error> {
    fn or_refused(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|error| refused(py, &said(&error)))
    }
}

impl<T> OrRefused<T> for Result<T, String> {
    fn or_refused(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|message| refused(py, &message))
    }
}
