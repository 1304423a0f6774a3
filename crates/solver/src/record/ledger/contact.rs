//! Energy and impulse between the two points of a pair.

use super::LedgerError;
use crate::{Pair, Relation};

/// Rounding tolerance of the energies of a contact, relative to the works on both structures.
const ROUNDING: f64 = 1e-12;
/// Tolerance of a pull, relative to the largest force of its span: series leave out terms.
const PULL: f64 = 1e-9;

/// Account of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContactAccount {
    relation: Relation,
    /// The floors that carry both points, in the order of [`Relation::pushes`].
    sides: [Side; 4],
    /// Instant of the last impact, until the pair has come apart \[s\].
    hit: Option<f64>,
    /// Impulse of impulsive impacts \[N·s\].
    impacts: f64,
    impact_loss: f64,
    loss: f64,
    collision: Option<Touching>,
    /// The collision with the largest excess of returned energy over the tolerance of its steps.
    worst: Option<Touching>,
}

/// A floor that carries a point of the pair.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Side {
    floor: usize,
    /// Part of the force on the floor \[–\], negative on the left; 0 if there is no floor.
    part: f64,
    /// End of the last span; the displacement of the floor there, and that of a ground that moves separately.
    time: f64,
    displacement: f64,
    ground: f64,
    /// Whether the floor was pushed in that span.
    pushed_last: bool,
    /// Impulse of compliant contact of the pair on this floor \[N·s\].
    impulse: f64,
    /// Sum of the magnitudes of these impulses \[N·s\].
    pushed: f64,
    /// Sum of the magnitudes of all impulses on this structure \[N·s\].
    momentum: f64,
    /// Work on this structure since both sides were last seen at a common instant \[J\].
    work: f64,
}

/// A collision in progress.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Touching {
    start: f64,
    /// End of the last span with a push \[s\].
    end: f64,
    n_spans: u32,
    /// Energy taken from the structures, and energy given back \[J\].
    taken: f64,
    given: f64,
    /// Sum of the magnitudes of the works on both sides \[J\].
    exchanged: f64,
}

/// The action on a side in a span: magnitudes, ≥ 0 if the neighbours push.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Push {
    /// Start and end \[s\].
    pub(super) times: (f64, f64),
    /// Displacement at the end \[m\], and that of a ground that moves separately.
    pub(super) displacement: f64,
    pub(super) ground: f64,
    /// Whether the motion is known between the ends.
    pub(super) exact: bool,
    /// Force at both ends \[N\].
    pub(super) forces: (f64, f64),
    /// Impulse \[N·s\].
    pub(super) impulse: f64,
    /// Sum of the magnitudes of all impulses on the structure so far \[N·s\].
    pub(super) momentum: f64,
    /// Work on the structure \[J\], minus half of the work of grounds that move towards each other.
    pub(super) work: f64,
}

/// Energy and impulse of the contact of a pair.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PairTerms {
    /// Energy dissipated by impulsive impacts \[J\].
    pub impact: f64,
    /// Energy taken by compliant contact \[J\], including the energy still stored there.
    pub contact: f64,
    /// Impulse on the right structure \[N·s\], ≥ 0.
    pub impulse: f64,
    /// Impulse on the right structure plus that on the left structure \[N·s\]: 0 up to rounding.
    pub imbalance: f64,
}

impl ContactAccount {
    pub(super) fn new(pair: &Pair) -> Self {
        let mut sides = [Side::default(); 4];
        for (side, (floor, part)) in sides.iter_mut().zip(pair.relation.pushes()) {
            (side.floor, side.part) = (floor, part);
        }
        Self {
            relation: pair.relation,
            sides,
            hit: None,
            impacts: 0.0,
            impact_loss: 0.0,
            loss: 0.0,
            collision: None,
            worst: None,
        }
    }

    pub(super) fn relation(&self) -> Relation {
        self.relation
    }

    /// The floors of the pair.
    fn sides(&self) -> impl Iterator<Item = &Side> + Clone {
        self.sides.iter().filter(|side| side.part != 0.0)
    }

