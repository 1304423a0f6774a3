//! Response spectra of a record, by the exact method.
//!
//! The recurrence of Nigam and Jennings takes a hundredth of the time, but it finds peaks only at samples. Tests compare with it.

use crate::{Error, parallel};
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use pounding_motion::Record;
use pounding_solver::{
    AnyRow, Budget, Clock, Damping, Elastic, Exact, Excitation, FloorAccelerations, Integrator, Node, Recorders, Row, RunError,
};
use pounding_text::{Refused, plain};

/// Largest number of values in the spectra of a record, periods times damping ratios. They take an hour for a usual record.
const MOST_VALUES: usize = 1_000_000;

/// The response spectrum of a record for one damping ratio.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Damping ratio \[–\].
    pub damping_ratio: f64,
    /// The largest responses, in the order of their periods.
    pub values: Vec<SpectralValues>,
}

/// The largest responses of one elastic structure to a record.
///
/// A structure of period 0 moves with the ground: its displacement and pseudo-velocity are zero, its accelerations the
/// peak of the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralValues {
    /// Natural period T \[s\].
    pub period: f64,
    /// Spectral displacement Sd, relative to the ground \[m\].
    pub displacement: f64,
    /// Pseudo-velocity (2π/T)·Sd \[m/s\].
    pub pseudo_velocity: f64,
    /// Pseudo-acceleration (2π/T)²·Sd \[m/s²\]; times the mass it is the largest restoring force.
    pub pseudo_acceleration: f64,
    /// Absolute acceleration of the structure \[m/s²\]; without damping it is the pseudo-acceleration.
    pub absolute_acceleration: f64,
}

/// Response spectrum of a record at `periods` \[s\], each 0 or 1e-6 ..= 1e6, in their order, for a damping ratio 0 ..= 1.
///
/// Peaks are found between samples, too. The run lasts one natural period longer than the record: in free vibration the largest magnitude
/// occurs within half a period. Time grows with the number of samples and with the number of natural periods in the record. On one core,
/// 100 periods from 0.02 s to 10 s take 0.4 s for the 1 560 samples of El Centro, and 1 s for 8 000 samples.
///
/// # Errors
/// Refuses a period or a damping ratio out of range, and a period that is shorter than the record by a factor of some hundred thousand.
pub fn response_spectrum(record: &Record, periods: &[f64], damping_ratio: f64) -> Result<Vec<SpectralValues>, Refused> {
    spectrum(record, periods, damping_ratio, None, &|| ())
}

/// Integrals of the response spectrum of a motion, damping 5 %, by the trapezoidal rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectrumIntensities {
    /// ∫ PSV dT from 0.1 to 2.5 s, every 0.1 s \[m\] (G. W. Housner, *Proc. Symp. Earthq. and Blast Effects on Structures* (1952) 20).
    pub housner: f64,
    /// Acceleration spectrum intensity, ∫ PSA dT from 0.1 to 0.5 s, every 0.05 s \[m/s\] (J. L. Von Thun et al. (1988)).
    pub asi: f64,
}

impl SpectrumIntensities {
    /// Measures a record.
    ///
    /// # Errors
    /// Errors of [`response_spectrum`].
    pub fn of(record: &Record) -> Result<Self, Refused> {
        let integral = |periods: Vec<f64>, value: fn(&SpectralValues) -> f64| {
            let values = response_spectrum(record, &periods, 0.05)?;
            let steps = periods.windows(2).zip(values.windows(2));
            Ok::<f64, Refused>(
                steps
                    .map(|(periods, values)| 0.5 * (periods[1] - periods[0]) * (value(&values[0]) + value(&values[1])))
                    .sum(),
            )
        };
        let tenths = (1..=25).map(|n| 0.1 * f64::from(n)).collect();
        let twentieths = (2..=10).map(|n| 0.05 * f64::from(n)).collect();
        Ok(Self {
            housner: integral(tenths, |one| one.pseudo_velocity)?,
            asi: integral(twentieths, |one| one.pseudo_acceleration)?,
        })
    }
}

/// Response spectra for several damping ratios. `done` is called after each period; setting `stop` ends the work.
///
/// # Errors
/// Errors of [`response_spectrum`]; refuses more than a million values.
pub fn response_spectra(
    record: &Record,
    periods: &[f64],
    damping_ratios: &[f64],
    stop: Option<&'static AtomicBool>,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<Spectrum>, Refused> {
    check_number(periods, damping_ratios)?;
    let of_ratio = |&damping_ratio: &f64| {
        Ok(Spectrum {
            damping_ratio,
            values: spectrum(record, periods, damping_ratio, stop, done)?,
        })
    };
    damping_ratios.iter().map(of_ratio).collect()
}

/// Refuses too many values.
fn check_number(periods: &[f64], damping_ratios: &[f64]) -> Result<(), Refused> {
    let (n, ratios) = (periods.len(), damping_ratios.len());
    if n.saturating_mul(ratios) > MOST_VALUES {
        let found = Refused::at("spectra").found(format!("{n} periods times {ratios} damping ratios"));
        let found = found.allowed_are(format!("up to {MOST_VALUES} values"));
        return Err(found.help("ask for fewer periods or ratios"));
    }
    Ok(())
}

