//! USGS SMC: titles, descriptive numbers, comments after `|`, then eight values of ten bytes per line.
//!
//! The numbers in the header give the number of comments, the number of values and the rate; they begin with the marks of missing values.
//! Without a rate the values are pairs of time and value. The format fixes the unit.

use super::columns::{FixedColumns, leading_data};
use super::numbers::is_mark;
use super::time_column::TimeColumn;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Peak, Reader, Scale, Spacing, Stated, identity};
use crate::line::{Line, number};
use crate::refusals;
use crate::{AccelerationUnit, FilePlace, Identity, Refused, Site};

/// Numbers of title lines, of lines of whole numbers, and of lines of numbers with a point.
const TITLES: usize = 11;
const WHOLE: usize = 6;
const REAL: usize = 10;

pub(super) const READER: Reader = Reader {
    format: Format::UsgsSmc,
    recognises,
    components,
    read: |file, _| read(file),
    identity: |file| identity_of(&file.lines),
};

/// The component in the title, such as `component=  360`, if there is one; `UP` if the header describes an upright sensor.
#[expect(clippy::unnecessary_wraps, reason = "one signature for all formats")]
fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let titles = &file.lines[..file.lines.len().min(TITLES)];
    let whole = file.lines.get(TITLES..TITLES + WHOLE);
    let numbers = whole.map(|lines| FixedColumns::new(8, 10).header(lines));
    // The 13th number is the angle from upright, in degrees.
    let angle = numbers.and_then(|numbers| number_of(&numbers, 13));
    let upright = angle.is_some_and(|angle| [0.0, 180.0].iter().any(|up| is_mark(angle, *up)));
    let line = title::line_with(titles, "COMPONENT=");
    let stated = line.and_then(|line| {
        let text = line.text();
        let name = title::words(title::after(&text, "COMPONENT=")?);
        Some(name).filter(|name| !name.is_empty())
    });
    // The place of the sensor follows the last comma of the station: `Del Valle Dam, crest`.
    let station = station(titles).unwrap_or_default();
    let site = Site::of_location(station.rsplit_once(',').map_or("", |(_, place)| place));
    let component = |name: String, line: usize| Component::new(name, FilePlace::Line(line)).at(site.clone());
    // A number would be the azimuth of an upright sensor, which has no meaning.
    let stated = stated.filter(|name| !upright || number(name.as_bytes()).is_none());
    let line = line.or(titles.last().copied());
    let line = line.map_or(1, |line| line.number);
    let of_angle = whole.map_or(line, |lines| lines[1].number);
    Ok(match stated {
        Some(name) => vec![component(name, line)],
        None if upright => vec![component("UP".to_owned(), of_angle)],
        None => Vec::new(),
    })
}

/// The station in the title.
fn station(titles: &[Line<'_>]) -> Option<String> {
    let line = title::line_with(titles, "STATION =")?;
    let text = line.text();
    let station = title::after(&text, "STATION =")?;
    Some(title::before(station, "COMPONENT=").trim().to_owned())
}

/// Station, and event with its time: `1989  10  18    0004 Loma Prieta, CA`.
fn identity_of(lines: &[Line<'_>]) -> Identity {
    let titles = &lines[..lines.len().min(TITLES)];
    let event = titles.get(3).map(|line| line.text());
    Identity {
        station: station(titles).as_deref().and_then(identity::text),
        event: event.and_then(|event| identity::text(event.trim_matches('*'))),
        ..Identity::default()
    }
}

/// Whether the first line is a stage from 1 to 9 with its name, and the second has a star.
fn recognises(file: &File<'_>) -> bool {
    let [first, second, ..] = file.lines[..] else {
        return false;
    };
    let title = first.text();
    let mut words = title.split_whitespace();
    let stage = words
        .next()
        .is_some_and(|word| word.len() == 1 && word.as_bytes()[0].is_ascii_digit());
    stage && words.next().is_some_and(|word| word.bytes().all(|byte| byte.is_ascii_alphabetic())) && second.bytes.trim_ascii() == b"*"
}

/// The header: titles, whole numbers and numbers with a point.
struct Header<'l, 't> {
    titles: &'l [Line<'t>],
    whole_lines: &'l [Line<'t>],
    real_lines: &'l [Line<'t>],
    whole: Vec<Option<f64>>,
    real: Vec<Option<f64>>,
    /// Marks of missing values.
    missing: Vec<f64>,
}

