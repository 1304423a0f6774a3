//! What a reader found in a file, and how it is held against the header and the caller's word.

use super::Format;
use crate::{AccelerationUnit, Accelerogram, Declared, Place, ReadError, Reading};

/// Something that a file states, with its place and its text.
#[derive(Clone, Debug)]
pub(crate) struct Stated<T> {
    pub(crate) value: T,
    pub(crate) place: Place,
    pub(crate) text: String,
}

/// What the values of a file are.
#[derive(Clone, Debug)]
pub(crate) enum Scale {
    /// Accelerations in a unit that the file states.
    Unit(Stated<AccelerationUnit>),
    /// Counts of a digitiser, as the file states.
    Counts(Stated<()>),
    /// The file does not say.
    Unknown,
}

/// The peak that a header states.
#[derive(Clone, Debug)]
pub(crate) struct Peak {
    pub(crate) stated: Stated<f64>,
    /// Unit of the last digit that is printed.
    pub(crate) digit: f64,
    /// Unit of the peak, where it may be another than that of the values.
    pub(crate) unit: Option<AccelerationUnit>,
}

/// What a reader found in a file, before it is held against the header and the declaration.
#[derive(Debug)]
pub(crate) struct Draft {
    pub(crate) values: Vec<f64>,
    /// Place of the last value.
    pub(crate) end: Place,
    /// Unit of the last printed digit of the largest value; 0 where values are not printed.
    pub(crate) digit: f64,
    pub(crate) count: Option<Stated<usize>>,
    pub(crate) time_step: Option<Stated<f64>>,
    pub(crate) scale: Scale,
    pub(crate) peak: Option<Peak>,
    pub(crate) provenance: String,
    /// What else bears on the values.
    pub(crate) remarks: Vec<Reading>,
}

impl Draft {
    /// Checks number, peak and declaration, and makes the accelerogram.
    pub(super) fn settle(
        self,
        format: Format,
        component: Option<Reading>,
        declared: &Declared,
    ) -> Result<Accelerogram, ReadError> {
        let mut readings = vec![reading("format", None, format.name())];
        readings.extend(component);
        readings.push(self.count()?);
        let (time_step, reading) = self.time_step(declared)?;
        readings.push(reading);
        let (unit, reading) = self.unit(declared)?;
        readings.push(reading);
        let (per_count, reading) = self.per_count(declared)?;
        readings.extend(reading);
        readings.extend(self.peak(unit)?);
        readings.extend(self.remarks);
        let mut values = self.values;
        if let Some(per_count) = per_count {
            for value in &mut values {
                *value *= per_count;
            }
            if !values.iter().all(|value| value.is_finite()) {
                return Err(ReadError::DeclaredPerCount { found: per_count });
            }
        }
        Ok(Accelerogram {
            format,
            time_step,
            values,
            unit,
            provenance: self.provenance,
            readings,
        })
    }

    fn count(&self) -> Result<Reading, ReadError> {
        let found = self.values.len();
        if let Some(count) = &self.count
            && count.value != found
        {
            return Err(ReadError::SampleCount {
                place: self.end,
                found,
                allowed: count.value,
                next: None,
            });
        }
        if found == 0 {
            return Err(ReadError::Empty);
        }
        let place = self.count.as_ref().map(|count| count.place);
        Ok(reading("number of samples", place, &found.to_string()))
    }

    fn time_step(&self, declared: &Declared) -> Result<(f64, Reading), ReadError> {
        if let Some(found) = declared.time_step
            && !(found.is_finite() && found > 0.0)
        {
            return Err(ReadError::DeclaredTimeStep { found });
        }
        match (&self.time_step, declared.time_step) {
            (Some(stated), _) if !(stated.value.is_finite() && stated.value > 0.0) => {
                Err(ReadError::TimeStep {
                    place: stated.place,
                    found: stated.value,
                })
            }
            // A declared step may repeat what the file gives with fewer digits.
            (Some(stated), Some(declared))
                if (stated.value - declared).abs() > 1e-6 * stated.value =>
            {
                Err(ReadError::TimeStepContradiction {
                    place: stated.place,
                    found: stated.value,
                    declared,
                })
            }
            (Some(stated), _) => {
                let found = format!("{} s", stated.value);
                let place = Some(stated.place);
                Ok((stated.value, reading("time step", place, &found)))
            }
            (None, Some(declared)) => {
                let found = format!("{declared} s (declared)");
                Ok((declared, reading("time step", None, &found)))
            }
            (None, None) => Err(ReadError::TimeStepNotStated),
        }
    }

