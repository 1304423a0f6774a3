//! What a floor on the ground knows of the friction below it.

use crate::roots::CAPACITY;
use crate::{Hysteresis, Knee};

/// Friction below a floor.
#[derive(Debug, Clone)]
pub(super) struct Stick {
    /// Mass of the floor \[kg\], which is infinite to others while it sticks.
    pub(super) mass: f64,
    /// The floor begins to slide at this instant, without an acceleration.
    pub(super) begins: bool,
    /// The friction that holds the floor has an extremum at this instant.
    pub(super) peaked: bool,
    /// Coefficients of the friction that holds the floor \[N\].
    pub(super) force: [f64; CAPACITY],
}

impl Stick {
    /// `None` for columns without friction.
    pub(super) fn of(columns: Hysteresis, mass: f64) -> Option<Box<Self>> {
        (columns.knee == Knee::Rigid && mass.is_finite()).then(|| {
            Box::new(Self {
                mass,
                begins: false,
                peaked: false,
                force: [0.0; CAPACITY],
            })
        })
    }
}
