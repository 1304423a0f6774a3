//! Numbers, tables, answers and refusals, for people and for programs.
//!
//! All other crates write the numbers in messages, tables and figures with this crate. Commands print an [`Answer`]: as text, CSV or JSON.
//!
//! ```
//! use pounding_text::{Cell, Table, rounded_up, short};
//!
//! // T = 2π √(m/k) of 75 t on 2.056 MN/m is 1.200049 s: four digits of it.
//! let period = std::f64::consts::TAU * (75e3_f64 / 2.056e6).sqrt();
//! assert_eq!(short(period), "1.200");
//!
//! // Peaks of 41.3 mm and 22.1 mm combine to √(41.3² + 22.1²) = 46.84 mm; a gap that is enough is never rounded down.
//! let gap = (41.3_f64 * 41.3 + 22.1 * 22.1).sqrt();
//! assert_eq!(rounded_up(gap, 1), "46.9");
//!
//! // A number that does not exist is an empty cell, and no cell holds NaN.
//! let table = Table::of([(period, f64::NAN)])
//!     .column("period_s", |row| Cell::number(row.0, short))
//!     .column("gap_mm", |row| row.1);
//! assert_eq!(table.csv(), "period_s,gap_mm\n1.200,\n");
//! ```
//!
//! An answer also says how its parts stand on a page: [`Where`] and [`Manner`]. `pounding-report` makes the page. Texts inside figures
//! belong to `pounding-plot`. `pounding-sweep` writes its millions of rows without [`Cell`] but with the same rule. This crate reads no
//! files, and knows neither structures nor contact.
//!
//! Where to start:
//!
//! - [`Answer`]: sentences, tables, figures and facts of a command, once for every [`Form`].
//! - [`Table`]: rows and columns for people, for programs or for both; [`Grid`] is the table that people read.
//! - [`Unit`]: the ending of a name in files, the unit that people read, the factor between both, and the digits.
//! - [`short`], [`digits`] and [`plain`]: four digits, seven digits, a number as its user wrote it.
//! - [`rounded_up`] and [`rounded_down`]: numbers that are safe on one side.
//! - [`Cell`] and [`json_text`]: tables and files without NaN.
//! - [`Refused`]: the reason for a refusal, in parts that become a sentence at the end.
//! - [`visible`] and [`message`]: text for people, without letters that steer their terminal.

mod answer;
mod cell;
mod grid;
mod knob;
mod place;
mod points;
mod refused;
mod table;
mod terminal;
mod unit;
mod visible;
mod words;

pub use answer::{Answer, Form, Manner, Part, Sentences, Where};
pub use cell::{Cell, CellKind, CellValue, harmless, json_text};
pub use grid::{Grid, Heading, NONE, Shown};
pub use knob::{Knob, Naming};
pub use place::{FaultPlace, Spot};
pub use points::{CurveWords, curve_points};
pub use refused::{Refusal, Refused, refusal_json};
pub use table::Table;
pub use terminal::{cut, paragraph};
pub use unit::Unit;
pub use visible::{message, steers, visible};
pub use words::{RefusalKind, Words};

/// A number as a message repeats it: as written if that is short, else with seven significant digits. It never prints the 309 digits of
/// 1.7e308.
pub fn plain(value: f64) -> String {
    // A negative zero loses its sign.
    let whole = (value + 0.0).to_string();
    if whole.len() <= LONGEST {
        return whole;
    }
    let seven = digits(value);
    match seven.split_once('e') {
        None => seven,
        Some((digits, exponent)) => {
            let digits = digits.trim_end_matches('0').trim_end_matches('.');
            format!("{digits}e{exponent}")
        }
    }
}

/// Longest number that a message repeats in full \[letters\].
const LONGEST: usize = 12;

/// A number with two decimals, such as a ratio.
pub fn two_decimals(value: f64) -> String {
    format!("{value:.2}")
}

/// A number with two significant digits, for values known to an order of magnitude.
pub fn two_digits(value: f64) -> String {
    digits(format!("{value:.1e}").parse().unwrap_or(value))
}

/// A length \[m\] in millimetres to a tenth, without zeros at its end.
pub fn millimetres(length: f64) -> String {
    digits((length * 1e4).round() / 10.0)
}

/// A needed width \[m\] in millimetres, rounded up to a tenth so that it suffices, without zeros at its end.
pub fn millimetres_up(length: f64) -> String {
    let up = rounded_up(length * 1e3, 1);
    up.parse().map_or(up, digits)
}

/// An instant \[s\] to a tenth of a millisecond, without zeros at its end.
pub fn instant(time: f64) -> String {
    digits((time * 1e4).round() * 1e-4)
}