impl<'l, 't> Header<'l, 't> {
    /// Splits the header from the lines after it.
    fn split(lines: &'l [Line<'t>]) -> Result<(Self, &'l [Line<'t>]), Refused> {
        let split = lines.split_at_checked(TITLES + WHOLE + REAL);
        let (header, rest) = needed(split, lines.last().copied(), "the numbers of its header")?;
        let (titles, numbers) = header.split_at(TITLES);
        let (whole_lines, real_lines) = numbers.split_at(WHOLE);
        let whole = FixedColumns::new(8, 10).header(whole_lines);
        let real = FixedColumns::new(5, 15).header(real_lines);
        let missing = [whole[..].first(), real[..].first()];
        let missing = missing.into_iter().filter_map(|mark| mark.copied().flatten());
        let missing = missing.chain([-32768.0, 1.7e38]).collect();
        let header = Self {
            titles,
            whole_lines,
            real_lines,
            whole,
            real,
            missing,
        };
        Ok((header, rest))
    }

    /// Splits off the comments. The 16th whole number, counted from 1, is their number.
    fn comments(&self, rest: &'l [Line<'t>]) -> Result<(&'l [Line<'t>], &'l [Line<'t>]), Refused> {
        let stated = number_of(&self.whole, 16).filter(|count| *count >= 0.0);
        let is_comment = |line: &&Line<'_>| line.bytes.starts_with(b"|");
        let found = rest.iter().take_while(is_comment).count();
        if is_mark(found as f64, stated.unwrap_or(0.0)) {
            return Ok(rest.split_at(found));
        }
        Err(refusals::header(
            FilePlace::Line(self.whole_lines[1].number),
            self.whole_lines[1].excerpt(),
            "the number of comment lines that follow as the eighth",
        ))
    }

    /// The 17th whole number: the number of values.
    fn count(&self) -> Result<Stated<usize>, Refused> {
        let count = number_of(&self.whole, 17).map(|count| count.to_string());
        title::count(self.whole_lines[2], &count.unwrap_or_default())
    }

    /// The second number with a point, the rate in samples per second, as a time step; `None` if it is marked as missing.
    fn time_step(&self) -> Result<Option<Stated<f64>>, Refused> {
        let rate = number_of(&self.real, 2);
        let is_missing = rate.is_some_and(|rate| self.missing.iter().any(|mark| is_mark(rate, *mark)));
        if is_missing {
            return Ok(None);
        }
        title::time_step(self.real_lines[0], rate.map(|rate| 1.0 / rate)).map(Some)
    }
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let first = file.lines[0];
    let is_unknown = first.bytes.starts_with(b"0") && title::holds(first, "UNKNOWN");
    if !(title::holds(first, "ACCELEROGRAM") || is_unknown) {
        return Err(refusals::not_acceleration(
            FilePlace::Line(first.number),
            first.excerpt(),
            "the accelerogram of the record",
        ));
    }
    let (header, rest) = Header::split(&file.lines)?;
    let mut count = header.count()?;
    let (comments, data) = header.comments(rest)?;
    let data = leading_data(data);
    let columns = data_columns(data);
    let above = file.lines[TITLES + WHOLE + REAL - 1];
    let numbers = columns.numbers(above, data, &header.missing)?;
    let mut values = numbers.values;
    let mut remark = None;
    let spacing = if let Some(step) = header.time_step()? {
        Spacing::Even(step)
    } else {
        let (times, of_pairs) = pairs(data, columns, &count)?;
        values = of_pairs;
        if !times.rise() {
            let line = header.real_lines[0];
            return Err(refusals::header(
                FilePlace::Line(line.number),
                line.excerpt(),
                "a number of samples in a second, or below the header pairs of time and value,",
            ));
        }
        let spacing = if times.have_ties() {
            times.into_uneven()
        } else {
            let (spacing, rest) = times.into_step_from_anywhere(&mut values)?;
            remark = rest;
            spacing
        };
        count.value = values.len();
        spacing
    };
    Ok(Draft {
        values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(spacing),
        scale: scale(first, comments, is_unknown),
        peak: peak(&header.real, header.real_lines),
        provenance: title::provenance(header.titles),
        remarks: remark.into_iter().collect(),
    })
}

