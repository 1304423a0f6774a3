//! The ground motion under a row, and its effect on pairs whose grounds move apart.

use crate::exact::clock::{LocalClock, Past};
use crate::exact::contact::PairState;
use crate::model::excitation::Segment;
use crate::{Excitation, Motion, Travel};

/// The ground motion, and how it travels along the row.
pub(super) struct Shaking<'a> {
    pub(super) excitation: Excitation<'a>,
    /// How the motion travels along the row; `None` if it arrives everywhere at t = 0.
    pub(super) travel: Option<Travel>,
    /// The last piece that was asked for.
    last: Asked,
}

/// A piece of the ground motion, with the arguments of the query.
struct Asked {
    /// Instant at which the clock shows 0 \[s\].
    zero: f64,
    /// Start of the piece on this clock \[s\].
    time: f64,
    /// Arrival of the ground motion \[s\].
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

    /// The piece of ground motion at an instant, for an arrival.
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

    /// How far the grounds of a pair have moved towards each other, and at which rate; `None` if they move alike.
    pub(super) fn opening(&self, contact: &PairState, now: Past) -> Option<Motion> {
        let travel = self.travel.as_ref().filter(|_| contact.opens())?;
        Some(travel.opening_at(contact.floors(), now.instant()))
    }

    /// Acceleration of the opening \[m/s²\]: twice its second coefficient as a series in time.
    pub(super) fn opening_acceleration(&self, contact: &PairState, now: Past) -> Option<f64> {
        let travel = self.travel.as_ref().filter(|_| contact.opens())?;
        Some(2.0 * travel.cubic_opening(contact.floors(), now.instant())[2])
    }
}
