//! Cubics through displacements and velocities at both ends.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

use super::Closing;
use crate::roots::first_root;
use crate::{Motion, Travel};

/// Instant \[s\], displacement \[m\] and velocity \[m/s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Time \[s\].
    pub time: f64,
    /// Displacement \[m\].
    pub displacement: f64,
    /// Velocity \[m/s\].
    pub velocity: f64,
}

/// The cubic through two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cubic {
    /// Start of the cubic.
    pub start: Node,
    /// End of the cubic.
    pub end: Node,
}

impl Node {
    pub(super) fn new(time: f64, motion: Motion) -> Self {
        Self {
            time,
            displacement: motion.displacement,
            velocity: motion.velocity,
        }
    }
}

impl Cubic {
    /// The motion of the ground under a node over this interval.
    pub(super) fn of_ground(self, node: usize, travel: Option<&Travel>) -> Self {
        let at = |time: f64| {
            let ground = travel.map_or_else(Motion::default, |travel| travel.ground(node, time));
            Node::new(time, ground)
        };
        Self {
            start: at(self.start.time),
            end: at(self.end.time),
        }
    }

    pub(super) fn duration(&self) -> f64 {
        self.end.time - self.start.time
    }

    /// Coefficients of 1, s, s² and s³ with s from 0 at the start to 1 at the end.
    fn coefficients(&self) -> [f64; 4] {
        let h = self.duration();
        let (first, last) = (self.start.velocity * h, self.end.velocity * h);
        let rise = self.end.displacement - self.start.displacement;
        [
            self.start.displacement,
            first,
            3.0 * rise - 2.0 * first - last,
            first + last - 2.0 * rise,
        ]
    }

    /// First instant above a value that the cubic exceeds \[s\].
    pub(super) fn first_above(&self, value: f64) -> f64 {
        let [u, a, b, c] = self.coefficients();
        let s = first_root(&[u - value, a, b, c], 1.0);
        self.start.time + s.unwrap_or(1.0) * self.duration()
    }

    fn at(&self, time: f64) -> Node {
        let h = self.duration();
        let s = (time - self.start.time) / h;
        let [u, a, b, c] = self.coefficients();
        Node {
            time,
            displacement: u + s * (a + s * (b + s * c)),
            velocity: (a + s * (2.0 * b + 3.0 * s * c)) / h,
        }
    }

    /// The part up to an instant, which is at least its start.
    pub(super) fn until(self, time: f64) -> Self {
        if time < self.end.time {
            Self {
                end: self.at(time),
                ..self
            }
        } else {
            self
        }
    }

    /// The part from an instant before its end.
    pub(super) fn from(self, time: f64) -> Self {
        Self {
            start: self.at(time),
            ..self
        }
    }

    pub(super) fn mirrored(self) -> Self {
        self.times(-1.0)
    }

    /// The cubic times a number.
    pub(super) fn times(self, factor: f64) -> Self {
        let times = |node: Node| Node {
            displacement: factor * node.displacement,
            velocity: factor * node.velocity,
            ..node
        };
        Self {
            start: times(self.start),
            end: times(self.end),
        }
    }

    /// The sum of two cubics over a common interval.
    pub(super) fn plus(self, other: Self) -> Self {
        let plus = |one: Node, other: Node| Node {
            time: one.time,
            displacement: one.displacement + other.displacement,
            velocity: one.velocity + other.velocity,
        };
        Self {
            start: plus(self.start, other.start),
            end: plus(self.end, other.end),
        }
    }

    /// The difference of two cubics over a common interval.
    pub(super) fn less(self, other: Self) -> Self {
        self.plus(other.mirrored())
    }

    /// Values of its Bézier points, whose range contains the cubic.
    pub(super) fn controls(&self) -> [f64; 4] {
        let [start, end] = [self.start, self.end].map(|node| [node.displacement, node.velocity]);
        controls(self.duration(), [start, end])
    }

    /// Its largest value, and the first position of this value.
    #[inline(always)] // Called instead, openings side by side take 1.12 times as long.
    pub fn highest(&self) -> Closing {
        let [u, a, b, c] = self.coefficients();
        // The slope is a + 2bs + 3cs², without a root if it does not change sign. A NaN root (b = 0 and c = 0 or a = 0) is not between 0
        // and 1.
        let root = (b * b - 3.0 * a * c).sqrt();
        let sum = -(b + root.copysign(b));
        let Node { time, displacement, .. } = self.start;
        let mut highest = Closing {
            distance: displacement,
            time,
        };
        let between = [sum / (3.0 * c), a / sum].into_iter();
        for s in between.filter(|s| *s > 0.0 && *s < 1.0) {
            let distance = u + s * (a + s * (b + s * c));
            if distance > highest.distance {
                highest = Closing {
                    distance,
                    time: self.start.time + s * self.duration(),
                };
            }
        }
        if self.end.displacement > highest.distance {
            highest = Closing {
                distance: self.end.displacement,
                time: self.end.time,
            };
        }
        highest
    }
}

/// Values whose range contains a cubic of this duration \[s\], from displacements and velocities at both ends, for a single scene or for
/// several scenes in lanes.
#[inline(always)]
pub fn controls<N: Number>(duration: N, [start, end]: [[N; 2]; 2]) -> [N; 4] {
    let third = duration / duration.like(3.0);
    [start[0], start[0] + third * start[1], end[0] - third * end[1], end[0]]
}
