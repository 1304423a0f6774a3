//! The run, step by step from event to event.

use std::sync::atomic::{AtomicBool, Ordering};

use super::block::Block;
use super::dormand_prince::DormandPrince;
use super::equations::{Equations, InStep, NOW, Segment};
use super::events::{self, Event};
use super::impact::NOISE;
use super::law::Law;
use super::model::{Model, TIME, displacement, velocity};
use super::phases::{ContactPhase, Phases};
use super::plan::{self, Plan};
use super::record::{Record, Response};
use super::scales::Scales;
use super::state::{Bounces, State};
use super::variable::{Variable, fourth_root};
use super::{Fineness, SecondRouteError};

/// Most events in one segment of the record.
const MOST_EVENTS: usize = 5_000;

/// Most reductions of a step. Beyond, the tolerance cannot be met.
const MOST_REJECTIONS: usize = 60;

/// Distance of a pair, as a part of the displacements of both sides, beyond which their difference is accurate.
const FAR: f64 = 1e-2;

/// A run in progress.
#[derive(Debug, Clone)]
pub(super) struct Runner {
    pub(super) motion: Equations,
    pub(super) state: State,
    /// End of the trial step.
    trial: State,
    method: DormandPrince,
    /// Events that can end the present step.
    events: Vec<Event>,
    /// Events that ended the present step.
    fired: Vec<Event>,
    pub(super) scratch: Vec<f64>,
    middle: Vec<f64>,
    pub(super) record: Record,
    pub(super) bounces: Vec<Bounces>,
    pub(super) scales: Scales,
    tolerance: f64,
    longest_step: f64,
    /// Bounces that would end within this time are over \[s\].
    pub(super) shortest: f64,
    /// Length of the next step by the error of the last one \[s\].
    pub(super) proposal: f64,
    n_events: usize,
}

impl Runner {
    /// A run from t = 0 over segments of `interval` \[s\].
    pub(super) fn new(model: Model, fineness: Fineness, interval: f64) -> Self {
        let n = model.n_unknowns();
        let mut state = State::zero(n);
        for (index, structure) in model.structures.iter().enumerate() {
            state.set(displacement(index), structure.initial_displacement);
            state.set(velocity(index), structure.initial_velocity);
            if let Some(smooth) = structure.columns.smooth {
                let drift = model.initial_drift(structure);
                state.set(smooth.unknown, structure.columns.loaded(smooth, drift));
            }
        }
        for pair in &model.pairs {
            let [deformation, rate] = model.initial_deformation(pair);
            state.set(pair.deformation, deformation);
            state.set(pair.deformation + 1, rate);
        }
        let longest_step = interval / f64::from(fineness.steps_per_sample);
        let motion = Equations {
            phases: Phases::new(&model),
            block: Block::new(&model, Vec::new()),
            model,
            segment: Segment::default(),
        };
        let mut runner = Self {
            trial: state.clone(),
            method: DormandPrince::new(n),
            events: Vec::new(),
            fired: Vec::new(),
            scratch: vec![0.0; n],
            middle: vec![0.0; n],
            record: Record::new(&motion),
            bounces: vec![Bounces::default(); motion.model.pairs.len()],
            scales: Scales::new(n, interval, longest_step),
            tolerance: fineness.tolerance,
            longest_step,
            shortest: fineness.shortest,
            proposal: longest_step,
            n_events: 0,
            motion,
            state,
        };
        let Self { scales, motion, state, .. } = &mut runner;
        scales.enlarge(&motion.model, &state.high);
        runner
    }

