//! Contents of a file, before the caller sets the value of one g.

use crate::{AccelerationUnit, Direction, Format, Reading, Record, Refused, Unusual};
use pounding_text::plain;

/// An `Accelerogram` is the contents of a file: a time step, and values in the unit of the file.
///
/// The first value is at t = 0. There is at least one value, all are finite, and the time step is above zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Accelerogram {
    pub(crate) format: Format,
    pub(crate) time_step: f64,
    pub(crate) values: Vec<f64>,
    pub(crate) unit: AccelerationUnit,
    pub(crate) provenance: String,
    pub(crate) readings: Vec<Reading>,
    pub(crate) unusual: Vec<Unusual>,
    pub(crate) states_acceleration: bool,
}

impl Accelerogram {
    /// Returns the format of the file.
    pub fn format(&self) -> Format {
        self.format
    }

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

    /// Returns the description in the file: the comments of a CSV or the title lines of other formats, one per line.
    pub fn provenance(&self) -> &str {
        &self.provenance
    }

    /// Returns the values read from the file with their places: format, component, number of samples, time step, unit, the peak in the
    /// header, and other information about the values.
    pub fn readings(&self) -> &[Reading] {
        &self.readings
    }

    /// Returns the name of the component that was read; `None` if the file has no name.
    pub fn component(&self) -> Option<&str> {
        let component = self.readings.iter().find(|one| one.what == "component")?;
        Some(&component.found)
    }

    /// Returns the direction of the component; `None` if its name does not show it.
    pub fn direction(&self) -> Option<Direction> {
        Direction::of_component(self.component()?)
    }

    /// Returns whether the file states that its values are accelerations, by a unit or in words.
    pub fn states_acceleration(&self) -> bool {
        self.states_acceleration
    }

    /// Returns properties that look wrong and may still be right: an unusual time step, a large peak, a channel of a seismometer.
    pub fn unusual(&self) -> &[Unusual] {
        &self.unusual
    }

    /// Returns the motion with every value multiplied by `factor`, which is among its readings.
    ///
    /// # Errors
    /// Refuses a factor that is not finite, and one that makes a value infinite.
    pub fn times(mut self, factor: f64) -> Result<Self, Refused> {
        for value in &mut self.values {
            *value *= factor;
        }
        if !factor.is_finite() || self.values.iter().any(|value| !value.is_finite()) {
            let found = Refused::default().found(format!("a factor of {}", plain(factor)));
            return Err(found.allowed_is("one that leaves values finite"));
        }
        self.readings.push(Reading {
            what: "factor",
            line: None,
            found: plain(factor),
        });
        Ok(self)
    }

    /// Turns the values into m/s², with one g worth `gravity` \[m/s²\].
    ///
    /// The value of g belongs to the use of a record, not to its file: studies to be compared must use one value. Units without g do not
    /// depend on it. Powers of ten divide, so 12.3 cm/s² become exactly the number written 0.123 m/s².
    ///
    /// # Errors
    /// Refuses a `gravity` that is not finite and above zero, or one that makes a value infinite.
    pub fn into_record(self, gravity: f64) -> Result<Record, Refused> {
        if !(gravity.is_finite() && gravity > 0.0) {
            let found = Refused::at("gravity").found(format!("{} m/s²", plain(gravity)));
            return Err(found.allowed("a finite number > 0, such as 9.81"));
        }
        let mut samples = self.values;
        for sample in &mut samples {
            *sample = self.unit.to_si(*sample, gravity);
        }
        Record::new(self.time_step, samples, self.provenance)
    }
}
