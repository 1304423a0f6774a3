//! Arrival times of the samples of a ground motion.

use crate::sum::{Sum, split};

/// The least unit \[s\]: every run has few enough units to count.
const LEAST: f64 = 1.0 / 1_048_576.0;

/// The time between two samples, for clocks that show 0 at whole multiples of a unit.
///
/// As a time since t = 0, the arrival of a sample has an error of up to 1e-15 s after 10 s. Floors that rest against each other, on grounds
/// that move at different times, press by differences of ground accelerations. The error is 1e-12 of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sampling {
    /// Time between two samples \[s\].
    pub(crate) step: f64,
    /// The time between two samples as the sum of two numbers of few digits: whole multiples of the first have no rounding.
    coarse: f64,
    fine: f64,
    /// Unit: a power of two \[s\], at most the time between two samples except for the shortest ones.
    unit: f64,
}

impl Sampling {
    /// Sampling with this time between samples \[s\].
    pub(crate) fn new(step: f64) -> Self {
        let [coarse, fine] = split(step);
        // Its power of two: the number without its fraction.
        let unit = f64::from_bits(step.to_bits() & f64::INFINITY.to_bits());
        Self {
            step,
            coarse,
            fine,
            unit: unit.max(LEAST),
        }
    }

    /// Arrival of a sample, for a motion that arrives at time `arrival`, on a clock that shows 0 at `zero`, a whole number of units \[s\].
    ///
    /// Within four units the result does not depend on `zero`: it is a whole multiple of a part of the unit that the clock resolves.
    pub(crate) fn on_clock(&self, zero: f64, index: usize, arrival: f64) -> f64 {
        let [whole, rest] = self.terms(zero, index, arrival);
        whole + rest
    }

    /// The arrival of a sample as a sum of two numbers \[s\].
    fn terms(&self, zero: f64, index: usize, arrival: f64) -> [f64; 2] {
        let index = index as f64;
        // This is the only rounded term. It is rounded to a part of the unit that does not depend on the clock.
        let grid = 3.0 * self.unit;
        let rest = ((arrival + index * self.fine) + grid) - grid;
        [index * self.coarse - zero, rest]
    }

    /// Time from the arrival of a sample to a time on this clock, of any length \[s\].
    pub(crate) fn since(&self, [zero, time]: [f64; 2], index: usize, arrival: f64) -> Sum {
        let [whole, rest] = self.terms(zero, index, arrival);
        Sum::of(time).plus(-rest).plus(-whole)
    }

    /// The arrival of a sample since t = 0, rounded once \[s\].
    pub(crate) fn instant(&self, index: usize, arrival: f64) -> f64 {
        let [zero, _] = self.split(index as f64 * self.step + arrival);
        zero + self.on_clock(zero, index, arrival)
    }

    /// An instant as a whole number of units and a rest \[s\]: the zero of a clock, and its reading.
    pub(crate) fn split(&self, instant: f64) -> [f64; 2] {
        let zero = whole(instant / self.unit) * self.unit;
        [zero, instant - zero]
    }

    /// The last sample up to number `most` that has arrived at a time; `None` before the first sample.
    pub(crate) fn last(&self, time: f64, most: usize, arrives: impl Fn(usize) -> f64) -> Option<usize> {
        if time < arrives(0) {
            return None;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "time >= the first arrival; beyond the last sample nothing follows"
        )]
        // Limited to the last sample: a larger index might exceed every number of samples and could not be incremented.
        let index = (((time - arrives(0)) / self.step) as usize).min(most);
        let is_it = arrives(index) <= time && (index == most || arrives(index + 1) > time);
        Some(if is_it { index } else { beside(index, time, most, arrives) })
    }
}

/// The last sample that has arrived, from one beside it. Rounding alone leads here: as a part of [`Sampling::last`] its loops would be
/// made fast for many samples, and slow for none.
#[cold]
#[inline(never)]
fn beside(mut index: usize, time: f64, most: usize, arrives: impl Fn(usize) -> f64) -> usize {
    while index < most && arrives(index + 1) <= time {
        index += 1;
    }
    while index > 0 && arrives(index) > time {
        index -= 1;
    }
    index
}

/// The whole part of a number, which is no call for one of 0 or more.
fn whole(number: f64) -> f64 {
    /// Above it every number is whole.
    const WHOLE: f64 = 9e15;
    if (0.0..WHOLE).contains(&number) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "0 or more, and far below the largest u64"
        )]
        let whole = number as u64;
        whole as f64
    } else {
        number.floor()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_an_instant_is_the_same_on_every_clock() {
        for step in [0.005, 0.01, 0.02, 1.0 / 3.0, 1e-7] {
            let sampling = Sampling::new(step);
            for index in (0..40_000).step_by(7) {
                let arrival = 0.013_435;
                let instant = sampling.instant(index, arrival);
                let exact = index as f64 * step + arrival;
                assert!((instant - exact).abs() <= f64::EPSILON * (exact + sampling.unit), "{index}");
                let [first, _] = sampling.split(instant);
                for back in [0.0, 1.0, 2.0] {
                    let zero = (first - back * sampling.unit).max(0.0);
                    let shown = sampling.on_clock(zero, index, arrival);
                    let further = first - zero;
                    let again = sampling.on_clock(first, index, arrival) + further;
                    assert_eq!(shown.to_bits(), again.to_bits(), "{step} {index} {back}");
                    assert_eq!((zero + shown).to_bits(), instant.to_bits(), "{step} {index}");
                }
            }
        }
    }
}
