//! What is said of a table that was joined.

use std::path::Path;

use pounding::sweep::{Joined, summary_beside};
use pounding::text::Refused;

use super::summed;
use crate::commands::Failure;
use crate::text::paragraph;

/// What is printed of a table. Of one without any result it is a failure.
pub(in crate::commands) fn answer(printed: String, joined: &Joined) -> Result<String, Failure> {
    if joined.failed < joined.runs || joined.runs == 0 {
        return Ok(printed);
    }
    let why = if joined.has_rows {
        "the last column says why"
    } else {
        "the summary says why the first of them did"
    };
    let refused = Refused::that(format!("all {} runs failed: {why}", joined.runs));
    Err(Failure { printed, refused })
}

/// What is said of a table.
pub(in crate::commands) fn result(joined: &Joined, out: &Path) -> String {
    let failed = match joined.failed {
        0 => "none failed".into(),
        failed if joined.has_rows => format!("{failed} failed: the last column says why"),
        failed => format!("{failed} failed"),
    };
    let rows = if joined.has_rows { "rows" } else { "runs summed up" };
    let text = format!("{}: {} {rows}, {failed}", out.display(), joined.runs);
    let mut said = paragraph("Results", &text);
    if let Some(summary) = &joined.summary {
        if joined.has_rows {
            said += &paragraph("Summary", &summary_beside(out).display().to_string());
        }
        said += &summed::told(summary);
    }
    said
}
