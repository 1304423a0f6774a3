//! A table is rows, and the columns that take their cells from them: for programs, for people, or for both.

use std::borrow::Cow;

use serde_json::{Map, Value};

use crate::cell::csv_text;
use crate::{Cell, CellKind, CellValue, Grid, Heading, Shown, Unit};

/// A column: its name for programs, its heading for people, and how to take its cells from a row, so that header and cells cannot part.
struct Column<'a, Row> {
    /// Name in files; `None` if only people read it.
    name: Option<Cow<'static, str>>,
    kind: CellKind,
    cell: Box<dyn Fn(&Row) -> Cell + 'a>,
    /// Heading with unit, and text; `None` if only programs read it.
    people: Option<People<'a, Row>>,
}

struct People<'a, Row> {
    heading: Heading,
    text: Box<dyn Fn(&Row) -> Shown + 'a>,
}

/// A table is rows, and the columns that take their cells from them.
///
/// ```
/// use pounding_text::{Cell, Table, Unit, short};
///
/// let gaps = [("left", 0.03, None), ("right", 0.05, Some(3_usize))];
/// let table = Table::of(gaps)
///     .column("pair", |(name, ..)| *name)
///     .column("gap_mm", |(_, gap, _)| 1e3 * gap)
///     .column("gap_m", |(_, gap, _)| Cell::number(*gap, short))
///     .column("collisions", |(.., count)| *count);
/// assert_eq!(table.csv(), "pair,gap_mm,gap_m,collisions\nleft,30,0.03000,\nright,50,0.05000,3\n");
///
/// // People read another unit, and other words.
/// let table = Table::of(gaps)
///     .shown("Pair", |(name, ..)| *name)
///     .number("gap_m", "Gap", &Unit::METRE, |(_, gap, _)| *gap);
/// assert_eq!(table.grid().terminal(false), "Pair     Gap\n        [mm]\nleft   30.00\nright  50.00\n");
/// assert_eq!(table.csv(), "gap_m\n0.03\n0.05\n");
/// ```
pub struct Table<'a, Row> {
    rows: Vec<Row>,
    columns: Vec<Column<'a, Row>>,
    /// Acceleration of gravity \[m/s²\], the unit in which people read accelerations.
    gravity: f64,
}

impl<Row> std::fmt::Debug for Table<'_, Row> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let names: Vec<_> = self.columns.iter().map(|column| &column.name).collect();
        f.debug_struct("Table").field("columns", &names).finish_non_exhaustive()
    }
}

