//! The answer about a table that was joined.

use std::path::Path;

use pounding::sweep::{Joined, summary_beside};
use pounding::text::{Answer, Form, Refused, Where};

use super::summed;
use crate::commands::Failure;

/// Returns the answer as text, with sentences about the table.
///
/// # Errors
/// Says that every run failed; the text is printed nevertheless.
pub(in crate::commands) fn of_table(answer: Answer<'_>, joined: &Joined, out: &Path) -> Result<String, Failure> {
    let failed = match joined.failed {
        0 => "none failed".into(),
        failed if joined.has_rows => format!("{failed} failed: the last column says why"),
        failed => format!("{failed} failed"),
    };
    let rows = if joined.has_rows { "rows" } else { "runs summed up" };
    let text = format!("{}: {} {rows}, {failed}", out.display(), joined.runs);
    let mut answer = answer.say(Where::Terminal, "Results", vec![text]);
    if let Some(summary) = &joined.summary {
        let beside = joined.has_rows.then(|| summary_beside(out).display().to_string());
        answer = summed::parts(answer.say(Where::Terminal, "Summary", beside.into_iter().collect()), summary);
    }
    let printed = answer.text(Form::Brief);
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