/// A number with four significant digits.
pub fn short(value: f64) -> String {
    // A negative zero loses its sign.
    let scientific = format!("{:.3e}", value + 0.0);
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        _ if value == 0.0 => "0".into(),
        Some(exponent @ -4..=5_i32) => {
            let decimals = usize::try_from(3 - exponent).unwrap_or(0);
            format!("{value:.decimals$}")
        }
        _ => scientific,
    }
}

/// A number with seven significant digits in plain notation, without trailing zeros.
pub fn digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        // A negative zero loses its sign.
        return format!("{}", value + 0.0);
    }
    let scientific = format!("{value:.6e}");
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        Some(exponent @ -6..=15) => {
            let rounded: f64 = scientific.parse().unwrap_or(value);
            let decimals = usize::try_from(6_i32 - exponent).unwrap_or(0);
            let plain = format!("{rounded:.decimals$}");
            if plain.contains('.') {
                plain.trim_end_matches('0').trim_end_matches('.').to_string()
            } else {
                plain
            }
        }
        _ => scientific,
    }
}

/// A relative error in per cent, with two significant digits.
pub fn percent(error: f64) -> String {
    let value = 100.0 * error;
    if value == 0.0 {
        return "0 %".into();
    }
    if value < 1e-9 {
        // The exact run has about this accuracy.
        return "<1e-9 %".into();
    }
    if !value.is_finite() {
        return "∞".into();
    }
    let scientific = format!("{value:.1e}");
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        Some(exponent @ -2..=3_i32) => {
            let decimals = usize::try_from(1 - exponent).unwrap_or(0);
            format!("{value:.decimals$} %")
        }
        _ => format!("{scientific} %"),
    }
}

/// An error of a time, in milliseconds with two significant digits.
pub fn milliseconds(seconds: f64) -> String {
    percent(10.0 * seconds).replace('%', "ms")
}

/// Relative rounding error of a number that was written with few digits \[–\].
const SLACK: f64 = 1e-12;

/// A number ≥ 0 with this many decimals, rounded down, for lower bounds.
pub fn rounded_down(value: f64, decimals: usize) -> String {
    rounded(value, decimals, |text| text > value * (1.0 + SLACK), -0.5)
}

/// A number ≥ 0 with this many decimals, rounded up, for widths that suffice.
pub fn rounded_up(value: f64, decimals: usize) -> String {
    rounded(value, decimals, |text| text < value * (1.0 - SLACK), 0.5)
}

/// The nearest text. If its number is `wrong`, the text on the other side: that of the number shifted by a part of the last digit.
fn rounded(value: f64, decimals: usize, wrong: impl Fn(f64) -> bool, shift: f64) -> String {
    let nearest = format!("{value:.decimals$}");
    if !nearest.parse().is_ok_and(wrong) {
        return nearest;
    }
    let last: f64 = format!("1e-{decimals}").parse().unwrap_or(1.0);
    format!("{:.decimals$}", value + shift * last)
}

#[cfg(test)]
mod tests {
    use super::{digits, plain, rounded_down, rounded_up};

    #[test]
    fn issue_messages_had_numbers_of_three_hundred_digits() {
        for (value, wanted) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-75e3, "-75000"),
            (0.012_345_678, "0.012345678"),
            (1.0 / 3.0, "0.3333333"),
            (f64::MAX, "1.797693e308"),
            (1.7e308, "1.7e308"),
            (-1e300, "-1e300"),
            (1e-300, "1e-300"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(plain(value), wanted);
        }
    }

    #[test]
    fn reference_seven_significant_digits() {
        for (value, wanted) in [
            (0.0, "0"),
            (-0.0, "0"),
            (3_607.138_612, "3607.139"),
            (-0.030_000_000_1, "-0.03"),
            (1.97, "1.97"),
            (0.999_999_99, "1"),
            (3_000_000.0, "3000000"),
            (123_456_789.0, "123456800"),
            (1.5e-9, "1.500000e-9"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(digits(value), wanted);
        }
    }

    #[test]
    fn reference_numbers_that_promise() {
        for (value, down, up) in [
            (41.24, "41.2", "41.3"),
            (41.26, "41.2", "41.3"),
            (41.25, "41.2", "41.3"),
            (99.96, "99.9", "100.0"),
            (0.04, "0.0", "0.1"),
            (0.0, "0.0", "0.0"),
            // The value is meant as written here, whatever rounding made of it.
            (1e3 * 0.0413, "41.3", "41.3"),
            (0.1 + 0.2, "0.3", "0.3"),
        ] {
            assert_eq!((&*rounded_down(value, 1), &*rounded_up(value, 1)), (down, up));
        }
        assert_eq!(rounded_up(1e300, 1).len(), 303);
        assert_eq!(rounded_up(f64::INFINITY, 1), "inf");
    }
}
