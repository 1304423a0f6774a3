//! Newmark's method with Newton iterations and a consistent tangent.
//!
//! Source: N. M. Newmark, *J. Engng Mech. Div. ASCE* 85 (1959) 67; Chopra, *Dynamics of Structures*, 5.4 and 5.7. The
//! paper compares itself with a result of this method at Δt = 0.005 s.

use crate::error::require;
use crate::impact::impacts::Impacts;
use crate::implicit::cluster::{Alone, Line};
use crate::implicit::clusters::Clusters;
use crate::implicit::equation::{Cluster, Failure, Slopes};
use crate::implicit::newton::{self};
use crate::implicit::trial::{PairTrial, TOLERANCE, Trial};
use crate::model::approach::speed;
use crate::model::ground::Ground;
use crate::span::{Load, Pushes};
use crate::{
    Clock, Course, Excitation, Recorder, RestoringForce, Row, RunError, Span, State, Work,
};

/// Settings of Newmark's method: u and u̇ follow from the accelerations at both ends of a step.
///
/// Average acceleration is β = 1/4, γ = 1/2 ([`Newmark::AVERAGE_ACCELERATION`]); linear acceleration is β = 1/6,
/// γ = 1/2 ([`Newmark::LINEAR_ACCELERATION`]). Order 2 for γ = 1/2, else 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newmark {
    /// β \[–\], 0 ..= 1/2.
    pub beta: f64,
    /// γ \[–\], 1/2 ..= 1; below 1/2 the method amplifies.
    pub gamma: f64,
}

impl Newmark {
    /// Constant average acceleration, unconditionally stable for linear structures.
    pub const AVERAGE_ACCELERATION: Self = Self {
        beta: 0.25,
        gamma: 0.5,
    };
    /// Linear acceleration, stable for Δt < 0.551 T.
    pub const LINEAR_ACCELERATION: Self = Self {
        beta: 1.0 / 6.0,
        gamma: 0.5,
    };

    pub(crate) fn check(&self) -> Result<(), RunError> {
        require(
            (0.0..=0.5).contains(&self.beta),
            "beta",
            self.beta,
            "0 to 0.5",
        )?;
        require(
            (0.5..=1.0).contains(&self.gamma),
            "gamma",
            self.gamma,
            "0.5 to 1",
        )
    }
}

/// Scratch of an implicit run: everything a step needs, allocated once.
pub(crate) struct Scratch<Memory> {
    /// State at the start of the step, after impacts.
    pub(crate) states: Vec<State>,
    /// State at its end, before impacts.
    pub(crate) ends: Vec<State>,
    pub(crate) trials: Vec<Trial<Memory>>,
    /// The same of the pairs.
    pub(crate) pairs: Vec<PairTrial>,
    pub(crate) pushes: Pushes,
    /// Which pairs overlap during the step.
    pub(crate) touching: Vec<bool>,
    /// Nothing in a row of structures of one storey.
    pub(crate) clusters: Option<Clusters>,
    pub(crate) impacts: Impacts,
}

/// Integrates a row; the shared signature of all methods.
///
/// Each building finds its equilibrium alone; those that then overlap do it again together. A cluster grows while it
/// overlaps further neighbours, and nothing outside a cluster changes its bits. Impulsive laws act at the end of the
/// step in which an overlap with approach is found, as a jump of the velocities.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: Newmark,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    let clock = course.clock;
    settings.check()?;
    let dt = clock.time_step;
    let guard = course.begin(row.nodes().len());
    let shaking = row.shaken(excitation, clock);
    let slopes = Slopes {
        displacement: settings.beta * dt * dt,
        velocity: settings.gamma * dt,
        inertia: 1.0,
        time_step: dt,
    };
    let mut scratch = begin(row, shaking.at(0));
    let mut work = Work::default();
    // The trapezoidal rule where γ = 1/2.
    let weights = (0.5 * dt, [2.0 - 2.0 * settings.gamma, 2.0 * settings.gamma]);
    for step in 1..=clock.n_steps {
        guard.step(step, clock)?;
        let at_ends = [step - 1, step].map(|node| shaking.at(node));
        for (state, trial) in scratch.states.iter().zip(&mut scratch.trials) {
            trial.predicted = (
                state.displacement
                    + dt * (state.velocity + dt * (0.5 - settings.beta) * state.acceleration),
                state.velocity + dt * (1.0 - settings.gamma) * state.acceleration,
            );
        }
        let time = clock.time(step);
        balance(row, &mut scratch, slopes, at_ends, time, &mut work)?;
        arrive(&mut scratch, clock, step)?;
        commit(row, &mut scratch, clock, step, recorder, |node, ends| {
            let load =
                |index: usize| load::<_, R>(row, node, ends[index], at_ends[index].under(node));
            (weights, [load(0), load(1)])
        });
        work.touching_steps += row.n_overlaps(&scratch.states, at_ends[1]);
        let instant = (at_ends[1], time);
        scratch
            .impacts
            .after_step(row, &mut scratch.states, instant, recorder)?;
        work.steps += 1;
    }
    Ok(work)
}

