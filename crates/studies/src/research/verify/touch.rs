//! Touches of a run, with a search for the corresponding touch of another run.

use pounding_contact::Clamp;

use super::compared::{ALLOWED, Compared, NumberPlace, Two};
use pounding_scene::RunErrors;
use pounding_solver::Pair;

/// A touch of a pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    /// First instant \[s\].
    pub start: f64,
    /// Last instant \[s\]; `None` for laws that let go before neighbours part.
    pub end: Option<f64>,
    /// Impulse \[N·s\].
    pub impulse: f64,
    /// Peak force \[N\]; `None` for an impact.
    pub peak_force: Option<f64>,
    /// Duration \[s\].
    pub lasts: f64,
    /// Uncertainty of the start by rounding \[s\], if the run gives it.
    pub uncertainty: Option<f64>,
}

/// Sorted touches, in which those that only rounding keeps apart are merged.
///
/// A route's resolution decides three things: how many bounces end in rest, which of several floors that meet at once hits first, and how
/// many bounces of a neighbour coming to rest reach a pair at rest. Bounces without an impulse therefore belong to the touch that
/// continues. A force that passes through zero, or an impact on a pair at rest, may end a touch or not. A touch that begins where another
/// one ends therefore continues it.
pub(super) fn as_one(touches: Vec<Touch>) -> Vec<Touch> {
    let largest = Largest::of(&touches).impulse;
    let mut all: Vec<Touch> = Vec::with_capacity(touches.len());
    let mut latest = f64::NEG_INFINITY;
    for next in touches {
        let belongs = |last: &Touch| {
            let apart = next.start - (last.start + last.lasts);
            let goes_on = last.lasts > 0.0 && apart <= TOGETHER;
            let slight = last.impulse <= ROUNDING * largest && apart <= SAME;
            next.start - latest <= TOGETHER || goes_on || slight
        };
        match all.last_mut().filter(|last| belongs(last)) {
            Some(last) => last.add(&next),
            None => all.push(next),
        }
        latest = next.start;
    }
    all
}

/// Whether impacts of two pairs, in their order, ever coincide.
pub(super) fn are_at_once(one: &[Touch], other: &[Touch]) -> bool {
    let mut next = 0;
    let impacts = one.iter().filter(|one| one.peak_force.is_none());
    impacts.map(|one| one.start).any(|time| {
        next += other[next..].partition_point(|other| other.start < time - TOGETHER);
        let near = other[next..].iter();
        let mut near = near.take_while(|other| other.start <= time + TOGETHER);
        near.any(|other| other.peak_force.is_none())
    })
}

/// Longest pause after which a touch of a pair still belongs to the previous one \[s\].
const TOGETHER: f64 = 1e-9;

/// The largest impulse and force of some touches.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Largest {
    /// Impulse \[N·s\].
    pub impulse: f64,
    /// Force \[N\].
    pub force: f64,
}

impl Largest {
    pub(super) fn of(touches: &[Touch]) -> Self {
        let forces = touches.iter().filter_map(|one| one.peak_force);
        Self {
            impulse: touches.iter().map(|one| one.impulse).fold(0.0, f64::max),
            force: forces.fold(0.0, f64::max),
        }
    }

    /// Raises both numbers to at least `part` of another's.
    pub(super) fn at_least(self, part: f64, other: Self) -> Self {
        Self {
            impulse: self.impulse.max(part * other.impulse),
            force: self.force.max(part * other.force),
        }
    }
}

/// Part of a touch out of rest in which its force may still be rounding. The force grows with the cube of time, and the second route cannot
/// tell 1e-13 of the forces from zero; this is the cube root.
const LEAVES_ZERO: f64 = 5e-5;

/// Largest impulse that is rounding, as a part of the largest impulse of the pair \[–\].
const ROUNDING: f64 = 1e-12;

impl Touch {
    /// A touch of a pair between two instants \[s\], with its impulse \[N·s\] and force \[N\].
    pub(super) fn new(pair: &Pair, [start, end]: [f64; 2], impulse: f64, peak_force: Option<f64>, uncertainty: Option<f64>) -> Self {
        // Neighbours part at the end of the force only if nothing clamps it.
        let parts = pair.law.clamp() == Clamp::Never;
        Self {
            start,
            end: parts.then_some(end),
            impulse,
            peak_force,
            lasts: end - start,
            uncertainty,
        }
    }

