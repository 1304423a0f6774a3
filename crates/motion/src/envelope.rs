//! The strength of a generated motion over time.

use crate::Refused;
use crate::record::within;

/// A factor on a stationary motion, from 0 to 1. It rises like t², stays constant, and decays exponentially.
///
/// Source: P. C. Jennings, G. W. Housner and N. C. Tsai, *Simulated earthquake motions*, Caltech 1968. Their types A to D differ in these
/// numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelope {
    /// Start of the strong shaking \[s\], > 0.
    pub strong_from: f64,
    /// End of the strong shaking \[s\], not before its start.
    pub strong_until: f64,
    /// Rate of the decay \[1/s\], > 0.
    pub decay: f64,
}

impl Envelope {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`Refused`] with the setting, the value found and the values allowed.
    pub fn check(&self) -> Result<(), Refused> {
        let (from, until) = (self.strong_from, self.strong_until);
        within("envelope.strong_from", from, from > 0.0, "a number > 0 s")?;
        let allowed = "a time not before the one at which the strong shaking begins";
        within("envelope.strong_until", until, until >= from, allowed)?;
        let decay = self.decay;
        within("envelope.decay", decay, decay > 0.0, "a number > 0 1/s")
    }

    /// Returns the factor \[–\] at a time \[s\], ≥ 0.
    pub fn at(&self, time: f64) -> f64 {
        if time < self.strong_from {
            (time / self.strong_from) * (time / self.strong_from)
        } else {
            libm::exp(-self.decay * (time - self.strong_until).max(0.0))
        }
    }
}
