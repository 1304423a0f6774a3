//! How the ground shakes under a row, and what that does to the pairs whose grounds move apart.

use crate::exact::clock::{LocalClock, Past};
use crate::exact::contact::Contact;
use crate::model::excitation::Segment;
use crate::{Excitation, Motion, Travel};

/// The ground motion, and how it travels along the row.
pub(super) struct Shaking<'a> {
    pub(super) excitation: Excitation<'a>,
    /// Nothing where it arrives everywhere at t = 0.
    pub(super) travel: Option<Travel>,
    /// The piece that was last asked for.
    last: Asked,
}

/// A piece of the ground motion, and what was asked.
struct Asked {
    /// On a clock that shows 0 at this instant \[s\],
    zero: f64,
    /// from this time on \[s\],
    time: f64,
    /// of a ground motion that arrives then \[s\].
    arrival: f64,
    segment: Segment,
}

impl<'a> Shaking<'a> {
    pub(super) fn new(excitation: Excitation<'a>, travel: Option<Travel>) -> Self {
        Self {
            excitation,
            travel,
            last: Asked {
                zero: 0.0,
                time: 0.0,
                arrival: 0.0,
                segment: excitation.segment(0.0, 0.0),
            },
        }
    }

    /// The ground motion from an instant on, of some arrival.
    pub(super) fn segment(&mut self, clock: LocalClock, time: f64, arrival: f64) -> Segment {
        let zero = clock.zero();
        let last = &self.last;
        let asked = [last.zero, last.time, last.arrival].map(f64::to_bits);
        if asked != [zero, time, arrival].map(f64::to_bits) {
            let segment = self.excitation.segment_on_clock(zero, time, arrival);
            self.last = Asked {
                zero,
                time,
                arrival,
                segment,
            };
        }
        self.last.segment
    }

    /// How far the grounds of a pair have moved towards each other, and at which rate; nothing where they move alike.
    pub(super) fn opening(&self, contact: &Contact, now: Past) -> Option<Motion> {
        let travel = self.travel.as_ref().filter(|_| contact.opens())?;
        Some(travel.opening_at(contact.floors(), now.instant()))
    }

    /// Second coefficient of that opening, as a series in time, twice: its acceleration \[m/s²\].
    pub(super) fn opening_acceleration(&self, contact: &Contact, now: Past) -> Option<f64> {
        let travel = self.travel.as_ref().filter(|_| contact.opens())?;
        Some(2.0 * travel.cubic_opening(contact.floors(), now.instant())[2])
    }
}
