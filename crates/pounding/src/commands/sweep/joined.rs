//! What is said of a table that was joined, and of its summary.

use std::path::Path;

use pounding::sweep::{Exceedance, Joined, SummaryTable, SummedColumn, summary_beside};

use crate::commands::Failure;
use crate::text::{NONE, paragraph, short, table};

/// Columns that are printed of a summary, and exceedances.
const MOST: usize = 12;

/// Columns of what is printed of every column of a summary, and of its exceedances.
const NUMBERS: [[&str; 1]; 7] = [
    [""],
    ["numbers"],
    ["mean"],
    ["deviation"],
    ["median"],
    ["84 %"],
    ["largest"],
];
const EXCEEDANCES: [[&str; 1]; 5] = [[""], ["above"], ["probability"], ["from"], ["to"]];

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
    let message = format!("all {} runs failed: {why}", joined.runs);
    Err(Failure { printed, message })
}

/// What is said of a table.
pub(in crate::commands) fn result(joined: &Joined, out: &Path) -> String {
    let failed = match joined.failed {
        0 => "none failed".into(),
        failed if joined.has_rows => format!("{failed} failed: the last column says why"),
        failed => format!("{failed} failed"),
    };
    let rows = if joined.has_rows {
        "rows"
    } else {
        "runs summed up"
    };
    let text = format!("{}: {} {rows}, {failed}", out.display(), joined.runs);
    let mut said = paragraph("Results", &text);
    if let Some(summary) = &joined.summary {
        if joined.has_rows {
            said += &paragraph("Summary", &summary_beside(out).display().to_string());
        }
        said += &told(summary);
    }
    said
}

/// A few numbers of every column.
fn told(summary: &SummaryTable) -> String {
    let mut said = Vec::new();
    let reasons = summary.first_failed();
    let reasons: Vec<String> = reasons
        .map(|(run, reason)| format!("run {run}: {reason}"))
        .collect();
    if !reasons.is_empty() {
        said.push(paragraph("Failed", &reasons.join("\n")));
    }
    if summary.n_cells() > 1 {
        let text = format!(
            "{}, in the table one by one, here all together",
            summary.n_cells()
        );
        said.push(paragraph("Cells", &text));
    }
    let columns = summary.whole();
    let rows: Vec<Vec<String>> = columns.iter().take(MOST).map(row).collect();
    said.extend(["\n".into(), table(&NUMBERS, &rows)]);
    let exceedances: Vec<Vec<String>> = columns.iter().flat_map(exceedances).take(MOST).collect();
    if !exceedances.is_empty() {
        said.extend(["\n".into(), table(&EXCEEDANCES, &exceedances)]);
    }
    if columns.len() > MOST {
        let more = columns.len() - MOST;
        said.push(format!("\nand {more} more columns in the table\n"));
    }
    said.concat()
}

fn row(column: &SummedColumn) -> Vec<String> {
    let number = |number: Option<f64>| number.map_or_else(|| NONE.into(), short);
    let middle = |bounds: Option<(f64, f64)>| number(bounds.map(|(low, high)| 0.5 * (low + high)));
    vec![
        column.name.clone(),
        column.numbers.to_string(),
        number(column.mean),
        number(column.standard_deviation),
        middle(column.median),
        middle(column.p84),
        number(column.largest),
    ]
}

fn exceedances(column: &SummedColumn) -> Vec<Vec<String>> {
    let row = |one: &Exceedance| {
        let mut row = vec![column.name.clone()];
        let (from, to) = one.bounds;
        row.extend([one.threshold, one.probability, from, to].map(short));
        row
    };
    column.exceedances.iter().map(row).collect()
}
