//! Largest values within a step: forces, and displacements of both sides.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::Pressing;
use super::reach::{PROBE, ROUGHLY, Reached};
use crate::exact::pressed::{State, rate};
use crate::exact::search::rise;
use crate::number::{Lanes, Mask};

impl<S: Simd> Pressing<S> {
    /// The force at the end of a step \[N\], and its rate \[N/s\].
    #[inline(always)]
    pub(super) fn force_at(&self, reached: &Reached<S>) -> [Lanes<S>; 2] {
        let approaches = rate(&self.here.state).exceeds(self.here.s.like(0.0));
        self.pressed.climb(&reached.next, approaches)
    }

    /// Updates the largest values within an accepted step with this force at its end.
    #[inline(always)]
    pub(super) fn follow(&mut self, reached: &Reached<S>, [force, climb]: [Lanes<S>; 2], taken: Mask<S>) {
        let Self { pressed, here, .. } = self;
        let next = &reached.next;
        let zero = here.s.like(0.0);
        let mut peak_force = self.peak_force.max(force);
        let tops = taken & !zero.reaches(self.climb) & !climb.exceeds(zero);
        let turns = [1, 3].map(|v: usize| taken & zero.exceeds(here.state[v] * next.state[v]));
        if Lanes::any(tops | turns[0] | turns[1]) {
            let way = reached.stepped.way(here, reached.length);
            if Lanes::any(tops) {
                let probe = here.s.like(PROBE);
                let number = |part: Lanes<S>| {
                    let [before, after] = [part - probe, part + probe];
                    pressed.force(&way.at(before)) - pressed.force(&way.at(after))
                };
                // The rate at the ends, from the rates of the force there.
                let [before, after] = [(&*here, self.climb), (next, climb)].map(|(point, climb)| {
                    let time = here.s.like(-8.0) * point.s * point.s * point.s;
                    time * reached.length * probe * climb
                });
                let before = Number::select(before.differs(before), zero - after, before);
                let top = rise(tops, [before, after], ROUGHLY, number);
                let force = pressed.force(&way.at(top));
                peak_force = Number::select(tops, peak_force.max(force), peak_force);
            }
            for (side, turns) in turns.into_iter().enumerate() {
                if Lanes::any(turns) {
                    let [u, v] = [2 * side, 2 * side + 1];
                    let [before, after] = [here.state[v], next.state[v]];
                    let sign = Number::select(before.exceeds(zero), here.s.like(-1.0), here.s.like(1.0));
                    let number = |part| sign * way.at(part)[v];
                    let turn = rise(turns, [sign * before, sign * after], ROUGHLY, number);
                    self.extremes[side] = reach(turns, self.extremes[side], way.at(turn)[u]);
                }
            }
        }
        for side in 0..2 {
            self.extremes[side] = reach(taken, self.extremes[side], next.state[2 * side]);
        }
        self.follow_closing(reached, taken);
        let climb = Number::select(reached.bends, zero.like(f64::NAN), climb);
        self.climb = Number::select(taken, climb, self.climb);
        self.peak_force = Number::select(taken, peak_force, self.peak_force);
    }
}

impl<S: Simd> Pressing<S> {
    /// Updates how far neighbours come towards each other in an accepted step, if requested.
    #[inline(always)]
    fn follow_closing(&mut self, reached: &Reached<S>, taken: Mask<S>) {
        let Some(known) = self.closing else {
            return;
        };
        let (here, next) = (&self.here, &reached.next);
        let ahead = |state: &State<Lanes<S>>| state[0] - state[2];
        let rates = [&here.state, &next.state].map(rate);
        let zero = known.like(0.0);
        let mut closing = known.max(ahead(&next.state));
        let turns = taken & rates[0].exceeds(zero) & zero.exceeds(rates[1]);
        if Lanes::any(turns) {
            let way = reached.stepped.way(here, reached.length);
            let opens = rates.map(|rate| zero - rate);
            let turn = rise(turns, opens, ROUGHLY, |part| zero - rate(&way.at(part)));
            let nearest = closing.max(ahead(&way.at(turn)));
            closing = Number::select(turns, nearest, closing);
        }
        self.closing = Some(Number::select(taken, closing, known));
    }
}

/// Extremes of a displacement including another value, where it counts.
#[inline(always)]
fn reach<S: Simd>(counts: Mask<S>, [least, largest]: [Lanes<S>; 2], u: Lanes<S>) -> [Lanes<S>; 2] {
    [
        Number::select(counts, least.min(u), least),
        Number::select(counts, largest.max(u), largest),
    ]
}
