//! Stability limits of the time step.

use nalgebra::DMatrix;

use crate::{AnyRow, Hysteretic, Integrator, LinkLaw, Mode, Newmark, OnRow, Oscillation, Rk4, Row};

impl Integrator {
    /// Largest stable time step \[s\] of a structure of one storey that moves alone; `None` for a method without a limit.
    ///
    /// 2/ω for the central difference and the Verlet method, for any damping. For Newmark's method with β < γ/2: (ζ(γ − ½) + √(γ/2 − β +
    /// ζ²(γ − ½)²)) / (ω(γ/2 − β)). For the Runge–Kutta method: [`Rk4::critical_time_step`].
    pub fn critical_time_step(&self, structure: &Oscillation) -> Option<f64> {
        self.limit(structure, 1, 0.0)
    }

    /// Largest stable time step of a building with these natural modes: the smallest limit of its modes \[s\].
    ///
    /// Usually this is the limit of the fastest mode. If damping shifts a limit, a slower mode with another ratio may have the smallest.
    /// `None` for a building that nothing holds. Columns that yield only become softer.
    pub fn critical_time_step_of(&self, building: &[Mode]) -> Option<f64> {
        let held = building.iter().filter(|mode| mode.angular_frequency > 0.0);
        held.filter_map(|mode| self.critical_time_step(&mode.oscillation()))
            .min_by(f64::total_cmp)
    }

    /// Largest stable time step of a pair that stays in touch, with the tangents of the contact law \[s\].
    ///
    /// The central difference method takes the rate of deformation from the step before: 2(√(1 + ζ²) − ζ)/ω, times the number of sub-steps
    /// in contact. The Verlet method predicts the rate a step ahead: 2(√(1 + 4ζ²) − 2ζ)/ω. For other methods see
    /// [`Self::critical_time_step`].
    pub fn critical_time_step_in_contact(&self, pair: &Oscillation) -> Option<f64> {
        let sub_steps = match self {
            Self::CentralDifference(settings) => settings.contact_substeps,
            Self::Newmark(_) | Self::Hht(_) | Self::Verlet(_) | Self::Rk4(_) | Self::MoreauJean(_) | Self::Exact(_) => 1,
        };
        self.limit(pair, sub_steps, pair.damping_ratio)
    }

    /// Largest stable time step \[s\] of the central difference method in a row with links while nothing touches. Returns `None` if the given
    /// step is below this limit, if the row has no links, and for other methods.
    ///
    /// Let K be the stiffness of columns and links, and C the dashpots of links. Steps h are stable as long as 4M − h²K − 4hC is positive
    /// definite. Dashpots of storeys are part of the equations and set no limit. A restrainer becomes taut and slack within steps, and gains
    /// energy each time where the step is long: rows with one have half of the limit.
    pub fn limit_of_links(&self, row: &AnyRow, time_step: f64) -> Option<f64> {
        if row.links().is_empty() || !matches!(self, Self::CentralDifference(_)) {
            return None;
        }
        let [stiffness, damping] = row.on(Scaled);
        let n = stiffness.nrows();
        let gains = row.links().iter().any(|link| matches!(link.law, LinkLaw::Restrainer(_)));
        let is_stable = |step: f64| {
            let step = if gains { 2.0 * step } else { step };
            let rest = DMatrix::from_diagonal_element(n, n, 4.0) - &stiffness * (step * step) - &damping * (4.0 * step);
            rest.cholesky().is_some()
        };
        if is_stable(time_step) {
            return None;
        }
        let (mut stable, mut unstable) = (0.0, time_step);
        for _ in 0..f64::MANTISSA_DIGITS {
            let middle = 0.5 * (stable + unstable);
            if is_stable(middle) {
                stable = middle;
            } else {
                unstable = middle;
            }
        }
        Some(unstable)
    }

    /// The limit with this many sub-steps. `explicit` is the part of the damping ratio whose force does not follow from the motion at its
    /// own instant.
    fn limit(&self, oscillation: &Oscillation, sub_steps: u32, explicit: f64) -> Option<f64> {
        let omega = oscillation.angular_frequency;
        let lagged = |ratio: f64| 2.0 * ((1.0 + ratio * ratio).sqrt() - ratio) / omega;
        match *self {
            Self::CentralDifference(_) => Some(f64::from(sub_steps) * lagged(explicit)),
            Self::Verlet(_) => Some(lagged(2.0 * explicit)),
            Self::Newmark(Newmark { beta, gamma }) if beta < 0.5 * gamma => {
                let (stable, damps) = (0.5 * gamma - beta, (gamma - 0.5) * oscillation.damping_ratio);
                Some((damps + (stable + damps * damps).sqrt()) / (stable * omega))
            }
            Self::Rk4(_) => Some(Rk4::critical_time_step(omega, oscillation.damping_ratio)),
            Self::Newmark(_) | Self::Hht(_) | Self::MoreauJean(_) | Self::Exact(_) => None,
        }
    }
}

/// M^(−1/2) K M^(−1/2) \[1/s²\] of columns and links, and M^(−1/2) C M^(−1/2) \[1/s\] of the dashpots of links.
struct Scaled;

impl OnRow for Scaled {
    type Output = [DMatrix<f64>; 2];

    fn on<Column: Hysteretic>(self, row: &Row<Column>) -> [DMatrix<f64>; 2] {
        let nodes = row.nodes();
        let mut scaled = [0, 1].map(|_| DMatrix::zeros(nodes.len(), nodes.len()));
        // Walls have no mobility, and drop out.
        let root = |node: usize| nodes[node].inverse_mass.sqrt();
        let add = |matrix: &mut DMatrix<f64>, value: f64, parts: &[(usize, f64)]| {
            for (one, part) in parts {
                for (other, by) in parts {
                    matrix[(*one, *other)] += value * (root(*one) * part) * (root(*other) * by);
                }
            }
        };
        let [stiffness, damping] = &mut scaled;
        for (index, node) in nodes.iter().enumerate() {
            let below = node.support.below().map(|below| (below, -1.0));
            let parts: Vec<_> = below.into_iter().chain([(index, 1.0)]).collect();
            add(stiffness, node.column.stiffness(), &parts);
        }
        for link in row.links() {
            let parts: Vec<_> = link.relation.pushes().collect();
            add(stiffness, link.law.stiffness(), &parts);
            add(damping, link.law.dashpot(), &parts);
        }
        scaled
    }
}
