//! Classes of a number in an extreme scene.

use crate::listed::listed;
use pounding_plot::{Fill, Shade};
use pounding_scene::Review;

/// Error up to which a number is exact to tolerance \[–\].
const EXACT: f64 = 1e-6;
/// Error up to which a number is accurate \[–\]; a warning about such a number is a false alarm.
pub(super) const ACCURATE: f64 = 0.01;
/// Error above which a number without a warning is silently wrong \[–\].
pub(super) const WRONG: f64 = 0.1;

// A threshold for warnings must fit between a false alarm and a silent fault.
const _: () = assert!(
    ACCURATE < Review::DOUBTFUL && Review::DOUBTFUL < WRONG,
    "a threshold of warnings between what is good and what is wrong"
);

/// The appearance of a class.
pub(super) struct Look {
    /// Name in tables.
    pub(super) key: &'static str,
    /// Name in figures.
    pub(super) words: &'static str,
    pub(super) fill: Fill,
    /// Letter that identifies the class in grey.
    pub(super) letter: &'static str,
    /// Rank from good to bad.
    pub(super) rank: usize,
}

const fn look(rank: usize, key: &'static str, words: &'static str, fill: Fill, letter: &'static str) -> Look {
    Look {
        key,
        words,
        fill,
        letter,
        rank,
    }
}

const fn fill(shade: Shade, opacity: f64) -> Fill {
    Fill { shade, opacity }
}

listed! {
    /// The class of a number.
    pub(super) enum Class { look: Look;
        /// Within 1e-6 of the exact run.
        ExactToTolerance = look(1, "exact_to_tolerance", "exact to 1e-6", fill(Shade::Blue, 0.75), ""),
        /// Within 1 %.
        Accurate = look(2, "accurate", "within 1 %", fill(Shade::Blue, 0.3), ""),
        /// Between 1 % and 10 % off, or further off with a warning.
        Degraded = look(3, "degraded", "1 to 10 %, or warned", fill(Shade::Amber, 0.6), "d"),
        /// The scene is refused before it runs.
        Refused = look(4, "refused", "refused", fill(Shade::Mist, 1.0), "r"),
        /// The run ends with an error, or its verdict is that a law of mechanics is broken.
        Caught = look(5, "diverged_and_caught", "diverged, caught", fill(Shade::Vermilion, 0.7), "c"),
        /// More than 10 % off without a warning.
        SilentlyWrong = look(8, "silently_wrong", "over 10 %, silent", fill(Shade::Ink, 1.0), ""),
        /// There is no exact run for a comparison. The program prints that, if it measures errors.
        NoReference = look(6, "no_reference", "no exact run", fill(Shade::White, 1.0), "–"),
        /// A number of the exact run that the second route cannot confirm.
        NotVerified = look(7, "not_verified", "not verified", fill(Shade::White, 1.0), "?"),
        /// Neither run has the number because nothing touches.
        Nothing = look(0, "nothing_touches", "nothing touches", fill(Shade::White, 1.0), ""),
    }
}

impl Class {
    /// The class of a number that a run printed, from its error and whether there was a warning.
    pub(super) fn of(error: Option<f64>, warned: bool) -> Self {
        match error {
            None => Self::Nothing,
            Some(error) if error <= EXACT => Self::ExactToTolerance,
            Some(error) if error <= ACCURATE => Self::Accurate,
            Some(error) if error <= WRONG || warned => Self::Degraded,
            Some(_) => Self::SilentlyWrong,
        }
    }
}
