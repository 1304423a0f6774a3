//! AFAD (NSMN) of Turkey: 18 lines of titles in a Turkish code page, then north-south, east-west
//! and up-down in gal.
//!
//! No file was available: this follows programs that read the format. The peaks of the header are those of the raw record and are not
//! compared with the values.

use super::table::ComponentTable;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, identity};
use crate::line::{Line, number};
use crate::{AccelerationUnit, FilePlace, Identity, Refused};

/// Lines of titles; the 13th has the number of values, the 14th their step.
const TITLES: usize = 18;
const COUNT: usize = 12;
const STEP: usize = 13;

/// The columns.
const NAMES: [&str; 3] = ["N-S", "E-W", "U-D"];

pub(super) const READER: Reader = Reader {
    format: Format::Afad,
    recognises: |file| {
        let first = file.lines.first();
        first.is_some_and(|line| title::holds(*line, "STRONG GROUND MOTION RECORDS OF TURK"))
    },
    components: |file| Ok(components(file)),
    read,
    identity: |file| {
        let said = |word: &str| {
            let line = title::line_with(&file.lines[..file.lines.len().min(TITLES)], word)?;
            Some(behind_colon(line))
        };
        Identity {
            station: said("STATION ID").as_deref().and_then(identity::text),
            time: said("EARTHQUAKE DATE").as_deref().and_then(identity::time),
            ..Identity::default()
        }
    },
};

fn components(file: &File<'_>) -> Vec<Component> {
    let last = file.lines.get(TITLES - 1).or(file.lines.last());
    let place = FilePlace::Line(last.map_or(1, |line| line.number));
    let components = NAMES.map(|name| Component::new(name, place));
    components.into()
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let split = file.lines.split_at_checked(TITLES);
    let (titles, lines) = needed(split, file.lines.last().copied(), "the values")?;
    let table = ComponentTable::new(titles[TITLES - 1], lines, NAMES.len(), Line::pieces)?;
    let numbers = table.column(index)?;
    let step = number(behind_colon(titles[STEP]).as_bytes());
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(title::count(titles[COUNT], &behind_colon(titles[COUNT]))?),
        time_step: Some(Spacing::Even(title::time_step(titles[STEP], step)?)),
        scale: Scale::Unit(Stated {
            value: AccelerationUnit::CentimetrePerSecondSquared,
            place: FilePlace::Line(titles[0].number),
            text: "as the format has it".to_owned(),
        }),
        peak: None,
        provenance: title::provenance(titles),
        remarks: Vec::new(),
    })
}

fn behind_colon(line: Line<'_>) -> String {
    let text = line.text();
    let value = text.split_once(':').map_or("", |(_, value)| value);
    value.trim().to_owned()
}
