//! Numbers out of range.

use pounding_text::{Refused, plain};

pub(super) fn require(valid: bool, field: &'static str, found: f64, allowed: &'static str) -> Result<(), Refused> {
    if valid && found.is_finite() {
        Ok(())
    } else {
        Err(Refused::at(field).found(plain(found)).allowed(allowed))
    }
}

pub(super) const FINITE: &str = "a finite number";
pub(super) const POSITIVE: &str = "a finite number > 0";
const ABOVE: &str = "a finite number above `from`";

/// Refuses bounds of which the upper one is not above the lower one.
pub(super) fn bounds(from: Option<f64>, to: Option<f64>) -> Result<(), Refused> {
    if let Some(from) = from {
        require(true, "from", from, FINITE)?;
    }
    let Some(to) = to else { return Ok(()) };
    require(from.is_none_or(|from| to > from), "to", to, ABOVE)
}
