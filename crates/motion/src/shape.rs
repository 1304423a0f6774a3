//! Signs in the shape of values: whether they change their sign, and whether header numbers are among them.

use crate::Unusual;

/// Fewest values that have a shape.
const FEWEST: usize = 10;

/// Ratio of a first value to the second largest magnitude above which it looks like a header number.
const SEVERAL: f64 = 3.0;

/// A warning about values that never change their sign, or only rise: a spectrum, a time, counts with an offset.
pub(crate) fn one_signed(values: &[f64]) -> Option<Unusual> {
    let found = values.len();
    let below = values.iter().any(|value| *value < 0.0);
    let above = values.iter().any(|value| *value > 0.0);
    let rises = values.is_sorted();
    let is_shaking = (below && above && !rises) || !(below || above);
    (found >= FEWEST && !is_shaking).then_some(Unusual::OneSigned { found, rises })
}

/// Other warnings about the shape of values in the unit of their file; `of_list` is the step \[s\] of a bare list.
pub(crate) fn unusual(values: &[f64], of_list: Option<f64>) -> impl Iterator<Item = Unusual> {
    let told = if values.len() < FEWEST { &[] } else { values };
    let is_zero = !told.is_empty() && told.iter().all(|value| value.abs() <= 0.0);
    let zero = is_zero.then_some(Unusual::Zero { found: told.len() });
    zero.into_iter().chain(first(told)).chain(step(told, of_list))
}

/// A warning about a first value that is the peak, several times the second largest magnitude.
fn first(values: &[f64]) -> Option<Unusual> {
    let (found, others) = values.split_first()?;
    let second = others.iter().fold(0.0, |peak: f64, value| peak.max(value.abs()));
    (second > 0.0 && found.abs() > SEVERAL * second).then_some(Unusual::FirstSample { found: *found, second })
}

/// A warning about one of the first two values that equals the time step.
fn step(values: &[f64], time_step: Option<f64>) -> Option<Unusual> {
    let step = time_step?;
    let is_step = |value: &f64| (value - step).abs() <= 1e-9 * step;
    let index = values.iter().take(2).position(is_step)?;
    Some(Unusual::StepAsSample {
        sample: index + 1,
        found: values[index],
    })
}

#[cfg(test)]
mod tests {
    use super::{one_signed, unusual};
    use crate::Unusual;

    fn found(values: &[f64]) -> Vec<Unusual> {
        unusual(values, Some(0.01)).collect()
    }

    #[test]
    fn issue_numbers_of_a_header_among_values() {
        let mut values = vec![1.0, 0.01];
        values.extend([0.1, -0.2, 0.25, -0.1].repeat(5));
        let (first, second) = (1.0, 0.25);
        let expected = [
            Unusual::FirstSample { found: first, second },
            Unusual::StepAsSample { sample: 2, found: 0.01 },
        ];
        assert_eq!(found(&values), expected);
        assert_eq!(found(&values[2..]), []);
        assert_eq!(found(&[0.0; 12]), [Unusual::Zero { found: 12 }]);
    }

    #[test]
    fn limit_shapes_of_one_sign() {
        let of_twelve = |rises| Some(Unusual::OneSigned { found: 12, rises });
        assert_eq!(one_signed(&[0.1, 0.3, 0.2].repeat(4)), of_twelve(false));
        assert_eq!(one_signed(&[-0.1, 0.0, -0.2].repeat(4)), of_twelve(false));
        let rising: Vec<f64> = (-4..8).map(f64::from).collect();
        assert_eq!(one_signed(&rising), of_twelve(true));
        assert_eq!(one_signed(&[0.0; 12]), None);
        assert_eq!(one_signed(&[0.1, -0.3, 0.2].repeat(4)), None);
        // Too few values have no shape.
        assert_eq!(one_signed(&[0.1; 9]), None);
    }
}
