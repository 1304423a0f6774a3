//! Text of the US Geological Survey of the 1980s: blocks of seven titles with values; only acceleration is read.

use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, identity, values};
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Identity, Refused, Site};

/// Number of title lines of a block, and index of the line with the rate, the last but one.
const TITLES: usize = 7;
const RATE: usize = 5;

pub(super) const READER: Reader = Reader {
    format: Format::UsgsText,
    recognises: |file| is_block(&file.lines, 0),
    components: |file| Ok(components(file)),
    read,
    identity: identity_of,
};

/// Whether a block begins here: rate and kind are on its sixth line, number and units on its seventh.
fn is_block(lines: &[Line<'_>], index: usize) -> bool {
    let Some(titles) = lines.get(index..index + TITLES) else {
        return false;
    };
    title::holds(titles[RATE], "SAMPLES/SEC=")
        && title::holds(titles[RATE], "DATA TYPE=")
        && title::holds(titles[TITLES - 1], "NO OF POINTS=")
}

/// The blocks of accelerations.
fn channels<'l, 't>(file: &'l File<'t>) -> Vec<&'l [Line<'t>]> {
    let mut blocks = super::blocks(&file.lines, |index| is_block(&file.lines, index));
    blocks.retain(|block| title::holds(block[RATE], "DATA TYPE=AC"));
    blocks
}

fn components(file: &File<'_>) -> Vec<Component> {
    let component = |block: &[Line<'_>]| {
        let line = title::line_with(&block[..TITLES], "COMPONENT=").unwrap_or(block[1]);
        let text = line.text();
        Component::new(
            title::words(title::after(&text, "COMPONENT=").unwrap_or(&text)),
            FilePlace::Line(line.number),
        )
        .at(Site::of_location(block[0].text().rsplit_once(',').map_or("", |(_, place)| place)))
    };
    channels(file).into_iter().map(component).collect()
}

/// The first title has the station before the place of the sensor, the third the event.
fn identity_of(file: &File<'_>) -> Identity {
    let said = |index: usize| file.lines.get(index).map(|line| line.text().into_owned());
    Identity {
        station: said(0).as_deref().and_then(identity::text),
        event: said(2).as_deref().and_then(identity::text),
        ..Identity::default()
    }
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let channels = channels(file);
    let line = file.lines[RATE];
    let Some(block) = channels.get(index) else {
        return Err(refusals::not_acceleration(
            FilePlace::Line(line.number),
            line.excerpt(),
            "the file with DATA TYPE=AC",
        ));
    };
    let (titles, data) = block.split_at(TITLES);
    let rate_text = titles[RATE].text();
    let rate = title::after(&rate_text, "SAMPLES/SEC=").and_then(title::first_number);
    let rate = rate.and_then(|rate| number(rate.as_bytes()));
    let last = titles[TITLES - 1];
    let text = last.text();
    let count = title::after(&text, "NO OF POINTS=").and_then(title::first_number);
    let unit = needed(title::after(&text, "UNITS="), Some(last), "its units")?;
    let numbers = values::read(last, data)?;
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(last, count.unwrap_or_default())?),
        time_step: Some(Spacing::Even(title::time_step(titles[RATE], rate.map(|rate| 1.0 / rate))?)),
        // The units are those of accelerations, velocities and displacements: the first one counts.
        scale: Scale::Unit(title::stated_unit(last, unit)?),
        peak: None,
        provenance: title::provenance(titles),
        remarks: Vec::new(),
    })
}