    /// Runs through a segment of the record, until `stop` is set.
    pub(super) fn segment(&mut self, segment: Segment, stop: &AtomicBool) -> Result<(), SecondRouteError> {
        self.motion.phases.shift(self.motion.segment.length);
        let length = segment.length;
        self.motion.segment = segment;
        self.state.set(TIME, 0.0);
        self.n_events = 0;
        // A floor that only a link moves has no scale at first.
        if self.motion.rests() || !self.motion.model.links.is_empty() {
            for &(start, rate) in &self.motion.segment.grounds {
                self.scales.shake(start);
                self.scales.shake(start + rate * length);
            }
            self.scales.enlarge(&self.motion.model, &self.state.high);
        }
        self.measure();
        // The acceleration of the ground may jump.
        self.rest(self.now())?;
        self.observe();
        while self.state.high[TIME] < length {
            if stop.load(Ordering::Relaxed) {
                return Err(SecondRouteError::Stopped { time: self.now() });
            }
            self.advance()?;
        }
        Ok(())
    }

    /// Recomputes deformations and rates of pairs far apart from the motions of both sides. Impacts round each of these unknowns
    /// separately, and many impacts would change the gap.
    fn measure(&mut self) {
        let Self { motion, state, scales, .. } = self;
        let moved = &motion.segment.moved;
        for (index, pair) in motion.model.pairs.iter().enumerate() {
            let apart = matches!(motion.phases.pairs[index].contact, ContactPhase::Apart);
            let size = pair.ends.size(|floor| scales.sizes()[displacement(floor)]);
            let distance = -state.high[pair.deformation];
            if apart && distance > FAR * size {
                for (own, unknown, gap) in [(0, displacement as fn(usize) -> usize, pair.gap), (1, velocity, 0.0)] {
                    let ahead = |state: &[f64]| pair.ends.ahead(|floor| state[unknown(floor)]);
                    let over_ground = ahead(&state.high) + ahead(&state.low);
                    let [left, right] = pair.ends.grounds().map(unknown);
                    let closed = over_ground + moved.difference(left, right) - gap;
                    state.set(pair.deformation + own, closed);
                }
            }
        }
    }

    /// The response, after the last segment.
    pub(super) fn finish(mut self, time: f64) -> Response {
        self.motion.slope(NOW, &self.state.high, &mut self.scratch);
        self.record.finish(&self.motion, &self.state, &self.scratch, time)
    }

    fn now(&self) -> f64 {
        self.motion.segment.start + self.state.high[TIME]
    }

    /// Makes a step, up to the first event in it.
    fn advance(&mut self) -> Result<(), SecondRouteError> {
        let variable = plan::variable(&self.motion, &self.state.high, &mut self.scratch);
        events::list(&self.motion, variable, &mut self.events);
        let longest = self.proposal.min(self.longest_step);
        let mut plan = Plan::new(&self.motion, &self.state.high, variable, longest);
        self.accept(&mut plan)?;
        self.split_reversals(&mut plan);
        self.stop_at_first_event(&mut plan);
        self.commit(plan)
    }

    fn try_step(&mut self, variable: Variable, length: f64) {
        self.method.step(&self.motion, variable, length, &self.state, &mut self.trial);
    }

    /// Shortens the step until its error is acceptable.
    fn accept(&mut self, plan: &mut Plan) -> Result<(), SecondRouteError> {
        let mut error = f64::NAN;
        for _ in 0..MOST_REJECTIONS {
            self.try_step(plan.variable, plan.length);
            let (sizes, end) = (self.scales.sizes(), &self.trial.high);
            let tolerance = self.tolerance;
            let scale = |index: usize| tolerance * sizes[index].max(end[index].abs());
            error = self.method.error(plan.length, scale);
            // The estimate grows with the sixth power of the length; 3/16 is the power closest to 1/6 that roots give.
            let factor = 0.8 / fourth_root(error * error.sqrt()).sqrt();
            if error <= 1.0 {
                let elapsed = self.trial.high[TIME] - self.state.high[TIME];
                let allowed = elapsed * factor.min(5.0);
                let met = plan.target.is_some();
                if elapsed <= 0.0 && !met {
                    break;
                }
                self.proposal = if met { allowed.max(self.proposal) } else { allowed };
                return Ok(());
            }
            let factor = if factor.is_finite() { factor.max(0.2) } else { 0.2 };
            plan.shorten(factor * plan.length);
        }
        let time = self.now();
        Err(if error.is_finite() {
            SecondRouteError::Tolerance {
                time,
                tolerance: self.tolerance,
            }
        } else {
            SecondRouteError::NotFinite { time }
        })
    }

