//! The columns of a storey, each loop written from its source.
//!
//! d is the drift, k the stiffness, `f_y` the yield force and a the ratio of the stiffness after yielding to k. The sources are those given
//! for the columns of `pounding_solver`.

use pounding_solver::{Hysteresis, Knee};

/// Sign of a number as a factor, 1 or −1.
///
/// Zero counts as negative: if the number then rises, this is an ordinary event, at once.
pub(super) fn sign(value: f64) -> f64 {
    if value > 0.0 { 1.0 } else { -1.0 }
}

/// Branch of the columns.
#[derive(Debug, Clone, Copy)]
pub(super) enum Branch {
    /// The force is k (d − plastic displacement).
    Elastic { plastic_displacement: f64 },
    /// The yielding part has this force \[N\].
    Yielding { force: f64 },
    /// Columns that yield smoothly, while the elastic part of their drift has the sign `side`.
    Smooth { side: f64 },
}

/// A floor with the storey below it, or a wall with inverse mass 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Structure {
    pub inverse_mass: f64,
    /// Floor on which the storey stands; `None` on the ground.
    pub below: Option<usize>,
    /// The lowest of the floors that move each other through storeys and links.
    pub body: usize,
    /// Damping coefficient of the storey \[N·s/m\].
    pub damping: f64,
    /// What yielding takes of it \[N·s/m\].
    pub elastic_damping: f64,
    /// Damping coefficient of the floor against the ground, in addition to that of a storey on the ground \[N·s/m\].
    pub ground_damping: f64,
    pub columns: StoreyColumns,
    /// Friction beside the columns of a storey on the ground.
    pub friction: Option<Friction>,
    /// Arrival of the ground motion \[s\].
    pub arrival: f64,
    pub initial_displacement: f64,
    pub initial_velocity: f64,
}

/// Coulomb friction below a floor.
#[derive(Debug, Clone, Copy)]
pub(super) struct Friction {
    /// Largest force \[N\].
    pub limit: f64,
    /// Inverse of the floor's mass \[1/kg\]; that of its structure is 0 while the floor sticks.
    pub inverse_mass: f64,
    /// Index of the impulse of the friction in the vector of unknowns.
    pub unknown: usize,
}

/// Columns of a storey.
#[derive(Debug, Clone, Copy)]
pub(super) struct StoreyColumns {
    /// k \[N/m\].
    pub stiffness: f64,
    /// `f_y` \[N\]; infinite for columns that never yield.
    pub yield_force: f64,
    /// a \[–\].
    pub hardening: f64,
    /// `None` for columns with a sharp knee or that never yield.
    pub smooth: Option<Smooth>,
}

/// Bouc–Wen columns: f = a k d + (1 − a) k z, ż = ḋ (1 − |z k/`f_y`|ⁿ (1 − β + β sgn(z ḋ))).
#[derive(Debug, Clone, Copy)]
pub(super) struct Smooth {
    /// Index of z \[m\] in the vector of unknowns.
    pub unknown: usize,
    /// n.
    pub exponent: u32,
    /// β.
    pub unloading: f64,
}

/// Steps per drift of `f_y`/(k n) in the computation of z at t = 0: an error of 1e-14.
const INITIAL_STEPS: f64 = 1000.0;

/// Drift, in units of `f_y`/k, beyond which z is `f_y`/k to rounding.
const FAR: f64 = 60.0;

impl StoreyColumns {
    pub(super) fn of(loop_of: Hysteresis) -> Self {
        let Hysteresis {
            stiffness,
            hardening,
            yield_force,
            knee,
        } = loop_of;
        // Friction is apart from the columns, which never yield.
        let [hardening, yield_force] = match knee {
            Knee::Rigid => [0.0, f64::INFINITY],
            Knee::Smooth(_) | Knee::Sharp => [hardening, yield_force],
        };
        let smooth = match knee {
            // The model numbers the unknown.
            Knee::Smooth(shape) if yield_force.is_finite() => Some(Smooth {
                unknown: 0,
                exponent: shape.exponent,
                unloading: shape.unloading,
            }),
            Knee::Smooth(_) | Knee::Sharp | Knee::Rigid => None,
        };
        Self {
            stiffness,
            yield_force,
            hardening,
            smooth,
        }
    }

