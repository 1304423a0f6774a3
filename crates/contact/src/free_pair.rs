use crate::form::{Form, Power, Slope};

/// Two masses that collide. No other force acts on them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreePair {
    /// Reduced mass m \[kg\], > 0; see [`crate::reduced_mass`].
    pub reduced_mass: f64,
    /// Approach speed v₀ at the first touch \[m/s\], > 0.
    pub approach_speed: f64,
}

impl FreePair {
    /// Reduced mass and approach speed of 1. Use it for laws whose coefficient of restitution e does not depend on the pair.
    pub const UNIT: Self = Self {
        reduced_mass: 1.0,
        approach_speed: 1.0,
    };

    /// Returns the impulse of the collision \[N·s\] for a coefficient of restitution e \[–\]: H = m (1+e) v₀. This holds for every law.
    pub fn impulse(&self, restitution: f64) -> f64 {
        self.reduced_mass * (1.0 + restitution) * self.approach_speed
    }

    /// Returns the energy that the collision dissipates \[J\] for a coefficient of restitution e \[–\]: ½ m v₀² (1−e²).
    pub fn energy_lost(&self, restitution: f64) -> f64 {
        let lost = (1.0 - restitution) * (1.0 + restitution);
        0.5 * self.reduced_mass * self.approach_speed * self.approach_speed * lost
    }

    /// Deformation \[m\] at which the spring of a form stores a given part \[–\] of the kinetic energy.
    pub(crate) fn deformation(&self, form: &Form, stored: f64) -> f64 {
        let (m, v, spring) = (self.reduced_mass, self.approach_speed, form.spring);
        if let Some(Slope { from, added }) = form.second {
            let first = spring.at(from);
            let rest = stored * m * v * v - first * from;
            if rest > 0.0 {
                // k₂x² + 2 k₁d₁x = rest, with x = δ − d₁.
                let stiffness = spring.coefficient + added;
                return from + rest / (first + (first * first + stiffness * rest).sqrt());
            }
        }
        // K δ^(n+1)/(n+1) = ½ m v₀² · stored.
        let power = spring.power.value() + 1.0;
        let ratio = 0.5 * power * stored * m * v * v / spring.coefficient;
        if spring.power == Power::One {
            ratio.sqrt()
        } else {
            libm::pow(ratio, 1.0 / power)
        }
    }
}
