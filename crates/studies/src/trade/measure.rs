//! The runs.

use pounding_solver::{Clock, Collisions, Peaks, TransferredMomentum, Work};
use rayon::prelude::*;

use super::Ladder;
use super::contenders::{CONTENDERS, Contender, Knob, REFERENCE, is_compliant};
use super::quantities::{Quantities, Quantity};
use crate::{Completed, Prepared, Scene, StudyError};

/// All runs of one scene.
#[derive(Debug)]
pub(crate) struct Race {
    /// Name of the scene.
    pub(crate) scene: String,
    /// Whether its contacts have forces over time.
    pub(crate) compliant: bool,
    pub(crate) truth: Quantities,
    /// The methods in the order of the list.
    pub(crate) entrants: Vec<Entrant>,
}

/// All runs of one method on one scene.
#[derive(Debug)]
pub(crate) struct Entrant {
    pub(crate) contender: &'static Contender,
    /// From the largest setting down.
    pub(crate) rungs: Vec<Rung>,
}

/// One run.
#[derive(Debug)]
pub(crate) struct Rung {
    /// Time step \[s\] or tolerance \[–\].
    pub(crate) setting: f64,
    /// What came out, or why nothing did.
    pub(crate) outcome: Result<Measured, String>,
}

/// What came out of a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Measured {
    pub(crate) work: Work,
    pub(crate) n_collisions: usize,
    /// Whether it has as many collisions as the truth.
    pub(crate) same_count: bool,
    /// Relative error of each quantity; nothing where there is nothing to compare.
    errors: [Option<f64>; Quantity::ALL.len()],
}

impl Measured {
    /// Relative error of a quantity \[–\]; nothing where neither the run nor the truth has a collision.
    pub(crate) fn error(&self, quantity: Quantity) -> Option<f64> {
        self.errors[quantity as usize]
    }

    /// The work that methods are compared by.
    pub(crate) fn cost(&self) -> u64 {
        self.work.force_evaluations + self.work.segments
    }
}

impl Race {
    /// The runs of a method; nothing where it does not differ from another one.
    pub(crate) fn of(&self, key: &str) -> Option<&Entrant> {
        self.entrants
            .iter()
            .find(|entrant| entrant.contender.key == key)
    }
}

/// The methods on a scene, each with its settings.
pub(super) fn entries<'a>(
    scene: &'a Scene,
    ladder: &'a Ladder,
) -> impl Iterator<Item = (&'static Contender, f64)> + 'a {
    let entering = CONTENDERS
        .iter()
        .filter(|contender| contender.enters(scene));
    entering.flat_map(|contender| {
        let settings = match contender.knob {
            Knob::TimeStep => &ladder.time_steps_s[..],
            Knob::Tolerance if is_compliant(scene) => &ladder.tolerances[..],
            Knob::Tolerance => &ladder.tolerances[ladder.tolerances.len() - 1..],
        };
        settings.iter().map(move |setting| (contender, *setting))
    })
}

/// Runs every method on every scene.
pub(super) fn races(
    completed: &Completed,
    ladder: &Ladder,
    done: &(impl Fn() + Sync),
) -> Result<Vec<Race>, StudyError> {
    let scenes = &completed.file.study.scenes;
    let runs = scenes
        .iter()
        .zip(&completed.prepared)
        .flat_map(|(scene, prepared)| {
            entries(scene, ladder)
                .map(move |(contender, setting)| (scene, prepared, contender, setting))
        });
    let runs: Vec<_> = runs.collect();
    let outcomes: Vec<_> = runs
        .par_iter()
        .map(|(scene, prepared, contender, setting)| {
            let outcome = run(scene, prepared, contender, *setting);
            done();
            outcome
        })
        .collect();
    let mut outcomes = outcomes.into_iter();
    scenes
        .iter()
        .map(|scene| {
            let rungs = entries(scene, ladder).zip(outcomes.by_ref());
            Race::new(scene, rungs).map_err(|found| {
                completed.refuse("scenes", found, "scenes that the exact method can run")
            })
        })
        .collect()
}

type Outcome = Result<(Quantities, Work), String>;

/// One run of one method.
fn run(scene: &Scene, prepared: &Prepared, contender: &Contender, setting: f64) -> Outcome {
    let n = scene.structures.len();
    let clock = match contender.knob {
        Knob::TimeStep => {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "checked: 0 < n < 1e9"
            )]
            let n_steps = (scene.duration_s / setting).round() as usize;
            Clock {
                time_step: setting,
                n_steps,
            }
        }
        Knob::Tolerance => Clock {
            time_step: scene.duration_s,
            n_steps: 1,
        },
    };
    let mut recorder = (
        Peaks::new(n),
        Collisions::new(n, prepared.pairs()),
        TransferredMomentum::new(n),
    );
    let integrator = (contender.integrator)(setting);
    let work = prepared
        .run_by(&integrator, clock, &mut recorder)
        .map_err(|error| error.to_string())?;
    Ok((Quantities::of(&recorder, n), work))
}

impl Race {
    /// Measures the runs of a scene; fails with the reason where the reference failed.
    fn new(
        scene: &Scene,
        rungs: impl Iterator<Item = ((&'static Contender, f64), Outcome)>,
    ) -> Result<Self, String> {
        let rungs: Vec<_> = rungs.collect();
        let reference = rungs
            .iter()
            .rfind(|((contender, _), _)| contender.key == REFERENCE);
        let truth = match reference {
            Some((_, Ok((truth, _)))) => truth.clone(),
            Some((_, Err(reason))) => return Err(format!("\"{}\": {reason}", scene.name)),
            None => unreachable!("the reference is among the contenders"),
        };
        let mut entrants: Vec<Entrant> = Vec::new();
        for ((contender, setting), outcome) in rungs {
            let outcome = outcome.map(|(found, work)| Measured {
                work,
                n_collisions: found.n_collisions,
                same_count: found.n_collisions == truth.n_collisions,
                errors: Quantity::ALL.map(|quantity| found.distance(&truth, quantity)),
            });
            let rung = Rung { setting, outcome };
            match entrants.last_mut() {
                Some(last) if last.contender.key == contender.key => last.rungs.push(rung),
                _ => entrants.push(Entrant {
                    contender,
                    rungs: vec![rung],
                }),
            }
        }
        Ok(Self {
            scene: scene.name.clone(),
            compliant: is_compliant(scene),
            truth,
            entrants,
        })
    }
}
