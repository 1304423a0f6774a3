//! EMOD3D, in processed and simulated records of New Zealand: station and component, then number of values, time step and six more numbers,
//! then values in columns. The unit is not in the file.

use super::{Component, Draft, File, Format, Reader, Scale, Spacing, identity, title, values};
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Identity, Refused};

/// Number of numbers in the second line.
const NUMBERS: usize = 8;

pub(super) const READER: Reader = Reader {
    format: Format::Emod3d,
    recognises: |file| header(file).is_some(),
    components: |file| Ok(component(file).into_iter().collect()),
    read: |file, _| read(file),
    identity: |file| {
        let station = header(file).and_then(|[names, _]| names.pieces().next());
        let station = station.map(String::from_utf8_lossy);
        Identity {
            station: station.as_deref().and_then(identity::text),
            ..Identity::default()
        }
    },
};

/// The line with station and component, and the line of numbers.
fn header<'t>(file: &File<'t>) -> Option<[Line<'t>; 2]> {
    let [names, numbers, first, ..] = file.lines[..] else {
        return None;
    };
    let pieces: Vec<&[u8]> = numbers.pieces().take(NUMBERS + 1).collect();
    let is_count = pieces.first().is_some_and(|count| count.iter().all(u8::is_ascii_digit));
    let of_numbers = |line: Line<'_>| line.pieces().all(|piece| number(piece).is_some());
    let is_header = pieces.len() == NUMBERS
        && is_count
        && of_numbers(numbers)
        && of_numbers(first)
        && (1..=3).contains(&names.pieces().count())
        && !of_numbers(names);
    is_header.then_some([names, numbers])
}

/// The second word of the first line: an azimuth or `ver`.
fn component(file: &File<'_>) -> Option<Component> {
    let [names, _] = header(file)?;
    let name = names.pieces().nth(1)?;
    Some(Component::new(
        String::from_utf8_lossy(name).into_owned(),
        FilePlace::Line(names.number),
    ))
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let [names, line] = header(file).ok_or(refusals::empty())?;
    let text = line.text();
    let mut pieces = text.split_whitespace();
    let count = title::count(line, pieces.next().unwrap_or_default())?;
    let step = pieces.next().and_then(|step| number(step.as_bytes()));
    let numbers = values::read(line, &file.lines[2..])?;
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(Spacing::Even(title::time_step(line, step)?)),
        scale: Scale::Unknown,
        peak: None,
        provenance: title::provenance(&[names]),
        remarks: Vec::new(),
    })
}
