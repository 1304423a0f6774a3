//! ESM and ITACA ASC: 64 lines of a key and a value, then a value to a line.

use super::columns::{decimal, leading_data};
use super::numbers::Values;
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, identity, title};
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Identity, Refused, Site};

/// Number of lines in which keys are searched; all known files have 64.
const HEADER: usize = 100;

/// Largest depth of a sensor that counts as at the ground \[m\].
const DEEP: f64 = 3.0;

pub(super) const READER: Reader = Reader {
    format: Format::Esm,
    recognises: |file| title::value_of(&file.lines[..file.lines.len().min(1)], "EVENT_NAME:").is_some(),
    components,
    read: |file, _| read(file),
    identity: identity_of,
};

fn header<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    let searched = &file.lines[..file.lines.len().min(HEADER)];
    let is_key = |line: &&Line<'_>| line.bytes.contains(&b':');
    &searched[..searched.iter().take_while(is_key).count()]
}

fn value<'t>(file: &File<'t>, key: &'static str) -> Result<(Line<'t>, String), Refused> {
    let header = header(file);
    title::value_of(header, key).ok_or(refusals::no_key(key))
}

fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let (line, name) = value(file, "STREAM:")?;
    let depth = value(file, "SENSOR_DEPTH_M:").ok();
    let depth = depth.map_or_else(String::new, |(_, depth)| depth);
    let is_deep = number(depth.as_bytes()).is_some_and(|depth| depth >= DEEP);
    let site = if is_deep {
        Site::Borehole(format!("SENSOR_DEPTH_M: {depth}"))
    } else {
        Site::Ground
    };
    Ok(vec![Component::new(name, FilePlace::Line(line.number)).at(site)])
}

fn identity_of(file: &File<'_>) -> Identity {
    let value = |key| value(file, key).map(|(_, value)| value).unwrap_or_default();
    let station = format!("{}.{}", value("NETWORK:"), value("STATION_CODE:"));
    let time = format!("{}_{}", value("EVENT_DATE_YYYYMMDD:"), value("EVENT_TIME_HHMMSS:"));
    Identity {
        station: identity::text(station.trim_matches('.')),
        event: identity::text(&value("EVENT_ID:")),
        time: identity::time(time.trim_matches('_')),
        ..Identity::default()
    }
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let header = header(file);
    let last = header[header.len() - 1];
    let (kind_line, kind) = value(file, "DATA_TYPE:")?;
    if !kind.eq_ignore_ascii_case("ACCELERATION") {
        return Err(refusals::not_acceleration(
            FilePlace::Line(kind_line.number),
            kind_line.excerpt(),
            "the .ACC.ASC file of the record",
        ));
    }
    let (count_line, count) = value(file, "NDATA:")?;
    let (step_line, step) = value(file, "SAMPLING_INTERVAL_S:")?;
    let (unit_line, unit) = value(file, "UNITS:")?;
    let peak = header.iter().find(|line| line.bytes.starts_with(b"PGA_"));
    let mut values = Values::default();
    for line in leading_data(&file.lines[header.len()..]) {
        values.push(*line, decimal(*line, 1, line.bytes)?, line.bytes)?;
    }
    let numbers = values.finish(last);
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(count_line, &count)?),
        time_step: Some(Spacing::Even(title::time_step(step_line, number(step.as_bytes()))?)),
        scale: Scale::Unit(title::stated_unit(unit_line, &unit)?),
        peak: peak.and_then(|line| title::peak(*line, line.text().split_once(':')?.1)),
        provenance: title::provenance(header),
        remarks: Vec::new(),
    })
}