/// Refuses periods and damping ratios out of range, and too many of them.
pub(crate) fn check_values(periods: &[f64], damping_ratios: &[f64]) -> Result<(), Refused> {
    check_number(periods, damping_ratios)?;
    for &damping_ratio in damping_ratios {
        check("damping_ratio", damping_ratio, (0.0..=1.0).contains(&damping_ratio), "0 to 1")?;
    }
    for (index, &period) in periods.iter().enumerate() {
        let valid = period == 0.0 || (1e-6..=1e6).contains(&period);
        check(&format!("periods[{index}]"), period, valid, "0 s, or 1e-6 s to 1e6 s")?;
    }
    Ok(())
}

/// Response spectrum for one damping ratio.
fn spectrum(
    record: &Record,
    periods: &[f64],
    damping_ratio: f64,
    stop: Option<&'static AtomicBool>,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<SpectralValues>, Refused> {
    let budget = Budget { stop, ..Budget::default() };
    let excitation = Excitation::new(record.time_step(), record.samples());
    let excitation = excitation.map_err(|error| Refused::at("record").is(error.to_string()))?;
    check_values(periods, &[damping_ratio])?;
    let values = |&period: &f64| {
        let found = if period == 0.0 {
            Ok(of_the_ground(record))
        } else {
            let end = record.duration() + period;
            values(excitation, end, period, damping_ratio, budget).map_err(|source| {
                let said = Error::ended(&source);
                let of = format!("period of {} s: ", plain(period));
                Refused::that(of).and(&said).kind(said.own_kind())
            })
        };
        done();
        found
    };
    parallel::try_each(periods, values)
}

/// Returns `count` periods between two periods > 0 \[s\], in equal ratios; only the first if `count` is 1.
pub fn periods_between(from: f64, to: f64, count: u32) -> Vec<f64> {
    let ratio = libm::log(to / from);
    let period = |index: u32| match index {
        0 => from,
        last if last == count - 1 => to,
        _ => from * libm::exp(ratio * f64::from(index) / f64::from(count - 1)),
    };
    (0..count).map(period).collect()
}

/// Multiplies the record by the factor > 0 for which its pseudo-acceleration at a period \[s\] is `target` \[m/s²\], > 0.
///
/// # Errors
/// Errors of [`response_spectrum`]; refuses a target that is not a finite number > 0, and a record that is zero throughout.
pub fn scaled_to_sa(record: &Record, period: f64, damping_ratio: f64, target: f64) -> Result<Record, Refused> {
    let valid = target.is_finite() && target > 0.0;
    check("target", target, valid, "a finite number > 0 m/s²")?;
    let spectrum = response_spectrum(record, &[period], damping_ratio)?;
    let found = spectrum[0].pseudo_acceleration;
    if found == 0.0 {
        return Err(pounding_motion::at_rest());
    }
    record.scaled(target / found)
}

pub(crate) fn check(place: &str, found: f64, valid: bool, allowed: &'static str) -> Result<(), Refused> {
    if valid {
        return Ok(());
    }
    Err(crate::settings::out_of_range(place, found, allowed))
}

/// Responses of a structure of period 0.
fn of_the_ground(record: &Record) -> SpectralValues {
    let peak = record.peak().1.abs();
    SpectralValues {
        period: 0.0,
        displacement: 0.0,
        pseudo_velocity: 0.0,
        pseudo_acceleration: peak,
        absolute_acceleration: peak,
    }
}

/// Largest responses of a structure.
pub(crate) struct Largest {
    /// Displacement \[m\].
    pub(crate) displacement: f64,
    /// Absolute acceleration \[m/s²\].
    pub(crate) acceleration: f64,
}

/// Runs an elastic structure of unit mass until `end` \[s\].
fn values(excitation: Excitation<'_>, end: f64, period: f64, damping_ratio: f64, budget: Budget) -> Result<SpectralValues, RunError> {
    let frequency = TAU / period;
    let stiffness = frequency * frequency;
    let damping = Damping::Ratio(damping_ratio).coefficient(1.0, stiffness);
    let node = Node::structure(1.0, damping, Elastic { stiffness });
    let row = Row::new(vec![node], vec![]).expect("mass, damping and stiffness are finite");
    let Largest {
        displacement,
        acceleration,
    } = shaken(&AnyRow::Elastic(row), excitation, end, budget)?;
    Ok(SpectralValues {
        period,
        displacement,
        pseudo_velocity: frequency * displacement,
        pseudo_acceleration: stiffness * displacement,
        absolute_acceleration: acceleration,
    })
}

/// Runs a row of one structure until `end` \[s\].
pub(crate) fn shaken(row: &AnyRow, excitation: Excitation<'_>, end: f64, budget: Budget) -> Result<Largest, RunError> {
    let clock = Clock {
        time_step: end,
        n_steps: 1,
    };
    let mut recorders = Recorders {
        accelerations: Some(FloorAccelerations::new(1, excitation)),
        ..Recorders::usual(1, row.pairs())
    };
    let exact = Integrator::Exact(Exact::default());
    row.run(&exact, excitation, clock.within(budget), &mut recorders)?;
    let accelerations = recorders.accelerations.iter();
    let absolute = accelerations.map(|all| all.of(0).value.abs());
    Ok(Largest {
        displacement: recorders.peaks.of(0).displacement.value.abs(),
        acceleration: absolute.fold(0.0, f64::max),
    })
}
