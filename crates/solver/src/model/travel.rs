//! A ground motion that arrives at the buildings of a row one after the other: how their grounds move apart.

use crate::model::excitation::last_sample;
use crate::{Excitation, Motion};

/// The ground motion under every node of a row to which it travels.
///
/// The ground under node i moves as the record says, `arrival`ᵢ later, and rests before: `a_g`(t − τᵢ). Its velocity and
/// displacement are the exact integrals of the record, which is linear between samples: parabolas and cubics. After the
/// record the ground keeps its last velocity, so that bases of a record which does not end at rest stay apart by that
/// velocity times the difference of their arrivals.
#[derive(Debug, Clone, PartialEq)]
pub struct Travel {
    /// Time between two samples \[s\].
    time_step: f64,
    samples: Vec<Sample>,
    /// Arrival at every node \[s\].
    arrivals: Vec<f64>,
}

/// The ground at a sample of the record.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sample {
    acceleration: f64,
    velocity: f64,
    displacement: f64,
}

/// Where two grounds were farthest from where they began to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opening {
    /// Displacement of the left ground less that of the right one \[m\]: positive where they came closer.
    pub distance: f64,
    /// Its first instant \[s\].
    pub time: f64,
}

impl Travel {
    /// Of an excitation that arrives at the nodes after these times \[s\].
    pub(crate) fn new(excitation: Excitation<'_>, arrivals: Vec<f64>) -> Self {
        let h = excitation.time_step();
        let samples = excitation.samples();
        let mut ground = Motion::default();
        let mut integrated = Vec::with_capacity(samples.len());
        for (index, &acceleration) in samples.iter().enumerate() {
            integrated.push(Sample {
                acceleration,
                velocity: ground.velocity,
                displacement: ground.displacement,
            });
            let next = samples.get(index + 1).copied().unwrap_or(0.0);
            ground.displacement += h * (ground.velocity + h * (2.0 * acceleration + next) / 6.0);
            ground.velocity += 0.5 * h * (acceleration + next);
        }
        Self {
            time_step: h,
            samples: integrated,
            arrivals,
        }
    }

    /// Arrival at a node \[s\].
    pub fn arrival(&self, node: usize) -> f64 {
        self.arrivals[node]
    }

    /// Displacement and velocity of the ground under a node at an instant \[s\].
    pub fn ground(&self, node: usize, time: f64) -> Motion {
        self.at((time - self.arrivals[node]) / self.time_step)
    }

    /// How far the ground of a left node has moved towards that of a right one, and at which rate, at an instant \[s\].
    pub fn opening(&self, [left, right]: [usize; 2], time: f64) -> Motion {
        self.ground(left, time).since(self.ground(right, time))
    }

    /// Where the ground of two nodes was farthest from where it began to each other, from t = 0 to an instant \[s\]; both
    /// ways count.
    ///
    /// Exact: the opening is a cubic between the instants at which samples arrive, and its largest magnitude lies at one of
    /// them or where its rate is zero in between.
    pub fn largest_opening(&self, nodes: [usize; 2], until: f64) -> Opening {
        let mut largest = Opening {
            distance: 0.0,
            time: 0.0,
        };
        let mut take = |time: f64, distance: f64| {
            if distance.abs() > largest.distance.abs() {
                largest = Opening { distance, time };
            }
        };
        let arrive = |node: usize| {
            let arrival = self.arrivals[node];
            let of = move |index: usize| index as f64 * self.time_step + arrival;
            (0..self.samples.len()).map(of)
        };
        let mut instants: Vec<f64> = arrive(nodes[0]).chain(arrive(nodes[1])).collect();
        instants.push(until);
        instants.retain(|time| *time <= until);
        instants.sort_by(f64::total_cmp);
        for ends in instants.windows(2) {
            let [_, rate, half_bend, sixth] = self.cubic_opening(nodes, ends[0]);
            // Zeros of rate + 2 b s + 3 c s².
            let (b, c) = (half_bend, 3.0 * sixth);
            let sum = -(b + (b * b - rate * c).sqrt().copysign(b));
            for s in [sum / c, rate / sum] {
                // Not a number where there is no zero.
                if s > 0.0 && s < ends[1] - ends[0] {
                    take(ends[0] + s, self.opening(nodes, ends[0] + s).displacement);
                }
            }
            take(ends[1], self.opening(nodes, ends[1]).displacement);
        }
        largest
    }

    /// Displacement and velocity at a position in the record counted in samples; at rest before the first one.
    pub(crate) fn at(&self, position: f64) -> Motion {
        let Some((index, part)) = self.place(position) else {
            return Motion::default();
        };
        let [displacement, velocity, ..] = self.cubic(index, part * self.time_step);
        Motion {
            displacement,
            velocity,
        }
    }

    /// The last sample at or before a position, and how far behind it that is; nothing before the first one.
    fn place(&self, position: f64) -> Option<(usize, f64)> {
        if position < 0.0 {
            return None;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number >= 0; beyond the last sample nothing follows"
        )]
        let index = (position as usize).min(self.samples.len() - 1);
        Some((index, position - index as f64))
    }

    /// Coefficients of the ground's displacement as a cubic about an instant s \[s\] after a sample.
    fn cubic(&self, index: usize, s: f64) -> [f64; 4] {
        let sample = &self.samples[index];
        // Behind the last sample the ground is not accelerated.
        let (acceleration, slope) = match self.samples.get(index + 1) {
            Some(next) => (
                sample.acceleration,
                (next.acceleration - sample.acceleration) / self.time_step,
            ),
            None => (0.0, 0.0),
        };
        [
            sample.displacement
                + s * (sample.velocity + s * (0.5 * acceleration + s * (slope / 6.0))),
            sample.velocity + s * (acceleration + s * (0.5 * slope)),
            0.5 * (acceleration + s * slope),
            slope / 6.0,
        ]
    }

    /// Coefficients of the ground's displacement under a node as a cubic in the time since an instant, valid until the
    /// next sample arrives there.
    pub(crate) fn cubic_ground(&self, node: usize, time: f64) -> [f64; 4] {
        let arrival = self.arrivals[node];
        let arrives = |index: usize| index as f64 * self.time_step + arrival;
        let last = last_sample(time, self.time_step, self.samples.len() - 1, arrives);
        last.map_or([0.0; 4], |index| {
            let start = index as f64 * self.time_step + arrival;
            self.cubic(index, time - start)
        })
    }

    /// The same of the ground of a left node less that of a right one.
    pub(crate) fn cubic_opening(&self, [left, right]: [usize; 2], time: f64) -> [f64; 4] {
        let (left, right) = (
            self.cubic_ground(left, time),
            self.cubic_ground(right, time),
        );
        [0, 1, 2, 3].map(|n| left[n] - right[n])
    }
}
