//! What is of the paper alone: its tables, figures, claims and printed numbers.

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

/// What each choice of the program is worth, and what all combinations of them give, by their paths in the results folder.
///
/// # Errors
/// [`StudyError`] when scenes do not give what their table shows, or the figure cannot be drawn.
pub(crate) fn files(completed: &[Completed], published: &PublishedValues, exact: Exact<'_>) -> Result<Files, StudyError> {
    let slips = slips::Slips::new(completed, exact, published.values())?;
    let mut files = slips.files()?;
    let combinations = combinations::combinations(completed, published)?;
    files.insert("paper/combinations.csv".into(), combinations.into_bytes());
    Ok(files)
}
