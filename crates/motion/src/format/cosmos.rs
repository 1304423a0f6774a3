//! COSMOS 1.2, volumes 0 to 2. Each channel has titles, whole numbers, numbers with a point, comments and the values. A line above each
//! block gives its print format.
//!
//! The 62nd number with a point is the time step in milliseconds, the 64th the peak. The line above the values gives their number and a
//! code for their unit. A volume 2 may have velocity and displacement as further channels; only those of acceleration are listed. Volume 1
//! was available, volumes 0 and 2 were not.

use super::columns::{FixedColumns, leading_data};
use super::numbers::{is_mark, last_digit};
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Peak, Reader, Scale, Spacing, Stated, identity, reading};
use crate::line::{Line, number};
use crate::refusals;
use crate::{AccelerationUnit, Direction, FilePlace, Identity, Refused, Site};

pub(super) const READER: Reader = Reader {
    format: Format::Cosmos,
    recognises: |file| file.lines.first().is_some_and(|line| starts(*line)),
    components,
    read,
    identity: identity_of,
};

fn starts(line: Line<'_>) -> bool {
    title::holds(line, "(FORMAT V01") && title::holds(line, "TEXT LINES")
}

/// The channels that hold accelerations.
fn channels<'l, 't>(file: &'l File<'t>) -> Result<Vec<&'l [Line<'t>]>, Refused> {
    let mut channels = super::blocks(&file.lines, |index| starts(file.lines[index]));
    channels.retain(|channel| title::holds(channel[0], "ACCEL"));
    if channels.is_empty() {
        let line = file.lines[0];
        return Err(refusals::not_acceleration(
            FilePlace::Line(line.number),
            line.excerpt(),
            "the channels of acceleration of the record",
        ));
    }
    Ok(channels)
}

fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let channels = channels(file)?;
    Ok(channels.into_iter().map(component).collect())
}

/// The channel as named by the titles: `Sta Cha:  1: 340 deg`, up to the text in brackets. If that has no direction, the code of the
/// channel in the comments or at the end: `|<SCNL>BMR.BNZ.AK.--`, `End-of-data for ChanBNZ acceleration`.
fn component(channel: &[Line<'_>]) -> Component {
    let titles = &channel[..channel.len().min(13)];
    let line = title::line_with(titles, "STA CHA");
    let line = line.or_else(|| title::line_with(titles, "CHAN")).unwrap_or(channel[0]);
    let text = line.text();
    let name = title::words(text.split(['(', ',']).next().unwrap_or_default());
    let location = title::after(&text, "LOCATION:").unwrap_or_default();
    let site = Site::of_location(location);
    if Direction::of_component(&name).is_none()
        && let Some((line, code)) = code(channel)
    {
        return Component::new(code, FilePlace::Line(line.number)).at(site);
    }
    Component::new(name, FilePlace::Line(line.number)).at(site)
}

/// Number of lines in which the code of a channel is searched.
const CODES: usize = 100;

/// The code of the channel, if it tells a direction.
fn code<'t>(channel: &[Line<'t>]) -> Option<(Line<'t>, String)> {
    let head = channel.iter().take(CODES);
    let mut lines = head.chain(channel.iter().rev().take(3));
    lines.find_map(|line| {
        let text = line.text();
        let words = |key| {
            let behind = title::after(&text, key)?;
            Some(behind.split(|letter: char| !letter.is_ascii_alphanumeric()))
        };
        // The forms are station, channel, network and location; the same starting with the network; and the channel alone.
        let code = words("<SCNL>")
            .and_then(|mut words| words.nth(1))
            .or_else(|| words("RCRDID:")?.rfind(|word| word.len() == 3))
            .or_else(|| words("END-OF-DATA FOR CHAN")?.next())?;
        let tells = code.len() == 3 && Direction::of_component(code).is_some();
        tells.then(|| (*line, code.to_owned()))
    })
}

/// Station, event and its time, from the titles of the first channel.
fn identity_of(file: &File<'_>) -> Identity {
    let titles = &file.lines[..file.lines.len().min(13)];
    let behind = |key: &str| {
        let line = title::line_with(titles, key)?;
        Some(title::after(&line.text(), key)?.to_owned())
    };
    let station = behind("CODE:");
    let event = titles.get(1).map(|line| line.text());
    Identity {
        station: station.and_then(|text| identity::text(text.split_whitespace().next()?)),
        event: event.and_then(|event| identity::text(&event)),
        time: behind("ORIGIN:").and_then(|text| identity::first_time(&text)),
        ..Identity::default()
    }
}

/// A block of a channel: the line above it, its own lines, and the remaining lines.
struct Block<'l, 't> {
    line: Line<'t>,
    lines: &'l [Line<'t>],
    rest: &'l [Line<'t>],
}

