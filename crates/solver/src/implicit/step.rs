//! A step of an implicit method: equilibrium at its end, and its report.

use crate::impact::impacts::Impacts;
use crate::implicit::cluster::{Alone, TouchingLine};
use crate::implicit::clusters::Clusters;
use crate::implicit::equation::{Cluster, Failure, Slopes, StepEnd};
use crate::implicit::newton::{self};
use crate::implicit::trial::{PairTrial, TOLERANCE, Trial};
use crate::march::ClockStep;
use crate::model::approach::speed;
use crate::model::ground::Ground;
use crate::pushes::Pushes;
use crate::span::{Load, StoreyForces, Weights};
use crate::{Recorder, RestoringForce, Row, RunError, Span, State, Work};

/// Scratch of an implicit run, allocated once.
pub(crate) struct Scratch<Memory> {
    /// State at the start of the step, after impacts.
    pub(crate) states: Vec<State>,
    /// State at its end, before impacts.
    pub(crate) ends: Vec<State>,
    pub(crate) trials: Vec<Trial<Memory>>,
    /// Trials of the pairs.
    pub(crate) pairs: Vec<PairTrial>,
    pub(crate) pushes: Pushes,
    /// Which pairs overlap during the step.
    pub(crate) touching: Vec<bool>,
    /// `None` for a row of structures of one storey.
    pub(crate) clusters: Option<Clusters>,
    pub(crate) impacts: Impacts,
}

/// State of every structure at t = 0, accelerations from equilibrium.
pub(crate) fn begin<Column: RestoringForce>(row: &Row<Column>, ground: Ground<'_>) -> Scratch<Column::Memory> {
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

/// Finds equilibrium at the end of a step: every building alone first, then the clusters that touch.
pub(crate) fn balance<Column: RestoringForce>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    slopes: Slopes,
    step: &ClockStep<'_>,
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
        end: StepEnd { slopes, ground: ground[1] },
        time: step.end().time,
        work,
    };
    match clusters {
        None => {
            for index in 0..row.nodes().len() {
                equation.solve(TouchingLine {
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

/// Inputs for the solution of every cluster of a step.
struct Equation<'a, Column: RestoringForce> {
    row: &'a Row<Column>,
    trials: &'a mut [Trial<Column::Memory>],
    pairs: &'a mut [PairTrial],
    end: StepEnd<'a>,
    time: f64,
    work: &'a mut Work,
}

impl<Column: RestoringForce> Equation<'_, Column> {
    #[inline]
    fn solve<C: Cluster>(&mut self, mut cluster: C) -> Result<(), RunError> {
        let (trials, pairs) = (&mut *self.trials, &mut *self.pairs);
        newton::solve(self.row, trials, pairs, &mut cluster, self.end, self.work).map_err(|failure| self.error(failure, &cluster))
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
            self.solve(TouchingLine {
                nodes: first..last + 1,
                pairs: start..pair,
            })?;
        }
        Ok(())
    }

    /// Equilibrium of buildings that touch.
    fn solve_clusters(&mut self, clusters: &mut Clusters, touching: &[bool]) -> Result<(), RunError> {
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

    /// Marks compliant pairs that overlap and were not marked yet; true if there are any.
    ///
    /// Pairs that begin to touch have the approach speed of a motion without their force.
    fn mark_overlaps(&mut self, touching: &mut [bool]) -> bool {
        let (trials, ground) = (&*self.trials, self.end.ground);
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

    /// Error of a run that did not find the equilibrium of a cluster.
    fn error(&self, failure: Failure, cluster: &impl Cluster) -> RunError {
        let time = self.time;
        match failure {
            Failure::NotFinite { structure } => RunError::Diverged {
                structure,
                time,
                time_step: self.end.slopes.time_step,
            },
            Failure::NotConverged { iterations, residual } => RunError::NotConverged {
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

/// The floors on both sides of the marked pairs.
pub(crate) fn marked<Column: RestoringForce>(row: &Row<Column>, marks: &[bool]) -> impl Iterator<Item = (usize, usize)> {
    let pairs = row.pairs().iter().zip(marks);
    pairs.filter_map(|(pair, marked)| marked.then_some((pair.left(), pair.right())))
}

/// Accepts the states at the end of a step.
pub(crate) fn arrive<Memory: Copy>(scratch: &mut Scratch<Memory>, step: &ClockStep<'_>) -> Result<(), RunError> {
    let ends = scratch.ends.iter_mut().zip(&scratch.trials);
    for (structure, (end, trial)) in ends.enumerate() {
        *end = trial.state();
        if !end.displacement.is_finite() {
            return Err(step.diverged(structure));
        }
    }
    Ok(())
}

/// The load on a node, limited to the parts that a recorder reads.
#[inline]
pub(crate) fn load<Column: RestoringForce>(reads_weighed: bool, row: &Row<Column>, node: usize, states: &[State], ground: f64) -> Load {
    let velocity = |index: usize| states[index].velocity;
    load_at(reads_weighed, row, node, states, ground, velocity)
}

/// The load on a node, with damping at velocities other than those of the states.
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
        StoreyForces::default()
    } else if row.stands_alone(node) {
        StoreyForces {
            restoring: state.restoring_force,
            damping: row.nodes()[node].damping * velocity(node),
        }
    } else {
        storeys(row, node, states, velocity)
    };
    Load::at(state, forces, ground)
}

/// Forces of the storeys below and above a floor.
#[inline(never)]
fn storeys<Column: RestoringForce>(row: &Row<Column>, node: usize, states: &[State], velocity: impl Fn(usize) -> f64) -> StoreyForces {
    StoreyForces {
        damping: row.damping_at(node, velocity),
        restoring: row.restoring_force(node, states),
    }
}

/// Accepts the end of a step and reports its spans. For each node it takes the loads in the states at both ends and the weights of the
/// method.
#[inline]
pub(crate) fn commit<Column: RestoringForce, R: Recorder, const N: usize>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    step: &ClockStep<'_>,
    recorder: &mut R,
    mut weighed: impl FnMut(usize, [&[State]; 2]) -> (Weights<N>, [Load; N]),
) {
    let (times, reads_weighed) = (step.times(), recorder.reads_weighed());
    let (pushes, incidence) = (&mut scratch.pushes, row.incidence());
    pushes.pass();
    for (pair, known) in scratch.pairs.iter().enumerate() {
        let force = if scratch.touching[pair] { known.force } else { 0.0 };
        pushes.set(incidence, pair, force);
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
