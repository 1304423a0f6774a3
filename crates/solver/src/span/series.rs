//! A motion that is known between the ends of its span: power series of the exact method.

use super::{Motion, State};

/// A motion as power series in x, with t = origin + x^power.
///
/// The power is one but just after the first touch of a compliant pair, where forces are series in the fourth root of
/// time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series<'a> {
    pub(crate) origin: f64,
    pub(crate) power: Power,
    /// x at the end of the span: instants tell a span that is shorter than they are fine by far too much, or by nothing. Infinite
    /// where they tell enough.
    pub(crate) end: f64,
    pub(crate) displacement: &'a [f64],
    pub(crate) velocity: &'a [f64],
    pub(crate) acceleration: &'a [f64],
    /// Displacement and velocity of the floor below; nothing for a floor that stands on the ground.
    pub(crate) below: Option<[&'a [f64]; 2]>,
    /// Restoring force where the displacement is the first coefficient \[N\], and its tangent \[N/m\].
    pub(crate) restoring_force: (f64, f64),
    /// Of columns that yield smoothly the part of the force that is no line over the drift, (1 − a) k z \[N\], whose start is
    /// in `restoring_force` too; empty for all others.
    pub(crate) bent: &'a [f64],
    /// Magnitude of the pounding force from either side \[N\].
    pub(crate) force_from_left: &'a [f64],
    pub(crate) force_from_right: &'a [f64],
}

/// The power p of t = origin + x^p.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Power {
    One,
    Four,
}

impl Power {
    /// x at a time after the origin \[s\], ≥ 0 for the power four.
    pub(crate) fn root(self, time: f64) -> f64 {
        match self {
            Self::One => time,
            Self::Four => time.sqrt().sqrt(),
        }
    }

    /// Time after the origin at x.
    pub(crate) fn time(self, x: f64) -> f64 {
        match self {
            Self::One => x,
            Self::Four => (x * x) * (x * x),
        }
    }

    /// dt/dx.
    pub(crate) fn rate(self, x: f64) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Four => 4.0 * (x * x) * x,
        }
    }

    /// The power as a number.
    pub(crate) fn order(self) -> usize {
        match self {
            Self::One => 1,
            Self::Four => 4,
        }
    }
}

/// Value of a polynomial with these coefficients, the lowest power first.
#[inline]
pub(crate) fn value(coefficients: &[f64], x: f64) -> f64 {
    let sum = |sum, coefficient: &f64| sum * x + coefficient;
    coefficients.iter().rev().fold(0.0, sum)
}

/// What a polynomial has risen since x = 0.
#[inline]
pub(crate) fn rise(coefficients: &[f64], x: f64) -> f64 {
    x * value(coefficients.get(1..).unwrap_or_default(), x)
}

impl Series<'_> {
    /// x at an instant \[s\].
    pub(crate) fn x(&self, time: f64) -> f64 {
        self.power.root((time - self.origin).max(0.0)).min(self.end)
    }

    /// Drift of the storey below the floor, whose own motion at x this is.
    #[inline]
    pub(super) fn drift(&self, floor: Motion, x: f64) -> Motion {
        match self.below {
            None => floor,
            Some([displacement, velocity]) => floor.since(Motion {
                displacement: value(displacement, x),
                velocity: value(velocity, x),
            }),
        }
    }

    /// State at x. Inlined, so that whoever integrates pays for what the integrand asks only.
    #[inline]
    pub(super) fn at(&self, x: f64) -> State {
        let rise = rise(self.displacement, x);
        let drift = match self.below {
            None => rise,
            Some([below, _]) => rise - self::rise(below, x),
        };
        let line = self.restoring_force.0 + self.restoring_force.1 * drift;
        State {
            displacement: self.displacement.first().unwrap_or(&0.0) + rise,
            velocity: value(self.velocity, x),
            acceleration: value(self.acceleration, x),
            restoring_force: if self.bent.is_empty() {
                line
            } else {
                line + self::rise(self.bent, x)
            },
            force_from_left: value(self.force_from_left, x),
            force_from_right: -value(self.force_from_right, x),
        }
    }
}
