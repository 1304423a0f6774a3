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
use crate::march::{Step, Stepping, march};
use crate::model::approach::speed;
use crate::model::ground::Ground;
use crate::span::{Load, Pushes};
use crate::{Course, Excitation, Recorder, RestoringForce, Row, RunError, Span, State, Work};

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

/// The methods whose steps follow Newmark's formulas, by their coefficients.
#[derive(Clone, Copy)]
pub(crate) struct Family {
    pub(crate) beta: f64,
    pub(crate) gamma: f64,
    /// Part of the forces that the equation takes from the start of the step, ≤ 0.
    pub(crate) alpha: f64,
    /// Whether accelerations are in equilibrium at a node, also after a jump.
    pub(crate) in_equilibrium: bool,
}

/// A run of one of them.
pub(crate) struct Run<Memory> {
    family: Family,
    slopes: Slopes,
    scratch: Scratch<Memory>,
    /// What acted a step ago: the acceleration carries it.
    earlier: Vec<Option<Load>>,
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
    settings.check()?;
    let family = Family {
        beta: settings.beta,
        gamma: settings.gamma,
        alpha: 0.0,
        in_equilibrium: true,
    };
    family.run(row, (excitation, course), recorder)
}

impl Family {
    /// Integrates a row.
    pub(crate) fn run<Column: RestoringForce, R: Recorder>(
        self,
        row: &Row<Column>,
        (excitation, course): (Excitation<'_>, Course),
        recorder: &mut R,
    ) -> Result<Work, RunError> {
        let dt = course.clock.time_step;
        let begin = |ground: Ground<'_>| Run {
            family: self,
            // Divided by 1+α, so that Newton sees the forces at the end of the step as they are.
            slopes: Slopes {
                displacement: self.beta * dt * dt,
                velocity: self.gamma * dt,
                inertia: 1.0 / (1.0 + self.alpha),
                time_step: dt,
            },
            scratch: begin(row, ground),
            earlier: vec![None; row.nodes().len()],
        };
        march(row, (excitation, course), (1, begin), recorder)
    }

    /// Weights of the loads a step before, at the start and at the end of a step; m ü at the start is (1+α) times its own load
    /// less α times the one before, at t = 0 its own.
    fn weights(&self, is_first: bool) -> [f64; 3] {
        let Self { gamma, alpha, .. } = self;
        let carried = if is_first { 0.0 } else { -alpha };
        [
            (1.0 - gamma) * carried,
            (1.0 - gamma) * (1.0 - carried) - gamma * alpha,
            gamma * (1.0 + alpha),
        ]
    }
}

impl<Column: RestoringForce> Stepping<Column> for Run<Column::Memory> {
    #[inline]
    fn step<R: Recorder>(
        &mut self,
        row: &Row<Column>,
        step: Step<'_>,
        work: &mut Work,
        recorder: &mut R,
    ) -> Result<(), RunError> {
        let (dt, at_ends) = (step.clock.time_step, step.ends());
        let family = self.family;
        self.predict(row, dt, at_ends[0]);
        let scratch = &mut self.scratch;
        balance(row, scratch, self.slopes, &step, work)?;
        arrive(scratch, &step)?;
        let (earlier, reads_weighed) = (&mut self.earlier, recorder.reads_weighed());
        commit(row, scratch, &step, recorder, |node, ends| {
            let load = |at: usize| {
                let ground = at_ends[at].under(node);
                load(reads_weighed, row, node, ends[at], ground)
            };
            let (start, end) = (load(0), load(1));
            let before = earlier[node].replace(start);
            let weights = family.weights(before.is_none());
            ((dt, weights), [before.unwrap_or(start), start, end])
        });
        let ended = (&mut scratch.states[..], &mut scratch.impacts);
        if step.collide(row, ended, work, recorder) && !family.in_equilibrium {
            self.change_accelerations(row);
        }
        Ok(())
    }
}

impl<Memory: Copy> Run<Memory> {
    /// Displacements and velocities at the end of a step without its acceleration.
    fn predict<Column: RestoringForce<Memory = Memory>>(
        &mut self,
        row: &Row<Column>,
        dt: f64,
        ground: Ground<'_>,
    ) {
        let Family {
            beta, gamma, alpha, ..
        } = self.family;
        let states = &self.scratch.states;
        for ((node, state), trial) in states.iter().enumerate().zip(&mut self.scratch.trials) {
            trial.predicted = (
                state.displacement + dt * (state.velocity + dt * (0.5 - beta) * state.acceleration),
                state.velocity + dt * (1.0 - gamma) * state.acceleration,
            );
            if alpha < 0.0 {
                let acceleration = row.acceleration(node, states, ground.under(node));
                trial.carried = alpha * self.slopes.inertia * acceleration;
            }
        }
    }

    /// Lets accelerations jump by what damping forces do, as if the velocities a step ago had jumped as well.
    fn change_accelerations<Column: RestoringForce<Memory = Memory>>(&mut self, row: &Row<Column>) {
        let Scratch { states, trials, .. } = &mut self.scratch;
        for (index, (trial, earlier)) in trials.iter().zip(&mut self.earlier).enumerate() {
            let jump = |node: usize| states[node].velocity - trials[node].velocity;
            let change = row.damping_at(index, jump);
            let inverse_mass = row.nodes()[index].inverse_mass;
            states[index].acceleration = trial.acceleration - inverse_mass * change;
            if let Some(earlier) = earlier {
                earlier.damping += change;
            }
        }
    }
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

/// Equilibrium at the end of a step: every building alone first, then the clusters that touch.
pub(crate) fn balance<Column: RestoringForce>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    slopes: Slopes,
    step: &Step<'_>,
    work: &mut Work,
) -> Result<(), RunError> {
    let ground = step.ends();
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
        time: step.end().1,
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
        Some(_) => {
            for floors in row.buildings().each() {
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
        let row = self.row;
        clusters.join(row.buildings(), marked(row, touching));
        for building in 0..row.buildings().len() {
            if clusters.gather(row, building, |pair| touching[pair]) {
                match clusters.line() {
                    Some(line) => self.solve(line)?,
                    None => self.solve(clusters.joined(row, |_| true))?,
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
    step: &Step<'_>,
) -> Result<(), RunError> {
    let ends = scratch.ends.iter_mut().zip(&scratch.trials);
    for (structure, (end, trial)) in ends.enumerate() {
        *end = trial.state();
        if !end.displacement.is_finite() {
            return Err(step.diverged(structure));
        }
    }
    Ok(())
}

/// What acts on a node, as much of it as a recorder reads.
#[inline]
pub(crate) fn load<Column: RestoringForce>(
    reads_weighed: bool,
    row: &Row<Column>,
    node: usize,
    states: &[State],
    ground: f64,
) -> Load {
    let velocity = |index: usize| states[index].velocity;
    load_at(reads_weighed, row, node, states, ground, velocity)
}

/// The same with damping at other velocities than those of the states.
#[inline]
pub(crate) fn load_at<Column: RestoringForce>(
    reads_weighed: bool,
    row: &Row<Column>,
    node: usize,
    states: &[State],
    ground: f64,
    velocity: impl Fn(usize) -> f64,
) -> Load {
    let state = &states[node];
    let forces = if !reads_weighed {
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
    step: &Step<'_>,
    recorder: &mut R,
    mut weighed: impl FnMut(usize, [&[State]; 2]) -> ((f64, [f64; N]), [Load; N]),
) {
    let (times, reads_weighed) = (step.times(), recorder.reads_weighed());
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
        let mut span = Span::step(reads_weighed, node, times, [*start, *end], weights, loads);
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
