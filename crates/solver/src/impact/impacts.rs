//! Impulsive contact as a jump of the velocities after a step: one rule for every stepping method.
//!
//! Every impulsive pair that approaches with a closed gap parts at e times its approach. A single pair gets P = (1+e) m δ̇, m the reduced
//! mass (the paper, equation (4)). Several pairs at once are solved together, in rounds. Each round solves 0 ≤ u⁺ + e u⁻ ⟂ P ≥ 0 over the
//! touching pairs that do not separate. u is the relative velocity, negative while approaching. Rounds repeat while a touching pair
//! approaches. A round changes the kinetic energy by ½ Σ P (1−e) u⁻ ≤ 0.
//!
//! Treating each pair alone, from the velocities before, would not create energy either (the product of their impulses enters it with a
//! minus sign). But it would destroy energy: a mass hit from both sides at once, e = 1, would not turn round, and its neighbours would go
//! on approaching.

use crate::impact::any_rounds::{Closed, Jumps};
use crate::impact::rounds::{Rounds, Touching};
use crate::model::ground::{Ground, Now};
use crate::{Impact, Pair, Recorder, RestoringForce, Row, RunError, State};

/// Scratch of the rule, allocated once per run.
pub(crate) struct Impacts {
    /// Impulsive pairs that touch at this instant.
    pub(crate) touching: Vec<bool>,
    /// Impulse of every pair \[N·s\], over all rounds.
    impulses: Vec<f64>,
    /// Velocity of every structure before the instant.
    before: Vec<f64>,
    /// Net impulse on every structure, for impulses that were found with the step.
    net: Vec<f64>,
    /// Velocity of every structure after the impulses, if pairs are no chain.
    after: Vec<f64>,
    rounds: Solver,
}

/// Solver for the impulses of a row.
enum Solver {
    Chain(Box<Rounds<f64>>),
    Any(Box<Jumps>),
}

impl Impacts {
    pub(crate) fn new<Column: RestoringForce>(row: &Row<Column>) -> Self {
        let (n, n_pairs) = (row.nodes().len(), row.pairs().len());
        let rounds = if row.is_chain() {
            let mobilities = row.nodes().iter().map(|node| node.inverse_mass);
            Solver::Chain(Box::new(Rounds::new(mobilities.collect(), n_pairs)))
        } else {
            Solver::Any(Box::new(Jumps::new(row)))
        };
        Self {
            touching: vec![false; n_pairs],
            impulses: vec![0.0; n_pairs],
            before: vec![0.0; n],
            net: vec![0.0; n],
            after: vec![0.0; n],
            rounds,
        }
    }

