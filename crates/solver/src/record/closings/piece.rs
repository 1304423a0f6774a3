//! A piece of the motion of a structure: a cubic, and the series behind it until a closer look is needed.

use super::cubic::{Cubic, Node};
use crate::Motion;
use crate::span::{Power, Series, value};

/// Most coefficients of a series that is kept.
const MOST: usize = 40;
/// Rounding added to the error of a cubic, as a part of the terms of the series. The cubics between looks have at most this error.
const ROUNDING: f64 = 1e-12;
/// Error of the cubics between looks plus that of the single cubic, relative to the latter: two or more cubics leave at most 2⁻⁴ of it.
const BETWEEN_LOOKS: f64 = 1.1;

/// A piece of the motion of a structure.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    /// The motion, or the rest of it.
    pub(super) cubic: Cubic,
    /// The series behind the cubic; `None` if the cubic is the motion itself.
    coarse: Option<Box<Coarse>>,
}

/// A series with its number of looks.
#[derive(Debug, Clone, PartialEq)]
struct Coarse {
    /// The cubic from its start to its end.
    whole: Cubic,
    /// Largest distance of the series from this cubic \[m\].
    leaves_out: f64,
    looks: u32,
    origin: f64,
    end: f64,
    len: usize,
    displacement: [f64; MOST],
    velocity: [f64; MOST],
}

impl From<Cubic> for Piece {
    fn from(cubic: Cubic) -> Self {
        Self { cubic, coarse: None }
    }
}

impl Piece {
    /// A series between two nodes; `None` if it is not a short series in time.
    pub(super) fn of_series(whole: Cubic, series: &Series<'_>) -> Option<Self> {
        let len = series.displacement.len();
        if len > MOST || series.velocity.len() != len || series.power != Power::One {
            return None;
        }
        let [mut displacement, mut velocity] = [[0.0; MOST]; 2];
        displacement[..len].copy_from_slice(series.displacement);
        velocity[..len].copy_from_slice(series.velocity);
        let bounds = Bounds::of(series.displacement, whole.duration());
        let coarse = Coarse {
            whole,
            leaves_out: bounds.leaves_out(),
            looks: bounds.looks(),
            origin: series.origin,
            end: series.end,
            len,
            displacement,
            velocity,
        };
        Some(Self {
            cubic: whole,
            coarse: Some(Box::new(coarse)),
        })
    }

    /// Largest distance of the motion from the cubic \[m\].
    pub(super) fn leaves_out(&self) -> f64 {
        self.coarse.as_ref().map_or(0.0, |coarse| coarse.leaves_out)
    }

    /// The part from an instant before its end.
    pub(super) fn from(self, time: f64) -> Self {
        Self {
            cubic: self.cubic.from(time),
            ..self
        }
    }

    /// The cubics between its looks.
    pub(super) fn fine(&self) -> impl DoubleEndedIterator<Item = Cubic> + '_ {
        let itself = self.coarse.is_none().then_some(self.cubic);
        let coarse = self.coarse.iter();
        let from = self.cubic.start.time;
        let rest = move |cubic: Cubic| {
            let cut = cubic.start.time < from;
            (cubic.end.time > from).then(|| if cut { cubic.from(from) } else { cubic })
        };
        let fine = coarse.flat_map(move |one| {
            let cubics = (0..one.looks).map(|look| one.between(look));
            cubics.filter_map(rest)
        });
        itself.into_iter().chain(fine)
    }
}

impl Coarse {
    /// The cubic from one look to the next.
    fn between(&self, look: u32) -> Cubic {
        Cubic {
            start: self.node(look),
            end: self.node(look + 1),
        }
    }

    fn node(&self, look: u32) -> Node {
        if look == 0 {
            return self.whole.start;
        }
        if look == self.looks {
            return self.whole.end;
        }
        let share = f64::from(look) / f64::from(self.looks);
        let time = self.whole.start.time + share * self.whole.duration();
        let x = (time - self.origin).max(0.0).min(self.end);
        let at = |series: &[f64; MOST]| value(&series[..self.len], x);
        // As in the state of a span: the rise is added to the start.
        let rise = x * value(&self.displacement[1..self.len.max(1)], x);
        let motion = Motion {
            displacement: self.displacement[0] + rise,
            velocity: at(&self.velocity),
        };
        Node::new(time, motion)
    }
}

/// Number of cubics for a series in time, such that they leave out at most the rounding.
pub(super) fn looks(displacement: &[f64], duration: f64) -> u32 {
    Bounds::of(displacement, duration).looks()
}

/// Bounds of a displacement over a duration, from the terms of its series \[m\].
struct Bounds {
    /// Bound of the distance from the cubic through its ends: h⁴/384 times the largest fourth derivative.
    from_cubic: f64,
    /// Bound of the displacement.
    all: f64,
}

impl Bounds {
    fn of(displacement: &[f64], duration: f64) -> Self {
        let (mut power, mut fourth, mut all) = (1.0, 0.0, 0.0);
        for (n, coefficient) in displacement.iter().enumerate() {
            let term = coefficient.abs() * power;
            let n = n as f64;
            fourth += n * (n - 1.0) * (n - 2.0) * (n - 3.0) * term;
            all += term;
            power *= duration;
        }
        Self {
            from_cubic: fourth / 384.0,
            all,
        }
    }

    /// Largest distance of the series from the cubic through its ends \[m\].
    fn leaves_out(&self) -> f64 {
        BETWEEN_LOOKS * self.from_cubic + ROUNDING * self.all
    }

    /// Number of cubics such that they leave out at most the rounding; the distance falls with the fourth power of their number.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "at least one, and some thousand at most for a short series"
    )]
    fn looks(&self) -> u32 {
        let times = self.from_cubic / (ROUNDING * self.all);
        times.sqrt().sqrt().ceil().max(1.0) as u32
    }
}
