//! The segments of a run: between instants at which a sample of the record arrives at some structure.

use pounding_solver::Excitation;

use super::motion::Segment;

/// Part of the interval between samples below which two instants are one: quotients of decimal numbers miss a whole number
/// by a rounding, and no segment is made for that.
const SAME: f64 = 1e-9;

/// The segments of a run, in the order of time.
pub(super) struct Segments<'a> {
    excitation: Excitation<'a>,
    /// Arrival at every structure \[s\].
    arrivals: Vec<f64>,
    /// Instants at which a sample arrives somewhere, and the end of the run.
    instants: Vec<f64>,
    duration: f64,
    next: usize,
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
            let mut sample = 0_u32;
            loop {
                let instant = f64::from(sample) * interval + arrival;
                if duration - instant <= SAME * interval {
                    break;
                }
                instants.push(instant);
                sample += 1;
            }
        }
        instants.sort_by(f64::total_cmp);
        instants.dedup_by(|later, earlier| *later - *earlier <= SAME * interval);
        instants.push(duration);
        Self {
            excitation,
            arrivals,
            instants,
            duration,
            next: 0,
        }
    }

    /// Acceleration of the ground at an instant, and its rate, where the motion arrives at some time.
    fn ground(&self, time: f64, arrival: f64) -> (f64, f64) {
        let interval = self.excitation.time_step();
        let position = (time - arrival) / interval;
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
        let since = if position > whole + SAME {
            time - (whole * interval + arrival)
        } else {
            0.0
        };
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
        let interval = self.excitation.time_step();
        let whole = end - start >= (1.0 - SAME) * interval;
        Some(Segment {
            start,
            // The difference of two instants has their rounding.
            length: if whole {
                interval.min(self.duration - start)
            } else {
                end - start
            },
            grounds: arrivals
                .map(|arrival| self.ground(start, *arrival))
                .collect(),
        })
    }
}
