//! Free flight of a structure on a single line of its columns, between two samples of the ground motion.

use super::{Path, Power, Series, Span, value};

/// Most coefficients of an expansion.
const MOST: usize = 24;

/// The motion m ü + c u̇ + f = −m `a_g` from a start, with f linear in u and `a_g` linear in time.
///
/// Its power series are expanded only if the motion between the ends is needed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// Instant of the start \[s\].
    pub origin: f64,
    /// Displacement \[m\], velocity \[m/s\] and restoring force \[N\] at the start.
    pub displacement: f64,
    /// Velocity at the start \[m/s\].
    pub velocity: f64,
    /// Restoring force at the start \[N\].
    pub restoring_force: f64,
    /// Stiffness k \[N/m\].
    pub stiffness: f64,
    /// Damping coefficient c \[N·s/m\].
    pub damping: f64,
    /// 1/m \[1/kg\].
    pub inverse_mass: f64,
    /// Ground acceleration at the start \[m/s²\] and its slope \[m/s³\].
    pub ground: [f64; 2],
    /// Number of coefficients down to rounding.
    pub len: usize,
}

/// Storage for the power series of a [`Flight`].
#[derive(Debug, Clone, Default)]
pub struct Expansion {
    displacement: [f64; MOST],
    velocity: [f64; MOST],
    acceleration: [f64; MOST],
}

impl Expansion {
    /// Coefficients of the displacement.
    pub fn displacement(&self, len: usize) -> &[f64] {
        &self.displacement[..len]
    }

    /// Coefficients of the velocity.
    pub fn velocity(&self, len: usize) -> &[f64] {
        &self.velocity[..len]
    }

    /// Coefficients of the acceleration.
    pub fn acceleration(&self, len: usize) -> &[f64] {
        &self.acceleration[..len]
    }
}

impl Flight {
    /// Expands the motion with the same operations as the exact method for a structure alone.
    pub fn expand(&self, room: &mut Expansion) {
        let (mut u, mut v) = (self.displacement, self.velocity);
        let mut force = self.restoring_force;
        for n in 0..self.len {
            let ground = self.ground.get(n).copied().unwrap_or(0.0);
            let a = self.acceleration(v, force, ground);
            (room.displacement[n], room.velocity[n], room.acceleration[n]) = (u, v, a);
            let next = 1.0 / (n + 1) as f64;
            (u, v) = (v * next, a * next);
            force = self.stiffness * u;
        }
    }

    /// Displacement \[m\] and velocity \[m/s\] after a time.
    pub fn ends(&self, time: f64) -> [f64; 2] {
        let mut room = Expansion::default();
        self.expand(&mut room);
        let ends = [room.displacement(self.len), room.velocity(self.len)];
        ends.map(|series| value(series, time))
    }

    /// Acceleration relative to the ground, from velocity, restoring force and ground acceleration.
    #[inline]
    pub fn acceleration(&self, velocity: f64, force: f64, ground: f64) -> f64 {
        self.inverse_mass * (0.0 - (self.damping * velocity + force)) - ground
    }

    /// The expansion as a path.
    fn series<'a>(&self, room: &'a Expansion) -> Series<'a> {
        Series {
            origin: self.origin,
            power: Power::One,
            end: f64::INFINITY,
            displacement: room.displacement(self.len),
            velocity: room.velocity(self.len),
            acceleration: room.acceleration(self.len),
            below: None,
            restoring_force: (self.restoring_force, self.stiffness),
            bent: &[],
            force_from_left: &[],
            force_from_right: &[],
        }
    }
}

impl<'a> Span<'a> {
    /// The span with the series of its free flight expanded; other spans are unchanged.
    #[inline]
    #[must_use]
    pub fn expanded(&self, room: &'a mut Expansion) -> Self {
        match self.path {
            Path::Flight(flight) => {
                flight.expand(room);
                Span {
                    path: Path::Series(flight.series(room)),
                    ..*self
                }
            }
            Path::Cubic(_) | Path::Series(_) => *self,
        }
    }
}
