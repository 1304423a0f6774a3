//! Damping of buildings in explicit methods, which is the only coupling between the unknowns of floors.
//!
//! A method needs x with (a + b M⁻¹C) x = known, a and b > 0. Every floor is joined only to the floor below and to the floor above: the
//! matrix of a building is tridiagonal. It is eliminated from the top floor down, and x then follows from the ground up. The remaining
//! diagonal elements are sums of positive terms, so that dashpots of any strength lose no digits.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use std::ops::Range;

use pounding_contact::Number;

use crate::{RestoringForce, Row};

/// Damping coefficients of a floor over its mass \[1/s\].
#[derive(Debug, Clone, Copy)]
pub struct DampingRates<N = f64> {
    /// Rate of the floor's storey.
    pub storey: N,
    /// Rate against the ground, in addition to that of a storey on the ground.
    pub ground: N,
    /// Rate of the storey above; 0 if there is none.
    pub above: N,
}

impl DampingRates {
    pub(crate) fn new<Column: RestoringForce>(row: &Row<Column>, index: usize) -> Self {
        let node = &row.nodes()[index];
        let above = |above: usize| node.inverse_mass * row.nodes()[above].damping;
        Self {
            storey: node.inverse_mass * node.damping,
            ground: node.inverse_mass * node.support.ground_damping(),
            above: row.above(index).map_or(0.0, above),
        }
    }
}

impl<N: Number> DampingRates<N> {
    /// Deceleration \[m/s²\] of a floor from the velocities \[m/s\] of the floor below, of this floor and of the floor above. Use 0 for the
    /// ground; the velocity of a missing floor has no effect.
    #[inline(always)]
    pub fn deceleration(&self, [below, own, above]: [N; 3]) -> N {
        self.storey * (own - below) + self.ground * own - self.above * (above - own)
    }
}

/// Equation of a floor after the unknowns of all floors above it are eliminated.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Eliminated {
    /// Coefficient of the unknown of this floor, > 0.
    pub(crate) pivot: f64,
    /// The pivot without the dashpot to the floor below.
    free: f64,
    /// Coefficient of the unknown of the floor below, subtracted; 0 on the ground.
    pub(crate) below: f64,
    /// Coefficient of the unknown of the floor above, subtracted; 0 on the top floor.
    pub(crate) above: f64,
}

impl Eliminated {
    /// Equation for a matrix with the diagonal `unit` and damping rates weighted by `weigh`. The floor above is already eliminated.
    pub(crate) fn new(rates: &DampingRates, on_ground: bool, above: Option<&Self>, unit: f64, weigh: impl Fn(f64) -> f64) -> Self {
        let (storey, upper) = (weigh(rates.storey), weigh(rates.above));
        let (fixed, below) = if on_ground {
            (unit + storey, 0.0)
        } else {
            (unit + weigh(rates.ground), storey)
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
    floors: Vec<FloorEquation>,
    /// The known values, for every floor, building by building; then x.
    pub(crate) values: Vec<f64>,
}

/// A floor, and its equation for the last step of its building.
#[derive(Debug)]
struct FloorEquation {
    rates: DampingRates,
    step: f64,
    equation: Eliminated,
    /// 1/pivot, and the factors of the floors above and below that are added after it. A division per floor, each waiting for the one
    /// before, would take longer than the rest.
    solve: f64,
    from_above: f64,
    from_below: f64,
}

impl Dashpots {
    pub(crate) fn new<Column: RestoringForce>(row: &Row<Column>) -> Self {
        let floor = |index: &usize| FloorEquation {
            rates: DampingRates::new(row, *index),
            step: 0.0,
            equation: Eliminated::default(),
            solve: 0.0,
            from_above: 0.0,
            from_below: 0.0,
        };
        Self {
            floors: row.buildings().all().iter().map(floor).collect(),
            values: vec![0.0; row.nodes().len()],
        }
    }

    /// Replaces the known values by x on the floors of a building, for a step h \[s\].
    pub(crate) fn solve(&mut self, building: Range<usize>, step: f64) -> &[f64] {
        let floors = &mut self.floors[building.clone()];
        let values = &mut self.values[building];
        if (step - floors[0].step).abs() > 0.0 {
            eliminate(floors, step);
        }
        let mut above = 0.0;
        for (floor, value) in floors.iter().zip(values.iter_mut()).rev() {
            *value = floor.solve * *value + floor.from_above * above;
            above = *value;
        }
        let mut below = 0.0;
        for (floor, value) in floors.iter().zip(values.iter_mut()) {
            *value += floor.from_below * below;
            below = *value;
        }
        values
    }
}

/// Builds the equations of a building for a step.
fn eliminate(floors: &mut [FloorEquation], step: f64) {
    let mut above = None;
    for (level, floor) in floors.iter_mut().enumerate().rev() {
        let weigh = |rate| 0.5 * step * rate;
        floor.equation = Eliminated::new(&floor.rates, level == 0, above.as_ref(), 1.0, weigh);
        floor.solve = 1.0 / floor.equation.pivot;
        floor.from_above = floor.equation.above * floor.solve;
        floor.from_below = floor.equation.below * floor.solve;
        floor.step = step;
        above = Some(floor.equation);
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
            let storey = Storey {
                mass: 1.0 + step,
                damping: if node % 2 == 0 { 1e3 } else { 0.1 * step },
                ground_damping: 0.3 * step,
                column,
            };
            levels.floor(node, storey)
        });
        let row = Row::new(nodes.collect(), vec![]).expect("a valid row");
        let buildings = row.buildings();
        assert_eq!(buildings.all(), [0, 3, 5, 6, 1, 2, 4]);
        let ranges: Vec<_> = buildings.ranges().collect();
        assert_eq!(ranges, [0..4, 4..5, 5..7]);
        let mut dashpots = Dashpots::new(&row);
        for step in [0.1, 7.0, 0.1] {
            let known: Vec<f64> = (0..7_i32).map(|n| f64::from(n * n) - 9.5).collect();
            dashpots.values.copy_from_slice(&known);
            for range in buildings.ranges() {
                let x = dashpots.solve(range.clone(), step).to_vec();
                let at = |floor: Option<usize>| floor.and_then(|floor| x.get(floor)).copied().unwrap_or(0.0);
                for floor in 0..x.len() {
                    let around = [at(floor.checked_sub(1)), x[floor], at(Some(floor + 1))];
                    let rate = dashpots.floors[range.start + floor].rates.deceleration(around);
                    let (sum, known) = (x[floor] + 0.5 * step * rate, known[range.start + floor]);
                    assert!((sum - known).abs() < 1e-10, "{floor}: {sum} {known}");
                }
            }
        }
    }
}
