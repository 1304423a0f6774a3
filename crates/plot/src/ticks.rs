//! Round numbers on an axis.

/// A tick is a round number with its label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    /// Position.
    pub(super) value: f64,
    /// Label, with a real minus sign.
    pub(super) label: String,
}

/// Chooses ticks 1, 2 or 5 × 10ⁿ apart: the most that `fit`, from about `most` steps downwards.
///
/// If even two ticks do not fit, returns two crowded ticks instead of an axis without numbers.
pub(super) fn choose(range: (f64, f64), most: u32, fit: impl Fn(&[Tick]) -> bool) -> Vec<Tick> {
    let mut fewest = Vec::new();
    // Fewer than six steps can leave an axis with only two numbers.
    for steps in (1..=most.max(6)).rev() {
        let ticks = at_least_apart(range, (range.1 - range.0) / f64::from(steps));
        if ticks.len() < 2 {
            break;
        }
        if fit(&ticks) {
            return ticks;
        }
        fewest = ticks;
    }
    fewest
}

/// Returns the ticks at the smallest distance 1, 2 or 5 × 10ⁿ that is at least `distance`.
fn at_least_apart((from, to): (f64, f64), distance: f64) -> Vec<Tick> {
    let (digit, exponent) = round_up(distance);
    let step = decimal(digit, exponent);
    // The tolerance keeps an end of the axis that is a tick up to rounding.
    let (first, last) = ((from / step - 1e-9).ceil(), (to / step + 1e-9).floor());
    #[expect(clippy::cast_possible_truncation, reason = "`scale` refuses ranges where these pass 1e10")]
    let digits: Vec<i64> = (first as i64..=last as i64).map(|k| k * digit).collect();
    let largest = digits.iter().map(|digits| digits.abs()).max().unwrap_or(0);
    let magnitude = exponent + i32::try_from(largest.to_string().len()).expect("an integer has few digits");
    let powers = magnitude > 6 || exponent < -6;
    digits
        .iter()
        .map(|&n| Tick {
            value: decimal(n, exponent),
            label: label(n, exponent, powers),
        })
        .collect()
}

/// Rounds up to 1, 2 or 5 × 10ⁿ; returns the digit and n.
fn round_up(distance: f64) -> (i64, i32) {
    let written = format!("{distance:e}");
    let (mantissa, exponent) = written.split_once('e').expect("this format always has an exponent");
    let mantissa: f64 = mantissa.parse().expect("a finite number was written");
    let exponent: i32 = exponent.parse().expect("an integer was written");
    match mantissa {
        // The tolerance keeps 0.1 × 3 / 3 from becoming 0.2.
        m if m <= 1.0 + 1e-9 => (1, exponent),
        m if m <= 2.0 + 1e-9 => (2, exponent),
        m if m <= 5.0 + 1e-9 => (5, exponent),
        _ => (1, exponent + 1),
    }
}

/// Returns digits × 10ⁿ, correctly rounded: reading a written number is exact on every machine.
pub(super) fn decimal(digits: i64, exponent: i32) -> f64 {
    format!("{digits}e{exponent}")
        .parse()
        .expect("an integer with an exponent is a number")
}

/// Writes digits × 10ⁿ with a real minus sign, as a decimal number or, if this is long, as a power of ten.
pub(super) fn label(digits: i64, exponent: i32, powers: bool) -> String {
    let sign = if digits < 0 { "\u{2212}" } else { "" };
    let number = match (digits.abs().to_string(), powers) {
        (zero, _) if digits == 0 => zero,
        (digits, true) => power(&digits, exponent),
        (digits, false) => plain(&digits, exponent),
    };
    format!("{sign}{number}")
}

/// Writes digits × 10ⁿ as a decimal number.
fn plain(digits: &str, exponent: i32) -> String {
    match usize::try_from(-exponent) {
        Ok(decimals) if decimals > 0 => {
            let padded = format!("{digits:0>width$}", width = decimals + 1);
            let (whole, fraction) = padded.split_at(padded.len() - decimals);
            format!("{whole}.{fraction}")
        }
        _ => format!("{digits}{}", "0".repeat(usize::try_from(exponent).unwrap_or(0))),
    }
}

/// Writes digits × 10ⁿ as a mantissa and a power of ten.
fn power(digits: &str, exponent: i32) -> String {
    let exponent = exponent + i32::try_from(digits.len()).expect("a label is short") - 1;
    let (lead, rest) = digits.split_at(1);
    let rest = rest.trim_end_matches('0');
    let point = if rest.is_empty() { "" } else { "." };
    format!("{lead}{point}{rest}×10{}", raised(exponent))
}

/// Writes an exponent.
pub(super) fn raised(exponent: i32) -> String {
    exponent.to_string().chars().map(superscript).collect()
}

/// Raises a digit or a minus sign.
fn superscript(character: char) -> char {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    character.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(range: (f64, f64), most: u32) -> Vec<String> {
        choose(range, most, |_| true).into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn reference_steps_are_one_two_or_five() {
        assert_eq!(labels((0.0, 10.0), 10).len(), 11);
        assert_eq!(labels((0.0, 10.0), 7), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(labels((-8.0, 8.0), 5), ["\u{2212}5", "0", "5"]);
        assert_eq!(labels((0.0, 0.3), 6), ["0", "0.05", "0.10", "0.15", "0.20", "0.25", "0.30"]);
        assert_eq!(labels((-0.021, 0.02), 5), ["\u{2212}0.02", "\u{2212}0.01", "0", "0.01", "0.02"]);
        assert_eq!(labels((0.0, 2000.0), 5), ["0", "500", "1000", "1500", "2000"]);
    }

    #[test]
    fn reference_long_numbers_become_powers_of_ten() {
        assert_eq!(labels((0.0, 5e6), 5), ["0", "1×10⁶", "2×10⁶", "3×10⁶", "4×10⁶", "5×10⁶"]);
        assert_eq!(labels((0.0, 2e-8), 5), ["0", "5×10⁻⁹", "1×10⁻⁸", "1.5×10⁻⁸", "2×10⁻⁸"]);
    }

    #[test]
    fn limit_fewer_ticks_where_they_do_not_fit() {
        let ticks = choose((0.0, 10.0), 10, |ticks| ticks.len() <= 4);
        assert_eq!(ticks.iter().map(|tick| tick.value).collect::<Vec<_>>(), [0.0, 5.0, 10.0]);
        assert!(choose((0.0, 10.0), 10, |_| false).len() >= 2, "an axis keeps two numbers");
    }

    #[test]
    fn extreme_magnitudes_give_finite_ticks() {
        for range in [(1e299, 9e299), (-1e-290, 3e-290), (1e6, 1e6 + 1e-3)] {
            let ticks = choose(range, 6, |_| true);
            assert!(
                ticks.len() >= 2 && ticks.iter().all(|tick| tick.value.is_finite()),
                "{range:?}: {ticks:?}"
            );
        }
    }
}
