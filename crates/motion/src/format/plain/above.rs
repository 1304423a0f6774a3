//! Numbers above the rows that are not values: their number, their step, a scale.

use super::super::Stated;
use super::rows::Rows;
use crate::line::{Line, number};
use crate::refusals;
use crate::{FilePlace, Refused};

/// Longest plausible step above values \[s\].
const LONGEST: f64 = 0.1;

/// Factors that turn g into other units. One above the values may be a scale, and nothing shows whether it was applied.
const FACTORS: [f64; 8] = [9.81, 9.806, 9.806_65, 981.0, 980.0, 980.6, 980.665, 386.4];

/// A line with the number of values or rows below it and their time step, such as `11800  0.005`, or two lines.
pub(super) struct Above<'t> {
    /// The line with the step.
    line: Line<'t>,
    pub(super) count: Option<usize>,
    /// Time step, above zero \[s\]; `None` above rows with times.
    pub(super) step: Option<f64>,
    /// Number of rows that it occupies.
    pub(super) n_rows: usize,
}

impl<'t> Above<'t> {
    /// The first row, or the first two, if they are numbers of a header.
    pub(super) fn new(rows: &Rows<'_, 't>) -> Result<Option<Self>, Refused> {
        match rows.n_columns {
            2 => Ok(Self::of_one_line(rows)),
            1 => match Self::of_count(rows) {
                Some(count) => Ok(Some(count)),
                None => Self::of_two_lines(rows),
            },
            _ => Ok(None),
        }
    }

    /// The number of the rows below it, which hold several numbers each.
    fn of_count(rows: &Rows<'_, 't>) -> Option<Self> {
        let line = rows.first();
        let count: usize = std::str::from_utf8(line.bytes.trim_ascii()).ok()?.parse().ok()?;
        let several = rows.iter().skip(1).all(|row| row.fields().nth(1).is_some());
        // A number that is far off counts something else.
        let n_rows = rows.len - 1;
        (several && n_rows > 1 && count > n_rows / 2).then_some(Self {
            line,
            count: Some(count),
            step: None,
            n_rows: 1,
        })
    }

    fn of_one_line(rows: &Rows<'_, 't>) -> Option<Self> {
        let line = rows.first();
        let mut fields = line.fields();
        let count: usize = std::str::from_utf8(fields.next()?).ok()?.parse().ok()?;
        let step = positive(fields.next()?)?;
        let second = rows.iter().nth(1)?;
        let in_pairs = second.fields().count() == 2;
        // In the first row of times and values, the next time would be larger than this number.
        let is_time_above = in_pairs && number(second.fields().next()?)? > count as f64;
        let counts = count == rows.n_numbers - 2 || (count == rows.len - 1 && in_pairs);
        (counts && !is_time_above).then_some(Self {
            line,
            count: Some(count),
            step: Some(step),
            n_rows: 1,
        })
    }

    fn of_two_lines(rows: &Rows<'_, 't>) -> Result<Option<Self>, Refused> {
        let head: Vec<Line<'t>> = rows.iter().take(3).collect();
        let [first, second, third] = head[..] else {
            return Ok(None);
        };
        let [Some(one), Some(other)] = [first, second].map(|line| positive(line.bytes)) else {
            return Ok(None);
        };
        let n_values = (rows.n_numbers - 2) as f64;
        let counts = |value: f64| (value - n_values).abs() < 0.5 && n_values > 2.0;
        let above = |line, count: bool, step| Self {
            line,
            count: count.then_some(rows.n_numbers - 2),
            step: Some(step),
            n_rows: 2,
        };
        if counts(one) && is_step(other) {
            return Ok(Some(above(second, true, other)));
        }
        if counts(other) && is_step(one) {
            return Ok(Some(above(first, true, one)));
        }
        // Values with many digits, or in another style, do not look like header numbers by chance.
        let (of_step, of_values) = (digits(second.bytes), digits(third.bytes));
        let is_apart = of_values >= 5 || of_values > of_step + 1;
        let is_one = (one - 1.0).abs() <= 0.0;
        if !is_step(other) {
            return Ok(None);
        }
        if is_one && is_apart {
            return Ok(Some(above(second, false, other)));
        }
        let is_factor = |factor: &f64| (one - factor).abs() < 1e-9 * factor;
        if is_one || FACTORS.iter().any(is_factor) {
            return Err(refusals::header_numbers(
                [first.number, second.number],
                format!("{}, {}", first.excerpt(), second.excerpt()),
                "perhaps a scale and a time step",
            ));
        }
        Ok(None)
    }

    pub(super) fn stated<T>(&self, value: T) -> Stated<T> {
        Stated {
            value,
            place: FilePlace::Line(self.line.number),
            text: self.line.excerpt(),
        }
    }
}

/// A number above zero.
fn positive(field: &[u8]) -> Option<f64> {
    number(field).filter(|value| value.is_finite() && *value > 0.0)
}

/// Whether a number is a typical step of recorders and programs: two digits, or one over a whole number of samples per second.
fn is_step(value: f64) -> bool {
    let rate = 1.0 / value;
    let is_whole = (rate - rate.round()).abs() <= 1e-6 * rate;
    let two_digits = format!("{value:.1e}")
        .parse()
        .is_ok_and(|short: f64| (short - value).abs() <= 1e-12);
    value <= LONGEST && rate <= 1000.5 && (is_whole || two_digits)
}

/// Digits of a printed number without its exponent.
fn digits(field: &[u8]) -> usize {
    let mantissa = field.split(|byte| b"EeDd".contains(byte)).next();
    let digits = mantissa.unwrap_or_default().iter();
    digits.filter(|byte| byte.is_ascii_digit()).count()
}
