//! USGS SMC: titles, numbers that describe, comments after `|`, then eight values of ten bytes to a
//! line.
//!
//! The numbers in the header say how many comments and values there are and how many samples make a
//! second; they begin with the marks of what is missing. The format fixes the unit.

use super::columns::{Columns, is_mark, leading_data};
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Peak, Reader, Scale, Stated};
use crate::line::{Line, number};
use crate::{AccelerationUnit, Place, ReadError};

/// Lines of titles, of whole numbers, and of numbers with a point.
const TITLES: usize = 11;
const WHOLE: usize = 6;
const REAL: usize = 10;

pub(super) const READER: Reader = Reader {
    format: Format::UsgsSmc,
    recognises,
    components,
    read: |file, _| read(file),
};

/// The component of the title, such as `component=  360`, where there is one; `UP` where the header says that the sensor
/// stands upright.
#[expect(clippy::unnecessary_wraps, reason = "one signature for all formats")]
fn components(file: &File<'_>) -> Result<Vec<Component>, ReadError> {
    let titles = &file.lines[..file.lines.len().min(TITLES)];
    let whole = file.lines.get(TITLES..TITLES + WHOLE);
    let numbers = whole.map(|lines| Columns::new(8, 10).header(lines));
    // The 13th number is the angle from upright, in degrees.
    let angle = numbers.and_then(|numbers| number_of(&numbers, 13));
    let upright = angle.is_some_and(|angle| [0.0, 180.0].iter().any(|up| is_mark(angle, *up)));
    let line = title::line_with(titles, "COMPONENT=");
    let stated = line.and_then(|line| {
        let text = line.text();
        let word = title::after(&text, "COMPONENT=")?
            .split_whitespace()
            .next()?;
        Some(word.to_owned())
    });
    let component = |name: String, line: usize| Component {
        name,
        place: Place::Line(line),
    };
    // A number would be the azimuth of an upright sensor.
    let stated = stated.filter(|name| !upright || number(name.as_bytes()).is_none());
    let line = line.map_or(TITLES, |line| line.number);
    Ok(match stated {
        Some(name) => vec![component(name, line)],
        None if upright => vec![component("UP".to_owned(), TITLES + 2)],
        None => Vec::new(),
    })
}

/// A stage from 1 to 9 and its name, then a line with a star.
fn recognises(file: &File<'_>) -> bool {
    let [first, second, ..] = file.lines[..] else {
        return false;
    };
    let title = first.text();
    let mut words = title.split_whitespace();
    let stage = words
        .next()
        .is_some_and(|word| word.len() == 1 && word.as_bytes()[0].is_ascii_digit());
    stage
        && words
            .next()
            .is_some_and(|word| word.bytes().all(|byte| byte.is_ascii_alphabetic()))
        && second.bytes.trim_ascii() == b"*"
}

fn read(file: &File<'_>) -> Result<Draft, ReadError> {
    let lines = &file.lines;
    let first = lines[0];
    if !title::holds(first, "ACCELEROGRAM") {
        return Err(ReadError::NotAcceleration {
            place: Place::Line(first.number),
            found: first.excerpt(),
            instead: "the accelerogram of the record",
        });
    }
    let header = lines.get(..TITLES + WHOLE + REAL);
    let header = needed(header, lines.last().copied(), "the numbers of its header")?;
    let (titles, numbers) = header.split_at(TITLES);
    let (whole_lines, real_lines) = numbers.split_at(WHOLE);
    let whole = Columns::new(8, 10).header(whole_lines);
    let real = Columns::new(5, 15).header(real_lines);
    let missing: Vec<f64> = [whole[..].first(), real[..].first()]
        .into_iter()
        .filter_map(|mark| mark.copied().flatten())
        .chain([-32768.0, 1.7e38])
        .collect();
    // Numbers are counted from 1: the 16th gives the comments, the 17th the values.
    let comments = number_of(&whole, 16)
        .filter(|count| *count >= 0.0)
        .unwrap_or(0.0);
    let count = number_of(&whole, 17)
        .map(|count| count.to_string())
        .unwrap_or_default();
    let count = title::count(whole_lines[2], &count)?;
    let rest = &lines[header.len()..];
    let n_comments = rest
        .iter()
        .take_while(|line| line.bytes.starts_with(b"|"))
        .count();
    if !is_mark(n_comments as f64, comments) {
        return Err(ReadError::Header {
            place: Place::Line(whole_lines[1].number),
            found: whole_lines[1].excerpt(),
            allowed: "the number of comment lines that follow as the eighth",
        });
    }
    let data = leading_data(&rest[n_comments..]);
    let numbers = Columns::new(8, 10).numbers(header[header.len() - 1], data, &missing)?;
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(title::time_step(
            real_lines[0],
            number_of(&real, 2).map(|rate| 1.0 / rate),
        )?),
        scale: Scale::Unit(Stated {
            value: AccelerationUnit::CentimetrePerSecondSquared,
            place: Place::Line(first.number),
            text: "as the format has it".to_owned(),
        }),
        peak: peak(&real, real_lines),
        provenance: title::provenance(titles),
        remarks: Vec::new(),
    })
}

/// The n-th number of a header, from 1.
fn number_of(numbers: &[Option<f64>], n: usize) -> Option<f64> {
    numbers.get(n - 1).copied().flatten()
}

/// The larger of the largest value, number 30, and the smallest, number 32, where both are given.
fn peak(real: &[Option<f64>], lines: &[Line<'_>]) -> Option<Peak> {
    let missing = number_of(real, 1)?;
    let stated = |n| number_of(real, n).filter(|value| !is_mark(*value, missing));
    let (largest, smallest) = (stated(30)?, stated(32)?);
    let value = largest.abs().max(smallest.abs());
    Some(Peak {
        stated: Stated {
            value,
            place: Place::Line(lines[5].number),
            text: format!("{value} cm/s²"),
        },
        // Seven digits are printed, fewer of the values.
        digit: value * 1e-6,
        unit: None,
    })
}
