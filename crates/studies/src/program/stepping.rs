//! The steps of the paper's [`Program`].
//!
//! Structures have one storey and begin at rest. A step i has three parts, in this order:
//!
//! 1. Forces of compliant pairs, from the displacements of steps i and i − 1.
//! 2. Equation (3) for the displacements of step i + 1.
//! 3. Overlaps at step i + 1. Their impacts are forces of step i + 1.

use pounding_contact::{Overlap, reduced_mass};
use pounding_motion::Record;
use pounding_solver::{
    Clock, Impact, Pair, Path, Push, Recorder, RestoringForce, Row, RunError, Span, State, Struck, TransferredMomentum, Velocities, Weighed,
};

use super::choices::{Choice, Program, Start};

/// State of a structure between steps.
struct Body<Memory> {
    mass: f64,
    /// Displacements at the previous, the current and the next step \[m\].
    displacements: [f64; 3],
    memory: Memory,
    /// Forces of compliant neighbours at this step \[N\].
    from_left: f64,
    from_right: f64,
    /// Net pounding force at this step, and the force of impacts at the next one \[N\].
    force: f64,
    next_force: f64,
    /// Velocities at this step: before its impacts, and after the impacts so far \[m/s\].
    velocities: [f64; 2],
    /// State at the previous step, not yet reported, and the force that acted then \[N\].
    last: State,
    last_force: f64,
}

impl<Memory> Body<Memory> {
    /// Velocity at this step \[m/s\].
    fn velocity(&self, time_step: f64) -> f64 {
        (self.displacements[2] - self.displacements[0]) / (2.0 * time_step)
    }
}

/// A run of the program over a row.
pub(super) struct Stepping<'a, Column: RestoringForce> {
    program: Program,
    row: &'a Row<Column>,
    time_step: f64,
    bodies: Vec<Body<Column::Memory>>,
    /// Impacts that act as forces in the next step.
    hits: Vec<Impact>,
    /// Actions of pairs on a structure over a step.
    pushes: Vec<Push<'static>>,
}

impl<'a, Column: RestoringForce> Stepping<'a, Column> {
    pub(super) fn new(program: Program, row: &'a Row<Column>, time_step: f64) -> Self {
        let body = |node: &pounding_solver::Node<Column>| Body {
            mass: 1.0 / node.inverse_mass,
            displacements: [0.0; 3],
            memory: node.column.untouched(),
            from_left: 0.0,
            from_right: 0.0,
            force: 0.0,
            next_force: 0.0,
            velocities: [0.0; 2],
            last: State::default(),
            last_force: 0.0,
        };
        Self {
            program,
            row,
            time_step,
            bodies: row.nodes().iter().map(body).collect(),
            hits: Vec::new(),
            pushes: Vec::new(),
        }
    }

