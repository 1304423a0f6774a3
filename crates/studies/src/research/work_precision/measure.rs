//! Runs of all methods.

use super::condition::Knowledge;
use super::quantities::{Ended, MethodQuantity, MethodRun, Quantities};
use crate::drivers::each;
use crate::{Completed, StudyError};
use pounding_reference::Fineness;
use pounding_scene::{ComparedMethod, Ladder, Scene, Structure, parallel};
use pounding_solver::{Ledger, Work};

/// All runs of one scene.
#[derive(Debug)]
pub(crate) struct Race {
    /// Name of the scene.
    pub(crate) scene: String,
    /// Names of the neighbours of every pair.
    pub(super) pairs: Vec<String>,
    /// Whether its contacts have forces over time.
    pub(crate) compliant: bool,
    /// Results of the exact method at its smallest tolerance.
    pub(crate) truth: Quantities,
    /// Reliability of the truth.
    pub(super) knowledge: Knowledge,
    /// The methods in the order of the list.
    pub(crate) entrants: Vec<Entrant>,
}

/// All runs of one method on one scene.
#[derive(Debug)]
pub(crate) struct Entrant {
    pub(crate) contender: &'static ComparedMethod,
    /// Runs from the largest setting down.
    pub(crate) rungs: Vec<Rung>,
}

/// One run.
#[derive(Debug)]
pub(crate) struct Rung {
    /// Time step \[s\] or tolerance \[–\].
    pub(crate) setting: f64,
    /// The results, or the reason why the run failed.
    pub(crate) outcome: Result<Measured, String>,
}

/// Results of a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Measured {
    pub(crate) work: Work,
    pub(crate) n_collisions: usize,
    /// Whether the run has as many collisions as the truth.
    pub(crate) same_count: bool,
    /// Relative error of each quantity; `None` if there is nothing to compare.
    errors: [Option<f64>; MethodQuantity::ALL.len()],
    pub(crate) energy: Energy,
}

/// Energy balances from the ledger of a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Energy {
    /// The method's own balance \[–\].
    pub(crate) identity: f64,
    /// The physical balance \[–\].
    pub(crate) residual: f64,
    /// Distance from the ledger of the truth \[–\].
    pub(crate) error: f64,
    /// The law of mechanics that the run broke, if any.
    pub(crate) broken: Option<String>,
}

impl Measured {
    /// Relative error of a quantity \[–\]; `None` if neither the run nor the truth has a collision.
    pub(crate) fn error(&self, quantity: MethodQuantity) -> Option<f64> {
        self.errors[quantity as usize]
    }

    /// The largest relative error of some quantities \[–\].
    pub(crate) fn worst(&self, quantities: &[MethodQuantity]) -> f64 {
        let errors = quantities.iter().filter_map(|quantity| self.error(*quantity));
        errors.fold(0.0, f64::max)
    }

    /// The work by which methods are compared.
    pub(crate) fn cost(&self) -> u64 {
        ComparedMethod::cost(self.work)
    }
}

impl Race {
    /// Number of digits in which the two routes agree, 0 to 16.
    pub(crate) fn digits(&self, quantity: MethodQuantity) -> Option<u32> {
        self.knowledge.of(quantity).map(|known| digits(known.distance))
    }

    /// The smallest number of digits in which the two routes agree, over all quantities.
    pub(crate) fn fewest_digits(&self) -> Option<u32> {
        MethodQuantity::ALL.into_iter().filter_map(|quantity| self.digits(quantity)).min()
    }

    /// Text for the column of agreed digits: whether the two routes have the same number of collisions.
    pub(crate) fn agreed_count(&self) -> &'static str {
        if self.knowledge.same_count { "all" } else { "0" }
    }

    /// The runs of a method; `None` if another method is identical.
    pub(crate) fn of(&self, key: &str) -> Option<&Entrant> {
        self.entrants.iter().find(|entrant| entrant.contender.key == key)
    }
}

/// Number of digits that agree at a relative distance.
fn digits(distance: f64) -> u32 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped, and a part of a digit does not count"
    )]
    let digits = (-libm::log10(distance)).clamp(0.0, 16.0) as u32;
    digits
}

