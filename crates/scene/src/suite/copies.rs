//! Records that lie in a folder twice: copies are left out, and a motion that is another one times a factor is told.

use std::collections::BTreeMap;

use crate::STANDARD_GRAVITY;

use super::{Motion, Read, ReasonKind};

/// Least correlation of two motions that are one \[–\].
const ONE: f64 = 0.99;

/// The same of motions with few swings: pulses whose periods are 4 to 9 % apart correlate by more than 0.99, records with many swings do
/// not where their periods are 1 % apart.
const ONE_PULSE: f64 = 0.9999;

/// Least number of swings of a motion that is no pulse.
const SWINGS: usize = 10;

/// Largest difference between the peaks of two copies, as a part of the larger.
const SAME_PEAK: f64 = 0.01;

/// Lags around that of the peaks at which motions are compared, in steps.
const LAGS: isize = 3;

/// Which motions are copies of others, by their indices.
pub(super) struct Copies {
    /// Of which motion each is a copy, if of any; that one is none.
    pub(super) of: Vec<Option<usize>>,
    /// Two motions that are alike but for a factor, and the factor.
    pub(super) alike: Vec<(usize, usize, f64)>,
}

impl Copies {
    /// Compares motions: of copies the one with the shortest name stays.
    ///
    /// What has the bytes of a motion that shakes nothing shakes nothing either: only the name tells that the other is vertical.
    pub(super) fn among(all: &mut [Read]) -> Self {
        let shapes: Vec<Shape<'_>> = all.iter().map(|one| Shape::of(&one.motion)).collect();
        let mut first_of: BTreeMap<(&str, &Option<String>), usize> = BTreeMap::new();
        let mut of: Vec<Option<usize>> = vec![None; all.len()];
        let mut alike = Vec::new();
        let mut order: Vec<usize> = (0..all.len()).collect();
        order.sort_by_key(|index| {
            let one = &all[*index];
            (one.reason.is_none(), one.motion.path.as_os_str().len())
        });
        for (rank, &index) in order.iter().enumerate() {
            let Read { motion, reason } = &all[index];
            let bytes = (motion.origin.sha256.as_str(), &motion.taken.component);
            let first = *first_of.entry(bytes).or_insert(index);
            if reason.is_some() {
                continue;
            }
            if first != index {
                of[index] = of[first].or(Some(first));
                continue;
            }
            let before = order[..rank].iter().copied();
            let mut others = before.filter(|other| {
                of[*other].is_none()
                    && all[*other].reason.is_none()
                    && all[*other].motion.path != motion.path
                    && shapes[*other].is_like(&shapes[index])
            });
            let Some(other) = others.next() else {
                continue;
            };
            let [one, another] = [other, index].map(|at| shapes[at].peak);
            if (one - another).abs() <= SAME_PEAK * one.max(another) {
                of[index] = Some(other);
            } else {
                alike.push((other, index, another / one));
            }
        }
        let mut copies = Self { of, alike };
        copies.leave_out_where(all, |first| first.reason.is_some());
        copies
    }

    /// Leaves out the copies. What tells the direction of a copy tells that of the motion that stays.
    pub(super) fn leave_out(mut self, all: &mut [Read]) {
        self.leave_out_where(all, |_| true);
    }

    fn leave_out_where(&mut self, all: &mut [Read], holds: impl Fn(&Read) -> bool) {
        for (index, of) in self.of.iter_mut().enumerate() {
            let Some(first) = of.filter(|first| holds(&all[*first])) else {
                continue;
            };
            *of = None;
            let direction = all[index].motion.direction;
            let stays = &mut all[first].motion;
            stays.direction = stays.direction.or(direction);
            let reason = ReasonKind::Copy.saying(format!("of {}", stays.name));
            all[index].reason = Some(reason);
        }
    }
}

/// A motion as it is compared with others.
struct Shape<'m> {
    values: &'m [f64],
    time_step: f64,
    /// Index of the value that is largest without its sign.
    at: usize,
    /// Its magnitude \[m/s²\].
    peak: f64,
    /// Sum of the squares over that of the peak \[–\].
    fullness: f64,
    /// How often values above a tenth of the peak change their sign.
    swings: usize,
}

impl<'m> Shape<'m> {
    fn of(motion: &'m Motion) -> Self {
        let file = &motion.origin.file;
        let values = file.values();
        let (mut at, mut largest) = (0, 0.0);
        for (index, value) in values.iter().enumerate() {
            if value.abs() > largest {
                (at, largest) = (index, value.abs());
            }
        }
        let strong = values.iter().filter(|value| value.abs() > 0.1 * largest);
        let mut signs: Vec<bool> = strong.map(|value| *value > 0.0).collect();
        signs.dedup();
        let squares: f64 = values.iter().map(|value| value * value).sum();
        Self {
            values,
            time_step: file.time_step(),
            at,
            peak: file.unit().to_si(largest, STANDARD_GRAVITY),
            fullness: squares / (largest * largest),
            swings: signs.len(),
        }
    }

    /// Whether they are one motion but for a factor.
    fn is_like(&self, other: &Self) -> bool {
        let least = if self.swings.min(other.swings) < SWINGS { ONE_PULSE } else { ONE };
        self.may_be(other) && self.correlation(other) > least
    }

    /// Whether it is worth while to compare them: the time steps are equal, and what a correlation above [`ONE`] implies holds roughly.
    fn may_be(&self, other: &Self) -> bool {
        let [least, most] = [self.fullness.min(other.fullness), self.fullness.max(other.fullness)];
        let same_step = (self.time_step - other.time_step).abs() <= 1e-6 * self.time_step;
        let near = |shape: &Self, lag: isize| {
            let index = shape.at.checked_add_signed(lag);
            let value = index.and_then(|index| shape.values.get(index));
            value.map_or(0.0, |value| value / shape.values[shape.at])
        };
        let looks_alike = || (-5..=5).all(|lag| (near(self, lag) - near(other, lag)).abs() < 0.3);
        same_step && most <= 1.2 * least && looks_alike()
    }

    /// The largest correlation over lags near that of the peaks, without its sign \[–\].
    fn correlation(&self, other: &Self) -> f64 {
        let energy = |shape: &Self| shape.values.iter().map(|value| value * value).sum::<f64>();
        let scale = (energy(self) * energy(other)).sqrt();
        let peaks = other.at.cast_signed() - self.at.cast_signed();
        let at = |lag: isize| {
            let [skip, behind] = [lag.min(0).unsigned_abs(), lag.max(0).unsigned_abs()];
            let own = self.values.iter().skip(skip);
            let pairs = own.zip(other.values.iter().skip(behind));
            pairs.map(|(one, other)| one * other).sum::<f64>().abs() / scale
        };
        (peaks - LAGS..=peaks + LAGS).map(at).fold(0.0, f64::max)
    }
}
