//! The paper's findings, tested: what each sentence claims, what was computed, and whether it holds.
//!
//! "Almost the same" and "slight" are read as within 20 %, which section 5 of the paper calls slight; "comparable" as
//! within a factor of two; "an order of magnitude" as a factor of five or more.

mod collisions;
mod layouts;
mod run;
mod settings;
mod survival;
mod tally;

use crate::listed::listed;
use crate::paper::tables::to_csv;
use crate::{Completed, StudyError};
use std::collections::BTreeMap;

pub(crate) use run::Run;
pub use survival::Survival;
pub(crate) use survival::{asked, survivals, verdicts};
pub use tally::ClaimCount;

/// Relative difference that still counts as almost the same.
const SLIGHT: f64 = 0.20;

listed! {
    /// Whether a claim holds.
    pub enum Finding { words: &'static str;
        /// In the paper's scenes, and in the further ones that `computed` names, if any.
        Holds = "holds",
        /// In the scenes, quantities and time steps of the paper, but not beyond them.
        HoldsOnlyAsStated = "holds only as stated",
        /// Not even in the paper's own scenes.
        DoesNotHold = "does not hold",
        /// Neither: it is about what does not happen in these runs, such as pounding where nothing touches.
        DoesNotApply = "does not apply",
    }
}

impl Finding {
    fn of(as_stated: bool, beyond: bool) -> Self {
        match (as_stated, beyond) {
            (true, true) => Self::Holds,
            (true, false) => Self::HoldsOnlyAsStated,
            (false, _) => Self::DoesNotHold,
        }
    }

