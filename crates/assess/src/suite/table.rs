//! Tables beside the files of a folder: `records.csv`, and PEER's `_SearchResults.csv`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use pounding_files::shown_name;
use pounding_scene::file::Unit;
use pounding_scene::{Error, FileUse};
use pounding_text::{Refused, digits};

use super::entries::RecordFile;
use super::{FolderUse, SelectionFactors};

/// What a table tells about a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct TableRow {
    /// Component that is read of a file with several; of a file with one the word for its direction.
    pub(super) component: Option<String>,
    unit: Option<Unit>,
    time_step_s: Option<f64>,
    /// Factor on the values \[–\].
    pub(super) factor: Option<f64>,
    /// Name of the event.
    pub(super) event: Option<String>,
}

impl TableRow {
    /// Adds the declarations of the row to those for all files.
    pub(super) fn over(&self, declared: &FileUse) -> FileUse {
        FileUse {
            unit: self.unit.or(declared.unit),
            time_step_s: self.time_step_s.or(declared.time_step_s),
            ..declared.clone()
        }
    }
}

/// The tables of some folders.
#[derive(Debug, Default)]
pub(super) struct Tables {
    /// Rows by the paths of their files.
    rows: BTreeMap<PathBuf, Vec<TableRow>>,
    /// The tables, which are no records.
    pub(super) paths: Vec<PathBuf>,
    /// Sentences about factors.
    pub(super) said: Vec<String>,
}

/// Name of the table that users write.
const OWN: &str = "records.csv";

/// Name of the table of a selection of PEER.
const PEER: &str = "_SearchResults.csv";

/// Columns of the table that users write.
const COLUMNS: [&str; 6] = ["file", "component", "unit", "time_step_s", "factor", "event"];

impl Tables {
    /// Reads the tables among files. A `records.csv` without a column `file` is a record like any other.
    ///
    /// # Errors
    /// Refuses a table with a fault, and its rows about files that are not there.
    pub(super) fn among(files: &[RecordFile], asked: &FolderUse) -> Result<Self, Error> {
        let mut tables = Self::default();
        for file in files {
            let name = shown_name(&file.path);
            if name.eq_ignore_ascii_case(OWN) {
                if let Some(rows) = file.with_bytes(|bytes| own(bytes, &file.path))?? {
                    tables.add(file, rows, files)?;
                }
            } else if name.eq_ignore_ascii_case(PEER)
                && let Some(rows) = file.with_bytes(selection)?
            {
                tables.add_selection(file, rows, asked.selection_factors);
            }
        }
        Ok(tables)
    }

    /// Returns the rows about a file; one that tells nothing if there is none.
    pub(super) fn of(&self, path: &Path) -> Vec<TableRow> {
        self.rows.get(path).cloned().unwrap_or_else(|| vec![TableRow::default()])
    }

    fn add(&mut self, table: &RecordFile, rows: Vec<(String, TableRow)>, files: &[RecordFile]) -> Result<(), Error> {
        let folder = table.path.parent().unwrap_or_else(|| Path::new(""));
        for (name, row) in rows {
            let path = folder.join(&name);
            if !files.iter().any(|file| file.path == path) {
                let found = Refused::at(table.path.as_path()).found(format!("a row of the file {name}, which is not there"));
                return Err(found
                    .allowed_are("files beside the table")
                    .help("correct its name, or delete the row")
                    .into());
            }
            self.rows.entry(path).or_default().push(row);
        }
        self.paths.push(table.path.clone());
        Ok(())
    }

    fn add_selection(&mut self, table: &RecordFile, rows: Vec<(String, f64)>, asked: SelectionFactors) {
        let folder = table.path.parent().unwrap_or_else(|| Path::new(""));
        let factors = rows.iter().map(|(_, factor)| *factor);
        let [least, most] = [f64::min, f64::max].map(|end| factors.clone().reduce(end).unwrap_or(1.0));
        let range = format!("scale factors from {} to {}", digits(least), digits(most));
        let name = shown_name(&table.path);
        let used = asked == SelectionFactors::Used;
        if used {
            self.said.push(format!("{name}: {range} multiply its records"));
        } else if asked == SelectionFactors::LeftOut && (least < 1.0 || most > 1.0) {
            self.said
                .push(format!("{name}: {range} are not used; --selection-factors uses them"));
        }
        for (file, factor) in rows.into_iter().filter(|_| used) {
            let row = TableRow {
                factor: Some(factor),
                ..TableRow::default()
            };
            // A row of the user's own table holds.
            self.rows.entry(folder.join(file)).or_insert_with(|| vec![row]);
        }
        self.paths.push(table.path.clone());
    }
}

/// Words of units, for a message.
const UNITS: &str = "g, mg, g_per_10, m_per_s2, cm_per_s2, mm_per_s2";

/// The unit of a word; `None` if it is none.
fn unit(word: &str) -> Option<Unit> {
    serde_json::from_value(serde_json::Value::from(word)).ok()
}

