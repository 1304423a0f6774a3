//! How far apart the values of a file are, and the resampling of pairs whose times are uneven.

use super::{Stated, reading};
use crate::{Declared, Place, ReadError, Reading};

/// Time steps that a file may give without a declaration that repeats them \[s\]: beyond them a header is damaged or lacks
/// them.
const POSSIBLE: std::ops::RangeInclusive<f64> = 1e-6..=10.0;

/// Most samples that resampling makes of one pair.
const MOST_PER_PAIR: usize = 8;

/// How far apart the values of a file are.
#[derive(Clone, Debug)]
pub(crate) enum Spacing {
    /// As far as each other.
    Even(Stated<f64>),
    /// Each at a time of its own.
    Uneven(Uneven),
}

/// Times that rise in uneven steps.
#[derive(Clone, Debug)]
pub(crate) struct Uneven {
    /// Times \[s\], each above the one before; one to each value.
    pub(crate) times: Vec<f64>,
    /// Where the first stands.
    pub(crate) place: Place,
    /// How uneven they are.
    pub(crate) refusal: ReadError,
}

impl From<Stated<f64>> for Spacing {
    fn from(step: Stated<f64>) -> Self {
        Self::Even(step)
    }
}

/// The time step \[s\] of some values, which are resampled where their times are uneven.
pub(super) fn settled(
    spacing: Option<&Spacing>,
    declared: &Declared,
    values: &mut Vec<f64>,
) -> Result<(f64, Reading), ReadError> {
    if let Some(found) = declared.time_step
        && !(found.is_finite() && found > 0.0)
    {
        return Err(ReadError::DeclaredTimeStep { found });
    }
    match (spacing, declared.time_step) {
        (Some(Spacing::Even(stated)), declared) => even(stated, declared),
        (Some(Spacing::Uneven(uneven)), Some(step)) => {
            *values = uneven.resampled(values, step)?;
            let (from, to) = (uneven.times.len(), values.len());
            let found = format!(
                "{step} s (declared; {from} uneven pairs resampled to {to}, linear between)"
            );
            Ok((step, reading("time step", Some(uneven.place), &found)))
        }
        (Some(Spacing::Uneven(uneven)), None) => Err(uneven.refusal.clone()),
        (None, Some(declared)) => {
            let found = format!("{declared} s (declared)");
            Ok((declared, reading("time step", None, &found)))
        }
        (None, None) => Err(ReadError::TimeStepNotStated),
    }
}

fn even(stated: &Stated<f64>, declared: Option<f64>) -> Result<(f64, Reading), ReadError> {
    let (place, found) = (stated.place, stated.value);
    if !(found.is_finite() && found > 0.0) {
        return Err(ReadError::TimeStep { place, found });
    }
    match declared {
        None if !POSSIBLE.contains(&found) => {
            return Err(ReadError::ImpossibleStep { place, found });
        }
        // A declared step may repeat what the file gives with fewer digits.
        Some(declared) if (found - declared).abs() > 1e-6 * found => {
            return Err(ReadError::TimeStepContradiction {
                place,
                found,
                declared,
            });
        }
        _ => {}
    }
    let text = format!("{found} s");
    Ok((found, reading("time step", Some(place), &text)))
}

impl Uneven {
    /// The values at t₀, t₀ + Δt, … up to the last pair, linear between pairs.
    fn resampled(&self, values: &[f64], step: f64) -> Result<Vec<f64>, ReadError> {
        let (first, last) = (self.times[0], self.times[self.times.len() - 1]);
        let most = MOST_PER_PAIR * self.times.len();
        // What rounding leaves of a step does not count.
        let wanted = ((last - first) / step + 1e-9).floor() + 1.0;
        if wanted > most as f64 {
            // In two digits, rounded up.
            let allowed = format!("{:.1e}", 1.06 * (last - first) / (most - 1) as f64);
            return Err(ReadError::FineResampling {
                declared: step,
                allowed: allowed.parse().expect("a number that was printed"),
            });
        }
        let mut samples = Vec::new();
        let mut left = 0;
        while (samples.len() as f64) < wanted {
            let time = (first + samples.len() as f64 * step).min(last);
            while left + 2 < self.times.len() && self.times[left + 1] <= time {
                left += 1;
            }
            let share = (time - self.times[left]) / (self.times[left + 1] - self.times[left]);
            samples.push(values[left] * (1.0 - share) + values[left + 1] * share);
        }
        Ok(samples)
    }
}

#[cfg(test)]
mod tests {
    use super::Uneven;
    use crate::{Place, ReadError};

    fn uneven(times: &[f64]) -> Uneven {
        Uneven {
            times: times.to_vec(),
            place: Place::Line(1),
            refusal: ReadError::Empty,
        }
    }

    #[test]
    fn reference_linear_between_pairs() {
        let pairs = uneven(&[0.0, 1.0, 3.0, 4.0]);
        let values = [0.0, 2.0, -2.0, 6.0];
        let found = pairs.resampled(&values, 0.5).expect("samples");
        assert_eq!(found, [0.0, 1.0, 2.0, 1.0, 0.0, -1.0, -2.0, 2.0, 6.0]);
        // What remains behind the last whole step is dropped.
        assert_eq!(
            pairs.resampled(&values, 1.5).expect("samples"),
            [0.0, 1.0, -2.0]
        );
    }

    #[test]
    fn extreme_steps() {
        let pairs = uneven(&[0.0, 1e9, 3e9]);
        assert_eq!(pairs.resampled(&[1.0, 2.0, 3.0], 1e10).expect("one"), [1.0]);
        let refused = pairs.resampled(&[1.0, 2.0, 3.0], 1e-9);
        assert!(matches!(refused, Err(ReadError::FineResampling { .. })));
        // The step that is named is allowed.
        let Err(ReadError::FineResampling { allowed, .. }) = refused else {
            unreachable!("as above");
        };
        assert!(pairs.resampled(&[1.0, 2.0, 3.0], allowed).is_ok());
    }
}
