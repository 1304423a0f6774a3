//! End of a step: at the first corner of the force within it.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::Pressing;
use crate::exact::dormand_prince::Stepped;
use crate::exact::pressed::{Corner, PressedPoint, rate};
use crate::exact::search::rise;
use crate::number::{Lanes, Mask};

/// Part of a step to which corners are located on its polynomial, and largest values, whose error is the square.
const FINELY: f64 = 1e-6;
pub(super) const ROUGHLY: f64 = 1e-2;
/// Part of a step over which a slope is taken. The end of the step moves at most by this part along a line, from the corner of the
/// polynomial to the corner of the motion.
pub(super) const PROBE: f64 = 1e-4;
const MOST_REST: f64 = 0.01;
/// Distance from the end of a branch, in the measure of `Pressed::side_of`. A force that is farther from it at both ends of a step does not
/// leave the branch in between. Without this bound no examined scene had another result.
const NEAR: f64 = 0.5;
/// Part of the approach speed below which neighbours may just as well be moving apart.
const FLAT: f64 = 1e-6;

/// A step up to the first corner within it.
pub(super) struct Reached<S: Simd> {
    pub(super) stepped: Stepped<Lanes<S>>,
    pub(super) length: Lanes<S>,
    /// The end, exactly at the corner.
    pub(super) next: PressedPoint<Lanes<S>>,
    pub(super) bends: Mask<S>,
    pub(super) parts: Mask<S>,
    /// Lanes that would miss corners or turns: they are tried again up to `length`.
    pub(super) again: Mask<S>,
    /// Lanes in which the step is rejected whatever its error.
    too_long: Mask<S>,
}

impl<S: Simd> Reached<S> {
    /// Error relative to the approach speed; infinite if the step is rejected.
    #[inline(always)]
    pub(super) fn error(&self) -> Lanes<S> {
        let error = self.stepped.error;
        Number::select(self.too_long | self.again, error.like(f64::INFINITY), error)
    }

    /// Marks the step to be tried again up to a part of it, in lanes that are not yet marked.
    #[inline(always)]
    pub(super) fn try_again(&mut self, lanes: Mask<S>, part: Lanes<S>) {
        let lanes = lanes & !self.again;
        self.length = Number::select(lanes, part * self.length, self.length);
        self.again = self.again | lanes;
    }
}

impl<S: Simd> Pressing<S> {
    /// A step that ends at the latest where the force bends sharply or neighbours part, or a step to be tried again.
    // Loops over both corners would cost a fifth of all time: their iterators copy lanes through memory.
    #[inline(always)]
    pub(super) fn reach(&self, step: Lanes<S>) -> Reached<S> {
        let stepped = self.pressed.step(&self.here, step);
        let none = Mask::splat(step.token(), false);
        let mut reached = Reached {
            next: stepped.next,
            stepped,
            length: step,
            bends: none,
            parts: none,
            again: none,
            too_long: none,
        };
        let probe = step * step.like(PROBE);
        let bend = self.pressed.side_behind(Corner::Bend, &self.here, probe);
        let parting = self.pressed.side_of(Corner::Parting, &self.here.state);
        self.stop_in_a_dip(Corner::Parting, parting, step, &mut reached);
        self.stop_in_a_dip(Corner::Bend, bend, step, &mut reached);
        // What would bend behind a parting bends nothing.
        self.stop_at(Corner::Bend, bend, &mut reached);
        self.stop_at(Corner::Parting, parting, &mut reached);
        reached
    }