    /// Whether the claim holds, be it only as stated.
    pub fn holds(self) -> bool {
        match self {
            Self::Holds | Self::HoldsOnlyAsStated => true,
            Self::DoesNotHold | Self::DoesNotApply => false,
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

/// Tests one claim.
type Test = fn(&Runs<'_>) -> Result<Claim, StudyError>;

/// Whether exact runs have something to say to a claim.
#[derive(Debug, Clone, Copy)]
enum Asked {
    /// Yes; the claim in few words, for figures.
    Exactly(&'static str),
    /// No, for this reason.
    Not(&'static str),
}
use Asked::{Exactly, Not};

/// What the paper's own time step does cannot be asked of a method without one.
const TIME_STEP: Asked = Not("it is about the time step, and the exact method has none");

/// The claims.
const TESTS: [(Test, Asked); 20] = [
    (settings::stability, TIME_STEP),
    (settings::time_step, TIME_STEP),
    (settings::damping_ratios, Not("it is about what goes into the runs")),
    (settings::restitution, Not("it is about the contact law, and tested exactly")),
    (
        collisions::same_first_impact,
        Exactly("Stereomechanical: first collision alike,\nelastic or nonlinear"),
    ),
    (
        collisions::same_first_momentum,
        Exactly("Viscoelastic: first collision alike,\nelastic or nonlinear"),
    ),
    (collisions::four_models, Exactly("First impulse comparable\nin all four models")),
    (collisions::as_newmark, Not("it compares two stepping methods")),
    (collisions::fewer_when_nonlinear, Exactly("More collisions\nwhen elastic")),
    (
        collisions::displacement_not_recovered,
        Exactly("Weak structure goes further when\nnonlinear, and does not come back"),
    ),
    (
        collisions::order_of_magnitude,
        Not("the stereomechanical force is an impulse over the time step and has no limit"),
    ),
    (
        collisions::slight_reduction,
        Exactly("Viscoelastic element lowers\nthe momentum by about 20 %"),
    ),
    (layouts::tangling_in_layout_c, TIME_STEP),
    (layouts::half_step_raises_the_force, TIME_STEP),
    (layouts::half_step_keeps_the_momentum, TIME_STEP),
    (layouts::less_momentum_when_nonlinear, Exactly("Less momentum\nwhen nonlinear")),
    (
        layouts::more_momentum_stereomechanical,
        Exactly("Elastic: more momentum with\nstereomechanical impact"),
    ),
    (
        layouts::same_momentum_nonlinear,
        Exactly("Nonlinear: same momentum\nwith either contact model"),
    ),
    (layouts::fewer_incursions, Exactly("Layout C: weak structure\nyields less")),
    (layouts::least_favourable, Exactly("Layout B has the largest\ndisplacement")),
];

/// Tests every claim on the completed studies.
///
/// # Errors
/// [`StudyError::MissingScene`] when a study or scene that a claim needs is not there.
pub fn claims(completed: &[Completed]) -> Result<Vec<Claim>, StudyError> {
    let runs = Runs::new(completed);
    TESTS.iter().map(|(test, _)| test(&runs)).collect()
}

/// In how many cases of other ground motions, and changed scenes, claims hold: a column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimCounts {
    /// Name of the column.
    pub column: String,
    /// Of each claim, in their order; nothing, or too few, where it was not asked.
    pub claims: Vec<Option<ClaimCount>>,
}

impl Default for ClaimCounts {
    /// Of no other ground motions.
    fn default() -> Self {
        Self {
            column: "holds_beyond".into(),
            claims: Vec::new(),
        }
    }
}

/// The claims as CSV text: by the paper's program, and by the method that it describes, without slips.
pub fn claims_csv(claims: &[Claim], without_slips: &[Claim], survivals: &[Survival], beyond: &[ClaimCounts]) -> String {
    let mut header = [
        "claim",
        "where",
        "computed",
        "verdict",
        "computed_without_slips",
        "verdict_without_slips",
        "computed_exactly",
        "verdict_exactly",
        "survives_perturbation",
    ]
    .map(String::from)
    .to_vec();
    header.extend(beyond.iter().map(|tallies| tallies.column.clone()));
    let row = |(index, ((claim, described), survival)): (usize, ((&Claim, &Claim), &Survival))| {
        let [exactly, found, perturbation] = survival.cells();
        let mut row = vec![
            claim.claim.into(),
            claim.place.into(),
            claim.computed.clone(),
            claim.finding.words().into(),
            described.computed.clone(),
            described.finding.words().into(),
            exactly,
            found,
            perturbation,
        ];
        let tally = |tallies: &ClaimCounts| tallies.claims.get(index).copied().flatten();
        row.extend(beyond.iter().map(|tallies| survival.beyond(tally(tallies))));
        row
    };
    let claims = claims.iter().zip(without_slips);
    let rows = claims.zip(survivals).enumerate().map(row);
    to_csv(&header, &rows.collect::<Vec<_>>())
}

/// The completed studies by name.
struct Runs<'a>(BTreeMap<&'a str, &'a Completed>);

impl<'a> Runs<'a> {
    fn new(completed: &'a [Completed]) -> Self {
        let named = completed.iter().map(|study| (&*study.file.id, study));
        Self(named.collect())
    }

    fn study(&self, study: &str) -> Result<&'a Completed, StudyError> {
        self.0.get(study).copied().ok_or_else(|| StudyError::no_scene_of(study))
    }

    fn scene(&self, study: &str, scene: &str) -> Result<Run<'a>, StudyError> {
        let missing = || StudyError::MissingScene {
            study: study.into(),
            scene: scene.into(),
        };
        let study = self.study(study)?;
        let scenes = study.file.study.scenes.iter();
        let index = scenes.map(|one| &*one.name).position(|name| name == scene);
        index.map(|index| Run::of(study, index)).ok_or_else(missing)
    }

    /// Two structures elastic and nonlinear, of Table 2 (stereomechanical) or 4 (viscoelastic).
    fn two_structures(&self, law: Law) -> Result<[Run<'a>; 2], StudyError> {
        let study = match law {
            Law::Stereomechanical => "table-2",
            Law::Viscoelastic => "table-4",
        };
        Ok([self.scene(study, "elastic")?, self.scene(study, "nonlinear")?])
    }

    /// A layout of Table 6 (stereomechanical) or 7 (viscoelastic); of a method with a time step the same with half of it too.
    fn layout(&self, layout: &str, behaviour: &str, law: Law) -> Result<Vec<Run<'a>>, StudyError> {
        let name = format!("layout {layout} {behaviour}");
        let run = self.scene(law.table(), &name)?;
        if run.scene.method.time_step().is_none() {
            return Ok(vec![run]);
        }
        let half = format!("{name}, {}, half the time step", law.name());
        Ok(vec![run, self.scene("claims", &half)?])
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

/// What is computed where a claim does not apply.
const NOTHING: &str = "nothing touches";

/// Start \[s\] and impulse \[kN·s\] of the first collision; nothing where nothing touches.
fn first_collision(run: Run<'_>) -> Option<(f64, f64)> {
    let first = run.outcome.collisions.all().first()?;
    Some((first.start, first.impulse / 1e3))
}

/// Largest pounding force of a run \[kN\]; of an impact the impulse over the time step.
fn peak_force(run: Run<'_>) -> f64 {
    let force = |collision: &pounding_solver::Collision| collision.peak_force.unwrap_or(collision.impulse / run.scene.method.step()) / 1e3;
    run.outcome.collisions.all().iter().map(force).fold(0.0, f64::max)
}

/// Transferred momentum of a structure \[kN·s\].
fn momentum(run: Run<'_>, structure: usize) -> f64 {
    run.momentum(structure) / 1e3
}

/// Change from `from` to `to` in per cent of `from`.
fn change(from: f64, to: f64) -> f64 {
    100.0 * (to / from - 1.0)
}

fn is_slight(from: f64, to: f64) -> bool {
    (to / from - 1.0).abs() <= SLIGHT
}