    /// Merges a touch that follows at once; an impact has no force, and adds none to a rest.
    fn add(&mut self, next: &Self) {
        let (one, other) = (self.peak_force, next.peak_force);
        self.peak_force = one.zip(other).map(|(one, other)| one.max(other)).or(one);
        self.lasts = self.lasts.max(next.start + next.lasts - self.start);
        self.end = self.end.zip(next.end).map(|(one, other)| one.max(other));
        self.impulse += next.impulse;
    }

    /// Whether the touch begins without an approach, when the force between neighbours at rest becomes positive.
    pub(super) fn presses_out_of_rest(&self) -> bool {
        self.uncertainty.is_none() && self.peak_force.is_some()
    }

    /// Whether rounding decides if the neighbours touch at all.
    pub(super) fn is_graze(&self, largest: f64) -> bool {
        let brief = |uncertainty: f64| self.lasts > 0.0 && self.lasts <= 2.0 * uncertainty;
        self.impulse <= ROUNDING * largest || self.uncertainty.is_some_and(brief)
    }

    /// Whether two routes differ in the start alone: the force is rounding until the later one.
    fn begins_without_impulse(&self, other: &Self) -> bool {
        let ends = [self, other].map(|one| one.start + one.lasts);
        let same = (ends[0] - ends[1]).abs() <= ALLOWED && (other.impulse - self.impulse).abs() <= ALLOWED * self.impulse;
        self.lasts > 0.0 && other.peak_force.is_some() && same
    }

    /// Compares the touch with the corresponding one of another run; without one, all distances are infinite. A number that the kind of
    /// touch does not have has distance 0. So does a force that only one of both has: rounding may decide whether the impact before a rest
    /// has an impulse, and the impulses are compared.
    pub(super) fn beside(&self, other: Option<&Self>, place: NumberPlace, largest: Largest) -> [Two; 4] {
        let two = |what, value: fn(&Self) -> Option<f64>, scale: f64| {
            let (first, second) = (value(self), other.and_then(value));
            Two {
                what,
                place,
                first: first.unwrap_or(f64::NAN),
                second: second.unwrap_or(f64::NAN),
                distance: match (first, second) {
                    (Some(first), Some(second)) => RunErrors::relative_to(second, first, scale),
                    (Some(_), None) if other.is_none() => f64::INFINITY,
                    (None, _) | (Some(_), None) => 0.0,
                },
            }
        };
        let mut start = two(Compared::Start, |one| Some(one.start), 1.0);
        let leaves_zero = start.distance <= LEAVES_ZERO * self.lasts || other.is_some_and(|other| self.begins_without_impulse(other));
        if self.presses_out_of_rest() && leaves_zero {
            start.distance = 0.0;
        }
        [
            start,
            two(Compared::End, |one| one.end, 1.0),
            two(Compared::Impulse, |one| Some(one.impulse), largest.impulse),
            two(Compared::PoundingForce, |one| one.peak_force, largest.force),
        ]
    }
}

/// Largest distance between the starts of corresponding touches, if the numbers of touches differ \[s\]. A bounce without impulse belongs
/// to a touch that follows within this time.
pub(super) const SAME: f64 = 1e-7;

/// For every touch of a pair the index of the corresponding touch in another run. If the runs have different numbers of touches, it is the
/// one with the nearest start within [`SAME`].
pub(super) fn matched(first: &[Touch], second: &[Touch]) -> Vec<Option<usize>> {
    if first.len() == second.len() {
        return (0..first.len()).map(Some).collect();
    }
    let mut next = 0;
    let mut all = Vec::with_capacity(first.len());
    for (index, one) in first.iter().enumerate() {
        let same = nearest(second, next, one.start);
        let same = same.filter(|&same| nearest(first, index, second[same].start) == Some(index));
        next = same.map_or(next, |same| same + 1);
        all.push(same);
    }
    all
}

/// The touch with the nearest start to an instant \[s\], from index `from`, if it is within [`SAME`].
fn nearest(touches: &[Touch], from: usize, time: f64) -> Option<usize> {
    let apart = |one: &Touch| (one.start - time).abs();
    let later = from + touches[from..].partition_point(|one| one.start < time);
    let near = later.saturating_sub(1).max(from)..touches.len().min(later + 1);
    let nearest = near.min_by(|one, other| apart(&touches[*one]).total_cmp(&apart(&touches[*other])));
    nearest.filter(|&nearest| apart(&touches[nearest]) <= SAME)
}
