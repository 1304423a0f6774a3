//! SAC: a binary header of 632 bytes, then values in single precision.
//!
//! In the correct byte order the version of the header is 6 or 7. The header states whether the values are accelerations, but not their
//! unit. A step in single precision becomes the shortest decimal that it represents: 0.02, not 0.01999999955.

use super::numbers::{at_most, is_mark};
use super::stamp::Stamp;
use super::{Component, Draft, File, Format, Peak, Reader, Scale, Spacing, Stated, identity, reading};
use crate::refusals;
use crate::{Direction, FilePlace, Identity, Refused, Site};

/// Number of bytes of the header, and of the part that version 7 adds after the values.
const HEADER: usize = 632;
const FOOTER: usize = 176;

/// Byte offsets of fields.
const STEP: usize = 0;
const SMALLEST: usize = 4;
const LARGEST: usize = 8;
/// Degrees from upright, word 58.
const INCLINATION: usize = 232;
const VERSION: usize = 304;
const COUNT: usize = 316;
const KIND: usize = 340;
const QUANTITY: usize = 344;
const EVEN: usize = 420;
/// Depth of burial \[m\], word 34, and the reference time, from word 70.
const DEPTH: usize = 136;
const TIME: usize = 280;
const STATION: usize = 440;
const EVENT: usize = 448;
const CHANNEL: usize = 600;
const NETWORK: usize = 608;

/// Mark of an unset field.
const UNSET: f64 = -12345.0;

pub(super) const READER: Reader = Reader {
    format: Format::Sac,
    recognises: |file| Sac::new(file.bytes).is_some(),
    components,
    read: |file, _| read(file),
    identity: |file| Sac::new(file.bytes).map_or_else(Identity::default, |sac| identity_of(&sac)),
};

/// The bytes of a file and their order.
struct Sac<'t> {
    bytes: &'t [u8],
    big_endian: bool,
}

impl<'t> Sac<'t> {
    fn new(bytes: &'t [u8]) -> Option<Self> {
        let header = bytes.get(..HEADER)?;
        [true, false].map(|big_endian| Self { bytes, big_endian }).into_iter().find(|sac| {
            matches!(sac.whole(VERSION), 6 | 7)
                    // Text has no such bytes.
                    && header.contains(&0)
        })
    }

    fn word(&self, at: usize) -> [u8; 4] {
        let mut word = [0; 4];
        word.copy_from_slice(&self.bytes[at..at + 4]);
        word
    }

    fn whole(&self, at: usize) -> i32 {
        let word = self.word(at);
        if self.big_endian {
            i32::from_be_bytes(word)
        } else {
            i32::from_le_bytes(word)
        }
    }

    fn single(&self, at: usize) -> f32 {
        f32::from_bits(self.whole(at).cast_unsigned())
    }

    /// A name of eight letters; `None` if it is unset.
    fn name(&self, at: usize) -> Option<String> {
        self.name_of(at, 8)
    }

    fn name_of(&self, at: usize, length: usize) -> Option<String> {
        let name = self.bytes[at..at + length].split(|byte| *byte == 0).next()?;
        let name = String::from_utf8_lossy(name.trim_ascii()).into_owned();
        (!name.is_empty() && name != "-12345").then_some(name)
    }

    fn refused(&self, at: usize, allowed: &'static str) -> Refused {
        refusals::header(byte(at), self.whole(at).to_string(), allowed)
    }
}

fn byte(at: usize) -> FilePlace {
    FilePlace::Byte(at + 1)
}

fn sac<'t>(file: &File<'t>) -> Result<Sac<'t>, Refused> {
    Sac::new(file.bytes).ok_or(refusals::empty())
}

/// The channel; `UP` if it has no direction and the header describes an upright sensor.
fn components(file: &File<'_>) -> Result<Vec<Component>, Refused> {
    let sac = sac(file)?;
    let channel = sac.name(CHANNEL);
    let tells = channel.as_deref().and_then(Direction::of_component).is_some();
    let from_upright = f64::from(sac.single(INCLINATION));
    let upright = [0.0, 180.0].iter().any(|up| is_mark(from_upright, *up));
    let name = if upright && !tells {
        let channel = channel.map_or_else(String::new, |channel| channel + " ");
        Some((channel + "UP", byte(INCLINATION)))
    } else {
        channel.map(|channel| (channel, byte(CHANNEL)))
    };
    let depth = f64::from(sac.single(DEPTH));
    let site = if depth >= DEEP {
        Site::Borehole(format!("STDP {depth} m"))
    } else {
        Site::Ground
    };
    let component = name.map(|(name, place)| Component::new(name, place).at(site));
    Ok(component.into_iter().collect())
}

