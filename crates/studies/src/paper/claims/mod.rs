//! The paper's findings, tested: the claim of each sentence, the computed numbers, and whether the claim holds.
//!
//! Words are read as numbers. "Almost the same" and "slight" mean within 20 %, which section 5 of the paper calls slight. The word
//! "comparable" means within a factor of two. The words "an order of magnitude" mean a factor of five or more.

mod collisions;
mod layouts;
mod run;
mod settings;
mod survival;

use crate::listed::listed;
use crate::{Completed, StudyError};
use pounding_text::Table;
use std::collections::BTreeMap;

pub(crate) use run::SceneRun;
pub use survival::Survival;
pub(crate) use survival::{asked, survivals, verdicts};

/// Largest relative difference that still counts as almost the same \[–\].
const SLIGHT: f64 = 0.20;

listed! {
    /// Whether a claim holds.
    pub enum Finding { words: &'static str;
        /// The claim holds in the paper's scenes, and in the further ones that `computed` names, if any.
        Holds = "holds",
        /// The claim holds in the scenes, quantities and time steps of the paper, but not beyond them.
        HoldsOnlyAsStated = "holds only as stated",
        /// The claim fails even in the paper's own scenes.
        DoesNotHold = "does not hold",
        /// The claim is about an event that these runs do not have, such as pounding where nothing touches.
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

    /// The finding from two answers; [`Self::DoesNotApply`] if nothing touches.
    fn where_touching(touch: bool, as_stated: bool, beyond: bool) -> Self {
        if touch { Self::of(as_stated, beyond) } else { Self::DoesNotApply }
    }

    /// Whether the claim holds, at least as stated.
    pub fn holds(self) -> bool {
        match self {
            Self::Holds | Self::HoldsOnlyAsStated => true,
            Self::DoesNotHold | Self::DoesNotApply => false,
        }
    }
}

/// One sentence of the paper's findings with its verdict.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claim {
    /// The paper's statement in our words.
    pub claim: &'static str,
    /// Section of the paper.
    pub place: &'static str,
    /// The computed numbers, in words.
    pub computed: String,
    /// The verdict.
    pub finding: Finding,
}

/// The computed numbers of a claim in words, and the verdict.
type Outcome = (String, Finding);

