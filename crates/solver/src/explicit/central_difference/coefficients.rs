//! Constants of the central difference method, computed once per run.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

use crate::Node;

/// Constants of one structure's equation (3), divided by its mass.
#[derive(Debug)]
pub struct Coefficients<N = f64> {
    /// Δt \[s\].
    pub time_step: f64,
    /// 1/m \[1/kg\]; 0 for a wall.
    pub inverse_mass: N,
    /// c/m \[1/s\].
    pub damping: N,
    /// 1/(1/Δt² + c/(2mΔt)).
    pub solve: N,
    /// 1/Δt² − c/(2mΔt).
    pub carry: N,
    /// 1 for a structure, 0 for a wall: walls do not feel inertia.
    pub mobile: N,
}

impl<N: Number> Coefficients<N> {
    /// Acceleration without damping \[m/s²\], from the net pounding force and the restoring force \[N\] and the ground acceleration that
    /// the structure feels.
    #[inline(always)]
    pub fn smooth(&self, pounding: N, restoring: N, ground: N) -> N {
        self.inverse_mass * (pounding - restoring) - ground
    }

    /// The next increment of the displacement \[m\], from the acceleration without damping \[m/s²\] and this increment.
    #[inline(always)]
    pub fn next(&self, load: N, increment: N) -> N {
        self.solve * (load + self.carry * increment)
    }

    /// Velocity at the node between two increments \[m/s\].
    #[inline(always)]
    pub fn velocity(&self, [before, after]: [N; 2]) -> N {
        (after + before) / after.like(2.0 * self.time_step)
    }

    /// Velocity at the end of two increments \[m/s\], of second order: dashpots of links need it before the next increment is known.
    #[inline(always)]
    pub fn extrapolated(time_step: f64, [before, after]: [N; 2]) -> N {
        (after.like(1.5) * after - after.like(0.5) * before) / after.like(time_step)
    }

    /// Increment from the velocity \[m/s\] and acceleration \[m/s²\] at a node, as a textbook begins a run.
    #[inline(always)]
    pub fn restarted(time_step: f64, velocity: N, acceleration: N) -> N {
        let (step, half) = (velocity.like(time_step), velocity.like(0.5 * time_step));
        step * (velocity + half * acceleration)
    }
}

impl<N: Number> Coefficients<N> {
    /// Constants for an inverse mass \[1/kg\] (0 for a wall), a damping coefficient c \[N·s/m\] and a mobility (1, or 0 for a wall).
    #[inline(always)]
    pub fn of(inverse_mass: N, damping: N, mobile: N, dt: f64) -> Self {
        let damping = inverse_mass * damping;
        let like = |value: f64| damping.like(value);
        let (inertia, half) = (like(1.0 / (dt * dt)), like(0.5) * damping / like(dt));
        Self {
            time_step: dt,
            inverse_mass,
            damping,
            solve: like(1.0) / (inertia + half),
            carry: inertia - half,
            mobile,
        }
    }
}

impl Coefficients {
    pub(crate) fn new<Column>(node: &Node<Column>, dt: f64) -> Self {
        Self::of(node.inverse_mass, node.damping, node.mobile(), dt)
    }
}
