//! The spacing of the values of a file, and the resampling of pairs with uneven times.

use crate::refusals;
use pounding_text::{Knob, plain, short};

use super::{Stated, reading};
use crate::record::MAX_SAMPLES;
use crate::{Declared, FilePlace, Reading, Refused};

/// Time steps that a file may give without a declaration that repeats them \[s\]. Outside this range the header is damaged, or lacks the
/// step.
pub(super) const POSSIBLE: std::ops::RangeInclusive<f64> = 1e-6..=10.0;

/// Largest number of samples per pair after resampling.
const MOST_PER_PAIR: usize = 8;

/// The spacing of the values of a file.
#[derive(Clone, Debug)]
pub(crate) enum Spacing {
    /// At equal distances.
    Even(Stated<f64>),
    /// At equal distances, by times without a known unit.
    Unlabelled(Stated<f64>),
    /// At separate times.
    Uneven(Uneven),
    /// The file gives several different steps.
    Several(Vec<Stated<f64>>),
}

/// Largest relative difference of steps that are equal up to their printed digits.
const ALIKE: f64 = 0.01;

/// Smallest step between times in an unnamed unit that may mean milliseconds \[s\].
const LARGE: f64 = 1.0;

impl Spacing {
    /// The step in an unknown unit.
    pub(super) fn unlabelled(self) -> Self {
        match self {
            Self::Even(step) => Self::Unlabelled(step),
            Self::Unlabelled(_) | Self::Uneven(_) | Self::Several(_) => self,
        }
    }

    /// The spacing from the times of a column, or else from comments. If both exist, or comments state several steps, they must agree.
    pub(super) fn of(column: Option<Self>, mut said: Vec<Stated<f64>>) -> Option<Self> {
        let differ = |one: &Stated<f64>, other: &Stated<f64>| (one.value - other.value).abs() > ALIKE * one.value;
        match column {
            Some(Self::Even(step)) => {
                said.retain(|one| differ(&step, one));
                if said.is_empty() {
                    return Some(Self::Even(step));
                }
                said.insert(0, step);
            }
            // A stated step also gives the unit.
            Some(Self::Unlabelled(step)) => {
                return match said.first() {
                    None => Some(Self::Unlabelled(step)),
                    Some(first) if differ(&step, first) && !differ(&milliseconds(&step), first) => {
                        Self::of(Some(Self::Even(milliseconds(&step))), said)
                    }
                    Some(_) => Self::of(Some(Self::Even(step)), said),
                };
            }
            Some(other) => return Some(other),
            None => {
                let first = said.first()?.clone();
                if !said.iter().any(|one| differ(&first, one)) {
                    return Some(Self::Even(first));
                }
            }
        }
        Some(Self::Several(said))
    }
}

/// The step in milliseconds.
fn milliseconds(step: &Stated<f64>) -> Stated<f64> {
    Stated {
        value: step.value / 1000.0,
        ..step.clone()
    }
}

/// Times that rise in uneven steps.
#[derive(Clone, Debug)]
pub(crate) struct Uneven {
    /// Times \[s\], one per value, none before the previous one.
    pub(crate) times: Vec<f64>,
    /// Place of the first time.
    pub(crate) place: FilePlace,
    /// The refusal that describes the unevenness.
    pub(crate) refusal: Refused,
}

impl From<Stated<f64>> for Spacing {
    fn from(step: Stated<f64>) -> Self {
        Self::Even(step)
    }
}

/// A final time step.
pub(super) struct Settled {
    /// \[s\]
    pub(super) time_step: f64,
    pub(super) readings: Vec<Reading>,
    /// Part of the peak lost by resampling \[–\].
    pub(super) lost: f64,
}

impl Settled {
    fn new(time_step: f64, reading: Reading) -> Self {
        Self {
            time_step,
            readings: vec![reading],
            lost: 0.0,
        }
    }
}

/// The time step of some values; values with uneven times are resampled.
pub(super) fn settled(spacing: Option<&Spacing>, declared: &Declared, values: &mut Vec<f64>) -> Result<Settled, Refused> {
    if let Some(found) = declared.time_step
        && !(found.is_finite() && found > 0.0)
    {
        return Err(Refused::that("the declared ")
            .and(Knob::TimeStep)
            .and(format!(" is {} s", plain(found)))
            .but(", and must be ", "finite and above 0 s"));
    }
    match (spacing, declared.time_step) {
        (Some(Spacing::Even(stated)), declared) => even(stated, declared),
        (Some(Spacing::Unlabelled(stated)), declared) => {
            let in_milliseconds = milliseconds(stated);
            match declared {
                Some(step) if is_repeated(step, in_milliseconds.value) => even(&in_milliseconds, declared),
                None if stated.value >= LARGE => Err(Refused::at(stated.place)
                    .is(format!("the times rise by {}, and nothing states their unit", stated.value))
                    .help("name the column `time_s` or `time_ms`, or declare ")
                    .and(Knob::TimeStep)
                    .and(format!(" as {} or {} s", stated.value, in_milliseconds.value))),
                _ => even(stated, declared),
            }
        }
        (Some(Spacing::Several(several)), declared) => {
            let meant = declared.and_then(|step| several.iter().find(|one| is_repeated(step, one.value)));
            meant.map_or_else(
                || {
                    let said = several.iter().map(|one| (one.place, format!("{} s", one.value)));
                    Err(refusals::several("time step", Knob::TimeStep, said))
                },
                |one| even(one, declared),
            )
        }
        (Some(Spacing::Uneven(uneven)), Some(step)) => uneven.settled(values, step),
        (Some(Spacing::Uneven(uneven)), None) => Err(uneven.refusal.clone()),
        (None, Some(declared)) => {
            let found = format!("{declared} s (declared)");
            Ok(Settled::new(declared, reading("time step", None, &found)))
        }
        (None, None) => Err(Refused::that("the file does not say how far apart its values are")
            .help("declare it as ")
            .and(Knob::TimeStep)
            .and(" in seconds")
            .wants(Knob::TimeStep)),
    }
}

