//! CSMNC of China: about fifteen lines of titles, then values in columns.

use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, identity, values};
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Identity, Refused, Site};

/// Number of lines in which titles are searched.
const TITLES: usize = 25;

/// Words of the line with number and step.
const SPACED: &str = "EQUALLY SPACED INTERVALS OF:";

pub(super) const READER: Reader = Reader {
    format: Format::Csmnc,
    recognises: |file| {
        let titles = titles(file);
        title::line_with(titles, SPACED).is_some_and(|line| title::holds(line, "NO. OF POINTS:"))
    },
    components: |file| Ok(component(file).into_iter().collect()),
    read: |file, _| read(file),
    identity: identity_of,
};

/// The titles, up to the network's line below the line of number and step.
fn titles<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    let searched = &file.lines[..file.lines.len().min(TITLES)];
    let is_title = |line: &Line<'_>| line.bytes.iter().any(u8::is_ascii_uppercase) && number_first(*line).is_none();
    let last = searched.iter().rposition(is_title);
    &searched[..last.map_or(0, |last| last + 1)]
}

/// The first number of a line with several numbers.
fn number_first(line: Line<'_>) -> Option<f64> {
    let mut pieces = line.pieces();
    let first = pieces.next().and_then(number);
    first.filter(|_| pieces.next().is_some_and(|piece| number(piece).is_some()))
}

/// The direction of a title such as `COMP. EW`.
fn component(file: &File<'_>) -> Option<Component> {
    let titles = titles(file);
    let (line, name) = title::value_of(titles, "COMP.")?;
    let place = identity::behind(titles, "OBSERVING POINT:").unwrap_or_default();
    let component = Component::new(title::words(&name), FilePlace::Line(line.number));
    Some(component.at(Site::of_location(&place)))
}

fn identity_of(file: &File<'_>) -> Identity {
    let titles = titles(file);
    let station = identity::behind(titles, "STATION:");
    let event = title::line_with(titles, "EARTHQUAKE").map(Line::text);
    let time = titles.iter().find_map(|line| identity::first_time(&line.text()));
    Identity {
        station: station.and_then(|text| identity::text(text.split_whitespace().next()?)),
        event: event.as_deref().and_then(identity::text),
        time,
        ..Identity::default()
    }
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let titles = titles(file);
    let last = *needed(titles.last(), None, "its titles")?;
    let line_of = |key: &'static str| title::line_with(titles, key).ok_or(refusals::no_key(key));
    let line = line_of(SPACED)?;
    let unit = line_of("UNIT:")?;
    if !title::holds(unit, "ACCELERATION") {
        return Err(refusals::not_acceleration(
            FilePlace::Line(unit.number),
            unit.excerpt(),
            "the file of accelerations of the record",
        ));
    }
    let text = line.text();
    let behind = |word| title::after(&text, word).and_then(title::first_number);
    let step = behind(SPACED).and_then(|step| number(step.as_bytes()));
    let numbers = values::read(last, &file.lines[titles.len()..])?;
    let peak = title::value_of(titles, "PEAK VALUE:");
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(line, behind("NO. OF POINTS:").unwrap_or_default())?),
        time_step: Some(Spacing::Even(title::time_step(line, step)?)),
        scale: Scale::Unit(title::stated_unit(unit, title::after(&unit.text(), "UNIT:").unwrap_or_default())?),
        peak: peak.and_then(|(line, text)| title::peak(line, &text)),
        provenance: title::provenance(titles),
        remarks: Vec::new(),
    })
}
