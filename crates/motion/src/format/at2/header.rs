//! The header: quantity, number and spacing of the values.

use super::super::identity::text;
use super::super::title::{self, holds};
use super::Component;
use crate::line::{Line, number};
use crate::refusals::{self, kind_of_quantity};
use crate::{Direction, FilePlace, Identity, Refused};
use pounding_text::Spot;

/// Number of lines in which NPTS and DT are searched. PEER has them on line 4, rotated and matched records on line 7.
const HEADER_LINES: usize = 10;

/// Line, from 1, that may have NPTS and DT without their names.
const COUNT_LINE: usize = 4;

/// Whether a text has a line with NPTS and DT, or names itself a record of PEER.
pub(super) fn is_at2(lines: &[Line<'_>]) -> bool {
    count_line(lines).is_some()
        || lines.first().is_some_and(|line| {
            let words = words(*line);
            !line.is_comment() && words.iter().any(|word| word == "PEER") && words.iter().any(|word| word == "MOTION")
        })
}

/// The parts of a file.
pub(super) struct Header<'l, 't> {
    pub(super) titles: &'l [Line<'t>],
    /// The line with NPTS and DT.
    pub(super) line: Line<'t>,
    /// The lines after it, from the first number.
    pub(super) data: &'l [Line<'t>],
}

/// Splits a file at its line with NPTS and DT. A line such as `*** Begin data ***` below it is skipped.
pub(super) fn split<'l, 't>(lines: &'l [Line<'t>]) -> Result<Header<'l, 't>, Refused> {
    let index = count_line(lines).ok_or(
        Refused::that(format!(
            "no line among the first {} gives the number of samples and the time step",
            HEADER_LINES.min(lines.len())
        ))
        .help("write line 4 as `NPTS= 4000, DT= .01000 SEC`"),
    )?;
    let mut data = &lines[index + 1..];
    if let [first, rest @ ..] = data
        && first.bytes.trim_ascii().starts_with(b"***")
        && holds(*first, "BEGIN")
    {
        data = rest;
    }
    Ok(Header {
        titles: &lines[..index],
        line: lines[index],
        data,
    })
}

