//! The time step behind a column of printed times.

use super::{Stated, reading};
use crate::line::Line;
use crate::{Place, ReadError, Reading};

/// Largest departure from equal steps that is not due to printing, in steps.
const UNEVENNESS: f64 = 1e-6;

/// Most decimals a time step is given: what an f64 near 1 can hold.
const MOST_DECIMALS: usize = 15;

/// The times of a file as printed, with the lines they stand on.
#[derive(Default)]
pub(super) struct TimeColumn {
    times: Vec<f64>,
    lines: Vec<usize>,
    decimals: usize,
}

/// Equal steps, and whether the first printed time is 0 or one step.
struct Grid {
    time_step: f64,
    starts_after_one_step: bool,
}

impl TimeColumn {
    pub(super) fn push(&mut self, line: Line<'_>, field: &[u8]) -> Result<(), ReadError> {
        self.times.push(line.finite(1, field)?);
        self.lines.push(line.number);
        self.decimals = self.decimals.max(decimals(field));
        Ok(())
    }

    /// The time step; values that begin one step late get the state of rest at t = 0.
    pub(super) fn into_step(
        self,
        values: &mut Vec<f64>,
    ) -> Result<(Stated<f64>, Option<Reading>), ReadError> {
        let grid = self.grid()?;
        let place = Place::Line(self.lines[0]);
        let remark = grid.starts_after_one_step.then(|| {
            values.insert(0, 0.0);
            reading(
                "state of rest",
                Some(place),
                "0 put at t = 0, where the file has nothing",
            )
        });
        let stated = Stated {
            value: grid.time_step,
            place,
            text: format!("times from {} s on", self.times[0]),
        };
        Ok((stated, remark))
    }

    fn grid(&self) -> Result<Grid, ReadError> {
        let (&[first, ..], &[.., last]) = (&self.times[..], &self.times[..]) else {
            return Err(ReadError::TooFewSamples { found: 0 });
        };
        if self.times.len() < 2 {
            return Err(ReadError::TooFewSamples { found: 1 });
        }
        if let Some(before) = self.times.windows(2).position(|pair| pair[1] <= pair[0]) {
            return Err(ReadError::TimeOrder {
                line: self.lines[before + 1],
                found: self.times[before + 1],
                allowed: self.times[before],
            });
        }
        let mean = (last - first) / (self.times.len() - 1) as f64;
        if !mean.is_finite() {
            // Times near ±1.8e308, whose difference is beyond every number.
            let line = self.lines[self.lines.len() - 1];
            return Err(ReadError::TimeStep {
                place: Place::Line(line),
                found: mean,
            });
        }
        let (time_step, slack) = self.time_step(mean).ok_or_else(|| self.unevenness())?;
        let starts_after_one_step = (first - time_step).abs() <= slack;
        if first.abs() > slack && !starts_after_one_step {
            return Err(ReadError::StartTime {
                line: self.lines[0],
                found: first,
                time_step,
            });
        }
        Ok(Grid {
            time_step,
            starts_after_one_step,
        })
    }

    /// The time step and how far a time may be from its place, if the times rise in equal steps.
    fn time_step(&self, mean: f64) -> Option<(f64, f64)> {
        let last = self.times[self.times.len() - 1];
        let unit = power_of_ten(self.decimals);
        let rounding = 4.0 * f64::EPSILON * last.abs();

        // A step with no more decimals than the times have is printed without rounding: its
        // multiples are exact.
        let slack = 0.25 * unit.min(mean) + rounding;
        let span = last - self.times[0];
        let steps = (self.times.len() - 1) as f64;
        let decimal = (0..=self.decimals.min(MOST_DECIMALS))
            .filter_map(|decimals| format!("{mean:.decimals$}").parse::<f64>().ok())
            .find(|step| *step > 0.0 && (step * steps - span).abs() <= slack);
        if let Some(step) = decimal
            && self.fits(step, slack + UNEVENNESS * step)
        {
            return Some((step, slack + UNEVENNESS * step));
        }

        // Otherwise, such as for 1/256 s in four decimals, first, last and each time are rounded,
        // by half a unit each. Where that is much of a step it would hide a missing sample.
        let slack = unit + UNEVENNESS * mean + rounding;
        (10.0 * unit <= mean && self.fits(mean, slack)).then_some((mean, slack))
    }

    fn fits(&self, step: f64, slack: f64) -> bool {
        let first = self.times[0];
        self.times
            .iter()
            .enumerate()
            .all(|(index, time)| (time - (first + index as f64 * step)).abs() <= slack)
    }

    /// The line whose step is furthest from the median step.
    fn unevenness(&self) -> ReadError {
        // As many decimals as the times have: the difference of two times has noise beyond them.
        let decimals = self.decimals.min(MOST_DECIMALS);
        let printed = |step: f64| format!("{step:.decimals$}").parse().unwrap_or(step);
        let steps: Vec<f64> = self
            .times
            .windows(2)
            .map(|pair| printed(pair[1] - pair[0]))
            .collect();
        let mut sorted = steps.clone();
        sorted.sort_by(f64::total_cmp);
        let allowed = sorted[sorted.len() / 2];
        let mut worst = 0;
        for (index, step) in steps.iter().enumerate() {
            if (step - allowed).abs() > (steps[worst] - allowed).abs() {
                worst = index;
            }
        }
        ReadError::UnevenTime {
            line: self.lines[worst + 1],
            found: steps[worst],
            allowed,
        }
    }
}

/// Decimals of a printed number: 2 for `0.02`, 4 for `1.23e-2`.
fn decimals(field: &[u8]) -> usize {
    let text = String::from_utf8_lossy(field.trim_ascii());
    let (mantissa, exponent) = text
        .split_once(['e', 'E', 'd', 'D'])
        .unwrap_or((&text, "0"));
    let written = mantissa
        .split_once('.')
        .map_or(0, |(_, decimals)| decimals.len());
    let shift: isize = exponent.parse().unwrap_or(0);
    written.saturating_add_signed(shift.saturating_neg())
}

/// 10⁻ⁿ to the last digit; 0 where that is below every number.
fn power_of_ten(decimals: usize) -> f64 {
    format!("1e-{decimals}")
        .parse()
        .expect("a number in exponent notation")
}