/// State of every structure at t = 0, accelerations from equilibrium.
pub(crate) fn begin<Column: RestoringForce>(
    row: &Row<Column>,
    ground: Ground<'_>,
) -> Scratch<Column::Memory> {
    let (states, memories) = row.initial(ground);
    let trial = |(state, memory): (&State, Column::Memory)| Trial {
        acceleration: state.acceleration,
        ..Trial::new(memory)
    };
    let trials = states.iter().zip(memories).map(trial).collect();
    Scratch {
        ends: states.clone(),
        states,
        trials,
        pairs: vec![PairTrial::default(); row.pairs().len()],
        pushes: Pushes::new(row.incidence()),
        touching: vec![false; row.pairs().len()],
        clusters: Clusters::new(row),
        impacts: Impacts::new(row),
    }
}

/// Equilibrium at the end of a step, of which the ground is known at both ends: every building alone first, then the
/// clusters that touch.
pub(crate) fn balance<Column: RestoringForce>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    slopes: Slopes,
    ground: [Ground<'_>; 2],
    time: f64,
    work: &mut Work,
) -> Result<(), RunError> {
    let Scratch {
        states,
        trials,
        pairs,
        touching,
        clusters,
        ..
    } = scratch;
    let mut equation = Equation {
        row,
        trials,
        pairs,
        step: (slopes, ground[1]),
        time,
        work,
    };
    match clusters {
        None => {
            for index in 0..row.nodes().len() {
                equation.solve(Line {
                    nodes: index..index + 1,
                    pairs: 0..0,
                })?;
            }
        }
        Some(Clusters { buildings, .. }) => {
            for building in 0..buildings.len() {
                let floors = buildings.floors(building);
                equation.solve(Alone { floors })?;
            }
        }
    }
    for (pair, known) in row.pairs().iter().zip(&mut *equation.pairs) {
        if ground[0].deformation_of(pair, states) <= 0.0 {
            known.approach_speed = None;
        }
    }
    touching.fill(false);
    while equation.mark_overlaps(touching) {
        match clusters {
            None => equation.solve_lines(touching)?,
            Some(clusters) => equation.solve_clusters(clusters, touching)?,
        }
    }
    Ok(())
}

/// What every cluster of a step is solved with.
struct Equation<'a, Column: RestoringForce> {
    row: &'a Row<Column>,
    trials: &'a mut [Trial<Column::Memory>],
    pairs: &'a mut [PairTrial],
    /// The step and the ground at its end.
    step: (Slopes, Ground<'a>),
    time: f64,
    work: &'a mut Work,
}

impl<Column: RestoringForce> Equation<'_, Column> {
    #[inline]
    fn solve<C: Cluster>(&mut self, mut cluster: C) -> Result<(), RunError> {
        let (trials, pairs) = (&mut *self.trials, &mut *self.pairs);
        newton::solve(self.row, trials, pairs, &mut cluster, self.step, self.work)
            .map_err(|failure| self.error(failure, &cluster))
    }

    /// Equilibrium of structures that touch.
    fn solve_lines(&mut self, touching: &[bool]) -> Result<(), RunError> {
        let pairs = self.row.pairs();
        let mut pair = 0;
        while pair < pairs.len() {
            if !touching[pair] {
                pair += 1;
                continue;
            }
            let start = pair;
            let first = pairs[pair].left();
            let mut last = pairs[pair].right();
            pair += 1;
            while pair < pairs.len() && touching[pair] && pairs[pair].left() == last {
                last = pairs[pair].right();
                pair += 1;
            }
            self.solve(Line {
                nodes: first..last + 1,
                pairs: start..pair,
            })?;
        }
        Ok(())
    }

    /// Equilibrium of buildings that touch.
    fn solve_clusters(
        &mut self,
        clusters: &mut Clusters,
        touching: &[bool],
    ) -> Result<(), RunError> {
        clusters.join(marked(self.row, touching));
        for building in 0..clusters.buildings.len() {
            let incidence = self.row.incidence();
            if clusters.gather(incidence, building, |pair| touching[pair]) {
                match clusters.line() {
                    Some(line) => self.solve(line)?,
                    None => self.solve(clusters.joined(self.row, |_| true))?,
                }
            }
        }
        Ok(())
    }

    /// Marks the compliant pairs that overlap and were not marked yet; true when there are any.
    ///
    /// Those that touch first approach as they do without each other's force.
    fn mark_overlaps(&mut self, touching: &mut [bool]) -> bool {
        let (trials, ground) = (&*self.trials, self.step.1);
        let mut grown = false;
        for (index, pair) in self.row.pairs().iter().enumerate() {
            if touching[index] || !pair.law.is_compliant() {
                continue;
            }
            let ahead = pair.relation.ahead(|floor| trials[floor].displacement);
            if ground.deformation(pair, ahead) > 0.0 {
                let faster = pair.relation.ahead(|floor| trials[floor].velocity);
                let rate = ground.rate(pair, faster);
                speed(&mut self.pairs[index].approach_speed, rate);
                touching[index] = true;
                grown = true;
            }
        }
        grown
    }

    /// Why a run ends that did not find the equilibrium of a cluster.
    fn error(&self, failure: Failure, cluster: &impl Cluster) -> RunError {
        let time = self.time;
        match failure {
            Failure::NotFinite { structure } => RunError::Diverged {
                structure,
                time,
                time_step: self.step.0.time_step,
            },
            Failure::NotConverged {
                iterations,
                residual,
            } => RunError::NotConverged {
                first: cluster.nodes().min().unwrap_or(0),
                last: cluster.nodes().max().unwrap_or(0),
                time,
                iterations,
                residual,
                allowed: TOLERANCE,
            },
        }
    }
}

