//! The programs compared, with their methods and settings.

use super::figure::Competitor;

use super::own::{EXACT, EXACT_LANES, LANES};
use super::scenes::SceneKind;

/// A method of a program over a ladder of settings.
#[derive(Debug, Clone, Copy)]
pub(super) struct Entrant {
    pub(super) competitor: Competitor,
    /// Tool: this project, or a tool of `worker.py`.
    pub(super) tool: &'static str,
    pub(super) method: &'static str,
    /// Name in figures.
    pub(super) label: &'static str,
    pub(super) knob: Knob,
}

/// All entrants that run scenes of a kind.
pub(super) fn entrants(kind: SceneKind) -> impl Iterator<Item = Entrant> {
    let all = ENTRANTS.iter().filter(move |(.., runs)| runs.contains(&kind));
    all.map(|&(competitor, [tool, method, label], knob, _)| Entrant {
        competitor,
        tool,
        method,
        label,
        knob,
    })
}

/// The setting that a ladder changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Knob {
    /// The time step \[s\].
    TimeStep,
    /// The tolerance \[–\].
    Tolerance,
    /// The tolerance \[–\] of this project's exact method, at most 1e-3.
    OwnTolerance,
    /// No setting: the exact method has none for impulsive contact.
    Nothing,
}

/// Time steps \[s\]: they divide the step of the record, so that its corners are nodes.
const TIME_STEPS: [f64; 12] = [2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 2e-6];
const TOLERANCES: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
const OWN_TOLERANCES: [f64; 9] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12];
/// Tolerance of the exact method where it changes nothing.
const NOTHING: [f64; 1] = [1e-16];

impl Knob {
    pub(super) fn ladder(self) -> &'static [f64] {
        match self {
            Self::TimeStep => &TIME_STEPS,
            Self::Tolerance => &TOLERANCES,
            Self::OwnTolerance => &OWN_TOLERANCES,
            Self::Nothing => &NOTHING,
        }
    }

    /// A setting in tables.
    pub(super) fn words(self, setting: f64) -> String {
        match self {
            Self::TimeStep => format!("{setting:e} s"),
            Self::Tolerance | Self::OwnTolerance => format!("tolerance {setting:e}"),
            Self::Nothing => String::from("none"),
        }
    }
}

/// Name of this project in tables.
pub(super) const OURS: &str = "pounding";

const STRUCTURES: &[SceneKind] = &[SceneKind::Impulsive, SceneKind::Compliant];
const IMPULSIVE: &[SceneKind] = &[SceneKind::Impulsive];
const COMPLIANT: &[SceneKind] = &[SceneKind::Compliant];
const PRESSED: &[SceneKind] = &[SceneKind::Compliant, SceneKind::Towers];
const ALL: &[SceneKind] = &[SceneKind::Impulsive, SceneKind::Compliant, SceneKind::Towers];

/// Entrants with tool, method and label, their ladder, and their scenes, in the order of tables and legends.
#[rustfmt::skip]
const ENTRANTS: [(Competitor, [&str; 3], Knob, &[SceneKind]); 15] = {
    use Competitor::{Loop, OpenSees, Ours, Scipy, Sundials};
    use Knob::{Nothing, OwnTolerance, TimeStep, Tolerance};
    [
        (Ours, [OURS, LANES, "Ours: central difference, SIMD"], TimeStep, ALL),
        (Ours, [OURS, EXACT_LANES, "Ours: exact, SIMD"], Nothing, IMPULSIVE),
        (Ours, [OURS, EXACT_LANES, "Ours: exact, SIMD"], OwnTolerance, COMPLIANT),
        (Ours, [OURS, EXACT, "Ours: exact"], Nothing, IMPULSIVE),
        (Ours, [OURS, EXACT, "Ours: exact"], OwnTolerance, PRESSED),
        (Loop, ["numba", "central_difference", "Numba: central difference"], TimeStep, STRUCTURES),
        (Loop, ["numba", "velocity_verlet", "Numba: Verlet"], TimeStep, STRUCTURES),
        (Loop, ["numba", "rk4", "Numba: Runge–Kutta"], TimeStep, STRUCTURES),
        (Loop, ["c", "central_difference", "C: central difference"], TimeStep, STRUCTURES),
        (Scipy, ["scipy", "DOP853", "SciPy: DOP853"], Tolerance, STRUCTURES),
        (Scipy, ["scipy", "LSODA", "SciPy: LSODA"], Tolerance, STRUCTURES),
        (Scipy, ["scipy", "Radau", "SciPy: Radau"], Tolerance, STRUCTURES),
        (Sundials, ["sundials", "adams", "SUNDIALS: CVODE, Adams"], Tolerance, STRUCTURES),
        (Sundials, ["sundials", "bdf", "SUNDIALS: CVODE, BDF"], Tolerance, STRUCTURES),
        (OpenSees, ["opensees", "newmark", "OpenSees: Newmark"], TimeStep, PRESSED),
    ]
};
