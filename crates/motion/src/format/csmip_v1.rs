//! CSMIP (CDMG) volume 1: uncorrected accelerograms, per channel 13 titles and 14 lines of numbers, then the values.
//!
//! Newer files have a line such as `13200 Accelerogram points at 200 pts/sec in units of g. Format:(8f9.6)` or `12001 POINTS OF ACCEL DATA
//! EQUALLY SPACED AT .005 SEC. (UNITS: G)` above the values. Older files have pairs of time and value, five to a line of 10F7 (USC:
//! 1X,10F7). Most have a title such as `UNITS ARE SEC AND G/10`; otherwise the unit must be declared.

use super::columns::{FixedColumns, decimal, leading_data};
use super::csmip_v2::{component, identity_in};
use super::numbers::Values;
use super::time_column::TimeColumn;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Peak, Reader, Scale, Spacing, Stated, reading};
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Refused};

/// Lines of titles of a channel, and of all of its header.
const TITLES: usize = 13;
const HEADER: usize = 27;

/// Pairs of time and value.
const PAIRS: FixedColumns = FixedColumns::new(10, 7);

pub(super) const READER: Reader = Reader {
    format: Format::CsmipV1,
    recognises,
    components,
    read,
    identity: |file| identity_in(titles(file), 1),
};

pub(super) fn recognises(file: &File<'_>) -> bool {
    file.lines.first().is_some_and(|line| starts(*line))
}

/// The titles of the first channel.
pub(super) fn titles<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    &file.lines[..file.lines.len().min(TITLES)]
}

fn starts(line: Line<'_>) -> bool {
    title::holds(line, "UNCORRECTED ACCELEROGRAM")
}

fn channels<'l, 't>(file: &'l File<'t>) -> Vec<&'l [Line<'t>]> {
    super::blocks(&file.lines, |index| starts(file.lines[index]))
}

#[expect(clippy::unnecessary_wraps, reason = "one signature for all formats")]
pub(super) fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let channels = channels(file);
    Ok(channels
        .into_iter()
        .map(|channel| component(&channel[..channel.len().min(TITLES)]))
        .collect())
}

pub(super) fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let channels = channels(file);
    let channel = needed(channels.get(index), file.lines.last().copied(), "a channel")?;
    let next = needed(channel.get(HEADER), channel.last().copied(), "the values")?;
    let (header, data) = channel.split_at(HEADER);
    if title::holds(*next, "POINTS") {
        evenly_spaced(header, *next, &data[1..])
    } else {
        pairs(header, data)
    }
}

fn evenly_spaced(header: &[Line<'_>], line: Line<'_>, data: &[Line<'_>]) -> Result<Draft, Refused> {
    let titles = &header[..TITLES];
    let text = line.text();
    let n_samples = title::first_number(&text).unwrap_or_default();
    let behind = |word| {
        let printed = title::after(&text, word).and_then(title::first_number)?;
        number(printed.as_bytes())
    };
    let step = behind("POINTS AT").map(|rate| 1.0 / rate);
    let step = step.or_else(|| behind("SPACED AT"));
    let unit = title::after(&text, "UNITS").or_else(|| title::after(&text, " IN "));
    let columns = FixedColumns::named_in(line).unwrap_or(FixedColumns::new(8, 9));
    let numbers = columns.numbers(line, leading_data(data), &[])?;
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(line, n_samples)?),
        time_step: Some(Spacing::Even(title::time_step(line, step)?)),
        scale: Scale::Unit(title::stated_unit(line, unit.unwrap_or_default())?),
        peak: peak(titles),
        provenance: title::provenance(titles),
        remarks: Vec::new(),
    })
}

/// Times and values in pairs.
#[derive(Default)]
struct Pairs<'t> {
    times: TimeColumn,
    values: Values<'t>,
}

impl<'t> Pairs<'t> {
    fn new(lines: &[Line<'t>]) -> Result<Self, Refused> {
        let mut pairs = Self::default();
        let columns = lines.first().map_or(PAIRS, |line| PAIRS.led_in_by(*line));
        for line in lines {
            let fields: Vec<&[u8]> = columns.fields(*line).collect();
            for (index, pair) in fields.chunks(2).enumerate() {
                let &[time, value] = pair else {
                    return Err(refusals::header(
                        FilePlace::Line(line.number),
                        line.excerpt(),
                        "a value behind each time",
                    ));
                };
                decimal(*line, 2 * index + 1, time)?;
                pairs.times.push(*line, time)?;
                let number = decimal(*line, 2 * index + 2, value)?;
                pairs.values.push(*line, number, value)?;
            }
        }
        Ok(pairs)
    }
}

fn pairs(header: &[Line<'_>], data: &[Line<'_>]) -> Result<Draft, Refused> {
    let titles = &header[..TITLES];
    let data = leading_data(data);
    let Pairs { times, values } = Pairs::new(data)?;
    let numbers = values.finish(header[HEADER - 1]);
    let mut values = numbers.values;
    let count = n_pairs(header)?;
    if values.len() != count.value {
        return Err(refusals::sample_count(numbers.end, values.len(), count.value));
    }
    let (time_step, rest) = times.into_step_from_anywhere(&mut values)?;
    // A state of rest may precede the pairs that were counted above.
    let count = Stated {
        value: values.len(),
        ..count
    };
    let remark = reading(
        "columns",
        Some(FilePlace::Line(header[HEADER - 1].number + 1)),
        "pairs of time and value",
    );
    Ok(Draft {
        values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(time_step),
        scale: scale(titles)?,
        peak: peak(titles),
        provenance: title::provenance(titles),
        remarks: rest.into_iter().chain([remark]).collect(),
    })
}

/// The unit of a title such as `UNITS ARE SEC AND G/10`; unknown if no title names units.
pub(super) fn scale(titles: &[Line<'_>]) -> Result<Scale, Refused> {
    let Some(line) = title::line_with(titles, "UNITS") else {
        return Ok(Scale::Unknown);
    };
    let text = line.text();
    let units = title::after(&text, "UNITS").unwrap_or_default();
    Ok(Scale::Unit(title::stated_unit(line, units)?))
}

/// The number of pairs from a title such as `NO. OF POINTS =   8820`, else from the 28th whole number.
fn n_pairs(header: &[Line<'_>]) -> Result<Stated<usize>, Refused> {
    if let Some(line) = title::line_with(&header[..TITLES], "POINTS") {
        let text = line.text();
        let count = title::after(&text, "POINTS").and_then(title::first_number);
        return title::count(line, count.unwrap_or_default());
    }
    let line = header[TITLES + 1];
    let whole = FixedColumns::new(16, 5).header(&header[TITLES..TITLES + 7]);
    let count = whole.get(27).copied().flatten();
    title::count(line, &count.map(|count| count.to_string()).unwrap_or_default())
}

/// The peak from a title such as `UNCOR MAX  =  -.275 G`.
fn peak(titles: &[Line<'_>]) -> Option<Peak> {
    titles.iter().find_map(|line| {
        let text = line.text();
        let value = title::after(&text, "MAX")?.trim_start().strip_prefix('=')?.to_owned();
        title::peak(*line, &value)
    })
}
