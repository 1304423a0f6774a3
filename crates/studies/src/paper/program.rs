//! The paper's program, as its numbers show it to have been: a model of somebody's program, and no method to choose.
//!
//! Equations (1) to (4) of the paper leave choices open. [`Program`] names each; its default is what gives the printed numbers.
//! Structures have one storey and begin at rest. Order of a step i: forces of compliant pairs from the displacements of i and i − 1;
//! equation (3) for i + 1; overlaps at i + 1, whose impacts are forces of step i + 1.

use pounding_contact::{Overlap, reduced_mass};
use pounding_motion::Record;
use pounding_solver::{
    Clock, Impact, Pair, Path, Recorder, RestoringForce, Row, RunError, Span, State,
    TransferredMomentum, Velocities, Weighed,
};

/// The choices of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Program {
    /// How the first step begins.
    pub start: Start,
    /// Whether loads are rounded.
    pub loads: Loads,
    /// How long a run lasts.
    pub length: Length,
    /// Which overlaps of impulsive pairs are impacts.
    pub impacts: Impacts,
    /// The velocity of a structure that two pairs hit in one step.
    pub velocities: Shared,
    /// The force on it.
    pub forces: Joined,
}

/// How the first step begins; u₋₁ is the displacement one step before t = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// u₋₁ = u₀ = 0.
    FirstLoadUsed,
    /// u₀ = u₁ = 0; the first equation is that of step 1.
    FirstLoadSkipped,
    /// u₀ = 0 and u₋₁ = Δt² ü₀/2, as textbooks begin.
    Consistent,
}

/// Whether loads are rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Loads {
    /// To five decimals of m/s².
    Rounded,
    /// Not at all.
    AsRecorded,
}

/// How long a run lasts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Length {
    /// The loads end, and the run goes on for as long again, until the motion has died out.
    RunsOn,
    /// As long as the loads.
    OfLoads,
}

/// Which overlaps of impulsive pairs are impacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Impacts {
    /// All, so that a pair that parts is pulled together.
    AnyOverlap,
    /// Those of pairs that approach.
    OnApproach,
}

/// The velocity of a structure that two pairs hit in one step, as the second pair sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shared {
    /// That after the impact of the first.
    HandedOn,
    /// That before both.
    Before,
}

/// The force on a structure that two pairs touch in one step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Joined {
    /// That of the second alone: it replaces the other.
    Replaced,
    /// The sum.
    Added,
}

impl Program {
    /// What gives the printed numbers, with one of the two starts.
    pub const fn printed(start: Start) -> Self {
        Self {
            start,
            loads: Loads::Rounded,
            length: Length::RunsOn,
            impacts: Impacts::AnyOverlap,
            velocities: Shared::HandedOn,
            forces: Joined::Replaced,
        }
    }

    /// The method as the paper describes it.
    pub const DESCRIBED: Self = Self {
        start: Start::Consistent,
        loads: Loads::AsRecorded,
        length: Length::OfLoads,
        impacts: Impacts::OnApproach,
        velocities: Shared::Before,
        forces: Joined::Added,
    };

    /// Runs a row under a record, loaded on a clock; `seen` is told what pairs do, each for itself, `momentum` the forces that act.
    ///
    /// # Errors
    /// [`RunError::Diverged`] when a displacement is no longer a finite number.
    pub(crate) fn run<Column: RestoringForce, R: Recorder>(
        self,
        row: &Row<Column>,
        (record, loaded): (&Record, Clock),
        recorders: (&mut R, &mut TransferredMomentum),
    ) -> Result<(), RunError> {
        Run::new(self, row, loaded.time_step).run(record, loaded, recorders)
    }

    /// The accelerations \[m/s²\] of the steps that are loaded, from t = 0 on, `loaded` of them \[s\].
    ///
    /// With the step of the record its samples, the one at the end too; with a shorter one, that one is left out, and those between
    /// are means of rounded neighbours.
    fn accelerations(self, record: &Record, clock: Clock) -> Vec<f64> {
        let rounded = |sample: &f64| match self.loads {
            Loads::Rounded => (sample * 1e5).round() / 1e5,
            Loads::AsRecorded => *sample,
        };
        let samples: Vec<f64> = record.samples().iter().map(rounded).collect();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "scenes are refused whose step does not divide their record's"
        )]
        let per_sample = (record.time_step() / clock.time_step).round() as usize;
        let n_steps = clock.n_steps + usize::from(per_sample == 1);
        let at = |step: usize| {
            let sample = |index: usize| samples.get(index).copied().unwrap_or(0.0);
            let (index, rest) = (step / per_sample, step % per_sample);
            let part = rest as f64 / per_sample as f64;
            (1.0 - part) * sample(index) + part * sample(index + 1)
        };
        (0..n_steps).map(at).collect()
    }
}