/// Largest depth of burial of a sensor that counts as at the ground \[m\].
const DEEP: f64 = 3.0;

/// Station, event, and the reference time of the header: year, day of the year, hour, minute and second.
fn identity_of(sac: &Sac<'_>) -> Identity {
    let [year, day, hour, minute, second] = [0, 4, 8, 12, 16].map(|at| sac.whole(TIME + at));
    let is_set = year > 0 && (1..=366).contains(&day);
    Identity {
        station: identity::text(&provenance(sac)),
        event: sac.name_of(EVENT, 16).as_deref().and_then(identity::text),
        time: is_set.then(|| Stamp::of_day([year, day, hour, minute, second]).to_string()),
        ..Identity::default()
    }
}

/// Network and station, if they are set.
fn provenance(sac: &Sac<'_>) -> String {
    let names = [NETWORK, STATION].map(|at| sac.name(at));
    names.into_iter().flatten().collect::<Vec<_>>().join(" ")
}

fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let sac = sac(file)?;
    if sac.whole(KIND) != 1 {
        return Err(sac.refused(KIND, "1, a time series"));
    }
    if sac.whole(EVEN) != 1 {
        return Err(sac.refused(EVEN, "1, values at equal steps"));
    }
    // Code 5 is unknown and 8 an acceleration; 6, 7 and 50 are displacement, velocity and volts.
    let quantity = match sac.whole(QUANTITY) {
        8 => "acceleration",
        5 | -12345 => "not stated",
        other => {
            return Err(refusals::not_acceleration(
                byte(QUANTITY),
                format!("IDEP {other}"),
                "the file of accelerations (IDEP 8)",
            ));
        }
    };
    let count = usize::try_from(sac.whole(COUNT)).ok().filter(|count| *count > 0);
    let count = count.ok_or_else(|| sac.refused(COUNT, "a number of samples above 0"))?;
    let (values, end) = values(&sac)?;
    let step = sac.single(STEP);
    Ok(Draft {
        values,
        end,
        digit: 0.0,
        count: Some(Stated {
            value: count,
            place: byte(COUNT),
            text: count.to_string(),
        }),
        time_step: Some(Spacing::Even(Stated {
            value: shortest(step),
            place: byte(STEP),
            text: step.to_string(),
        })),
        scale: if sac.whole(QUANTITY) == 8 {
            Scale::Acceleration
        } else {
            Scale::Unknown
        },
        peak: peak(&sac),
        provenance: provenance(&sac),
        remarks: vec![reading("quantity", None, quantity)],
    })
}

/// The values, and the place of the last.
fn values(sac: &Sac<'_>) -> Result<(Vec<f64>, FilePlace), Refused> {
    let data = &sac.bytes[HEADER..];
    let footer = if sac.whole(VERSION) == 7 { FOOTER } else { 0 };
    let n_values = data.len().saturating_sub(footer) / 4;
    at_most(n_values)?;
    let mut values = Vec::with_capacity(n_values);
    for index in 0..n_values {
        let at = HEADER + 4 * index;
        let value = f64::from(sac.single(at));
        if !value.is_finite() {
            return Err(refusals::header(byte(at), value.to_string(), "a finite value"));
        }
        values.push(value);
    }
    Ok((values, byte(HEADER + 4 * n_values.saturating_sub(1))))
}

/// The number written by the shortest decimal of a single-precision number.
fn shortest(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}

fn peak(sac: &Sac<'_>) -> Option<Peak> {
    let [smallest, largest] = [SMALLEST, LARGEST].map(|at| f64::from(sac.single(at)));
    let is_set = |value: f64| value.is_finite() && !is_mark(value, UNSET);
    if !(is_set(smallest) && is_set(largest)) {
        return None;
    }
    let value = smallest.abs().max(largest.abs());
    Some(Peak {
        stated: Stated {
            value,
            place: byte(SMALLEST),
            text: format!("{smallest} to {largest}"),
        },
        digit: value * f64::from(f32::EPSILON),
        unit: None,
    })
}