impl<'a, Row: 'a> Table<'a, Row> {
    /// A table without columns.
    pub fn of(rows: impl IntoIterator<Item = Row>) -> Self {
        Self {
            rows: rows.into_iter().collect(),
            columns: Vec::new(),
            gravity: 9.806_65,
        }
    }

    /// Returns the table with this acceleration of gravity \[m/s²\], for the columns that follow.
    #[must_use]
    pub fn gravity(self, gravity: f64) -> Self {
        Self { gravity, ..self }
    }

    /// Returns the table with one column more for programs, whose cells `cell` takes from the rows. Numbers get seven significant digits;
    /// [`Cell::number`] takes another format.
    #[must_use]
    pub fn column<C: CellValue>(mut self, name: impl Into<Cow<'static, str>>, cell: impl Fn(&Row) -> C + 'a) -> Self {
        self.columns.push(Column {
            name: Some(name.into()),
            kind: C::KIND,
            cell: Box::new(move |row| cell(row).into()),
            people: None,
        });
        self
    }

    /// Returns the table with one column more for each of some keys; `name` and `cell` get the key.
    #[must_use]
    pub fn columns<Key: Copy + 'a, C: CellValue>(
        self,
        keys: impl IntoIterator<Item = Key>,
        name: impl Fn(Key) -> String,
        cell: impl Fn(&Row, Key) -> C + Copy + 'a,
    ) -> Self {
        let keys = keys.into_iter();
        keys.fold(self, |table, key| table.column(name(key), move |row| cell(row, key)))
    }

    /// Returns the table with one column more for people; a heading may be a name with its unit.
    #[must_use]
    pub fn shown<S: Into<Shown>>(mut self, heading: impl Into<Heading>, text: impl Fn(&Row) -> S + 'a) -> Self {
        self.columns.push(Column {
            name: None,
            kind: CellKind::Text,
            cell: Box::new(|_| Cell::default()),
            people: Some(People {
                heading: heading.into(),
                text: Box::new(move |row| text(row).into()),
            }),
        });
        self
    }

    /// Returns the table with one column more for people, under a unit.
    #[must_use]
    pub fn shown_in<S: Into<Shown>>(self, unit: &'static str, heading: impl Into<String>, text: impl Fn(&Row) -> S + 'a) -> Self {
        self.shown((heading.into(), unit), text)
    }

    /// Returns the table with one column more for people: a number \[SI\] in the unit that they read.
    #[must_use]
    pub fn shown_number<N: Into<Option<f64>>>(
        self,
        heading: impl Into<String>,
        unit: &'static Unit,
        number: impl Fn(&Row) -> N + 'a,
    ) -> Self {
        let gravity = self.gravity;
        self.shown((heading.into(), unit.shown), move |row| {
            let number: Option<f64> = number(row).into();
            number.map(|value| unit.text_of(value, gravity))
        })
    }

    /// Returns the table with one column more for both: a number \[SI\], which people read in their unit. JSON makes an object of names
    /// with a dot: `width_m.median`.
    #[must_use]
    pub fn number<N: Into<Option<f64>>>(
        self,
        name: impl Into<Cow<'static, str>>,
        heading: impl Into<String>,
        unit: &'static Unit,
        number: impl Fn(&Row) -> N + Copy + 'a,
    ) -> Self {
        let gravity = self.gravity;
        let text = move |row: &Row| number(row).into().map(|value| unit.text_of(value, gravity));
        self.both(name, (heading.into(), unit.shown), move |row| Cell::exact(number(row)), text)
    }

    /// Returns the table with one column more for both: what programs take from a row, and what people read of it.
    #[must_use]
    pub fn both<C: CellValue, S: Into<Shown>>(
        self,
        name: impl Into<Cow<'static, str>>,
        heading: impl Into<Heading>,
        cell: impl Fn(&Row) -> C + 'a,
        text: impl Fn(&Row) -> S + 'a,
    ) -> Self {
        let mut table = self.shown(heading, text);
        if let Some(column) = table.columns.last_mut() {
            column.name = Some(name.into());
            column.kind = C::KIND;
            column.cell = Box::new(move |row| cell(row).into());
        }
        table
    }

    fn named(&self) -> impl Iterator<Item = (&str, &Column<'a, Row>)> {
        self.columns.iter().filter_map(|column| Some((&**column.name.as_ref()?, column)))
    }

    /// Names of the columns for programs.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.named().map(|(name, _)| name)
    }

    /// The columns for programs: the name of each, the kind of its values, and its values.
    pub fn values(&self) -> impl Iterator<Item = (&str, CellKind, Vec<Value>)> {
        self.named().map(|(name, column)| {
            let values = self.rows.iter().map(|row| (column.cell)(row).json());
            (name, column.kind, values.collect())
        })
    }

    /// The table for programs as CSV: the names of its columns, and a line for each row.
    pub fn csv(&self) -> String {
        let header: Vec<&str> = self.names().collect();
        let cells = |row| self.named().map(move |(_, column)| (column.cell)(row));
        csv_text(&header, self.rows.iter().map(cells))
    }

    /// The table for programs as JSON: an object for each row.
    pub fn json(&self) -> Value {
        let object = |row: &Row| {
            let mut all = Map::new();
            for (name, column) in self.named() {
                put(&mut all, name, (column.cell)(row).json());
            }
            Value::Object(all)
        };
        self.rows.iter().map(object).collect()
    }

    /// The table for people.
    pub fn grid(&self) -> Grid {
        let people: Vec<&People<'_, Row>> = self.columns.iter().filter_map(|column| column.people.as_ref()).collect();
        let headings = people.iter().map(|column| column.heading.clone());
        let row = |row: &Row| people.iter().map(|column| (column.text)(row)).collect();
        Grid::of(headings, self.rows.iter().map(row).collect())
    }
}

/// Puts a value under a name; a name with a dot leads into a nested object.
fn put(all: &mut Map<String, Value>, name: &str, value: Value) {
    match name.split_once('.') {
        None => {
            all.insert(name.into(), value);
        }
        Some((outer, inner)) => {
            let nested = all.entry(outer).or_insert_with(|| Value::Object(Map::new()));
            if let Value::Object(nested) = nested {
                put(nested, inner, value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Cell, CellKind, Table};

    /// A column without rows, or with an empty first cell, had the type of another one.
    #[test]
    fn issue_a_column_knows_its_kind_without_rows() {
        let none: [Option<usize>; 0] = [];
        let table = Table::of(none)
            .column("text", |_| "")
            .column("flag", |row| row.map(|_| true))
            .column("count", |row| *row)
            .column("number", |row| Cell::exact(row.map(|one| one as f64)));
        let kinds: Vec<_> = table.values().map(|(_, kind, _)| kind).collect();
        assert_eq!(kinds, [CellKind::Text, CellKind::Truth, CellKind::Count, CellKind::Number]);
    }

    /// A name that a spreadsheet would run had its apostrophe in JSON, too, and no longer matched the scene.
    #[test]
    fn issue_json_has_names_as_they_are() {
        let table = Table::of(["-A", "a\u{1b}"]).both("name", "Name", |name| *name, |name| *name);
        assert_eq!(table.json(), serde_json::json!([{"name": "-A"}, {"name": "a\u{1b}"}]));
        assert_eq!(table.csv(), "name\n'-A\na\\u001b\n");
        assert_eq!(table.grid().terminal(true), "Name\n-A\na\\u001b\n");
    }
}