    /// Applies jumps to the impulsive pairs with a closed gap; true if any jumped. The errors are those of [`Self::jump`].
    pub(crate) fn after_step<Column: RestoringForce, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        states: &mut [State],
        now: Now<'_>,
        recorder: &mut R,
    ) -> Result<bool, RunError> {
        let mut touches = false;
        for (touching, pair) in self.touching.iter_mut().zip(row.pairs()) {
            *touching = now.ground.deformation_of(pair, states) >= 0.0 && pair.law.impulsive().is_some();
            touches |= *touching;
        }
        if touches {
            self.jump(row, states, now, recorder)
        } else {
            Ok(false)
        }
    }

    /// Applies jumps to the pairs marked as touching: first velocities, then accelerations from equilibrium; true if any jumped.
    ///
    /// Precondition: the spans that end now have been reported. Returns an error if pairs are
    /// no chain and their walls close in on them. In a chain the velocities become non-finite in this case.
    pub(crate) fn jump<Column: RestoringForce, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        states: &mut [State],
        now: Now<'_>,
        recorder: &mut R,
    ) -> Result<bool, RunError> {
        self.remember(states);
        self.gather(row.pairs(), now.ground);
        let closed_in = |pair: usize| {
            let pair = &row.pairs()[pair];
            let ([left, right], time) = ([pair.left(), pair.right()], now.time);
            RunError::ClosedIn { left, right, time }
        };
        let jumps = self.strike_all().map_err(closed_in)?;
        if jumps {
            self.tell(states);
            self.settle(row, states, now, recorder);
        }
        Ok(jumps)
    }

    /// Lists the pairs marked as touching.
    fn gather(&mut self, pairs: &[Pair], ground: Ground<'_>) {
        self.impulses.fill(0.0);
        match &mut self.rounds {
            Solver::Chain(rounds) => rounds.clear(),
            Solver::Any(rounds) => rounds.clear(),
        }
        for (index, pair) in pairs.iter().enumerate() {
            if let Some(law) = pair.law.impulsive().filter(|_| self.touching[index]) {
                let opening = ground.opening(pair).velocity;
                let (restitution, speeds) = (law.restitution, ground.extent(pair).velocity);
                match &mut self.rounds {
                    Solver::Chain(rounds) => rounds.push(
                        index,
                        pair.left(),
                        Touching {
                            scenes: true,
                            factor: 1.0 + restitution,
                            opening_rate: opening,
                            speeds,
                        },
                    ),
                    Solver::Any(rounds) => rounds.push(
                        index,
                        pair.relation,
                        Closed {
                            rate: opening,
                            restitution,
                            passes_on: true,
                            scale: speeds,
                            impulse: 0.0,
                        },
                    ),
                }
            }
        }
    }

    /// Compiled once, not for every column and recorder.
    #[inline(never)]
    fn strike_all(&mut self) -> Result<bool, usize> {
        match &mut self.rounds {
            Solver::Chain(rounds) => Ok(rounds.strike_all(|node| self.before[node])),
            Solver::Any(rounds) => {
                self.after.copy_from_slice(&self.before);
                rounds.strike_all(&mut self.after)
            }
        }
    }

    /// Keeps the impulses found, and gives the states their new velocities.
    fn tell(&mut self, states: &mut [State]) {
        match &self.rounds {
            Solver::Chain(rounds) => {
                for (link, impulse) in rounds.struck() {
                    self.impulses[link.pair] = impulse;
                    for node in [link.left, link.right] {
                        states[node].velocity = rounds.velocity(node);
                    }
                }
            }
            Solver::Any(rounds) => {
                for (pair, impulse) in rounds.struck() {
                    self.impulses[pair] = impulse;
                }
                for (state, after) in states.iter_mut().zip(&self.after) {
                    state.velocity = *after;
                }
            }
        }
    }

    /// Adds the impulses of all pairs that were found with the step to the velocities. The precondition is that of a jump.
    pub(crate) fn impose<Column: RestoringForce, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        states: &mut [State],
        impulses: &[f64],
        now: Now<'_>,
        recorder: &mut R,
    ) {
        self.impulses.copy_from_slice(impulses);
        self.remember(states);
        strike(row, impulses, &mut self.net, states);
        self.settle(row, states, now, recorder);
    }

    fn remember(&mut self, states: &[State]) {
        for (before, state) in self.before.iter_mut().zip(states) {
            *before = state.velocity;
        }
    }

    /// Reports the impacts of an instant, and updates the accelerations from the new velocities.
    fn settle<Column: RestoringForce, R: Recorder>(&self, row: &Row<Column>, states: &mut [State], now: Now<'_>, recorder: &mut R) {
        self.report(row.pairs(), states, now, recorder);
        for node in 0..states.len() {
            if self.feels_jump(row, node, states) {
                states[node].acceleration = row.acceleration(node, states, now.ground.under(node));
            }
        }
    }

    /// Whether the velocity of a node has jumped.
    pub(crate) fn has_jumped(&self, node: usize, states: &[State]) -> bool {
        (states[node].velocity - self.before[node]).abs() > 0.0
    }

    /// Whether the velocity of a node has jumped, or that of a floor joined to it by a damper.
    pub(crate) fn feels_jump<Column: RestoringForce>(&self, row: &Row<Column>, node: usize, states: &[State]) -> bool {
        let jumped = |node: usize| self.has_jumped(node, states);
        let below = row.nodes()[node].support.below();
        jumped(node) || below.is_some_and(jumped) || row.above(node).is_some_and(jumped)
    }

    fn report<R: Recorder>(&self, pairs: &[Pair], states: &[State], Now { ground, time }: Now<'_>, recorder: &mut R) {
        for (index, (pair, &impulse)) in pairs.iter().zip(&self.impulses).enumerate() {
            if impulse > 0.0 {
                let before = |floor: usize| self.before[floor];
                let after = |floor: usize| states[floor].velocity;
                recorder.impact(&Impact {
                    pair: index,
                    time,
                    impulse,
                    opening_rate: ground.opening(pair).velocity,
                    ..Impact::of(&pair.relation, before, after)
                });
            }
        }
    }
}

/// Changes the velocities by the impulses of all pairs; `net` is scratch.
fn strike<Column: RestoringForce>(row: &Row<Column>, impulses: &[f64], net: &mut [f64], states: &mut [State]) {
    net.fill(0.0);
    for (pair, impulse) in row.pairs().iter().zip(impulses) {
        // Summed before it is added to a velocity, so that a mirrored row gives mirrored bits.
        pair.relation.spread(*impulse, |floor, impulse| net[floor] += impulse);
    }
    for ((state, net), node) in states.iter_mut().zip(net).zip(row.nodes()) {
        state.velocity += node.inverse_mass * *net;
    }
}
