//! The segments of a run, each between two arrivals of samples at any structure.

use pounding_solver::Excitation;

use super::equations::Segment;
use super::model::{displacement, velocity};
use super::state::{State, Sum};

/// Instants closer than this part of the interval between samples are equal: quotients of decimal numbers miss a whole number by a
/// rounding, which must not make a segment.
const SAME: f64 = 1e-9;

/// Arrival of a sample \[s\], unrounded. Ground accelerations are integrated twice to the relative motion of grounds: a sample that is
/// 1e-15 s late would give a relative error of 1e-12.
fn instant(sample: f64, interval: f64, arrival: f64) -> Sum {
    Sum::default().plus_product(Sum::of(sample), Sum::of(interval)).plus(arrival)
}

/// The ground at a sample of the record that has arrived, and at an instant after it.
#[derive(Debug, Clone, Copy, Default)]
struct Ground {
    /// Acceleration \[m/s²\], and its rate until the next sample \[m/s³\].
    acceleration: f64,
    rate: f64,
    /// Velocity \[m/s\] and displacement \[m\].
    velocity: Sum,
    displacement: Sum,
}

impl Ground {
    /// The ground `since` seconds later, before the next sample. A ground moves by metres, while two grounds move far less relative to each
    /// other.
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
    /// Instants at which a sample arrives at any structure, and the end of the run.
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
            reason = "a whole number >= 0; beyond the last sample nothing follows"
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
        // The ground keeps the velocity of the last sample.
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
        // As many unknowns as precede the displacement of one more structure.
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

    /// Deviation of the distance of the grounds of two structures, after the record, from velocity times difference of arrivals \[m\].
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
