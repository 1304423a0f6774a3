//! Response spectra of two horizontal components: geometric mean and rotated responses.
//!
//! An oscillator that is free in the plane moves by (u₁, u₂). Along a direction θ its largest displacement is the largest
//! |u₁ cos θ + u₂ sin θ|, the extent of the outline of its path (`outline.rs`). `RotD50` and `RotD100` are median and maximum over all
//! directions (D. M. Boore, *Bull. Seismol. Soc. Am.* 100 (2010) 1830), without steps of an angle.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, Ordering};

use pounding_motion::Record;
use pounding_text::{RefusalKind, Refused, plain};

use crate::outline::Outline;
use crate::parallel;
use crate::spectrum::check_values;

/// The response spectra of a pair of horizontal components for one damping ratio.
#[derive(Debug, Clone, PartialEq)]
pub struct PairSpectrum {
    /// Damping ratio \[–\].
    pub damping_ratio: f64,
    /// Pseudo-accelerations, in the order of their periods.
    pub values: Vec<PairValues>,
}

/// Pseudo-accelerations of one elastic structure under a pair of horizontal components \[m/s²\].
///
/// A structure of period 0 moves with the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairValues {
    /// Natural period T \[s\].
    pub period: f64,
    /// Along each component.
    pub of_components: [f64; 2],
    /// Geometric mean of the two components.
    pub geometric_mean: f64,
    /// Least over all directions.
    pub rotd00: f64,
    /// Median over all directions.
    pub rotd50: f64,
    /// Largest over all directions.
    pub rotd100: f64,
}

/// Largest number of steps of an oscillator: 64 MB of states for each thread.
const MOST_STEPS: f64 = 1e6;

/// Largest angle of the natural vibration in a step \[rad\].
const STEP: f64 = 0.2;

/// Largest number of parts into which a step near the outline is cut at once.
const MOST_PARTS: f64 = 40.0;

/// Largest angle of the natural vibration in the last parts \[rad\]. Their chords miss a peak by at most FINEST²/8 = 2e-9 of it.
const FINEST: f64 = 1.3e-4;

/// Largest number of steps that are cut. Only records with thousands of equal cycles have more near the outline.
const MOST_CUT: usize = 20_000;

/// Response spectra of two horizontal components at right angles, at `periods` \[s\], each 0 or 1e-6 ..= 1e6, in their order, for each
/// damping ratio 0 ..= 1. `done` is called after each period; setting `stop` ends the work.
///
/// The acceleration is linear between samples, peaks are found between them, and the run lasts one natural period longer than the record.
/// Numbers are right to 1e-8.
///
/// # Errors
/// Refuses time steps that differ, a period or ratio out of range, and more than a million values. Refuses a period that is shorter than the
/// record by a factor of some ten thousand.
pub fn pair_spectra(
    pair: [&Record; 2],
    periods: &[f64],
    damping_ratios: &[f64],
    stop: Option<&'static AtomicBool>,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<PairSpectrum>, Refused> {
    let [one, other] = pair.map(Record::time_step);
    if (one - other).abs() > 1e-9 * one {
        let found = Refused::at("pair").found(format!("time steps of {one} s and {other} s"));
        return Err(found.allowed_are("equal ones").help("resample one of them"));
    }
    check_values(periods, damping_ratios)?;
    let of_ratio = |&damping_ratio: &f64| {
        let values = |&period: &f64| {
            if stop.is_some_and(|stop| stop.load(Ordering::Relaxed)) {
                return Err(Refused::that("stopped").kind(RefusalKind::Stopped));
            }
            let found = values(pair, period, damping_ratio);
            done();
            found
        };
        Ok(PairSpectrum {
            damping_ratio,
            values: parallel::try_each(periods, values)?,
        })
    };
    damping_ratios.iter().map(of_ratio).collect()
}

/// Pseudo-accelerations at one period.
fn values(pair: [&Record; 2], period: f64, damping_ratio: f64) -> Result<PairValues, Refused> {
    let (outline, factor) = if period == 0.0 {
        let n = pair.map(|one| one.samples().len()).into_iter().max().unwrap_or(0);
        (Outline::of((0..n).map(|index| ground(pair, index))), 1.0)
    } else {
        let frequency = TAU / period;
        (Oscillator::new(pair, frequency, damping_ratio)?.outline(), frequency * frequency)
    };
    let of_components = outline.along_axes().map(|one| factor * one);
    let [rotd00, rotd50, rotd100] = outline.percentiles().map(|one| factor * one);
    Ok(PairValues {
        period,
        of_components,
        geometric_mean: of_components[0].sqrt() * of_components[1].sqrt(),
        rotd00,
        rotd50,
        rotd100,
    })
}

