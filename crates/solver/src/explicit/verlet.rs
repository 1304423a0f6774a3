//! Velocity Verlet method, with impacts after a step or located within it.
//!
//! Source: W. C. Swope et al., *J. Chem. Phys.* 76 (1982) 637; L. Verlet, *Phys. Rev.* 159 (1967) 98. Over a step h:
//! u⁺ = u + h u̇ + h²ü/2, then u̇⁺ = u̇ + h (ü + ü⁺)/2.
//!
//! Damping of the structures is half-implicit: ü⁺ contains the damping of u̇⁺ (a division, since c is constant). The method then moves like
//! the central difference method, is in equilibrium at both ends, and keeps the limit 2/ω for any damping. For floors that stand on floors
//! the velocities are the solution of a tridiagonal system. Compliant contact is explicit: its rate is that of the predicted velocities u̇
//! + h ü.
//!
//! Impacts are located in this method, not in the central difference method, for two reasons. A step needs only the state at its start, so
//! that it may begin and end anywhere. And displacements are quadratic in time: a gap closes at the root of a quadratic.

mod storeys;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::impact::impacts::Impacts;
use crate::march::{ClockStep, Stepping, march};
use crate::model::approach::Approaches;
use crate::model::dashpots::Dashpots;
use crate::model::ground::{Ground, Now};
use crate::pushes::Pushes;
use crate::span::{Load, StoreyForces, Weights};
use crate::{Course, Excitation, Node, Pair, Recorder, RestoringForce, Row, RunError, Span, State, Work};

/// Settings of the velocity Verlet method. Order 2 while nothing touches, critical time step 2/ω.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Verlet {
    /// When impulsive contact acts.
    pub impacts: VerletImpacts,
}

/// When the impulsive contact of the velocity Verlet method acts.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum VerletImpacts {
    /// After the step in which an overlap with approach is found: the rule of every stepping method.
    #[default]
    VelocityJump,
    /// When the gap closes within the step; the velocities jump there and the rest of the step follows from them.
    ///
    /// A pair is located once a step: where it comes back before the end, or touches from the start, the velocities
    /// jump after the step.
    Located,
}

/// One structure during a step.
struct Body<Memory> {
    memory: Memory,
    /// Instant of its state, counted from the start of the step \[s\].
    since: f64,
    /// Whether the structure gets a state at the present instant.
    due: bool,
    /// Impulses of the pounding forces at the end of the present span, from the left and from the right \[N·s\].
    impulses: (f64, f64),
}

/// A run: its state and all its memory, allocated once.
struct Scratch<Memory> {
    when: VerletImpacts,
    bodies: Vec<Body<Memory>>,
    /// Last states, after impacts.
    states: Vec<State>,
    /// States at the present instant.
    ends: Vec<State>,
    impacts: Impacts,
    /// The impulse of each push is that of the force at the end of its span, until the span is reported.
    pushes: Pushes,
    /// When the gap of each pair closes \[s\], counted from the start of the step; infinite if it does not close.
    closings: Vec<f64>,
    approaches: Approaches,
    /// `None` if all structures have one storey.
    dashpots: Option<Dashpots>,
}

/// Integrates a row. Every method has a `run` function with these arguments.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: Verlet,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    let begin = |ground: Ground<'_>| begin(settings, row, ground);
    march(row, excitation, course, 1, begin, recorder)
}

impl<Column: RestoringForce> Stepping<Column> for Scratch<Column::Memory> {
    #[inline]
    fn step<R: Recorder>(&mut self, row: &Row<Column>, step: ClockStep<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        let duration = step.clock.time_step;
        self.pushes.pass();
        if self.when == VerletImpacts::Located {
            self.locate(row, step, work, recorder)?;
        }
        for body in &mut self.bodies {
            body.due = true;
        }
        self.predict(duration);
        self.finish(row, step, duration, work, recorder)?;
        for body in &mut self.bodies {
            body.since = 0.0;
        }
        let ground = step.ground(step.number);
        self.approaches.forget_parted(row.pairs(), &self.states, ground);
        step.collide(row, &mut self.states, &mut self.impacts, work, recorder)?;
        Ok(())
    }
}

