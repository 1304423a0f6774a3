//! The time step of a column of printed times.

use super::spacing::{Spacing, Uneven};
use super::{Stated, reading};
use crate::line::Line;
use crate::refusals;
use crate::{FilePlace, Reading, Refused};
use pounding_text::{Knob, RefusalKind, Spot, plain};

/// Largest departure from equal steps that is not due to printing, in steps.
const UNEVENNESS: f64 = 1e-6;

/// Largest number of decimals of a time step: an f64 near 1 holds no more.
const MOST_DECIMALS: usize = 15;

/// The printed times of a file with their lines.
#[derive(Default)]
pub(super) struct TimeColumn {
    times: Vec<f64>,
    lines: Vec<usize>,
    decimals: usize,
}

/// The start of the times.
#[derive(Clone, Copy)]
enum Start {
    /// At t = 0.
    Zero,
    /// After one step.
    OneStep,
    /// At any other time.
    Elsewhere,
}

impl TimeColumn {
    pub(super) fn push(&mut self, line: Line<'_>, field: &[u8]) -> Result<(), Refused> {
        self.push_time(line, line.finite(1, field)?, decimals(field));
        Ok(())
    }

    /// Adds a time \[s\] with its number of decimals.
    pub(super) fn push_time(&mut self, line: Line<'_>, time: f64, decimals: usize) {
        self.times.push(time);
        self.lines.push(line.number);
        self.decimals = self.decimals.max(decimals);
    }

    /// Whether the times rise in equal steps.
    pub(super) fn is_even(&self) -> bool {
        matches!(self.spacing(), Ok((Spacing::Even(_), _)))
    }

    /// Whether no time is before the previous one, and some are after it.
    pub(super) fn rise(&self) -> bool {
        self.times.is_sorted() && self.times.first() < self.times.last()
    }

    /// Whether some times are printed equal to the previous one.
    pub(super) fn have_ties(&self) -> bool {
        self.times.windows(2).any(|pair| pair[0] >= pair[1])
    }

    /// The times unchanged, as uneven ones with ties.
    pub(super) fn into_uneven(self) -> Spacing {
        Spacing::Uneven(Uneven {
            place: FilePlace::Line(self.lines[0]),
            refusal: self.unevenness(),
            times: self.times,
        })
    }

    /// The time step of times that begin at 0 or one step later. In the latter case the state of rest at t = 0 is added to the values.
    pub(super) fn into_step(self, values: &mut Vec<f64>) -> Result<(Spacing, Option<Reading>), Refused> {
        let (spacing, start) = self.spacing()?;
        let remark = match (&spacing, start) {
            (Spacing::Even(_), Start::OneStep) => Some(self.at_rest(values)),
            (Spacing::Even(step), Start::Elsewhere) => {
                return Err(Refused::at(Spot::Line(self.lines[0]))
                    .is(format!("the first time is {} s", plain(self.times[0])))
                    .allowed_are(format!("0 s and one time step, {} s", plain(step.value)))
                    .help("shift the time column so that the record begins there"));
            }
            _ => None,
        };
        Ok((spacing, remark))
    }

    /// The time step of times that begin anywhere; the first becomes t = 0.
    pub(super) fn into_step_from_anywhere(self, values: &mut Vec<f64>) -> Result<(Spacing, Option<Reading>), Refused> {
        let (spacing, start) = self.spacing()?;
        let remark = match (&spacing, start) {
            (_, Start::Zero) => None,
            (Spacing::Even(_), Start::OneStep) => Some(self.at_rest(values)),
            _ => {
                let found = format!("the {} s of the first line, taken as t = 0", self.times[0]);
                Some(reading("start", Some(FilePlace::Line(self.lines[0])), &found))
            }
        };
        Ok((spacing, remark))
    }

    /// Puts the state of rest before values that begin one step late.
    fn at_rest(&self, values: &mut Vec<f64>) -> Reading {
        values.insert(0, 0.0);
        reading(
            "state of rest",
            Some(FilePlace::Line(self.lines[0])),
            "0 put at t = 0, where the file has nothing",
        )
    }

    fn spacing(&self) -> Result<(Spacing, Start), Refused> {
        let (&[first, ..], &[.., last]) = (&self.times[..], &self.times[..]) else {
            return Err(too_few(0));
        };
        if self.times.len() < 2 {
            return Err(too_few(1));
        }
        if let Some(before) = self.times.windows(2).position(|pair| pair[1] <= pair[0]) {
            return Err(Refused::at(Spot::Line(self.lines[before + 1]))
                .is(format!("the time is {} s", plain(self.times[before + 1])))
                .allowed_are(format!("times after the {} s of the line before", plain(self.times[before])))
                .help("sort the lines by time and keep one of each"));
        }
        let mean = (last - first) / (self.times.len() - 1) as f64;
        if !mean.is_finite() {
            // The difference of times near ±1.8e308 overflows.
            let line = self.lines[self.lines.len() - 1];
            return Err(refusals::time_step(FilePlace::Line(line), mean));
        }
        let place = FilePlace::Line(self.lines[0]);
        let Some((time_step, slack)) = self.time_step(mean) else {
            let uneven = Uneven {
                times: self.times.clone(),
                place,
                refusal: self.unevenness(),
            };
            let start = if first.abs() > 0.0 { Start::Elsewhere } else { Start::Zero };
            return Ok((Spacing::Uneven(uneven), start));
        };
        let start = if first.abs() <= slack {
            Start::Zero
        } else if (first - time_step).abs() <= slack {
            Start::OneStep
        } else {
            Start::Elsewhere
        };
        let stated = Stated {
            value: time_step,
            place,
            text: format!("times from {first} s on"),
        };
        Ok((Spacing::Even(stated), start))
    }

