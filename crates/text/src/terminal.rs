//! Plain text of at most 80 columns; only a long path is longer. It has no letters that steer a terminal, also if it goes to a file.

use crate::{Grid, Shown, visible};

/// Columns of a terminal.
const WIDTH: usize = 80;
/// Columns of the words that begin a paragraph.
const LABEL: usize = 10;
/// Lines of a heading without its unit.
const HEADING_LINES: usize = 2;
/// Most columns of a cell of a table in blocks.
const BLOCK_CELL: usize = 14;

/// Lines under a word, which precedes the first one; long lines are broken between words.
pub fn paragraph(label: &str, text: &str) -> String {
    behind(label, LABEL, text)
}

/// Facts of the form `name: value`, the values below each other.
pub(crate) fn facts(lines: &[String]) -> String {
    let facts: Vec<(&str, &str)> = lines.iter().map(|line| line.split_once(": ").unwrap_or(("", line))).collect();
    let widest = facts.iter().map(|(name, _)| length(name) + 2).max().unwrap_or(0);
    let fact = |(name, value): &(&str, &str)| behind(&visible(name), widest.max(LABEL), value);
    facts.iter().map(fact).collect()
}

/// Lines that begin in a column, under a word that precedes the first one.
fn behind(label: &str, column: usize, text: &str) -> String {
    let broken: Vec<String> = visible(text).lines().flat_map(|line| broken(line, WIDTH - column)).collect();
    let indent = " ".repeat(column);
    format!("{label:column$}{}\n", broken.join(&format!("\n{indent}")))
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// The words of a text; a percent sign stays with its number.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match words.last_mut() {
            Some(number) if word.starts_with('%') => {
                number.push(' ');
                number.push_str(word);
            }
            _ => words.push(word.into()),
        }
    }
    words
}

fn longest_word(text: &str) -> usize {
    words(text).iter().map(|word| length(word.as_str())).max().unwrap_or(0)
}

/// Breaks a line between words into pieces of at most `width` letters; a longer word stays whole.
fn broken(line: &str, width: usize) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    for word in words(line) {
        match pieces.last_mut() {
            Some(piece) if length(piece) + 1 + length(&word) <= width => {
                piece.push(' ');
                piece.push_str(&word);
            }
            _ => pieces.push(word),
        }
    }
    pieces
}

/// Breaks a text into pieces of at most `width` letters, also within a longer word.
fn pieces(text: &str, width: usize) -> Vec<String> {
    let cut = |piece: String| {
        let letters: Vec<char> = piece.chars().collect();
        let parts = letters.chunks(width).map(|part| part.iter().collect());
        parts.collect::<Vec<String>>()
    };
    broken(text, width).into_iter().flat_map(cut).collect()
}

/// Shortens a text to `width` letters with an ellipsis in its middle, because names often differ at their ends.
pub fn cut(text: &str, width: usize) -> String {
    let letters: Vec<char> = text.chars().collect();
    if letters.len() <= width {
        return text.into();
    }
    let end = (width - 1) / 2;
    let begin = width - 1 - end;
    let (begin, end) = (&letters[..begin], &letters[letters.len() - end..]);
    begin.iter().chain(['…'].iter()).chain(end).collect()
}

impl Grid {
    /// The table in plain text; without `details` the rows of the first screen.
    pub fn terminal(&self, details: bool) -> String {
        let most = if details { self.rows.len() } else { self.most.min(self.rows.len()) };
        let rows: Vec<Vec<String>> = self.rows[..most].iter().flat_map(|row| lines_of(row)).collect();
        let table = if self.is_in_blocks {
            let headings = self.headings.iter().map(crate::Heading::title).collect();
            in_blocks(&[vec![headings], rows].concat())
        } else {
            in_lines(&self.heading_lines(&rows), &rows)
        };
        match self.rows.len() - most {
            0 => table,
            left => format!("{table}and {left} more: --details\n"),
        }
    }

