//! Tables and JSON as all crates write them: no number in them is NaN or infinite.
//!
//! A number that does not exist is an empty cell or `null`. A sweep writes millions of rows without these cells, by its own code with this
//! rule.

use std::borrow::Cow;

use serde::Serialize;

use crate::{digits, visible};

/// A cell of a table: a text, or a number that is finite.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Cell(String);

impl Cell {
    /// A number in the caller's format; empty if there is no number or if it is not finite.
    pub fn number(value: impl Into<Option<f64>>, format: impl FnOnce(f64) -> String) -> Self {
        let value = value.into().filter(|value| value.is_finite());
        Self(value.map_or_else(String::new, format))
    }

    /// A number in the shortest digits that give it back; empty if there is no number or if it is not finite.
    pub fn exact(value: impl Into<Option<f64>>) -> Self {
        Self::number(value, |value| {
            let plain = value.to_string();
            if plain.len() <= LONGEST { plain } else { format!("{value:e}") }
        })
    }

    /// A number that is already text, in a table of texts; empty if it is not finite.
    fn written(text: &str) -> Self {
        let is_none = ["NaN", "inf", "-inf"].contains(&text);
        if is_none { Self::default() } else { text.into() }
    }
}

/// Longest number that is written without an exponent \[letters\].
const LONGEST: usize = 24;

/// A text for tables. A text that a spreadsheet would take for a formula gets an apostrophe in front, unless it is a number. Letters that
/// steer a terminal are spelt as by [`visible`].
pub fn harmless(text: &str) -> Cow<'_, str> {
    let shown = visible(text);
    let begins = shown.starts_with(['=', '+', '-', '@', '\t']);
    if begins && shown.parse::<f64>().is_err() {
        format!("'{shown}").into()
    } else {
        shown
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        text.as_str().into()
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self(harmless(text).into_owned())
    }
}

impl From<bool> for Cell {
    fn from(truth: bool) -> Self {
        Self(truth.to_string())
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Self {
        Self(count.to_string())
    }
}

impl From<u64> for Cell {
    fn from(count: u64) -> Self {
        Self(count.to_string())
    }
}

impl From<f64> for Cell {
    /// A number with seven significant digits; an empty cell if it is not finite.
    fn from(value: f64) -> Self {
        Self::number(value, digits)
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    /// An empty cell if there is no value.
    fn from(value: Option<T>) -> Self {
        value.map_or_else(Self::default, Into::into)
    }
}

/// A column of a table: its name, and a function that takes its cell from a row. Header and cells therefore always match.
struct TableColumn<'a, Row> {
    name: Cow<'static, str>,
    cell: Box<dyn Fn(&Row) -> Cell + 'a>,
}

/// A table: rows, and columns that take their cells from them.
///
/// ```
/// use pounding_text::{Cell, Table, short};
///
/// let gaps = [("left", 0.03, None), ("right", 0.05, Some(3_usize))];
/// let table = Table::of(gaps)
///     .column("pair", |(name, ..)| *name)
///     .column("gap_mm", |(_, gap, _)| 1e3 * gap)
///     .column("gap_m", |(_, gap, _)| Cell::number(*gap, short))
///     .column("collisions", |(.., count)| *count);
/// assert_eq!(table.csv(), "pair,gap_mm,gap_m,collisions\nleft,30,0.03000,\nright,50,0.05000,3\n");
/// ```
pub struct Table<'a, Row> {
    rows: Vec<Row>,
    columns: Vec<TableColumn<'a, Row>>,
}

impl<Row> std::fmt::Debug for Table<'_, Row> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let names: Vec<_> = self.columns.iter().map(|column| &column.name).collect();
        f.debug_struct("Table").field("columns", &names).finish_non_exhaustive()
    }
}

impl<'a, Row> Table<'a, Row> {
    /// A table without columns.
    pub fn of(rows: impl IntoIterator<Item = Row>) -> Self {
        Self {
            rows: rows.into_iter().collect(),
            columns: Vec::new(),
        }
    }

    /// Adds a column whose cells `cell` takes from the rows. Numbers get seven significant digits, unless `cell` returns [`Cell::number`].
    #[must_use]
    pub fn column<C: Into<Cell>>(mut self, name: impl Into<Cow<'static, str>>, cell: impl Fn(&Row) -> C + 'a) -> Self {
        self.columns.push(TableColumn {
            name: name.into(),
            cell: Box::new(move |row| cell(row).into()),
        });
        self
    }

    /// Adds one column per key; `name` and `cell` get the key.
    #[must_use]
    pub fn columns<Key: Copy + 'a, C: Into<Cell>>(
        self,
        keys: impl IntoIterator<Item = Key>,
        name: impl Fn(Key) -> String,
        cell: impl Fn(&Row, Key) -> C + Copy + 'a,
    ) -> Self {
        let keys = keys.into_iter();
        keys.fold(self, |table, key| table.column(name(key), move |row| cell(row, key)))
    }

    /// The table as CSV: a line with the names of the columns, and a line per row.
    pub fn csv(&self) -> String {
        let header: Vec<&str> = self.columns.iter().map(|column| &*column.name).collect();
        let cells = |row| self.columns.iter().map(move |column| (column.cell)(row));
        csv_text(&header, self.rows.iter().map(cells))
    }
}

