//! Constants of the central difference method, computed once per run.

use crate::dashpots::{DampingRates, Eliminated};
use crate::{RestoringForce, Row};

/// Constants of one floor's equation (3), divided by its mass.
pub(super) struct Coefficients {
    pub(super) time_step: f64,
    pub(super) inverse_mass: f64,
    pub(super) rates: DampingRates,
    /// 1/(1/Δt² + c/(2mΔt)), with c of all dashpots of the floor, less what the elimination of the floors above takes away.
    pub(super) solve: f64,
    /// 1/Δt² − c/(2mΔt).
    pub(super) carry: f64,
    /// 1 for a structure, 0 for a wall: walls do not feel inertia.
    pub(super) mobile: f64,
    pub(super) coupling: Coupling,
}

/// What the increments of other floors mean to a floor; 0 where there is none.
pub(super) struct Coupling {
    /// c/(2mΔt) of the dashpot to the floor below.
    pub(super) below: f64,
    /// The same to the floor above, per mass of this floor.
    pub(super) above: f64,
    /// What of the next increment of the floor below is added to that of this one.
    pub(super) share: f64,
}

impl Coefficients {
    /// Of every node, for steps of this length \[s\].
    pub(super) fn of<Column: RestoringForce>(row: &Row<Column>, dt: f64) -> Vec<Self> {
        let inertia = 1.0 / (dt * dt);
        let weigh = |rate: f64| 0.5 * rate / dt;
        let n = row.nodes().len();
        let mut equations = vec![Eliminated::default(); n];
        let mut coefficients = Vec::with_capacity(n);
        for (index, node) in row.nodes().iter().enumerate().rev() {
            let rates = DampingRates::new(row, index);
            let above = row.above(index).map(|above| &equations[above]);
            let equation = Eliminated::new((&rates, &node.support), above, inertia, weigh);
            let solve = 1.0 / equation.pivot;
            coefficients.push(Self {
                time_step: dt,
                inverse_mass: node.inverse_mass,
                solve,
                carry: inertia - weigh(rates.storey) - weigh(rates.ground) - weigh(rates.above),
                mobile: if node.is_wall() { 0.0 } else { 1.0 },
                coupling: Coupling {
                    below: equation.below,
                    above: equation.above,
                    share: equation.below * solve,
                },
                rates,
            });
            equations[index] = equation;
        }
        coefficients.reverse();
        coefficients
    }
}