    /// The headings in as many lines as they need, the units below them, for columns as narrow as their cells allow.
    fn heading_lines(&self, rows: &[Vec<String>]) -> Vec<Vec<String>> {
        let column = |column: usize| {
            let heading = &self.headings[column];
            let cells = rows.iter().map(|row| length(&row[column])).max().unwrap_or(0);
            let least = cells
                .min(WIDTH / 2)
                .max(longest_word(&heading.text))
                .max(length(&heading.bracketed()));
            let mut widths = (least..).map(|width| broken(&heading.text, width));
            let mut lines = widths.find(|lines| lines.len() <= HEADING_LINES).unwrap_or_default();
            lines.extend((!heading.unit.is_empty()).then(|| heading.bracketed()));
            lines
        };
        let columns: Vec<Vec<String>> = (0..self.headings.len()).map(column).collect();
        let tallest = columns.iter().map(Vec::len).max().unwrap_or(0);
        let line = |line: usize| columns.iter().map(|lines| lines.get(line).cloned().unwrap_or_default()).collect();
        (0..tallest).map(line).collect()
    }
}

/// The texts of a row, and if there are any the texts below them.
fn lines_of(row: &[Shown]) -> Vec<Vec<String>> {
    let texts = row.iter().map(|cell| cell.text.clone()).collect();
    let below = row.iter().enumerate().map(|(column, cell)| {
        let below = cell.below.clone().unwrap_or_default();
        if column == 0 { format!("  {below}") } else { below }
    });
    let has_below = row.iter().any(|cell| cell.below.is_some());
    std::iter::once(texts).chain(has_below.then(|| below.collect())).collect()
}

/// Columns, the first to the left, the others to the right. If they are too wide, they stand closer, names stand in separate lines above their
/// numbers, and long texts are broken between words.
fn in_lines(names: &[Vec<String>], rows: &[Vec<String>]) -> String {
    let lines: Vec<&Vec<String>> = names.iter().chain(rows).collect();
    let n_columns = lines.first().map_or(0, |line| line.len());
    let width = |column: usize| lines.iter().map(|line| length(&line[column])).max().unwrap_or(0);
    let mut widths: Vec<usize> = (0..n_columns).map(width).collect();
    let Some((names, numbers)) = widths.split_first() else {
        return String::new();
    };
    let numbers: usize = numbers.iter().sum();
    let between = if names.min(&LABEL) + numbers + 2 * (n_columns - 1) > WIDTH {
        1
    } else {
        2
    };
    let numbers = numbers + between * (n_columns - 1);
    let first = (*names).min(WIDTH.saturating_sub(numbers).max(LABEL));
    let words = |column: usize| lines.iter().map(|line| longest_word(&line[column])).max().unwrap_or(0);
    let mut excess = (first + numbers).saturating_sub(WIDTH);
    while excess > 0 {
        let least = |column: usize| words(column).max(BLOCK_CELL);
        let breakable = (1..n_columns).filter(|column| least(*column) < widths[*column]);
        let Some(column) = breakable.max_by_key(|column| widths[*column]) else {
            break;
        };
        let narrow = widths[column].saturating_sub(excess).max(least(column));
        excess -= widths[column] - narrow;
        widths[column] = narrow;
    }
    widths[0] = first;
    lines.into_iter().map(|line| printed(line, &widths, between)).collect()
}

/// A row of a table, in as many lines as its cells need in columns of these widths, with blanks between them.
fn printed(row: &[String], widths: &[usize], between: usize) -> String {
    let cells = row.iter().zip(widths).skip(1).map(|(cell, width)| {
        let is_broken = length(cell) > *width;
        if is_broken { broken(cell, *width) } else { vec![cell.clone()] }
    });
    let cells: Vec<Vec<String>> = cells.collect();
    let first = widths[0];
    let (above, name) = if length(&row[0]) > first {
        let blanks = row[0].chars().take_while(|letter| *letter == ' ').count();
        let indent = " ".repeat(blanks);
        let pieces = pieces(&row[0], WIDTH - blanks);
        (format!("{indent}{}\n", pieces.join(&format!("\n{indent}"))), "")
    } else {
        (String::new(), row[0].as_str())
    };
    let tallest = cells.iter().map(Vec::len).max().unwrap_or(1);
    let line = |line: usize| {
        let name = if line == 0 { name } else { "" };
        let cells = cells.iter().zip(&widths[1..]).map(|(lines, width)| {
            let width = width + between;
            format!("{:>width$}", lines.get(line).map_or("", String::as_str))
        });
        let text = format!("{name:first$}{}", cells.collect::<String>());
        format!("{}\n", text.trim_end())
    };
    let lines: String = (0..tallest).map(line).collect();
    if lines.trim().is_empty() && !above.is_empty() {
        return above;
    }
    format!("{above}{lines}")
}

