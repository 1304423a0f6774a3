//! Records that a folder holds twice: copies are left out, and motions that differ by a factor are reported.

use std::collections::BTreeMap;

use pounding_scene::STANDARD_GRAVITY;

use super::{LeftOutKind, ReadMotion, SuiteMotion};

/// Least correlation of two copies of a motion \[–\].
const ONE: f64 = 0.99;

/// Least correlation of two copies of a motion with few swings \[–\]. Pulses whose periods differ by 4 to 9 % correlate by more than 0.99;
/// records with many swings do not, even if their periods differ by 1 %.
const ONE_PULSE: f64 = 0.9999;

/// Least number of swings of a motion that is not a pulse.
const SWINGS: usize = 10;

/// Largest difference between the peaks of two copies, as a part of the larger peak \[–\].
const SAME_PEAK: f64 = 0.01;

/// Motions are compared at lags up to this many steps from the lag of their peaks.
const LAGS: isize = 3;

/// Copies among motions, by their indices.
pub(super) struct Copies {
    /// For each motion the one that it copies, which is itself no copy; `None` if it is no copy.
    pub(super) of: Vec<Option<usize>>,
    /// Pairs of motions that differ only by a factor, and the factor.
    pub(super) alike: Vec<(usize, usize, f64)>,
}

impl Copies {
    /// Compares motions. Among copies, the motion with the shortest name stays.
    ///
    /// A motion with the bytes of a motion that shakes nothing shakes nothing either: only the name of the other one shows that it is
    /// vertical.
    pub(super) fn among(all: &mut [ReadMotion]) -> Self {
        let shapes: Vec<MotionShape<'_>> = all.iter().map(|one| MotionShape::of(&one.motion)).collect();
        let mut first_of: BTreeMap<(&str, &Option<String>), usize> = BTreeMap::new();
        let mut of: Vec<Option<usize>> = vec![None; all.len()];
        let mut alike = Vec::new();
        let mut order: Vec<usize> = (0..all.len()).collect();
        order.sort_by_key(|index| {
            let one = &all[*index];
            (one.reason.is_none(), one.motion.path.as_os_str().len())
        });
        for (rank, &index) in order.iter().enumerate() {
            let ReadMotion { motion, reason } = &all[index];
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

    /// Leaves out the copies. If the motion that stays has no direction, it takes the direction of its copy.
    pub(super) fn leave_out(mut self, all: &mut [ReadMotion]) {
        self.leave_out_where(all, |_| true);
    }

    fn leave_out_where(&mut self, all: &mut [ReadMotion], holds: impl Fn(&ReadMotion) -> bool) {
        for (index, of) in self.of.iter_mut().enumerate() {
            let Some(first) = of.filter(|first| holds(&all[*first])) else {
                continue;
            };
            *of = None;
            let direction = all[index].motion.direction;
            let stays = &mut all[first].motion;
            stays.direction = stays.direction.or(direction);
            let reason = LeftOutKind::Copy.saying(format!("of {}", stays.name));
            all[index].reason = Some(reason);
        }
    }
}

/// Properties by which two motions are compared.
struct MotionShape<'m> {
    values: &'m [f64],
    time_step: f64,
    /// Index of the value of largest magnitude.
    at: usize,
    /// Magnitude of this value \[m/s²\].
    peak: f64,
    /// Sum of the squares of all values over the square of the peak \[–\].
    fullness: f64,
    /// Number of sign changes among values above a tenth of the peak, plus one.
    swings: usize,
}

impl<'m> MotionShape<'m> {
    fn of(motion: &'m SuiteMotion) -> Self {
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

    /// Whether two motions differ at most by a factor.
    fn is_like(&self, other: &Self) -> bool {
        let least = if self.swings.min(other.swings) < SWINGS { ONE_PULSE } else { ONE };
        self.may_be(other) && self.correlation(other) > least
    }

    /// Whether two motions may be alike: their time steps are equal, and they roughly have what a correlation above [`ONE`] implies.
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

    /// Largest magnitude of the correlation over lags near the lag of the peaks \[–\].
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