/// A floor on either side of the pairs that are marked.
pub(crate) fn marked<Column: RestoringForce>(
    row: &Row<Column>,
    marks: &[bool],
) -> impl Iterator<Item = (usize, usize)> {
    let pairs = row.pairs().iter().zip(marks);
    pairs.filter_map(|(pair, marked)| marked.then_some((pair.left(), pair.right())))
}

/// Takes over the states at the end of a step.
pub(crate) fn arrive<Memory: Copy>(
    scratch: &mut Scratch<Memory>,
    clock: Clock,
    step: usize,
) -> Result<(), RunError> {
    let ends = scratch.ends.iter_mut().zip(&scratch.trials);
    for (structure, (end, trial)) in ends.enumerate() {
        *end = trial.state();
        if !end.displacement.is_finite() {
            return Err(RunError::Diverged {
                structure,
                time: clock.time(step),
                time_step: clock.time_step,
            });
        }
    }
    Ok(())
}

/// What acts on a node, as much of it as a recorder reads.
#[inline]
pub(crate) fn load<Column: RestoringForce, R: Recorder>(
    row: &Row<Column>,
    node: usize,
    states: &[State],
    ground: f64,
) -> Load {
    let velocity = |index: usize| states[index].velocity;
    load_at::<_, R>(row, node, states, ground, velocity)
}

/// The same with damping at other velocities than those of the states.
#[inline]
pub(crate) fn load_at<Column: RestoringForce, R: Recorder>(
    row: &Row<Column>,
    node: usize,
    states: &[State],
    ground: f64,
    velocity: impl Fn(usize) -> f64,
) -> Load {
    let state = &states[node];
    let forces = if !R::READS_WEIGHED {
        (0.0, 0.0)
    } else if row.stands_alone(node) {
        let damping = row.nodes()[node].damping;
        (state.restoring_force, damping * velocity(node))
    } else {
        storeys(row, node, states, velocity)
    };
    Load::at(state, forces, ground)
}

/// Restoring and damping force of the storeys below and above a floor.
#[inline(never)]
fn storeys<Column: RestoringForce>(
    row: &Row<Column>,
    node: usize,
    states: &[State],
    velocity: impl Fn(usize) -> f64,
) -> (f64, f64) {
    let damping = row.damping_at(node, velocity);
    (row.restoring_force(node, states), damping)
}

/// Accepts the end of a step and reports its spans; of each node, in the states at both ends, what the method made of
/// which loads.
#[inline]
pub(crate) fn commit<Column: RestoringForce, R: Recorder, const N: usize>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    clock: Clock,
    step: usize,
    recorder: &mut R,
    mut weighed: impl FnMut(usize, [&[State]; 2]) -> ((f64, [f64; N]), [Load; N]),
) {
    let times = (clock.time(step - 1), clock.time(step));
    let (pushes, incidence) = (&mut scratch.pushes, row.incidence());
    for (pair, known) in scratch.pairs.iter().enumerate() {
        let force = if scratch.touching[pair] {
            known.force
        } else {
            0.0
        };
        for slot in incidence.slots_of(pair) {
            pushes.at(*slot).forces[1] = force;
        }
    }
    let all: [&[State]; 2] = [&scratch.states, &scratch.ends];
    for (node, (start, end)) in all[0].iter().zip(all[1]).enumerate() {
        let (weights, loads) = weighed(node, all);
        let mut span = Span::step::<R, N>(node, times, [*start, *end], weights, loads);
        span.below = row.below(node, all);
        let slots = incidence.slots_at(node);
        pushes.weigh(slots.clone(), weights);
        span.pushes = pushes.of(slots.clone());
        recorder.span(&span);
        pushes.go_on(slots);
    }
    std::mem::swap(&mut scratch.states, &mut scratch.ends);
    for trial in &mut scratch.trials {
        trial.memory = trial.response.memory;
    }
}
