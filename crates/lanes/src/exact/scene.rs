//! An interval in which a scene may touch or turn, from event to event.

use pounding_contact::{Action, Form};

use super::Interval;
use super::pair::{Bounces, Link, Opening, PressedContact, Scene, Side, Stage};
use super::rises::{first_turn, highest, rise_bound};
use pounding_solver::formulas::{CAPACITY, quick_first_root, value_and_slope};
use pounding_solver::formulas::{Expansion, value};

/// Most events of a scene between two samples. With more, bounces may not end, and the scene needs a run alone.
const MOST_EVENTS: usize = 1000;

/// A deformation below this part of the displacements is stored as a separate number, because their difference has lost its digits.
const CARRIED: f64 = 1e-3;
/// Part of an interval that counts as no rest of it.
const NOTHING: f64 = 1e-15;

/// Event that ends a piece of free flight.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Event {
    Sample,
    Touch,
    /// The velocity of this side is zero.
    Turn(usize),
}

/// A piece of free flight.
struct Flown {
    /// Duration \[s\].
    length: f64,
    event: Event,
    /// Deformation of the pair at the end \[m\], and its rate \[m/s\].
    deformation: f64,
    rate: f64,
}

impl Scene {
    /// Begins an interval that the scene runs alone.
    pub(super) fn set_out(&mut self) {
        (self.stage, self.at, self.events) = (Stage::OnTheWay, 0.0, 0);
        self.bounces = Bounces::default();
    }

    /// Advances to the sample or to compliant contact.
    pub(super) fn go_on(&mut self, interval: &Interval) {
        while self.stage == Stage::OnTheWay {
            let ahead = interval.after(self.at);
            match self.link {
                Link::Pressed(_) => {
                    // A touch at the sample belongs to the next interval.
                    if self.at >= interval.length {
                        self.arrive();
                    }
                    return;
                }
                Link::Apart => self.fly_on(&ahead, None),
                Link::Parting(opening) => self.fly_on(&ahead, Some(opening)),
                // Rounding put the end of a rest before the sample: the next interval decides.
                Link::Closed { .. } if ahead.length <= NOTHING * interval.length => {
                    self.at = interval.length;
                    self.arrive();
                }
                Link::Closed { is_struck } => self.settle(&ahead, is_struck),
                Link::Resting { zero_orders } => self.rest_on(&ahead, zero_orders),
            }
            self.count();
        }
    }

    /// Flies to the next event, from an opening gap or from apart.
    fn fly_on(&mut self, ahead: &Interval, opening: Option<Opening>) {
        let Flown {
            length,
            event,
            deformation,
            rate,
        } = self.fly(ahead, opening);
        self.at += length;
        let far = self.sides.iter().map(|side| side.displacement.abs());
        let near = -deformation < CARRIED * far.sum::<f64>();
        self.link = match opening {
            Some(_) if near => Link::Parting(Opening::At(deformation, rate)),
            _ => Link::Apart,
        };
        match event {
            Event::Sample => self.arrive(),
            Event::Turn(side) => self.sides[side].velocity = 0.0,
            Event::Touch => self.touch(rate, ahead.value + ahead.slope * length),
        }
    }

    /// Marks the scene as arrived at the end of the interval.
    pub(super) fn arrive(&mut self) {
        self.stage = Stage::Arrived;
    }

    /// Ends a compliant contact, `passed` seconds after it was resumed.
    pub(super) fn part(&mut self, contact: &PressedContact, passed: f64, interval: &Interval) {
        self.at = (self.at + passed).min(interval.length);
        self.tally.impulse += contact.impulse;
        self.tally.largest_impulse = self.tally.largest_impulse.max(contact.impulse);
        let (_, rate) = self.closing();
        self.link = Link::Parting(Opening::At(0.0, rate));
        self.count();
    }

    /// Gives the scene up: it needs a run alone.
    pub(super) fn give_up(&mut self) {
        self.stage = Stage::GivenUp;
    }

    /// Branches of its law: scenes in contact share lanes if these are equal.
    pub(super) fn branches(&self) -> Option<[u64; 3]> {
        let Link::Pressed(PressedContact { form, .. }) = self.link else {
            return None;
        };
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

    /// Flies to the next event.
    fn fly(&mut self, ahead: &Interval, opening: Option<Opening>) -> Flown {
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
        match opening {
            None => deformation[0] -= self.gap,
            Some(Opening::At(now, rate)) => deformation[..2].copy_from_slice(&[now, rate]),
            Some(Opening::Order(order)) => deformation[..order].fill(0.0),
        }
        if let Some(touch) = quick_first_root(deformation, length) {
            (length, event) = (touch, Event::Touch);
        }
        for (index, (side, room)) in self.sides.iter().zip(&rooms).enumerate() {
            let series = [room.displacement(side.len), room.velocity(side.len)];
            if let Some(turn) = side.turn(series, length) {
                (length, event) = (turn, Event::Turn(index));
            }
        }
        for (side, room) in self.sides.iter_mut().zip(&rooms) {
            side.displacement = value(room.displacement(side.len), length);
            side.velocity = value(room.velocity(side.len), length);
            side.reach(side.displacement);
        }
        if let Some(closing) = &mut self.tally.closing {
            *closing = self.gap + highest(deformation, length, *closing - self.gap);
        }
        let (deformation, rate) = value_and_slope(deformation, length);
        Flown {
            length,
            event,
            deformation,
            rate,
        }
    }

    /// The pair touches at a rate \[m/s\], under this ground acceleration \[m/s²\]: an impact, or the start of compliant contact.
    fn touch(&mut self, rate: f64, ground: f64) {
        if rate <= 0.0 {
            self.give_up();
        } else if let Some(law) = self.law.impulsive() {
            self.strike(rate, law.restitution, ground);
        } else if let Some(form) = self.law.form(self.reduced_mass, rate) {
            self.begin(form, rate);
        } else {
            self.give_up();
        }
    }

    fn begin(&mut self, form: Form, rate: f64) {
        self.tally.collisions += 1.0;
        self.tally.peak_force = self.tally.peak_force.max(form.force(0.0, rate));
        self.link = Link::Pressed(PressedContact::new(form, rate));
    }
}

impl Side {
    /// First instant of a turn; `None` if the motion cannot exceed its extremes within a length. The first coefficient of the displacement
    /// is not used.
    pub(super) fn turn(&self, [displacement, rates]: [&[f64]; 2], length: f64) -> Option<f64> {
        let farther = |sign: f64| sign * self.displacement + rise_bound(displacement, sign, length);
        let [least, largest] = self.extremes;
        if farther(1.0) <= largest && farther(-1.0) <= -least {
            return None;
        }
        first_turn(rates, length)
    }
}

impl Interval {
    /// The rest of the interval after a time \[s\].
    pub(super) fn after(&self, at: f64) -> Self {
        Self {
            length: self.length - at,
            value: self.value + self.slope * at,
            ..*self
        }
    }
}
