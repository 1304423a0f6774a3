//! The cheapest method and time step for an accuracy, and the runs that were tried.

use crate::Method;

/// The wanted accuracy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goal {
    /// Largest relative error \[–\], > 0 and < 1.
    pub error: f64,
    /// Numbers that must have it.
    pub quantity: QuantityGroup,
}

/// A run of the ladder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodTrial {
    /// Name of the method, as in figures.
    pub name: &'static str,
    /// Method with its step.
    pub method: Method,
    /// Largest error of these numbers \[–\]; infinite if the run failed or the numbers of collisions differ.
    pub error: f64,
    /// Number with the largest error; empty for the exact method.
    pub worst: &'static str,
    /// Cost in force evaluations of a step of the central difference method that take the same time. A piece of the exact method counts as
    /// [`Simulation::evaluations_per_piece`](super::Simulation::evaluations_per_piece) evaluations.
    pub cost: u64,
}

/// A method with its time steps, from the longest to the shortest.
#[derive(Debug, Clone, PartialEq)]
pub struct StepSizes {
    /// Runs of the method; empty if no time step is stable.
    pub trials: Vec<MethodTrial>,
    /// Index of the cheapest run that meets the goal, if all runs with shorter steps meet it, too. The shortest step only confirms.
    pub meets: Option<usize>,
}

/// Cost and error of every method.
#[derive(Debug, Clone, PartialEq)]
pub struct Advice {
    /// The wanted accuracy.
    pub goal: Goal,
    /// The exact method, the reference for the others; its own error is rounding.
    pub exact: MethodTrial,
    /// Every method with time steps.
    pub methods: Vec<StepSizes>,
}

impl Advice {
    /// The cheapest run that meets the goal; the exact method when no cheaper one does.
    pub fn best(&self) -> &MethodTrial {
        let meeting = self.methods.iter().filter_map(StepSizes::chosen);
        meeting.fold(&self.exact, |best, next| if next.cost < best.cost { next } else { best })
    }
}

impl StepSizes {
    /// Returns the rungs, from the coarsest to the finest, that hold a condition together with all finer rungs.
    pub fn holding<Rung>(rungs: &[Rung], holds: impl Fn(&Rung) -> bool) -> &[Rung] {
        let missed = rungs.iter().rposition(|rung| !holds(rung));
        &rungs[missed.map_or(0, |index| index + 1)..]
    }

    pub(crate) fn new(trials: Vec<MethodTrial>, goal: Goal) -> Self {
        let holding = Self::holding(&trials, |trial| trial.error <= goal.error);
        let first = trials.len() - holding.len();
        let confirmed = first..trials.len().saturating_sub(1);
        Self {
            meets: confirmed.min_by_key(|index| trials[*index].cost),
            trials,
        }
    }

    /// Cheapest run that meets the goal, if all runs with shorter steps meet it, too.
    pub fn chosen(&self) -> Option<&MethodTrial> {
        self.meets.map(|index| &self.trials[index])
    }
}

/// Quantities whose errors count together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum QuantityGroup {
    /// Transferred momentum of every structure.
    Momentum,
    /// Peak displacement of every floor, peak drift of every storey, both at the end, and least opening of every pair.
    Displacement,
    /// Peak absolute acceleration of every floor.
    Acceleration,
    /// Peak shear force of every structure and peak pounding force of every compliant pair.
    Force,
    /// Impulse of the first collision, largest impulse and sum of the impulses of every pair.
    Impulse,
    /// Time of the first collision of every pair, relative to that time, and time for which it touches.
    Time,
    /// All of these, and equal numbers of collisions.
    All,
}

impl QuantityGroup {
    /// Every group.
    pub const EVERY: [Self; 7] = [
        Self::Momentum,
        Self::Displacement,
        Self::Acceleration,
        Self::Force,
        Self::Impulse,
        Self::Time,
        Self::All,
    ];

    /// Name, as users write it.
    pub fn name(self) -> &'static str {
        self.told()[0]
    }

    /// Meaning in a few words.
    pub fn meaning(self) -> &'static str {
        self.told()[1]
    }

    fn told(self) -> [&'static str; 2] {
        match self {
            Self::Momentum => ["momentum", "Transferred momentum of every structure"],
            Self::Displacement => ["displacement", "Peak displacements, storey drifts, both at the end, least openings"],
            Self::Acceleration => ["acceleration", "Peak absolute acceleration of every floor"],
            Self::Force => ["force", "Peak shear forces and peak pounding forces"],
            Self::Impulse => ["impulse", "First and largest impulse of every pair, sum of its impulses"],
            Self::Time => ["time", "Time of the first collision of every pair, time of touching"],
            Self::All => ["all", "All of these, and equal numbers of collisions"],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_rung_holds_only_if_all_finer_ones_do() {
        let holding = |errors| StepSizes::holding(errors, |error: &f64| *error <= 1.0).to_vec();
        assert_eq!(holding(&[0.5, 2.0, 1.0, 0.1]), [1.0, 0.1], "0.5 was luck");
        assert_eq!(holding(&[1.0, 0.5]), [1.0, 0.5]);
        assert_eq!(holding(&[0.5, 2.0]), [0.0; 0]);
        assert_eq!(holding(&[]), [0.0; 0]);
    }
}
