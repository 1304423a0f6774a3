//! eqsig: a title, a line with the number of values and the time step, then a value to a line.

use super::numbers::Values;
use super::said::Said;
use super::{Draft, File, Format, Reader, Spacing, title};
use crate::Refused;
use crate::line::number;

pub(super) const READER: Reader = Reader {
    format: Format::Eqsig,
    recognises,
    components: |file| Ok(said(file).component.into_iter().collect()),
    read: |file, _| read(file),
    identity: |file| said(file).identity(),
};

/// Whether line 2 is like `4684 0.0100`, and line 3 is one number.
fn recognises(file: &File<'_>) -> bool {
    let [title, line, value, ..] = file.lines[..] else {
        return false;
    };
    let mut fields = line.pieces();
    let mut values = value.pieces();
    let is_title = title.bytes.iter().any(u8::is_ascii_alphabetic) && !title.is_comment();
    let is_count = |field: &[u8]| field.iter().all(u8::is_ascii_digit);
    let is_number = |field: &[u8]| number(field).is_some();
    is_title
        && fields.next().is_some_and(is_count)
        && fields.next().is_some_and(is_number)
        && fields.next().is_none()
        && values.next().is_some_and(is_number)
        && values.next().is_none()
}

/// Statements of the title.
fn said(file: &File<'_>) -> Said {
    Said::new(&file.lines[..1], None)
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let line = file.lines[1];
    let text = line.text();
    let mut fields = text.split_whitespace();
    let count = title::count(line, fields.next().unwrap_or_default())?;
    let step = fields.next().and_then(|step| number(step.as_bytes()));
    let mut values = Values::default();
    for value in file.lines[2..].iter().filter(|line| !line.is_blank()) {
        values.push(*value, value.finite(1, value.bytes)?, value.bytes)?;
    }
    let numbers = values.finish(line);
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(Spacing::Even(title::time_step(line, step)?)),
        scale: said(file).scale(),
        peak: None,
        provenance: title::provenance(&file.lines[..1]),
        remarks: Vec::new(),
    })
}