    /// Force of the spring that never yields, in addition to the yielding part \[N\].
    fn hardened(&self, drift: f64) -> f64 {
        self.hardening * self.stiffness * drift
    }

    /// Largest force of the yielding part \[N\].
    pub(super) fn limit(&self) -> f64 {
        (1.0 - self.hardening) * self.yield_force
    }

    /// dz/dd for z with the sign `side` and a drift that grows in `direction`.
    pub(super) fn bend(&self, smooth: Smooth, z: f64, side: f64, direction: f64) -> f64 {
        let y = side * (z * self.stiffness / self.yield_force);
        let mut power = 1.0;
        for _ in 0..smooth.exponent {
            power *= y;
        }
        let Smooth { unloading, .. } = smooth;
        1.0 - power * (1.0 - unloading + unloading * side * direction)
    }

    /// z after a first drift from 0 \[m\].
    pub(super) fn loaded(&self, smooth: Smooth, drift: f64) -> f64 {
        let unit = self.yield_force / self.stiffness;
        let side = sign(drift);
        let way = drift.abs().min(FAR * unit);
        let steps = (way / unit * INITIAL_STEPS * f64::from(smooth.exponent)).ceil();
        let (h, mut z, mut step) = (side * way / steps, 0.0, 0.0);
        let slope = |z: f64| self.bend(smooth, z, side, side);
        while step < steps {
            let first = slope(z);
            let second = slope(z + 0.5 * h * first);
            let third = slope(z + 0.5 * h * second);
            let fourth = slope(z + h * third);
            z += h * (first + 2.0 * second + 2.0 * third + fourth) / 6.0;
            step += 1.0;
        }
        z
    }

    /// Branch at t = 0, after a first drift from 0 \[m\].
    pub(super) fn first_branch(&self, drift: f64) -> Branch {
        if self.smooth.is_some() {
            return Branch::Smooth { side: sign(drift) };
        }
        let force = self.stiffness * drift - self.hardened(drift);
        let excess = force - force.clamp(-self.limit(), self.limit());
        let plastic_displacement = if excess == 0.0 { 0.0 } else { excess / self.stiffness };
        Branch::Elastic { plastic_displacement }
    }

    /// Force \[N\] on a branch.
    pub(super) fn force(&self, branch: Branch, drift: f64, y: &[f64]) -> f64 {
        match (branch, self.smooth) {
            (Branch::Elastic { plastic_displacement }, _) => self.stiffness * (drift - plastic_displacement),
            (Branch::Yielding { force }, _) => force + self.hardened(drift),
            (Branch::Smooth { .. }, smooth) => {
                let z = smooth.map_or(0.0, |smooth| y[smooth.unknown]);
                self.hardened(drift) + (1.0 - self.hardening) * self.stiffness * z
            }
        }
    }

    /// Yielding part \[N\] of a total force.
    pub(super) fn yielding_part(&self, force: f64, drift: f64) -> f64 {
        force - self.hardened(drift)
    }

    /// The force \[N\], limited to the yield force despite rounding.
    pub(super) fn bounded(&self, force: f64, drift: f64) -> f64 {
        if self.smooth.is_some() {
            return force;
        }
        let (hardened, limit) = (self.hardened(drift), self.limit());
        force.clamp(hardened - limit, hardened + limit)
    }

    /// The elastic branch of columns that unload at a drift, from a `force` \[N\] of their yielding part.
    pub(super) fn unloading(&self, force: f64, drift: f64) -> Branch {
        let elastic = (force + self.hardened(drift)) / self.stiffness;
        Branch::Elastic {
            plastic_displacement: drift - elastic,
        }
    }
}
