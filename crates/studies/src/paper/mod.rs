//! The paper's own tables, figures, claims and printed numbers.

pub(crate) mod agreement;
pub(crate) mod claims;
mod combinations;
pub(crate) mod converged;
pub(crate) mod figures;
pub(crate) mod printed;
mod slips;
pub(crate) mod tables;

use crate::files::Files;
use crate::{Completed, PublishedValues, StudyError};
use converged::Exact;

/// Files by path in the results folder: the effect of each choice of the paper's program, and of all their combinations.
///
/// # Errors
/// [`StudyError`] if scenes do not give the contents of their table, or if the figure cannot be drawn.
pub(crate) fn files(completed: &[Completed], published: &PublishedValues, exact: Exact<'_>) -> Result<Files, StudyError> {
    let slips = slips::Slips::new(completed, exact, published.values())?;
    let mut files = slips.files()?;
    let combinations = combinations::combinations(completed, published)?;
    files.insert("paper/combinations.csv".into(), combinations.into_bytes());
    Ok(files)
}
