//! Properties of a file that look wrong but may be right.

use std::fmt;
use std::ops::RangeInclusive;

use pounding_text::{short, two_digits};

use crate::AccelerationUnit;

/// Usual time steps of strong motion \[s\].
const USUAL_STEPS: RangeInclusive<f64> = 1e-4..=0.1;

/// Peaks of records that are chosen for buildings \[g\]. A weaker peak in a declared unit is compared with other units.
const CHOSEN_PEAKS: RangeInclusive<f64> = 0.1..=1.5;

/// Part of the peak that resampling may remove silently.
const USUAL_LOSS: f64 = 1e-3;

/// Relative difference of a peak from that of the header that is accepted silently.
const USUAL_DIFFERENCE: f64 = 0.05;

/// An `Unusual` is a property of a file that looks wrong but may be right.
#[derive(Clone, Debug, PartialEq)]
pub enum Unusual {
    /// A time step below 10⁻⁴ s or above 0.1 s.
    TimeStep {
        /// The time step \[s\].
        found: f64,
    },
    /// A peak below 0.02 g or above 3 g.
    Peak {
        /// Largest magnitude, in multiples of 9.80665 m/s² \[g\].
        found: f64,
    },
    /// A weak peak in a declared unit, which would be usual in another unit.
    DeclaredUnit {
        /// Largest magnitude as declared \[g\].
        found: f64,
        /// The declared unit.
        declared: AccelerationUnit,
        /// The other unit.
        other: AccelerationUnit,
        /// Largest magnitude in the other unit \[g\].
        instead: f64,
    },
    /// Values that are all zero.
    Zero {
        /// Number of values.
        found: usize,
    },
    /// Values that never change sign, or only rise.
    OneSigned {
        /// Number of values.
        found: usize,
        /// Whether no value is below the previous one.
        rises: bool,
    },
    /// A first value that is the peak, several times the second largest.
    FirstSample {
        /// The first value, in the unit of the file.
        found: f64,
        /// The largest of the others.
        second: f64,
    },
    /// One of the first two values of a bare list that is the declared time step.
    StepAsSample {
        /// Number of the value, from 1.
        sample: usize,
        /// The value, in the unit of the file.
        found: f64,
    },
    /// A peak that resampling has lowered by more than 0.1 %.
    Resampled {
        /// Reduction of the peak, as a part of it.
        lost: f64,
    },
    /// A peak that differs by more than 5 % from the peak in the header.
    HeaderPeak {
        /// The difference, as a part of the peak in the header.
        found: f64,
    },
    /// Values that are declared to be accelerations although the file suggests velocities.
    Velocity {
        /// Text of the file.
        found: String,
    },
    /// A sensor in a borehole or on a structure.
    OffTheGround {
        /// Text of the file about the place.
        found: String,
    },
}

impl Unusual {
    /// Usual peaks \[g\]: weaker motions do no harm, and the largest on record are near 4 g. A wrong unit leads out of this range.
    pub const USUAL_PEAKS: RangeInclusive<f64> = 0.02..=3.0;

    /// Unusual time step \[s\] and peak \[g\] of a record. A zero peak is reported elsewhere.
    pub(crate) fn of_record(time_step: f64, peak: f64) -> impl Iterator<Item = Self> {
        let step = (!USUAL_STEPS.contains(&time_step)).then_some(Self::TimeStep { found: time_step });
        let is_usual = Self::USUAL_PEAKS.contains(&peak) || peak <= 0.0;
        let peak = (!is_usual).then_some(Self::Peak { found: peak });
        step.into_iter().chain(peak)
    }

    /// Warning about a declared unit if the peak \[g\] is weak, but usual for strong motion in another unit.
    pub(crate) fn of_unit(declared: AccelerationUnit, peak: f64) -> Option<Self> {
        let is_weak = (*Self::USUAL_PEAKS.start()..*CHOSEN_PEAKS.start()).contains(&peak);
        // Only plain units are tried: thousandths and tenths of g are not chosen by mistake.
        let others = AccelerationUnit::ALL[..3].iter();
        let in_units = others.map(|other| (*other, peak * other.worth_in(declared)));
        let mut chosen = in_units.filter(|(_, peak)| CHOSEN_PEAKS.contains(peak));
        let (other, instead) = chosen.next().filter(|_| is_weak)?;
        Some(Self::DeclaredUnit {
            found: peak,
            declared,
            other,
            instead,
        })
    }

