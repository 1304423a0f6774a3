//! Ground motion that arrives at the buildings of a row at different times, and the relative motion of their grounds.

use crate::model::sampling::Sampling;
use crate::sum::Sum;
use crate::{Excitation, Motion};

/// The ground motion under every node of a row along which it travels.
///
/// The ground under node i rests until `arrival`ᵢ and then follows the record: `a_g`(t − τᵢ). Its velocity and displacement are the exact
/// integrals of the record, which is linear between samples: parabolas and cubics. After the record the ground keeps its last velocity. If
/// the record does not end at rest, two bases then stay apart by this velocity times the difference of their arrivals.
#[derive(Debug, Clone, PartialEq)]
pub struct Travel {
    sampling: Sampling,
    samples: Vec<Sample>,
    /// Arrival at every node \[s\].
    arrivals: Vec<f64>,
}

/// The ground at a sample of the record. A ground may move by metres, while two grounds move far less relative to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sample {
    acceleration: f64,
    velocity: Sum,
    displacement: Sum,
}

/// Displacement of a ground as a cubic in the time since an instant.
#[derive(Debug, Clone, Copy, Default)]
struct Cubic {
    displacement: Sum,
    velocity: Sum,
    /// Half of the acceleration.
    bend: f64,
    /// A sixth of the slope of the acceleration.
    sixth: f64,
}

impl Cubic {
    fn motion(self) -> Motion {
        Motion {
            displacement: self.displacement.rounded(),
            velocity: self.velocity.rounded(),
        }
    }
}

/// The largest relative displacement of two grounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opening {
    /// Displacement of the left ground minus that of the right ground \[m\]; positive if they came closer.
    pub distance: f64,
    /// First instant of the largest value \[s\].
    pub time: f64,
}

impl Travel {
    /// Travel of an excitation that arrives at the nodes after these times \[s\].
    pub(crate) fn new(excitation: Excitation<'_>, arrivals: Vec<f64>) -> Self {
        let h = excitation.time_step();
        let samples = excitation.samples();
        let (mut displacement, mut velocity) = (Sum::default(), Sum::default());
        let mut integrated = Vec::with_capacity(samples.len());
        for (index, &acceleration) in samples.iter().enumerate() {
            integrated.push(Sample {
                acceleration,
                velocity,
                displacement,
            });
            let next = samples.get(index + 1).copied().unwrap_or(0.0);
            let moved = h * (velocity.rounded() + h * (2.0 * acceleration + next) / 6.0);
            displacement = displacement.plus(moved);
            velocity = velocity.plus(0.5 * h * (acceleration + next));
        }
        Self {
            sampling: excitation.sampling(),
            samples: integrated,
            arrivals,
        }
    }

    /// Arrival at a node \[s\].
    pub fn arrival(&self, node: usize) -> f64 {
        self.arrivals[node]
    }

    /// The next arrival of a sample at a node after an instant \[s\]; infinite after the last sample.
    pub(crate) fn next_arrival(&self, node: usize, after: f64) -> f64 {
        let arrives = |index: usize| self.sampling.instant(index, self.arrivals[node]);
        let most = self.samples.len() - 1;
        let last = self.sampling.last(after, most, arrives);
        match last.map_or(0, |last| last + 1) {
            next if next > most => f64::INFINITY,
            next => arrives(next),
        }
    }

    /// Displacement and velocity of the ground under a node at an instant \[s\].
    pub fn ground(&self, node: usize, time: f64) -> Motion {
        self.under(node, self.sampling.split(time)).motion()
    }

    /// Opening: how far the ground of a left node has moved towards that of a right node, and at which rate, at an instant \[s\].
    pub fn opening(&self, nodes: [usize; 2], time: f64) -> Motion {
        self.opening_at(nodes, self.sampling.split(time))
    }

    /// The opening at an instant that is the unrounded sum of two numbers \[s\].
    pub(crate) fn opening_at(&self, nodes: [usize; 2], instant: [f64; 2]) -> Motion {
        let [left, right] = nodes.map(|node| self.under(node, instant));
        Motion {
            displacement: left.displacement.less(right.displacement),
            velocity: left.velocity.less(right.velocity),
        }
    }