/// A claim of the paper in our words, its section, whether exact runs can be asked, and what tests it.
struct Test(&'static str, &'static str, Asked, fn(&Runs<'_>) -> Result<Outcome, StudyError>);

impl Test {
    fn run(&self, runs: &Runs<'_>) -> Result<Claim, StudyError> {
        let Self(claim, place, _, test) = *self;
        let (computed, finding) = test(runs)?;
        Ok(Claim {
            claim,
            place,
            computed,
            finding,
        })
    }
}

/// Whether a claim can be tested on exact runs.
#[derive(Debug, Clone, Copy)]
enum Asked {
    /// It can; the text is the claim in few words, for figures.
    Exactly(&'static str),
    /// It cannot; the text is the reason.
    Not(&'static str),
}
use Asked::{Exactly, Not};

/// The reason for claims about the paper's time step.
const TIME_STEP: Asked = Not("it is about the time step, and the exact method has none");

/// The claims with their sections, their short names for exact runs, and their tests.
#[rustfmt::skip]
const TESTS: [Test; 20] = [
    Test("The stability limit T > πΔt is no constraint at a time step of 0.01 s", "2",
        TIME_STEP, settings::stability),
    Test("A time step of 0.01 s is small enough for accurate results", "2",
        TIME_STEP, settings::time_step),
    Test("Both structures have a damping ratio of 5 % (Table 1)", "2, Table 1",
        Not("it is about what goes into the runs"), settings::damping_ratios),
    Test("The impact damping ratio 0.35 belongs to the restitution 0.65", "3.2",
        Not("it is about the contact law, and tested exactly"), settings::restitution),
    Test("Stereomechanical impact: elastic or nonlinear, the structures first meet at nearly one time and with nearly one force", "3.1",
        Exactly("Stereomechanical: first collision alike,\nelastic or nonlinear"), collisions::same_first_impact),
    Test("Viscoelastic element: elastic or nonlinear, the structures first meet at nearly one time and with nearly one transferred momentum", "3.2",
        Exactly("Viscoelastic: first collision alike,\nelastic or nonlinear"), collisions::same_first_momentum),
    Test("The transferred momentum of the first collision is comparable in all four models", "3.3",
        Exactly("First impulse comparable\nin all four models"), collisions::four_models),
    Test("The explicit method gives as many collisions, at the same times, as Newmark's method at 0.005 s (tested against our own run of it)", "3.3",
        Not("it compares two stepping methods"), collisions::as_newmark),
    Test("Elastic structures collide more often than nonlinear ones", "5",
        Exactly("More collisions\nwhen elastic"), collisions::fewer_when_nonlinear),
    Test("After the first pounding the displacement of the weak structure is larger when nonlinear, and is not recovered", "5",
        Exactly("Weak structure goes further when\nnonlinear, and does not come back"), collisions::displacement_not_recovered),
    Test("The viscoelastic element lowers the peak pounding force by an order of magnitude", "5",
        Not("the stereomechanical force is an impulse over the time step and has no limit"), collisions::order_of_magnitude),
    Test("The viscoelastic element lowers the transferred momentum by about 20 %", "5",
        Exactly("Viscoelastic element lowers\nthe momentum by about 20 %"), collisions::slight_reduction),
    Test("Layout C elastic needs a time step of 0.005 s: at 0.01 s the structures tangle", "4.1",
        TIME_STEP, layouts::tangling_in_layout_c),
    Test("Layout C elastic: half the time step gives larger peak pounding forces", "4.1",
        TIME_STEP, layouts::half_step_raises_the_force),
    Test("Layout C elastic: half the time step leaves the transferred momentum the same", "4.1",
        TIME_STEP, layouts::half_step_keeps_the_momentum),
    Test("Nonlinear structures transfer less momentum than elastic ones", "4.1",
        Exactly("Less momentum\nwhen nonlinear"), layouts::less_momentum_when_nonlinear),
    Test("Elastic structures: the stereomechanical approach transfers more momentum than the viscoelastic element", "4.2, 4.3",
        Exactly("Elastic: more momentum with\nstereomechanical impact"), layouts::more_momentum_stereomechanical),
    Test("Nonlinear structures: both contact models transfer the same momentum (read as within 20 %)", "4.2, 4.3",
        Exactly("Nonlinear: same momentum\nwith either contact model"), layouts::same_momentum_nonlinear),
    Test("Between two stiff structures (layout C) the nonlinear incursions of the weak one decrease (read as plastic travel; beyond that, their number)", "4.3, Fig. 15",
        Exactly("Layout C: weak structure\nyields less"), layouts::fewer_incursions),
    Test("The stiff structure between two weak ones (layout B) is the least favourable layout by maximum displacement", "5",
        Exactly("Layout B has the largest\ndisplacement"), layouts::least_favourable),
];

/// Tests every claim on the completed studies.
///
/// # Errors
/// [`StudyError::MissingScene`] if a study or scene that a claim needs is missing.
pub fn claims(completed: &[Completed]) -> Result<Vec<Claim>, StudyError> {
    let runs = Runs::new(completed);
    TESTS.iter().map(|test| test.run(&runs)).collect()
}

/// Counts of the cases in which each claim holds, for one column of a table: other ground motions, or changed scenes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimCounts {
    /// Name of the column.
    pub column: String,
    /// The count of each claim in their order. The list is short, or an entry `None`, if a claim was not tested.
    pub claims: Vec<Option<ClaimCount>>,
}

impl Default for ClaimCounts {
    /// The empty column of a run without other ground motions.
    fn default() -> Self {
        Self {
            column: "holds_beyond".into(),
            claims: Vec::new(),
        }
    }
}

/// The claims as CSV text, with verdicts from the paper's program and from the method as the paper describes it, without slips.
pub fn claims_csv(claims: &[Claim], without_slips: &[Claim], survivals: &[Survival], beyond: &[ClaimCounts]) -> String {
    let rows = claims.iter().zip(without_slips).zip(survivals).enumerate();
    let tally = |tallies: &ClaimCounts, index: usize| tallies.claims.get(index).copied().flatten();
    Table::of(rows)
        .column("claim", |(_, ((claim, _), _))| claim.claim)
        .column("where", |(_, ((claim, _), _))| claim.place)
        .column("computed", |(_, ((claim, _), _))| claim.computed.clone())
        .column("verdict", |(_, ((claim, _), _))| claim.finding.words())
        .column("computed_without_slips", |(_, ((_, described), _))| described.computed.clone())
        .column("verdict_without_slips", |(_, ((_, described), _))| described.finding.words())
        .column("computed_exactly", |(_, (_, survival))| survival.cells()[0].clone())
        .column("verdict_exactly", |(_, (_, survival))| survival.cells()[1].clone())
        .column("survives_perturbation", |(_, (_, survival))| survival.cells()[2].clone())
        .columns(
            beyond,
            |tallies| tallies.column.clone(),
            |(index, (_, survival)), tallies| survival.beyond(tally(tallies, *index)),
        )
        .csv()
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

    fn scene(&self, study: &str, scene: &str) -> Result<SceneRun<'a>, StudyError> {
        let missing = || StudyError::MissingScene {
            study: study.into(),
            scene: scene.into(),
        };
        let study = self.study(study)?;
        let scenes = study.file.study.scenes.iter();
        let index = scenes.map(|one| &*one.name).position(|name| name == scene);
        index.map(|index| SceneRun::of(study, index)).ok_or_else(missing)
    }

    /// Two structures, elastic and nonlinear, of Table 2 (stereomechanical) or Table 4 (viscoelastic).
    fn two_structures(&self, law: Law) -> Result<[SceneRun<'a>; 2], StudyError> {
        let [_, study, _] = law.texts();
        Ok([self.scene(study, "elastic")?, self.scene(study, "nonlinear")?])
    }

    /// The runs of a layout of Table 6 (stereomechanical) or Table 7 (viscoelastic). If the method has a time step, a run at half of it
    /// follows.
    fn layout(&self, layout: &str, behaviour: &str, law: Law) -> Result<Vec<SceneRun<'a>>, StudyError> {
        let name = format!("layout {layout} {behaviour}");
        let run = self.scene(law.texts()[2], &name)?;
        if run.scene.method.time_step().is_none() {
            return Ok(vec![run]);
        }
        let half = format!("{name}, {}, half the time step", law.name());
        Ok(vec![run, self.scene("claims", &half)?])
    }
}

listed! {
    /// The two contact models of the paper: their names, and the studies of two structures and of layouts.
    enum Law { texts: [&'static str; 3];
        Stereomechanical = ["stereomechanical", "table-2", "table-6"],
        Viscoelastic = ["viscoelastic", "table-4", "table-7"],
    }
}

impl Law {
    fn name(self) -> &'static str {
        self.texts()[0]
    }
}

/// The text for a claim that does not apply because nothing touches.
const NOTHING: &str = "nothing touches";

/// Start \[s\] and impulse \[kN·s\] of the first collision; `None` if nothing touches.
fn first_collision(run: SceneRun<'_>) -> Option<(f64, f64)> {
    let first = run.outcome.collisions.all().first()?;
    Some((first.start, first.impulse / 1e3))
}

/// Largest pounding force of a run \[kN\]. The force of an impact is its impulse over the time step.
fn peak_force(run: SceneRun<'_>) -> f64 {
    let force = |collision: &pounding_solver::Collision| collision.peak_force.unwrap_or(collision.impulse / run.scene.method.step()) / 1e3;
    run.outcome.collisions.all().iter().map(force).fold(0.0, f64::max)
}

/// Transferred momentum of a structure \[kN·s\].
fn momentum(run: SceneRun<'_>, structure: usize) -> f64 {
    run.momentum(structure) / 1e3
}

/// Change from `from` to `to` in per cent of `from`.
fn change(from: f64, to: f64) -> f64 {
    100.0 * (to / from - 1.0)
}

fn is_slight(from: f64, to: f64) -> bool {
    (to / from - 1.0).abs() <= SLIGHT
}

/// Number of cases in which a claim holds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ClaimCount {
    /// Number of cases.
    pub cases: usize,
    /// Number of cases in which the claim holds, at least as stated.
    pub holds: usize,
    /// Number of cases in which the claim holds only as stated.
    pub only_as_stated: usize,
    /// Number of cases in which the claim does not apply.
    pub does_not_apply: usize,
}

impl ClaimCount {
    /// Counts findings.
    pub(crate) fn of(findings: impl Iterator<Item = Finding>) -> Self {
        findings.fold(Self::default(), |tally, finding| Self {
            cases: tally.cases + 1,
            holds: tally.holds + usize::from(finding.holds()),
            only_as_stated: tally.only_as_stated + usize::from(finding == Finding::HoldsOnlyAsStated),
            does_not_apply: tally.does_not_apply + usize::from(finding == Finding::DoesNotApply),
        })
    }

    /// Number of cases in which the claim applies but fails.
    pub fn does_not_hold(&self) -> usize {
        self.cases - self.holds - self.does_not_apply
    }

    /// The counts in words.
    pub fn words(&self) -> String {
        let holds = format!("in {} of {} cases", self.holds, self.cases);
        match self.does_not_apply {
            0 => holds,
            1 => format!("{holds}; 1 does not apply"),
            many => format!("{holds}; {many} do not apply"),
        }
    }
}
