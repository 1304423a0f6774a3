//! `GeoNet` V1A and V2A: three components, each with 16 titles, numbers in 10I8 and 10F8, then accelerations in 10F8.1. In a V2A velocity
//! and displacement follow.
//!
//! Values are in mm/s². A V2A was available, a V1A was not. The peak may exclude the offset of uncorrected values: only that of a V2A is
//! checked.

use super::columns::{FixedColumns, leading_data};
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, identity};
use crate::line::Line;
use crate::{AccelerationUnit, Direction, FilePlace, Identity, Refused};

/// Numbers of title lines, of lines of whole numbers, and of lines of the whole header.
const TITLES: usize = 16;
const WHOLE: usize = 4;
const HEADER: usize = 26;

const COLUMNS: FixedColumns = FixedColumns::new(10, 8);

pub(super) const READER: Reader = Reader {
    format: Format::GeoNet,
    recognises: |file| file.lines.first().is_some_and(|line| starts(*line)),
    components: |file| Ok(components(file)),
    read,
    identity: identity_of,
};

fn starts(line: Line<'_>) -> bool {
    title::holds(line, "CORRECTED ACCELEROGRAM") && title::holds(line, "GNS SCIENCE")
}

fn channels<'l, 't>(file: &'l File<'t>) -> Vec<&'l [Line<'t>]> {
    super::blocks(&file.lines, |index| starts(file.lines[index]))
}

fn components(file: &File<'_>) -> Vec<Component> {
    let component = |channel: &[Line<'_>]| {
        let titles = &channel[..channel.len().min(TITLES)];
        let line = title::line_with(titles, "COMPONENT").unwrap_or(channel[0]);
        let text = line.text();
        let words: Vec<&str> = text.split_whitespace().skip(1).collect();
        // A channel number may precede the direction.
        let is_number = |word: &&str| word.bytes().all(|byte| byte.is_ascii_digit());
        let is_upright = |word: &&str| Direction::of_component(word) == Some(Direction::Vertical);
        let n_words = match words[..] {
            [first, second, ..] if is_number(&first) && is_upright(&second) => 2,
            _ => 1,
        };
        let name = words[..n_words.min(words.len())].join(" ");
        Component::new(name, FilePlace::Line(line.number))
    };
    channels(file).into_iter().map(component).collect()
}

/// The name of the accelerogram, with time and station, and the site.
fn identity_of(file: &File<'_>) -> Identity {
    let titles = &file.lines[..file.lines.len().min(TITLES)];
    let word = |key: &str| identity::behind(titles, key)?.split_whitespace().next().and_then(identity::text);
    Identity {
        station: word("Site"),
        event: word("Accelerogram"),
        ..Identity::default()
    }
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let channels = channels(file);
    let channel = needed(channels.get(index), file.lines.last().copied(), "a channel")?;
    let header = needed(channel.get(..HEADER), channel.last().copied(), "the numbers of its header")?;
    let (titles, numbers) = header.split_at(TITLES);
    let (whole_lines, real_lines) = numbers.split_at(WHOLE);
    let whole = COLUMNS.header(whole_lines);
    let real = COLUMNS.header(real_lines);
    let uncorrected = title::holds(titles[0], "UNCORRECTED");
    // The last line begins with six counts: the numbers of raw samples of each quantity, then of corrected ones.
    let count = whole.get(if uncorrected { 30 } else { 33 }).copied().flatten();
    let count = count.map(|count| count.to_string()).unwrap_or_default();
    let count = title::count(whole_lines[WHOLE - 1], &count)?;
    let data = &channel[HEADER..];
    let rows = COLUMNS.lines_of(count.value).min(data.len());
    let numbers = COLUMNS.numbers(header[HEADER - 1], leading_data(&data[..rows]), &[])?;
    let quantity = title::line_with(titles, "ACCELERATION:");
    let unit = match quantity {
        Some(line) => {
            let text = line.text();
            title::stated_unit(line, title::before(&text, " AT "))?
        }
        None => Stated {
            value: AccelerationUnit::MillimetrePerSecondSquared,
            place: FilePlace::Line(titles[0].number),
            text: "as the format has it".to_owned(),
        },
    };
    let step = time_step(titles, &real, count.value);
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: numbers.digit,
        count: Some(count),
        time_step: Some(Spacing::Even(title::time_step(real_lines[2], step)?)),
        scale: Scale::Unit(unit),
        peak: quantity
            .filter(|_| !uncorrected)
            .and_then(|line| title::peak(line, title::after(&line.text(), "PEAK")?)),
        provenance: title::provenance(titles),
        remarks: Vec::new(),
    })
}

/// The 26th number with a point, or the 25th, which is that of the recorder: the one that fits the duration in the titles.
fn time_step(titles: &[Line<'_>], real: &[Option<f64>], n_samples: usize) -> Option<f64> {
    let steps = [25, 24].map(|index| real.get(index).copied().flatten());
    let line = title::line_with(titles, "DURATION")?;
    let text = line.text();
    let duration: f64 = title::first_number(title::after(&text, "DURATION")?)?.parse().ok()?;
    // The duration is printed to hundredths; it may count the last step or not.
    let fits = |step: &f64| {
        let near = |n_steps: usize| (n_steps as f64 * step - duration).abs() <= 0.0051;
        near(n_samples - 1) || near(n_samples)
    };
    steps.into_iter().flatten().find(fits)
}