fn begin<Column: RestoringForce>(settings: Verlet, row: &Row<Column>, ground: Ground<'_>) -> Scratch<Column::Memory> {
    let (states, memories) = row.initial(ground);
    let body = |memory| Body {
        memory,
        since: 0.0,
        due: true,
        impulses: (0.0, 0.0),
    };
    Scratch {
        when: settings.impacts,
        bodies: memories.into_iter().map(body).collect(),
        ends: states.clone(),
        states,
        impacts: Impacts::new(row),
        pushes: Pushes::new(row.incidence()),
        closings: vec![f64::INFINITY; row.pairs().len()],
        approaches: Approaches::new(row.pairs().len()),
        dashpots: (!row.buildings().are_single()).then(|| Dashpots::new(row)),
    }
}

impl<Memory: Copy> Scratch<Memory> {
    /// Finds the impacts within a step in order of time, and applies the velocity jumps.
    fn locate<Column: RestoringForce<Memory = Memory>, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        step: ClockStep<'_>,
        work: &mut Work,
        recorder: &mut R,
    ) -> Result<(), RunError> {
        self.closings.fill(0.0);
        loop {
            for (pair, closing) in row.pairs().iter().zip(&mut self.closings) {
                // NaN marks a pair that was already located.
                if pair.law.impulsive().is_none() {
                    *closing = f64::INFINITY;
                } else if !closing.is_nan() {
                    *closing = closes(pair, &self.states, &self.bodies, step);
                }
            }
            let instant = self.closings.iter().copied().fold(f64::INFINITY, f64::min);
            if instant.is_infinite() {
                return Ok(());
            }
            self.predict(instant);
            self.gather(row, instant, step.at(instant).ground);
            self.finish(row, step, instant, work, recorder)?;
            for (touching, closing) in self.impacts.touching.iter().zip(&mut self.closings) {
                if *touching {
                    *closing = f64::NAN;
                    work.touching_steps += 1;
                }
            }
            self.impacts.jump(row, &mut self.states, step.at(instant), recorder)?;
        }
    }

    /// Displacements, and velocities to first order, at an instant counted from the start of the step.
    fn predict(&mut self, instant: f64) {
        for ((end, state), body) in self.ends.iter_mut().zip(&self.states).zip(&self.bodies) {
            let h = instant - body.since;
            *end = *state;
            end.displacement += h * (state.velocity + 0.5 * h * state.acceleration);
            end.velocity += h * state.acceleration;
        }
    }

    /// Chooses the structures that need a state at this instant: structures that are hit, and structures that touch them, with all their
    /// floors.
    fn gather<Column: RestoringForce>(&mut self, row: &Row<Column>, instant: f64, ground: Ground<'_>) {
        let pairs = row.pairs();
        for body in &mut self.bodies {
            body.due = false;
        }
        let Self { impacts, closings, .. } = self;
        for ((pair, touching), closing) in pairs.iter().zip(&mut impacts.touching).zip(closings) {
            *touching = *closing <= instant;
            if *touching {
                for (floor, _) in pair.relation.pushes() {
                    self.bodies[floor].due = true;
                }
            }
        }
        let mut grown = true;
        while std::mem::take(&mut grown) {
            let marks = self.impacts.touching.iter_mut();
            for ((index, pair), touching) in pairs.iter().enumerate().zip(marks) {
                let (left, right) = (self.bodies[pair.left()].due, self.bodies[pair.right()].due);
                let deformation = ground.deformation_of(pair, &self.ends);
                let closed = if pair.law.impulsive().is_some() {
                    deformation >= 0.0
                } else {
                    deformation > 0.0 || self.pushes.pushed(row.incidence(), index)
                };
                if (left || right) && closed {
                    grown |= !(left && right);
                    *touching = pair.law.impulsive().is_some();
                    for (floor, _) in pair.relation.pushes() {
                        self.bodies[floor].due = true;
                    }
                }
            }
            if self.dashpots.is_some() {
                let buildings = row.buildings();
                grown |= buildings.share(&mut self.bodies, |body| &mut body.due);
            }
        }
    }

    /// Gives every structure that is due its state at an instant for which it was predicted, and reports its span.
    fn finish<Column: RestoringForce<Memory = Memory>, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        step: ClockStep<'_>,
        instant: f64,
        work: &mut Work,
        recorder: &mut R,
    ) -> Result<(), RunError> {
        let Now { ground, time } = step.at(instant);
        row.push(&mut self.ends, &mut self.pushes, &mut self.approaches, ground);
        self.share(row, instant);
        if self.dashpots.is_some() {
            return self.finish_storeys(row, step, instant, work, recorder);
        }
        for (structure, node) in row.nodes().iter().enumerate() {
            let body = &mut self.bodies[structure];
            if !(body.due && instant > body.since) {
                continue;
            }
            let (start, end) = (&self.states[structure], &mut self.ends[structure]);
            if !end.displacement.is_finite() {
                return Err(step.diverged(structure));
            }
            let h = instant - body.since;
            let ground = ground.under(structure);
            body.memory = close(node, body, start, end, ground, h);
            work.force_evaluations += 1;
            let began = step.at(body.since);
            let start_ground = began.ground.under(structure);
            let loads = [(start, start_ground), (&*end, ground)].map(|(state, ground)| {
                let forces = StoreyForces {
                    restoring: state.restoring_force,
                    damping: node.damping * state.velocity,
                };
                Load::at(state, forces, ground)
            });
            let (times, ends) = ([began.time, time], [*start, *end]);
            let slots = row.incidence().slots_at(structure);
            self.pushes.start(slots.clone(), 0.5 * h);
            let weights = Weights::trapezoidal(0.5 * h);
            let mut span = Span::step(recorder.reads_weighed(), structure, times, ends, weights, loads);
            span.impulse_from_left = 0.5 * h * start.force_from_left + body.impulses.0;
            span.impulse_from_right = 0.5 * h * start.force_from_right + body.impulses.1;
            span.pushes = self.pushes.of(slots.clone());
            recorder.span(&span);
            self.pushes.go_on(slots);
            self.states[structure] = *end;
            body.since = instant;
        }
        Ok(())
    }

    /// Impulses of the pounding forces at an instant.
    ///
    /// The force of a pair acts on both structures for half the time since both last had a state. Another neighbour may have hit either of
    /// them since.
    fn share<Column: RestoringForce>(&mut self, row: &Row<Column>, instant: f64) {
        for body in &mut self.bodies {
            body.impulses = (0.0, 0.0);
        }
        for pair in 0..row.pairs().len() {
            let [left, right] = row.pairs()[pair].relation.points();
            let since = |floor: usize| self.bodies[floor].since;
            let half = 0.5 * (instant - since(left.floor()).max(since(right.floor())));
            let force = self.pushes.ends(row.incidence(), pair, half);
            if force == 0.0 {
                continue;
            }
            left.spread(force, |floor, force| {
                self.bodies[floor].impulses.1 -= half * force;
            });
            right.spread(force, |floor, force| {
                self.bodies[floor].impulses.0 += half * force;
            });
        }
    }
}

