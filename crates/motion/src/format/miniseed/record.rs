//! One record: stream, start, step and packing in its header.

use super::super::numbers::at_most;
use super::super::stamp::Stamp;
use super::samples;
use crate::refusals;
use crate::{FilePlace, Refused};

/// Bytes of the fixed headers.
const HEADER_2: usize = 48;
const HEADER_3: usize = 40;

/// Longest record, as a power of two; the standard allows as much.
const LONGEST: u8 = 20;

/// A record of a file.
pub(super) struct Record<'t> {
    /// First byte in the file, from 0, and number of bytes.
    pub(super) at: usize,
    pub(super) length: usize,
    /// Network, station, location and channel.
    pub(super) stream: String,
    /// Start \[s\] after a fixed day in the past, and as a date with a time of day.
    pub(super) start: f64,
    pub(super) time: Stamp,
    /// Step \[s\], above zero.
    pub(super) time_step: f64,
    n_samples: usize,
    encoding: u8,
    big_endian: bool,
    data: &'t [u8],
}

/// Whether a record begins here: `MS` and version 3, or a sequence number and a quality.
pub(super) fn begins(bytes: &[u8]) -> bool {
    if bytes.starts_with(b"MS\x03") {
        return true;
    }
    let is_number = |byte: &u8| byte.is_ascii_digit() || *byte == b' ' || *byte == 0;
    bytes.len() >= HEADER_2
        && bytes[..6].iter().all(is_number)
        && matches!(bytes[6], b'D' | b'R' | b'Q' | b'M')
        && matches!(bytes[7], b' ' | 0)
        && year(bytes, 20).is_some()
}

/// The year at an offset, and whether its first byte is the higher one.
fn year(bytes: &[u8], at: usize) -> Option<(u16, bool)> {
    let pair = [*bytes.get(at)?, *bytes.get(at + 1)?];
    let known = 1900..=2200;
    let (big, little) = (u16::from_be_bytes(pair), u16::from_le_bytes(pair));
    if known.contains(&big) {
        Some((big, true))
    } else {
        known.contains(&little).then_some((little, false))
    }
}

impl<'t> Record<'t> {
    /// The record that begins at a byte of a file.
    pub(super) fn new(file: &'t [u8], at: usize) -> Result<Self, Refused> {
        let bytes = &file[at..];
        if !begins(bytes) {
            return Err(header(at, &bytes[..bytes.len().min(8)], "a record of miniSEED"));
        }
        let record = if bytes.starts_with(b"MS") {
            Self::version_3(bytes, at)
        } else {
            Self::version_2(bytes, at)
        }?;
        if record.time_step.is_finite() && record.time_step > 0.0 {
            Ok(record)
        } else {
            Err(refusals::time_step(FilePlace::Byte(at + 1), record.time_step))
        }
    }

    fn version_2(bytes: &'t [u8], at: usize) -> Result<Self, Refused> {
        let cut = || truncated(at, bytes);
        let (year, big_endian) = year(bytes, 20).ok_or_else(cut)?;
        let short = |at: usize| {
            let pair = bytes.get(at..at + 2).map(|pair| [pair[0], pair[1]])?;
            Some(if big_endian {
                u16::from_be_bytes(pair)
            } else {
                u16::from_le_bytes(pair)
            })
        };
        let signed = |at: usize| short(at).map(u16::cast_signed).map(f64::from);
        let (factor, multiplier) = signed(32).zip(signed(34)).ok_or_else(cut)?;
        let (packing, exact) =
            blockettes(bytes, &short).ok_or_else(|| header(at, &bytes[..8], "a record with blockettes that are whole"))?;
        // Old records have no blockette 1000 with the packing: theirs is Steim 1.
        let packing = packing.or_else(|| Some([10, u8::from(big_endian), power(bytes)?]));
        let packing = packing.ok_or_else(|| {
            header(
                at,
                &bytes[..8],
                "a record with a blockette 1000 that tells its length, or another record behind it",
            )
        })?;
        let [encoding, order, power] = packing;
        if !(6..=LONGEST).contains(&power) {
            return Err(header(at, &[power], "a length of the record between 2^6 and 2^20 bytes"));
        }
        let length = 1 << power;
        let offset = usize::from(short(44).ok_or_else(cut)?);
        let data = bytes.get(..length).ok_or_else(cut)?.get(offset..);
        let stream = [18..20, 8..13, 13..15, 15..18].map(|range| String::from_utf8_lossy(bytes[range].trim_ascii()).into_owned());
        let day = short(22).ok_or_else(cut)?;
        let of_day = [bytes[24], bytes[25], bytes[26]];
        let seconds = Day { year, day }.seconds() + clock(of_day);
        Ok(Self {
            at,
            length,
            stream: stream.join("."),
            time: time(year, day, of_day),
            start: seconds + f64::from(short(28).ok_or_else(cut)?) * 1e-4,
            time_step: exact.unwrap_or_else(|| step(factor, multiplier)),
            n_samples: usize::from(short(30).ok_or_else(cut)?),
            encoding,
            big_endian: order == 1,
            data: data.ok_or_else(|| header(at, &bytes[44..46], "the start of the values in the record"))?,
        })
    }

