//! Lines of numbers and their shape.

use super::super::stamp::Stamp;
use super::super::time_column::TimeColumn;
use crate::Refused;
use crate::line::{Line, number};
use pounding_text::Spot;

/// Rows of numbers, at least one, possibly with blank lines and comments between them.
pub(super) struct Rows<'l, 't> {
    lines: &'l [Line<'t>],
    /// Number of rows, of the numbers in them, and of those in the first.
    pub(super) len: usize,
    pub(super) n_numbers: usize,
    pub(super) n_columns: usize,
    /// The first row with a different number of numbers.
    pub(super) other: Option<Line<'t>>,
    /// Whether numbers touch somewhere, which means that they have a fixed width.
    pub(super) touch: bool,
}

/// Index of the first line with only numbers; the lines above it are titles.
pub(super) fn first_row(lines: &[Line<'_>]) -> Option<usize> {
    lines.iter().position(|line| is_row(*line))
}

/// Whether a line has only numbers, possibly after a date and a time of day; numbers may touch.
fn is_row(line: Line<'_>) -> bool {
    let is_number = |field: &[u8]| number(field).is_some() || is_touching(field);
    let mut fields = line.fields();
    let first = match fields.next() {
        Some(first) if !line.is_comment() => first,
        _ => return false,
    };
    if is_number(first) {
        return fields.all(is_number);
    }
    stamp(first).is_some() && fields.next().is_some_and(is_number) && fields.all(is_number)
}

/// A moment at the start of a row.
pub(super) fn stamp(field: &[u8]) -> Option<Stamp> {
    // No date is printed in more letters.
    let text = field.get(..field.len().min(40))?;
    Stamp::new(std::str::from_utf8(text).ok()?)
}

/// Whether a piece is several numbers of fixed width: a sign follows a digit, and there are two points.
pub(super) fn is_touching(piece: &[u8]) -> bool {
    let of_numbers = |byte: &u8| byte.is_ascii_digit() || b"+-.EeDd".contains(byte);
    let signs = piece.windows(2);
    let mut signs = signs.filter(|pair| pair[0].is_ascii_digit() && matches!(pair[1], b'+' | b'-'));
    super::super::values::touches(piece) && piece.iter().all(of_numbers) && signs.next().is_some()
}

/// Whether a line after the last row marks the end: `*** End Data ***`, `/&`.
fn is_end(line: Line<'_>) -> bool {
    let text = line.bytes.trim_ascii();
    let word = text.split(|byte| !byte.is_ascii_alphabetic()).next();
    text.starts_with(b"***") || text == b"/&" || word.is_some_and(|word| word.eq_ignore_ascii_case(b"END"))
}

/// Whether decimal commas may have cut the numbers of a line: they are whole and in pairs, the second of each pair without a sign.
pub(in super::super) fn may_be_cut(line: Line<'_>) -> bool {
    let is_whole = |field: &[u8]| !field.is_empty() && field.iter().all(u8::is_ascii_digit);
    let mut n_fields = 0;
    let whole = line.fields().enumerate().all(|(index, field)| {
        n_fields = index + 1;
        let bare = field.strip_prefix(b"-").filter(|_| index % 2 == 0);
        is_whole(bare.unwrap_or(field))
    });
    whole && n_fields % 2 == 0 && line.bytes.contains(&b',')
}

/// The refusal of a line that decimal commas may have cut.
pub(in super::super) fn cut_by_commas(line: Line<'_>) -> Refused {
    Refused::at(Spot::Line(line.number)).reads(line.excerpt()).so(": ", "its comma may be a decimal comma, or separate two whole numbers; write decimal points, or semicolons between numbers with decimal commas")
}

fn rows_in<'t>(lines: &[Line<'t>]) -> impl Iterator<Item = Line<'t>> {
    let lines = lines.iter().copied();
    lines.filter(|line| !line.is_blank() && !line.is_comment())
}

impl<'l, 't> Rows<'l, 't> {
    /// The rows of these lines, from the first row; `None` if there are none.
    pub(super) fn new(lines: &'l [Line<'t>]) -> Option<Self> {
        let is_some = |line: &Line<'_>| !line.is_blank() && !line.is_comment() && !is_end(*line);
        let end = lines.iter().rposition(is_some)? + 1;
        let lines = &lines[..end];
        let mut rows = Self {
            lines,
            len: 0,
            n_numbers: 0,
            n_columns: 0,
            other: None,
            touch: false,
        };
        for row in rows_in(lines) {
            let n_numbers = row.fields().count();
            if rows.len == 0 {
                rows.n_columns = n_numbers;
            }
            if rows.other.is_none() && n_numbers != rows.n_columns {
                rows.other = Some(row);
            }
            rows.len += 1;
            rows.touch |= row.fields().any(is_touching);
            rows.n_numbers += n_numbers;
        }
        Some(rows)
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = Line<'t>> {
        rows_in(self.lines)
    }

    pub(super) fn first(&self) -> Line<'t> {
        self.iter().next().expect("at least one row")
    }

    pub(super) fn last(&self) -> Line<'t> {
        self.lines[self.lines.len() - 1]
    }

    /// The rows after the first ones.
    pub(super) fn behind(&self, n_rows: usize) -> Option<Self> {
        let first = self.iter().nth(n_rows)?;
        let at = self.lines.iter().position(|line| line.number == first.number)?;
        Self::new(&self.lines[at..])
    }

    /// Whether all rows have as many numbers as the first one.
    pub(super) fn is_full(&self) -> bool {
        self.other.is_none()
    }

    /// Whether only the last row has fewer numbers than the first one.
    pub(super) fn is_short(&self) -> bool {
        let last = self.last();
        let ends = self.other.is_some_and(|other| other.number == last.number);
        ends && last.fields().count() < self.n_columns
    }

    /// Whether the first numbers of three rows or more rise in equal steps; a short last row is left out.
    pub(super) fn is_time(&self) -> bool {
        let n_rows = self.len - usize::from(self.is_short());
        if n_rows < 3 {
            return false;
        }
        let mut times = TimeColumn::default();
        for row in self.iter().take(n_rows) {
            let Some(field) = row.fields().next() else {
                return false;
            };
            if times.push(row, field).is_err() {
                return false;
            }
        }
        times.is_even()
    }

    /// Whether the first numbers of the rows rise, with few exceptions.
    pub(super) fn mostly_rises(&self) -> bool {
        let mut falls = 0;
        let mut before = f64::NEG_INFINITY;
        for row in self.iter() {
            let time = row.fields().next().and_then(number).unwrap_or(f64::NAN);
            let rises = time > before;
            falls += usize::from(!rises);
            before = time;
        }
        10 * falls <= self.len
    }

    /// Refuses rows that decimal commas may cut. More than two columns are counts, unless a fraction begins with a zero.
    pub(super) fn check_commas(&self) -> Result<(), Refused> {
        let is_fraction = |field: &[u8]| field.len() > 1 && field.starts_with(b"0");
        let has_fraction = |row: Line<'t>| row.fields().skip(1).step_by(2).any(is_fraction);
        let may_be = self.iter().all(may_be_cut) && (self.n_columns == 2 || self.iter().any(has_fraction));
        if may_be {
            return Err(cut_by_commas(self.first()));
        }
        Ok(())
    }
}
