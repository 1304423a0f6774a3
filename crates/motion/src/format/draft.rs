//! Result of a reader, and its comparison with the header and the declaration.

use crate::refusals;
use pounding_text::{Knob, RefusalKind, plain, short};

use super::Format;
use super::component::Component;
use super::spacing::{self, Spacing};
use crate::direction::is_seismometer;
use crate::shape;
use crate::{AccelerationUnit, Accelerogram, Declared, FilePlace, Reading, Refused, Unusual};

/// A statement of a file, with its place and its text.
#[derive(Clone, Debug)]
pub(crate) struct Stated<T> {
    pub(crate) value: T,
    pub(crate) place: FilePlace,
    pub(crate) text: String,
}

/// Quantity and unit of the values of a file.
#[derive(Clone, Debug)]
pub(crate) enum Scale {
    /// Accelerations in a unit that the file states.
    Unit(Stated<AccelerationUnit>),
    /// Accelerations whose unit the file states in contradictory ways.
    Several(Vec<Stated<AccelerationUnit>>),
    /// Accelerations in an unstated unit.
    Acceleration,
    /// Velocities according to the header; some such files hold accelerations.
    Velocity(Stated<()>),
    /// Displacements according to the header.
    Displacement(Stated<()>),
    /// Counts of a digitiser, whose value the file does not give.
    Counts(Stated<()>),
    /// The file says nothing.
    Unknown,
}

/// The peak that a header states.
#[derive(Clone, Debug)]
pub(crate) struct Peak {
    pub(crate) stated: Stated<f64>,
    /// Unit of the last printed digit.
    pub(crate) digit: f64,
    /// Unit of the peak, if it may differ from that of the values.
    pub(crate) unit: Option<AccelerationUnit>,
}

/// Result of a reader, before its comparison with the header and the declaration.
#[derive(Debug)]
pub(crate) struct Draft {
    pub(crate) values: Vec<f64>,
    /// Place of the last value.
    pub(crate) end: FilePlace,
    /// Unit of the last printed digit of the largest value; 0 if values are not printed.
    pub(crate) digit: f64,
    pub(crate) count: Option<Stated<usize>>,
    pub(crate) time_step: Option<Spacing>,
    pub(crate) scale: Scale,
    pub(crate) peak: Option<Peak>,
    pub(crate) provenance: String,
    /// Other information about the values.
    pub(crate) remarks: Vec<Reading>,
}

/// Whether a unit is alone, or follows the name of an acceleration or of a direction: `g`, `acc (g)`, `EW (gal)`; not `Sae (g)`.
fn calls_acceleration(unit: &str) -> bool {
    let name = unit.split(['(', '[']).next().unwrap_or_default().trim();
    let capitals = name.to_ascii_uppercase();
    name.is_empty()
        || super::title::unit_of(name).is_some()
        || super::title::unit_in(name).is_some()
        || capitals.contains("ACC")
        || ["A", "AG"].contains(&capitals.as_str())
        || crate::Direction::of_component(name).is_some()
}

impl Draft {
    /// Checks number, quantity, peak and declaration, and makes the accelerogram. `ends` tells whether no line of numbers follows the last
    /// value.
    pub(super) fn settle(
        mut self,
        format: Format,
        component: Option<&Component>,
        declared: &Declared,
        ends: bool,
    ) -> Result<Accelerogram, Refused> {
        let mut readings = vec![reading("format", None, format.name())];
        let velocity = self.velocity(component);
        readings.extend(component.map(|one| reading("component", Some(one.place), &one.name)));
        readings.extend(self.count(ends)?);
        self.check_quantity(velocity.as_ref(), declared)?;
        let mut values = std::mem::take(&mut self.values);
        let largest = spacing::peak(&values);
        let one_signed = self.one_signed(&values, format, declared)?;
        let settled = spacing::settled(self.time_step.as_ref(), declared, &mut values)?;
        let time_step = settled.time_step;
        readings.extend(settled.readings);
        let (unit, reading) = self.unit(declared)?;
        readings.push(reading);
        let (per_count, reading) = self.per_count(declared)?;
        readings.extend(reading);
        let (reading, differs) = self.peak(largest, unit)?;
        readings.extend(reading);
        readings.extend(self.remarks);
        if let Some(per_count) = per_count {
            for value in &mut values {
                *value *= per_count;
            }
            if !values.iter().all(|value| value.is_finite()) {
                return Err(bad_per_count(per_count));
            }
        }
        let in_g = unit.worth_in(AccelerationUnit::StandardGravity);
        let peak = largest * per_count.map_or(1.0, f64::abs) * in_g;
        let of_list = self.time_step.is_none().then_some(time_step);
        let is_declared = declared.unit.filter(|_| !matches!(self.scale, Scale::Unit(_)));
        let unusual = Unusual::of_record(time_step, peak)
            .chain(is_declared.and_then(|unit| Unusual::of_unit(unit, peak)))
            .chain(one_signed)
            .chain(shape::unusual(&values, of_list))
            .chain(differs)
            .chain(Unusual::of_resampling(settled.lost))
            .chain(velocity.map(|stated| Unusual::Velocity { found: stated.text }))
            .chain(component.and_then(|one| one.site.off_the_ground()))
            .collect();
        Ok(Accelerogram {
            format,
            time_step,
            values,
            unit,
            provenance: self.provenance,
            readings,
            unusual,
            states_acceleration: matches!(self.scale, Scale::Unit(_) | Scale::Acceleration),
        })
    }

