//! The spectrum that records are scaled to, by its name.

use std::path::Path;

use super::design::DesignSpectrum;
use pounding_text::Refused;

impl DesignSpectrum {
    /// The spectrum of a code, such as `ec8:a_g=0.25g,ground=C`, or that of a CSV file of periods in s and accelerations in g.
    ///
    /// # Errors
    /// Says of a code what is allowed, and of a file what is wrong with it.
    pub fn named(text: &str) -> Result<Self, Refused> {
        let is_code = ["ec8:", "asce7:"].iter().any(|code| text.starts_with(code));
        let path = Path::new(text);
        if is_code || !path.is_file() {
            return text.parse();
        }
        let unreadable = |error: std::io::Error| Refused::unreadable(path, &error);
        let read = crate::bytes(path).map_err(unreadable)?;
        let read = String::from_utf8(read).map_err(|error| unreadable(std::io::Error::other(error)))?;
        Self::table(&read).map_err(|refused| refused.in_file(path))
    }
}