    /// Halves the step while a velocity changes its sign twice in it.
    fn split_reversals(&mut self, plan: &mut Plan) {
        // Thirty halvings: a billionth of a step, in which only rounding reverses a velocity.
        for _ in 0..30 {
            if !self.has_double_reversal(plan) {
                return;
            }
            plan.shorten(0.5 * plan.length);
            self.try_step(plan.variable, plan.length);
        }
    }

    fn has_double_reversal(&mut self, plan: &Plan) -> bool {
        let end = &self.trial.high;
        let place = InStep {
            variable: plan.variable,
            position: plan.length,
        };
        self.motion.slope(place, end, &mut self.scratch);
        let first = self.method.first_slope();
        for (index, middle) in self.middle.iter_mut().enumerate() {
            let bend = first[index] - self.scratch[index];
            *middle = 0.5 * (self.state.high[index] + end[index]) + 0.125 * plan.length * bend;
        }
        let (motion, middle, scratch) = (&self.motion, &self.middle, &mut self.scratch);
        self.events
            .iter()
            .any(|event| event.is_reversal() && event.value(motion, middle, scratch) < 0.0 && event.value(motion, end, scratch) >= 0.0)
    }

    /// Shortens the step to the first event in it; `trial` is then just past the event.
    fn stop_at_first_event(&mut self, plan: &mut Plan) {
        for index in 0..self.events.len() {
            let event = self.events[index];
            let value = event.value(&self.motion, &self.trial.high, &mut self.scratch);
            if value < 0.0 {
                let length = self.locate(event, plan, value);
                if length < plan.length {
                    plan.shorten(length);
                }
            }
        }
    }

    /// Length within the planned step that just passes an event.
    ///
    /// The step is repeated with trial lengths: regula falsi (Illinois), with a bisection every third time.
    fn locate(&mut self, event: Event, plan: &Plan, value: f64) -> f64 {
        let start = event.value(&self.motion, &self.state.high, &mut self.scratch);
        if start < 0.0 {
            self.trial.copy_from(&self.state);
            return 0.0;
        }
        let (mut before, mut after) = ((0.0, start), (plan.length, value));
        let resolution = f64::EPSILON * plan.length;
        let mut round = 0;
        let mut last_moved = 0;
        while after.0 - before.0 > 2.0 * resolution && round < 200 {
            round += 1;
            let guess = if round % 3 == 0 {
                0.5 * (before.0 + after.0)
            } else {
                (before.0 * after.1 - after.0 * before.1) / (after.1 - before.1)
            };
            let length = guess.clamp(before.0 + resolution, after.0 - resolution);
            self.try_step(plan.variable, length);
            let value = event.value(&self.motion, &self.trial.high, &mut self.scratch);
            let moved = if value < 0.0 { 1 } else { -1 };
            if value < 0.0 {
                after = (length, value);
                before.1 *= if last_moved == moved { 0.5 } else { 1.0 };
            } else {
                before = (length, value);
                after.1 *= if last_moved == moved { 0.5 } else { 1.0 };
            }
            last_moved = moved;
        }
        self.try_step(plan.variable, after.0);
        after.0
    }

