//! Forces of viscous damping that no building may have: those of dashpots to the ground, and those of dampers that keep the stiffness before
//! yielding.

use std::f64::consts::PI;

use crate::{RunResult, Simulation, Structure};

/// The part of a building's damping that is proportional to mass, at the peak of its run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassDamping {
    /// First period \[s\] with the stiffness that the peak drift of each storey leaves: peak shear force over peak drift.
    pub period_s: f64,
    /// Its damping ratio at this period \[–\].
    pub ratio: f64,
}

impl Simulation {
    /// Peak force of the damper beside the columns of every storey \[N\], in the order of the row: without dashpots to the ground. Empty if
    /// drift rates were not asked for. If damping follows the tangent stiffness and the storey yields, it is the force of the damping that
    /// yielding leaves, at the peak rate.
    pub(crate) fn damper_forces(&self, result: &RunResult) -> Vec<f64> {
        let Some(rates) = &result.drift_rates else {
            return Vec::new();
        };
        let floors = self.floors();
        let mut forces = vec![0.0; floors.all().len()];
        for (index, structure) in self.scene().structures.iter().enumerate() {
            let coefficients = match structure {
                Structure::Sdof(sdof) => vec![((sdof.damping_coefficient(), 0.0), sdof.elastic_damping())],
                Structure::Building(building) => building.dampings().into_iter().zip(building.elastic_dampings()).collect(),
                Structure::Wall => continue,
            };
            for (floor, ((coefficient, _), elastic)) in floors.of_structure(index).iter().zip(coefficients) {
                let drift = result.peaks.of(*floor).drift().value.abs();
                let yields = floors.all()[*floor].ductility(drift).is_some_and(|ductility| ductility > 1.0);
                let left = if yields { coefficient - elastic } else { coefficient };
                forces[*floor] = left * rates.of(*floor).value.abs();
            }
        }
        forces
    }

    /// The mass term of a building's damping at the peak of a run; `None` for a wall, for one storey, whose damper stands beside its
    /// columns, and without a mass term.
    ///
    /// α/(2ω) with the frequency ω of the secant stiffnesses. The dashpots act between floors and ground, where a building has none. They
    /// matter the more the softer the building becomes: J. F. Hall, *Earthq. Eng. Struct. Dyn.* 35 (2006) 525.
    pub fn mass_damping(&self, result: &RunResult, structure: usize) -> Option<MassDamping> {
        let Structure::Building(building) = &self.scene().structures[structure] else {
            return None;
        };
        let factor = building.mass_damping();
        if factor <= 0.0 {
            return None;
        }
        let floors = self.floors().of_structure(structure).iter();
        let secant = |(floor, storey): (&usize, &crate::Storey)| {
            let peaks = result.peaks.of(*floor);
            let (drift, stiffness) = (peaks.drift().value.abs(), storey.columns.stiffness_n_per_m);
            let has_yielded = self.floors().all()[*floor]
                .ductility(drift)
                .is_some_and(|ductility| ductility > 1.0);
            if has_yielded {
                peaks.column_force().value.abs() / drift
            } else {
                stiffness
            }
        };
        let secants: Vec<f64> = floors.zip(&building.storeys).map(secant).collect();
        let period_s = building.period_with(&secants)?;
        Some(MassDamping {
            period_s,
            ratio: factor * period_s / (4.0 * PI),
        })
    }
}
