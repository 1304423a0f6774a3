use crate::model::sampling::Sampling;
use crate::{Clock, ModelError};

/// Ground acceleration at equally spaced instants, linear between them and zero outside; the first sample is at t = 0.
///
/// Stepping methods sample it once per run. Closed forms use its linear segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Excitation<'a> {
    time_step: f64,
    samples: &'a [f64],
}

/// A linear piece of the ground acceleration, from a given time.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Segment {
    /// Ground acceleration at that time \[m/s²\].
    pub(crate) value: f64,
    /// Its slope \[m/s³\].
    pub(crate) slope: f64,
    /// End of the piece \[s\].
    pub(crate) end: f64,
}

impl Segment {
    /// Coefficient `n` of the acceleration as a series in x, with t = now + x^p.
    #[inline]
    pub(crate) fn coefficient(&self, n: usize, p: usize) -> f64 {
        if n == 0 {
            self.value
        } else if n == p {
            self.slope
        } else {
            0.0
        }
    }
}

/// Instants closer to a sample than this fraction of a segment take the sample itself.
const SNAP: f64 = 1e-9;

impl<'a> Excitation<'a> {
    /// Borrows ground accelerations \[m/s²\], `time_step` \[s\] apart.
    ///
    /// # Errors
    /// [`ModelError`] if there is no sample, a sample is not finite, or `time_step` is not a finite number > 0.
    pub fn new(time_step: f64, samples: &'a [f64]) -> Result<Self, ModelError> {
        if samples.is_empty() {
            return Err(ModelError::NoSamples);
        }
        if !(time_step.is_finite() && time_step > 0.0) {
            return Err(ModelError::OutOfRange {
                place: "excitation.time_step".into(),
                found: time_step,
                allowed: "a finite number > 0",
            });
        }
        if let Some(index) = samples.iter().position(|sample| !sample.is_finite()) {
            return Err(ModelError::OutOfRange {
                place: format!("excitation.samples[{index}]"),
                found: samples[index],
                allowed: "a finite number",
            });
        }
        Ok(Self { time_step, samples })
    }

    /// Time between two samples \[s\], > 0.
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// Ground accelerations at t = 0, Δt, 2Δt, … \[m/s²\].
    pub fn samples(&self) -> &'a [f64] {
        self.samples
    }

    /// Arrival times of the samples.
    pub(crate) fn sampling(&self) -> Sampling {
        Sampling::new(self.time_step)
    }

    /// The linear piece that begins at or before a time ≥ 0 \[s\] and continues after it, for a motion that arrives at time `arrival` ≥ 0
    /// \[s\]. The ground rests before.
    pub(crate) fn segment(&self, time: f64, arrival: f64) -> Segment {
        let sampling = self.sampling();
        let start = |index| sampling.instant(index, arrival);
        self.segment_of(sampling, time, start)
    }

    /// The linear piece at a time on a clock that shows 0 at `zero` \[s\], a whole number of units of the sampling.
    pub(crate) fn segment_on_clock(&self, zero: f64, time: f64, arrival: f64) -> Segment {
        let sampling = self.sampling();
        let start = |index| sampling.on_clock(zero, index, arrival);
        self.segment_of(sampling, time, start)
    }

    fn segment_of(&self, sampling: Sampling, time: f64, start: impl Fn(usize) -> f64) -> Segment {
        let resting = |end: f64| Segment {
            value: 0.0,
            slope: 0.0,
            end,
        };
        let Some(index) = sampling.last(time, self.samples.len(), &start) else {
            return resting(start(0));
        };
        let (Some(left), Some(right)) = (self.samples.get(index), self.samples.get(index + 1)) else {
            return resting(f64::INFINITY);
        };
        let slope = (right - left) / self.time_step;
        Segment {
            value: left + slope * (time - start(index)),
            slope,
            end: start(index + 1),
        }
    }

    /// Ground acceleration at every node of a clock, 0..=n \[m/s²\].
    pub fn sampled(&self, clock: Clock) -> impl Iterator<Item = f64> + use<'a> {
        (0..=clock.n_steps).map(self.at_steps(clock.time_step))
    }

    /// Ground acceleration at a node \[m/s²\], by the number of steps of this length \[s\] before it.
    #[inline]
    pub fn at_steps(&self, time_step: f64) -> impl Fn(usize) -> f64 + use<'a> {
        let (excitation, ratio) = (*self, time_step / self.time_step);
        move |step| excitation.at_position(step as f64 * ratio)
    }

    /// Ground acceleration at a time ≥ 0 \[s\], as stepping methods sample it \[m/s²\], for a motion that arrives at time `arrival` \[s\].
    pub(crate) fn at(&self, time: f64, arrival: f64) -> f64 {
        self.at_position(time / self.time_step - arrival / self.time_step)
    }

    /// Ground acceleration at a `position` counted in samples; 0 before the first sample.
    #[inline]
    pub(crate) fn at_position(&self, position: f64) -> f64 {
        if position <= -SNAP {
            return 0.0;
        }
        // Rounds towards zero, without a call; `get` detects the end of the samples.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a position >= 0, or one that is nearly 0"
        )]
        let below = position as usize;
        let sample = |index: usize| self.samples.get(index).copied().unwrap_or(0.0);
        let fraction = position - below as f64;
        if fraction < SNAP {
            return sample(below);
        }
        if below as f64 + 1.0 - position < SNAP {
            return sample(below.saturating_add(1));
        }
        match (self.samples.get(below), self.samples.get(below.saturating_add(1))) {
            (Some(left), Some(right)) => left + fraction * (right - left),
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_sampled_linearly_and_zero_outside() {
        let ground = [1.0, 3.0, -1.0];
        let excitation = Excitation::new(0.01, &ground).unwrap();
        let clock = Clock {
            time_step: 0.005,
            n_steps: 6,
        };
        let expected = [1.0, 2.0, 3.0, 1.0, -1.0, 0.0, 0.0];
        assert!(excitation.sampled(clock).eq(expected));
    }

    #[test]
    fn limit_own_grid_takes_the_samples() {
        let ground: Vec<f64> = (0..1000).map(|i| f64::from(i).sqrt()).collect();
        let excitation = Excitation::new(0.01, &ground).unwrap();
        let own = Clock {
            time_step: 0.01,
            n_steps: 999,
        };
        assert!(excitation.sampled(own).eq(ground.iter().copied()));
        let fine = excitation.sampled(Clock {
            time_step: 0.01 / 3.0,
            n_steps: 2997,
        });
        assert!(fine.step_by(3).eq(ground.iter().copied()), "every third node is a sample");
    }

    #[test]
    fn extreme_bad_excitations_are_refused() {
        assert_eq!(Excitation::new(0.01, &[]), Err(ModelError::NoSamples));
        for time_step in [0.0, -0.01, f64::NAN, f64::INFINITY] {
            assert!(Excitation::new(time_step, &[1.0]).is_err(), "{time_step}");
        }
        assert!(Excitation::new(0.01, &[0.0, f64::NAN]).is_err(), "NaN");
    }
}