/// Names to the left, and beside them as many columns as there is room for, their cells in as many lines as they need. The other columns
/// stand below, with the names again.
fn in_blocks(rows: &[Vec<String>]) -> String {
    let names = rows.iter().map(|row| length(&row[0])).max().unwrap_or(0);
    let n_columns = rows.first().map_or(0, Vec::len);
    let width = |column: usize| {
        let cells = rows.iter().map(|row| length(&row[column]));
        cells.max().unwrap_or(0).min(BLOCK_CELL)
    };
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    let mut used = 0;
    for column in 1..n_columns {
        used += 2 + width(column);
        match blocks.last_mut() {
            Some(block) if names + used <= WIDTH => block.push(column),
            _ => {
                blocks.push(vec![column]);
                used = 2 + width(column);
            }
        }
    }
    let line = |row: &Vec<String>, block: &[usize]| {
        let cells: Vec<Vec<String>> = block.iter().map(|column| pieces(&row[*column], BLOCK_CELL)).collect();
        let tallest = cells.iter().map(Vec::len).max().unwrap_or(0).max(1);
        let line = |line: usize| {
            let name = if line == 0 { row[0].as_str() } else { "" };
            let cells = block.iter().zip(&cells).map(|(&column, lines)| {
                let width = width(column);
                format!("  {:>width$}", lines.get(line).map_or("", String::as_str))
            });
            let line = format!("{name:names$}{}", cells.collect::<String>());
            format!("{}\n", line.trim_end())
        };
        (0..tallest).map(line).collect::<String>()
    };
    let block = |block: &Vec<usize>| rows.iter().map(|row| line(row, block)).collect();
    let blocks: Vec<String> = blocks.iter().map(block).collect();
    blocks.join("\n")
}

#[cfg(test)]
mod tests {
    use crate::{Grid, Shown};

    fn grid(names: &[&str]) -> Grid {
        let headings = [("Pair", ""), ("Largest impulse", "kN·s"), ("Collisions", "")];
        let impulse = || Shown::from("12.3").over(Some("0.2 %".into()));
        let row = |name: &&str| vec![Shown::from(*name).over(Some("error".into())), impulse(), "3".into()];
        Grid::of(headings, names.iter().map(row).collect())
    }

    #[test]
    fn reference_headings_are_as_narrow_as_their_words() {
        insta::assert_snapshot!(grid(&["left – right", "right – wall"]).most(1).terminal(false), @r"
        Pair          Largest  Collisions
                      impulse
                       [kN·s]
        left – right     12.3           3
          error         0.2 %
        and 1 more: --details
        ");
    }

    /// Parameters of a contact law made a table wider than a terminal.
    #[test]
    fn issue_a_long_text_is_broken_between_words() {
        let headings = [("Contact", ""), ("Gap", "mm"), ("Parameters", "")];
        let text = "impact_damping_ratio = 0.3500, impact_stiffness_n_per_m1_5 = 2.750e9, and a third = 1";
        let table = Grid::of(headings, vec![vec!["weak – stiff".into(), "30 ".into(), text.into()]]);
        insta::assert_snapshot!(table.terminal(true), @r"
        Contact     Gap                                                       Parameters
                   [mm]
        weak – stiff
                    30      impact_damping_ratio = 0.3500, impact_stiffness_n_per_m1_5 =
                                                                2.750e9, and a third = 1
        ");
    }

    /// A long name made a table wider than a terminal.
    #[test]
    fn issue_a_long_name_stands_above_its_numbers() {
        let long = "a name of a building ".repeat(6);
        let text = grid(&[&long, "b"]).terminal(true);
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    }
}
