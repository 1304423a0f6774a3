//! Stability limits of the time step.

use crate::{Integrator, Mode, Newmark, Oscillation, Rk4};

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