    /// Ends a step at a corner within it; `before` is the side of the corner at the start.
    #[inline(always)]
    fn stop_at(&self, corner: Corner, before: Lanes<S>, reached: &mut Reached<S>) {
        let (pressed, here) = (&self.pressed, &self.here);
        let [zero, one] = [0.0, 1.0].map(|number| before.like(number));
        let mut passed = self.used.exceeds(zero) & !reached.again;
        passed = passed
            & match corner {
                Corner::Bend => zero.exceeds(before * pressed.side_of(corner, &reached.next.state)),
                Corner::Parting => pressed.parts(here, &reached.next),
            };
        if corner == Corner::Parting {
            // The first step passed the whole contact.
            let whole = passed & !here.s.exceeds(zero);
            reached.too_long = whole;
            passed = passed & !whole;
        }
        if !Lanes::any(passed) {
            return;
        }
        let length = reached.length;
        let way = reached.stepped.way(here, length);
        let after = pressed.side_of(corner, &reached.stepped.next.state);
        let sign = Number::select(zero.exceeds(before), one, zero - one);
        let number = |part| sign * pressed.side_of(corner, &way.at(part));
        let part = rise(passed, [sign * before, sign * after], FINELY, number);
        reached.length = Number::select(passed, part * length, length);
        reached.stepped = pressed.step(here, reached.length);
        let (settled, close) = self.settle(corner, &reached.stepped.next, reached.length);
        let next = &mut reached.next;
        next.s = Number::select(passed, settled.s, next.s);
        for index in 0..next.state.len() {
            let [state, slope] = [settled.state[index], settled.slope[index]];
            next.state[index] = Number::select(passed, state, next.state[index]);
            next.slope[index] = Number::select(passed, slope, next.slope[index]);
        }
        match corner {
            Corner::Bend => reached.bends = passed,
            Corner::Parting => {
                reached.parts = passed;
                // The polynomial is too coarse to locate the parting.
                reached.too_long = reached.too_long | (passed & !close);
            }
        }
    }

    /// Shortens a step that would miss a pair of corners. Either neighbours touch at both ends and part in between: it ends where they are
    /// farthest apart. Or a force is on a branch at both ends and leaves it in between: it ends where the force is farthest away.
    #[inline(always)]
    fn stop_in_a_dip(&self, corner: Corner, before: Lanes<S>, step: Lanes<S>, reached: &mut Reached<S>) {
        let (pressed, here, next) = (&self.pressed, &self.here, &reached.stepped.next);
        let [zero, one, probe] = [0.0, 1.0, PROBE].map(|number| before.like(number));
        let after = pressed.side_of(corner, &next.state);
        let near = match corner {
            // After a turn of the deformation the rate is rounding.
            Corner::Parting => (zero.like(FLAT) * pressed.speed).exceeds(rate(&here.state)),
            Corner::Bend => zero.like(NEAR).exceeds(before.abs().min(after.abs())),
        };
        let same = self.used.exceeds(zero) & near & (before * after).exceeds(zero);
        if !Lanes::any(same) {
            return;
        }
        let sign = Number::select(zero.exceeds(before), zero - one, one);
        let behind = pressed.side_of(corner, &here.moved(probe * step));
        let mut starts = sign * (behind - pressed.side_of(corner, &here.state));
        if corner == Corner::Parting {
            starts = starts.min(zero.like(-f64::MIN_POSITIVE));
        }
        let ahead = pressed.side_of(corner, &next.moved(zero - probe * step));
        let ends = sign * (after - ahead);
        let turns = same & zero.exceeds(starts) & ends.exceeds(zero);
        if !Lanes::any(turns) {
            return;
        }
        let way = reached.stepped.way(here, step);
        let climbs = |part: Lanes<S>| {
            let before = pressed.side_of(corner, &way.at(part - probe));
            sign * (pressed.side_of(corner, &way.at(part + probe)) - before)
        };
        let part = rise(turns, [starts, ends], ROUGHLY, climbs);
        let there = pressed.side_of(corner, &way.at(part));
        let dips = turns & zero.exceeds(sign * there);
        reached.try_again(dips, part);
    }

    /// Moves a point near a corner to it along a line; true in lanes in which it was close enough.
    #[inline(always)]
    fn settle(&self, corner: Corner, near: &PressedPoint<Lanes<S>>, length: Lanes<S>) -> (PressedPoint<Lanes<S>>, Mask<S>) {
        let pressed = &self.pressed;
        let probe = length * length.like(PROBE);
        let value = pressed.side_of(corner, &near.state);
        let beyond = pressed.side_of(corner, &near.moved(probe));
        let zero = length.like(0.0);
        let rest = (zero - value) * probe / (beyond - value);
        let close = (length * length.like(MOST_REST)).exceeds(rest.abs());
        let rest = Number::select(close, rest.min(self.end - near.s), zero);
        (pressed.at(near.s + rest, near.moved(rest)), close)
    }
}
