//! Divides a run into segments. A segment ends when the next sample of the ground motion reaches any structure.

use pounding_solver::Excitation;

use super::equations::Segment;
use super::model::{displacement, velocity};
use super::state::{State, Sum};

/// Two instants count as equal if they differ by less than this part of the sampling interval. Otherwise a rounding error would create an
/// extra, very short segment.
const SAME: f64 = 1e-9;

/// Returns the time at which a sample arrives \[s\], together with its rounding error. The relative motion of two grounds is the double
/// integral of their accelerations. A time error of 1e-15 s would cause a relative error of 1e-12 in it.
fn instant(sample: f64, interval: f64, arrival: f64) -> Sum {
    Sum::default().plus_product(Sum::of(sample), Sum::of(interval)).plus(arrival)
}

/// Motion of the ground at one instant: at a sample, or after it.
#[derive(Debug, Clone, Copy, Default)]
struct Ground {
    /// Acceleration \[m/s²\].
    acceleration: f64,
    /// Rate of the acceleration until the next sample \[m/s³\].
    rate: f64,
    /// Velocity \[m/s\].
    velocity: Sum,
    /// Displacement \[m\].
    displacement: Sum,
}

impl Ground {
    /// Returns the motion of the ground `since` seconds later. This instant must not lie beyond the next sample, if there is one.
    ///
    /// Displacements and velocities keep their rounding errors, because the difference between two grounds is far smaller than either
    /// displacement.
    fn after(&self, since: Sum) -> Self {
        let Self {
            acceleration,
            rate,
            velocity,
            displacement,
        } = *self;
        let s = since.rounded();
        let bent = s * s * (0.5 * acceleration + s * (rate / 6.0));
        Self {
            acceleration: acceleration + rate * s,
            rate,
            velocity: velocity.plus(s * (acceleration + s * (0.5 * rate))),
            displacement: displacement.plus_product(velocity, since).plus(bent),
        }
    }
}

/// The segments of a run, in order of time.
pub(super) struct Segments {
    interval: f64,
    /// The ground at every sample; there is no acceleration after the last sample.
    samples: Vec<Ground>,
    /// Arrival at every structure \[s\].
    arrivals: Vec<f64>,
    /// Boundaries of the segments: the sampling grid of every arrival time and of t = 0, also after the last sample, and the end of the
    /// run.
    instants: Vec<Sum>,
    next: usize,
}

impl Segments {
    pub(super) fn new(excitation: Excitation<'_>, arrivals: Vec<f64>, duration: f64) -> Self {
        let interval = excitation.time_step();
        let mut different = arrivals.clone();
        different.push(0.0);
        different.sort_by(f64::total_cmp);
        different.dedup();
        let mut instants = Vec::new();
        for arrival in different {
            let samples = (0..).map(|sample: u32| instant(f64::from(sample), interval, arrival));
            instants.extend(samples.take_while(|one| duration - one.high > SAME * interval));
        }
        instants.sort_by(|one, other| one.less(*other).rounded().total_cmp(&0.0));
        instants.dedup_by(|later, earlier| later.less(*earlier).rounded() <= SAME * interval);
        instants.push(Sum::of(duration));
        Self {
            interval,
            samples: integrated(excitation.samples(), interval),
            arrivals,
            instants,
            next: 0,
        }
    }

    /// The ground at an instant, for a motion that arrives at time `arrival`.
    fn ground(&self, now: Sum, arrival: f64) -> Ground {
        let position = (now.high - arrival) / self.interval;
        let nearest = position.round();
        let whole = if (position - nearest).abs() <= SAME {
            nearest
        } else {
            position.floor()
        };
        if whole < 0.0 {
            return Ground::default();
        }
        let last = self.samples.len() - 1;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the number is whole and not negative; after the record the last sample is used"
        )]
        let index = (whole as usize).min(last);
        let arrives = instant(index as f64, self.interval, arrival);
        self.samples[index].after(now.less(arrives))
    }
}

/// The ground at every sample of a record.
fn integrated(samples: &[f64], interval: f64) -> Vec<Ground> {
    let mut all: Vec<Ground> = Vec::with_capacity(samples.len());
    for (index, &acceleration) in samples.iter().enumerate() {
        let before = all.last().map(|before| before.after(Sum::of(interval)));
        let before = before.unwrap_or_default();
        // After the last sample the acceleration is 0, so the ground keeps its velocity.
        let next = samples.get(index + 1);
        all.push(Ground {
            acceleration: next.map_or(0.0, |_| acceleration),
            rate: next.map_or(0.0, |next| (next - acceleration) / interval),
            ..before
        });
    }
    all
}

impl Iterator for Segments {
    type Item = Segment;

    fn next(&mut self) -> Option<Segment> {
        let &[start, end] = self.instants.get(self.next..self.next + 2)? else {
            return None;
        };
        self.next += 1;
        // The vector has room for the time and for the displacement and velocity of every structure.
        let mut moved = State::zero(displacement(self.arrivals.len()));
        let mut grounds = Vec::with_capacity(self.arrivals.len());
        for (index, arrival) in self.arrivals.iter().enumerate() {
            let ground = self.ground(start, *arrival);
            grounds.push((ground.acceleration, ground.rate));
            moved.put_sum(displacement(index), ground.displacement);
            moved.put_sum(velocity(index), ground.velocity);
        }
        Some(Segment {
            start: start.high,
            length: end.less(start).rounded(),
            grounds,
            moved,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the largest error \[m\] of the distance between two grounds after the record. The exact distance is the final velocity times
    /// the difference of the two arrival times.
    fn off(samples: &[f64], arrivals: [f64; 2]) -> f64 {
        let excitation = Excitation::new(0.1, samples).expect("finite samples");
        let n = samples.len() as f64;
        let velocity: f64 = 0.1 * samples.windows(2).map(|ends| 0.5 * (ends[0] + ends[1])).sum::<f64>();
        let wanted = velocity * (arrivals[1] - arrivals[0]);
        let segments = Segments::new(excitation, arrivals.to_vec(), 30.0);
        let last = segments.filter(|segment| segment.start > 0.1 * n + arrivals[1]);
        let apart = last.map(|segment| {
            let [first, second] = [0, 1].map(displacement);
            (segment.moved.difference(first, second) - wanted).abs()
        });
        apart.fold(0.0, f64::max)
    }

    #[test]
    fn extreme_grounds_stay_as_far_apart_as_they_are_behind_the_record() {
        for arrivals in [[0.0, 0.125], [0.0, 0.0137], [0.3, 0.8]] {
            assert!(off(&[1.0; 9], arrivals) < 1e-16, "{arrivals:?}");
            // A record of one sample shakes nothing.
            assert!(off(&[1.0], arrivals) == 0.0, "{arrivals:?}");
        }
    }
}