/// The columns of the values: five of fourteen bytes per line, as some programs write them, or eight of ten.
fn data_columns(data: &[Line<'_>]) -> FixedColumns {
    let wide = FixedColumns::new(5, 14);
    let is_wide = data.first().is_some_and(|line| {
        let fields: Vec<&[u8]> = wide.fields(*line).collect();
        fields.len() > 1 && fields.iter().all(|field| field.len() == 14 && number(field).is_some())
    });
    if is_wide { wide } else { FixedColumns::new(8, 10) }
}

/// The unit, which the format fixes for accelerations. A file of type `UNKNOWN` must speak of them in its comments.
fn scale(first: Line<'_>, comments: &[Line<'_>], is_unknown: bool) -> Scale {
    let says = title::line_with(comments, "ACCELER");
    let line = if is_unknown { says } else { Some(first) };
    let text = if is_unknown {
        "as the format has it for accelerations: the type is unknown, but a comment says so"
    } else {
        "as the format has it"
    };
    line.map_or(Scale::Unknown, |line| {
        Scale::Unit(Stated {
            value: AccelerationUnit::CentimetrePerSecondSquared,
            place: FilePlace::Line(line.number),
            text: text.to_owned(),
        })
    })
}

/// Pairs of time and value, for a header without a rate; its count is that of the numbers or of the pairs. Some files continue after them.
fn pairs(data: &[Line<'_>], columns: FixedColumns, count: &Stated<usize>) -> Result<(TimeColumn, Vec<f64>), Refused> {
    let fields = data.iter().flat_map(|line| columns.fields(*line).map(|field| (*line, field)));
    let fields: Vec<(Line<'_>, &[u8])> = fields.collect();
    let n_numbers = if fields.len() == 2 * count.value {
        fields.len()
    } else {
        count.value
    };
    let Some(fields) = fields.get(..n_numbers) else {
        return Err(refusals::sample_count(
            data.last().map_or(count.place, |line| FilePlace::Line(line.number)),
            fields.len(),
            count.value,
        ));
    };
    let mut times = TimeColumn::default();
    let mut values = Vec::new();
    for pair in fields.chunks_exact(2) {
        let [(of_time, time), (of_value, value)] = [pair[0], pair[1]];
        times.push(of_time, time)?;
        values.push(of_value.finite(2, value)?);
    }
    Ok((times, values))
}

/// The n-th number of a header, from 1.
fn number_of(numbers: &[Option<f64>], n: usize) -> Option<f64> {
    numbers.get(n - 1).copied().flatten()
}

/// The larger magnitude of the largest value, number 30, and the smallest, number 32, if both are given.
fn peak(real: &[Option<f64>], lines: &[Line<'_>]) -> Option<Peak> {
    let missing = number_of(real, 1)?;
    let stated = |n| number_of(real, n).filter(|value| !is_mark(*value, missing));
    let (largest, smallest) = (stated(30)?, stated(32)?);
    let value = largest.abs().max(smallest.abs());
    Some(Peak {
        stated: Stated {
            value,
            place: FilePlace::Line(lines[5].number),
            text: format!("{value} cm/s²"),
        },
        // The peak has seven digits, more than the values.
        digit: value * 1e-6,
        unit: None,
    })
}
