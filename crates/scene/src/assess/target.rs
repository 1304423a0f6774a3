//! The spectrum that records are scaled to, by its name.

use std::fmt::Display;
use std::path::Path;

use super::design::DesignSpectrum;
use crate::assess::design::DesignSpectrumError;

impl DesignSpectrum {
    /// The spectrum of a code, such as `ec8:a_g=0.25g,ground=C`, or that of a CSV file of periods in s and accelerations in g.
    ///
    /// # Errors
    /// Says of a code what is allowed, and of a file what is wrong with it.
    pub fn named(text: &str) -> Result<Self, String> {
        let is_code = ["ec8:", "asce7:"].iter().any(|code| text.starts_with(code));
        if is_code || !Path::new(text).is_file() {
            return text.parse().map_err(|error: DesignSpectrumError| error.to_string());
        }
        let unreadable = |error: &dyn Display| format!("{text}: cannot be read: {error}");
        let read = crate::bytes(text.as_ref()).map_err(|error| unreadable(&error))?;
        let read = String::from_utf8(read).map_err(|error| unreadable(&error))?;
        Self::table(&read).map_err(|error| format!("{text}: {error}"))
    }
}
