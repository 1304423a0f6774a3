//! The answer about a table that was joined.

use std::path::Path;

use pounding::sweep::{Joined, summary_beside};
use pounding::text::{Form, Refused};

use super::{answer, fact, summed};

/// What the column `checked` says.
const CHECKED: &str = "what held a row to mechanics: `ledger`, its own energy and momentum; `beside`, a run side by side with others; `both`, \
                       such a run and another one alone";

use crate::commands::Failure;

/// Returns facts as text, with those about the table.
///
/// # Errors
/// Says that every run failed; the text is printed nevertheless.
pub(in crate::commands) fn of_table(mut facts: Vec<Option<String>>, joined: &Joined, out: &Path) -> Result<String, Failure> {
    let failed = match joined.failed {
        0 => "none failed".into(),
        failed if joined.has_rows => format!("{failed} failed: the last column says why"),
        failed => format!("{failed} failed"),
    };
    let rows = if joined.has_rows { "rows" } else { "runs summed up" };
    let text = format!("{}: {} {rows}, {failed}", out.display(), joined.runs);
    facts.push(fact("Results", [text]));
    facts.push(fact("Checked", joined.has_rows.then(|| CHECKED.into())));
    let printed = match &joined.summary {
        None => answer(facts),
        Some(summary) => {
            let beside = joined.has_rows.then(|| summary_beside(out).display().to_string());
            facts.push(fact("Summary", beside));
            facts.extend(summed::facts(summary));
            summed::tables(answer(facts), summary)
        }
    };
    let printed = printed.text(Form::Brief);
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
