/// A parameter of a contact law outside its valid range.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{parameter}: found {found}, allowed {allowed}")]
pub struct ParameterError {
    /// Name of the parameter, as scene files spell it.
    pub parameter: &'static str,
    /// The value found.
    pub found: f64,
    /// The values allowed, in words.
    pub allowed: &'static str,
}

/// Refuses a `found` value that is not `valid`.
pub(crate) fn require(
    valid: bool,
    parameter: &'static str,
    found: f64,
    allowed: &'static str,
) -> Result<(), ParameterError> {
    if valid {
        Ok(())
    } else {
        Err(ParameterError {
            parameter,
            found,
            allowed,
        })
    }
}