    fn version_3(bytes: &'t [u8], at: usize) -> Result<Self, Refused> {
        let cut = || truncated(at, bytes);
        let fixed = bytes.get(..HEADER_3).ok_or_else(cut)?;
        let short = |at: usize| u16::from_le_bytes([fixed[at], fixed[at + 1]]);
        let long = |at: usize| u32::from_le_bytes([fixed[at], fixed[at + 1], fixed[at + 2], fixed[at + 3]]);
        let mut rate = [0; 8];
        rate.copy_from_slice(&fixed[16..24]);
        let rate = f64::from_le_bytes(rate);
        let (name_length, extra) = (usize::from(fixed[33]), usize::from(short(34)));
        let data_start = HEADER_3 + name_length + extra;
        let data_length = usize::try_from(long(36)).map_err(|_| cut())?;
        let length = data_start.saturating_add(data_length);
        let record = bytes.get(..length).ok_or_else(cut)?;
        let name = String::from_utf8_lossy(&record[HEADER_3..HEADER_3 + name_length]);
        let encoding = fixed[15];
        let (year, day) = (short(8), short(10));
        let of_day = [fixed[12], fixed[13], fixed[14]];
        let seconds = Day { year, day }.seconds() + clock(of_day);
        Ok(Self {
            at,
            length,
            stream: stream_of(&name),
            time: time(year, day, of_day),
            start: seconds + f64::from(long(4)) * 1e-9,
            // A positive rate is samples per second, a negative one a step with its sign changed.
            time_step: if rate > 0.0 { 1.0 / rate } else { -rate },
            n_samples: usize::try_from(long(24)).map_err(|_| cut())?,
            encoding,
            big_endian: matches!(encoding, 10 | 11),
            data: &record[data_start..],
        })
    }

    /// Unpacks the values after others. Returns whether they are whole numbers.
    pub(super) fn append(&self, values: &mut Vec<f64>) -> Result<bool, Refused> {
        let before = values.len();
        if !matches!(self.encoding, 1 | 3 | 4 | 5 | 10 | 11) {
            let found = format!("encoding {}", self.encoding);
            return Err(self.refused(found, "whole numbers, floats, Steim 1 or Steim 2"));
        }
        let found = samples::unpack(self.encoding, self.big_endian, self.data, self.n_samples);
        let found = found.ok_or_else(|| {
            let found = "packed differences that do not lead to the last value".to_owned();
            self.refused(found, "the last value that the first frame repeats")
        })?;
        at_most(values.len() + found.len())?;
        values.extend(found);
        if values.len() - before != self.n_samples {
            return Err(refusals::sample_count(
                FilePlace::Byte(self.at + 1),
                values.len() - before,
                self.n_samples,
            ));
        }
        if !values[before..].iter().all(|value| value.is_finite()) {
            return Err(self.refused("a value that is not finite".to_owned(), "finite values"));
        }
        Ok(!matches!(self.encoding, 4 | 5))
    }

