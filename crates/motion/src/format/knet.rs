//! K-NET and KiK-net: 17 lines of keys, then whole numbers of a digitiser, eight to a line.
//!
//! The scale factor in the header, such as `3920(gal)/6182761`, turns counts into gal. The counts have an offset, so their mean is removed,
//! as for the peak in the header. Directions are compass points. On KiK-net they are 1 to 3 in the borehole and 4 to 6 at the surface, each
//! north-south, east-west and up.
//!
//! The network does not allow redistribution of its files, and none was available: this follows its description and programs that read the
//! format.

use super::numbers::Values;
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, identity, reading, title};
use crate::line::{Line, number};
use crate::refusals;
use crate::{AccelerationUnit, FilePlace, Identity, Refused, Site};

/// Lines in which keys are looked for.
const HEADER: usize = 40;

pub(super) const READER: Reader = Reader {
    format: Format::KNet,
    recognises: |file| {
        let header = &file.lines[..file.lines.len().min(HEADER)];
        title::value_of(&header[..header.len().min(1)], "Origin Time").is_some() && title::value_of(header, "Scale Factor").is_some()
    },
    components,
    read: |file, _| read(file),
    identity: identity_of,
};

fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let (line, stated) = value(file, "Dir.")?;
    let site = match stated.as_str() {
        "1" | "2" | "3" => Site::Borehole(format!("Dir. {stated}, of KiK-net's borehole")),
        _ => Site::Ground,
    };
    let component = Component::new(direction(stated), FilePlace::Line(line.number));
    Ok(vec![component.at(site)])
}

fn identity_of(file: &File<'_>) -> Identity {
    let value = |key| value(file, key).ok().map(|(_, value)| value);
    Identity {
        station: value("Station Code").as_deref().and_then(identity::text),
        time: value("Origin Time").as_deref().and_then(identity::time),
        ..Identity::default()
    }
}

/// The direction as stated, with words if it is a number of KiK-net: `6: UP`.
fn direction(stated: String) -> String {
    match stated.as_str() {
        "1" | "4" => format!("{stated}: N-S"),
        "2" | "5" => format!("{stated}: E-W"),
        "3" | "6" => format!("{stated}: UP"),
        _ => stated,
    }
}

fn value<'t>(file: &File<'t>, key: &'static str) -> Result<(Line<'t>, String), Refused> {
    let header = &file.lines[..file.lines.len().min(HEADER)];
    title::value_of(header, key).ok_or(refusals::no_key(key))
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let (rate_line, rate) = value(file, "Sampling Freq(Hz)")?;
    let rate = title::first_number(&rate).and_then(|rate| number(rate.as_bytes()));
    let time_step = title::time_step(rate_line, rate.map(|rate| 1.0 / rate))?;
    let (duration_line, duration) = value(file, "Duration Time(s)")?;
    let duration = number(duration.as_bytes());
    let (scale_line, scale) = value(file, "Scale Factor")?;
    let (gal, counts) = scale_factor(scale_line, &scale)?;
    let (peak_line, peak) = value(file, "Max. Acc. (gal)")?;
    let (memo, _) = value(file, "Memo")?;
    let mut values = Values::default();
    for line in file.behind(memo) {
        for (index, field) in line.pieces().enumerate() {
            values.push(*line, line.finite(index + 1, field)?, field)?;
        }
    }
    let numbers = values.finish(memo);
    let mut values = numbers.values;
    let n_samples = duration.zip(rate).map(|(duration, rate)| (duration * rate).round().to_string());
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    for value in &mut values {
        *value = (*value - mean) * gal / counts;
    }
    let remark = format!("{:.6} gal, the mean of the record, taken off", mean * gal / counts);
    Ok(Draft {
        values,
        end: numbers.end,
        digit: gal / counts,
        count: Some(title::count(duration_line, &n_samples.unwrap_or_default())?),
        time_step: Some(Spacing::Even(time_step)),
        scale: Scale::Unit(Stated {
            value: AccelerationUnit::CentimetrePerSecondSquared,
            place: FilePlace::Line(scale_line.number),
            text: scale_line.excerpt(),
        }),
        peak: title::peak(peak_line, &peak),
        provenance: title::provenance(file.through(memo)),
        remarks: vec![
            reading("scale factor", Some(FilePlace::Line(scale_line.number)), &scale),
            reading("mean removed", None, &remark),
        ],
    })
}

/// Gal and counts of `3920(gal)/6182761`.
fn scale_factor(line: Line<'_>, text: &str) -> Result<(f64, f64), Refused> {
    let parts = text.split_once('/').and_then(|(gal, counts)| {
        let gal = gal.trim().strip_suffix("(gal)")?;
        Some((number(gal.as_bytes())?, number(counts.as_bytes())?))
    });
    let usable = |value: f64| value.is_finite() && value > 0.0;
    parts
        .filter(|(gal, counts)| usable(*gal) && usable(*counts) && usable(gal / counts))
        .ok_or_else(|| {
            refusals::header(
                FilePlace::Line(line.number),
                line.excerpt(),
                "a scale factor such as 3920(gal)/6182761",
            )
        })
}
