//! A summary on the terminal: cell by cell where they are few, else all runs together.

use pounding::sweep::{Exceedance, SummaryTable, SummedCell, SummedColumn};
use pounding::text::plain;

use crate::text::{NONE, paragraph, short, table};

/// Most rows of a kind that are printed of all runs together.
const MOST: usize = 12;
/// Cells that are printed one by one, and rows of all their blocks.
const MOST_CELLS: usize = 40;
const MOST_ROWS: usize = 40;

/// Names of the numbers of a column, and of an exceedance.
const NUMBERS: [&str; 6] = ["numbers", "mean", "deviation", "median", "84 %", "largest"];
const EXCEEDANCE: [&str; 3] = ["probability", "from", "to"];

/// A few numbers of every column.
pub(super) fn told(summary: &SummaryTable) -> String {
    let mut said = Vec::new();
    let reasons = summary.first_failed();
    let reasons: Vec<String> = reasons.map(|(run, reason)| format!("run {run}: {reason}")).collect();
    if !reasons.is_empty() {
        said.push(paragraph("Failed", &reasons.join("\n")));
    }
    let (n_cells, by) = (summary.n_cells(), summary.by());
    let cells = match n_cells {
        0 | 1 => String::new(),
        2..=MOST_CELLS => paragraph("Cells", &format!("{n_cells}, by {by}")),
        _ => {
            let text = format!("{n_cells}, by {by}: one by one in the table, with their exceedances; here all together");
            paragraph("Cells", &text)
        }
    };
    said.push(cells);
    let without = summary.without_numbers();
    if !without.is_empty() {
        let text = format!("no run has {}", without.join(", "));
        said.push(paragraph("Without", &text));
    }
    let (blocks, left_out) = if (2..=MOST_CELLS).contains(&n_cells) {
        of_cells(&by, &summary.cells())
    } else {
        of_columns(&summary.whole(), n_cells < 2)
    };
    said.extend(blocks.iter().map(Block::text));
    if left_out > 0 {
        let hint = if summary.has_whole_buildings() {
            ""
        } else {
            "; `buildings` and `neighbours` in `outputs` ask for the severest of all floors and levels"
        };
        let text = format!("{left_out} more in the table{hint}");
        said.extend(["\n".into(), paragraph("More", &text)]);
    }
    said.concat()
}

/// Rows of numbers under their names.
struct Block<'a> {
    title: String,
    /// What the rows differ in.
    first: &'a str,
    names: &'static [&'static str],
    rows: Vec<Vec<String>>,
}

impl Block<'_> {
    fn text(&self) -> String {
        let names = [&[self.first], self.names].concat();
        let header: Vec<_> = names.into_iter().map(|name| [name]).collect();
        let title = match self.title.as_str() {
            "" => String::new(),
            title => format!("{title}\n"),
        };
        format!("\n{title}{}", table(&header, &self.rows))
    }
}

/// Every column as a row, and every exceedance of runs that are of one cell; how many rows are left out.
fn of_columns(columns: &[SummedColumn], is_one_cell: bool) -> (Vec<Block<'static>>, usize) {
    let numbers = columns.iter().map(|one| row(&one.name, numbers(one)));
    let exceeded = columns.iter().filter(|_| is_one_cell);
    let exceedances = exceeded.flat_map(|column| {
        let all = column.exceedances.iter();
        all.map(|one| row(&above(column, one), exceedance(Some(one))))
    });
    let (numbers, exceedances): (Vec<_>, Vec<_>) = (numbers.collect(), exceedances.collect());
    let all = numbers.len() + exceedances.len();
    let blocks = [(&NUMBERS[..], numbers), (&EXCEEDANCE, exceedances)].map(|(names, rows)| Block {
        title: String::new(),
        first: "",
        names,
        rows: rows.into_iter().take(MOST).collect(),
    });
    let blocks = blocks.into_iter().filter(|block| !block.rows.is_empty());
    let blocks: Vec<_> = blocks.collect();
    let shown: usize = blocks.iter().map(|block| block.rows.len()).sum();
    (blocks, all - shown)
}

/// Every cell as a row, in a block for each exceedance that is asked for, or for each column where none is; how many blocks are left
/// out.
fn of_cells<'a>(by: &'a str, cells: &[SummedCell]) -> (Vec<Block<'a>>, usize) {
    let columns = 0..cells[0].columns.len();
    // No run of a cell may have the number: then it has no exceedance.
    let exceeded = columns.clone().flat_map(|column| {
        let mut all = cells.iter().map(|cell| &cell.columns[column]);
        let known = all.find(|column| !column.exceedances.is_empty());
        let known = known.map_or(&[][..], |column| &column.exceedances);
        let places = known.iter().enumerate();
        places.map(move |(place, one)| {
            let of = |cell: &SummedCell| exceedance(cell.columns[column].exceedances.get(place));
            Block {
                title: above(&cells[0].columns[column], one),
                first: by,
                names: &EXCEEDANCE,
                rows: cells.iter().map(|cell| row(&cell.name, of(cell))).collect(),
            }
        })
    });
    let mut blocks: Vec<_> = exceeded.collect();
    if blocks.is_empty() {
        let has_numbers = |column: &usize| cells.iter().any(|cell| cell.columns[*column].numbers > 0);
        let columns = columns.filter(has_numbers).map(|column| {
            let of = |cell: &SummedCell| row(&cell.name, numbers(&cell.columns[column]));
            Block {
                title: cells[0].columns[column].name.clone(),
                first: by,
                names: &NUMBERS,
                rows: cells.iter().map(of).collect(),
            }
        });
        blocks = columns.collect();
    }
    let all = blocks.len();
    blocks.truncate(MOST_ROWS / cells.len());
    let left_out = all - blocks.len();
    (blocks, left_out)
}

fn row(name: &str, numbers: Vec<String>) -> Vec<String> {
    let name = vec![name.to_owned()];
    [name, numbers].concat()
}

/// What is above a threshold.
fn above(column: &SummedColumn, one: &Exceedance) -> String {
    format!("{} > {}", column.name, plain(one.threshold))
}

fn numbers(column: &SummedColumn) -> Vec<String> {
    let number = |number: Option<f64>| number.map_or_else(|| NONE.into(), short);
    let middle = |bounds: Option<(f64, f64)>| number(bounds.map(|(low, high)| 0.5 * (low + high)));
    vec![
        column.numbers.to_string(),
        number(column.mean),
        number(column.standard_deviation),
        middle(column.median),
        middle(column.p84),
        number(column.largest),
    ]
}

fn exceedance(one: Option<&Exceedance>) -> Vec<String> {
    match one {
        Some(one) => [one.probability, one.bounds.0, one.bounds.1].map(short).into(),
        None => vec![NONE.into(); EXCEEDANCE.len()],
    }
}