    /// Warning if resampling removed much of the peak.
    pub(crate) fn of_resampling(lost: f64) -> Option<Self> {
        (lost > USUAL_LOSS).then_some(Self::Resampled { lost })
    }

    /// Warning if the difference from the peak of the header is large.
    pub(crate) fn of_difference(found: f64) -> Option<Self> {
        (found > USUAL_DIFFERENCE).then_some(Self::HeaderPeak { found })
    }

    /// Returns the ratio to the usual value: below 1 if a value is too small, and 1 for a property without a size.
    pub fn ratio(&self) -> f64 {
        match self {
            // The ratio is relative to the middle of the usual range.
            Self::TimeStep { found } => found / 3e-3,
            Self::Peak { found } | Self::DeclaredUnit { found, .. } => found / 0.25,
            Self::FirstSample { found, second } => (found / second).abs(),
            Self::Resampled { lost } => lost / USUAL_LOSS,
            Self::HeaderPeak { found } => found / USUAL_DIFFERENCE,
            Self::Zero { .. } | Self::OneSigned { .. } | Self::StepAsSample { .. } | Self::Velocity { .. } | Self::OffTheGround { .. } => {
                1.0
            }
        }
    }

    /// Returns the value found, in words.
    pub fn found(&self) -> String {
        match self {
            Self::TimeStep { found } => format!("a time step of {found} s in the file"),
            // Two digits would round the value into the usual range.
            Self::Peak { found } if (0.0195..0.02).contains(found) => {
                format!("a peak of {found:.4} g in the file")
            }
            Self::Peak { found } if *found < 1.0 => {
                format!("a peak of {} g in the file", two_digits(*found))
            }
            Self::Peak { found } => format!("a peak of {found:.1} g in the file"),
            Self::DeclaredUnit {
                found,
                declared,
                other,
                instead,
            } => format!(
                "a peak of {} g in the file, with the unit {} as declared; in {} the values would peak at {} g",
                two_digits(*found),
                declared.symbol(),
                other.symbol(),
                two_digits(*instead)
            ),
            Self::Zero { found } => format!("{found} values in the file that are all zero"),
            Self::OneSigned { found, rises: false } => {
                format!("{found} values in the file that never change sign")
            }
            Self::OneSigned { found, rises: true } => {
                format!("{found} values in the file that only rise")
            }
            Self::FirstSample { found, second } => format!(
                "a first value of {} in the file, where no other is above {}",
                short(*found),
                short(*second)
            ),
            Self::StepAsSample { sample, found } => {
                format!("value {sample} of the file, {found}, equal to its time step")
            }
            Self::Resampled { lost } => format!("a peak that is {:.1} % lower after resampling", 100.0 * lost),
            Self::HeaderPeak { found } => format!("a peak that is {:.0} % off that in the header of the file", 100.0 * found),
            Self::Velocity { found } => {
                format!("{found:?} in the file, which speaks for velocities, declared to be accelerations")
            }
            Self::OffTheGround { found } => {
                format!("a sensor that is not at the ground, by its file: {found}")
            }
        }
    }

    /// Returns the usual values, in words.
    pub fn usual(&self) -> &'static str {
        match self {
            Self::TimeStep { .. } => "0.0001 to 0.1 s",
            Self::Peak { .. } => "0.02 to 3 g; its unit decides it",
            Self::DeclaredUnit { .. } => "0.1 to 1.5 g, where the unit is declared",
            Self::Zero { .. } => "shaking",
            Self::OneSigned { .. } => "shaking both ways; a spectrum, a column of times or an offset has one sign",
            Self::FirstSample { .. } => "a motion that begins near zero; the first may be a number of the header",
            Self::StepAsSample { .. } => "a step that stands above the values, not among them",
            Self::Resampled { .. } => "up to 0.1 %; a shorter step keeps more",
            Self::HeaderPeak { .. } => "up to 5 %; the file may be cut, damaged or corrected",
            Self::Velocity { .. } => "the record of an accelerometer, such as channel HNE",
            Self::OffTheGround { .. } => "the motion of the ground, on which the row stands",
        }
    }
}

impl fmt::Display for Unusual {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "found {}, usual is {}", self.found(), self.usual())
    }
}
