//! CWB (CWA) of Taiwan: keys, in most files after `#`, then time, up, north and east in 4F10.3, or in the order of a key.
//!
//! The amplitudes in the header may include the offset of the instrument, so they are not compared with the values.

use super::columns::FixedColumns;
use super::table::ComponentTable;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, identity, reading};
use crate::line::{Line, number};
use crate::refusals;
use crate::{AccelerationUnit, FilePlace, Identity, Refused};

const COLUMNS: FixedColumns = FixedColumns::new(4, 10);

/// Keys in capitals; a header has at least two of them.
const KEYS: [&str; 4] = ["STATIONCODE:", "AMPLITUDEUNIT:", "DATASEQUENCE:", "SAMPLERATE(HZ):"];

pub(super) const READER: Reader = Reader {
    format: Format::Cwb,
    recognises: |file| {
        let header = header(file);
        let n_keys = KEYS.iter().filter(|key| said(header, key).is_some());
        header.first().is_some_and(|line| title::holds(*line, "#EARTHQUAKE INFORMATION")) || n_keys.count() > 1
    },
    components,
    read,
    identity: |file| {
        let said = |key: &str| said(header(file), key).map(|(_, value)| value);
        let time = said("ORIGIN TIME(GMT+08):").or_else(|| said("STARTTIME:"));
        Identity {
            station: said("STATIONCODE:").as_deref().and_then(identity::text),
            time: time.as_deref().and_then(identity::time),
            ..Identity::default()
        }
    },
};

/// Most lines of a header.
const HEADER: usize = 60;

fn header<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    // Some files have blank lines between the parts of the header.
    let of_header = |line: &&Line<'_>| {
        let text = line.bytes.trim_ascii_start();
        text.first().is_none_or(|byte| *byte == b'#' || byte.is_ascii_alphabetic())
    };
    let lines = &file.lines[..file.lines.len().min(HEADER)];
    &lines[..lines.iter().take_while(of_header).count()]
}

/// Text after a key, with its line.
fn said<'t>(header: &[Line<'t>], key: &str) -> Option<(Line<'t>, String)> {
    header.iter().find_map(|line| {
        let text = line.text();
        let text = text.trim_start_matches(['#', ' ']);
        let start = text.get(..key.len())?;
        let is_key = start.eq_ignore_ascii_case(key);
        is_key.then(|| (*line, text[key.len()..].trim().to_owned()))
    })
}

/// The components in the order of `DataSequence: Time U(+); N(+); E(+)`, or of words such as `Time, North, East, Up`.
fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let header = header(file);
    let sequence = said(header, "DATASEQUENCE:");
    let last = header.last().map_or(1, |line| line.number);
    let place = FilePlace::Line(sequence.as_ref().map_or(last, |(line, _)| line.number));
    let stated = sequence.map(|(_, text)| text).unwrap_or_default();
    let names = stated
        .split([' ', ';', ',', '\t'])
        .map(|word| word.split('(').next().unwrap_or_default());
    let names: Vec<&str> = names
        .filter(|name| !name.is_empty() && !name.eq_ignore_ascii_case("time"))
        .collect();
    let names = if stated.is_empty() { vec!["U", "N", "E"] } else { names };
    let are_known = names.iter().all(|name| crate::Direction::of_component(name).is_some());
    if names.len() != COLUMNS.per_line - 1 || !are_known {
        return Err(refusals::header(
            place,
            stated,
            "a time and three directions, such as `Time U(+); N(+); E(+)`,",
        ));
    }
    let component = |name| Component::new(name, place);
    Ok(names.into_iter().map(component).collect())
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let header = header(file);
    let last = *needed(header.last(), None, "its header")?;
    let fields = |line| COLUMNS.fields(line);
    let table = ComponentTable::new(last, &file.lines[header.len()..], COLUMNS.per_line, fields)?;
    let numbers = table.column(index + 1)?;
    let n_samples = numbers.values.len();
    let mut values = numbers.values;
    let (spacing, remark) = table.times()?.into_step_from_anywhere(&mut values)?;
    let rate = key(header, "SampleRate(Hz):")?;
    let length = key(header, "RecordLength(sec):")?;
    // The last step may be counted or not; a missing row is reported.
    let count = (length.value * rate.value).round();
    let off = n_samples as f64 - count;
    if off.abs() > 1.0 {
        return Err(refusals::header(
            length.place,
            length.text,
            "the duration of the values that follow",
        ));
    }
    let missing = (off < 0.0).then(|| {
        let found = format!("{n_samples}, one fewer than the header's duration and rate give");
        reading("rows", Some(length.place), &found)
    });
    if let Spacing::Even(step) = &spacing
        && (step.value * rate.value - 1.0).abs() > 1e-6
    {
        return Err(refusals::header(rate.place, rate.text, "the rate of the times of the values"));
    }
    let unit = match said(header, "AMPLITUDEUNIT:") {
        Some((line, text)) => title::stated_unit(line, &text)?,
        None => Stated {
            value: AccelerationUnit::CentimetrePerSecondSquared,
            place: FilePlace::Line(header[0].number),
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
        remarks: remark.into_iter().chain(missing).collect(),
    })
}

/// The number after a key such as `SampleRate(Hz):`.
fn key(header: &[Line<'_>], key: &'static str) -> Result<Stated<f64>, Refused> {
    let (line, printed) = said(header, key).ok_or(refusals::no_key(key))?;
    let place = FilePlace::Line(line.number);
    let value = number(printed.as_bytes()).filter(|value| value.is_finite() && *value > 0.0);
    let value = value.ok_or_else(|| refusals::header(place, line.excerpt(), "a number above 0"))?;
    Ok(Stated {
        value,
        place,
        text: line.excerpt(),
    })
}
