//! miniSEED 2 and 3: records with a header and a few hundred packed values each, of one stream or several.
//!
//! Whole numbers are counts of a digitiser, whose value is not in the file. Records of a stream must follow each other without a gap.
//!
//! The existing crates for this format crash or hang on damaged files, so this reader is separate. No file of a network was available:
//! tests read files written by another program.

mod record;
mod samples;

use crate::refusals;
use std::collections::BTreeMap;

use super::component::is_sum;
use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, identity, reading};
use crate::{FilePlace, Identity, Refused};
use record::Record;

pub(super) const READER: Reader = Reader {
    format: Format::MiniSeed,
    recognises: |file| record::begins(file.bytes),
    components,
    read,
    identity: identity_of,
};

fn records<'t>(file: &File<'t>) -> Result<Vec<Record<'t>>, Refused> {
    let mut records = Vec::new();
    let mut at = 0;
    while at < file.bytes.len() {
        let record = Record::new(file.bytes, at)?;
        at += record.length;
        records.push(record);
    }
    Ok(records)
}

/// Names of the streams and the first byte of each, in the order of the file.
fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    streams(&records(file)?)
}

/// Network, station and location of the first stream, and the time of its first sample.
fn identity_of(file: &File<'_>) -> Identity {
    let Ok(record) = Record::new(file.bytes, 0) else {
        return Identity::default();
    };
    let station = record.stream.rsplit_once('.').map_or("", |(station, _)| station);
    Identity {
        station: identity::text(station.trim_matches('.')),
        // Programs write this date if they know no time.
        time: Some(record.time.to_string()).filter(|time| !time.starts_with("1970-01-01")),
        ..Identity::default()
    }
}

/// The streams, except sums of components.
fn streams(records: &[Record<'_>]) -> Result<Vec<Component>, Refused> {
    let mut seen = BTreeMap::new();
    for record in records {
        let number = seen.len();
        seen.entry(record.stream.clone()).or_insert((number, record.at));
    }
    let mut streams: Vec<(String, (usize, usize))> = seen.into_iter().collect();
    streams.sort_by_key(|(_, (number, _))| *number);
    let is_component = |(name, _): &(String, _)| !name.rsplit('.').next().is_some_and(is_sum);
    let of_none = streams.first().filter(|one| !is_component(one)).cloned();
    streams.retain(is_component);
    match of_none.filter(|_| streams.is_empty()) {
        Some((found, (_, at))) => Err(refusals::not_acceleration(
            FilePlace::Byte(at + 1),
            found,
            "a stream of one component, this one sums several",
        )),
        None => Ok(streams
            .into_iter()
            .map(|(name, (_, at))| Component::new(name, FilePlace::Byte(at + 1)))
            .collect()),
    }
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let records = records(file)?;
    let streams = streams(&records)?;
    let stream = streams.get(index).ok_or(refusals::empty())?;
    let mut records = records.iter().filter(|record| record.stream == stream.name);
    let first = records.next().ok_or(refusals::empty())?;
    let step = first.time_step;
    let mut values = Vec::new();
    let mut counts = first.append(&mut values)?;
    let mut due = first.start + values.len() as f64 * step;
    let mut last = first;
    for record in records {
        if (record.time_step - step).abs() > 1e-6 * step.abs() {
            return Err(record.refused(record.time_step.to_string(), "the time step of the records before"));
        }
        if (record.start - due).abs() > 0.5 * step {
            let gap = format!("a start {:.4} s late", record.start - due);
            return Err(record.refused(gap, "a start one step after the record before"));
        }
        let before = values.len();
        counts |= record.append(&mut values)?;
        due += (values.len() - before) as f64 * step;
        last = record;
    }
    let text = |what: &str| Stated {
        value: (),
        place: stream.place,
        text: what.to_owned(),
    };
    Ok(Draft {
        values,
        end: FilePlace::Byte(last.at + 1),
        digit: 0.0,
        count: None,
        time_step: Some(Spacing::Even(Stated {
            value: step,
            place: stream.place,
            text: format!("{} samples a second", 1.0 / step),
        })),
        scale: if counts {
            Scale::Counts(text("whole numbers"))
        } else {
            Scale::Unknown
        },
        peak: None,
        provenance: stream.name.clone(),
        remarks: vec![reading("encoding", None, first.encoding_name())],
    })
}
