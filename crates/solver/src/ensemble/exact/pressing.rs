//! Steps in compliant contact in lanes: error control, and what ends a step.

mod follow;

use fearless_simd::Simd;
use pounding_contact::{Form, Number, Term};

use super::Interval;
use super::contact::Contact;
use super::dormand_prince::Stepped;
use super::pair::Scene;
use super::pressed::{Corner, Half, Point, Pressed, fourth_power, rate};
use super::search::rise;
use crate::ensemble::number::{Lanes, Mask};

/// Steps of a contact between two samples; no scene that was looked at needs a tenth.
const MOST_STEPS: f64 = 10_000.0;
/// A step shrinks to this part at least, and grows by no more than this.
const LEAST_SHRINK: f64 = 0.2;
const MOST_GROWTH: f64 = 4.0;
/// Part of a step to which corners are searched on its polynomial, and largest values, of which the square counts.
const FINELY: f64 = 1e-6;
const ROUGHLY: f64 = 1e-2;
/// Part of a step over which a slope is taken, and by which its end is moved at most on a line, from the corner of the
/// polynomial to that of the motion.
const PROBE: f64 = 1e-4;
const MOST_REST: f64 = 0.01;
/// A branch of the force that is farther from its end than this at both ends of a step, in the measure of [`Pressed::side_of`], is not left
/// between; without this bound no scene that was looked at came out otherwise.
const NEAR: f64 = 0.5;
/// Part of the approach speed below which neighbours may as well move apart.
const FLAT: f64 = 1e-6;

/// Contacts in lanes.
pub(super) struct Pressing<S: Simd> {
    pressed: Pressed<Lanes<S>>,
    here: Point<Lanes<S>>,
    /// Time since the touch where the scene came \[s\].
    start: Lanes<S>,
    /// Next step, and the end of the interval, in s.
    step: Lanes<S>,
    end: Lanes<S>,
    tolerance: Lanes<S>,
    /// 1 in lanes with a scene, 0 in others.
    used: Lanes<S>,
    /// Steps that were tried.
    tried: Lanes<S>,
    /// How fast the force changes here \[N/s\]; no number just after a touch or a bend, or where the ground's acceleration jumps.
    climb: Lanes<S>,
    peak_force: Lanes<S>,
    /// Least and largest displacements of both sides.
    extremes: [[Lanes<S>; 2]; 2],
}

/// What became of lanes in a step.
pub(super) struct Ends<S: Simd> {
    /// Does not go on: parted, broken, or at the end of the interval.
    pub(super) ended: Mask<S>,
    pub(super) parted: Mask<S>,
    /// No numbers, or no end of steps.
    pub(super) broken: Mask<S>,
}

/// A step up to the first corner on its way.
struct Reached<S: Simd> {
    stepped: Stepped<Lanes<S>>,
    length: Lanes<S>,
    /// The end, at the corner itself.
    next: Point<Lanes<S>>,
    error: Lanes<S>,
    bends: Mask<S>,
    parts: Mask<S>,
}