/// When the gap of a pair closes, counted from the start of the step; infinite if it does not close before the end or is closed from the
/// start.
fn closes<Memory>(pair: &Pair, states: &[State], bodies: &[Body<Memory>], step: ClockStep<'_>) -> f64 {
    let since = bodies[pair.left()].since.max(bodies[pair.right()].since);
    let h = |floor: usize| since - bodies[floor].since;
    let ahead = pair.relation.ahead(|floor| {
        let (state, h) = (&states[floor], h(floor));
        state.displacement + h * (state.velocity + 0.5 * h * state.acceleration)
    });
    let faster = |floor: usize| states[floor].velocity + h(floor) * states[floor].acceleration;
    let bends = |floor: usize| 0.5 * states[floor].acceleration;
    let (mut gap, mut rate) = (pair.gap() - ahead, pair.relation.ahead(faster));
    let mut curvature = pair.relation.ahead(bends);
    if !step.is_common() {
        let ground = step.at(since).ground;
        let opening = ground.opening(pair);
        gap -= opening.displacement;
        rate += opening.velocity;
        curvature += 0.5 * (ground.under(pair.left()) - ground.under(pair.right()));
    }
    let closing = Closing { gap, rate, curvature };
    let root = closing.instant();
    if gap >= 0.0 && since + root < step.clock.time_step {
        since + root
    } else {
        f64::INFINITY
    }
}

