//! Refusals as Python exceptions, with the program's own words.

use std::io::ErrorKind;

use pounding_scene::Error;
use pounding_text::Refusal;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// `pounding.Refused` with a message and its parts.
pub(crate) fn refused(py: Python<'_>, message: &str) -> PyErr {
    of_class(py, "Refused", message)
}

fn of_class(py: Python<'_>, class: &str, message: &str) -> PyErr {
    let message = pounding_text::message(message);
    let made = || -> PyResult<PyErr> {
        let Refusal {
            message,
            place,
            found,
            allowed,
            help,
        } = message.as_ref().into();
        let parts = PyDict::new(py);
        parts.set_item("place", place)?;
        parts.set_item("found", found)?;
        parts.set_item("allowed", allowed)?;
        parts.set_item("help", help)?;
        let class = py.import("pounding._errors")?.getattr(class)?;
        Ok(PyErr::from_value(class.call((message,), Some(&parts))?))
    };
    made().unwrap_or_else(|error| error)
}

/// What is said of an error: of words that Python made there is no line and no column.
pub(crate) fn said(error: &Error) -> String {
    if let Error::Form { path, place, fault, .. } = error
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
        self.map_err(|error| {
            let class = if is_missing(&error) { "NotFound" } else { "Refused" };
            of_class(py, class, &said(&error))
        })
    }
}

/// Whether it is of a file that is not there.
fn is_missing(error: &Error) -> bool {
    if let Error::InFile { source, .. } = error {
        return is_missing(source);
    }
    matches!(
        error,
        Error::Unreadable { source, .. } | Error::NoRecord { source, .. } if source.kind() == ErrorKind::NotFound
    )
}

impl<T> OrRefused<T> for Result<T, String> {
    fn or_refused(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|message| refused(py, &message))
    }
}
