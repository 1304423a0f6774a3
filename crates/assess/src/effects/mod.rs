//! Effects of pounding on every storey of a row: its response beside the neighbours against the same building alone.
//!
//! All numbers come from exact runs in both directions of shaking, with the record and with the record changed by one per cent. If such a
//! change moves a number much more, the number says little about the building.

mod cases;
mod csv;

pub use csv::FloorFact;

use pounding_scene::{Error, Simulation, parallel};
use serde::{Deserialize, Serialize};

use crate::peaks::FloorPeaks;
use cases::{CaseAnswer, EffectCase, cases};

/// Effects of pounding on the storeys of a row, in both directions of shaking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Effects {
    /// Effects on every floor under the record as given, whatever direction the scene asks for.
    pub as_given: Vec<FloorEffects>,
    /// Effects on every floor under the reversed record.
    pub reversed: Vec<FloorEffects>,
}

/// Effects of pounding on one floor and the storey below it; a wall has only collisions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FloorEffects {
    /// Name of the structure; for a floor of a building also the number of the storey.
    pub name: String,
    /// Number of collisions on both sides of the floor. A meeting with several impacts counts several times.
    pub collisions: Known,
    /// Sum of the impulses of these collisions \[N·s\], from the left and from the right without sign.
    pub impulse_n_s: Known,
    /// Largest impulse of these collisions \[N·s\].
    pub largest_impulse_n_s: Known,
    /// Peak drift of the storey \[m\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_drift_m: Option<Effect>,
    /// Peak shear force of the storey \[N\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_shear_force_n: Option<Effect>,
    /// Peak absolute acceleration of the floor \[m/s²\]. Impulsive impacts, whose acceleration has no bound, are left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_acceleration_m_per_s2: Option<Effect>,
}

/// Peak response beside the neighbours, against that of the same building alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Effect {
    /// Magnitude for the building alone.
    pub alone: f64,
    /// Magnitude beside its neighbours.
    pub beside: f64,
    /// Amplification, `beside` over `alone` \[–\]; `None` if the building alone does not move.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amplification: Option<Known>,
}

/// A number with its error and its range under slight changes of the record.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Known {
    /// Value.
    pub value: f64,
    /// Distance to a second exact run, which has 10⁴ times the tolerance and a record scaled by 1 + 10⁻¹².
    pub error: f64,
    /// Least value under the record and its changes by one per cent.
    pub low: f64,
    /// Largest value under the record and its changes by one per cent.
    pub high: f64,
}

impl Known {
    /// A number is robust if a [change of the record by one per cent](Effects) moves it by at most this part \[–\].
    pub const ROBUST: f64 = 0.05;

    /// Finds a number with its error and range in the answers to all cases.
    fn of(answers: &[CaseAnswer], number: impl Fn(&CaseAnswer) -> f64) -> Self {
        let value = number(&answers[EffectCase::AS_IT_IS]);
        let mut known = Self {
            value,
            error: (number(&answers[EffectCase::CHECK]) - value).abs(),
            low: value,
            high: value,
        };
        for answer in &answers[EffectCase::CHECK + 1..] {
            let changed = number(answer);
            (known.low, known.high) = (known.low.min(changed), known.high.max(changed));
        }
        known
    }

    /// Largest change of the value by one per cent of the record \[in the unit of the value\].
    pub fn change(&self) -> f64 {
        (self.high - self.value).max(self.value - self.low)
    }

    /// Whether neither one per cent of the record nor the error moves the value by more than [`Self::ROBUST`].
    pub fn is_robust(&self) -> bool {
        self.change().max(self.error) <= Self::ROBUST * self.value.abs()
    }
}

impl Effect {
    fn of(answers: &[CaseAnswer], number: impl Fn(&CaseAnswer) -> [f64; 2]) -> Self {
        let [alone, beside] = number(&answers[EffectCase::AS_IT_IS]);
        let moves = answers.iter().all(|answer| number(answer)[0] > 0.0);
        let ratio = |answer: &CaseAnswer| {
            let [alone, beside] = number(answer);
            beside / alone
        };
        Self {
            alone,
            beside,
            amplification: moves.then(|| Known::of(answers, ratio)),
        }
    }
}

impl Effects {
    /// Sentence for a row in which [nothing touches](Effects::touch).
    pub const NOTHING_TOUCHES: &str = "nothing touches, in neither direction of shaking and under no change of the record by one per cent, so \
                                       that every storey moves as it does alone";

    /// Runs a scene with its contacts and without, in both directions. The record is used unchanged, slightly changed as a check, and
    /// weaker, stronger, faster and slower by one per cent. These are 24 exact runs of the scene's duration; runs with the slower record
    /// last longer.
    ///
    /// # Errors
    /// [`Error::Run`] if a run ends early, [`Error::Broken`] if a run breaks a law of mechanics.
    pub fn of(prepared: &Simulation) -> Result<Self, Error> {
        let cases = cases();
        let answers = parallel::try_each(&cases, |case| case.answer(prepared))?;
        let (own, other) = answers.split_at(answers.len() / 2);
        let is_reversed = prepared.scene().record.reversed;
        let (as_given, reversed) = if is_reversed { (other, own) } else { (own, other) };
        let of = |answers: &[CaseAnswer]| {
            let floors = 0..prepared.floors().all().len();
            floors.map(|floor| effects(prepared, floor, answers)).collect()
        };
        Ok(Self {
            as_given: of(as_given),
            reversed: of(reversed),
        })
    }

    /// Whether there are effects on a floor; a wall has effects only if something hits it.
    pub fn concern(&self, floor: usize) -> bool {
        let both = [&self.as_given[floor], &self.reversed[floor]];
        both.iter().any(|one| one.peak_drift_m.is_some() || one.collisions.high > 0.0)
    }

    /// Whether anything touches in any of the runs.
    pub fn touch(&self) -> bool {
        let mut floors = self.as_given.iter().chain(&self.reversed);
        floors.any(|one| one.collisions.high > 0.0)
    }

    /// Largest error of the amplifications \[–\].
    pub fn largest_error(&self) -> f64 {
        let floors = self.as_given.iter().chain(&self.reversed);
        let effects = floors.flat_map(FloorEffects::responses);
        let errors = effects.filter_map(|effect| Some(effect?.amplification?.error));
        errors.fold(0.0, f64::max)
    }
}

impl FloorEffects {
    /// Effects on drift, shear force and acceleration; `None` for a wall.
    pub fn responses(&self) -> [Option<Effect>; 3] {
        [self.peak_drift_m, self.peak_shear_force_n, self.peak_acceleration_m_per_s2]
    }
}

fn effects(prepared: &Simulation, floor: usize, answers: &[CaseAnswer]) -> FloorEffects {
    let place = &prepared.floors().all()[floor];
    let moves = !place.is_wall();
    let effect =
        |number: fn(&FloorPeaks) -> f64| moves.then(|| Effect::of(answers, |answer| answer.floors[floor].peaks.each_ref().map(number)));
    let hits = |number: fn(&cases::FloorHits) -> f64| Known::of(answers, |answer| number(&answer.floors[floor].hits));
    FloorEffects {
        name: place.name.clone(),
        collisions: hits(|hits| hits.collisions),
        impulse_n_s: hits(|hits| hits.impulse),
        largest_impulse_n_s: hits(|hits| hits.largest_impulse),
        peak_drift_m: effect(|peaks| peaks.drift),
        peak_shear_force_n: effect(|peaks| peaks.shear),
        peak_acceleration_m_per_s2: effect(|peaks| peaks.acceleration),
    }
}
