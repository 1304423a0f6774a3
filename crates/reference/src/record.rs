//! Results of the second route.

use super::equations::Equations;
use super::impact::SHORTEST;
use super::model::{displacement, velocity};
use super::state::State;

/// Result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// Collisions of each pair, in order of time.
    pub collisions: Vec<Vec<Collision>>,
    /// Results of each structure, floor or wall, in the order of the row's nodes.
    pub structures: Vec<StructureResponse>,
    /// Peak deformation of each link \[m\], positive if it is shorter.
    pub links: Vec<Peak>,
    /// Number of accepted steps.
    pub steps: u64,
}

/// A contact of a pair, from touch to parting. For an impulsive law: an impact with the rest that follows it at once, or the time for which
/// a pair presses that came to rest without an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    /// First touch, or the instant of the impact \[s\].
    pub start: f64,
    /// Parting or the end of the run, or the instant of the impact \[s\].
    pub end: f64,
    /// Impulse ∫F dt \[N·s\], ≥ 0.
    pub impulse: f64,
    /// Peak pounding force \[N\]; `None` for an impact, with or without rest.
    pub peak_force: Option<f64>,
}

/// The value of largest magnitude and its first instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Peak {
    /// The value, with its sign.
    pub value: f64,
    /// First instant of the value \[s\].
    pub time: f64,
}

/// Results of a structure, or of a floor and the storey below it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StructureResponse {
    /// ∫ |net pounding force| dt, or the sum over instants of |net impulse| \[N·s\].
    pub transferred_momentum: f64,
    /// Peak displacement \[m\].
    pub displacement: Peak,
    /// Peak drift of the storey below \[m\]; on the ground, the peak displacement.
    pub drift: Peak,
    /// Peak restoring force of the storey below \[N\].
    pub restoring_force: Peak,
    /// Displacement at the end of the run \[m\].
    pub end_displacement: f64,
    /// Velocity at the end of the run \[m/s\].
    pub end_velocity: f64,
    /// Restoring force of the storey below at the end of the run \[N\].
    pub end_restoring_force: f64,
}

/// Collects the response during the run.
#[derive(Debug, Clone)]
pub(super) struct Record {
    response: Response,
    /// Index of the present collision of each pair.
    open: Vec<Option<usize>>,
    /// The last instant with an impact \[s\], and the net impulse of its impacts on every structure \[N·s\].
    instant: f64,
    net: Vec<f64>,
}

fn take(peak: &mut Peak, value: f64, time: f64) {
    if value.abs() > peak.value.abs() {
        *peak = Peak { value, time };
    }
}

impl Record {
    pub(super) fn new(motion: &Equations) -> Self {
        let structures = vec![StructureResponse::default(); motion.model.n_nodes];
        let response = Response {
            collisions: vec![Vec::new(); motion.model.pairs.len()],
            structures,
            links: vec![Peak::default(); motion.model.links.len()],
            steps: 0,
        };
        Self {
            response,
            open: vec![None; motion.model.pairs.len()],
            instant: 0.0,
            net: vec![0.0; motion.model.n_nodes],
        }
    }

    /// Records the state at the end of a step, in the phases of the step, or after an event there. `slope` is the derivative of the
    /// unknowns, which contains the forces.
    pub(super) fn observe(&mut self, motion: &Equations, y: &[f64], slope: &[f64], time: f64) {
        for (index, structure) in self.response.structures.iter_mut().enumerate() {
            let columns = &motion.model.structures[index].columns;
            let drift = motion.model.drift(index, y);
            let force = columns.bounded(motion.restoring_force(index, y), drift) + motion.model.friction(index, slope);
            take(&mut structure.displacement, y[displacement(index)], time);
            take(&mut structure.drift, drift, time);
            take(&mut structure.restoring_force, force, time);
        }
        for (index, peak) in self.response.links.iter_mut().enumerate() {
            take(peak, motion.link_deformation(index, y), time);
        }
        for (index, phase) in motion.phases.pairs.iter().enumerate() {
            if phase.contact.touches()
                && let Some(collision) = self.open[index].and_then(|last| self.response.collisions[index].get_mut(last))
            {
                let force = slope[motion.model.impulse(index)];
                collision.peak_force = collision.peak_force.map(|peak| peak.max(force));
            }
        }
    }

