//! An interval in which a scene may touch or turn, from event to event.

use pounding_contact::Action;

use super::Interval;
use super::contact::Contact;
use super::pair::{GivenUp, Scene, Stage};
use crate::roots::{CAPACITY, quick_first_root};
use crate::span::{Expansion, value};

/// Events of a scene between two samples; with more of them bounces come to rest.
const MOST_EVENTS: usize = 64;
/// Rate after an impact, relative to the velocities, below which a pair does not part.
const SLOWEST_PARTING: f64 = 1e-9;

/// What ends a piece of free flight.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Event {
    Sample,
    Touch,
    /// The velocity of this side is zero.
    Turn(usize),
}

impl Scene {
    /// Begins an interval in which the scene goes alone.
    pub(super) fn set_out(&mut self) {
        (self.stage, self.at, self.events) = (Stage::OnTheWay, 0.0, 0);
    }

    /// Flies on, to the sample or into compliant contact.
    pub(super) fn fly_on(&mut self, interval: &Interval) {
        while self.stage == Stage::OnTheWay && self.contact.is_none() {
            let (length, event) = self.fly(&interval.after(self.at));
            self.at += length;
            match event {
                Event::Sample => self.arrive(None),
                Event::Turn(side) => self.sides[side].velocity = 0.0,
                Event::Touch => {
                    if self.touch().is_err() {
                        self.give_up();
                    } else if self.contact.is_some() && self.at >= interval.length {
                        let contact = self.contact.take();
                        self.arrive(contact);
                    }
                }
            }
            self.count();
        }
    }

    /// The end of the interval, in compliant contact or not.
    pub(super) fn arrive(&mut self, contact: Option<Contact>) {
        (self.stage, self.contact) = (Stage::Arrived, contact);
    }

    /// The end of a compliant contact, some time after \[s\] it was gone on with.
    pub(super) fn part(&mut self, contact: &Contact, passed: f64, interval: &Interval) {
        self.at = (self.at + passed).min(interval.length);
        self.tally.impulse += contact.impulse;
        self.parts = true;
        self.count();
    }

    /// Only a run of the scene alone can say what happens.
    pub(super) fn give_up(&mut self) {
        self.stage = Stage::GivenUp;
    }

    /// What its law branches on: scenes in contact at once go side by side where this is the same.
    pub(super) fn branches(&self) -> Option<[u64; 3]> {
        let form = self.contact.as_ref()?.form;
        let powers = [form.spring.power, form.damper.power].map(|power| power.value().to_bits());
        let approach = u64::from(form.action == Action::Approach);
        Some([powers[0], powers[1], approach])
    }

    fn count(&mut self) {
        self.events += 1;
        if self.events > MOST_EVENTS && self.stage == Stage::OnTheWay {
            self.give_up();
        }
    }

    /// Flies to the next event; returns how long that takes \[s\].
    fn fly(&mut self, ahead: &Interval) -> (f64, Event) {
        let mut rooms = [Expansion::default(), Expansion::default()];
        for (side, room) in self.sides.iter().zip(&mut rooms) {
            side.expand([ahead.value, ahead.slope], room);
        }
        let lens = [self.sides[0].len, self.sides[1].len];
        let mut series = [0.0; CAPACITY];
        let (mut length, mut event) = (ahead.length, Event::Sample);
        let deformation = &mut series[..lens[0].max(lens[1])];
        for (side, sign) in [(0, 1.0), (1, -1.0)] {
            let coefficients = rooms[side].displacement(lens[side]);
            for (sum, coefficient) in deformation.iter_mut().zip(coefficients) {
                *sum += sign * coefficient;
            }
        }
        // A pair that parts is at zero, which displacements know to rounding only.
        deformation[0] = if self.parts {
            0.0
        } else {
            deformation[0] - self.gap
        };
        if let Some(touch) = quick_first_root(deformation, length) {
            (length, event) = (touch, Event::Touch);
        }
        for (index, (side, room)) in self.sides.iter().zip(&rooms).enumerate() {
            let rates = room.velocity(side.len);
            let Some(first) = rates.iter().find(|rate| **rate != 0.0) else {
                continue;
            };
            let displacements = room.displacement(side.len);
            let [least, largest] = side.extremes;
            let farther = bound(displacements, 1.0, length) > largest
                || bound(displacements, -1.0, length) > -least;
            if !farther {
                continue;
            }
            let falling = &mut series[..side.len];
            for (rate, coefficient) in falling.iter_mut().zip(rates) {
                *rate = -first.signum() * coefficient;
            }
            if let Some(turn) = quick_first_root(falling, length) {
                (length, event) = (turn, Event::Turn(index));
            }
        }
        for (side, room) in self.sides.iter_mut().zip(&rooms) {
            side.displacement = value(room.displacement(side.len), length);
            side.velocity = value(room.velocity(side.len), length);
            side.reach(side.displacement);
        }
        self.parts = false;
        (length, event)
    }
}

/// What a polynomial, times this sign, does not exceed from 0 to x.
fn bound(coefficients: &[f64], sign: f64, x: f64) -> f64 {
    let sum = |sum: f64, coefficient: &f64| sum * x + (sign * coefficient).max(0.0);
    let [start, rest @ ..] = coefficients else {
        return 0.0;
    };
    sign * start + x * rest.iter().rev().fold(0.0, sum)
}

impl Scene {
    /// The pair meets: an impact, or the beginning of compliant contact.
    fn touch(&mut self) -> Result<(), GivenUp> {
        let (_, rate) = self.closing();
        let [left, right] = &mut self.sides;
        if rate <= 0.0 {
            return Err(GivenUp);
        }
        let Some(law) = self.law.impulsive() else {
            self.begin(rate)?;
            return Ok(());
        };
        let impulse = (1.0 + law.restitution) * self.reduced_mass * rate;
        let speed = left.velocity.abs() + right.velocity.abs();
        left.velocity -= left.inverse_mass * impulse;
        right.velocity += right.inverse_mass * impulse;
        self.tally.collisions += 1.0;
        self.tally.impulse += impulse;
        self.parts = true;
        if right.velocity - left.velocity > SLOWEST_PARTING * speed {
            Ok(())
        } else {
            Err(GivenUp)
        }
    }

    fn begin(&mut self, rate: f64) -> Result<(), GivenUp> {
        let form = self.law.form(self.reduced_mass, rate).ok_or(GivenUp)?;
        self.tally.collisions += 1.0;
        self.tally.peak_force = self.tally.peak_force.max(form.force(0.0, rate));
        self.contact = Some(Contact::new(form, rate));
        Ok(())
    }
}

impl Interval {
    /// What is left of it after a time \[s\].
    pub(super) fn after(&self, at: f64) -> Self {
        Self {
            length: self.length - at,
            value: self.value + self.slope * at,
            ..*self
        }
    }
}