/// A table as CSV, from the names of its columns and its rows.
///
/// # Panics
/// Panics if a row is not as long as the header.
pub fn csv_text<Name: AsRef<str>>(header: &[Name], rows: impl IntoIterator<Item: IntoIterator<Item = Cell>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = header.iter().map(|name| harmless(name.as_ref()).into_owned());
    writer.write_record(names).expect("memory takes all");
    for row in rows {
        let cells = row.into_iter().map(|cell| cell.0);
        writer
            .write_record(cells)
            .expect("rows are as long as the header, and memory takes them");
    }
    let bytes = writer.into_inner().expect("memory takes all");
    String::from_utf8(bytes).expect("cells are text")
}

/// A table of texts as CSV. Texts that read as `inf` or `NaN` become empty cells.
///
/// # Panics
/// Panics if a row is not as long as the header.
pub fn to_csv(header: &[String], rows: &[Vec<String>]) -> String {
    let cells = |row: &Vec<String>| row.iter().map(|text| Cell::written(text)).collect();
    csv_text(header, rows.iter().map(cells).collect::<Vec<Vec<_>>>())
}

/// JSON for files and answers, with a line break at its end. A number that is not finite is `null`. Letters that JSON allows but that steer
/// a terminal are escaped.
///
/// # Panics
/// Panics if a value has no JSON form, for example a map whose keys are not texts.
pub fn json_text<T: Serialize + ?Sized>(value: &T) -> String {
    let mut text = serde_json::to_string_pretty(value).expect("plain data is JSON");
    text.push('\n');
    match visible(&text) {
        Cow::Owned(escaped) => escaped,
        Cow::Borrowed(_) => text,
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Texts that table readers take for numbers.
    fn numbers(table: &str) -> Vec<f64> {
        let cells = table.lines().skip(1).flat_map(|line| line.split(','));
        cells.filter_map(|cell| cell.parse().ok()).collect()
    }

    proptest! {
        #[test]
        fn limit_no_number_of_a_table_or_of_json_is_infinite(
            values in prop::collection::vec(prop::num::f64::ANY, 1..20)
        ) {
            let header = vec!["x"; values.len()];
            let exact = values.iter().map(|value| Cell::exact(*value)).collect::<Vec<_>>();
            let table = csv_text(&header, [exact]);
            let finite: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
            prop_assert_eq!(numbers(&table), finite.clone());
            let header: Vec<String> = header.into_iter().map(String::from).collect();
            let texts = values.iter().map(ToString::to_string).collect::<Vec<_>>();
            prop_assert_eq!(numbers(&to_csv(&header, &[texts])), finite);
            let json: Vec<Option<f64>> = serde_json::from_str(&json_text(&values)).expect("good JSON");
            for (value, read) in values.iter().zip(json) {
                prop_assert_eq!(read, Some(*value).filter(|value| value.is_finite()));
            }
        }
    }

    /// A spreadsheet ran the text of a name as a formula.
    #[test]
    fn issue_a_name_is_no_formula() {
        let names = ["=1+1", "+a", "-a", "@a", "a=b", "-0.5", "+2e3", "–"];
        let cells = names.map(Cell::from);
        let table = csv_text(&["=x"; 8], [cells]);
        assert_eq!(table, "'=x,'=x,'=x,'=x,'=x,'=x,'=x,'=x\n'=1+1,'+a,'-a,'@a,a=b,-0.5,+2e3,–\n");
    }

    /// A name rang the bell of a terminal that showed the table, and its NUL ended the file for some readers.
    #[test]
    fn issue_a_name_steers_no_terminal() {
        let name = "a\u{0}\u{1b}[31m\u{202e}";
        let spelt = "a\\u0000\\u001b[31m\\u202e";
        let table = csv_text(&[name], [[Cell::from(name)]]);
        assert_eq!(table, format!("{spelt}\n{spelt}\n"));
        assert_eq!(json_text(name), format!("\"{spelt}\"\n"));
        let read: String = serde_json::from_str(&json_text("\u{9b}\u{7f}\u{202e}")).unwrap();
        assert_eq!(read, "\u{9b}\u{7f}\u{202e}");
    }

    #[test]
    fn reference_columns_take_their_cells_from_rows() {
        let rows = [("a, b", 1.0 / 3.0), ("c", f64::INFINITY)];
        let table = Table::of(rows)
            .column("name", |row| row.0)
            .columns([1, 2], |times| format!("{times} times"), |row, times| f64::from(times) * row.1)
            .column("none", |_| None::<&str>);
        assert_eq!(table.csv(), "name,1 times,2 times,none\n\"a, b\",0.3333333,0.6666667,\nc,,,\n");
    }

    #[test]
    fn reference_a_name_stays_a_name() {
        let table = csv_text(&["name", "number"], [[Cell::from("inf"), Cell::exact(1e300)]]);
        assert_eq!(table, "name,number\ninf,1e300\n");
        assert_eq!(Cell::exact(0.1), Cell::from("0.1"));
        assert_eq!(Cell::exact(None), Cell::default());
    }
}
