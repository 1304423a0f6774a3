//! The paper's findings, tested: what each sentence claims, what was computed, and whether it holds.
//!
//! "Almost the same" and "slight" are read as within 20 %, which section 5 of the paper calls slight; "comparable" as
//! within a factor of two; "an order of magnitude" as a factor of five or more.

mod collisions;
mod layouts;
mod settings;

use std::collections::BTreeMap;

use crate::tables::to_csv;
use crate::{Completed, Outcome, Scene, StudyError};

/// Relative difference that still counts as almost the same.
const SLIGHT: f64 = 0.20;

/// Whether a claim holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Finding {
    /// In the paper's scenes, and in the further ones that `computed` names, if any.
    Holds,
    /// In the scenes, quantities and time steps of the paper, but not beyond them.
    HoldsOnlyAsStated,
    /// Not even in the paper's own scenes.
    DoesNotHold,
}

impl Finding {
    fn of(as_stated: bool, beyond: bool) -> Self {
        match (as_stated, beyond) {
            (true, true) => Self::Holds,
            (true, false) => Self::HoldsOnlyAsStated,
            (false, _) => Self::DoesNotHold,
        }
    }

    /// The finding in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::HoldsOnlyAsStated => "holds only as stated",
            Self::DoesNotHold => "does not hold",
        }
    }
}

/// One sentence of findings and what became of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claim {
    /// What the paper says, in our words.
    pub claim: &'static str,
    /// Section of the paper.
    pub place: &'static str,
    /// What was computed.
    pub computed: String,
    /// Whether it holds.
    pub finding: Finding,
}

/// Tests every claim on the completed studies.
///
/// # Errors
/// [`StudyError::MissingScene`] when a study or scene that a claim needs is not there.
pub fn claims(completed: &[Completed]) -> Result<Vec<Claim>, StudyError> {
    let runs = Runs(
        completed
            .iter()
            .map(|study| (&*study.file.id, study))
            .collect(),
    );
    [
        settings::stability,
        settings::time_step,
        settings::damping_ratios,
        settings::restitution,
        collisions::same_first_impact,
        collisions::same_first_momentum,
        collisions::four_models,
        collisions::as_newmark,
        collisions::fewer_when_nonlinear,
        collisions::displacement_not_recovered,
        collisions::order_of_magnitude,
        collisions::slight_reduction,
        layouts::tangling_in_layout_c,
        layouts::half_step_raises_the_force,
        layouts::half_step_keeps_the_momentum,
        layouts::less_momentum_when_nonlinear,
        layouts::more_momentum_stereomechanical,
        layouts::same_momentum_nonlinear,
        layouts::fewer_incursions,
        layouts::least_favourable,
    ]
    .into_iter()
    .map(|claim: fn(&Runs<'_>) -> Result<Claim, StudyError>| claim(&runs))
    .collect()
}

/// The claims as CSV text.
pub fn claims_csv(claims: &[Claim]) -> String {
    let header = ["claim", "where", "computed", "verdict"].map(String::from);
    let row = |claim: &Claim| {
        vec![
            claim.claim.into(),
            claim.place.into(),
            claim.computed.clone(),
            claim.finding.words().into(),
        ]
    };
    to_csv(&header, &claims.iter().map(row).collect::<Vec<_>>())
}

/// A scene and what it left behind.
type Run<'a> = (&'a Scene, &'a Outcome);

/// The completed studies by name.
struct Runs<'a>(BTreeMap<&'a str, &'a Completed>);

impl<'a> Runs<'a> {
    fn study(&self, study: &str) -> Result<&'a Completed, StudyError> {
        let missing = || StudyError::MissingScene {
            study: study.into(),
            scene: "any".into(),
        };
        self.0.get(study).copied().ok_or_else(missing)
    }

    fn scene(&self, study: &str, scene: &str) -> Result<Run<'a>, StudyError> {
        let missing = || StudyError::MissingScene {
            study: study.into(),
            scene: scene.into(),
        };
        self.study(study)?.of(scene).ok_or_else(missing)
    }

    /// The same scene elastic and nonlinear, of Table 5: two structures.
    fn two_structures(&self, law: &str) -> Result<[Run<'a>; 2], StudyError> {
        let scene = |behaviour| self.scene("table-5", &format!("{law} {behaviour}"));
        Ok([scene("elastic")?, scene("nonlinear")?])
    }

    /// A layout of Table 6 (stereomechanical) or 7 (viscoelastic), and the same with half the time step.
    fn layout(&self, layout: &str, behaviour: &str, law: Law) -> Result<[Run<'a>; 2], StudyError> {
        let name = format!("layout {layout} {behaviour}");
        let half = format!("{name}, {}, half the time step", law.name());
        Ok([
            self.scene(law.table(), &name)?,
            self.scene("claims", &half)?,
        ])
    }
}

/// The two contact models of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Law {
    Stereomechanical,
    Viscoelastic,
}

impl Law {
    const BOTH: [Self; 2] = [Self::Stereomechanical, Self::Viscoelastic];

    fn name(self) -> &'static str {
        match self {
            Self::Stereomechanical => "stereomechanical",
            Self::Viscoelastic => "viscoelastic",
        }
    }

    fn table(self) -> &'static str {
        match self {
            Self::Stereomechanical => "table-6",
            Self::Viscoelastic => "table-7",
        }
    }
}

/// Start \[s\] and impulse \[kN·s\] of the first collision.
fn first_collision((scene, outcome): Run<'_>) -> Result<(f64, f64), StudyError> {
    outcome
        .collisions
        .all()
        .first()
        .map(|first| (first.start, first.impulse / 1e3))
        .ok_or_else(|| StudyError::MissingScene {
            study: "claims".into(),
            scene: format!("{} with a collision", scene.name),
        })
}

/// Largest pounding force of a run \[kN\]; of an impact the impulse over the time step.
fn peak_force((scene, outcome): Run<'_>) -> f64 {
    let force = |collision: &pounding_solver::Collision| {
        collision
            .peak_force
            .unwrap_or(collision.impulse / scene.method.step())
            / 1e3
    };
    outcome
        .collisions
        .all()
        .iter()
        .map(force)
        .fold(0.0, f64::max)
}

/// Transferred momentum of a structure \[kN·s\].
fn momentum((_, outcome): Run<'_>, structure: usize) -> f64 {
    outcome.momentum.of(structure) / 1e3
}

/// Change from `from` to `to` in per cent of `from`.
fn change(from: f64, to: f64) -> f64 {
    100.0 * (to / from - 1.0)
}

fn is_slight(from: f64, to: f64) -> bool {
    (to / from - 1.0).abs() <= SLIGHT
}