    /// Refuses velocities that are not declared to be accelerations, and displacements.
    fn check_quantity(&self, velocity: Option<&Stated<()>>, declared: &Declared) -> Result<(), Refused> {
        if let Some(stated) = velocity.filter(|_| !declared.acceleration) {
            return Err(Refused::at(stated.place)
                .reads(stated.text.clone())
                .and(", which speaks for velocities")
                .but(", and ", "only histories of acceleration are read")
                .help("take the record of accelerations, such as channel HNE of an accelerometer, or declare ")
                .and(Knob::Acceleration)
                .and(" if the values were turned into accelerations")
                .kind(RefusalKind::Velocity)
                .wants(Knob::Acceleration));
        }
        if let Scale::Displacement(stated) = &self.scale {
            return Err(refusals::not_acceleration(
                stated.place,
                stated.text.clone(),
                "the accelerations of the record, these are displacements",
            ));
        }
        Ok(())
    }

    /// Refuses values of one sign in a plain text that does not call them accelerations. In other files they are unusual.
    fn one_signed(&self, values: &[f64], format: Format, declared: &Declared) -> Result<Option<Unusual>, Refused> {
        let is_called = match &self.scale {
            Scale::Unknown => false,
            Scale::Unit(stated) => calls_acceleration(&stated.text),
            Scale::Several(_) | Scale::Acceleration | Scale::Velocity(_) | Scale::Displacement(_) | Scale::Counts(_) => true,
        };
        let is_told = is_called || !matches!(format, Format::Plain | Format::Eqsig) || declared.acceleration;
        let one_signed = shape::one_signed(values);
        if let Some(Unusual::OneSigned { found, rises }) = one_signed
            && !is_told
        {
            return Err({
                let how = if rises { "only rise" } else { "never change sign" };
                let said = format!(
                    "the {} values that end at {} {how}, like a spectrum and unlike shaking, and the file does not call them accelerations",
                    found, self.end
                );
                Refused::that_at(self.end, said)
                    .help("take the record itself, or declare ")
                    .and(Knob::Acceleration)
                    .and(" if they are accelerations")
                    .wants(Knob::Acceleration)
            });
        }
        Ok(one_signed)
    }

