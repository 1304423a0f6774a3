//! Damping of buildings in explicit methods: the only thing that couples the unknowns of floors there.
//!
//! A method asks for x with (a + b M⁻¹C) x = known, a and b > 0. Every floor is joined to the floor below and to the one
//! above alone, so that the matrix of a building is tridiagonal. It is eliminated from the top floor down to the ground:
//! the nodes of a row backwards, and then forwards. What is left of a diagonal element is a sum of positive terms, so that
//! dashpots of any strength lose no digits.

use crate::{Floor, RestoringForce, Row, Support};

/// Damping coefficients of a floor over its mass \[1/s\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct DampingRates {
    /// Of its own storey.
    pub(crate) storey: f64,
    /// Against the ground, besides that of a storey which stands there.
    pub(crate) ground: f64,
    /// Of the storey above; 0 where there is none.
    pub(crate) above: f64,
}

impl DampingRates {
    pub(crate) fn new<Column: RestoringForce>(row: &Row<Column>, index: usize) -> Self {
        let node = &row.nodes()[index];
        let ground = match node.support {
            Support::Ground => 0.0,
            Support::Floor(Floor { ground_damping, .. }) => ground_damping,
        };
        let above = |above: usize| node.inverse_mass * row.nodes()[above].damping;
        Self {
            storey: node.inverse_mass * node.damping,
            ground: node.inverse_mass * ground,
            above: row.above(index).map_or(0.0, above),
        }
    }

    /// What velocities \[m/s\] of the floors take from the acceleration of this one \[m/s²\].
    #[inline]
    pub(crate) fn deceleration<Column: RestoringForce>(
        &self,
        row: &Row<Column>,
        index: usize,
        velocity: impl Fn(usize) -> f64,
    ) -> f64 {
        let own = velocity(index);
        let below = match row.nodes()[index].support.below() {
            None => self.storey * own,
            Some(below) => self.storey * (own - velocity(below)) + self.ground * own,
        };
        match row.above(index) {
            None => below,
            Some(above) => below - self.above * (velocity(above) - own),
        }
    }
}

/// Equation of a floor when the unknowns of all floors above it are eliminated.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Eliminated {
    /// Coefficient of its own unknown, > 0.
    pub(crate) pivot: f64,
    /// The same without the dashpot to the floor below.
    free: f64,
    /// Coefficient of the unknown of the floor below, which enters with a minus sign; 0 on the ground.
    pub(crate) below: f64,
    /// The same of the floor above.
    pub(crate) above: f64,
}

impl Eliminated {
    /// For a matrix with the diagonal `unit` and damping rates that count as `weigh` says; the equation of the floor above
    /// has been eliminated.
    pub(crate) fn new(
        (rates, support): (&DampingRates, &Support),
        above: Option<&Self>,
        unit: f64,
        weigh: impl Fn(f64) -> f64,
    ) -> Self {
        let (storey, upper) = (weigh(rates.storey), weigh(rates.above));
        let (fixed, below) = match support {
            Support::Ground => (unit + storey, 0.0),
            Support::Floor(_) => (unit + weigh(rates.ground), storey),
        };
        let free = match above {
            None => fixed,
            Some(above) => fixed + upper * above.free / above.pivot,
        };
        Self {
            pivot: free + below,
            free,
            below,
            above: upper,
        }
    }
}

/// Solves (1 + h/2 M⁻¹C) x = known, for steps h that may change and differ between buildings.
#[derive(Debug)]
pub(crate) struct Dashpots {
    rates: Vec<DampingRates>,
    /// Equations, and the step \[s\] for which they were eliminated.
    equations: Vec<(f64, Eliminated)>,
    /// What is known, for every node; then x.
    pub(crate) values: Vec<f64>,
}

impl Dashpots {
    /// Nothing for a row in which no floor stands on another one.
    pub(crate) fn of<Column: RestoringForce>(row: &Row<Column>) -> Option<Self> {
        let n = row.nodes().len();
        let stands = |index: usize| row.nodes()[index].support.below().is_some();
        (0..n).any(stands).then(|| Self {
            rates: (0..n).map(|index| DampingRates::new(row, index)).collect(),
            equations: vec![(0.0, Eliminated::default()); n],
            values: vec![0.0; n],
        })
    }

    /// Replaces what is known by x. Nodes that have no step take no part; floors of a building have the same.
    pub(crate) fn solve<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        step: impl Fn(usize) -> Option<f64>,
    ) {
        for index in (0..self.values.len()).rev() {
            let Some(step) = step(index) else {
                continue;
            };
            let above = row.above(index);
            let (known_for, _) = self.equations[index];
            if (step - known_for).abs() > 0.0 {
                let support = &row.nodes()[index].support;
                let carried = above.map(|above| &self.equations[above].1);
                let parts = (&self.rates[index], support);
                let weigh = |rate| 0.5 * step * rate;
                self.equations[index] = (step, Eliminated::new(parts, carried, 1.0, weigh));
            }
            let (_, equation) = &self.equations[index];
            let known = match above {
                None => self.values[index],
                Some(above) => self.values[index] + equation.above * self.values[above],
            };
            self.values[index] = known / equation.pivot;
        }
        for index in 0..self.values.len() {
            if let (Some(below), Some(_)) = (row.nodes()[index].support.below(), step(index)) {
                let (_, equation) = &self.equations[index];
                self.values[index] += equation.below / equation.pivot * self.values[below];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Elastic, Levels, Storey};

    #[test]
    fn reference_a_solution_fulfils_the_equations() {
        // Towers of four and two storeys beside a house, with dashpots of very different strengths.
        let levels = Levels::new(&[4, 1, 2]);
        let column = Elastic { stiffness: 0.0 };
        let nodes = (0..levels.n_nodes()).map(|node| {
            let step = node as f64;
            levels.floor(
                node,
                Storey {
                    mass: 1.0 + step,
                    damping: if node % 2 == 0 { 1e3 } else { 0.1 * step },
                    ground_damping: 0.3 * step,
                    column,
                },
            )
        });
        let row = Row::new(nodes.collect(), vec![]).expect("a valid row");
        let mut dashpots = Dashpots::of(&row).expect("floors stand on floors");
        for step in [0.1, 7.0, 0.1] {
            let known: Vec<f64> = (0..7_i32).map(|n| f64::from(n * n) - 9.5).collect();
            dashpots.values.copy_from_slice(&known);
            // The house takes no part.
            dashpots.solve(&row, |index| (index != 1).then_some(step));
            let x = &dashpots.values;
            for (index, known) in known.iter().enumerate() {
                let rate = dashpots.rates[index].deceleration(&row, index, |node| x[node]);
                let sum = if index == 1 {
                    x[1]
                } else {
                    x[index] + 0.5 * step * rate
                };
                assert!((sum - known).abs() < 1e-10, "{index}: {sum} {known}");
            }
        }
    }
}
