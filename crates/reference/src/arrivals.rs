//! The segments of a run: between instants at which a sample of the record arrives at some structure.

use pounding_solver::Excitation;

use super::model::{displacement, velocity};
use super::motion::Segment;
use super::state::State;

/// Part of the interval between samples below which two instants are one: quotients of decimal numbers miss a whole number
/// by a rounding, and no segment is made for that.
const SAME: f64 = 1e-9;

/// An instant \[s\], and what its rounding left: ground accelerations are integrated twice to what grounds move against each other, and a
/// sample that comes 1e-15 s late would be 1e-12 of that.
#[derive(Debug, Clone, Copy)]
struct Instant {
    time: f64,
    rest: f64,
}

impl Instant {
    /// When a sample arrives.
    fn of(sample: f64, interval: f64, arrival: f64) -> Self {
        let product = sample * interval;
        let time = product + arrival;
        let taken = time - product;
        let lost = (product - (time - taken)) + (arrival - taken);
        Self {
            time,
            rest: lost + sample.mul_add(interval, -product),
        }
    }

    fn since(self, earlier: Self) -> f64 {
        (self.time - earlier.time) + (self.rest - earlier.rest)
    }
}

/// The segments of a run, in the order of time.
pub(super) struct Segments<'a> {
    excitation: Excitation<'a>,
    /// Arrival at every structure \[s\].
    arrivals: Vec<f64>,
    /// Instants at which a sample arrives somewhere, and the end of the run.
    instants: Vec<Instant>,
    next: usize,
    /// Where the ground under every structure has moved by then, and how fast it moves.
    moved: State,
}

impl<'a> Segments<'a> {
    pub(super) fn new(excitation: Excitation<'a>, arrivals: Vec<f64>, duration: f64) -> Self {
        let interval = excitation.time_step();
        let mut different = arrivals.clone();
        different.push(0.0);
        different.sort_by(f64::total_cmp);
        different.dedup();
        let mut instants = Vec::new();
        for arrival in different {
            let samples =
                (0..).map(|sample: u32| Instant::of(f64::from(sample), interval, arrival));
            instants.extend(samples.take_while(|one| duration - one.time > SAME * interval));
        }
        instants.sort_by(|one, other| one.since(*other).total_cmp(&0.0));
        instants.dedup_by(|later, earlier| later.since(*earlier) <= SAME * interval);
        instants.push(Instant {
            time: duration,
            rest: 0.0,
        });
        Self {
            // As many unknowns as come before the displacement of one more.
            moved: State::zero(displacement(arrivals.len())),
            excitation,
            arrivals,
            instants,
            next: 0,
        }
    }

    /// Acceleration of the ground at an instant, and its rate, where the motion arrives at some time.
    fn ground(&self, now: Instant, arrival: f64) -> (f64, f64) {
        let interval = self.excitation.time_step();
        let position = (now.time - arrival) / interval;
        let nearest = position.round();
        let whole = if (position - nearest).abs() <= SAME {
            nearest
        } else {
            position.floor()
        };
        if whole < 0.0 {
            return (0.0, 0.0);
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number >= 0; beyond the last sample nothing follows"
        )]
        let sample = self.excitation.samples().windows(2).nth(whole as usize);
        let ends = sample.map_or([0.0; 2], |pair| [pair[0], pair[1]]);
        let rate = (ends[1] - ends[0]) / interval;
        let since = now.since(Instant::of(whole, interval, arrival));
        (ends[0] + rate * since, rate)
    }
}

impl Iterator for Segments<'_> {
    type Item = Segment;

    fn next(&mut self) -> Option<Segment> {
        let &[start, end] = self.instants.get(self.next..self.next + 2)? else {
            return None;
        };
        self.next += 1;
        let arrivals = self.arrivals.iter();
        let grounds = arrivals.map(|arrival| self.ground(start, *arrival));
        let (grounds, length): (Vec<_>, _) = (grounds.collect(), end.since(start));
        let moved = self.moved.clone();
        for (index, (acceleration, rate)) in grounds.iter().enumerate() {
            let faster = length * (acceleration + length * (0.5 * rate));
            let further = length * (0.5 * acceleration + length * (rate / 6.0));
            let further = length * (moved.high[velocity(index)] + further);
            self.moved.add(&moved, displacement(index), further);
            self.moved.add(&moved, velocity(index), faster);
        }
        Some(Segment {
            start: start.time,
            length,
            grounds,
            moved,
        })
    }
}
