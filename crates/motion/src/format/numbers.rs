//! Values as they are read, with the limit on their number and their printed precision.

use crate::line::Line;
use crate::record::MAX_SAMPLES;
use crate::{FilePlace, Refused};

/// The numbers of some lines.
#[derive(Debug)]
pub(super) struct Numbers {
    pub(super) values: Vec<f64>,
    /// Place of the last number.
    pub(super) end: FilePlace,
    /// Unit of the last printed digit of the largest number.
    pub(super) digit: f64,
}

/// Refuses more values than a record may have.
pub(super) fn at_most(n_values: usize) -> Result<(), Refused> {
    if n_values <= MAX_SAMPLES {
        return Ok(());
    }
    Err(Refused::default()
        .found(format!("more samples than the {MAX_SAMPLES} allowed"))
        .help("cut the record to the shaking that matters, or resample it"))
}

/// Values that are read one by one.
#[derive(Default)]
pub(super) struct Values<'t> {
    found: Vec<f64>,
    largest: Largest<'t>,
    last_line: Option<usize>,
}

impl<'t> Values<'t> {
    /// Appends a value; the field is its printed form.
    pub(super) fn push(&mut self, line: Line<'_>, value: f64, field: &'t [u8]) -> Result<(), Refused> {
        at_most(self.found.len() + 1)?;
        self.largest.see(value, field);
        self.found.push(value);
        self.last_line = Some(line.number);
        Ok(())
    }

    /// The values. Without any, the header is the place of the last one.
    pub(super) fn finish(self, header: Line<'_>) -> Numbers {
        Numbers {
            digit: self.largest.digit(),
            end: FilePlace::Line(self.last_line.unwrap_or(header.number)),
            values: self.found,
        }
    }
}

/// Whether a number equals a mark to the last bit: files write marks in one way.
pub(super) fn is_mark(value: f64, mark: f64) -> bool {
    value.total_cmp(&mark).is_eq()
}

/// The largest of printed numbers, with its printed precision.
#[derive(Default)]
struct Largest<'t> {
    value: f64,
    field: &'t [u8],
}

impl<'t> Largest<'t> {
    fn see(&mut self, value: f64, field: &'t [u8]) {
        if value.abs() >= self.value {
            self.value = value.abs();
            self.field = field;
        }
    }

    fn digit(&self) -> f64 {
        last_digit(self.field)
    }
}

/// The unit of the last digit of a printed number: 0.01 for `-12.50`, 10 for `1.5E+2`.
pub(super) fn last_digit(field: &[u8]) -> f64 {
    let text = String::from_utf8_lossy(field.trim_ascii()).to_ascii_uppercase();
    let (mantissa, exponent) = text.split_once(['E', 'D']).unwrap_or((&text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent: i64 = exponent.parse().unwrap_or(0);
    let decimals = i64::try_from(decimals).unwrap_or(i64::MAX);
    let exponent = exponent.saturating_sub(decimals).clamp(-400, 400);
    format!("1e{exponent}").parse().expect("a number in exponent notation")
}