/// Reads a table that users write; `None` if it is no such table.
fn own(bytes: &[u8], path: &Path) -> Result<Option<Vec<(String, TableRow)>>, Error> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let refused = |line: u64, found: String, allowed: String| {
        let found = Refused::at(path).found(format!("{found} in line {line}"));
        Error::from(found.allowed_are(allowed))
    };
    let header = reader
        .headers()
        .map_err(|error| refused(1, error.to_string(), "columns between commas".into()))?
        .clone();
    if !header.iter().any(|name| name == "file") {
        return Ok(None);
    }
    if let Some(other) = header.iter().find(|name| !COLUMNS.contains(name)) {
        return Err(refused(1, format!("the column {other:?}"), COLUMNS.join(", ")));
    }
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error.position().map_or(0, csv::Position::line);
            refused(line, error.to_string(), "as many values as names of columns".into())
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        let cell = |name: &str| {
            let at = header.iter().position(|column| column == name)?;
            record.get(at).filter(|cell| !cell.is_empty())
        };
        let number = |name: &str, is_allowed: fn(f64) -> bool, allowed: &str| match cell(name) {
            None => Ok(None),
            Some(text) => match text.parse::<f64>() {
                Ok(value) if value.is_finite() && is_allowed(value) => Ok(Some(value)),
                _ => Err(refused(line, format!("the {name} {text:?}"), format!("{allowed}, or nothing"))),
            },
        };
        let unit = cell("unit").map(|text| unit(text).ok_or_else(|| refused(line, format!("the unit {text:?}"), UNITS.into())));
        let file = cell("file").ok_or_else(|| refused(line, "no file".into(), "a name of a file".into()))?;
        rows.push((
            file.to_owned(),
            TableRow {
                component: cell("component").map(str::to_owned),
                unit: unit.transpose()?,
                time_step_s: number("time_step_s", |step| step > 0.0, "seconds above 0")?,
                factor: number("factor", |factor| factor != 0.0, "a number that is not 0")?,
                event: cell("event").map(str::to_owned),
            },
        ));
    }
    Ok(Some(rows))
}

/// Reads the files and scale factors of a selection of PEER; `None` if it has no such table.
fn selection(bytes: &[u8]) -> Option<Vec<(String, f64)>> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = text
        .lines()
        .skip_while(|line| !line.contains("Summary of Metadata of Selected Records"));
    lines.next()?;
    let is_blank = |line: &&str| line.trim_matches([',', ' ']).is_empty();
    let mut table = lines.skip_while(is_blank).take_while(|line| !is_blank(line)).map(cells);
    let header = table.next()?;
    let column = |name: &str| header.iter().position(|one| one.eq_ignore_ascii_case(name));
    let factor = column("Scale Factor")?;
    let files = ["Horizontal-1 Acc. Filename", "Horizontal-2 Acc. Filename"].map(column);
    let mut rows = Vec::new();
    for row in table {
        let factor: f64 = row
            .get(factor)?
            .parse()
            .ok()
            .filter(|factor: &f64| factor.is_finite() && *factor > 0.0)?;
        let names = files.iter().filter_map(|at| row.get((*at)?));
        let names = names.filter(|name| !name.is_empty() && !name.starts_with("--"));
        rows.extend(names.map(|name| ((*name).to_owned(), factor)));
    }
    (!rows.is_empty()).then_some(rows)
}

/// The cells of a line of PEER's table. A quote may follow a blank, which a reader of CSV does not take for a quote.
fn cells(line: &str) -> Vec<&str> {
    let mut within = false;
    let cells = line.split(|letter: char| {
        within ^= letter == '"';
        letter == ',' && !within
    });
    cells.map(|cell| cell.trim_matches([' ', '"', '\t', '\r'])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_a_table_of_peer() {
        let text = "PEER Ground Motion Database\n-- Summary of Search Criteria --\nMagnitude Range :, 6, 7\n\n\
            \x20-- Summary of Metadata of Selected Records --\n\
            Result ID, Spectral Ordinate, Record Sequence Number, Scale Factor, Earthquake Name, Horizontal-1 Acc. Filename, \
            Horizontal-2 Acc. Filename, Vertical Acc. Filename\n\
            1, SRSS, 6, 1.25, \"Chi-Chi, Taiwan\", RSN6_A180.AT2, RSN6_A270.AT2, RSN6_A-UP.AT2\n\
            2, SRSS, 7, 0.5, \"B\", RSN7_B090.AT2, -----, -----\n\n -- Scaled Spectra used in Search & Scaling --\nT, Sa\n0.01, 1\n";
        let rows = selection(text.as_bytes()).expect("a table");
        let wanted = [("RSN6_A180.AT2", 1.25), ("RSN6_A270.AT2", 1.25), ("RSN7_B090.AT2", 0.5)];
        assert_eq!(rows, wanted.map(|(name, factor)| (name.to_owned(), factor)));
        assert_eq!(selection(b"T, Sa\n1, 2\n"), None);
        assert_eq!(selection(text.replace("1.25", "none").as_bytes()), None);
    }
}
