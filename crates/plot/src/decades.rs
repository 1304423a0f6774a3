//! Round numbers on a logarithmic axis.

use super::ticks::{self, Tick};

/// Distances of the written decades.
const STEPS: [i32; 10] = [1, 2, 3, 4, 5, 10, 20, 30, 50, 100];

/// Fewer decades than this are written with numbers between them.
const FEW: usize = 3;

/// Least length of a decade that is divided \[mm\].
const DIVIDED: f64 = 8.0;

/// Chooses the ticks of a range of positive numbers, and the places of short ticks between them.
///
/// Decades get labels, as many as `fit`. A range with fewer than three decades has labels at 1, 2 and 5 of each, and a range with hardly a
/// decade has those of a linear axis. Between decades, 2 to 9 get short ticks if a decade is long enough \[mm\]. If only every second or
/// third decade has a label, the others get short ticks.
pub(super) fn choose(range: (f64, f64), decade: f64, fit: impl Fn(&[Tick]) -> bool) -> (Vec<Tick>, Vec<f64>) {
    let (first, last) = (exponent(range.0, f64::ceil), exponent(range.1, f64::floor));
    let decades: Vec<i32> = (first..=last).collect();
    if decades.len() < FEW {
        let (round, between) = digits(range);
        if round.len() >= FEW && fit(&round) {
            return (round, between);
        }
        if decades.len() < 2 {
            return (ticks::choose(range, 6, fit), Vec::new());
        }
    }
    let mut chosen = Vec::new();
    for step in STEPS {
        let ticks: Vec<Tick> = decades.iter().filter(|&n| n % step == 0).map(|&n| power(n)).collect();
        if ticks.len() < 2 {
            break;
        }
        let done = fit(&ticks);
        chosen = ticks;
        if done {
            let short = match step {
                1 if decade < DIVIDED => Vec::new(),
                1 => digits(range).1,
                _ => decades.iter().filter(|&n| n % step != 0).map(|&n| ticks::decimal(1, n)).collect(),
            };
            return (chosen, short);
        }
    }
    (chosen, Vec::new())
}

/// Returns the decade next to a number. A number within rounding of a decade counts as this decade.
#[expect(clippy::cast_possible_truncation, reason = "finite numbers have small exponents")]
fn exponent(value: f64, round: fn(f64) -> f64) -> i32 {
    let exponent = libm::log10(value);
    let whole = exponent.round();
    if (exponent - whole).abs() < 1e-9 {
        whole as i32
    } else {
        round(exponent) as i32
    }
}

/// Returns the tick of a decade.
fn power(exponent: i32) -> Tick {
    Tick {
        value: ticks::decimal(1, exponent),
        label: format!("10{}", ticks::raised(exponent)),
    }
}

/// Returns 1, 2 and 5 × 10ⁿ in a range as ticks, and all of 2 to 9 × 10ⁿ as places.
fn digits((from, to): (f64, f64)) -> (Vec<Tick>, Vec<f64>) {
    let (first, last) = (exponent(from, f64::floor), exponent(to, f64::ceil));
    let powers = first < -5 || last > 6;
    let (mut round, mut between) = (Vec::new(), Vec::new());
    for n in first..=last {
        for digit in 1..=9 {
            let value = ticks::decimal(digit, n);
            // The ends of an axis may have rounding errors.
            if value < from * (1.0 - 1e-9) || to * (1.0 + 1e-9) < value {
                continue;
            }
            if matches!(digit, 1 | 2 | 5) {
                let label = ticks::label(digit, n, powers);
                round.push(Tick { value, label });
            }
            if digit > 1 {
                between.push(value);
            }
        }
    }
    (round, between)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(range: (f64, f64)) -> Vec<String> {
        let (ticks, _) = choose(range, 10.0, |_| true);
        ticks.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn reference_decades_are_powers_of_ten() {
        assert_eq!(labels((1e-2, 1e1)), ["10⁻²", "10⁻¹", "10⁰", "10¹"]);
        assert_eq!(labels((3e7, 2e10)), ["10⁸", "10⁹", "10¹⁰"]);
    }

    #[test]
    fn reference_few_decades_get_one_two_and_five() {
        assert_eq!(labels((3.0, 60.0)), ["5", "10", "20", "50"]);
        assert_eq!(labels((0.05, 0.2)), ["0.05", "0.1", "0.2"]);
        assert_eq!(labels((1e7, 5e7)), ["1×10⁷", "2×10⁷", "5×10⁷"]);
    }

    #[test]
    fn limit_less_than_a_decade_has_the_ticks_of_a_linear_axis() {
        let range = (0.9, 1.3);
        let (ticks, between) = choose(range, 10.0, |_| true);
        assert_eq!(ticks, ticks::choose(range, 6, |_| true));
        assert!(between.is_empty());
    }

    #[test]
    fn reference_short_ticks_stand_at_two_to_nine() {
        let (_, between) = choose((1.0, 1e3), DIVIDED, |_| true);
        let digits = (2..=9).map(f64::from);
        let expected: Vec<f64> = [1.0, 10.0, 100.0]
            .iter()
            .flat_map(|decade| digits.clone().map(move |digit| digit * decade))
            .collect();
        assert_eq!(between, expected);
        let (_, between) = choose((1.0, 1e3), 0.9 * DIVIDED, |_| true);
        assert!(between.is_empty(), "a short decade is not divided");
    }

    #[test]
    fn limit_decades_are_left_out_where_they_do_not_fit() {
        let (ticks, between) = choose((1e-14, 1.0), 10.0, |ticks| ticks.len() <= 4);
        let written: Vec<f64> = ticks.iter().map(|tick| tick.value).collect();
        assert_eq!(written, [1e-12, 1e-8, 1e-4, 1.0]);
        assert_eq!(written.len() + between.len(), 15, "the others get short ticks");
        let (crowded, _) = choose((1e-14, 1.0), 10.0, |_| false);
        assert!(crowded.len() >= 2, "an axis keeps two numbers");
    }

    #[test]
    fn extreme_magnitudes_give_finite_ticks() {
        for range in [(1e-299, 1e299), (1e299, 9e299), (2e-300, 3e-300), (1.0, 1.0 + 1e-6)] {
            let (ticks, _) = choose(range, 1.0, |_| true);
            assert!(
                ticks.len() >= 2 && ticks.iter().all(|tick| tick.value.is_finite()),
                "{range:?}: {ticks:?}"
            );
        }
    }
}