    pub(super) fn run<R: Recorder>(
        mut self,
        record: &Record,
        loaded: Clock,
        seen: &mut R,
        momentum: &mut TransferredMomentum,
    ) -> Result<(), RunError> {
        let accelerations = self.program.accelerations(record, loaded);
        let times_loads = if self.program.is_described(Choice::Length) { 1 } else { 2 };
        let n_steps = times_loads * loaded.n_steps;
        let first = usize::from(self.program.start == Start::FirstLoadSkipped);
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
            self.report(times, seen, momentum);
            self.hit(loaded.time(step + 1));
            for body in &mut self.bodies {
                let [_, here, next] = body.displacements;
                body.displacements = [here, next, next];
            }
        }
        Ok(())
    }

    /// Checks that all displacements of the next step are finite; `time` \[s\] is the end of that step.
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
            body.force = std::mem::take(&mut body.next_force);
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
                self.bodies[pair.left()].from_right = -contact.force;
                self.bodies[pair.right()].from_left = contact.force;
                self.add_force(pair, contact.force, |body| &mut body.force);
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
            let load = body.force - body.mass * acceleration - response.force;
            let carried = 2.0 * inertia * here - (inertia - damping) * before;
            body.displacements[2] = (load + carried) / (inertia + damping);
            body.memory = response.memory;
        }
    }

    /// Impacts of impulsive pairs that overlap at the next step.
    fn hit(&mut self, time: f64) {
        let dt = self.time_step;
        for body in &mut self.bodies {
            body.velocities = [body.velocity(dt); 2];
        }
        for (index, pair) in self.row.pairs().iter().enumerate() {
            let Some(law) = pair.law.impulsive() else {
                continue;
            };
            let [left, right] = [pair.left(), pair.right()].map(|one| self.seen(one));
            let rate = left - right;
            let meets = rate > 0.0 || !self.program.is_described(Choice::Impacts);
            if self.deformation(pair, 2) <= 0.0 || !meets {
                continue;
            }
            let impulse = law.impulse(rate, self.reduced_mass(pair));
            self.add_force(pair, impulse / dt, |body| &mut body.next_force);
            let after = Velocities {
                left: left - impulse / self.bodies[pair.left()].mass,
                right: right + impulse / self.bodies[pair.right()].mass,
            };
            self.bodies[pair.left()].velocities[1] = after.left;
            self.bodies[pair.right()].velocities[1] = after.right;
            let struck = |floor, part, velocities| Struck { floor, part, velocities };
            self.hits.push(Impact {
                pair: index,
                left: pair.left(),
                right: pair.right(),
                floors: [
                    Some(struck(pair.left(), -1.0, [left, after.left])),
                    Some(struck(pair.right(), 1.0, [right, after.right])),
                    None,
                    None,
                ],
                time,
                impulse,
                before: Velocities { left, right },
                after,
                opening_rate: 0.0,
            });
        }
    }

    /// The velocity of a structure at this step as a pair sees it \[m/s\].
    fn seen(&self, structure: usize) -> f64 {
        let [before, after] = self.bodies[structure].velocities;
        if self.program.is_described(Choice::Velocities) {
            before
        } else {
            after
        }
    }

    /// Applies the force of a pair to both neighbours. The left one may already have a force of the pair to its left: that force is added
    /// or replaced.
    fn add_force(&mut self, pair: &Pair, force: f64, on: impl Fn(&mut Body<Column::Memory>) -> &mut f64) {
        *on(&mut self.bodies[pair.right()]) += force;
        let left = on(&mut self.bodies[pair.left()]);
        let kept = if self.program.is_described(Choice::Forces) { *left } else { 0.0 };
        *left = kept - force;
    }

    /// Deformation of a pair at the previous, the current or the next step \[m\].
    fn deformation(&self, pair: &Pair, at: usize) -> f64 {
        let of = |structure: usize| self.bodies[structure].displacements[at];
        of(pair.left()) - of(pair.right()) - pair.gap()
    }

    fn reduced_mass(&self, pair: &Pair) -> f64 {
        let [left, right] = [pair.left(), pair.right()].map(|structure| self.row.nodes()[structure].inverse_mass);
        reduced_mass(left, right)
    }

    /// Reports the motion since the previous step, and the impacts of this step.
    fn report<R: Recorder>(&mut self, [start_time, end_time]: [f64; 2], seen: &mut R, momentum: &mut TransferredMomentum) {
        let (dt, row) = (self.time_step, self.row);
        for (structure, (body, node)) in self.bodies.iter_mut().zip(row.nodes()).enumerate() {
            let [before, here, next] = body.displacements;
            let end = State {
                displacement: here,
                velocity: body.velocity(dt),
                acceleration: (next - 2.0 * here + before) / (dt * dt),
                // The memory of the columns is already that of this step, so this call gives the force of the step again.
                restoring_force: node.column.respond(here, body.memory).force,
                force_from_left: body.from_left,
                force_from_right: body.from_right,
            };
            let start = body.last;
            if end_time > start_time {
                let mean = |one: f64, other: f64| 0.5 * dt * (one + other);
                list_pushes(&mut self.pushes, row, structure, [start, end], dt);
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
                    pushes: &self.pushes,
                    links: &[],
                };
                seen.span(&span);
                let acts = |state: State, force: f64| State {
                    force_from_left: force,
                    force_from_right: 0.0,
                    ..state
                };
                momentum.span(&Span {
                    start: acts(start, body.last_force),
                    end: acts(end, body.force),
                    impulse_from_left: mean(body.last_force, body.force),
                    impulse_from_right: 0.0,
                    ..span
                });
            }
            body.last = end;
            body.last_force = body.force;
        }
        for impact in self.hits.drain(..) {
            seen.impact(&impact);
        }
    }
}

