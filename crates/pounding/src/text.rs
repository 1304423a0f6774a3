//! Plain text of at most 80 columns, but for a long path: numbers, paragraphs and tables.

pub(crate) use pounding::studies::{milliseconds, percent, short};

/// Columns of a terminal.
const WIDTH: usize = 80;
/// Columns of the words that begin a paragraph.
const LABEL: usize = 10;
/// What stands where there is no number.
pub(crate) const NONE: &str = "–";

/// Lines with a word before the first; long lines are broken between words.
pub(crate) fn paragraph(label: &str, text: &str) -> String {
    let broken: Vec<String> = text.lines().flat_map(broken).collect();
    let indent = " ".repeat(LABEL);
    format!("{label:LABEL$}{}\n", broken.join(&format!("\n{indent}")))
}

/// A line in pieces that fit beside a label; a longer word stays whole.
fn broken(line: &str) -> Vec<String> {
    let length = |text: &str| text.chars().count();
    let mut pieces: Vec<String> = Vec::new();
    for word in line.split_whitespace() {
        match pieces.last_mut() {
            Some(piece) if LABEL + length(piece) + 1 + length(word) <= WIDTH => {
                piece.push(' ');
                piece.push_str(word);
            }
            _ => pieces.push(word.into()),
        }
    }
    pieces
}

/// Columns under a name of some lines: the first to the left and cut where the table would be too wide, others to
/// the right.
pub(crate) fn table<const N: usize, const LINES: usize>(
    header: &[[&str; LINES]; N],
    rows: &[Vec<String>],
) -> String {
    let line = |line: usize| header.map(|name| name[line].to_string()).to_vec();
    let header: Vec<_> = (0..LINES).map(line).collect();
    let lines: Vec<&Vec<String>> = header.iter().chain(rows).collect();
    let width = |column: usize| {
        let widths = lines.iter().map(|line| line[column].chars().count());
        widths.max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..N).map(width).collect();
    let others: usize = widths[1..].iter().map(|width| width + 2).sum();
    let first = widths[0].min(WIDTH.saturating_sub(others).max(LABEL));
    let print = |line: &Vec<String>| {
        let others = line.iter().zip(&widths).skip(1);
        let others: Vec<String> = others
            .map(|(cell, width)| format!("  {cell:>width$}"))
            .collect();
        let line = format!("{:first$}{}", cut(&line[0], first), others.concat());
        format!("{}\n", line.trim_end())
    };
    lines.into_iter().map(print).collect()
}

/// Columns of a cell of a wide table.
const CELL: usize = 14;

/// Rows of a name and some cells, with as many columns as there are: names to the left, cells to the right, cut.
pub(crate) fn wide_table(rows: &[Vec<String>]) -> String {
    let cut_cells = |row: &Vec<String>| {
        let cells = row.iter().enumerate();
        let cells = cells.map(|(column, cell)| {
            if column == 0 {
                cell.clone()
            } else {
                cut(cell, CELL)
            }
        });
        cells.collect::<Vec<_>>()
    };
    let rows: Vec<_> = rows.iter().map(cut_cells).collect();
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).skip(1);
        let cells: Vec<String> = cells
            .map(|(cell, width)| format!("  {cell:>width$}"))
            .collect();
        let first = widths[0];
        format!("{:first$}{}\n", row[0], cells.concat())
    };
    rows.iter().map(line).collect()
}

/// The text, or its beginning and its end with an ellipsis between: names often differ at their ends.
pub(crate) fn cut(text: &str, width: usize) -> String {
    let letters: Vec<char> = text.chars().collect();
    if letters.len() <= width {
        return text.into();
    }
    let end = (width - 1) / 2;
    let begin = width - 1 - end;
    let (begin, end) = (&letters[..begin], &letters[letters.len() - end..]);
    begin.iter().chain(['…'].iter()).chain(end).collect()
}