    /// Evidence for velocities, from the header or the code of the channel, if the file does not call the values accelerations.
    fn velocity(&self, component: Option<&Component>) -> Option<Stated<()>> {
        match &self.scale {
            Scale::Unit(_) | Scale::Several(_) | Scale::Acceleration | Scale::Displacement(_) => None,
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

    /// Compares the number of values with that of the header. A small difference is reported, not refused: programs count steps, or the
    /// line of the header.
    fn count(&self, ends: bool) -> Result<Vec<Reading>, Refused> {
        let found = self.values.len();
        if found == 0 && self.count.is_none() {
            return Err(refusals::empty());
        }
        let place = self.count.as_ref().map(|count| count.place);
        let mut readings = vec![reading("number of samples", place, &found.to_string())];
        if let Some(count) = &self.count
            && count.value != found
        {
            let off = found.abs_diff(count.value);
            if off > MOST_OFF || off > found / 100 || !ends {
                return Err(refusals::sample_count(self.end, found, count.value));
            }
            let found = format!("{found} values, where the header declares {}", count.value);
            readings.push(reading("count", place, &found));
        }
        Ok(readings)
    }

    fn unit(&self, declared: &Declared) -> Result<(AccelerationUnit, Reading), Refused> {
        match (&self.scale, declared.unit) {
            (Scale::Unit(stated), Some(unit)) if unit != stated.value => Err(Refused::at(stated.place)
                .goes_on(format!("says that the values are in {}", stated.value.name()))
                .but(", but ", unit.name())
                .and(" is declared as ")
                .and(Knob::Unit)
                .help("leave the declaration away")),
            (Scale::Unit(stated), _) => {
                let found = format!("{} ({})", stated.value.symbol(), stated.text);
                let place = Some(stated.place);
                Ok((stated.value, reading("unit", place, &found)))
            }
            (Scale::Several(several), declared) => {
                let meant = declared.and_then(|unit| several.iter().find(|one| one.value == unit));
                let meant = meant.ok_or_else(|| {
                    let said = several.iter().map(|one| (one.place, one.value.name().to_owned()));
                    refusals::several("unit", Knob::Unit, said)
                })?;
                let found = format!("{} ({})", meant.value.symbol(), meant.text);
                Ok((meant.value, reading("unit", Some(meant.place), &found)))
            }
            (Scale::Counts(stated), None) => Err(counts(stated)),
            (_, None) => Err(Refused::that("the file does not say in which unit its values are")
                .help("declare it as ")
                .and(Knob::Unit)
                .and(format!(", one of {}", AccelerationUnit::names()))
                .wants(Knob::Unit)),
            (_, Some(unit)) => {
                let found = format!("{} (declared)", unit.symbol());
                Ok((unit, reading("unit", None, &found)))
            }
        }
    }

    fn per_count(&self, declared: &Declared) -> Result<(Option<f64>, Option<Reading>), Refused> {
        if let Some(found) = declared.per_count
            && !(found.is_finite() && found != 0.0)
        {
            return Err(bad_per_count(found));
        }
        match (&self.scale, declared.per_count) {
            (Scale::Unit(stated), Some(declared)) => Err(Refused::at(stated.place)
                .goes_on(format!("says that the values are in {}", stated.value.name()))
                .but(", but ", Knob::PerCount)
                .and(format!(" is declared as {}", plain(declared)))
                .help("leave it away, there are no counts to scale")),
            (Scale::Counts(stated), None) => Err(counts(stated)),
            (_, Some(per_count)) => {
                let found = format!("{per_count} (declared)");
                Ok((Some(per_count), Some(reading("worth of a count", None, &found))))
            }
            (_, None) => Ok((None, None)),
        }
    }

    /// Compares the largest value with the peak of the header. This checks the unit and the division into columns at no cost.
    ///
    /// Some agencies state the peak before their last correction, so a small difference is reported. A large one is refused.
    fn peak(&self, found: f64, unit: AccelerationUnit) -> Result<(Option<Reading>, Option<Unusual>), Refused> {
        let Some(peak) = &self.peak else {
            return Ok((None, None));
        };
        let stated = &peak.stated;
        let of_header = peak.unit.unwrap_or(unit);
        let factor = of_header.worth_in(unit);
        let allowed = stated.value.abs() * factor;
        // Old programs cut digits off instead of rounding: one unit of the last digit for each number.
        let mut slack = peak.digit * factor + self.digit + 1e-9 * allowed;
        if of_header.needs_gravity() != unit.needs_gravity() {
            slack += GRAVITY_SPREAD * allowed;
        }
        let off = (found - allowed).abs();
        // If the units differ, one may be wrong: 1 mg is 0.98 cm/s².
        let most = if of_header == unit { MOST_DIFFERENT * allowed } else { slack };
        if off > slack.max(most) {
            return Err(Refused::at(stated.place)
                .goes_on("states a peak of ")
                .quoted(stated.text.clone())
                .but(", but ", format!("the largest value read is {} {}", plain(found), unit.symbol()))
                .help("one of them is damaged or in another unit: fetch the file again"));
        }
        let said = |text: &str| Some(reading("peak in the header", Some(stated.place), text));
        if off <= slack {
            return Ok((said(&stated.text), None));
        }
        let part = off / allowed;
        let text = format!(
            "{}, but the values reach {} {}, {:.1} % off",
            stated.text,
            short(found),
            unit.symbol(),
            100.0 * part
        );
        Ok((said(&text), Unusual::of_difference(part)))
    }
}

/// Largest accepted difference from the number in the header; it also needs a hundred times as many values.
const MOST_OFF: usize = 2;

/// Largest difference of the largest value from the peak of the header, as a part of the peak. Of 156 components of UNAM with different
/// peaks, 152 differ by less.
const MOST_DIFFERENT: f64 = 0.2;

/// Largest relative difference between programs in the value of g: 978 to 983 cm/s².
const GRAVITY_SPREAD: f64 = 5e-3;

pub(super) fn reading(what: &'static str, place: Option<FilePlace>, found: &str) -> Reading {
    Reading {
        what,
        line: place.and_then(FilePlace::line),
        found: found.to_owned(),
    }
}

fn counts(stated: &Stated<()>) -> Refused {
    Refused::at(stated.place)
        .reads(stated.text.clone())
        .and(": the values are counts of a digitiser")
        .help("declare what one is worth as ")
        .and(Knob::PerCount)
        .and(", and in which ")
        .and(Knob::Unit)
        .wants(Knob::PerCount)
}

fn bad_per_count(found: f64) -> Refused {
    let said = Refused::that("the declared ").and(Knob::PerCount).and(format!(" is {found:?}"));
    said.but(", and must be ", "finite, not 0, and keep every value finite")
}
