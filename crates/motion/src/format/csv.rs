//! Two-column CSV: a time and an acceleration to a line, comments after `#`.

use super::numbers::Values;
use super::plain::{cut_by_commas, may_be_cut, tells};
use super::said::Said;
use super::time_column::TimeColumn;
use super::{Draft, File, Format, Reader, Scale, Stated, one_component};
use crate::line::Line;
use crate::refusals;
use crate::{AccelerationUnit, FilePlace, Refused};
use pounding_text::Spot;

pub(super) const READER: Reader = Reader {
    format: Format::Csv,
    recognises,
    components: one_component,
    read: |file, _| read(file),
    identity: |file| Said::new(above(&file.lines), None).identity(),
};

/// Names of the second column with their units.
const OURS: [(&str, AccelerationUnit); 2] = [
    ("acceleration_g", AccelerationUnit::StandardGravity),
    ("acceleration_m_per_s2", AccelerationUnit::MetrePerSecondSquared),
];

/// Whether the header is two words and a comma, with a first word like that of the format. Errors in the rest are then reported, and the
/// line does not count as a title of plain text.
fn recognises(file: &File<'_>) -> bool {
    file.first().is_some_and(|line| {
        let mut fields = fields(line);
        let is_time = fields.next().is_some_and(|word| word.starts_with(b"time_s"));
        let value = fields.next().map(String::from_utf8_lossy);
        // The header of another program, whose name gives the unit or another quantity.
        let is_other = value
            .as_deref()
            .is_some_and(|value| !OURS.iter().any(|(name, _)| *name == value) && tells(value));
        is_time && value.is_some() && fields.next().is_none() && !is_other
    })
}

/// The comments and blank lines above the header.
fn above<'l, 't>(lines: &'l [Line<'t>]) -> &'l [Line<'t>] {
    let is_header = |line: &Line<'_>| !line.is_blank() && !line.is_comment();
    let end = lines.iter().position(is_header);
    &lines[..end.unwrap_or(lines.len())]
}

/// The fields between commas, without quotes.
fn fields(line: Line<'_>) -> impl Iterator<Item = &[u8]> {
    line.fields().map(|field| {
        let quoted = field.strip_prefix(b"\"");
        let quoted = quoted.and_then(|field| field.strip_suffix(b"\""));
        quoted.unwrap_or(field).trim_ascii()
    })
}

/// Reads a two-column CSV: comment lines that begin with `#`, a header, then a time and a value to
/// a line.
///
/// The header is `time_s,acceleration_g` or `time_s,acceleration_m_per_s2` and gives the unit.
///
/// Times \[s\] rise in equal steps, to within 10⁻⁶ of a step and the rounding of their printed decimals. The time step is the shortest
/// decimal number that gives the printed span, else the mean step. The first time is 0 or one time step. A file that starts after one step
/// lacks the state of rest, and a value of 0 at t = 0 is added. The comments become the provenance.
///
/// # Errors
/// Refuses another header, a line without exactly two finite numbers, fewer than two samples, and times that break the rules above.
fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let mut rows = file.lines.iter().copied().filter(|line| !line.is_blank() && !line.is_comment());
    let header = rows.next().ok_or(refusals::empty())?;
    let unit = unit(header)?;
    let mut times = TimeColumn::default();
    let mut values = Values::default();
    for line in rows {
        let mut row = fields(line);
        let (Some(time), Some(value), None) = (row.next(), row.next(), row.next()) else {
            if fields(line).count() == 4 && may_be_cut(line) {
                return Err(cut_by_commas(line));
            }
            return Err(Refused::at(Spot::Line(line.number))
                .goes_on(format!("has {} field(s)", fields(line).count()))
                .allowed_are("2, the time and the acceleration")
                .help("write one sample to a line, with a comma between"));
        };
        times.push(line, time)?;
        values.push(line, line.finite(2, value)?, value)?;
    }
    let comments = file.lines.iter().filter(|line| line.is_comment());
    let comments: Vec<String> = comments.map(|line| comment(*line)).collect();
    let numbers = values.finish(header);
    let mut values = numbers.values;
    let (time_step, remark) = times.into_step(&mut values)?;
    Ok(Draft {
        values,
        end: numbers.end,
        digit: 0.0,
        count: None,
        time_step: Some(time_step),
        scale: Scale::Unit(Stated {
            value: unit,
            place: FilePlace::Line(header.number),
            text: header.excerpt(),
        }),
        peak: None,
        provenance: comments.join("\n"),
        remarks: remark.into_iter().collect(),
    })
}

fn unit(line: Line<'_>) -> Result<AccelerationUnit, Refused> {
    let name = fields(line).nth(1).map(String::from_utf8_lossy);
    let ours = OURS.iter().find(|(known, _)| name.as_deref() == Some(known));
    ours.map(|(_, unit)| *unit).ok_or_else(|| {
        Refused::at(Spot::Line(line.number))
            .reads(line.excerpt())
            .but(
                ", but ",
                "the header of a CSV must be `time_s,acceleration_g` or `time_s,acceleration_m_per_s2`",
            )
            .help("put the one that gives the unit above the numbers")
    })
}

fn comment(line: Line<'_>) -> String {
    line.text().trim_start_matches('#').trim().to_owned()
}
