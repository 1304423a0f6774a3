//! UNAM (Mexico), standard file of accelerations: about a hundred lines of keys in Latin-1, then one column per channel in gal.
//!
//! Keys with `C1-C6` give a value for each channel after a slash. No file was available: this reader follows programs that read the format.

use super::table::ComponentTable;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, identity, reading};
use crate::line::{Line, number};
use crate::refusals;
use crate::{AccelerationUnit, FilePlace, Identity, Refused};

/// Number of lines in which the mark of the format is searched, and of lines with keys.
const MARK: usize = 10;
const HEADER: usize = 120;

pub(super) const READER: Reader = Reader {
    format: Format::Unam,
    recognises: |file| {
        let first = &file.lines[..file.lines.len().min(MARK)];
        title::line_with(first, "ARCHIVO ESTANDAR DE ACELERACION").is_some()
    },
    components,
    read,
    identity: identity_of,
};

/// The values of a key for each channel.
struct Slots<'t> {
    line: Line<'t>,
    values: Vec<String>,
}

impl<'t> Slots<'t> {
    fn new(file: &File<'t>, key: &'static str) -> Result<Self, Refused> {
        let header = &file.lines[..file.lines.len().min(HEADER)];
        let line = title::line_with(header, key).ok_or(refusals::no_key(key))?;
        let text = line.text();
        let values = text.split_once(':').map_or("", |(_, values)| values);
        let values = values.split('/').map(title::words).filter(|value| !value.is_empty());
        Ok(Self {
            line,
            values: values.collect(),
        })
    }

    fn get(&self, index: usize) -> &str {
        self.values.get(index).map_or("", String::as_str)
    }
}

fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let slots = Slots::new(file, "ORIENTACION C1-C6")?;
    let place = FilePlace::Line(slots.line.number);
    let components = slots.values.into_iter().map(|name| Component::new(name, place));
    Ok(components.collect())
}

/// Station and event; date and hour of the event are on two lines.
fn identity_of(file: &File<'_>) -> Identity {
    let said = |key: &'static str| {
        let header = &file.lines[..file.lines.len().min(HEADER)];
        let text = title::line_with(header, key)?.text().into_owned();
        Some(text.split_once(':')?.1.trim().to_owned())
    };
    let time = [said("FECHA DEL SISMO"), said("HORA EPICENTRO")].map(Option::unwrap_or_default);
    Identity {
        station: said("CLAVE DE LA ESTACION").as_deref().and_then(identity::text),
        time: identity::time(&time.join(" ")),
        ..Identity::default()
    }
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let counts = Slots::new(file, "NUM. TOTAL DE MUESTRAS")?;
    let steps = Slots::new(file, "INTERVALO DE MUESTREO")?;
    let peaks = Slots::new(file, "ACEL. MAX.")?;
    let n_columns = counts.values.len();
    let is_row = |line: &Line<'_>| line.pieces().count() == n_columns && line.pieces().all(|piece| number(piece).is_some());
    let behind = file.behind(counts.line);
    let first = behind.iter().position(is_row);
    let first = needed(first, file.lines.last().copied(), "the values")?;
    let mut count = title::count(counts.line, counts.get(index))?;
    let (above, lines) = behind.split_at(first);
    let last = above.last().copied().unwrap_or(counts.line);
    let header = file.through(last);
    let numbers = ComponentTable::new(last, lines, n_columns, Line::pieces)?.column(index)?;
    // Some files count the steps instead of the samples.
    let is_one_more = numbers.values.len() == count.value + 1;
    let remark = is_one_more.then(|| {
        let found = format!("one more than the header declares, {}", count.value);
        reading("rows", Some(count.place), &found)
    });
    count.value += usize::from(is_one_more);
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(Spacing::Even(title::time_step(steps.line, number(steps.get(index).as_bytes()))?)),
        scale: Scale::Unit(Stated {
            value: AccelerationUnit::CentimetrePerSecondSquared,
            place: FilePlace::Line(peaks.line.number),
            text: peaks.line.excerpt(),
        }),
        peak: title::peak(peaks.line, peaks.get(index)),
        provenance: title::provenance(&header[..header.len().min(HEADER)]),
        remarks: remark.into_iter().collect(),
    })
}