    /// Accepts the end of the step, records it and applies its events.
    fn commit(&mut self, plan: Plan) -> Result<(), SecondRouteError> {
        let started = self.now();
        self.record.transfer(&self.motion, &self.state.high, &self.trial.high);
        std::mem::swap(&mut self.state, &mut self.trial);
        if let Some(Event::SegmentEnd) = plan.target {
            self.state.set(TIME, self.motion.segment.length);
        }
        if self.state.high.iter().any(|unknown| !unknown.is_finite()) {
            return Err(SecondRouteError::NotFinite { time: started });
        }
        self.scales.enlarge(&self.motion.model, &self.state.high);
        self.observe();
        self.fired.clear();
        for &event in &self.events {
            if event.value(&self.motion, &self.state.high, &mut self.scratch) < 0.0 {
                self.fired.push(event);
            }
        }
        if let Some(part @ Event::Part(_)) = plan.target {
            self.fired.push(part);
        }
        self.n_events += self.fired.len();
        if self.n_events > MOST_EVENTS {
            return Err(SecondRouteError::TooManyEvents {
                time: self.now(),
                limit: MOST_EVENTS,
            });
        }
        if !self.fired.is_empty() {
            self.happen()?;
            self.observe();
        }
        self.motion.settle(&self.scratch);
        Ok(())
    }

    /// Records the present state; `scratch` then holds its derivative.
    fn observe(&mut self) {
        let (y, time) = (&self.state.high, self.now());
        self.motion.slope(NOW, y, &mut self.scratch);
        self.record.observe(&self.motion, y, &self.scratch, time);
    }

    /// Applies the events of the step.
    fn happen(&mut self) -> Result<(), SecondRouteError> {
        let time = self.now();
        let mut collides = false;
        for index in 0..self.fired.len() {
            let event = self.fired[index];
            event.apply(&mut self.motion, &self.state.high);
            match event {
                Event::SegmentEnd => self.state.set(TIME, self.motion.segment.length),
                Event::Part(pair) => self.part(pair, time),
                Event::Touch(pair) => match self.motion.model.pairs[pair].law {
                    Law::Impulsive { .. } => collides = true,
                    Law::Compliant(_) => self.touch(pair, time),
                },
                // It is decided next whether it sticks.
                Event::Turn(floor) if self.motion.model.structures[floor].friction.is_some() => self.stop(floor),
                Event::Turn(_)
                | Event::DriftTurn(_)
                | Event::Yield(_)
                | Event::Straight(_)
                | Event::Soften(_)
                | Event::Balance(_)
                | Event::Reversal(_)
                | Event::ForcePeak(_)
                | Event::Bend(_)
                | Event::Clamp(_)
                | Event::Grip(_)
                | Event::Fade(_)
                | Event::Slip(_)
                | Event::FrictionPeak(_)
                | Event::Stir(_)
                | Event::Link(..) => {}
            }
        }
        if collides { self.collide(time) } else { self.rest(time) }
    }

    /// A floor with friction comes to a standstill, without rounding in its own velocity and in the rates of its pairs.
    fn stop(&mut self, floor: usize) {
        let Self { motion, state, .. } = self;
        state.set(velocity(floor), 0.0);
        for (pair, phase) in motion.model.pairs.iter().zip(&motion.phases.pairs) {
            let rests = matches!(phase.contact, ContactPhase::Resting { .. });
            if !rests && pair.ends.part(floor) != 0.0 {
                let ahead = pair.ends.ahead(|floor| state.high[velocity(floor)]);
                let rate = ahead + motion.segment.faster(pair.ends.grounds(), state.high[TIME]);
                state.set(pair.deformation + 1, rate);
            }
        }
    }

    /// A pair begins to press.
    pub(super) fn touch(&mut self, pair: usize, time: f64) {
        self.state.set(self.motion.model.impulse(pair), 0.0);
        self.motion.slope(NOW, &self.state.high, &mut self.scratch);
        let force = self.scratch[self.motion.model.impulse(pair)];
        self.record.touch(pair, time, force);
    }

    /// A pair stops pressing.
    pub(super) fn part(&mut self, pair: usize, time: f64) {
        let index = self.motion.model.impulse(pair);
        let (impulse, least) = (self.state.high[index], NOISE * self.scales.sizes()[index]);
        self.record.part(pair, impulse, least, time);
    }
}
