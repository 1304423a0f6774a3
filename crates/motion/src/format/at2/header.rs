//! The header: what the values are, how many there are, and how far apart.

use super::Component;
use crate::line::{Line, number};
use crate::{Direction, Place, ReadError};

/// Lines in which NPTS and DT are looked for. PEER has them on line 4, rotated and matched records
/// on line 7.
const HEADER_LINES: usize = 10;

/// Line, from 1, on which NPTS and DT may stand without being named.
const COUNT_LINE: usize = 4;

/// Whether a text has a line with NPTS and DT, or at least says that it is a record of PEER.
pub(super) fn is_at2(lines: &[Line<'_>]) -> bool {
    count_line(lines).is_some()
        || lines.first().is_some_and(|line| {
            let words = words(*line);
            !line.is_comment()
                && words.iter().any(|word| word == "PEER")
                && words.iter().any(|word| word == "MOTION")
        })
}

/// The title lines, the line with NPTS and DT, and the lines after it.
pub(super) fn split<'l, 't>(
    lines: &'l [Line<'t>],
) -> Result<(&'l [Line<'t>], Line<'t>, &'l [Line<'t>]), ReadError> {
    let index = count_line(lines).ok_or(ReadError::NoCountLine {
        searched: HEADER_LINES.min(lines.len()),
    })?;
    Ok((&lines[..index], lines[index], &lines[index + 1..]))
}

/// The direction that PEER writes behind the last comma of the line of earthquake and station, which is the second above
/// the numbers: `EL CENTRO ARRAY #9, 180 (USGS STATION 117)`, `Iwate, IWTH25, UD`.
pub(super) fn component(lines: &[Line<'_>]) -> Option<Component> {
    let (titles, _, _) = split(lines).ok()?;
    let line = titles.get(titles.len().checked_sub(2)?)?;
    let text = line.text();
    let (_, behind) = text.rsplit_once(',')?;
    let word = behind.split('(').next().unwrap_or_default().trim();
    Direction::of_component(word).filter(|_| !word.contains(' '))?;
    Some(Component {
        name: word.to_owned(),
        place: Place::Line(line.number),
    })
}

/// Index of the line with NPTS and DT.
fn count_line(lines: &[Line<'_>]) -> Option<usize> {
    let header = &lines[..lines.len().min(HEADER_LINES)];
    let named = |line: &Line<'_>| !line.is_comment() && named(*line).len() == 2;
    // The last one: matched records repeat the header of the record they were made from.
    header.iter().rposition(named).or_else(|| {
        let titles = header.get(..COUNT_LINE - 1)?;
        let bare = header.get(COUNT_LINE - 1)?;
        let fields: Vec<&[u8]> = bare
            .bytes
            .split(u8::is_ascii_whitespace)
            .filter(|field| !field.is_empty())
            .collect();
        let is_pair = fields.len() == 2
            && fields[0].iter().all(u8::is_ascii_digit)
            && number(fields[1]).is_some_and(f64::is_finite);
        let is_title =
            |line: &Line<'_>| !line.is_comment() && line.bytes.iter().any(u8::is_ascii_alphabetic);
        (is_pair && titles.iter().any(is_title)).then_some(COUNT_LINE - 1)
    })
}

/// The names NPTS and DT in the order in which a line has them.
fn named(line: Line<'_>) -> Vec<String> {
    let mut names = words(line);
    names.retain(|word| word == "NPTS" || word == "DT");
    names.dedup();
    names
}

/// The number of samples and the time step \[s\].
pub(super) fn count_and_step(line: Line<'_>) -> Result<(usize, f64), ReadError> {
    let refused = || ReadError::CountLine {
        line: line.number,
        found: line.excerpt(),
    };
    let text = line.text().to_ascii_uppercase();
    // Whether each name precedes its number or both names follow both numbers, names and numbers
    // are in one order.
    let numbers: Vec<&str> = text
        .split(|letter: char| letter.is_whitespace() || matches!(letter, '=' | ',' | ':'))
        .map(|word| word.trim_end_matches("SEC"))
        .filter(|word| {
            word.starts_with(|letter: char| {
                letter.is_ascii_digit() || matches!(letter, '.' | '-' | '+')
            })
        })
        .collect();
    let &[first, second] = &numbers[..] else {
        return Err(refused());
    };
    let (count, step) = if named(line).first().is_some_and(|name| name == "DT") {
        (second, first)
    } else {
        (first, second)
    };
    let count: usize = count.parse().map_err(|_| refused())?;
    let step = number(step.as_bytes()).ok_or_else(refused)?;
    if count == 0 {
        return Err(refused());
    }
    if !(step.is_finite() && step > 0.0) {
        return Err(ReadError::TimeStep {
            place: Place::Line(line.number),
            found: step,
        });
    }
    Ok((count, step))
}

/// The title line that says acceleration in g, the one next to the numbers first; none where no
/// line names a unit.
pub(super) fn unit<'t>(titles: &[Line<'t>]) -> Result<Option<Line<'t>>, ReadError> {
    let mut other: Option<Line<'t>> = None;
    for line in titles.iter().rev() {
        let words = words(*line);
        let says = |known: &[&str]| words.iter().any(|word| known.contains(&word.as_str()));
        let acceleration = says(&["ACCELERATION"]);
        if !acceleration && says(&["VELOCITY", "DISPLACEMENT"]) {
            return Err(ReadError::Quantity {
                line: line.number,
                found: line.excerpt(),
            });
        }
        if !acceleration && !says(&["UNIT", "UNITS"]) {
            continue;
        }
        let in_g = words.windows(2).any(|pair| {
            matches!(
                pair[0].as_str(),
                "IN" | "OF" | "ARE" | "UNIT" | "UNITS" | "ACCELERATION"
            ) && matches!(pair[1].as_str(), "G" | "GS" | "G'S")
        });
        if in_g {
            return Ok(Some(*line));
        }
        other.get_or_insert(*line);
    }
    match other {
        Some(line) => Err(ReadError::Quantity {
            line: line.number,
            found: line.excerpt(),
        }),
        None => Ok(None),
    }
}

/// The words of a line in capitals. A unit such as `CM/S` is one word; its `S` alone would say
/// nothing.
fn words(line: Line<'_>) -> Vec<String> {
    let text = line.text().to_ascii_uppercase();
    let separates =
        |letter: char| !(letter.is_alphanumeric() || matches!(letter, '/' | '\'' | '^' | '*'));
    text.split(separates)
        .filter(|word| !word.is_empty())
        .map(str::to_owned)
        .collect()
}