/// Earthquake and station from the titles (the second line above the numbers), without the direction; for a rotated record, from the lines
/// of both original records.
pub(super) fn identity(lines: &[Line<'_>]) -> Identity {
    let Ok(Header { titles, .. }) = split(lines) else {
        return Identity::default();
    };
    let rotated = titles.iter().filter(|line| holds(**line, "FOR ROTATION"));
    let rotated: Vec<String> = rotated.map(|line| line.text().into_owned()).collect();
    let of_second = || {
        let line = titles.get(titles.len().checked_sub(2)?)?;
        let text = line.text();
        let (before, _) = text.rsplit_once(',').filter(|_| component(lines).is_some())?;
        Some(before.to_owned())
    };
    let title = if rotated.is_empty() { of_second() } else { Some(rotated.join(" ")) };
    Identity {
        title: title.as_deref().and_then(text),
        ..Identity::default()
    }
}

/// The direction that PEER writes after the last comma of the line of earthquake and station, the second line above the numbers:
/// `EL CENTRO ARRAY #9, 180 (USGS STATION 117)`, `Iwate, IWTH25, UD`.
pub(super) fn component(lines: &[Line<'_>]) -> Option<Component> {
    let titles = split(lines).ok()?.titles;
    // A rotated record has `FN component, azimuth =   233.0`.
    if let Some(line) = title::line_with(titles, "COMPONENT, AZIMUTH") {
        let name = line.pieces().next().map(String::from_utf8_lossy)?;
        return Some(Component::new(name, FilePlace::Line(line.number)));
    }
    let line = titles.get(titles.len().checked_sub(2)?)?;
    let text = line.text();
    let (_, behind) = text.rsplit_once(',')?;
    let word = behind.split('(').next().unwrap_or_default().trim();
    Direction::of_component(word)?;
    // A channel number may precede the direction; other words belong to the name of a station.
    let mut words = word.split_whitespace().rev().skip(1);
    if !words.all(|word| word.bytes().all(|byte| byte.is_ascii_digit())) {
        return None;
    }
    Some(Component::new(word.to_owned(), FilePlace::Line(line.number)))
}

/// Index of the line with NPTS and DT.
fn count_line(lines: &[Line<'_>]) -> Option<usize> {
    let header = &lines[..lines.len().min(HEADER_LINES)];
    let named = |line: &Line<'_>| !line.is_comment() && named(*line).len() == 2;
    // The last one counts: matched records repeat the header of their original record.
    header.iter().rposition(named).or_else(|| {
        let titles = header.get(..COUNT_LINE - 1)?;
        let bare = header.get(COUNT_LINE - 1)?;
        let fields: Vec<&[u8]> = bare.pieces().take(3).collect();
        let is_pair = fields.len() == 2 && fields[0].iter().all(u8::is_ascii_digit) && number(fields[1]).is_some_and(f64::is_finite);
        let is_title = |line: &Line<'_>| !line.is_comment() && line.bytes.iter().any(u8::is_ascii_alphabetic);
        (is_pair && titles.iter().any(is_title)).then_some(COUNT_LINE - 1)
    })
}

/// The names NPTS and DT in the order of a line.
fn named(line: Line<'_>) -> Vec<String> {
    let mut names = words(line);
    names.retain(|word| word == "NPTS" || word == "DT");
    names.dedup();
    names
}

/// The number of samples and the time step of a line.
pub(super) struct Stated<'t> {
    pub(super) line: Line<'t>,
    /// Number of samples, above zero.
    pub(super) count: usize,
    /// Time step, above zero \[s\].
    pub(super) step: f64,
}

/// Reads a line with NPTS and DT.
pub(super) fn count_and_step(line: Line<'_>) -> Result<Stated<'_>, Refused> {
    let refused = || {
        Refused::at(Spot::Line(line.number))
            .reads(line.excerpt())
            .but(
                ", but ",
                "must give a whole number of samples above 0 and the time step in seconds, and no other number",
            )
            .help("write it as `NPTS= 4000, DT= .01000 SEC`")
    };
    let text = line.text().to_ascii_uppercase();
    let [count, step] = printed(&text).ok_or_else(refused)?;
    let count: usize = count.parse().map_err(|_| refused())?;
    let step = number(step.as_bytes()).ok_or_else(refused)?;
    if count == 0 {
        return Err(refused());
    }
    if !(step.is_finite() && step > 0.0) {
        return Err(refusals::time_step(FilePlace::Line(line.number), step));
    }
    Ok(Stated { line, count, step })
}

/// The numbers of NPTS and DT in a line in capitals.
///
/// Either each number follows its name, possibly with a filter after both, `0 POLE @ 30. HZ`; or names and numbers have one order, and
/// there are no other numbers.
fn printed(text: &str) -> Option<[&str; 2]> {
    let words: Vec<&str> = text
        .split(|letter: char| letter.is_whitespace() || matches!(letter, '=' | ',' | ':'))
        .filter(|word| !word.is_empty())
        .map(|word| match word.strip_suffix("SEC") {
            Some(number) if !number.is_empty() => number,
            _ => word,
        })
        .collect();
    let is_number = |word: &&&str| word.starts_with(|letter: char| letter.is_ascii_digit() || matches!(letter, '.' | '-' | '+'));
    let behind = |name: &str| {
        let at = words.iter().rposition(|word| *word == name)?;
        words.get(at + 1).filter(is_number).copied()
    };
    let numbers: Vec<&str> = words.iter().filter(is_number).copied().collect();
    if let (Some(count), Some(step)) = (behind("NPTS"), behind("DT"))
        && (numbers.len() == 2 || words.contains(&"POLE") || words[words.len() - 2..].contains(&step))
    {
        return Some([count, step]);
    }
    let &[first, second] = &numbers[..] else {
        return None;
    };
    let names = words.iter().find(|word| matches!(**word, "NPTS" | "DT"));
    Some(if names == Some(&"DT") { [second, first] } else { [first, second] })
}

/// The statement of a title such as `1559 points at equal spacing of 0.02 sec`.
pub(super) fn points<'t>(titles: &[Line<'t>]) -> Option<Stated<'t>> {
    let line = title::line_with(titles, "POINTS AT EQUAL SPACING OF")?;
    let text = line.text();
    let count = text.split_whitespace().next()?.parse().ok()?;
    let behind = title::after(&text, "SPACING OF")?;
    let step = number(behind.split_whitespace().next()?.as_bytes())?;
    (count > 0 && step.is_finite() && step > 0.0).then_some(Stated { line, count, step })
}

/// The title line that states acceleration in g, searched upwards from the numbers; `None` if no line names a unit.
pub(super) fn unit<'t>(titles: &[Line<'t>]) -> Result<Option<Line<'t>>, Refused> {
    let mut other: Option<Line<'t>> = None;
    for line in titles.iter().rev() {
        let words = words(*line);
        let says = |known: &[&str]| words.iter().any(|word| known.contains(&word.as_str()));
        let acceleration = says(&["ACCELERATION"]);
        if !acceleration && says(&["VELOCITY", "DISPLACEMENT"]) {
            return Err(quantity(*line));
        }
        if !acceleration && !says(&["UNIT", "UNITS"]) {
            continue;
        }
        let in_g = words.windows(2).any(|pair| {
            matches!(pair[0].as_str(), "IN" | "OF" | "ARE" | "UNIT" | "UNITS" | "ACCELERATION")
                && matches!(pair[1].as_str(), "G" | "GS" | "G'S")
        });
        if in_g {
            return Ok(Some(*line));
        }
        other.get_or_insert(*line);
    }
    match other {
        Some(line) => Err(quantity(line)),
        None => Ok(None),
    }
}

/// A line that names another quantity or unit than acceleration in g.
fn quantity(line: Line<'_>) -> Refused {
    let read = Refused::at(Spot::Line(line.number))
        .reads(line.excerpt())
        .kind(kind_of_quantity(&line.excerpt()));
    read.but(", but ", "only acceleration in units of g is read")
        .help("take the .AT2 file of the record")
}

/// The words of a line in capitals. A unit such as `CM/S` is one word; its `S` alone would have no meaning.
fn words(line: Line<'_>) -> Vec<String> {
    let text = line.text().to_ascii_uppercase();
    let separates = |letter: char| !(letter.is_alphanumeric() || matches!(letter, '/' | '\'' | '^' | '*'));
    text.split(separates).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}
