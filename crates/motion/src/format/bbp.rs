//! SCEC Broadband Platform: comments behind `#` that name four columns, time and three components.
//!
//! The comments say `cm/s` of velocities and, in some files, of accelerations too: such files leave
//! the unit to the caller. No file was at hand: this follows a description of the format.

use super::table::{Table, pieces};
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale};
use crate::line::Line;
use crate::{Place, ReadError};

/// Time and three components.
const COLUMNS: usize = 4;

pub(super) const READER: Reader = Reader {
    format: Format::Bbp,
    recognises: |file| names(file).is_some(),
    components: |file| Ok(components(file)),
    read,
};

fn comments<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    let comments = file.lines.iter().take_while(|line| line.is_comment());
    &file.lines[..comments.count()]
}

/// The comment that names the columns.
fn names<'t>(file: &File<'t>) -> Option<Line<'t>> {
    let holds =
        |line: Line<'_>, words: [&str; 2]| words.iter().any(|word| title::holds(line, word));
    comments(file).iter().copied().find(|line| {
        title::holds(*line, "TIME")
            && holds(*line, ["NS (", "N-S"])
            && holds(*line, ["EW (", "E-W"])
            && holds(*line, ["UD (", "U-D"])
    })
}

fn components(file: &File<'_>) -> Vec<Component> {
    let place = Place::Line(names(file).map_or(1, |line| line.number));
    let components = ["NS", "EW", "UD"].map(|name| Component {
        name: name.to_owned(),
        place,
    });
    components.into()
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, ReadError> {
    let comments = comments(file);
    let line = needed(names(file), None, "names of its columns")?;
    let table = Table::new(line, &file.lines[comments.len()..], COLUMNS, pieces)?;
    let numbers = table.column(index + 1)?;
    let mut values = numbers.values;
    let (step, remark) = table.times()?.into_step(&mut values)?;
    if title::holds(line, "(CM)") {
        return Err(ReadError::NotAcceleration {
            place: Place::Line(line.number),
            found: line.excerpt(),
            instead: "the .acc.bbp file of the record",
        });
    }
    let text = line.text();
    let scale = match title::unit_in(&text) {
        Some(_) => Scale::Unit(title::stated_unit(line, &text)?),
        None => Scale::Unknown,
    };
    Ok(Draft {
        values,
        end: numbers.end,
        digit: numbers.digit,
        count: None,
        time_step: Some(step),
        scale,
        peak: None,
        provenance: title::provenance(comments),
        remarks: remark.into_iter().collect(),
    })
}
