//! What pounding does to every storey of a row: its response beside neighbours against the same building alone.
//!
//! Everything comes from exact runs, of both directions of shaking, and of the same record changed by one per cent: a number
//! that a per cent of the record changes by much more cannot be trusted to be the building's own.

mod cases;
mod csv;

use serde::{Deserialize, Serialize};

use crate::{Error, Simulation, parallel};
use cases::{Answer, Case, cases};

/// A change of the record [of one per cent](Effects) that moves a number by no more than this part of it leaves it robust \[–\].
pub const ROBUST: f64 = 0.05;

/// What is said of effects where [nothing touches](Effects::touch).
pub const NOTHING_TOUCHES: &str = "nothing touches, in neither direction of shaking and under no change of the record by one per cent, so that \
                                   every storey moves as it does alone";

/// What pounding does to the storeys of a row, in both directions of shaking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Effects {
    /// Shaken as the scene says.
    pub as_given: Vec<FloorEffects>,
    /// Shaken the other way round.
    pub reversed: Vec<FloorEffects>,
}

/// What pounding does to one floor and the storey below it; a wall has hits alone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FloorEffects {
    /// Its name; of a floor of a building that of the building and the number of the storey.
    pub name: String,
    /// Collisions on either side of the floor, both sides counted together; several where one meeting has several impacts.
    pub collisions: Known,
    /// Sum of their impulses \[N·s\], those from the left and from the right without sign.
    pub impulse_n_s: Known,
    /// The largest of them \[N·s\].
    pub largest_impulse_n_s: Known,
    /// Peak drift of the storey \[m\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drift_m: Option<Effect>,
    /// Peak shear force of the storey \[N\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_n: Option<Effect>,
    /// Peak absolute acceleration of the floor \[m/s²\]. That of an impulsive impact has no bound and is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acceleration_m_per_s2: Option<Effect>,
}

/// A peak response beside neighbours, against that of the same building alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Effect {
    /// Magnitude for the building alone.
    pub alone: f64,
    /// Magnitude beside its neighbours.
    pub beside: f64,
    /// Amplification, the ratio of both \[–\]; nothing for a building that does not move at all when it is alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amplification: Option<Known>,
}

/// A number with what is known of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Known {
    /// Its value.
    pub value: f64,
    /// Distance to another exact run, whose tolerance is ten thousand times as large and whose record is larger by one part
    /// in 10¹².
    pub error: f64,
    /// Its least value under the record and all its changes by one per cent.
    pub low: f64,
    /// Its largest value under them.
    pub high: f64,
}

impl Known {
    /// Of one number of the answers to all cases.
    fn of(answers: &[Answer], number: impl Fn(&Answer) -> f64) -> Self {
        let value = number(&answers[Case::AS_IT_IS]);
        let mut known = Self {
            value,
            error: (number(&answers[Case::CHECK]) - value).abs(),
            low: value,
            high: value,
        };
        for answer in &answers[Case::CHECK + 1..] {
            let changed = number(answer);
            (known.low, known.high) = (known.low.min(changed), known.high.max(changed));
        }
        known
    }

    /// Largest change \[in the unit of the value\] by one per cent of the record.
    pub fn change(&self) -> f64 {
        (self.high - self.value).max(self.value - self.low)
    }

    /// Whether a change of the record by one per cent moves it by no more than [`ROBUST`], and it is known as well.
    pub fn is_robust(&self) -> bool {
        self.change().max(self.error) <= ROBUST * self.value.abs()
    }
}

impl Effect {
    fn of(answers: &[Answer], number: impl Fn(&Answer) -> [f64; 2]) -> Self {
        let [alone, beside] = number(&answers[Case::AS_IT_IS]);
        let moves = answers.iter().all(|answer| number(answer)[0] > 0.0);
        let ratio = |answer: &Answer| {
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
    /// Runs a scene with its contacts and with none, in both directions, as it is and under its record changed by one per
    /// cent: weaker, stronger, faster and slower; 24 exact runs, all of the duration of the scene but those of the slower record, which last
    /// as much longer.
    ///
    /// # Errors
    /// [`Error::Run`] when one of them ends early, [`Error::Broken`] when it breaks a law of mechanics.
    pub fn of(prepared: &Simulation) -> Result<Self, Error> {
        let cases = cases();
        let answers = parallel::try_each(&cases, |case| case.answer(prepared))?;
        let (as_given, reversed) = answers.split_at(answers.len() / 2);
        let of = |answers: &[Answer]| {
            let floors = 0..prepared.floors().all().len();
            floors.map(|floor| effects(prepared, floor, answers)).collect()
        };
        Ok(Self {
            as_given: of(as_given),
            reversed: of(reversed),
        })
    }

    /// Both directions, with their names.
    pub fn directions(&self) -> [(&'static str, &[FloorEffects]); 2] {
        [("as in the scene", &self.as_given), ("reversed", &self.reversed)]
    }

    /// Whether they say anything of a floor: of a wall but where something hits it.
    pub fn concern(&self, floor: usize) -> bool {
        let both = [&self.as_given[floor], &self.reversed[floor]];
        both.iter().any(|one| one.drift_m.is_some() || one.collisions.high > 0.0)
    }

    /// Whether anything touches, in any of the runs.
    pub fn touch(&self) -> bool {
        let mut floors = self.as_given.iter().chain(&self.reversed);
        floors.any(|one| one.collisions.high > 0.0)
    }

    /// Largest error of all amplifications \[–\].
    pub fn largest_error(&self) -> f64 {
        let floors = self.as_given.iter().chain(&self.reversed);
        let effects = floors.flat_map(FloorEffects::responses);
        let errors = effects.filter_map(|effect| Some(effect?.amplification?.error));
        errors.fold(0.0, f64::max)
    }
}

impl FloorEffects {
    /// Drift, shear force and acceleration; nothing of a wall.
    pub fn responses(&self) -> [Option<Effect>; 3] {
        [self.drift_m, self.shear_n, self.acceleration_m_per_s2]
    }
}

fn effects(prepared: &Simulation, floor: usize, answers: &[Answer]) -> FloorEffects {
    let place = &prepared.floors().all()[floor];
    let moves = !place.is_wall();
    let effect = |number: fn(&super::FloorPeaks) -> f64| {
        moves.then(|| Effect::of(answers, |answer| answer.floors[floor].peaks.each_ref().map(number)))
    };
    let hits = |number: fn(&cases::Hits) -> f64| Known::of(answers, |answer| number(&answer.floors[floor].hits));
    FloorEffects {
        name: place.name.clone(),
        collisions: hits(|hits| hits.collisions),
        impulse_n_s: hits(|hits| hits.impulse),
        largest_impulse_n_s: hits(|hits| hits.largest_impulse),
        drift_m: effect(|peaks| peaks.drift),
        shear_n: effect(|peaks| peaks.shear),
        acceleration_m_per_s2: effect(|peaks| peaks.acceleration),
    }
}
