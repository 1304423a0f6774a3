//! What a reader found in a file, and how it is held against the header and the caller's word.

use super::Format;
use super::component::Component;
use super::spacing::{Spacing, settled};
use crate::direction::is_seismometer;
use crate::record::MAX_SAMPLES;
use crate::unusual::{USUAL_PEAK, USUAL_STEPS};
use crate::{AccelerationUnit, Accelerogram, Declared, Place, ReadError, Reading, Unusual};

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
    /// Accelerations; the file does not say in which unit.
    Acceleration,
    /// Velocities, as the header has it; some such files hold accelerations.
    Velocity(Stated<()>),
    /// Counts of a digitiser, as the file states; of which instrument it does not say.
    Counts(Stated<()>),
    /// The file says nothing.
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
    pub(crate) time_step: Option<Spacing>,
    pub(crate) scale: Scale,
    pub(crate) peak: Option<Peak>,
    pub(crate) provenance: String,
    /// What else bears on the values.
    pub(crate) remarks: Vec<Reading>,
}

impl Draft {
    /// Checks number, quantity, peak and declaration, and makes the accelerogram.
    pub(super) fn settle(
        mut self,
        format: Format,
        component: Option<&Component>,
        declared: &Declared,
    ) -> Result<Accelerogram, ReadError> {
        if self.values.len() > MAX_SAMPLES {
            return Err(ReadError::TooManySamples {
                found: self.values.len(),
                allowed: MAX_SAMPLES,
            });
        }
        let mut readings = vec![reading("format", None, format.name())];
        let velocity = self.velocity(component);
        readings.extend(component.map(|one| reading("component", Some(one.place), &one.name)));
        readings.push(self.count()?);
        if let Some(stated) = velocity.as_ref().filter(|_| !declared.acceleration) {
            return Err(ReadError::Velocity {
                place: stated.place,
                found: stated.text.clone(),
            });
        }
        let mut values = std::mem::take(&mut self.values);
        let largest = values
            .iter()
            .fold(0.0, |peak: f64, value| peak.max(value.abs()));
        let (time_step, reading) = settled(self.time_step.as_ref(), declared, &mut values)?;
        readings.push(reading);
        let (unit, reading) = self.unit(declared)?;
        readings.push(reading);
        let (per_count, reading) = self.per_count(declared)?;
        readings.extend(reading);
        readings.extend(self.peak(largest, unit)?);
        readings.extend(self.remarks);
        if let Some(per_count) = per_count {
            for value in &mut values {
                *value *= per_count;
            }
            if !values.iter().all(|value| value.is_finite()) {
                return Err(ReadError::DeclaredPerCount { found: per_count });
            }
        }
        let peak = largest
            * per_count.map_or(1.0, f64::abs)
            * ratio(unit, AccelerationUnit::StandardGravity);
        Ok(Accelerogram {
            format,
            time_step,
            values,
            unit,
            provenance: self.provenance,
            readings,
            unusual: unusual(time_step, peak, velocity),
            states_acceleration: matches!(self.scale, Scale::Unit(_) | Scale::Acceleration),
        })
    }

    /// What speaks for velocities, where the file does not say that the values are accelerations: its header, or the code of
    /// its channel.
    fn velocity(&self, component: Option<&Component>) -> Option<Stated<()>> {
        match &self.scale {
            Scale::Unit(_) | Scale::Acceleration => None,
            Scale::Velocity(stated) => Some(stated.clone()),
            Scale::Counts(_) | Scale::Unknown => {
                let component = component?;
                let code = component.name.rsplit('.').next()?;
                is_seismometer(code).then(|| Stated {
                    value: (),
                    place: component.place,
                    text: component.name.clone(),
                })
            }
        }
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
            (_, None) => Err(ReadError::UnitNotStated),
            (_, Some(unit)) => {
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
            (_, Some(per_count)) => {
                let found = format!("{per_count} (declared)");
                Ok((
                    Some(per_count),
                    Some(reading("worth of a count", None, &found)),
                ))
            }
            (_, None) => Ok((None, None)),
        }
    }

    /// Holds the largest value against the peak of the header: a check of the unit and of the cut
    /// of the columns that costs nothing.
    fn peak(&self, found: f64, unit: AccelerationUnit) -> Result<Option<Reading>, ReadError> {
        let Some(peak) = &self.peak else {
            return Ok(None);
        };
        let stated = &peak.stated;
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

/// What looks wrong: the time step \[s\], the peak \[g\], or a velocity that is declared to be none.
fn unusual(time_step: f64, peak: f64, velocity: Option<Stated<()>>) -> Vec<Unusual> {
    let step =
        (!USUAL_STEPS.contains(&time_step)).then_some(Unusual::TimeStep { found: time_step });
    let peak = (peak > USUAL_PEAK).then_some(Unusual::Peak { found: peak });
    let velocity = velocity.map(|stated| Unusual::Velocity { found: stated.text });
    [step, peak, velocity].into_iter().flatten().collect()
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
