//! Steps in compliant contact in lanes, with error control.

mod follow;
mod reach;
mod turns;

use fearless_simd::Simd;
use pounding_contact::{Form, Number, Term};

use super::Interval;
use super::pair::{PressedContact, Scene};
use super::pressed::{Half, Pressed, PressedPoint, fourth_power};
use crate::number::{Lanes, Mask};
use reach::Reached;

/// Most steps of a contact between two samples; no examined scene needs a tenth.
const MOST_STEPS: f64 = 10_000.0;
/// Largest shrink and largest growth of a step.
const LEAST_SHRINK: f64 = 0.2;
const MOST_GROWTH: f64 = 4.0;

/// Contacts in lanes.
pub(super) struct Pressing<S: Simd> {
    pressed: Pressed<Lanes<S>>,
    here: PressedPoint<Lanes<S>>,
    /// Time since the touch at which the scene came \[s\].
    start: Lanes<S>,
    /// Next step, and end of the interval, in s.
    step: Lanes<S>,
    end: Lanes<S>,
    tolerance: Lanes<S>,
    /// 1 in lanes with a scene, else 0.
    used: Lanes<S>,
    /// Number of trial steps.
    tried: Lanes<S>,
    /// Rate of the force \[N/s\]; NaN just after a touch or a bend, or after a jump of the ground's acceleration.
    climb: Lanes<S>,
    peak_force: Lanes<S>,
    /// Smallest and largest displacements of both sides.
    extremes: [[Lanes<S>; 2]; 2],
    /// How far neighbours have come towards each other \[m\]; `None` if not requested.
    closing: Option<Lanes<S>>,
}

/// Results of lanes in a step.
pub(super) struct Ends<S: Simd> {
    /// Lanes that stop: parted, broken, or at the end of the interval.
    pub(super) ended: Mask<S>,
    pub(super) parted: Mask<S>,
    /// Lanes with NaN, or with too many steps.
    pub(super) broken: Mask<S>,
}

impl<S: Simd> Pressing<S> {
    /// Lanes for contacts whose laws have the powers of this scene's law. Closings are recorded if the scene requests them.
    #[inline(always)]
    pub(super) fn new(simd: S, form: &Form, scene: &Scene) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let half = Half {
            inverse_mass: zero,
            damping: zero,
            stiffness: zero,
            mobile: zero,
        };
        let term = |power| Term { coefficient: zero, power };
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
                    second: None,
                },
                speed: zero,
                ground: [zero; 2],
            },
            here: PressedPoint {
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
            closing: scene.tally.closing.map(|_| zero),
        }
    }

    /// Copies a scene in contact to a lane.
    #[inline(always)]
    pub(super) fn take(&mut self, lane: usize, scene: &Scene, contact: &PressedContact, interval: &Interval) {
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
        let climb = if interval.jumps { f64::NAN } else { contact.climb };
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
        if let Some((lanes, closing)) = self.closing.as_mut().zip(scene.tally.closing) {
            lanes.set(lane, closing);
        }
    }

    /// Evaluates the state of lanes after scenes were copied to them.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        self.here = self.pressed.at(self.here.s, self.here.state);
    }

    /// Copies the results of a lane to its scene; the lane is then free.
    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, scene: &mut Scene, contact: &mut PressedContact) {
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
        scene.tally.closing = self.closing.map(|closing| closing.lane(lane));
    }

    /// Time since a scene came to a lane \[s\].
    #[inline(always)]
    pub(super) fn passed(&self, lane: usize) -> f64 {
        fourth_power(self.here.s.lane(lane)) - self.start.lane(lane)
    }

    /// Tries a step in every lane, each of a separate length.
    #[inline(always)]
    pub(super) fn advance(&mut self) -> Ends<S> {
        let step = self.step;
        let like = |number: f64| step.like(number);
        let rest = self.end - self.here.s;
        let mut reached = self.reach(step.min(rest).max(like(0.0)));
        let force = self.force_at(&reached);
        self.stop_between_turns(force, &mut reached);
        let Reached { length, next, .. } = reached;
        let error = reached.error() / self.tolerance;
        let used = self.used.exceeds(like(0.0));
        self.tried = self.tried + like(1.0);
        let sound = like(f64::INFINITY).exceeds((next.state[1] + next.state[3]).abs());
        let sound = sound & !error.differs(error);
        let broken = used & (self.tried.exceeds(like(MOST_STEPS)) | !sound);
        let taken = used & sound & like(1.0).reaches(error);
        self.follow(&reached, force, taken);
        // Roots of order 4 and 8 on purpose: they shrink more than order 5 demands, and grow less.
        let root = error.sqrt().sqrt();
        let shrunk = length * (like(0.9) / root).max(like(LEAST_SHRINK));
        let shrunk = Number::select(reached.again, length, shrunk);
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
}
