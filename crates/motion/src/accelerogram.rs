//! What a file holds, before the caller says what one g is worth.

use crate::{Record, RecordError};

/// An `AccelerationUnit` is the unit of the values in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccelerationUnit {
    /// Multiples of the acceleration of gravity, g.
    StandardGravity,
    /// Metres per second squared.
    MetrePerSecondSquared,
}

/// An `Accelerogram` is what a file holds: a time step and values in the unit of the file.
///
/// The first value is at t = 0. There is at least one, all are finite, and the time step is above
/// zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Accelerogram {
    pub(crate) time_step: f64,
    pub(crate) values: Vec<f64>,
    pub(crate) unit: AccelerationUnit,
    pub(crate) provenance: String,
}

impl Accelerogram {
    /// Returns the time between two values \[s\], above zero.
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// Returns the ground acceleration at t = 0, Δt, 2Δt, … in the [unit](Self::unit) of the file.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the unit of the values.
    pub fn unit(&self) -> AccelerationUnit {
        self.unit
    }

    /// Returns what the file says of itself: the comments of a CSV or the title lines of an AT2,
    /// one per line.
    pub fn provenance(&self) -> &str {
        &self.provenance
    }

    /// Turns the values into m/s², with one g worth `gravity` \[m/s²\].
    ///
    /// The value of g belongs to the use of a record, not to its file: studies that are compared
    /// with each other must take the same. Values that are in m/s² already are left as they are.
    ///
    /// # Errors
    /// Refuses a `gravity` that is not finite and above zero, or one that makes a value infinite.
    pub fn into_record(self, gravity: f64) -> Result<Record, RecordError> {
        if !(gravity.is_finite() && gravity > 0.0) {
            return Err(RecordError::Gravity { found: gravity });
        }
        let mut samples = self.values;
        match self.unit {
            AccelerationUnit::StandardGravity => {
                for sample in &mut samples {
                    *sample *= gravity;
                }
            }
            AccelerationUnit::MetrePerSecondSquared => {}
        }
        Record::new(self.time_step, samples, self.provenance)
    }
}
