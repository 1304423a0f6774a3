//! What becomes of a number at the edge.

use pounding_scene::DOUBTFUL;
use strum::EnumCount;

/// Error up to which a number is exact to tolerance \[–\].
const EXACT: f64 = 1e-6;
/// Error up to which it is accurate \[–\]; a warning of such a number is a false alarm.
pub(super) const ACCURATE: f64 = 0.01;
/// Error above which a number without a warning is silently wrong \[–\].
pub(super) const WRONG: f64 = 0.1;

// Between a false alarm and a silent fault there is room for a threshold.
const _: () = assert!(
    ACCURATE < DOUBTFUL && DOUBTFUL < WRONG,
    "a threshold of warnings between what is good and what is wrong"
);

/// What becomes of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
pub(super) enum Class {
    /// Within 1e-6 of the exact run.
    ExactToTolerance,
    /// Within 1 %.
    Accurate,
    /// Further off, but by less than 10 % or with a warning.
    Degraded,
    /// The scene is refused before it runs.
    Refused,
    /// The run ends with an error, or its verdict is that a law of mechanics is broken.
    Caught,
    /// More than 10 % off without a word.
    SilentlyWrong,
    /// There is no exact run to compare with; the program says so, where it measures errors.
    NoReference,
    /// A number of the exact run that the second route cannot follow.
    NotVerified,
    /// Neither run has the number: nothing touches.
    Nothing,
}

impl Class {
    pub(super) const ALL: [Self; Self::COUNT] = [
        Self::ExactToTolerance,
        Self::Accurate,
        Self::Degraded,
        Self::Refused,
        Self::Caught,
        Self::SilentlyWrong,
        Self::NoReference,
        Self::NotVerified,
        Self::Nothing,
    ];

    /// The class of a number that a run printed, with or without a warning.
    pub(super) fn of(error: Option<f64>, warned: bool) -> Self {
        match error {
            None => Self::Nothing,
            Some(error) if error <= EXACT => Self::ExactToTolerance,
            Some(error) if error <= ACCURATE => Self::Accurate,
            Some(error) if error <= WRONG || warned => Self::Degraded,
            Some(_) => Self::SilentlyWrong,
        }
    }

    /// Name in tables.
    pub(super) fn key(self) -> &'static str {
        match self {
            Self::ExactToTolerance => "exact_to_tolerance",
            Self::Accurate => "accurate",
            Self::Degraded => "degraded",
            Self::Refused => "refused",
            Self::Caught => "diverged_and_caught",
            Self::SilentlyWrong => "silently_wrong",
            Self::NoReference => "no_reference",
            Self::NotVerified => "not_verified",
            Self::Nothing => "nothing_touches",
        }
    }

    /// Name in figures.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::ExactToTolerance => "exact to 1e-6",
            Self::Accurate => "within 1 %",
            Self::Degraded => "degraded",
            Self::Refused => "refused",
            Self::Caught => "diverged, caught",
            Self::SilentlyWrong => "silently wrong",
            Self::NoReference => "no exact run",
            Self::NotVerified => "not verified",
            Self::Nothing => "nothing touches",
        }
    }
}