    /// Impulses of compliant contact on the floors of the left and of the right point \[N·s\]. The share of the ground is scaled from that
    /// of the floors.
    fn impulses(&self) -> [f64; 2] {
        let on = |is_on: fn(f64) -> bool| {
            let sides = self.sides().filter(|side| is_on(side.part));
            let given = sides.clone().map(|side| side.part * side.impulse);
            let parts = sides.map(|side| side.part.abs());
            given.sum::<f64>() / parts.sum::<f64>()
        };
        [on(|part| part < 0.0), on(|part| part > 0.0)]
    }

    /// Whether all floors of the pair have been seen at a common instant.
    fn is_together(&self) -> bool {
        let times = || self.sides().map(|side| side.time);
        let first = times().fold(f64::INFINITY, f64::min);
        times().all(|time| time <= first)
    }

    pub(super) fn terms(&self) -> PairTerms {
        let [left, right] = self.impulses();
        PairTerms {
            impact: self.impact_loss,
            contact: self.loss,
            impulse: self.impacts + right,
            imbalance: left + right,
        }
    }

    /// Books an impact.
    pub(super) fn impact(&mut self, time: f64, impulse: f64, loss: f64) {
        self.impacts += impulse;
        self.impact_loss += loss;
        self.hit = Some(time);
    }

    /// Whether the pair has not parted since its last impact.
    pub(super) fn meets(&self) -> bool {
        self.hit.is_some()
    }

    /// Forgets the last impact once the pair is apart.
    ///
    /// A motion known between its nodes separates or rests after an impact; in a step the overlap must have vanished.
    fn separate(&mut self, exact: bool) {
        let Some(hit) = self.hit else {
            return;
        };
        let last = self.sides().map(|side| side.time).fold(0.0, f64::max);
        if last > hit && (exact || (self.is_together() && self.is_apart())) {
            self.hit = None;
        }
    }

    /// Whether the neighbours do not overlap. Both have been seen at a common instant.
    fn is_apart(&self) -> bool {
        let side = |floor: usize| self.sides().find(|side| side.floor == floor);
        let moved = |floor: usize| side(floor).map_or(0.0, |side| side.displacement);
        let ground = |floor: usize| side(floor).map_or(0.0, |side| side.ground);
        let [left, right] = self.relation.points().map(|point| ground(point.floor()));
        self.relation.ahead(moved) + (left - right) <= self.relation.offset
    }

    /// Books the span of a side: 0 for the left structure, 1 for the right structure.
    #[inline]
    pub(super) fn push(&mut self, pair: usize, floor: usize, push: &Push) -> Result<(), LedgerError> {
        let place = self.sides().position(|side| side.floor == floor);
        let index = place.unwrap_or_default();
        let side = &mut self.sides[index];
        side.time = push.times.1;
        (side.displacement, side.ground) = (push.displacement, push.ground);
        // Some methods push once more after parting, others only between the ends of a span.
        side.pushed_last = push.impulse != 0.0 || push.forces != (0.0, 0.0);
        if side.pushed_last {
            side.impulse += push.impulse;
            side.pushed += push.impulse.abs();
            side.momentum = push.momentum;
            let pushed = side.pushed;
            // A wall has no momentum.
            let momentum = self.sides().map(|side| side.momentum).fold(0.0, f64::max);
            let magnitude = pushed + self.impacts + momentum;
            let side = &mut self.sides[index];
            side.work += push.work;
            self.loss -= push.work;
            let collision = self.collision.get_or_insert(Touching {
                start: push.times.0,
                end: push.times.1,
                n_spans: 0,
                taken: 0.0,
                given: 0.0,
                exchanged: 0.0,
            });
            collision.end = push.times.1;
            pulls(pair, push, magnitude)?;
        }
        self.separate(push.exact);
        // A collision is evaluated when all its floors have been seen.
        if self.is_together() {
            self.meet();
        }
        Ok(())
    }

