//! Numbers as printed, digit by digit.

use crate::listed::listed;
use serde::Deserialize;

/// A number as printed; trailing zeros count as digits.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "String")]
pub struct Printed {
    /// Its value.
    pub value: f64,
    text: String,
    /// 10 to the power of the number of printed decimals.
    per_last: f64,
}

impl TryFrom<String> for Printed {
    type Error = NotPrinted;

    fn try_from(text: String) -> Result<Self, NotPrinted> {
        let (whole, decimals) = text.split_once('.').unwrap_or((&text, "0"));
        let is_number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        if !is_number(whole.trim_start_matches('-')) || !is_number(decimals) {
            return Err(NotPrinted(text));
        }
        let n_decimals = text.split_once('.').map_or(0, |(_, after)| after.len());
        let value = text.parse().map_err(|_| NotPrinted(text.clone()))?;
        Ok(Self {
            value,
            per_last: (0..n_decimals).fold(1.0, |power, _| 10.0 * power),
            text,
        })
    }
}

impl Printed {
    /// The digits as printed.
    pub fn text(&self) -> &str {
        &self.text
    }
}

/// A text that is not a number as a paper prints it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("found \"{0}\", allowed a decimal number")]
pub struct NotPrinted(String);

listed! {
    /// How a computed number gives the printed digits.
    pub enum PrintedDigits { words: &'static str;
        /// Rounding the computed number gives the printed digits.
        Rounded = "rounded",
        /// Cutting off further digits of the computed number gives the printed digits.
        CutOff = "cut off",
        /// The digits differ.
        Other = "no",
    }
}

impl PrintedDigits {
    pub(crate) fn of(printed: &Printed, computed: f64) -> Self {
        let in_last = |value: f64| value * printed.per_last;
        let is_printed = |digits: f64| (digits - in_last(printed.value)).abs() < 0.5;
        if is_printed(in_last(computed).round()) {
            Self::Rounded
        } else if is_printed(in_last(computed).trunc()) {
            Self::CutOff
        } else {
            Self::Other
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_digits_at_their_bounds() {
        for (printed, computed, digits) in [
            ("243.64", 243.649, PrintedDigits::CutOff),
            ("243.64", 243.6449, PrintedDigits::Rounded),
            ("243.64", 243.65, PrintedDigits::Other),
            ("-243.64", -243.649, PrintedDigits::CutOff),
            ("-243.64", -243.635, PrintedDigits::Rounded),
            ("243.64", 243.634, PrintedDigits::Other),
            ("3397.0", 3397.04, PrintedDigits::Rounded),
            ("3397.00", 3397.04, PrintedDigits::Other),
            ("3607", 3607.4, PrintedDigits::Rounded),
            ("0", 0.0, PrintedDigits::Rounded),
            ("1.97", 1.97, PrintedDigits::Rounded),
            ("1.0", f64::NAN, PrintedDigits::Other),
        ] {
            let number = Printed::try_from(printed.to_string()).expect("a number");
            assert_eq!(PrintedDigits::of(&number, computed), digits, "{printed}, {computed}");
        }
    }

    #[test]
    fn extreme_texts_that_are_no_printed_numbers() {
        for text in ["", "-", "1e3", "inf", "nan", "1.", ".5", "1.2.3", "thirty-six"] {
            assert!(Printed::try_from(text.to_string()).is_err(), "{text}");
        }
    }
}