fn even(stated: &Stated<f64>, declared: Option<f64>) -> Result<Settled, Refused> {
    let (place, found) = (stated.place, stated.value);
    if !(found.is_finite() && found > 0.0) {
        return Err(refusals::time_step(place, found));
    }
    match declared {
        None if !POSSIBLE.contains(&found) => {
            return Err(Refused::at(place)
                .goes_on(format!("gives a time step of {found:?} s"))
                .allowed_are("1e-6 to 10 s")
                .so(": ", "the header lacks it, or is damaged; if it is right, declare the same as ")
                .and(Knob::TimeStep));
        }
        Some(declared) if !is_repeated(declared, found) => {
            return Err(Refused::at(place)
                .goes_on(format!("gives a time step of {} s", plain(found)))
                .but(", but ", format!("{} s is declared as ", plain(declared)))
                .and(Knob::TimeStep)
                .help("leave the declaration away"));
        }
        _ => {}
    }
    let text = format!("{found} s");
    Ok(Settled::new(found, reading("time step", Some(place), &text)))
}

/// Whether a declared step equals that of the file, possibly with fewer digits.
fn is_repeated(declared: f64, found: f64) -> bool {
    (found - declared).abs() <= 1e-6 * found
}

impl Uneven {
    /// Resamples the values and determines the loss of their peak.
    fn settled(&self, values: &mut Vec<f64>, step: f64) -> Result<Settled, Refused> {
        let before = peak(values);
        *values = self.resampled(values, step)?;
        let after = peak(values);
        let (from, to) = (self.times.len(), values.len());
        let found = format!("{step} s (declared; {from} uneven pairs resampled to {to}, linear between)");
        let mut settled = Settled::new(step, reading("time step", Some(self.place), &found));
        settled.lost = if before > 0.0 { 1.0 - after / before } else { 0.0 };
        if settled.lost > 1e-6 {
            let percent = 100.0 * settled.lost;
            let [before, after] = [before, after].map(short);
            let found = format!("{percent:.2} % lower than before, {before} became {after}");
            settled.readings.push(reading("resampled peak", None, &found));
        }
        Ok(settled)
    }

    /// The values at t₀, t₀ + Δt, … up to the last pair, linear between pairs.
    fn resampled(&self, values: &[f64], step: f64) -> Result<Vec<f64>, Refused> {
        let (first, last) = (self.times[0], self.times[self.times.len() - 1]);
        let most = (MOST_PER_PAIR * self.times.len()).min(MAX_SAMPLES);
        // Rounding errors of a step are ignored.
        let wanted = ((last - first) / step + 1e-9).floor() + 1.0;
        if wanted > most as f64 {
            // Two digits, rounded up.
            let allowed = format!("{:.1e}", 1.06 * (last - first) / (most - 1) as f64);
            let allowed: f64 = allowed.parse().expect("a number that was printed");
            let said = format!(" of {step} s resamples the uneven times of the file to more than {MOST_PER_PAIR} values for each there is");
            let said = Refused::that("the declared ").and(Knob::TimeStep).and(said);
            return Err(said.but("; allowed is ", format!("{allowed} s and more")));
        }
        let mut samples = Vec::new();
        let mut left = 0;
        while (samples.len() as f64) < wanted {
            let time = (first + samples.len() as f64 * step).min(last);
            while left + 2 < self.times.len() && self.times[left + 1] <= time {
                left += 1;
            }
            let (from, to) = (self.times[left], self.times[left + 1]);
            // If two pairs have one printed time, the later one counts.
            let share = if to > from { (time - from) / (to - from) } else { 1.0 };
            samples.push(values[left] * (1.0 - share) + values[left + 1] * share);
        }
        Ok(samples)
    }
}

/// The largest magnitude.
pub(super) fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |peak: f64, value| peak.max(value.abs()))
}

#[cfg(test)]
mod tests {
    use super::Uneven;
    use crate::FilePlace;
    use crate::refusals;

    fn uneven(times: &[f64]) -> Uneven {
        Uneven {
            times: times.to_vec(),
            place: FilePlace::Line(1),
            refusal: refusals::empty(),
        }
    }

    #[test]
    fn reference_linear_between_pairs() {
        let pairs = uneven(&[0.0, 1.0, 3.0, 4.0]);
        let values = [0.0, 2.0, -2.0, 6.0];
        let found = pairs.resampled(&values, 0.5).expect("samples");
        assert_eq!(found, [0.0, 1.0, 2.0, 1.0, 0.0, -1.0, -2.0, 2.0, 6.0]);
        // The rest after the last whole step is dropped.
        assert_eq!(pairs.resampled(&values, 1.5).expect("samples"), [0.0, 1.0, -2.0]);
    }

    #[test]
    fn extreme_steps() {
        let pairs = uneven(&[0.0, 1e9, 3e9]);
        assert_eq!(pairs.resampled(&[1.0, 2.0, 3.0], 1e10).expect("one"), [1.0]);
        let refused = pairs.resampled(&[1.0, 2.0, 3.0], 1e-9);
        // The step that is named is allowed.
        let allowed = refused.expect_err("too fine").parts().allowed.expect("a step");
        let allowed = allowed.strip_suffix(" s and more").expect("its unit").parse();
        assert!(pairs.resampled(&[1.0, 2.0, 3.0], allowed.expect("a number")).is_ok());
    }
}
