//! The balance of momentum of every floor in every step.

use pounding_solver::{Hysteretic, Impact, Path, Recorder, Row, Span};

use super::{DAMPING, SPRING, all, bilinear, facing, run, towers};
use crate::common::{STEREOMECHANICAL, VISCOELASTIC, clock, ground};
use crate::towers::row;

/// Records the residual of the momentum balance of each step.
pub(crate) struct Momentum {
    masses: Vec<f64>,
    /// Stiffness \[N/m\] and damping \[N·s/m\] of the storeys below and above each floor: they scale the rounding of its motion to its
    /// forces.
    storeys: Vec<[f64; 2]>,
    pub(crate) worst: f64,
}

impl Momentum {
    pub(crate) fn new<Column: Hysteretic>(row: &Row<Column>) -> Self {
        let own = |node: usize| {
            let node = &row.nodes()[node];
            [node.column.stiffness(), node.damping]
        };
        let both = |node: usize| {
            let above = row.above(node).map_or([0.0; 2], own);
            [own(node)[0] + above[0], own(node)[1] + above[1]]
        };
        let masses = row.nodes().iter().map(|node| 1.0 / node.inverse_mass);
        Self {
            masses: masses.collect(),
            storeys: (0..row.nodes().len()).map(both).collect(),
            worst: 0.0,
        }
    }
}

impl Recorder for Momentum {
    fn reads_weighed(&self) -> bool {
        true
    }

    fn span(&mut self, span: &Span<'_>) {
        let Path::Cubic(weighed) = span.path else {
            return;
        };
        let mass = self.masses[span.structure];
        let terms = [
            weighed.restoring,
            weighed.damping,
            -mass * weighed.ground_velocity,
            span.impulse_from_left,
            span.impulse_from_right,
            -mass * span.end.velocity,
            mass * span.start.velocity,
        ];
        let scale = terms.iter().map(|term| term.abs()).sum::<f64>().max(1.0);
        let [stiffness, damping] = self.storeys[span.structure];
        let [start, end] = [&span.start, &span.end].map(|state| stiffness * state.displacement.abs() + damping * state.velocity.abs());
        let rounding = 32.0 * f64::EPSILON * start.max(end) * span.duration();
        let left = (terms.iter().sum::<f64>().abs() - rounding).max(0.0);
        self.worst = self.worst.max(left / scale);
    }

    fn impact(&mut self, _: &Impact) {}
}

#[test]
fn limit_every_floor_keeps_its_balance_of_momentum() {
    for law in [SPRING, VISCOELASTIC, STEREOMECHANICAL] {
        let (row, _) = row(&towers(bilinear), DAMPING, facing(0.005, law));
        for (name, method) in all() {
            let mut momentum = Momentum::new(&row);
            run(&row, method, (&ground(), clock(2e-3, 5.0)), &mut momentum);
            assert!(momentum.worst < 1e-11, "{name}: {:e}", momentum.worst);
        }
    }
}
