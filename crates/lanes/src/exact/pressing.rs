//! Steps in compliant contact in lanes, with their error under control.

mod follow;
mod reach;
mod turns;

use fearless_simd::Simd;
use pounding_contact::{Form, Number, Term};

use super::Interval;
use super::contact::Contact;
use super::pair::Scene;
use super::pressed::{Half, Point, Pressed, fourth_power};
use crate::number::{Lanes, Mask};
use reach::Reached;

/// Steps of a contact between two samples; no scene that was looked at needs a tenth.
const MOST_STEPS: f64 = 10_000.0;
/// A step shrinks to this part at least, and grows by no more than this.
const LEAST_SHRINK: f64 = 0.2;
const MOST_GROWTH: f64 = 4.0;

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
    /// How far they have come towards each other \[m\]; nothing where nobody asks.
    closing: Option<Lanes<S>>,
}

/// What became of lanes in a step.
pub(super) struct Ends<S: Simd> {
    /// Does not go on: parted, broken, or at the end of the interval.
    pub(super) ended: Mask<S>,
    pub(super) parted: Mask<S>,
    /// No numbers, or no end of steps.
    pub(super) broken: Mask<S>,
}

impl<S: Simd> Pressing<S> {
    /// Lanes for contacts by laws of the same powers as that of a scene, which is asked for the same.
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
            closing: scene.tally.closing.map(|_| zero),
        }
    }

    /// Takes a scene in contact into a lane.
    #[inline(always)]
    pub(super) fn take(&mut self, lane: usize, scene: &Scene, contact: &Contact, interval: &Interval) {
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
        scene.tally.closing = self.closing.map(|closing| closing.lane(lane));
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
        // Roots of order 4 and 8 on purpose: shrinks more than order 5 asks for, and grows less.
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
