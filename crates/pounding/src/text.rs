//! Plain text of at most 80 columns, but for a long path: numbers, paragraphs, tables, and tables side by side. It steers no terminal, also
//! where it goes to a file.

use pounding::scene::Implausible;
use pounding::text::visible;
pub(crate) use pounding::text::{percent, short};

/// Columns of a terminal.
const WIDTH: usize = 80;
/// Columns of the words that begin a paragraph.
const LABEL: usize = 10;
/// What stands where there is no number.
pub(crate) const NONE: &str = "–";

/// Lines with a word before the first; long lines are broken between words.
pub(crate) fn paragraph(label: &str, text: &str) -> String {
    let broken: Vec<String> = visible(text).lines().flat_map(|line| broken(line, WIDTH - LABEL)).collect();
    let indent = " ".repeat(LABEL);
    format!("{label:LABEL$}{}\n", broken.join(&format!("\n{indent}")))
}

/// What looks wrong, which stands before every answer; `None` if nothing does.
pub(crate) fn unusual(found: &[Implausible]) -> Option<String> {
    let lines: Vec<String> = found.iter().map(ToString::to_string).collect();
    (!lines.is_empty()).then(|| paragraph("Unusual", &lines.join("\n")))
}

/// A line in pieces of so many letters; a longer word stays whole.
fn broken(line: &str, width: usize) -> Vec<String> {
    let length = |text: &str| text.chars().count();
    let mut pieces: Vec<String> = Vec::new();
    for word in line.split_whitespace() {
        match pieces.last_mut() {
            Some(piece) if length(piece) + 1 + length(word) <= width => {
                piece.push(' ');
                piece.push_str(word);
            }
            _ => pieces.push(word.into()),
        }
    }
    pieces
}

/// A text in pieces of so many letters; a longer word is broken, too.
fn pieces(text: &str, width: usize) -> Vec<String> {
    let cut = |piece: String| {
        let letters: Vec<char> = piece.chars().collect();
        let parts = letters.chunks(width).map(|part| part.iter().collect());
        parts.collect::<Vec<String>>()
    };
    broken(text, width).into_iter().flat_map(cut).collect()
}

/// Columns under a name of some lines: the first to the left, others to the right. A name for which the table would be too wide
/// stands in lines of its own, above its numbers.
pub(crate) fn table<const LINES: usize, Line: AsRef<str>>(header: &[[Line; LINES]], rows: &[Vec<String>]) -> String {
    let line = |line: usize| header.iter().map(|name| name[line].as_ref().to_string()).collect();
    let names: Vec<Vec<String>> = (0..LINES).map(line).collect();
    let rows = shown(rows);
    let lines: Vec<&Vec<String>> = names.iter().chain(&rows).collect();
    let width = |column: usize| {
        let widths = lines.iter().map(|line| line[column].chars().count());
        widths.max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let others: usize = widths[1..].iter().map(|width| width + 2).sum();
    let first = widths[0].min(WIDTH.saturating_sub(others).max(LABEL));
    let print = |line: &Vec<String>| {
        let others = line.iter().zip(&widths).skip(1);
        let others: Vec<String> = others.map(|(cell, width)| format!("  {cell:>width$}")).collect();
        let (above, name) = if line[0].chars().count() > first {
            let blanks = line[0].chars().take_while(|letter| *letter == ' ').count();
            let indent = " ".repeat(blanks);
            let pieces = pieces(&line[0], WIDTH - blanks);
            (format!("{indent}{}\n", pieces.join(&format!("\n{indent}"))), "")
        } else {
            (String::new(), line[0].as_str())
        };
        let line = format!("{name:first$}{}", others.concat());
        if line.trim_end().is_empty() && !above.is_empty() {
            return above;
        }
        format!("{above}{}\n", line.trim_end())
    };
    lines.into_iter().map(print).collect()
}

/// Rows whose cells steer no terminal.
fn shown(rows: &[Vec<String>]) -> Vec<Vec<String>> {
    let row = |row: &Vec<String>| row.iter().map(|cell| visible(cell).into_owned()).collect();
    rows.iter().map(row).collect()
}

/// Columns of a cell of a table side by side.
const CELL: usize = 14;

/// Rows of a name and some cells, with as many columns as there are: names to the left, cells to the right, in as many lines as
/// they need. What does not fit beside the names stands below, with the names again.
pub(crate) fn table_in_blocks(rows: &[Vec<String>]) -> String {
    let rows = shown(rows);
    let names = rows.iter().filter_map(|row| row.first());
    let names = names.map(|name| name.chars().count()).max().unwrap_or(0);
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let cell = |row: usize, column: usize| rows[row].get(column).map_or("", String::as_str);
    let width = |column: usize| {
        let cells = (0..rows.len()).map(|row| cell(row, column).chars().count());
        cells.max().unwrap_or(0).min(CELL)
    };
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    let mut used = 0;
    for column in 1..columns {
        used += 2 + width(column);
        match blocks.last_mut() {
            Some(block) if names + used <= WIDTH => block.push(column),
            _ => {
                blocks.push(vec![column]);
                used = 2 + width(column);
            }
        }
    }
    let line = |row: usize, block: &[usize]| {
        let lines_of = |column: &usize| pieces(cell(row, *column), CELL);
        let cells: Vec<Vec<String>> = block.iter().map(lines_of).collect();
        let tallest = cells.iter().map(Vec::len).max().unwrap_or(0).max(1);
        let line = |line: usize| {
            let name = if line == 0 { cell(row, 0) } else { "" };
            let cells = block.iter().zip(&cells).map(|(&column, lines)| {
                let width = width(column);
                format!("  {:>width$}", lines.get(line).map_or("", String::as_str))
            });
            let line = format!("{name:names$}{}", cells.collect::<String>());
            format!("{}\n", line.trim_end())
        };
        (0..tallest).map(line).collect::<String>()
    };
    let block = |block: &Vec<usize>| (0..rows.len()).map(|row| line(row, block)).collect();
    let blocks: Vec<String> = blocks.iter().map(block).collect();
    blocks.join("\n")
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