/// Runs every method on every scene.
pub(super) fn races(completed: &Completed, ladder: &Ladder, done: &(dyn Fn() + Sync)) -> Result<Vec<Race>, StudyError> {
    let scenes = &completed.file.study.scenes;
    let of_scene = |(scene, prepared)| {
        ladder.entries(scene).map(move |(contender, setting)| MethodRun {
            scene,
            prepared,
            contender,
            setting,
        })
    };
    let runs: Vec<_> = scenes.iter().zip(&completed.prepared).flat_map(of_scene).collect();
    let finest = ladder.tolerances[ladder.tolerances.len() - 1];
    let is_reference = |run: &&MethodRun<'_>| run.contender.key == ComparedMethod::REFERENCE && run.setting <= finest;
    let references: Vec<_> = runs.iter().filter(is_reference).collect();
    let known = parallel::each(&references, |reference| {
        let second = crate::second_route(reference.prepared, Fineness::FINE);
        Knowledge::measure(reference, second.ok().as_ref())
    });
    let mut outcomes = each(&runs, done, MethodRun::outcome).into_iter();
    let race = |(scene, knowledge): (&Scene, Result<Knowledge, String>)| {
        let rungs = ladder.entries(scene).zip(outcomes.by_ref()).collect();
        let race = knowledge.and_then(|knowledge| Race::new(scene, rungs, knowledge));
        race.map_err(|found| {
            let found = format!("\"{}\": {found}", scene.name);
            completed.refuse("scenes", found, "scenes that the exact method can run")
        })
    };
    scenes.iter().zip(known).map(race).collect()
}

impl Race {
    /// Measures the runs of a scene. Fails with a reason if the reference failed.
    fn new(scene: &Scene, rungs: Vec<((&'static ComparedMethod, f64), Ended<'_>)>, knowledge: Knowledge) -> Result<Self, String> {
        let reference = rungs.iter().rfind(|((contender, _), _)| contender.key == ComparedMethod::REFERENCE);
        let (_, reference) = reference.expect("the reference is among the contenders");
        let (truth, ledger, _) = reference.as_ref().map_err(Clone::clone)?;
        ledger.verdict().map_err(|broken| broken.to_string())?;
        let truth = (truth.clone(), ledger.clone());
        let distances = MethodQuantity::ALL.map(|quantity| Some(knowledge.of(quantity)?.distance));
        let mut entrants: Vec<Entrant> = Vec::new();
        for ((contender, setting), outcome) in rungs {
            let outcome = outcome.map(|found| Measured::new(&found, &truth, &distances));
            let rung = Rung { setting, outcome };
            match entrants.last_mut() {
                Some(last) if last.contender.key == contender.key => last.rungs.push(rung),
                _ => entrants.push(Entrant {
                    contender,
                    rungs: vec![rung],
                }),
            }
        }
        let pair = |pair: &[Structure]| format!("{} – {}", pair[0].name(), pair[1].name());
        Ok(Self {
            scene: scene.name.clone(),
            pairs: scene.structures.windows(2).map(pair).collect(),
            compliant: scene.is_compliant(),
            truth: truth.0,
            knowledge,
            entrants,
        })
    }
}

impl Measured {
    fn new(
        (found, ledger, work): &(Quantities, Ledger<'_>, Work),
        (truth, true_ledger): &(Quantities, Ledger<'_>),
        distances: &[Option<f64>; MethodQuantity::ALL.len()],
    ) -> Self {
        let error = |quantity: MethodQuantity| {
            let error = found.distance(truth, quantity)?;
            // The distance of the two routes limits what is known of the error.
            Some(error.max(distances[quantity as usize].unwrap_or(0.0)))
        };
        Self {
            work: *work,
            n_collisions: found.n_collisions,
            same_count: found.n_collisions == truth.n_collisions,
            errors: MethodQuantity::ALL.map(error),
            energy: Energy {
                identity: ledger.identity(),
                residual: ledger.residual(),
                error: ledger.error(true_ledger),
                broken: ledger.verdict().err().map(|broken| broken.to_string()),
            },
        }
    }
}
