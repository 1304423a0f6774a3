//! Refusals as Python exceptions, with the program's own words.

use std::io::ErrorKind;

use pounding_text::{Refusal, RefusalKind, Refused};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// `pounding.Refused` with a message and its parts; `pounding.NotFound` if a file does not exist.
pub(crate) fn refused(py: Python<'_>, refused: Refused) -> PyErr {
    let refused = said(refused);
    let is_missing = refused.is_kind(RefusalKind::System(ErrorKind::NotFound));
    let class = if is_missing { "NotFound" } else { "Refused" };
    let made = || -> PyResult<PyErr> {
        let Refusal {
            message,
            place,
            found,
            allowed,
            help,
        } = refused.parts();
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

/// The refusal of an error. Words that Python made have no file, line or column, and a field needs no scene name.
pub(crate) fn said(error: impl Into<Refused>) -> Refused {
    let mut refused: Refused = error.into();
    let is_of_system = matches!(refused.own_kind(), RefusalKind::System(_));
    let place = refused.place_mut();
    if place.field.is_some() && place.file.is_none() {
        place.scene = None;
    }
    if !is_of_system && place.file.as_ref().is_some_and(|path| !path.exists()) {
        place.file = None;
        place.spot = None;
    }
    refused
}

/// Conversion of errors to exceptions.
pub(crate) trait OrRefused<T> {
    fn or_refused(self, py: Python<'_>) -> PyResult<T>;
}

impl<T, E: Into<Refused>> OrRefused<T> for Result<T, E> {
    fn or_refused(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|error| refused(py, error.into()))
    }
}
