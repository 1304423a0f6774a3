//! CWB (CWA) of Taiwan: keys behind `#`, then time, up, north and east in 4F10.3.
//!
//! What the header calls the amplitudes may still have the offset of the instrument, so they are not
//! held against the values.

use super::columns::Columns;
use super::table::Table;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated};
use crate::line::{Line, number};
use crate::{AccelerationUnit, Place, ReadError};

const COLUMNS: Columns = Columns::new(4, 10);

pub(super) const READER: Reader = Reader {
    format: Format::Cwb,
    recognises: |file| {
        let first = file.lines.first();
        first.is_some_and(|line| title::holds(*line, "#EARTHQUAKE INFORMATION"))
    },
    components: |file| Ok(components(file)),
    read,
};

fn header<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    // Some files have blank lines between the parts of the header.
    let of_header = |line: &&Line<'_>| line.is_comment() || line.is_blank();
    let n_lines = file.lines.iter().take_while(of_header);
    &file.lines[..n_lines.count()]
}

fn components(file: &File<'_>) -> Vec<Component> {
    let last = header(file).last();
    let place = Place::Line(last.map_or(1, |line| line.number));
    let names = ["U", "N", "E"];
    let components = names.map(|name| Component::new(name, place));
    components.into()
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, ReadError> {
    let header = header(file);
    let last = *needed(header.last(), None, "its header")?;
    let fields = |line| COLUMNS.fields(line);
    let table = Table::new(last, &file.lines[header.len()..], COLUMNS.per_line, fields)?;
    let numbers = table.column(index + 1)?;
    let n_samples = numbers.values.len();
    let mut values = numbers.values;
    let (spacing, remark) = table.times()?.into_step_from_anywhere(&mut values)?;
    let rate = key(header, "#SampleRate")?;
    let length = key(header, "#RecordLength")?;
    // The last step may be counted or not.
    let count = (length.value * rate.value).round();
    if (n_samples as f64 - count).abs() > 1.0 {
        return Err(ReadError::Header {
            place: length.place,
            found: length.text,
            allowed: "the duration of the values that follow",
        });
    }
    if let Spacing::Even(step) = &spacing
        && (step.value * rate.value - 1.0).abs() > 1e-6
    {
        return Err(ReadError::Header {
            place: rate.place,
            found: rate.text,
            allowed: "the rate of the times of the values",
        });
    }
    let unit = match title::line_with(header, "#AMPLITUDEUNIT") {
        Some(line) => title::stated_unit(line, &line.text())?,
        None => Stated {
            value: AccelerationUnit::CentimetrePerSecondSquared,
            place: Place::Line(header[0].number),
            text: "as the format has it".to_owned(),
        },
    };
    Ok(Draft {
        values,
        end: numbers.end,
        digit: numbers.digit,
        count: None,
        time_step: Some(spacing),
        scale: Scale::Unit(unit),
        peak: None,
        provenance: title::provenance(header),
        remarks: remark.into_iter().collect(),
    })
}

/// The number behind a key such as `#SampleRate(Hz):`.
fn key(header: &[Line<'_>], key: &'static str) -> Result<Stated<f64>, ReadError> {
    let (line, value) = title::value_of(header, key).ok_or(ReadError::NoKey { key })?;
    let printed = value.split_once(':').map_or("", |(_, value)| value.trim());
    let place = Place::Line(line.number);
    let value = number(printed.as_bytes()).filter(|value| value.is_finite() && *value > 0.0);
    let value = value.ok_or_else(|| ReadError::Header {
        place,
        found: line.excerpt(),
        allowed: "a number above 0",
    })?;
    Ok(Stated {
        value,
        place,
        text: line.excerpt(),
    })
}