/// Lists the actions of the pairs on a structure over a step, at most one on each side.
fn list_pushes<Column: RestoringForce>(pushes: &mut Vec<Push<'_>>, row: &Row<Column>, structure: usize, ends: [State; 2], time_step: f64) {
    pushes.clear();
    for (pair, of) in row.pairs().iter().enumerate() {
        if ![of.left(), of.right()].contains(&structure) {
            continue;
        }
        let on_left = of.left() == structure;
        let forces = ends.map(|state| if on_left { -state.force_from_right } else { state.force_from_left });
        pushes.push(Push {
            pair,
            on_left,
            part: 1.0,
            forces,
            impulse: 0.5 * time_step * (forces[0] + forces[1]),
            series: &[],
        });
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::StudyFile;
    use pounding_scene::Simulation;

    fn prepared(study: &str, scene: usize) -> Simulation {
        let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
        let file = StudyFile::read(&studies.join(study).with_extension("json"));
        let file = file.expect("a readable study");
        Simulation::new(&file.study.scenes[scene], file.base()).expect("a good scene")
    }

    /// Without its slips the program equals the central difference method if all forces are compliant.
    #[test]
    fn limit_as_described_it_is_the_central_difference_method() {
        for (study, scene) in [("table-4", 0), ("table-4", 1), ("table-7", 0), ("table-7", 4)] {
            let prepared = prepared(study, scene);
            let by_program = Program::DESCRIBED.run(&prepared, None);
            let by_program = by_program.expect("a run");
            let by_method = prepared.run(None).expect("a run");
            for floor in 0..prepared.floors().all().len() {
                let [one, other] = [&by_program, &by_method].map(|run| run.momentum.of(floor));
                let [first, second] = [&by_program, &by_method].map(|run| run.peaks.of(floor).displacement.value);
                assert!((first / second - 1.0).abs() < 1e-9, "{study}: {first} {second}");
                assert!((one - other).abs() <= 1e-9 * other, "{study}: {one} {other}");
            }
        }
    }

    #[test]
    fn reference_loads_are_rounded_and_those_between_are_means() {
        let record = Record::new(0.01, vec![0.123_456_7, -0.1, 0.000_004, 9.0], "three");
        let record = record.expect("a record");
        let clock = |time_step: f64, n_steps: usize| Clock { time_step, n_steps };
        let printed = Program::printed(Start::FirstLoadUsed);
        let loads = |program: Program, clock| program.accelerations(&record, clock);
        assert_eq!(loads(printed, clock(0.01, 2)), [0.12346, -0.1, 0.0]);
        let halves = [0.12346, 0.5 * 0.12346 - 0.5 * 0.1, -0.1, -0.05];
        assert_eq!(loads(printed, clock(0.005, 4)), halves);
        let used = printed.with_described(Choice::LastLoad).with_described(Choice::Loads);
        assert_eq!(loads(used, clock(0.005, 4)).last(), Some(&0.000_004));
    }

    /// Layout A elastic, stereomechanical: a parting pair is pulled together, and the middle structure gets one of its two forces.
    #[test]
    fn reference_slips_show_in_impacts_and_forces() {
        let prepared = prepared("table-6", 0);
        let printed = Program::printed(Start::FirstLoadUsed);
        let run = |program: Program| program.run(&prepared, None).expect("a run");
        let pulls = |program| {
            let all = run(program);
            let mut collisions = all.collisions.all().iter();
            collisions.any(|one| one.impulse < 0.0)
        };
        assert!(pulls(printed));
        assert!(!pulls(printed.with_described(Choice::Impacts)));
        let [replaced, added] = [printed, printed.with_described(Choice::Forces)].map(|program| run(program).momentum.of(1));
        assert!((replaced - 1170.774e3).abs() < 1.0, "{replaced}");
        assert!((added - 1157.182e3).abs() < 1.0, "{added}");
    }
}
