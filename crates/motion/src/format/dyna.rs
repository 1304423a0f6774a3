//! DYNA of the Italian networks, as of 2009: lines of a key, a colon and a value, then values in columns.

use super::{Component, Draft, File, Format, Reader, Scale, Spacing, identity, title, values};
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Identity, Refused};

/// Number of lines in which the line above the values is searched.
const HEADER: usize = 40;

pub(super) const READER: Reader = Reader {
    format: Format::Dyna,
    recognises: |file| {
        let header = &file.lines[..file.lines.len().min(HEADER)];
        title::value_of(header, "TIME INCREMENT (S)").is_some() && title::value_of(header, "NUMBER OF DATA").is_some()
    },
    components: |file| Ok(component(file).into_iter().collect()),
    read: |file, _| read(file),
    identity: |file| Identity {
        station: said(file, "Station Code").and_then(|text| identity::text(&text)),
        time: said(file, "Event Date").and_then(|text| identity::time(&text)),
        ..Identity::default()
    },
};

/// The lines up to the one above the values.
fn header<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    let searched = &file.lines[..file.lines.len().min(HEADER)];
    let above = searched.iter().position(|line| title::holds(*line, "TIME SERIES IN"));
    &searched[..above.map_or(searched.len(), |above| above + 1)]
}

/// The text after a key and its colon.
fn value<'t>(file: &File<'t>, key: &'static str) -> Result<(Line<'t>, String), Refused> {
    let (line, value) = title::value_of(header(file), key).ok_or(refusals::no_key(key))?;
    let value = value.split_once(':').map_or("", |(_, value)| value.trim());
    Ok((line, value.to_owned()))
}

/// Text after a key; `None` if it is missing.
fn said(file: &File<'_>, key: &'static str) -> Option<String> {
    value(file, key).ok().map(|(_, value)| value)
}

fn component(file: &File<'_>) -> Option<Component> {
    let (line, name) = value(file, "Orientation").ok()?;
    Some(Component::new(name, FilePlace::Line(line.number)))
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let header = header(file);
    let last = header[header.len() - 1];
    let unit = title::after(&last.text(), "TIME SERIES IN").map(str::to_owned);
    // The files spell it "Accelaration".
    if !last.bytes.to_ascii_uppercase().starts_with(b"ACCEL") {
        return Err(refusals::not_acceleration(
            FilePlace::Line(last.number),
            last.excerpt(),
            "the .acc file of the record",
        ));
    }
    let (count_line, count) = value(file, "Number of Data")?;
    let (step_line, step) = value(file, "Time Increment (s)")?;
    let peak = value(file, "PGA");
    let numbers = values::read(last, &file.lines[header.len()..])?;
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(count_line, &count)?),
        time_step: Some(Spacing::Even(title::time_step(step_line, number(step.as_bytes()))?)),
        scale: Scale::Unit(title::stated_unit(last, &unit.unwrap_or_default())?),
        peak: peak.ok().and_then(|(line, text)| title::peak(line, &text)),
        provenance: title::provenance(&header[..header.len() - 1]),
        remarks: Vec::new(),
    })
}
