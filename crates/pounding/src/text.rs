//! Plain text of at most 80 columns, but for a long path: numbers, paragraphs, tables, and tables side by side. It steers no terminal, also
//! where it goes to a file.

use pounding::scene::Implausible;
use pounding::text::visible;
pub(crate) use pounding::text::{NONE, cut, paragraph, percent, short};

/// Columns of a terminal.
const WIDTH: usize = 80;
/// Columns of the words that begin a paragraph.
const LABEL: usize = 10;
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
