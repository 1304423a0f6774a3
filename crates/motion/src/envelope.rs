//! How the strength of a generated motion comes and goes.

use crate::RecordError;
use crate::record::within;

/// A factor on a stationary motion, from 0 to 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Envelope {
    /// The factor 1 throughout: stationary shaking that begins and ends abruptly.
    Constant,
    /// Rises like t², stays, and dies away exponentially (P. C. Jennings, G. W. Housner and N. C. Tsai, *Simulated
    /// earthquake motions*, Caltech 1968, where the four types A to D differ in these numbers).
    Jennings {
        /// When the strong shaking begins \[s\], > 0.
        strong_from: f64,
        /// When it ends \[s\], not before it begins.
        strong_until: f64,
        /// Rate at which it dies away \[1/s\], > 0.
        decay: f64,
    },
}

impl Envelope {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`RecordError`] names the setting, what was found and what is allowed.
    pub fn check(&self) -> Result<(), RecordError> {
        let Self::Jennings {
            strong_from,
            strong_until,
            decay,
        } = *self
        else {
            return Ok(());
        };
        let valid = strong_from > 0.0;
        within("envelope.strong_from", strong_from, valid, "a number > 0 s")?;
        let (valid, allowed) = (strong_until >= strong_from, "at least strong_from");
        within("envelope.strong_until", strong_until, valid, allowed)?;
        within("envelope.decay", decay, decay > 0.0, "a number > 0 1/s")
    }

    /// Returns the factor \[–\] at a time \[s\], ≥ 0.
    pub fn at(&self, time: f64) -> f64 {
        match *self {
            Self::Constant => 1.0,
            Self::Jennings { strong_from, .. } if time < strong_from => {
                (time / strong_from) * (time / strong_from)
            }
            Self::Jennings {
                strong_until,
                decay,
                ..
            } => libm::exp(-decay * (time - strong_until).max(0.0)),
        }
    }
}
