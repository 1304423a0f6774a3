//! Inelastic response spectra of a record: the strength at which a structure has a given ductility, by the exact method.

use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

use pounding_motion::Record;
use pounding_solver::{AnyRow, Bilinear, Budget, Damping, Excitation, Node, Row};
use pounding_text::{RefusalKind, Refused, plain};

use crate::spectrum::{check, check_values, response_spectrum, shaken};
use crate::{Error, parallel};

/// The strengths of elastic-perfectly plastic structures of one damping ratio and ductility.
#[derive(Debug, Clone, PartialEq)]
pub struct DuctilitySpectrum {
    /// Damping ratio of the elastic structure \[–\].
    pub damping_ratio: f64,
    /// Largest displacement over the yield displacement \[–\].
    pub ductility: f64,
    /// The values, in the order of their periods.
    pub values: Vec<DuctilityValues>,
}

/// An elastic-perfectly plastic structure whose largest displacement is its yield displacement times the ductility.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DuctilityValues {
    /// Natural period T of the elastic structure \[s\].
    pub period: f64,
    /// Yield force over the mass, which is the pseudo-acceleration at yield \[m/s²\].
    pub yield_acceleration: f64,
    /// Largest displacement relative to the ground \[m\].
    pub displacement: f64,
    /// Strength that the structure needs to stay elastic, over its yield force \[–\].
    pub strength_reduction: f64,
}

/// Ratio of two strengths of the search. Ductility does not fall steadily with the strength: what rises and falls again between two of
/// these is not seen.
const STEP: f64 = 0.98;

/// Least yield force over that which stays elastic.
const WEAKEST: f64 = 1e-5;

/// Spectra of constant ductility of a record, for every damping ratio 0 ..= 1 and ductility 1 ..= 100, at `periods` \[s\], each 1e-6 ..= 1e6.
///
/// Of several strengths with the ductility the largest counts (A. K. Chopra, *Dynamics of Structures*, 7.5). A search by 2 % looks for it,
/// which misses a ductility that is reached between two steps alone. It is found to 1e-9 of itself.
/// `done` is called after each period; setting `stop` ends the work.
///
/// # Errors
/// Errors of [`response_spectrum`]; refuses a period of 0 and a ductility out of range, and a record that is zero throughout.
pub fn ductility_spectra(
    record: &Record,
    periods: &[f64],
    [damping_ratios, ductilities]: [&[f64]; 2],
    stop: Option<&'static AtomicBool>,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<DuctilitySpectrum>, Refused> {
    check_values(periods, damping_ratios)?;
    for (index, &period) in periods.iter().enumerate() {
        check(
            &format!("periods[{index}]"),
            period,
            period > 0.0,
            "above 0 s, where no structure yields",
        )?;
    }
    for &ductility in ductilities {
        check("ductility", ductility, (1.0..=100.0).contains(&ductility), "1 to 100")?;
    }
    let of_both = |(damping_ratio, ductility): (f64, f64)| {
        let yielding = |&period: &f64| {
            let found = Yielding::new(record, period, damping_ratio, stop)?.at(ductility);
            done();
            found
        };
        Ok(DuctilitySpectrum {
            damping_ratio,
            ductility,
            values: parallel::try_each(periods, yielding)?,
        })
    };
    let ratios = damping_ratios.iter();
    ratios
        .flat_map(|ratio| ductilities.iter().map(move |ductility| (*ratio, *ductility)))
        .map(of_both)
        .collect()
}

/// A structure of unit mass whose strength is sought.
struct Yielding<'r> {
    record: &'r Record,
    period: f64,
    damping_ratio: f64,
    /// Largest displacement of the elastic structure \[m\].
    elastic: f64,
    budget: Budget,
}

impl<'r> Yielding<'r> {
    fn new(record: &'r Record, period: f64, damping_ratio: f64, stop: Option<&'static AtomicBool>) -> Result<Self, Refused> {
        let elastic = response_spectrum(record, &[period], damping_ratio)?[0].displacement;
        if elastic == 0.0 {
            return Err(pounding_motion::at_rest());
        }
        Ok(Self {
            record,
            period,
            damping_ratio,
            elastic,
            budget: Budget { stop, ..Budget::default() },
        })
    }

    /// The strongest structure that reaches a ductility.
    fn at(&self, ductility: f64) -> Result<DuctilityValues, Refused> {
        let (mut strong, mut weak) = (1.0, 1.0);
        let reaches = |part: f64| Ok::<bool, Refused>(self.ductility(part, ductility)? >= ductility);
        while !reaches(weak)? {
            (strong, weak) = (weak, STEP * weak);
            if weak < WEAKEST {
                let period = plain(self.period);
                let found = Refused::that(format!(
                    "the period of {period} s has no ductility of {ductility} above {WEAKEST:e} of the elastic strength"
                ));
                return Err(found.help("ask for a smaller ductility, or leave the period out"));
            }
        }
        while strong - weak > 1e-9 * weak {
            let part = f64::midpoint(strong, weak);
            *(if reaches(part)? { &mut weak } else { &mut strong }) = part;
        }
        let frequency = TAU / self.period;
        Ok(DuctilityValues {
            period: self.period,
            yield_acceleration: frequency * frequency * weak * self.elastic,
            displacement: ductility * weak * self.elastic,
            strength_reduction: weak.recip(),
        })
    }

    /// The ductility of a structure with a part of the strength that stays elastic \[–\]; of one above `most`, a number above it.
    fn ductility(&self, part: f64, most: f64) -> Result<f64, Refused> {
        // Rounding must not decide whether the elastic structure yields.
        if part >= 1.0 {
            return Ok(1.0);
        }
        let frequency = TAU / self.period;
        let stiffness = frequency * frequency;
        let at_yield = part * self.elastic;
        let column = Bilinear {
            stiffness,
            yield_force: stiffness * at_yield,
            hardening: 0.0,
        };
        let damping = Damping::Ratio(self.damping_ratio).coefficient(1.0, stiffness);
        let row = Row::new(vec![Node::structure(1.0, damping, column)], vec![]).expect("mass, damping and stiffness are finite");
        let excitation = Excitation::new(self.record.time_step(), self.record.samples());
        let excitation = excitation.map_err(|error| Refused::at("record").is(error.to_string()))?;
        // After the record it vibrates on for half a period, and may yield before: across 2 µ uy, slowed down by fy/m, within √(4 µ)/ω.
        let end = self.record.duration() + self.period * (1.0 + most.sqrt() / PI);
        let largest = shaken(&AnyRow::Bilinear(row), excitation, end, self.budget).map_err(|source| {
            let said = Error::ended(&source);
            let of = format!("period of {} s, ductility: ", plain(self.period));
            let kind: RefusalKind = said.own_kind();
            Refused::that(of).and(&said).kind(kind)
        })?;
        Ok(largest.displacement / at_yield)
    }
}