    /// Evaluates a collision when both sides have reached a common instant.
    fn meet(&mut self) {
        let Some(collision) = &mut self.collision else {
            return;
        };
        let works = self.sides.map(|side| side.work);
        for side in &mut self.sides {
            side.work = 0.0;
        }
        let pushed = self.sides.iter().any(|side| side.pushed_last);
        if pushed || works.iter().any(|work| *work != 0.0) {
            let taken = -works.iter().sum::<f64>();
            collision.n_spans += 1;
            collision.taken += taken.max(0.0);
            collision.given += (-taken).max(0.0);
            collision.exchanged += works.iter().map(|work| work.abs()).sum::<f64>();
        }
        // A clamped law releases neighbours that still overlap, and may later give back the energy that it took.
        if pushed || !self.is_apart() {
            return;
        }
        let ended = self.collision.take();
        let excess = |touching: Option<Touching>| touching.map_or(0.0, |it| it.excess());
        if excess(ended) > excess(self.worst) {
            self.worst = ended;
        }
    }

    /// Checks that a collision gives at most the energy that it took, apart from a `negligible` energy \[J\].
    pub(super) fn gives(&self, pair: usize, negligible: f64) -> Result<(), LedgerError> {
        let Some(worst) = self.worst.filter(|worst| worst.excess() > negligible) else {
            return Ok(());
        };
        Err(LedgerError::GainInContact {
            pair,
            start: worst.start,
            end: worst.end,
            found: worst.given - worst.taken,
            allowed: worst.allowed() + negligible,
        })
    }

    /// Checks that both structures have opposite impulses.
    pub(super) fn balanced(&self, pair: usize) -> Result<(), LedgerError> {
        let [left, right] = self.impulses();
        let allowed = PULL * self.sides().map(|side| side.pushed).sum::<f64>();
        if (left + right).abs() <= allowed {
            Ok(())
        } else {
            Err(LedgerError::Imbalance { pair, left, right })
        }
    }
}

impl Touching {
    /// Energy that may be given back beyond the energy taken \[J\].
    ///
    /// A stepping method finds the ends of a collision to a step: an error of a single step out of n is the nth part.
    fn allowed(&self) -> f64 {
        self.taken / f64::from(self.n_spans) + ROUNDING * self.exchanged
    }

    /// Energy given back beyond the allowed energy \[J\].
    fn excess(&self) -> f64 {
        self.given - self.taken - self.allowed()
    }
}

/// Checks that neighbours push and do not pull. `magnitude` is the sum of impulses on the structure so far \[N·s\].
fn pulls(pair: usize, push: &Push, magnitude: f64) -> Result<(), LedgerError> {
    let (start, end) = push.times;
    let allowed = PULL * push.forces.0.abs().max(push.forces.1.abs());
    // The impulse of a piece near the resolution of the clock is rounding.
    let mean = if push.impulse < -ROUNDING * magnitude {
        push.impulse / (end - start)
    } else {
        0.0
    };
    for (time, found) in [(start, push.forces.0), (end, push.forces.1), (end, mean)] {
        if found < -allowed {
            return Err(LedgerError::Tension { pair, time, found });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A span below the resolution of the clock, of floors that touch before they feel the shaking: −4e-120 N·s over 0 s counted as a pull
    /// of −∞.
    #[test]
    fn issue_an_impulse_below_rounding_is_no_pull() {
        let push = |impulse: f64, duration: f64| Push {
            times: (0.75, 0.75 + duration),
            displacement: 0.0,
            ground: 0.0,
            exact: true,
            forces: (1e-104, 5e-104),
            impulse,
            momentum: 1e4,
            work: 0.0,
        };
        let law = pounding_contact::ContactLaw::Stereomechanical(pounding_contact::Stereomechanical { restitution: 0.0 });
        let pair = Pair::of_floors(0, 1, 0.0, law);
        let mut contact = ContactAccount::new(&pair);
        assert_eq!(contact.push(7, 0, &push(-4e-120, 0.0)), Ok(()));
        let pull = ContactAccount::new(&pair).push(7, 0, &push(-1.0, 0.01));
        let Err(LedgerError::Tension { pair: 7, found, .. }) = pull else {
            panic!("{pull:?}");
        };
        assert!((found + 100.0).abs() < 1e-9, "{found}");
    }
}
