/// A parameter of a contact law outside its valid range.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{parameter}: found {}, allowed {allowed}", pounding_text::plain(*found))]
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

/// Refuses a stiffness that is not > 0 and finite.
pub(crate) fn require_stiffness(name: &'static str, found: f64) -> Result<(), ParameterError> {
    let valid = found > 0.0 && found.is_finite();
    require(valid, name, found, "a finite number > 0")
}

/// Refuses a damping that is not ≥ 0 and finite.
pub(crate) fn require_damping(name: &'static str, found: f64) -> Result<(), ParameterError> {
    let valid = found >= 0.0 && found.is_finite();
    require(valid, name, found, "a finite number >= 0")
}

/// Refuses an e that no damping of a compliant law delivers: it takes infinite damping to e = 0.
pub(crate) fn require_restitution(found: f64) -> Result<(), ParameterError> {
    let valid = found > 0.0 && found <= 1.0;
    require(valid, "restitution", found, "more than 0, up to 1")
}
