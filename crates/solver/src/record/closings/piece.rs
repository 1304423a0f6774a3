//! A piece of the motion of a structure: a cubic, and the series that it stands for until somebody needs to look closer.

use super::cubic::{Cubic, Node};
use crate::Motion;
use crate::span::{Power, Series, value};

/// Most coefficients of a series that is kept.
const MOST: usize = 40;
/// What rounding adds to what a cubic leaves out, as a part of the terms of the series; the cubics between looks leave out no more.
const ROUNDING: f64 = 1e-12;
/// What the cubics between looks leave out themselves, as a part of what one cubic does: at most 2⁻⁴.
const BETWEEN_LOOKS: f64 = 1.1;

/// A piece of the motion of a structure.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    /// The motion, or what is left of it.
    pub(super) cubic: Cubic,
    /// What the cubic stands for; nothing where it is the motion itself.
    coarse: Option<Box<Coarse>>,
}

/// A series, looked at so many times.
#[derive(Debug, Clone, PartialEq)]
struct Coarse {
    /// From its start to its end.
    whole: Cubic,
    /// How far the series is from that cubic at most \[m\].
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
    /// A series between two nodes; `None` where it is no short series in time.
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

    /// How far the motion is from the cubic at most \[m\].
    pub(super) fn leaves_out(&self) -> f64 {
        self.coarse.as_ref().map_or(0.0, |coarse| coarse.leaves_out)
    }

    /// The part from an instant before its end on.
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
        // As the state of a span: the rise on top of the start.
        let rise = x * value(&self.displacement[1..self.len.max(1)], x);
        let motion = Motion {
            displacement: self.displacement[0] + rise,
            velocity: at(&self.velocity),
        };
        Node::new(time, motion)
    }
}

/// Into how many cubics a series in time is cut, so that they leave out no more than rounding adds.
pub(super) fn looks(displacement: &[f64], duration: f64) -> u32 {
    Bounds::of(displacement, duration).looks()
}

/// Bounds of a displacement over a time, by the terms of its series \[m\].
struct Bounds {
    /// How far it is from the cubic through its ends: h⁴/384 times the largest fourth derivative.
    from_cubic: f64,
    /// Of itself.
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

    /// How far the series is from the cubic through its ends at most \[m\].
    fn leaves_out(&self) -> f64 {
        BETWEEN_LOOKS * self.from_cubic + ROUNDING * self.all
    }

    /// Into how many cubics it is cut, so that they leave out no more than rounding adds: the distance falls with the fourth power of
    /// their number.
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