    /// Adds the momentum that pounding forces transferred within a step without a change of sign of a net force.
    pub(super) fn transfer(&mut self, motion: &Equations, from: &[f64], to: &[f64]) {
        self.response.steps += 1;
        for (structure, response) in self.response.structures.iter_mut().enumerate() {
            let mut net = 0.0;
            for (index, pair) in motion.model.pairs.iter().enumerate() {
                let impulse = motion.model.impulse(index);
                net -= pair.ends.part(structure) * (to[impulse] - from[impulse]);
            }
            response.transferred_momentum += net.abs();
        }
    }

    /// A pair begins to press, with a force that may jump.
    pub(super) fn touch(&mut self, pair: usize, time: f64, force: f64) {
        let collisions = &mut self.response.collisions[pair];
        let struck = |last: &Collision| last.peak_force.is_none() && time - last.end < SHORTEST;
        if collisions.last().is_some_and(struck) {
            // The rest after an impact belongs to the impact.
            self.open[pair] = Some(collisions.len() - 1);
            return;
        }
        self.open[pair] = Some(collisions.len());
        collisions.push(Collision {
            start: time,
            end: time,
            impulse: 0.0,
            peak_force: Some(force),
        });
    }

    /// A pair stops pressing. An impulse of at most `least` \[N·s\] was rounding, for example if neighbours without a gap start together.
    pub(super) fn part(&mut self, pair: usize, impulse: f64, least: f64, time: f64) {
        let Some(last) = self.open[pair].take() else {
            return;
        };
        let collisions = &mut self.response.collisions[pair];
        if impulse > least {
            collisions[last].end = time;
            collisions[last].impulse += impulse;
        } else if collisions[last].peak_force.is_some() {
            collisions.remove(last);
        }
    }

    /// Impulsive pairs collide at an instant, each with an impulse ≥ 0. Impulses of at most `least` \[N·s\] are ignored.
    pub(super) fn impacts(&mut self, motion: &Equations, impulses: &[f64], least: &[f64], time: f64) {
        let impacts = impulses.iter().copied().enumerate();
        let impacts: Vec<_> = impacts.filter(|&(pair, impulse)| impulse > least[pair]).collect();
        for &(pair, impulse) in &impacts {
            self.response.collisions[pair].push(Collision {
                start: time,
                end: time,
                impulse,
                peak_force: None,
            });
        }
        if time > self.instant {
            self.instant = time;
            self.net.fill(0.0);
        }
        for (structure, response) in self.response.structures.iter_mut().enumerate() {
            let on_it = impacts
                .iter()
                .map(|&(index, impulse)| -motion.model.pairs[index].ends.part(structure) * impulse);
            let net = &mut self.net[structure];
            response.transferred_momentum -= net.abs();
            *net += on_it.sum::<f64>();
            response.transferred_momentum += net.abs();
        }
    }

    /// Closes collisions in progress at the end of the run. `slope` is the derivative of the unknowns there.
    pub(super) fn finish(mut self, motion: &Equations, state: &State, slope: &[f64], time: f64) -> Response {
        for index in 0..motion.model.pairs.len() {
            self.part(index, state.high[motion.model.impulse(index)], 0.0, time);
        }
        for (index, structure) in self.response.structures.iter_mut().enumerate() {
            structure.end_displacement = state.high[displacement(index)];
            structure.end_velocity = state.high[velocity(index)];
            structure.end_restoring_force = motion.restoring_force(index, &state.high) + motion.model.friction(index, slope);
        }
        self.response
    }
}