/// What the program carries of a structure from step to step.
struct Body<Memory> {
    mass: f64,
    /// Displacements of the step before, of this one and of the next \[m\].
    displacements: [f64; 3],
    memory: Memory,
    /// Forces of compliant neighbours at this step \[N\].
    from_left: f64,
    from_right: f64,
    /// Net pounding force that acts at this step, and what impacts add at the next \[N\].
    acting: f64,
    coming: f64,
    /// The step before, to be reported, and the force that acted at it.
    last: State,
    last_acting: f64,
}

impl<Memory> Body<Memory> {
    /// Velocity at this step \[m/s\].
    fn velocity(&self, time_step: f64) -> f64 {
        (self.displacements[2] - self.displacements[0]) / (2.0 * time_step)
    }
}

/// A run of the program over a row.
struct Run<'a, Column: RestoringForce> {
    program: Program,
    row: &'a Row<Column>,
    time_step: f64,
    bodies: Vec<Body<Column::Memory>>,
    /// Impacts that are forces of the next step.
    hits: Vec<Impact>,
}

impl<'a, Column: RestoringForce> Run<'a, Column> {
    fn new(program: Program, row: &'a Row<Column>, time_step: f64) -> Self {
        let body = |node: &pounding_solver::Node<Column>| Body {
            mass: 1.0 / node.inverse_mass,
            displacements: [0.0; 3],
            memory: node.column.untouched(),
            from_left: 0.0,
            from_right: 0.0,
            acting: 0.0,
            coming: 0.0,
            last: State::default(),
            last_acting: 0.0,
        };
        Self {
            program,
            row,
            time_step,
            bodies: row.nodes().iter().map(body).collect(),
            hits: Vec::new(),
        }
    }

    fn run<R: Recorder>(
        mut self,
        record: &Record,
        loaded: Clock,
        (seen, momentum): (&mut R, &mut TransferredMomentum),
    ) -> Result<(), RunError> {
        let accelerations = self.program.accelerations(record, loaded);
        let n_steps = match self.program.length {
            Length::RunsOn => 2 * loaded.n_steps,
            Length::OfLoads => loaded.n_steps,
        };
        let first = match self.program.start {
            Start::FirstLoadUsed | Start::Consistent => 0,
            Start::FirstLoadSkipped => 1,
        };
        if self.program.start == Start::Consistent {
            for body in &mut self.bodies {
                body.displacements[0] = -0.5 * self.time_step * self.time_step * accelerations[0];
            }
        }
        for step in first..=n_steps {
            let acceleration = accelerations.get(step).copied().unwrap_or(0.0);
            self.push();
            self.advance(acceleration);
            self.check(loaded.time(step + 1))?;
            let times = [step.saturating_sub(1), step].map(|step| loaded.time(step));
            self.report(times, (seen, momentum));
            self.hit(loaded.time(step + 1));
            for body in &mut self.bodies {
                let [_, here, next] = body.displacements;
                body.displacements = [here, next, next];
            }
        }
        Ok(())
    }

    /// Whether all displacements of the next step, which ends at a time \[s\], are finite.
    fn check(&self, time: f64) -> Result<(), RunError> {
        let diverged = |body: &Body<_>| !body.displacements[2].is_finite();
        match self.bodies.iter().position(diverged) {
            Some(structure) => Err(RunError::Diverged {
                structure,
                time,
                time_step: self.time_step,
            }),
            None => Ok(()),
        }
    }

    /// Forces of compliant pairs at this step.
    fn push(&mut self) {
        for body in &mut self.bodies {
            (body.from_left, body.from_right) = (0.0, 0.0);
            body.acting = std::mem::take(&mut body.coming);
        }
        for pair in self.row.pairs() {
            let [before, here] = [0, 1].map(|at| self.deformation(pair, at));
            if here <= 0.0 {
                continue;
            }
            let rate = (here - before) / self.time_step;
            let overlap = Overlap {
                deformation: here,
                rate,
                reduced_mass: self.reduced_mass(pair),
                approach_speed: rate.max(0.0),
            };
            if let Some(contact) = pair.law.respond(&overlap) {
                self.bodies[pair.left].from_right = -contact.force;
                self.bodies[pair.right].from_left = contact.force;
                self.act(pair, contact.force, |body| &mut body.acting);
            }
        }
    }