/// The ground acceleration at a sample, zero after the last.
fn ground(pair: [&Record; 2], index: usize) -> [f64; 2] {
    pair.map(|one| one.samples().get(index).copied().unwrap_or(0.0))
}

/// Displacement and velocity of both components.
type State = [[f64; 2]; 2];

/// A part of the motion in which the ground acceleration is linear.
#[derive(Clone, Copy)]
struct Step {
    /// State at the start.
    state: State,
    /// Ground acceleration of both components at the start and at the end.
    ground: [[f64; 2]; 2],
}

/// An elastic structure under a pair of records.
struct Oscillator<'r> {
    pair: [&'r Record; 2],
    frequency: f64,
    damping_ratio: f64,
    /// Number of steps between two samples.
    per_sample: usize,
    /// Number of steps, one natural period after the last sample included.
    n_steps: usize,
    /// Length of a step \[s\].
    step: f64,
}

impl<'r> Oscillator<'r> {
    fn new(pair: [&'r Record; 2], frequency: f64, damping_ratio: f64) -> Result<Self, Refused> {
        let time_step = pair[0].time_step();
        let n_samples = pair.map(|one| one.samples().len()).into_iter().max().unwrap_or(0);
        let per_sample = (frequency * time_step / STEP).ceil().max(1.0);
        let after = (TAU / frequency / time_step).ceil();
        let steps = per_sample * (n_samples as f64 + after);
        if steps > MOST_STEPS {
            let period = plain(TAU / frequency);
            let found = Refused::that(format!("the period of {period} s needs {steps:e} steps over this record"));
            return Err(found
                .allowed_are(format!("up to {MOST_STEPS:e}"))
                .help("take other periods, or a shorter record"));
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most a million")]
        let [per_sample, n_steps] = [per_sample, steps].map(|one| one as usize);
        Ok(Self {
            pair,
            frequency,
            damping_ratio,
            per_sample,
            n_steps,
            step: time_step / per_sample as f64,
        })
    }

    /// The outline of the path of the structure.
    fn outline(&self) -> Outline {
        let mut states: Vec<State> = Vec::with_capacity(self.n_steps + 1);
        let transition = Transition::of(self, self.step);
        let mut state = [[0.0; 2]; 2];
        states.push(state);
        for index in 0..self.n_steps {
            state = transition.after(&self.step_at(index, state));
            states.push(state);
        }
        let mut outline = Outline::of(states.iter().map(|state| state[0]));
        let mut near: Vec<Step> = states[..self.n_steps]
            .iter()
            .enumerate()
            .map(|(index, state)| self.step_at(index, *state))
            .collect();
        let mut length = self.step;
        while self.frequency * length > FINEST {
            near = self.near(&outline, near, length);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 40")]
            let n_parts = (self.frequency * length / FINEST).ceil().min(MOST_PARTS) as usize;
            length /= n_parts as f64;
            let transition = Transition::of(self, length);
            let (mut parts, mut points) = (Vec::with_capacity(near.len() * n_parts), outline.into_corners());
            for step in &near {
                let mut state = step.state;
                for part in 0..n_parts {
                    let part = step.part(part, n_parts, state);
                    state = transition.after(&part);
                    parts.push(part);
                    points.push(state[0]);
                }
            }
            outline = Outline::of(points.into_iter());
            near = parts;
        }
        outline
    }

    fn step_at(&self, index: usize, state: State) -> Step {
        let (sample, part) = (index / self.per_sample, index % self.per_sample);
        let ground = [sample, sample + 1].map(|index| ground(self.pair, index));
        let n_samples = self.pair.map(|one| one.samples().len()).into_iter().max().unwrap_or(0);
        let n = self.per_sample as f64;
        let at = |part: usize| {
            let share = part as f64 / n;
            [0, 1].map(|axis| ground[0][axis] + (ground[1][axis] - ground[0][axis]) * share)
        };
        // The ground is at rest after the last sample.
        let ground = if sample + 1 >= n_samples {
            [[0.0; 2]; 2]
        } else {
            [at(part), at(part + 1)]
        };
        Step { state, ground }
    }

    /// The steps that may reach beyond the outline of their ends.
    fn near(&self, outline: &Outline, steps: Vec<Step>, length: f64) -> Vec<Step> {
        let sectors = outline.sectors();
        let [along_first, along_second] = outline.along_axes();
        let scale = along_first.max(along_second);
        let transition = Transition::of(self, length);
        // The path leaves its chord by at most ü h²/8; a quarter more is for directions within a sector.
        let bend = 1.25 * length * length / 8.0;
        let beyond = |step: &Step| {
            let after = transition.after(step);
            let accelerations = [
                self.acceleration(&step.state, step.ground[0]),
                self.acceleration(&after, step.ground[1]),
            ];
            let bends = accelerations.map(|both| both.map(|one| bend * one));
            let reach = sectors.iter().map(|sector| sector.beyond([step.state[0], after[0]], bends));
            reach.fold(f64::NEG_INFINITY, f64::max)
        };
        let all = steps.into_iter().map(|step| (beyond(&step), step));
        let mut near: Vec<(f64, Step)> = all.filter(|(beyond, _)| *beyond > 1e-11 * scale).collect();
        if near.len() > MOST_CUT {
            near.sort_by(|one, other| other.0.total_cmp(&one.0));
            near.truncate(MOST_CUT);
        }
        near.into_iter().map(|(_, step)| step).collect()
    }

    /// Relative acceleration of both components.
    fn acceleration(&self, [displacement, velocity]: &State, ground: [f64; 2]) -> [f64; 2] {
        let (stiffness, damping) = (self.frequency * self.frequency, 2.0 * self.damping_ratio * self.frequency);
        [0, 1].map(|axis| -ground[axis] - damping * velocity[axis] - stiffness * displacement[axis])
    }
}

impl Step {
    /// One of its parts, from the state at its start.
    fn part(&self, index: usize, n_parts: usize, state: State) -> Self {
        let at = |index: usize| {
            let share = index as f64 / n_parts as f64;
            [0, 1].map(|axis| self.ground[0][axis] + (self.ground[1][axis] - self.ground[0][axis]) * share)
        };
        Self {
            state,
            ground: [at(index), at(index + 1)],
        }
    }
}

/// The matrix of a step of one length. Its rows are displacement and velocity at the end; its columns are displacement and velocity at the
/// start and ground acceleration at both ends.
struct Transition {
    rows: [[f64; 4]; 2],
}

impl Transition {
    /// By the power series of the motion in the step, which has no cancellation in short steps.
    fn of(oscillator: &Oscillator<'_>, length: f64) -> Self {
        let angle = oscillator.frequency * length;
        let (stiffness, damping) = (angle * angle, 2.0 * oscillator.damping_ratio * angle);
        let column = |input: usize| {
            // Coefficients of powers of time in units of the step.
            let start = f64::from(u8::from(input == 2));
            let slope = [0.0, 0.0, -1.0, 1.0][input];
            let load = |power: usize| length * length * [-start, -slope].get(power).copied().unwrap_or(0.0);
            let mut coefficients = [0.0; 26];
            coefficients[0] = f64::from(u8::from(input == 0));
            coefficients[1] = if input == 1 { length } else { 0.0 };
            for power in 0..24 {
                let n = power as f64;
                let known = load(power) - damping * (n + 1.0) * coefficients[power + 1] - stiffness * coefficients[power];
                coefficients[power + 2] = known / ((n + 1.0) * (n + 2.0));
            }
            // The smallest first.
            let powers = || coefficients.iter().enumerate().rev();
            let displacement: f64 = powers().map(|(_, one)| one).sum();
            let velocity: f64 = powers().map(|(power, one)| power as f64 * one).sum();
            [displacement, velocity / length]
        };
        let columns = [0, 1, 2, 3].map(column);
        Self {
            rows: [0, 1].map(|row| columns.map(|column| column[row])),
        }
    }

    fn after(&self, step: &Step) -> State {
        self.rows.map(|[u, v, start, end]| {
            [0, 1].map(|axis| u * step.state[0][axis] + v * step.state[1][axis] + start * step.ground[0][axis] + end * step.ground[1][axis])
        })
    }
}
