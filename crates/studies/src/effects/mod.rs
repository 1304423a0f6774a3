//! What pounding does to every storey of a row: its response beside neighbours against the same building alone.
//!
//! Everything comes from exact runs, of both directions of shaking, and of the same record changed by one per cent: a number
//! that a per cent of the record changes by much more cannot be trusted to be the building's own.

mod cases;
mod csv;
mod figure;

use rayon::prelude::*;

use crate::{Prepared, StudyError};
use cases::{Answer, Case, cases};
pub use figure::Drawn;

/// A change of the record [of one per cent](Effects) that moves a number by no more than this part of it leaves it robust \[–\].
pub const ROBUST: f64 = 0.05;

/// What pounding does to the storeys of a row, in both directions of shaking.
#[derive(Debug, Clone, PartialEq)]
pub struct Effects {
    /// Shaken as the scene says.
    pub as_given: Vec<FloorEffects>,
    /// Shaken the other way round.
    pub reversed: Vec<FloorEffects>,
}

/// What pounding does to one floor and the storey below it; a wall has hits alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloorEffects {
    /// Index of the floor in [`Floors`](crate::Floors).
    pub floor: usize,
    /// Collisions on either side of the floor; several where one meeting has several impacts.
    pub collisions: Known,
    /// Sum of their impulses \[N·s\].
    pub impulse: Known,
    /// The largest of them \[N·s\].
    pub largest_impulse: Known,
    /// Peak drift of the storey \[m\].
    pub drift: Option<Effect>,
    /// Peak shear force of the storey \[N\].
    pub shear: Option<Effect>,
    /// Peak absolute acceleration of the floor \[m/s²\]. That of an impulsive impact has no bound and is left out.
    pub acceleration: Option<Effect>,
}

/// A peak response beside neighbours, against that of the same building alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effect {
    /// Magnitude for the building alone.
    pub alone: f64,
    /// Magnitude beside its neighbours.
    pub beside: f64,
    /// Amplification, the ratio of both \[–\]; 1 where both are 0.
    pub amplification: Known,
}

/// A number with what is known of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Known {
    /// Its value.
    pub value: f64,
    /// Distance to another exact run, whose tolerance is ten thousand times as large and whose record is larger by one part
    /// in 10¹².
    pub error: f64,
    /// Its least and largest value under the record and all its changes by one per cent.
    pub range: [f64; 2],
}

impl Known {
    /// Of one number of the answers to all cases.
    fn of(answers: &[Answer], number: impl Fn(&Answer) -> f64) -> Self {
        let value = number(&answers[Case::AS_IT_IS]);
        let mut known = Self {
            value,
            error: (number(&answers[Case::CHECK]) - value).abs(),
            range: [value; 2],
        };
        for answer in &answers[Case::CHECK + 1..] {
            let changed = number(answer);
            known.range = [known.range[0].min(changed), known.range[1].max(changed)];
        }
        known
    }

    /// Largest change \[in the unit of the value\] by one per cent of the record.
    pub fn change(&self) -> f64 {
        (self.range[1] - self.value).max(self.value - self.range[0])
    }

    /// Whether a change of the record by one per cent moves it by less than [`ROBUST`], and it is known better than that.
    pub fn is_robust(&self) -> bool {
        self.change().max(self.error) <= ROBUST * self.value.abs()
    }
}

impl Effect {
    fn of(answers: &[Answer], number: impl Fn(&Answer) -> [f64; 2]) -> Self {
        let [alone, beside] = number(&answers[Case::AS_IT_IS]);
        let ratio = |answer: &Answer| {
            let [alone, beside] = number(answer);
            if alone > 0.0 {
                beside / alone
            } else if beside > 0.0 {
                f64::INFINITY
            } else {
                1.0
            }
        };
        Self {
            alone,
            beside,
            amplification: Known::of(answers, ratio),
        }
    }
}

impl Effects {
    /// Runs a scene with its contacts and with none, in both directions, as it is and under its record changed by one per
    /// cent: weaker, stronger, faster and slower; 24 exact runs.
    ///
    /// # Errors
    /// [`StudyError::Run`] when one of them ends early.
    pub fn of(prepared: &Prepared) -> Result<Self, StudyError> {
        let cases = cases();
        let answers: Result<Vec<_>, _> = cases
            .into_par_iter()
            .map(|case| case.answer(prepared))
            .collect();
        let answers = answers?;
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

    /// The floors that are hit in some direction.
    pub fn hit(&self) -> impl Iterator<Item = usize> {
        let both = self.as_given.iter().zip(&self.reversed);
        both.filter(|(one, other)| one.collisions.value + other.collisions.value > 0.0)
            .map(|(one, _)| one.floor)
    }
}

fn effects(prepared: &Prepared, floor: usize, answers: &[Answer]) -> FloorEffects {
    let moves = !prepared.floors().all()[floor].is_wall();
    let effect = |number: fn(&cases::Peaks) -> f64| {
        moves.then(|| Effect::of(answers, |answer| answer.floors[floor].peaks.each_ref().map(number)))
    };
    let hits = |number: fn(&cases::Hits) -> f64| {
        Known::of(answers, |answer| number(&answer.floors[floor].hits))
    };
    FloorEffects {
        floor,
        collisions: hits(|hits| hits.collisions),
        impulse: hits(|hits| hits.impulse),
        largest_impulse: hits(|hits| hits.largest_impulse),
        drift: effect(|peaks| peaks.drift),
        shear: effect(|peaks| peaks.shear),
        acceleration: effect(|peaks| peaks.acceleration),
    }
}
