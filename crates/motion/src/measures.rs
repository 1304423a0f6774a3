//! Measures of the strength of a ground motion.

use std::f64::consts::PI;

use crate::Record;
use crate::integration::Step;

/// Standard acceleration of gravity in the Arias intensity \[m/s²\].
const STANDARD_GRAVITY: f64 = 9.806_65;

/// Number of bisections of a time step that locate an instant to rounding.
const HALVINGS: u32 = 53;

/// Intensity measures of a ground motion that is linear between samples, exact to rounding.
///
/// Velocity and displacement are those of [`Record::integrated`], without correction of the baseline. A measure is infinite if its
/// integrand overflows 64-bit numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures {
    /// Peak ground acceleration, the largest magnitude \[m/s²\].
    pub pga: f64,
    /// Peak ground velocity, between samples too \[m/s\].
    pub pgv: f64,
    /// Peak ground displacement, between samples too \[m\].
    pub pgd: f64,
    /// Arias intensity π/(2g) ∫a² dt with g = 9.80665 m/s² \[m/s\] (A. Arias in *Seismic Design for Nuclear Power
    /// Plants*, MIT Press 1970, 438).
    pub arias: f64,
    /// Cumulative absolute velocity ∫|a| dt over the whole record, without threshold \[m/s\] (EPRI report NP-5930,
    /// 1988; the "standardised" one of 1991 leaves out seconds below 0.025 g).
    pub cav: f64,
    /// Interval in which the Arias intensity grows from 5 % to 75 % of its final value; `None` if that is zero or infinite.
    pub d5_75: Option<Interval>,
    /// Interval in which the Arias intensity grows from 5 % to 95 % (M. D. Trifunac and A. G. Brady, *Bull. Seism. Soc. Am.* 65 (1975)
    /// 581).
    pub d5_95: Option<Interval>,
    /// From the first to the last instant at [`Self::STRONG`]; `None` if the record never is (B. A. Bolt, *Proc. 5th World Conf. Earthq.
    /// Eng.* (1973) 1304).
    pub bracketed: Option<Interval>,
    /// Time at or above [`Self::STRONG`] \[s\], ≥ 0 (uniform duration, the same source).
    pub uniform: f64,
}

impl Measures {
    /// Acceleration from which motion counts as strong \[m/s²\]: 0.05 g.
    pub const STRONG: f64 = 0.05 * STANDARD_GRAVITY;
}

/// An interval of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Start \[s\].
    pub start: f64,
    /// End \[s\], not before the start.
    pub end: f64,
}

impl Interval {
    /// Returns the length of the interval \[s\], ≥ 0.
    pub fn duration(&self) -> f64 {
        self.end - self.start
    }
}

impl Record {
    /// Returns the intensity measures of the record.
    pub fn measures(&self) -> Measures {
        let time_step = self.time_step();
        let (mut pgv, mut pgd, mut cav, mut uniform) = (0.0_f64, 0.0_f64, 0.0, 0.0);
        let mut bracketed: Option<Interval> = None;
        let mut squares = vec![0.0];
        let mut square = 0.0;
        for (index, step) in self.steps().enumerate() {
            let [v, u] = peaks(&step, time_step);
            (pgv, pgd) = (pgv.max(v), pgd.max(u));
            cav += magnitude(step.accelerations, time_step);
            for [from, to] in strong(step.accelerations) {
                uniform += (to - from) * time_step;
                let [start, end] = [from, to].map(|part| (index as f64 + part) * time_step);
                bracketed = Some(Interval {
                    start: bracketed.map_or(start, |known| known.start),
                    end,
                });
            }
            square += squared(step.accelerations, 1.0) * time_step;
            squares.push(square);
        }
        let interval = |from, to| {
            let instant = |share| self.instant(&squares, share * square);
            (square > 0.0 && square.is_finite()).then(|| Interval {
                start: instant(from),
                end: instant(to),
            })
        };
        Measures {
            pga: self.peak().1.abs(),
            pgv,
            pgd,
            arias: PI / (2.0 * STANDARD_GRAVITY) * square,
            cav,
            d5_75: interval(0.05, 0.75),
            d5_95: interval(0.05, 0.95),
            bracketed,
            uniform,
        }
    }

    /// The instant \[s\] at which ∫a² dt reaches a value below its last, from its values at the samples.
    fn instant(&self, squares: &[f64], wanted: f64) -> f64 {
        let index = squares.partition_point(|&square| square <= wanted) - 1;
        let (Some(&left), Some(&right)) = (self.samples().get(index), self.samples().get(index + 1)) else {
            return self.duration();
        };
        let missing = (wanted - squares[index]) / self.time_step();
        let [mut below, mut above] = [0.0, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (below + above);
            if squared([left, right], middle) <= missing {
                below = middle;
            } else {
                above = middle;
            }
        }
        (index as f64 + below) * self.time_step()
    }
}

/// ∫a² over the first `part` of a step, 0..=1, in time steps.
fn squared([start, end]: [f64; 2], part: f64) -> f64 {
    let end = start + (end - start) * part;
    // A sum of squares: on overflow it is infinite, never NaN.
    part * (start * start + (start + end) * (start + end) + end * end) / 6.0
}

/// ∫|a| dt over a step.
fn magnitude([start, end]: [f64; 2], time_step: f64) -> f64 {
    let sum = start.abs() + end.abs();
    let crosses = (start < 0.0 && end > 0.0) || (start > 0.0 && end < 0.0);
    if crosses {
        // Two triangles: start²/sum and end²/sum of the step are their shares, without squares that overflow.
        let (left, right) = (start.abs() / sum, end.abs() / sum);
        0.5 * time_step * (left * start.abs() + right * end.abs())
    } else {
        0.5 * time_step * sum
    }
}

/// Parts of a step, 0..=1, in which |a| is strong, in their order: at its start, at its end, or all of it.
fn strong([start, end]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let crossing = move |limit: f64| ((limit - start) / (end - start)).clamp(0.0, 1.0);
    // On a line |a| is strong beyond the positive limit, and beyond the negative one.
    let beyond = move |sign: f64| {
        let [start, end] = [sign * start, sign * end].map(|one| one >= Measures::STRONG);
        match [start, end] {
            [false, false] => None,
            [true, true] => Some([0.0, 1.0]),
            [true, false] => Some([0.0, crossing(sign * Measures::STRONG)]),
            [false, true] => Some([crossing(sign * Measures::STRONG), 1.0]),
        }
    };
    let first = if start < 0.0 { -1.0 } else { 1.0 };
    [first, -first].into_iter().filter_map(beyond)
}

/// Largest magnitudes of velocity and displacement in a step, including its start and end.
fn peaks(step: &Step, time_step: f64) -> [f64; 2] {
    let [start, end] = step.accelerations;
    let slope = (end - start) / time_step;
    let mut peaks = [0.0_f64; 2];
    let mut take = |time: f64| {
        let values = step.at(time, time_step);
        peaks = [0, 1].map(|index| peaks[index].max(values[index].abs()));
    };
    take(0.0);
    take(time_step);
    // Velocity has an extremum at zero acceleration, displacement at zero velocity.
    let root = (start * start - 2.0 * slope * step.velocity).sqrt();
    let pivot = -(start + root.copysign(start));
    let inside = [-start / slope, pivot / slope, 2.0 * step.velocity / pivot];
    for time in inside {
        // A NaN fails this test: then there is no such instant.
        if time > 0.0 && time < time_step {
            take(time);
        }
    }
    peaks
}
