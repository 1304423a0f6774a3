//! What a run says of a touch, and the same touch in another run.

use pounding_contact::Clamp;

use super::compared::{Compared, Place, Two};
use pounding_scene::RunErrors;
use pounding_solver::Pair;

/// What a run says of a touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting {
    /// First instant \[s\].
    pub start: f64,
    /// Last instant \[s\]; nothing of laws that let go before.
    pub end: Option<f64>,
    /// Impulse \[N·s\].
    pub impulse: f64,
    /// Peak force \[N\]; nothing of an impact.
    pub peak_force: Option<f64>,
    /// How long it lasts \[s\].
    pub lasts: f64,
    /// What rounding leaves open of the start, where the run says \[s\].
    pub uncertainty: Option<f64>,
}

/// Touches in the order of their starts, as one where rounding decides that they are several.
///
/// How many bounces end in rest, and which of several floors that meet at once hits first, is a matter of where a route stops to tell
/// them apart. So is how many of the bounces that a neighbour of theirs comes to rest with are passed on to a pair at rest: those of
/// no impulse belong to the touch that goes on. And so is whether a force that passes zero ends a touch: a force that
/// begins where another one ends goes on.
pub(super) fn as_one(touches: Vec<Meeting>) -> Vec<Meeting> {
    let largest = Largest::of(&touches).impulse;
    let mut all: Vec<Meeting> = Vec::with_capacity(touches.len());
    let mut latest = f64::NEG_INFINITY;
    for next in touches {
        let belongs = |last: &Meeting| {
            let apart = next.start - (last.start + last.lasts);
            let press = last.peak_force.is_some() && next.peak_force.is_some();
            let goes_on = press && last.lasts > 0.0 && apart <= TOGETHER;
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

/// Whether impacts of two pairs, in their order, ever happen at once.
pub(super) fn are_at_once(one: &[Meeting], other: &[Meeting]) -> bool {
    let mut next = 0;
    let impacts = one.iter().filter(|one| one.peak_force.is_none());
    impacts.map(|one| one.start).any(|time| {
        next += other[next..].partition_point(|other| other.start < time - TOGETHER);
        let near = other[next..].iter();
        let mut near = near.take_while(|other| other.start <= time + TOGETHER);
        near.any(|other| other.peak_force.is_none())
    })
}

/// Touches of a pair that begin within this of the one before are compared as one with it \[s\].
const TOGETHER: f64 = 1e-9;

/// The largest of some touches.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Largest {
    /// Impulse \[N·s\].
    pub impulse: f64,
    /// Force \[N\].
    pub force: f64,
}

impl Largest {
    pub(super) fn of(touches: &[Meeting]) -> Self {
        let forces = touches.iter().filter_map(|one| one.peak_force);
        Self {
            impulse: touches.iter().map(|one| one.impulse).fold(0.0, f64::max),
            force: forces.fold(0.0, f64::max),
        }
    }

    /// Not less than a part of another one.
    pub(super) fn at_least(self, part: f64, other: Self) -> Self {
        Self {
            impulse: self.impulse.max(part * other.impulse),
            force: self.force.max(part * other.force),
        }
    }
}

/// Part of a touch out of rest in which its force may still be rounding: the cube root of 1e-13 of the forces, which the second route
/// does not tell from none, where it grows with the cube of time.
const LEAVES_ZERO: f64 = 5e-5;

/// Part of the largest impulse of a pair that is rounding.
const ROUNDING: f64 = 1e-12;

impl Meeting {
    /// A touch of a pair between two instants \[s\], with its impulse \[N·s\] and force \[N\].
    pub(super) fn new(pair: &Pair, [start, end]: [f64; 2], (impulse, peak_force): (f64, Option<f64>), uncertainty: Option<f64>) -> Self {
        // Neighbours part when the force of their law ends only where nothing clamps it.
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

    /// Takes a touch that follows at once as part of this one; an impact has no force.
    fn add(&mut self, next: &Self) {
        let (one, other) = (self.peak_force, next.peak_force);
        self.peak_force = one.zip(other).map(|(one, other)| one.max(other));
        self.lasts = self.lasts.max(next.start + next.lasts - self.start);
        self.end = self.end.zip(next.end).map(|(one, other)| one.max(other));
        self.impulse += next.impulse;
    }

    /// Whether it begins without an approach: where the force between neighbours at rest leaves zero.
    pub(super) fn presses_out_of_rest(&self) -> bool {
        self.uncertainty.is_none() && self.peak_force.is_some()
    }

    /// Whether rounding decides that neighbours touch at all.
    pub(super) fn is_graze(&self, largest: f64) -> bool {
        let brief = |uncertainty: f64| self.lasts > 0.0 && self.lasts <= 2.0 * uncertainty;
        self.impulse <= ROUNDING * largest || self.uncertainty.is_some_and(brief)
    }

    /// Its numbers beside those of the same touch in another run, all of them infinitely far from none. A number that a touch of
    /// its kind does not have is no distance away, and neither is the force of one that rests: whether the impact that rest began
    /// with has an impulse at all may be rounding, and the impulse of both is compared.
    pub(super) fn beside(&self, other: Option<&Self>, place: Place, largest: Largest) -> [Two; 4] {
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
        if self.presses_out_of_rest() && start.distance <= LEAVES_ZERO * self.lasts {
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

/// Touches that begin within this of each other are the same one, where the numbers of touches differ \[s\]; bounces of no impulse
/// belong to what follows within it.
pub(super) const SAME: f64 = 1e-7;

/// For every touch of a pair the same touch in another run: the one of the same number, or where the runs count differently, the one
/// that begins nearest to it of those that begin at the same time.
pub(super) fn matched(first: &[Meeting], second: &[Meeting]) -> Vec<Option<usize>> {
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

/// The touch from a number on that begins nearest to an instant \[s\], if it begins at the same time.
fn nearest(touches: &[Meeting], from: usize, time: f64) -> Option<usize> {
    let apart = |one: &Meeting| (one.start - time).abs();
    let later = from + touches[from..].partition_point(|one| one.start < time);
    let near = later.saturating_sub(1).max(from)..touches.len().min(later + 1);
    let nearest = near.min_by(|one, other| apart(&touches[*one]).total_cmp(&apart(&touches[*other])));
    nearest.filter(|&nearest| apart(&touches[nearest]) <= SAME)
}