impl<S: Simd> Pressing<S> {
    /// Lanes for contacts by laws of the same powers as that of a scene.
    #[inline(always)]
    pub(super) fn new(simd: S, form: &Form) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let half = Half {
            inverse_mass: zero,
            damping: zero,
            stiffness: zero,
            mobile: zero,
        };
        let term = |power| Term {
            coefficient: zero,
            power,
        };
        Self {
            pressed: Pressed {
                left: half,
                right: half,
                largest_inverse_mass: zero,
                gap: zero,
                form: Form {
                    spring: term(form.spring.power),
                    damper: term(form.damper.power),
                    action: form.action,
                },
                speed: zero,
                ground: [zero; 2],
            },
            here: Point {
                s: zero,
                state: [zero; 5],
                slope: [zero; 5],
            },
            start: zero,
            step: zero,
            end: zero,
            tolerance: zero,
            used: zero,
            tried: zero,
            climb: zero,
            peak_force: zero,
            extremes: [[zero; 2]; 2],
        }
    }

    /// Takes a scene in contact into a lane.
    #[inline(always)]
    pub(super) fn take(
        &mut self,
        lane: usize,
        scene: &Scene,
        contact: &Contact,
        interval: &Interval,
    ) {
        let since = fourth_power(contact.s);
        let ahead = interval.after(scene.at);
        let pressed = &mut self.pressed;
        let halves = [&mut pressed.left, &mut pressed.right];
        for (index, (half, side)) in halves.into_iter().zip(&scene.sides).enumerate() {
            half.inverse_mass.set(lane, side.inverse_mass);
            half.damping.set(lane, side.damping);
            half.stiffness.set(lane, side.stiffness);
            half.mobile.set(lane, side.mobile);
            self.here.state[2 * index].set(lane, side.displacement);
            self.here.state[2 * index + 1].set(lane, side.velocity);
            for (extreme, of_side) in self.extremes[index].iter_mut().zip(side.extremes) {
                extreme.set(lane, of_side);
            }
        }
        let climb = if interval.jumps {
            f64::NAN
        } else {
            contact.climb
        };
        let [left, right] = &scene.sides;
        let largest = left.inverse_mass.max(right.inverse_mass);
        let Form { spring, damper, .. } = contact.form;
        let [value, slope] = &mut pressed.ground;
        for (number, of_scene) in [
            (&mut pressed.largest_inverse_mass, largest),
            (&mut pressed.gap, scene.gap),
            (&mut pressed.form.spring.coefficient, spring.coefficient),
            (&mut pressed.form.damper.coefficient, damper.coefficient),
            (&mut pressed.speed, contact.speed),
            (value, ahead.value - ahead.slope * since),
            (slope, ahead.slope),
            (&mut self.start, since),
            (&mut self.here.s, contact.s),
            (&mut self.here.state[4], contact.impulse),
            (&mut self.step, contact.step),
            (&mut self.end, (since + ahead.length).sqrt().sqrt()),
            (&mut self.tolerance, scene.tolerance),
            (&mut self.used, 1.0),
            (&mut self.tried, 0.0),
            (&mut self.climb, climb),
            (&mut self.peak_force, scene.tally.peak_force),
        ] {
            number.set(lane, of_scene);
        }
    }

    /// Looks at where lanes are, after scenes were taken in.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        self.here = self.pressed.at(self.here.s, self.here.state);
    }

    /// Gives a scene what became of it in a lane, which is free then.
    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, scene: &mut Scene, contact: &mut Contact) {
        self.used.set(lane, 0.0);
        for (index, side) in scene.sides.iter_mut().enumerate() {
            side.displacement = self.here.state[2 * index].lane(lane);
            side.velocity = self.here.state[2 * index + 1].lane(lane);
            side.extremes = [0, 1].map(|end: usize| self.extremes[index][end].lane(lane));
        }
        contact.s = self.here.s.lane(lane);
        contact.step = self.step.lane(lane);
        contact.climb = self.climb.lane(lane);
        contact.impulse = self.here.state[4].lane(lane);
        scene.tally.peak_force = self.peak_force.lane(lane);
    }

    /// Time since a scene came into a lane \[s\].
    #[inline(always)]
    pub(super) fn passed(&self, lane: usize) -> f64 {
        fourth_power(self.here.s.lane(lane)) - self.start.lane(lane)
    }

    /// Tries a step in every lane, each of its own length.
    #[inline(always)]
    pub(super) fn advance(&mut self) -> Ends<S> {
        let step = self.step;
        let like = |number: f64| step.like(number);
        let rest = self.end - self.here.s;
        let reached = self.reach(step.min(rest).max(like(0.0)));
        let Reached { length, next, .. } = reached;
        let error = reached.error / self.tolerance;
        let used = self.used.exceeds(like(0.0));
        self.tried = self.tried + like(1.0);
        let sound = like(f64::INFINITY).exceeds((next.state[1] + next.state[3]).abs());
        let sound = sound & !error.differs(error);
        let broken = used & (self.tried.exceeds(like(MOST_STEPS)) | !sound);
        let taken = used & sound & like(1.0).reaches(error);
        self.follow(&reached, taken);
        // Roots of order 4 and 8 on purpose: shrinks more than order 5 asks for, and grows less.
        let root = error.sqrt().sqrt();
        let shrunk = length * (like(0.9) / root).max(like(LEAST_SHRINK));
        let grown = length * (like(0.9) / root.sqrt()).min(like(MOST_GROWTH));
        let cut = step.exceeds(length);
        let grown = Number::select(cut, step.max(grown), grown);
        self.step = Number::select(taken, grown, shrunk);
        self.here.s = Number::select(taken, next.s, self.here.s);
        for index in 0..next.state.len() {
            let [state, slope] = [next.state[index], next.slope[index]];
            self.here.state[index] = Number::select(taken, state, self.here.state[index]);
            self.here.slope[index] = Number::select(taken, slope, self.here.slope[index]);
        }
        let parted = taken & reached.parts;
        Ends {
            ended: parted | broken | (taken & length.reaches(rest)),
            parted,
            broken,
        }
    }

    /// A step, no longer than to where the force bends sharply or neighbours part.
    #[inline(always)]
    fn reach(&self, step: Lanes<S>) -> Reached<S> {
        let (pressed, here) = (&self.pressed, &self.here);
        let [zero, one] = [0.0, 1.0].map(|number| step.like(number));
        let probe = step * step.like(PROBE);
        let used = self.used.exceeds(zero);
        let mut stepped = pressed.step(here, step);
        let mut length = self.before_a_dip(&stepped, step);
        if Lanes::any(step.exceeds(length)) {
            stepped = pressed.step(here, length);
        }
        let mut next = stepped.next;
        let mut found = [Mask::splat(step.token(), false); 2];
        let mut too_long = found[0];
        for (corner, found) in [Corner::Bend, Corner::Parting].into_iter().zip(&mut found) {
            // What would bend behind a parting bends nothing.
            let mut passed = match corner {
                Corner::Bend => {
                    let before = pressed.side_behind(corner, here, probe);
                    used & zero.exceeds(before * pressed.side_of(corner, &next.state))
                }
                Corner::Parting => used & pressed.parts(here, &next),
            };
            if corner == Corner::Parting {
                // The first step went through the whole contact.
                too_long = passed & !here.s.exceeds(zero);
                passed = passed & !too_long;
            }
            if !Lanes::any(passed) {
                continue;
            }
            let way = stepped.way(here, length);
            let before = pressed.side_behind(corner, here, probe);
            let after = pressed.side_of(corner, &stepped.next.state);
            let sign = Number::select(zero.exceeds(before), one, zero - one);
            let number = |part| sign * pressed.side_of(corner, &way.at(part));
            let part = rise(passed, [sign * before, sign * after], FINELY, number);
            length = Number::select(passed, part * length, length);
            stepped = pressed.step(here, length);
            let (settled, close) = self.settle(corner, &stepped.next, length);
            if corner == Corner::Parting {
                // A polynomial too coarse to say where they part.
                too_long = too_long | (passed & !close);
            }
            next.s = Number::select(passed, settled.s, next.s);
            for index in 0..next.state.len() {
                let [state, slope] = [settled.state[index], settled.slope[index]];
                next.state[index] = Number::select(passed, state, next.state[index]);
                next.slope[index] = Number::select(passed, slope, next.slope[index]);
            }
            *found = passed;
        }
        let error = Number::select(too_long, step.like(f64::INFINITY), stepped.error);
        let [bends, parts] = found;
        Reached {
            stepped,
            length,
            next,
            error,
            bends,
            parts,
        }
    }

    /// A step shortened to where neighbours that touch at both ends are farthest apart on the way, or where a force that is on one branch at
    /// both ends is farthest on the other: the corners on both sides of that would be missed.
    #[inline(always)]
    fn before_a_dip(&self, stepped: &Stepped<Lanes<S>>, step: Lanes<S>) -> Lanes<S> {
        let (pressed, here, next) = (&self.pressed, &self.here, &stepped.next);
        let [zero, one, probe] = [0.0, 1.0, PROBE].map(|number| step.like(number));
        let mut length = step;
        for corner in [Corner::Parting, Corner::Bend] {
            let value = |state: &_| pressed.side_of(corner, state);
            let before = pressed.side_behind(corner, here, probe * step);
            let after = value(&next.state);
            let near = match corner {
                // After a turn of the deformation the rate is rounding.
                Corner::Parting => (step.like(FLAT) * pressed.speed).exceeds(rate(&here.state)),
                Corner::Bend => step.like(NEAR).exceeds(before.abs().min(after.abs())),
            };
            let same = self.used.exceeds(zero) & near & (before * after).exceeds(zero);
            if !Lanes::any(same) {
                continue;
            }
            let sign = Number::select(zero.exceeds(before), zero - one, one);
            let starts = sign * (value(&here.moved(probe * step)) - value(&here.state));
            let starts = match corner {
                Corner::Parting => starts.min(step.like(-f64::MIN_POSITIVE)),
                Corner::Bend => starts,
            };
            let ends = sign * (after - value(&next.moved(zero - probe * step)));
            let turns = same & zero.exceeds(starts) & ends.exceeds(zero);
            if !Lanes::any(turns) {
                continue;
            }
            let way = stepped.way(here, step);
            let climbs = |part: Lanes<S>| {
                let [before, after] = [part - probe, part + probe];
                sign * (value(&way.at(after)) - value(&way.at(before)))
            };
            let part = rise(turns, [starts, ends], ROUGHLY, climbs);
            let dips = turns & zero.exceeds(sign * value(&way.at(part)));
            length = Number::select(dips, length.min(part * step), length);
        }
        length
    }

    /// A point near a corner brought to it on a line, and where it was near enough for that.
    #[inline(always)]
    fn settle(
        &self,
        corner: Corner,
        near: &Point<Lanes<S>>,
        length: Lanes<S>,
    ) -> (Point<Lanes<S>>, Mask<S>) {
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
