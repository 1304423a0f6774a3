//! When the samples of a ground motion arrive.

use crate::sum::{Sum, split};

/// The least unit \[s\]: no run has too many of it to count.
const LEAST: f64 = 1.0 / 1_048_576.0;

/// The time between two samples, and instants told on clocks that show 0 at whole multiples of a unit.
///
/// Told since t = 0, a sample is late by up to 1e-15 s after 10 s. Floors that rest against each other under grounds that move at
/// different times press by differences of ground accelerations, of which that is 1e-12.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sampling {
    /// Time between two samples \[s\].
    pub(crate) step: f64,
    /// The same as two numbers of few digits: whole multiples of the first one have no rounding.
    coarse: f64,
    fine: f64,
    /// A power of two \[s\], at most the time between two samples but for the shortest of them.
    unit: f64,
}

impl Sampling {
    /// Of samples this far apart \[s\].
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

    /// When a sample arrives where the motion arrives at some time, on a clock that shows 0 at `zero`, a whole number of units \[s\].
    ///
    /// Within four units it is one number whatever `zero` is: a whole multiple of a part of the unit that such a clock can tell.
    pub(crate) fn on_clock(&self, zero: f64, index: usize, arrival: f64) -> f64 {
        let [whole, rest] = self.terms(zero, index, arrival);
        whole + rest
    }

    /// The same as a sum of two numbers \[s\].
    fn terms(&self, zero: f64, index: usize, arrival: f64) -> [f64; 2] {
        let index = index as f64;
        // Of the terms only this one is rounded: to a part of the unit, whatever the clock shows.
        let grid = 3.0 * self.unit;
        let rest = ((arrival + index * self.fine) + grid) - grid;
        [index * self.coarse - zero, rest]
    }

    /// Time from that instant to a time of that clock, however long \[s\].
    pub(crate) fn since(&self, [zero, time]: [f64; 2], index: usize, arrival: f64) -> Sum {
        let [whole, rest] = self.terms(zero, index, arrival);
        Sum::of(time).plus(-rest).plus(-whole)
    }

    /// The same instant since t = 0, rounded once \[s\].
    pub(crate) fn instant(&self, index: usize, arrival: f64) -> f64 {
        let [zero, _] = self.split(index as f64 * self.step + arrival);
        zero + self.on_clock(zero, index, arrival)
    }

    /// An instant as a whole number of units and a rest \[s\]: a clock, and what it shows.
    pub(crate) fn split(&self, instant: f64) -> [f64; 2] {
        let zero = (instant / self.unit).floor() * self.unit;
        [zero, instant - zero]
    }

    /// The last sample that has arrived at a time, of which none comes after the one numbered `most`; nothing before the first.
    pub(crate) fn last(&self, time: f64, most: usize, arrives: impl Fn(usize) -> f64) -> Option<usize> {
        if time < arrives(0) {
            return None;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "time >= the first arrival; beyond the last sample nothing follows"
        )]
        // Not beyond the last sample: a count that no number of samples reaches could not be raised.
        let mut index = (((time - arrives(0)) / self.step) as usize).min(most);
        while index < most && arrives(index + 1) <= time {
            index += 1;
        }
        while index > 0 && arrives(index) > time {
            index -= 1;
        }
        Some(index)
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
