//! CSMIP (CDMG) volume 2. Each channel has titles and numbers, then blocks of acceleration, velocity and displacement; only acceleration is
//! read.
//!
//! The line above each block gives the number of values, their step, their unit and, in newer files, their Fortran format; older files have
//! 8F10.3.

use super::columns::{FixedColumns, leading_data};
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Peak, Reader, Scale, Spacing, Stated, identity, reading};
use crate::line::{Line, number};
use crate::{Direction, FilePlace, Identity, Refused, Site};

/// Lines of titles of a channel; 7 lines of whole numbers and 13 of others follow.
const TITLES: usize = 25;

/// Number of lines in which the end of a channel's header is searched.
const SEARCHED: usize = 80;

pub(super) const READER: Reader = Reader {
    format: Format::CsmipV2,
    recognises,
    components,
    read,
    identity: |file| identity_in(titles(file), 2),
};

pub(super) fn recognises(file: &File<'_>) -> bool {
    starts(&file.lines, 0)
}

/// The titles of the first channel.
pub(super) fn titles<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    &file.lines[..file.lines.len().min(TITLES)]
}

/// Whether a channel begins here: `CORRECTED ACCELEROGRAM`, and on the next line the uncorrected accelerogram that it was made from.
fn starts(lines: &[Line<'_>], index: usize) -> bool {
    let (Some(first), Some(second)) = (lines.get(index), lines.get(index + 1)) else {
        return false;
    };
    title::holds(*first, "CORRECTED ACCELEROGRAM")
        && !title::holds(*first, "UNCORRECTED ACCELEROGRAM")
        && title::holds(*second, "UNCORRECTED ACCELEROGRAM")
}

/// The lines of each channel.
fn channels<'l, 't>(file: &'l File<'t>) -> Vec<&'l [Line<'t>]> {
    super::blocks(&file.lines, |index| starts(&file.lines, index))
}

#[expect(clippy::unnecessary_wraps, reason = "one signature for all formats")]
pub(super) fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    Ok(channels(file).into_iter().map(component).collect())
}

/// The channel as named by the titles: `CHAN  1:  90 DEG` or `COMP N08W`.
pub(super) fn component(lines: &[Line<'_>]) -> Component {
    let titles = &lines[..lines.len().min(TITLES)];
    let named = titles.iter().find(|line| {
        let words = line.bytes.trim_ascii();
        ["CHAN", "COMP"]
            .iter()
            .any(|word| words.get(..4).is_some_and(|start| start.eq_ignore_ascii_case(word.as_bytes())))
    });
    let line = named.unwrap_or(&lines[0]);
    let text = line.text();
    let name = title::before(title::before(&text, "("), "LOCATION");
    let mut words: Vec<&str> = name.split_whitespace().collect();
    if words.first().is_some_and(|word| word.eq_ignore_ascii_case("COMP")) {
        // The length of the title may follow; or the direction may, after the number of the channel.
        let is_length = |word: &&str| word.bytes().all(|byte| byte.is_ascii_digit());
        let kept = if words
            .get(2)
            .is_some_and(|word| !is_length(word) && Direction::of_component(word).is_some())
        {
            3
        } else {
            2
        };
        words.truncate(kept);
    }
    let location = title::after(&text, "LOCATION:").unwrap_or_default();
    Component::new(words.join(" "), FilePlace::Line(line.number)).at(Site::of_location(location))
}

/// Station, event and its time: the event is in the title with this index, from 0, and its time in the next title.
pub(super) fn identity_in(titles: &[Line<'_>], event: usize) -> Identity {
    let line = |index: usize| titles.get(index).map(|line| line.text());
    let time = line(event + 1).unwrap_or_default();
    Identity {
        station: identity::numbered(titles, "STATION"),
        event: line(event).and_then(|event| identity::text(title::before(&event, "("))),
        time: identity::time(title::before(&time, "(")),
        ..Identity::default()
    }
}

pub(super) fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let channels = channels(file);
    let channel = needed(channels.get(index), file.lines.last().copied(), "a channel")?;
    let titles = &channel[..channel.len().min(TITLES)];
    let header = channel.iter().take(SEARCHED).position(|line| is_block(*line));
    let header = needed(header, channel.last().copied(), "a line such as `3251 POINTS OF ACCEL DATA`")?;
    let (line, data) = (channel[header], &channel[header + 1..]);
    let text = line.text();
    let n_samples = title::first_number(&text).unwrap_or_default();
    let spacing = title::after(&text, "SPACED AT").unwrap_or_default();
    let step = title::first_number(spacing).and_then(|step| number(step.as_bytes()));
    let behind = title::after(spacing, "SEC").unwrap_or_default();
    let named = FixedColumns::named_in(line);
    let columns = named.unwrap_or(FixedColumns::new(8, 10));
    let numbers = columns.numbers(line, leading_data(data), &[])?;
    let peak = title::line_with(titles, "PEAK ACCELERATION");
    let peak = peak.and_then(|line| title::peak(line, title::after(&line.text(), "PEAK ACCELERATION")?));
    let cut = match named {
        Some(columns) => columns.to_string(),
        None => format!("{columns}, as usual: the line does not say"),
    };
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(line, n_samples)?),
        time_step: Some(Spacing::Even(title::time_step(line, step)?)),
        scale: scale(line, behind, peak.as_ref())?,
        peak,
        provenance: title::provenance(titles),
        remarks: vec![reading("columns", Some(FilePlace::Line(line.number)), &cut)],
    })
}

/// The unit after the step of a block's line, else the unit of the peak in the titles; unknown if both are missing.
fn scale(line: Line<'_>, behind: &str, peak: Option<&Peak>) -> Result<Scale, Refused> {
    let format = behind.rfind('(').filter(|_| FixedColumns::named_in(line).is_some());
    let unit = &behind[..format.unwrap_or(behind.len())];
    if unit.bytes().any(|byte| byte.is_ascii_alphabetic()) {
        return Ok(Scale::Unit(title::stated_unit(line, unit)?));
    }
    let of_peak = peak.and_then(|peak| Some((peak.unit?, &peak.stated)));
    Ok(of_peak.map_or(Scale::Acceleration, |(unit, stated)| {
        Scale::Unit(Stated {
            value: unit,
            place: stated.place,
            text: stated.text.clone(),
        })
    }))
}

fn is_block(line: Line<'_>) -> bool {
    title::holds(line, "POINTS OF ACC") && title::holds(line, "SPACED AT") && !title::holds(line, "POINTS OF ACCEL, VELOC")
}