    /// The time step, and the largest distance of a time from its grid point, if the times rise in equal steps.
    fn time_step(&self, mean: f64) -> Option<(f64, f64)> {
        let last = self.times[self.times.len() - 1];
        let unit = power_of_ten(self.decimals);
        let rounding = 4.0 * f64::EPSILON * last.abs();

        // A step with at most the decimals of the times is printed without rounding: its multiples are exact.
        let slack = 0.25 * unit.min(mean) + rounding;
        if let Some(found) = self.decimal_step(mean, slack) {
            return Some(found);
        }

        // Otherwise, for example with 1/256 s in four decimals, the first, the last and each time are rounded by up to half a unit. If that
        // is much of a step, it would hide a missing sample.
        let slack = unit + UNEVENNESS * mean + rounding;
        if 10.0 * unit <= mean && self.fits(mean, slack) {
            return Some((mean, slack));
        }

        // Programs in single precision may have computed the times: then each has a rounding error too.
        let single = unit + f64::from(f32::EPSILON) * last.abs();
        let is_much = 10.0 * single > mean;
        self.decimal_step(mean, single).filter(|_| !is_much)
    }

    /// The shortest decimal step between the first and the last time, if all times are on its grid.
    fn decimal_step(&self, mean: f64, slack: f64) -> Option<(f64, f64)> {
        let span = self.times[self.times.len() - 1] - self.times[0];
        let steps = (self.times.len() - 1) as f64;
        let step = (0..=self.decimals.min(MOST_DECIMALS))
            .filter_map(|decimals| format!("{mean:.decimals$}").parse::<f64>().ok())
            .find(|step| *step > 0.0 && (step * steps - span).abs() <= slack)?;
        let slack = slack + UNEVENNESS * step;
        self.fits(step, slack).then_some((step, slack))
    }

    fn fits(&self, step: f64, slack: f64) -> bool {
        let first = self.times[0];
        self.times
            .iter()
            .enumerate()
            .all(|(index, time)| (time - (first + index as f64 * step)).abs() <= slack)
    }

    /// The line whose step is furthest from the median step.
    fn unevenness(&self) -> Refused {
        // The message has as many decimals as the times: the difference of two times has noise beyond them.
        let decimals = self.decimals.min(MOST_DECIMALS);
        let printed = |step: f64| format!("{step:.decimals$}").parse().unwrap_or(step);
        let steps: Vec<f64> = self.times.windows(2).map(|pair| printed(pair[1] - pair[0])).collect();
        let mut sorted = steps.clone();
        sorted.sort_by(f64::total_cmp);
        let allowed = sorted[sorted.len() / 2];
        let mut worst = 0;
        for (index, step) in steps.iter().enumerate() {
            if (step - allowed).abs() > (steps[worst] - allowed).abs() {
                worst = index;
            }
        }
        Refused::that_at(
            Spot::Line(self.lines[worst + 1]),
            format!(
                "the times rise in uneven steps, from {} to {} s: at line {} by {} s, where {} s are the median",
                plain(sorted[0]),
                plain(sorted[sorted.len() - 1]),
                self.lines[worst + 1],
                plain(steps[worst]),
                plain(allowed)
            ),
        )
        .help("declare the step to which they are to be resampled, linear between them, as ")
        .and(Knob::TimeStep)
        .and(", or print them with more decimals")
        .wants(Knob::TimeStep)
        .kind(RefusalKind::Uneven)
    }
}

/// Number of decimals of a printed number: 2 for `0.02`, 4 for `1.23e-2`.
pub(super) fn decimals(field: &[u8]) -> usize {
    let text = String::from_utf8_lossy(field.trim_ascii());
    let (mantissa, exponent) = text.split_once(['e', 'E', 'd', 'D']).unwrap_or((&text, "0"));
    let written = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let shift: isize = exponent.parse().unwrap_or(0);
    written.saturating_add_signed(shift.saturating_neg())
}

/// 10⁻ⁿ to the last digit; 0 if that underflows.
fn power_of_ten(decimals: usize) -> f64 {
    format!("1e-{decimals}").parse().expect("a number in exponent notation")
}

fn too_few(found: usize) -> Refused {
    let said = Refused::that(format!("{found} sample(s) found"));
    said.but(", but ", "the time step is taken from the time column and needs at least 2")
}
