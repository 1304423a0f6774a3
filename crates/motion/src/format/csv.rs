//! Two-column CSV: a time and an acceleration to a line, comments after `#`.

use super::time_column::TimeColumn;
use super::{Draft, File, Format, Reader, Scale, Stated, one_component};
use crate::line::Line;
use crate::{AccelerationUnit, Place, ReadError};

pub(super) const READER: Reader = Reader {
    format: Format::Csv,
    recognises,
    components: one_component,
    read: |file, _| read(file),
};

/// Two words and a comma, the first of which begins like the header: what is wrong with the rest
/// is told, and not taken for the titles of plain text.
fn recognises(file: &File<'_>) -> bool {
    let fields: Vec<&[u8]> = file
        .first()
        .map(|line| line.bytes.split(|byte| *byte == b',').collect())
        .unwrap_or_default();
    let is_header = |field: &&[u8]| {
        let word = field.trim_ascii();
        word.strip_prefix(b"\"")
            .unwrap_or(word)
            .starts_with(b"time_s")
    };
    fields.len() == 2 && fields.first().is_some_and(is_header)
}

/// Reads a two-column CSV: comment lines that begin with `#`, a header, then a time and a value to
/// a line.
///
/// The header is `time_s,acceleration_g` or `time_s,acceleration_m_per_s2` and gives the unit.
/// Times \[s\] rise in equal steps, to within 10⁻⁶ of a step and the rounding of their printed
/// decimals; the time step is the shortest decimal number that gives the printed span, and the mean
/// step where none does. The first time is 0, or one time step: such files leave out the state of
/// rest, and a value of 0 at t = 0 is put before the others. The comments become the provenance.
///
/// # Errors
/// Refuses another header, a line without exactly two finite numbers, fewer than two samples, and
/// times that do not keep to the rules above.
fn read(file: &File<'_>) -> Result<Draft, ReadError> {
    let lines = file.lines.iter().copied();
    let (comments, rows): (Vec<Line<'_>>, Vec<Line<'_>>) = lines
        .filter(|line| !line.is_blank())
        .partition(|line| line.is_comment());
    let mut records = split(&rows).into_iter();
    let (header, columns) = records.next().ok_or(ReadError::Empty)?;
    let unit = unit(header, &columns)?;
    let mut times = TimeColumn::default();
    let mut values = Vec::new();
    let mut end = header;
    for (line, record) in records {
        if record.len() != 2 {
            return Err(ReadError::FieldCount {
                line: line.number,
                found: record.len(),
            });
        }
        times.push(line, &record[0])?;
        values.push(line.finite(2, &record[1])?);
        end = line;
    }
    let comments: Vec<String> = comments.iter().map(|line| comment(*line)).collect();
    let (time_step, remark) = times.into_step(&mut values)?;
    Ok(Draft {
        values,
        end: Place::Line(end.number),
        digit: 0.0,
        count: None,
        time_step: Some(time_step),
        scale: Scale::Unit(Stated {
            value: unit,
            place: Place::Line(header.number),
            text: header.excerpt(),
        }),
        peak: None,
        provenance: comments.join("\n"),
        remarks: remark.into_iter().collect(),
    })
}

/// The fields of each line, together with the line where they begin.
///
/// The parser places a record at the comments and blank lines before it, so it is not shown them:
/// then its line n is `rows[n - 1]`, whatever the ends of the lines.
fn split<'t>(rows: &[Line<'t>]) -> Vec<(Line<'t>, csv::ByteRecord)> {
    let body: String = rows
        .iter()
        .map(|row| row.text().into_owned() + "\n")
        .collect();
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(body.as_bytes());
    let records = reader.byte_records().map(|record| {
        let record =
            record.expect("text in memory with any number of fields to a line cannot fail");
        let place = record
            .position()
            .expect("the parser gives every record its position")
            .line();
        let index = usize::try_from(place).expect("lines of a text in memory fit a usize") - 1;
        (rows[index], record)
    });
    records.collect()
}

fn unit(line: Line<'_>, columns: &csv::ByteRecord) -> Result<AccelerationUnit, ReadError> {
    let columns: Vec<&[u8]> = columns.iter().collect();
    match columns[..] {
        [b"time_s", b"acceleration_g"] => Ok(AccelerationUnit::StandardGravity),
        [b"time_s", b"acceleration_m_per_s2"] => Ok(AccelerationUnit::MetrePerSecondSquared),
        _ => Err(ReadError::Columns {
            line: line.number,
            found: line.excerpt(),
        }),
    }
}

fn comment(line: Line<'_>) -> String {
    line.text().trim_start_matches('#').trim().to_owned()
}