    /// The largest relative displacement of the grounds of two nodes from t = 0 to an instant \[s\], in either direction.
    ///
    /// Exact: the opening is a cubic between the arrivals of samples. Its largest magnitude is at an arrival, or between two of them at a
    /// zero of its rate.
    pub fn largest_opening(&self, nodes: [usize; 2], until: f64) -> Opening {
        let mut largest = Opening { distance: 0.0, time: 0.0 };
        let mut take = |time: f64, distance: f64| {
            if distance.abs() > largest.distance.abs() {
                largest = Opening { distance, time };
            }
        };
        let arrive = |node: usize| {
            let arrival = self.arrivals[node];
            let of = move |index: usize| self.sampling.instant(index, arrival);
            (0..self.samples.len()).map(of)
        };
        let mut instants: Vec<f64> = arrive(nodes[0]).chain(arrive(nodes[1])).collect();
        instants.push(until);
        instants.retain(|time| *time <= until);
        instants.sort_by(f64::total_cmp);
        for ends in instants.windows(2) {
            // About the middle, where rounding cannot select another piece of the motion.
            let half = 0.5 * (ends[1] - ends[0]);
            let middle = ends[0] + half;
            let instant = self.sampling.split(middle);
            let [_, rate, half_bend, sixth] = self.cubic_opening(nodes, instant);
            // Zeros of rate + 2 b s + 3 c s².
            let (b, c) = (half_bend, 3.0 * sixth);
            let sum = -(b + (b * b - rate * c).sqrt().copysign(b));
            for s in [sum / c, rate / sum] {
                // NaN if there is no zero.
                if s.abs() < half {
                    take(middle + s, self.opening(nodes, middle + s).displacement);
                }
            }
            take(ends[1], self.opening(nodes, ends[1]).displacement);
        }
        largest
    }

    /// Displacement and velocity at a position in the record counted in samples; at rest before the first sample.
    pub(crate) fn at(&self, position: f64) -> Motion {
        let Some((index, part)) = self.place(position) else {
            return Motion::default();
        };
        let after = Sum::of(part * self.sampling.step);
        self.cubic(index, after).motion()
    }

    /// The last sample at or before a position, and the distance from it; `None` before the first sample.
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

    /// Displacement of the ground as a cubic about an instant \[s\] after a sample.
    fn cubic(&self, index: usize, after: Sum) -> Cubic {
        let sample = &self.samples[index];
        let Some(next) = self.samples.get(index + 1) else {
            // No further acceleration: the ground may go on for metres while the distance of two grounds stays the same.
            return Cubic {
                displacement: sample.displacement.plus_product(sample.velocity, after),
                velocity: sample.velocity,
                ..Cubic::default()
            };
        };
        let s = after.rounded();
        let acceleration = sample.acceleration;
        let slope = (next.acceleration - acceleration) / self.sampling.step;
        let moved = s * (sample.velocity.rounded() + s * (0.5 * acceleration + s * (slope / 6.0)));
        let faster = s * (acceleration + s * (0.5 * slope));
        Cubic {
            displacement: sample.displacement.plus(moved),
            velocity: sample.velocity.plus(faster),
            bend: 0.5 * (acceleration + s * slope),
            sixth: slope / 6.0,
        }
    }

    /// The ground under a node from an instant, the sum of two numbers \[s\], until the next sample arrives there.
    fn under(&self, node: usize, instant: [f64; 2]) -> Cubic {
        let arrival = self.arrivals[node];
        let [zero, time] = instant;
        let arrives = |index: usize| self.sampling.on_clock(zero, index, arrival);
        let last = self.sampling.last(time, self.samples.len() - 1, arrives);
        last.map_or_else(Cubic::default, |index| {
            self.cubic(index, self.sampling.since(instant, index, arrival))
        })
    }

    /// Coefficients of the ground's displacement under a node as a cubic in the time since an instant, the sum of two numbers \[s\],
    /// valid until the next sample arrives there.
    pub(crate) fn cubic_ground(&self, node: usize, instant: [f64; 2]) -> [f64; 4] {
        let ground = self.under(node, instant);
        let Motion { displacement, velocity } = ground.motion();
        [displacement, velocity, ground.bend, ground.sixth]
    }

    /// Coefficients of the difference of the ground displacements under a left and a right node, as a cubic in the time since an instant.
    pub(crate) fn cubic_opening(&self, nodes: [usize; 2], instant: [f64; 2]) -> [f64; 4] {
        let [left, right] = nodes.map(|node| self.under(node, instant));
        [
            left.displacement.less(right.displacement),
            left.velocity.less(right.velocity),
            left.bend - right.bend,
            left.sixth - right.sixth,
        ]
    }
}
