//! A summary on the terminal: cell by cell if they are few, else all runs together.

use pounding::sweep::{Exceedance, SummaryTable, SummedCell, SummedColumn};
use pounding::text::{Answer, Grid, Shown, Table, Where, plain, short};

use super::fact;

/// Most rows of a kind that are printed of all runs together.
const MOST: usize = 12;
/// Cells that are printed one by one, and rows of all their tables.
const MOST_CELLS: usize = 40;
const MOST_ROWS: usize = 40;

/// The failures, the collapses, the cells, and the columns without numbers.
pub(super) fn facts(summary: &SummaryTable) -> [Option<String>; 4] {
    let collapsed = summary.n_collapsed().filter(|n| *n > 0);
    let collapsed = collapsed.map(|n| format!("{n} of {} runs end there; their numbers are those until then", summary.n_runs()));
    let failed = summary.first_failed().map(|(run, reason)| format!("run {run}: {reason}"));
    let (n_cells, by) = (summary.n_cells(), summary.by());
    let cells = match n_cells {
        0 | 1 => None,
        2..=MOST_CELLS => Some(format!("{n_cells}, by {by}")),
        _ => Some(format!(
            "{n_cells}, by {by}: one by one in the table, with their exceedances; here all together"
        )),
    };
    let without = summary.without_numbers();
    let without = (!without.is_empty()).then(|| format!("no run has {}", without.join(", ")));
    [
        fact("Failed", failed),
        fact("Collapse", collapsed),
        fact("Cells", cells),
        fact("Without", without),
    ]
}

/// Adds a few numbers of every column.
pub(super) fn tables<'a>(answer: Answer<'a>, summary: &SummaryTable) -> Answer<'a> {
    let (tables, left_out) = if (2..=MOST_CELLS).contains(&summary.n_cells()) {
        of_cells(&summary.by(), &summary.cells())
    } else {
        of_columns(&summary.whole(), summary.n_cells() < 2)
    };
    let hint = if summary.has_whole_buildings() {
        ""
    } else {
        "; `buildings` and `neighbours` in `outputs` ask for the severest of all floors and levels"
    };
    let more = (left_out > 0).then(|| format!("{left_out} more in the table{hint}"));
    let answer = tables.into_iter().fold(answer, |answer, table| {
        answer
            .say(Where::Terminal, "Number", table.number.into_iter().collect())
            .table(Where::Terminal, table.grid)
    });
    answer.say(Where::Terminal, "More", more.into_iter().collect())
}

/// A table of a summary.
struct SummedTable {
    /// The number that the table is about, if its rows are cells.
    number: Option<String>,
    grid: Grid,
}

/// Every column as a row, and every exceedance if all runs are of one cell; returns also how many rows are left out.
fn of_columns(columns: &[SummedColumn], is_one_cell: bool) -> (Vec<SummedTable>, usize) {
    let exceeded = columns.iter().filter(|_| is_one_cell);
    let exceeded = exceeded.flat_map(|column| column.exceedances.iter().map(move |one| (above(column, one), one)));
    let exceeded: Vec<_> = exceeded.collect();
    let all = columns.len() + exceeded.len();
    let named = Table::of(columns.iter().take(MOST)).shown("", |column| Shown::from(column.name.as_str()));
    let exceeded = Table::of(exceeded.into_iter().take(MOST)).shown("", |(name, _)| Shown::from(name.as_str()));
    let grids = [
        numbers(named, |column| column).grid(),
        exceedances(exceeded, |(_, one)| Some(*one)).grid(),
    ];
    let shown: usize = grids.iter().map(|grid| grid.rows.len()).sum();
    (grids.map(|grid| SummedTable { number: None, grid }).into(), all - shown)
}

/// Every cell as a row, in a table for each exceedance that is asked for, or for each column if none is; returns also how many tables are
/// left out.
fn of_cells(by: &str, cells: &[SummedCell]) -> (Vec<SummedTable>, usize) {
    let rows = || Table::of(cells).shown(by, |cell| Shown::from(cell.name.as_str()));
    let columns = 0..cells[0].columns.len();
    // A cell has no exceedance if no run of it has the number.
    let exceeded = columns.clone().flat_map(|column| {
        let mut all = cells.iter().map(|cell| &cell.columns[column].exceedances[..]);
        let known = all.find(|exceedances| !exceedances.is_empty()).unwrap_or_default();
        known.iter().enumerate().map(move |(place, one)| SummedTable {
            number: Some(above(&cells[0].columns[column], one)),
            grid: exceedances(rows(), move |cell| cell.columns[column].exceedances.get(place)).grid(),
        })
    });
    let mut tables: Vec<_> = exceeded.collect();
    if tables.is_empty() {
        let has_numbers = |column: &usize| cells.iter().any(|cell| cell.columns[*column].numbers > 0);
        let of_column = |column: usize| SummedTable {
            number: Some(cells[0].columns[column].name.clone()),
            grid: numbers(rows(), move |cell| &cell.columns[column]).grid(),
        };
        tables = columns.filter(has_numbers).map(of_column).collect();
    }
    let all = tables.len();
    tables.truncate(MOST_ROWS / cells.len());
    let left_out = all - tables.len();
    (tables, left_out)
}

/// A number and the threshold that it exceeds.
fn above(column: &SummedColumn, one: &Exceedance) -> String {
    format!("{} > {}", column.name, plain(one.threshold))
}

/// Adds statistics of the numbers of a column.
fn numbers<'a, Of: 'a>(table: Table<'a, &'a Of>, column: impl Fn(&'a Of) -> &'a SummedColumn + Copy + 'a) -> Table<'a, &'a Of> {
    let middle = |(low, high): (f64, f64)| short(0.5 * (low + high));
    table
        .shown("numbers", move |row| column(*row).numbers.to_string())
        .shown("samples", move |row| column(*row).samples.to_string())
        .shown("mean", move |row| column(*row).mean.map(short))
        .shown("deviation", move |row| column(*row).standard_deviation.map(short))
        .shown("median", move |row| column(*row).median.map(middle))
        .shown("84 %", move |row| column(*row).p84.map(middle))
        .shown("largest", move |row| column(*row).largest.map(short))
}

/// Adds the probability of an exceedance and its bounds.
fn exceedances<'a, Of: 'a>(table: Table<'a, Of>, one: impl Fn(&Of) -> Option<&'a Exceedance> + Copy + 'a) -> Table<'a, Of> {
    table
        .shown("share of runs", move |row| one(row).map(|one| short(one.probability)))
        .shown("95 % from", move |row| one(row).map(|one| short(one.bounds.0)))
        .shown("to", move |row| one(row).map(|one| short(one.bounds.1)))
}