/// The state at the end of a span with known displacement and pounding forces; returns the memory of the columns.
fn close<Column: RestoringForce>(
    node: &Node<Column>,
    body: &Body<Column::Memory>,
    start: &State,
    end: &mut State,
    ground: f64,
    h: f64,
) -> Column::Memory {
    let response = node.column.respond(end.displacement, body.memory);
    let length = Length::new(h, node.inverse_mass * node.damping);
    let half_way = start.velocity + length.half * start.acceleration;
    let at_rest = State {
        restoring_force: response.force,
        ..State::default()
    };
    let smooth = node.acceleration(&at_rest, ground);
    let pushed = node.inverse_mass * (body.impulses.0 + body.impulses.1);
    end.restoring_force = response.force;
    end.velocity = length.velocity(half_way, smooth, pushed);
    end.acceleration = node.acceleration(end, ground);
    response.memory
}

/// The length of a span, for one structure.
#[derive(Clone, Copy)]
struct Length {
    /// Half of it, h/2 \[s\].
    half: f64,
    /// 1/(1 + h c/(2m)): the damping at the end belongs to the velocity at the end.
    solve: f64,
}

impl Length {
    /// The length of a span \[s\] for a structure with c/m \[1/s\].
    fn new(whole: f64, damping: f64) -> Self {
        let half = 0.5 * whole;
        Self {
            half,
            solve: 1.0 / (1.0 + half * damping),
        }
    }

    /// Velocity at the end \[m/s\].
    ///
    /// It follows from the velocity at mid-span \[m/s\], the acceleration by column and ground at the end \[m/s²\], and the contribution of
    /// the pounding force at the end \[m/s\].
    fn velocity(&self, half_way: f64, smooth: f64, pushed: f64) -> f64 {
        self.solve * (half_way + self.half * smooth + pushed)
    }
}

/// Two structures with quadratic motions.
struct Closing {
    /// Distance between them \[m\], ≥ 0.
    gap: f64,
    /// Rate at which it closes \[m/s\].
    rate: f64,
    /// Half of the relative acceleration \[m/s²\].
    curvature: f64,
}

impl Closing {
    /// Returns the x ≥ 0 at which rate·x + curvature·x² rises through the gap \[s\]; infinite if there is none.
    fn instant(&self) -> f64 {
        let Self { gap, rate, curvature } = *self;
        let discriminant = rate * rate + 4.0 * curvature * gap;
        if discriminant < 0.0 {
            return f64::INFINITY;
        }
        let root = discriminant.sqrt();
        // The form of the root without cancellation. It is 0/0 only for a path that stays in the gap.
        if rate > 0.0 {
            2.0 * gap / (rate + root)
        } else if curvature > 0.0 {
            (root - rate) / (2.0 * curvature)
        } else {
            f64::INFINITY
        }
    }
}
