//! The bumper of the command line.

use pounding::text::digits;

/// Which bumper is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum BumperAsked {
    /// No bumper.
    None,
    /// With the stiffness that `Bumper::proposed` chooses.
    Proposed,
    /// With this stiffness at each floor \[N/m\].
    Stiffness(f64),
}

/// Units of a stiffness, the longest first: each ends as the last one does.
const UNITS: [(&str, f64); 3] = [("MN/m", 1e6), ("kN/m", 1e3), ("N/m", 1.0)];

/// The words of the command line: `k=80MN/m`, `proposed` or `none`.
pub(super) fn asked(text: &str) -> Result<BumperAsked, String> {
    const ALLOWED: &str = "allowed are k=80MN/m (or kN/m, N/m), proposed and none";
    match text {
        "none" => return Ok(BumperAsked::None),
        "proposed" => return Ok(BumperAsked::Proposed),
        _ => {}
    }
    let value = text.strip_prefix("k=").ok_or(ALLOWED)?.trim();
    let unit = UNITS.iter().find_map(|(unit, factor)| Some((value.strip_suffix(unit)?, factor)));
    match unit {
        Some((number, factor)) => super::super::positive(number.trim())
            .map(|number| BumperAsked::Stiffness(factor * number))
            .map_err(|_| ALLOWED.into()),
        None => Err(format!("{value} has no unit that is known; {ALLOWED}")),
    }
}

impl BumperAsked {
    /// How to ask for it again; `None` if nothing needs to be said.
    pub(super) fn words(self) -> Option<String> {
        match self {
            Self::None => None,
            Self::Proposed => Some("--bumper proposed".into()),
            Self::Stiffness(stiffness) => Some(format!("--bumper k={}N/m", digits(stiffness))),
        }
    }
}