    /// Equation (3).
    fn advance(&mut self, acceleration: f64) {
        let dt = self.time_step;
        for (body, node) in self.bodies.iter_mut().zip(self.row.nodes()) {
            let [before, here, _] = body.displacements;
            let response = node.column.respond(here, body.memory);
            let (inertia, damping) = (body.mass / (dt * dt), node.damping / (2.0 * dt));
            let load = body.acting - body.mass * acceleration - response.force;
            let carried = 2.0 * inertia * here - (inertia - damping) * before;
            body.displacements[2] = (load + carried) / (inertia + damping);
            body.memory = response.memory;
        }
    }

    /// Impacts of impulsive pairs that overlap at the next step.
    fn hit(&mut self, time: f64) {
        let dt = self.time_step;
        let before: Vec<f64> = self.bodies.iter().map(|body| body.velocity(dt)).collect();
        let mut velocities = before.clone();
        for (index, pair) in self.row.pairs().iter().enumerate() {
            let Some(law) = pair.law.impulsive() else {
                continue;
            };
            let seen = match self.program.velocities {
                Shared::HandedOn => &velocities,
                Shared::Before => &before,
            };
            let rate = seen[pair.left] - seen[pair.right];
            let meets = match self.program.impacts {
                Impacts::AnyOverlap => true,
                Impacts::OnApproach => rate > 0.0,
            };
            if self.deformation(pair, 2) <= 0.0 || !meets {
                continue;
            }
            let impulse = law.impulse(rate, self.reduced_mass(pair));
            self.act(pair, impulse / dt, |body| &mut body.coming);
            let of = |velocities: &[f64]| Velocities {
                left: velocities[pair.left],
                right: velocities[pair.right],
            };
            let earlier = of(seen);
            velocities[pair.left] = earlier.left - impulse / self.bodies[pair.left].mass;
            velocities[pair.right] = earlier.right + impulse / self.bodies[pair.right].mass;
            self.hits.push(Impact {
                pair: index,
                left: pair.left,
                right: pair.right,
                time,
                impulse,
                before: earlier,
                after: of(&velocities),
                opening_rate: 0.0,
            });
        }
    }

    /// Gives the neighbours of a pair its force; one that the pair to its left has pushed already gets both or this one alone.
    fn act(&mut self, pair: &Pair, force: f64, on: impl Fn(&mut Body<Column::Memory>) -> &mut f64) {
        *on(&mut self.bodies[pair.right]) += force;
        let left = on(&mut self.bodies[pair.left]);
        *left = match self.program.forces {
            Joined::Replaced => -force,
            Joined::Added => *left - force,
        };
    }

    /// Deformation of a pair \[m\] at the step before, at this one or at the next.
    fn deformation(&self, pair: &Pair, at: usize) -> f64 {
        let of = |structure: usize| self.bodies[structure].displacements[at];
        of(pair.left) - of(pair.right) - pair.gap
    }

    fn reduced_mass(&self, pair: &Pair) -> f64 {
        let [left, right] =
            [pair.left, pair.right].map(|structure| self.row.nodes()[structure].inverse_mass);
        reduced_mass(left, right)
    }

    /// Reports the motion since the step before, and the impacts of this step.
    fn report<R: Recorder>(
        &mut self,
        [start_time, end_time]: [f64; 2],
        (seen, momentum): (&mut R, &mut TransferredMomentum),
    ) {
        let (dt, row) = (self.time_step, self.row);
        for (structure, (body, node)) in self.bodies.iter_mut().zip(row.nodes()).enumerate() {
            let [before, here, next] = body.displacements;
            let end = State {
                displacement: here,
                velocity: body.velocity(dt),
                acceleration: (next - 2.0 * here + before) / (dt * dt),
                // What the columns remember is of this step: they answer the same once more.
                restoring_force: node.column.respond(here, body.memory).force,
                force_from_left: body.from_left,
                force_from_right: body.from_right,
            };
            let start = body.last;
            if end_time > start_time {
                let mean = |one: f64, other: f64| 0.5 * dt * (one + other);
                let span = Span {
                    structure,
                    start_time,
                    end_time,
                    start,
                    end,
                    impulse_from_left: mean(start.force_from_left, end.force_from_left),
                    impulse_from_right: mean(start.force_from_right, end.force_from_right),
                    below: None,
                    path: Path::Cubic(Weighed::default()),
                };
                seen.span(&span);
                let acts = |state: State, force: f64| State {
                    force_from_left: force,
                    force_from_right: 0.0,
                    ..state
                };
                momentum.span(&Span {
                    start: acts(start, body.last_acting),
                    end: acts(end, body.acting),
                    impulse_from_left: mean(body.last_acting, body.acting),
                    impulse_from_right: 0.0,
                    ..span
                });
            }
            body.last = end;
            body.last_acting = body.acting;
        }
        for impact in self.hits.drain(..) {
            seen.impact(&impact);
        }
    }
}