    pub(super) fn encoding_name(&self) -> &'static str {
        match self.encoding {
            1 => "16-bit whole numbers",
            3 => "32-bit whole numbers",
            4 => "single precision",
            5 => "double precision",
            10 => "Steim 1",
            _ => "Steim 2",
        }
    }

    pub(super) fn refused(&self, found: String, allowed: &'static str) -> Refused {
        refusals::header(FilePlace::Byte(self.at + 1), found, allowed)
    }
}

/// The length of a record as a power of 2, from the beginning of the next record or the end of the file.
fn power(bytes: &[u8]) -> Option<u8> {
    let ends = |power: &u8| {
        let rest = bytes.get(1 << power..);
        rest.is_some_and(|rest| rest.is_empty() || begins(rest))
    };
    (7..=LONGEST).find(ends)
}

/// Packing from blockette 1000 and step from blockette 100, if they exist. The chain must move forwards, so it ends.
fn blockettes(bytes: &[u8], short: &impl Fn(usize) -> Option<u16>) -> Option<(Option<[u8; 3]>, Option<f64>)> {
    let mut at = usize::from(short(46)?);
    let (mut packing, mut exact) = (None, None);
    while at >= HEADER_2 {
        match short(at)? {
            1000 => {
                packing = Some([*bytes.get(at + 4)?, *bytes.get(at + 5)?, *bytes.get(at + 6)?]);
            }
            100 => {
                let (high, low) = (short(at + 4)?, short(at + 6)?);
                // The halves of a word have the order of the bytes.
                let big_endian = short(20) == Some(u16::from_be_bytes([bytes[20], bytes[21]]));
                let (high, low) = if big_endian { (high, low) } else { (low, high) };
                let rate = f32::from_bits(u32::from(high) << 16 | u32::from(low));
                exact = rate.to_string().parse().ok().filter(|rate| *rate > 0.0).map(|rate: f64| 1.0 / rate);
            }
            _ => {}
        }
        let next = usize::from(short(at + 2)?);
        if next <= at {
            break;
        }
        at = next;
    }
    Some((packing, exact))
}

/// The step of a rate with factor and multiplier; negative ones divide.
fn step(factor: f64, multiplier: f64) -> f64 {
    let part = |value: f64| if value < 0.0 { -value } else { 1.0 / value };
    part(factor) * part(multiplier)
}

fn time(year: u16, day: u16, [hour, minute, second]: [u8; 3]) -> Stamp {
    Stamp::of_day([year.into(), day.into(), hour.into(), minute.into(), second.into()])
}

fn clock([hour, minute, second]: [u8; 3]) -> f64 {
    (f64::from(hour) * 60.0 + f64::from(minute)) * 60.0 + f64::from(second)
}

/// A year and a day of the year, from 1.
struct Day {
    year: u16,
    day: u16,
}

impl Day {
    /// Seconds from the beginning of year 1 of the present calendar.
    fn seconds(self) -> f64 {
        let before = u32::from(self.year).saturating_sub(1);
        let days = 365 * before + before / 4 - before / 100 + before / 400 + u32::from(self.day);
        f64::from(days) * 86400.0
    }
}

/// `NET.STA.LOC.CHA` for `FDSN:NET_STA_LOC_B_S_S`; other names are unchanged.
fn stream_of(name: &str) -> String {
    let parts: Vec<&str> = name.strip_prefix("FDSN:").unwrap_or_default().split('_').collect();
    match parts[..] {
        [network, station, location, band, source, subsource] => {
            format!("{network}.{station}.{location}.{band}{source}{subsource}")
        }
        _ => name.to_owned(),
    }
}

fn header(at: usize, found: &[u8], allowed: &'static str) -> Refused {
    refusals::header(FilePlace::Byte(at + 1), found.escape_ascii().to_string(), allowed)
}

fn truncated(at: usize, bytes: &[u8]) -> Refused {
    refusals::truncated(FilePlace::Byte(at + bytes.len()), "the end of its last record")
}
