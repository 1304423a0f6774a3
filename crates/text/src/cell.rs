//! Tables and JSON as all crates write them: no number in them is NaN or infinite.
//!
//! A number that does not exist is an empty cell or `null`. A sweep writes millions of rows without these cells, by its own code with this
//! rule.

use std::borrow::Cow;

use serde::Serialize;
use serde_json::Value;

use crate::{digits, visible};

/// A cell of a table for programs: a text, or a number that is finite.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cell(Content);

#[derive(Debug, Clone, Default, PartialEq)]
enum Content {
    /// No value, or no finite number.
    #[default]
    Nothing,
    Text(String),
    /// A number, and the text that tables have of it.
    Number(serde_json::Number, String),
    Truth(bool),
    /// What only JSON can hold, such as a list.
    Nested(Value),
}

impl Cell {
    /// A number in the caller's format; empty if there is no number or if it is not finite.
    pub fn number(value: impl Into<Option<f64>>, format: impl FnOnce(f64) -> String) -> Self {
        let number = value.into().and_then(|value| Some((serde_json::Number::from_f64(value)?, value)));
        Self(number.map_or(Content::Nothing, |(number, value)| Content::Number(number, format(value))))
    }

    /// A number in the shortest digits that give it back; empty if there is no number or if it is not finite.
    pub fn exact(value: impl Into<Option<f64>>) -> Self {
        Self::number(value, |value| {
            let plain = value.to_string();
            if plain.len() <= LONGEST { plain } else { format!("{value:e}") }
        })
    }

    /// The text in a table.
    fn csv(self) -> String {
        match self.0 {
            Content::Nothing => String::new(),
            Content::Text(text) => harmless(&text).into_owned(),
            Content::Number(_, text) => text,
            Content::Truth(truth) => truth.to_string(),
            Content::Nested(value) => value.to_string(),
        }
    }

    /// The value in JSON, with all digits of a number.
    pub fn json(self) -> Value {
        match self.0 {
            Content::Nothing => Value::Null,
            Content::Text(text) => text.into(),
            Content::Number(number, _) => number.into(),
            Content::Truth(truth) => truth.into(),
            Content::Nested(value) => value,
        }
    }
}

/// The kind of the values of a column, whatever rows it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellKind {
    /// Numbers.
    Number,
    /// Whole numbers.
    Count,
    /// Yes or no.
    Truth,
    /// Texts.
    Text,
    /// What only JSON can hold, such as lists.
    Nested,
}

/// A value that fills a cell.
pub trait CellValue: Into<Cell> {
    /// The kind of such values. A ready [`Cell`] counts as a number, which it mostly is.
    const KIND: CellKind;
}

macro_rules! cell_values {
    ($($Value:ty: $Kind:ident),+ $(,)?) => {
        $(impl CellValue for $Value {
            const KIND: CellKind = CellKind::$Kind;
        })+
    };
}

cell_values! { f64: Number, Cell: Number, usize: Count, u64: Count, bool: Truth, String: Text, &str: Text, Value: Nested }

impl<T: CellValue> CellValue for Option<T> {
    const KIND: CellKind = T::KIND;
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
        Self(Content::Text(text.into()))
    }
}

impl From<bool> for Cell {
    fn from(truth: bool) -> Self {
        Self(Content::Truth(truth))
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Self {
        Self(Content::Number(count.into(), count.to_string()))
    }
}

impl From<u64> for Cell {
    fn from(count: u64) -> Self {
        Self(Content::Number(count.into(), count.to_string()))
    }
}

impl From<Value> for Cell {
    /// What only JSON can hold, such as a list.
    fn from(value: Value) -> Self {
        Self(Content::Nested(value))
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

/// A table as CSV: the names of its columns, and rows as long as they are.
///
/// # Panics
/// Panics if a row is not as long as the header.
pub(crate) fn csv_text<Name: AsRef<str>>(header: &[Name], rows: impl IntoIterator<Item: IntoIterator<Item = Cell>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = header.iter().map(|name| harmless(name.as_ref()).into_owned());
    writer.write_record(names).expect("memory takes all");
    for row in rows {
        let cells = row.into_iter().map(Cell::csv);
        writer
            .write_record(cells)
            .expect("rows are as long as the header, and memory takes them");
    }
    let bytes = writer.into_inner().expect("memory takes all");
    String::from_utf8(bytes).expect("cells are text")
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
    use crate::Table;

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
            prop_assert_eq!(&numbers(&table), &finite);
            let rounded = csv_text(&header, [values.iter().map(|value| Cell::from(*value))]);
            prop_assert_eq!(numbers(&rounded).len(), finite.len());
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
        assert_eq!(Cell::exact(0.1).csv(), "0.1");
        assert_eq!(Cell::exact(None), Cell::default());
    }
}
