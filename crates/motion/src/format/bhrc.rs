//! Volume 1 of BHRC, Iran: each channel has 13 titles, seven lines of whole numbers and seven of others, then the values.
//!
//! The ninth number with a point is the rate; the lines show only the first six of its eight digits.

use super::csmip_v1::scale;
use super::csmip_v2::component;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Spacing, identity, values};
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Identity, Refused};

/// Number of title lines of a channel, of lines of its header, and of lines up to the one that begins with the rate.
const TITLES: usize = 13;
const HEADER: usize = 27;
const RATE: usize = 21;

pub(super) const READER: Reader = Reader {
    format: Format::Bhrc,
    recognises: |file| file.lines.first().is_some_and(|line| starts(*line)),
    components: |file| Ok(components(file)),
    read,
    identity: |file| identity_of(&file.lines),
};

fn starts(line: Line<'_>) -> bool {
    title::holds(line, "VOL1DS FILE:")
}

fn channels<'l, 't>(file: &'l File<'t>) -> Vec<&'l [Line<'t>]> {
    super::blocks(&file.lines, |index| starts(file.lines[index]))
}

/// The time follows a key; the station is on a line with its coordinates.
fn identity_of(lines: &[Line<'_>]) -> Identity {
    let titles = &lines[..lines.len().min(TITLES)];
    let station = title::line_with(titles, "STATION").map(Line::text);
    let time = identity::behind(titles, "Origin Time");
    Identity {
        station: station.and_then(|text| identity::text(title::before(&text, "STATION"))),
        time: time.as_deref().and_then(identity::time),
        ..Identity::default()
    }
}

fn components(file: &File<'_>) -> Vec<Component> {
    let titles = |channel: &[Line<'_>]| component(&channel[..channel.len().min(TITLES)]);
    channels(file).into_iter().map(titles).collect()
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let channels = channels(file);
    let channel = needed(channels.get(index), file.lines.last().copied(), "a channel")?;
    let split = channel.split_at_checked(HEADER);
    let (header, data) = needed(split, channel.last().copied(), "the values")?;
    let titles = &header[..TITLES];
    let line = title::line_with(titles, "NO. OF POINTS").ok_or(refusals::no_key("NO. OF POINTS"))?;
    let text = line.text();
    let behind = |word| title::after(&text, word).and_then(title::first_number);
    let count = title::count(line, behind("NO. OF POINTS").unwrap_or_default())?;
    let duration = behind("DURATION").and_then(|duration| number(duration.as_bytes()));
    let rate = header[RATE].pieces().next().and_then(number);
    let step = title::time_step(header[RATE], rate.map(|rate| 1.0 / rate))?;
    // Files may count the last step or not.
    let is_near = |duration: f64| (duration - count.value as f64 * step.value).abs() < 1.5 * step.value;
    if !duration.is_none_or(is_near) {
        return Err(refusals::header(
            FilePlace::Line(line.number),
            line.excerpt(),
            "the duration that the number of points and the rate of the header give",
        ));
    }
    let numbers = values::read(header[HEADER - 1], data)?;
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(Spacing::Even(step)),
        scale: scale(titles)?,
        peak: None,
        provenance: title::provenance(titles),
        remarks: Vec::new(),
    })
}
