//! eqsig: a title, a line with the number of values and the time step, then a value to a line.

use super::columns::Largest;
use super::{Draft, File, Format, Reader, Scale, Spacing, one_component, title};
use crate::line::number;
use crate::{Place, ReadError};

pub(super) const READER: Reader = Reader {
    format: Format::Eqsig,
    recognises,
    components: one_component,
    read: |file, _| read(file),
};

/// `4684 0.0100` on line 2, and one number on line 3.
fn recognises(file: &File<'_>) -> bool {
    let [title, line, value, ..] = file.lines[..] else {
        return false;
    };
    let fields: Vec<&[u8]> = line.pieces().collect();
    let values: Vec<&[u8]> = value.pieces().collect();
    let is_title = title.bytes.iter().any(u8::is_ascii_alphabetic) && !title.is_comment();
    is_title
        && fields.len() == 2
        && fields[0].iter().all(u8::is_ascii_digit)
        && number(fields[1]).is_some()
        && values.len() == 1
        && number(values[0]).is_some()
}

fn read(file: &File<'_>) -> Result<Draft, ReadError> {
    let line = file.lines[1];
    let text = line.text();
    let mut fields = text.split_whitespace();
    let count = title::count(line, fields.next().unwrap_or_default())?;
    let step = fields.next().and_then(|step| number(step.as_bytes()));
    let mut values = Vec::new();
    let mut largest = Largest::default();
    let mut end = line;
    for line in file.lines[2..].iter().filter(|line| !line.is_blank()) {
        let value = line.finite(1, line.bytes)?;
        largest.see(value, line.bytes);
        values.push(value);
        end = *line;
    }
    Ok(Draft {
        values,
        end: Place::Line(end.number),
        digit: largest.digit(),
        count: Some(count),
        time_step: Some(Spacing::Even(title::time_step(line, step)?)),
        scale: Scale::Unknown,
        peak: None,
        provenance: title::provenance(&file.lines[..1]),
        remarks: Vec::new(),
    })
}
