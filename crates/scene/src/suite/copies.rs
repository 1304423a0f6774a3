//! Records that lie in a folder twice: copies are left out, and a motion that is another one times a factor is told.

use std::collections::BTreeMap;

use crate::STANDARD_GRAVITY;

use super::{LeftOut, Motion, ReasonKind, Suite};

/// Correlation from which on two motions are one \[–\].
const ONE: f64 = 0.99;

/// Largest difference between the peaks of two copies, as a part of the larger.
const SAME_PEAK: f64 = 0.01;

/// Lags around that of the peaks at which motions are compared, in steps.
const LAGS: isize = 3;

/// Leaves out copies, of which the one with the shortest name stays, and lists motions that are alike but for a factor.
pub(super) fn leave_out(suite: &mut Suite) {
    let motions = &suite.motions;
    let shapes: Vec<Shape<'_>> = motions.iter().map(Shape::of).collect();
    let mut first_of: BTreeMap<(&str, &Option<String>), usize> = BTreeMap::new();
    let mut copy_of: Vec<Option<usize>> = vec![None; motions.len()];
    let mut alike = Vec::new();
    let mut order: Vec<usize> = (0..motions.len()).collect();
    order.sort_by_key(|index| motions[*index].path.as_os_str().len());
    for (rank, &index) in order.iter().enumerate() {
        let motion = &motions[index];
        let bytes = (motion.origin.sha256.as_str(), &motion.taken.component);
        if let Some(first) = first_of.get(&bytes) {
            copy_of[index] = copy_of[*first].or(Some(*first));
            continue;
        }
        first_of.insert(bytes, index);
        let before = order[..rank].iter().copied();
        let others = before.filter(|other| {
            copy_of[*other].is_none()
                && motions[*other].path != motion.path
                && shapes[*other].may_be(&shapes[index])
        });
        for other in others.collect::<Vec<usize>>() {
            if shapes[other].correlation(&shapes[index]) <= ONE {
                continue;
            }
            let [one, another] = [other, index].map(|at| shapes[at].peak);
            if (one - another).abs() <= SAME_PEAK * one.max(another) {
                copy_of[index] = Some(other);
            } else {
                alike.push((other, index, another / one));
            }
            break;
        }
    }
    let named = |index: usize| suite.motions[index].name.clone();
    let alike = alike
        .into_iter()
        .filter(|(_, index, _)| copy_of[*index].is_none())
        .map(|(one, other, factor)| (named(one), named(other), factor));
    suite.alike = alike.collect();
    let copies = copy_of.iter().enumerate();
    let copies = copies.filter_map(|(index, of)| {
        Some(LeftOut {
            name: named(index),
            reason: ReasonKind::Copy.saying(format!("of {}", named((*of)?))),
        })
    });
    suite.left_out.extend(copies);
    let mut is_copy = copy_of.iter();
    suite
        .motions
        .retain(|_| is_copy.next().is_some_and(Option::is_none));
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
        let squares: f64 = values.iter().map(|value| value * value).sum();
        Self {
            values,
            time_step: file.time_step(),
            at,
            peak: file.unit().to_si(largest, STANDARD_GRAVITY),
            fullness: squares / (largest * largest),
        }
    }

    /// Whether it is worth while to compare them: the time steps are equal, and what a correlation above [`ONE`] implies holds roughly.
    fn may_be(&self, other: &Self) -> bool {
        let [least, most] = [
            self.fullness.min(other.fullness),
            self.fullness.max(other.fullness),
        ];
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