    fn unit(&self, declared: &Declared) -> Result<(AccelerationUnit, Reading), ReadError> {
        match (&self.scale, declared.unit) {
            (Scale::Unit(stated), Some(unit)) if unit != stated.value => {
                Err(ReadError::UnitContradiction {
                    place: stated.place,
                    found: stated.value,
                    declared: unit,
                })
            }
            (Scale::Unit(stated), _) => {
                let found = format!("{} ({})", stated.value.symbol(), stated.text);
                let place = Some(stated.place);
                Ok((stated.value, reading("unit", place, &found)))
            }
            (Scale::Counts(stated), None) => Err(ReadError::Counts {
                place: stated.place,
                found: stated.text.clone(),
            }),
            (Scale::Unknown, None) => Err(ReadError::UnitNotStated),
            (Scale::Counts(_) | Scale::Unknown, Some(unit)) => {
                let found = format!("{} (declared)", unit.symbol());
                Ok((unit, reading("unit", None, &found)))
            }
        }
    }

    fn per_count(&self, declared: &Declared) -> Result<(Option<f64>, Option<Reading>), ReadError> {
        if let Some(found) = declared.per_count
            && !(found.is_finite() && found != 0.0)
        {
            return Err(ReadError::DeclaredPerCount { found });
        }
        match (&self.scale, declared.per_count) {
            (Scale::Unit(stated), Some(declared)) => Err(ReadError::NoCounts {
                place: stated.place,
                found: stated.value,
                declared,
            }),
            (Scale::Counts(stated), None) => Err(ReadError::Counts {
                place: stated.place,
                found: stated.text.clone(),
            }),
            (Scale::Counts(_) | Scale::Unknown, Some(per_count)) => {
                let found = format!("{per_count} (declared)");
                Ok((
                    Some(per_count),
                    Some(reading("worth of a count", None, &found)),
                ))
            }
            (Scale::Unit(_) | Scale::Unknown, None) => Ok((None, None)),
        }
    }

    /// Holds the largest value against the peak of the header: a check of the unit and of the cut
    /// of the columns that costs nothing.
    fn peak(&self, unit: AccelerationUnit) -> Result<Option<Reading>, ReadError> {
        let Some(peak) = &self.peak else {
            return Ok(None);
        };
        let stated = &peak.stated;
        let found = self
            .values
            .iter()
            .fold(0.0, |peak: f64, value| peak.max(value.abs()));
        let of_header = peak.unit.unwrap_or(unit);
        let factor = ratio(of_header, unit);
        let allowed = stated.value.abs() * factor;
        // Old programs cut digits off instead of rounding: one unit of the last digit each.
        let mut slack = peak.digit * factor + self.digit + 1e-9 * allowed;
        if of_header.needs_gravity() != unit.needs_gravity() {
            slack += GRAVITY_SPREAD * allowed;
        }
        let is_near = (found - allowed).abs() <= slack;
        if !is_near {
            return Err(ReadError::Peak {
                place: stated.place,
                stated: stated.text.clone(),
                found,
                unit,
            });
        }
        Ok(Some(reading(
            "peak in the header",
            Some(stated.place),
            &stated.text,
        )))
    }
}

/// Values of g differ between programs by less than this part: 978 to 983 cm/s².
const GRAVITY_SPREAD: f64 = 5e-3;

/// What one of the first unit is in the second.
fn ratio(from: AccelerationUnit, to: AccelerationUnit) -> f64 {
    if from == to {
        return 1.0;
    }
    from.to_si(1.0, 9.806_65) / to.to_si(1.0, 9.806_65)
}

pub(super) fn reading(what: &'static str, place: Option<Place>, found: &str) -> Reading {
    Reading {
        what,
        line: place.and_then(Place::line),
        found: found.to_owned(),
    }
}
