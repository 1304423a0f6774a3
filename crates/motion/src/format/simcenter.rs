//! JSON of the `SimCenter`: a step `dT` and lists of values, `data_x`, `data_y`. The unit is not in the file.

use super::numbers::Values;
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, no_identity};
use crate::line::Line;
use crate::refusals;
use crate::{FilePlace, Refused};

/// The key of the step, and the beginning of the keys of values.
const STEP: &[u8] = b"\"dT\"";
const VALUES: &[u8] = b"\"data";

pub(super) const READER: Reader = Reader {
    format: Format::SimCenter,
    recognises: |file| {
        let begins = file.bytes.trim_ascii_start().first();
        matches!(begins, Some(b'{' | b'[')) && memchr::memmem::find(file.bytes, STEP).is_some() && !lists(file).is_empty()
    },
    components: |file| Ok(lists(file).into_iter().map(|list| list.component).collect()),
    read,
    identity: no_identity,
};

/// A list of values, from its opening bracket.
struct List<'t> {
    component: Component,
    line: Line<'t>,
}

/// The lists whose keys begin with `data`, named by the rest of the key: `x` of `data_x`.
fn lists<'t>(file: &File<'t>) -> Vec<List<'t>> {
    let keys = memchr::memmem::find_iter(file.bytes, VALUES);
    let list = |at: usize| {
        let rest = &file.bytes[at + VALUES.len()..];
        let end = rest.iter().take(40).position(|byte| *byte == b'"')?;
        let name = String::from_utf8_lossy(&rest[..end]);
        let behind = rest[end + 1..].trim_ascii_start().strip_prefix(b":")?;
        let values = behind.trim_ascii_start().strip_prefix(b"[")?;
        let number = line_of(file.bytes, at);
        let name = match name.trim_matches('_') {
            "" => "data",
            name => name,
        };
        let component = Component::new(name, FilePlace::Line(number));
        let end = memchr::memchr(b']', values)?;
        let bytes = &values[..end];
        Some(List {
            component,
            line: Line { number, bytes },
        })
    };
    keys.filter_map(list).collect()
}

fn line_of(bytes: &[u8], at: usize) -> usize {
    memchr::memchr_iter(b'\n', &bytes[..at]).count() + 1
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let lists = lists(file);
    let list = lists.get(index).ok_or(refusals::empty())?;
    let mut values = Values::default();
    for (index, field) in list.line.fields().enumerate() {
        values.push(list.line, list.line.finite(index + 1, field)?, field)?;
    }
    let numbers = values.finish(list.line);
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: None,
        time_step: Some(Spacing::Even(step(file)?)),
        scale: Scale::Unknown,
        peak: None,
        provenance: String::new(),
        remarks: Vec::new(),
    })
}

/// The number after the key of the step.
fn step(file: &File<'_>) -> Result<Stated<f64>, Refused> {
    let at = memchr::memmem::find(file.bytes, STEP).unwrap_or_default();
    let behind = file.bytes[at..].get(STEP.len()..).unwrap_or_default();
    let of_number = |byte: &u8| byte.is_ascii_digit() || b"+-.eE".contains(byte);
    let behind = behind.trim_ascii_start();
    let behind = behind.strip_prefix(b":").unwrap_or(behind).trim_ascii_start();
    let end = behind.iter().position(|byte| !of_number(byte)).unwrap_or(behind.len());
    let line = Line {
        number: line_of(file.bytes, at),
        bytes: &behind[..end],
    };
    Ok(Stated {
        value: line.finite(1, line.bytes)?,
        place: FilePlace::Line(line.number),
        text: line.excerpt(),
    })
}
