//! Numbers out of range.

/// A number out of range.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{field}: found {}, allowed {allowed}", pounding_text::plain(*found))]
pub(super) struct RangeError {
    field: &'static str,
    found: f64,
    allowed: &'static str,
}

pub(super) fn require(valid: bool, field: &'static str, found: f64, allowed: &'static str) -> Result<(), RangeError> {
    if valid && found.is_finite() {
        Ok(())
    } else {
        Err(RangeError { field, found, allowed })
    }
}

pub(super) const FINITE: &str = "a finite number";
pub(super) const POSITIVE: &str = "a finite number > 0";
const ABOVE: &str = "a finite number above `from`";

/// Refuses an upper bound that is not above the lower bound.
pub(super) fn bounds(from: Option<f64>, to: Option<f64>) -> Result<(), RangeError> {
    if let Some(from) = from {
        require(true, "from", from, FINITE)?;
    }
    let Some(to) = to else { return Ok(()) };
    require(from.is_none_or(|from| to > from), "to", to, ABOVE)
}
