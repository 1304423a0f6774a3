//! Constants of the central difference method, computed once per run.

use crate::buildings::Buildings;
use crate::dashpots::{DampingRates, Eliminated};
use crate::{Node, RestoringForce, Row};

/// Constants of one structure's equation (3), divided by its mass.
pub(super) struct Coefficients {
    pub(super) time_step: f64,
    pub(super) inverse_mass: f64,
    /// c/m.
    pub(super) damping: f64,
    /// 1/(1/Δt² + c/(2mΔt)).
    pub(super) solve: f64,
    /// 1/Δt² − c/(2mΔt).
    pub(super) carry: f64,
    /// 1 for a structure, 0 for a wall: walls do not feel inertia.
    pub(super) mobile: f64,
}

impl Coefficients {
    pub(super) fn new<Column>(node: &Node<Column>, dt: f64) -> Self {
        let damping = node.inverse_mass * node.damping;
        let (inertia, half) = (1.0 / (dt * dt), 0.5 * damping / dt);
        Self {
            time_step: dt,
            inverse_mass: node.inverse_mass,
            damping,
            solve: 1.0 / (inertia + half),
            carry: inertia - half,
            mobile: if node.is_wall() { 0.0 } else { 1.0 },
        }
    }
}

/// Constants of the equation of a floor that is joined to the floors below and above.
pub(super) struct FloorCoefficients {
    /// With c of all its dashpots; what it solves is less by what the elimination of the floors above took.
    pub(super) own: Coefficients,
    pub(super) rates: DampingRates,
    /// c/(2mΔt) of the dashpot to the floor below, m the mass of this floor.
    pub(super) below: f64,
    /// The same of that to the floor above.
    pub(super) above: f64,
    /// What of the next increment of the floor below is added to that of this one.
    pub(super) share: f64,
}

impl FloorCoefficients {
    /// Of all floors, building by building, for steps of this length \[s\].
    pub(super) fn of<Column: RestoringForce>(
        row: &Row<Column>,
        buildings: &Buildings,
        dt: f64,
    ) -> Vec<Self> {
        let (inertia, weigh) = (1.0 / (dt * dt), |rate: f64| 0.5 * rate / dt);
        let mut all = Vec::with_capacity(row.nodes().len());
        for building in buildings.each() {
            let (first, mut above) = (all.len(), None);
            for index in building.iter().rev() {
                let rates = DampingRates::new(row, *index);
                let parts = (&rates, *index == building[0]);
                let equation = Eliminated::new(parts, above.as_ref(), inertia, weigh);
                let solve = 1.0 / equation.pivot;
                let half = weigh(rates.storey) + weigh(rates.ground) + weigh(rates.above);
                all.push(Self {
                    own: Coefficients {
                        solve,
                        carry: inertia - half,
                        ..Coefficients::new(&row.nodes()[*index], dt)
                    },
                    rates,
                    below: equation.below,
                    above: equation.above,
                    share: equation.below * solve,
                });
                above = Some(equation);
            }
            all[first..].reverse();
        }
        all
    }
}
