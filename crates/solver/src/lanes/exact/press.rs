//! Compliant contact of two neighbours: Dormand and Prince's method of order 5 with error control.
//!
//! Just after a touch forces are powers of δ like 1/4, which no step in time follows well. Steps are taken in s with s⁴ the time
//! since the touch, in which they are smooth.

use pounding_contact::Form;

use super::Interval;
use super::pair::{GivenUp, Scene};
use super::pressed::{Ahead, Point, Pressed, ROUGHLY, fourth_power};

/// Steps of a contact between two samples; no scene that was looked at needs a tenth.
const MOST_STEPS: usize = 10_000;
/// First step in s \[s^¼\]: a thousandth of the time of a stiff contact.
const FIRST_STEP: f64 = 0.02;
/// A step shrinks to this part at least, and grows by no more than this.
const LEAST_SHRINK: f64 = 0.2;
const MOST_GROWTH: f64 = 4.0;

/// A compliant contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    form: Form,
    /// Approach rate at the touch \[m/s\].
    speed: f64,
    /// Fourth root of the time since the touch \[s^¼\], and the next step in it.
    s: f64,
    step: f64,
    /// \[N·s\].
    pub(super) impulse: f64,
}

impl Contact {
    pub(super) fn new(form: Form, speed: f64) -> Self {
        Self {
            form,
            speed,
            s: 0.0,
            step: FIRST_STEP,
            impulse: 0.0,
        }
    }
}

impl Scene {
    /// Goes on in contact to the end of the interval, or to the parting: then it returns how long that takes \[s\].
    pub(super) fn press(
        &mut self,
        contact: &mut Contact,
        ahead: &Interval,
    ) -> Result<Option<f64>, GivenUp> {
        let since = fourth_power(contact.s);
        let end = (since + ahead.length).sqrt().sqrt();
        let pressed = Pressed {
            sides: self.sides,
            gap: self.gap,
            form: contact.form,
            speed: contact.speed,
            ground: *ahead,
            since,
        };
        let [left, right] = &self.sides;
        let state = [
            left.displacement,
            left.velocity,
            right.displacement,
            right.velocity,
            contact.impulse,
        ];
        let mut here = pressed.at(contact.s, state);
        for _ in 0..MOST_STEPS {
            let rest = end - here.s;
            let Ahead {
                next,
                step,
                error,
                parts,
            } = pressed.ahead(&here, contact.step.min(rest));
            let error = error / self.tolerance;
            if error.is_nan() {
                return Err(GivenUp);
            }
            if error > 1.0 {
                // Roots of order 4 here and 8 below on purpose: shrinks more than order 5 asks for, and grows less.
                contact.step = step * (0.9 / error.sqrt().sqrt()).max(LEAST_SHRINK);
                continue;
            }
            let growth = 0.9 / error.sqrt().sqrt().sqrt();
            let grown = step * growth.min(MOST_GROWTH);
            contact.step = if step < contact.step {
                contact.step.max(grown)
            } else {
                grown
            };
            self.follow(&pressed, (&here, &next));
            here = next;
            [contact.s, contact.impulse] = [here.s, here.state[4]];
            if parts {
                return Ok(Some(fourth_power(here.s) - since));
            }
            if step >= rest {
                return Ok(None);
            }
        }
        Err(GivenUp)
    }

    /// Takes a step in contact, with what is largest on the way.
    fn follow(&mut self, pressed: &Pressed, (here, next): (&Point, &Point)) {
        let ends = (here, next);
        let approaches = here.rate() > 0.0;
        let climb = |point: &Point| pressed.climb(point, approaches);
        if climb(here) > 0.0 && climb(next) <= 0.0 {
            let top = pressed.rise(ends, ROUGHLY, |point| -climb(point));
            let (top, _) = pressed.step(here, top);
            self.tally.peak_force = self.tally.peak_force.max(pressed.force(&top.state));
        }
        self.tally.peak_force = self.tally.peak_force.max(pressed.force(&next.state));
        for index in 0..2 {
            let velocity = |point: &Point| point.state[2 * index + 1];
            if velocity(here) * velocity(next) < 0.0 {
                let onward = velocity(here).signum();
                let turn = pressed.rise(ends, ROUGHLY, |point| -onward * velocity(point));
                let (turn, _) = pressed.step(here, turn);
                self.sides[index].reach(turn.state[2 * index]);
            }
            let side = &mut self.sides[index];
            [side.displacement, side.velocity] = [next.state[2 * index], velocity(next)];
            side.reach(side.displacement);
        }
    }
}