/// Splits off a block; the line above gives its number of lines after a word.
fn block<'l, 't>(lines: &'l [Line<'t>], word: &str) -> Result<Block<'l, 't>, Refused> {
    let (line, rest) = needed(lines.split_first(), None, "a block of its header")?;
    let text = line.text();
    let place = FilePlace::Line(line.number);
    let n_lines = title::after(&text, word).and_then(title::first_number);
    let n_lines = n_lines.and_then(|number| number.parse().ok());
    let n_lines: usize = n_lines.ok_or_else(|| refusals::header(place, line.excerpt(), "the number of lines of the block below"))?;
    let split = rest.split_at_checked(n_lines);
    let (lines, rest) = needed(split, rest.last().copied().or(Some(*line)), "the end of its header")?;
    Ok(Block { line: *line, lines, rest })
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let channels = channels(file)?;
    let channel = needed(channels.get(index), file.lines.last().copied(), "a channel")?;
    let n_titles = title::after(&channel[0].text(), "WITH").and_then(|text| title::first_number(text)?.parse().ok());
    let titles = channel.get(..n_titles.unwrap_or(13));
    let titles = needed(titles, channel.last().copied(), "its titles")?;
    let whole = block(&channel[titles.len()..], "FOLLOW ON")?;
    let real = block(whole.rest, "FOLLOW ON")?;
    let comments = block(real.rest, "")?;
    let last = comments.lines.last().unwrap_or(&comments.line);
    let (line, data) = needed(comments.rest.split_first(), Some(*last), "the values")?;
    let scale = scale(*line)?;
    let unknown = unknown(titles);
    let marks = [unknown];
    // In counts the mark may be a valid value.
    let marks = if matches!(scale, Scale::Counts(_)) { &[][..] } else { &marks[..] };
    let columns = FixedColumns::named_in(*line);
    let columns = columns.ok_or_else(|| {
        refusals::header(
            FilePlace::Line(line.number),
            line.excerpt(),
            "a Fortran format such as Format=(8F10.5)",
        )
    })?;
    let numbers = columns.numbers(*line, leading_data(data), marks)?;
    let header = Header::new(&real, unknown);
    let time_step = header.stated(62).map(|step| Stated {
        value: step.value / 1000.0,
        ..step
    });
    let text = line.text();
    check_duration(*line, numbers.values.len(), time_step.as_ref())?;
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(*line, title::first_number(&text).unwrap_or_default())?),
        time_step: time_step.map(Spacing::Even),
        scale,
        peak: header.stated(64).map(|stated| Peak {
            digit: last_digit(stated.value.to_string().as_bytes()),
            stated,
            unit: None,
        }),
        provenance: title::provenance(titles),
        remarks: vec![reading("columns", Some(FilePlace::Line(line.number)), &columns.to_string())],
    })
}

/// The numbers with a point, and the mark of unknown ones.
struct Header<'l, 't> {
    numbers: Vec<Option<f64>>,
    lines: &'l [Line<'t>],
    per_line: usize,
    unknown: f64,
}

impl<'l, 't> Header<'l, 't> {
    fn new(block: &Block<'l, 't>, unknown: f64) -> Self {
        let columns = FixedColumns::named_in(block.line).unwrap_or(FixedColumns::new(5, 15));
        Self {
            numbers: columns.header(block.lines),
            lines: block.lines,
            per_line: columns.per_line,
            unknown,
        }
    }

    /// The n-th number, from 1; `None` if it is marked as unknown.
    fn stated(&self, n: usize) -> Option<Stated<f64>> {
        let value = self.numbers.get(n - 1).copied().flatten()?;
        let line = self.lines.get((n - 1) / self.per_line)?;
        (!is_mark(value, self.unknown) && value.is_finite()).then(|| Stated {
            value,
            place: FilePlace::Line(line.number),
            text: format!("number {n} of the block: {value}"),
        })
    }
}

/// The mark of unknown values, from a title such as `Values used when parameter or data value is unknown/unspecified:   -999, -999.0`.
fn unknown(titles: &[Line<'_>]) -> f64 {
    let line = title::line_with(titles, "UNKNOWN");
    let marks = line.and_then(|line| {
        let text = line.text();
        let mark = text.rsplit([',', ' ']).find(|word| !word.is_empty())?;
        number(mark.as_bytes())
    });
    marks.unwrap_or(-999.0)
}

/// Quantity and unit of the values, from a line such as `7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)`.
fn scale(line: Line<'_>) -> Result<Scale, Refused> {
    let place = FilePlace::Line(line.number);
    let text = line.excerpt();
    if !title::holds(line, "ACC") {
        return Err(refusals::not_acceleration(
            place,
            text,
            "the channels of acceleration of the record",
        ));
    }
    let whole = line.text();
    let units = title::after(&whole, "UNITS").unwrap_or_default();
    let code = units.split_once('(').and_then(|(_, rest)| rest.split_once(')'));
    // `cm/sec2(04)` without the sign before it and the format after it.
    let spelt = title::before(units, ",FORMAT").trim_start_matches(['=', ' ']);
    let unit = match code.map_or("", |(code, _)| code.trim()) {
        "02" | "2" => AccelerationUnit::StandardGravity,
        "04" | "4" | "10" => AccelerationUnit::CentimetrePerSecondSquared,
        "11" => AccelerationUnit::MilliG,
        "50" => {
            return Ok(Scale::Counts(Stated { value: (), place, text }));
        }
        _ => return Err(refusals::unknown_unit(place, text)),
    };
    Ok(Scale::Unit(Stated {
        value: unit,
        place,
        text: spelt.to_owned(),
    }))
}

/// Compares number and time step with `approx   70 secs`. Files may count the last step or not.
fn check_duration(line: Line<'_>, n_samples: usize, time_step: Option<&Stated<f64>>) -> Result<(), Refused> {
    let text = line.text();
    let stated = title::after(&text, "APPROX").and_then(title::first_number);
    let stated = stated.and_then(|stated| number(stated.as_bytes()));
    let (Some(stated), Some(step)) = (stated, time_step) else {
        return Ok(());
    };
    let found = n_samples as f64 * step.value;
    if (found - stated).abs() <= 1.0 + step.value {
        return Ok(());
    }
    Err(refusals::header(
        FilePlace::Line(line.number),
        line.excerpt(),
        "a duration that the number of values and the time step of the header give",
    ))
}
