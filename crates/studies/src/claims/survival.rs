//! Which claims hold of exact runs, and of exact runs under noisy records.

use super::{Finding, Runs, TESTS};
use crate::{Completed, StudyError};

/// Share of the noisy records in which a claim must hold to survive \[–\].
const ENOUGH: f64 = 0.95;

/// Whether a claim holds of the exact runs, and what they gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Exactly {
    holds: bool,
    computed: String,
}

/// What exact runs say to a claim.
#[derive(Debug, Clone, PartialEq)]
pub enum Survival {
    /// Nothing, for this reason.
    NotAsked(&'static str),
    /// Something.
    Asked {
        /// What was computed under the paper's record.
        computed: String,
        /// Whether the claim holds there.
        converged: bool,
        /// Of how many noisy records it holds.
        n_holds: usize,
        /// How many noisy records there were.
        n_noisy: usize,
    },
}

impl Survival {
    /// What was computed, whether the claim survives convergence, and whether it survives perturbation, in words.
    pub(super) fn cells(&self) -> [String; 3] {
        match self {
            Self::NotAsked(reason) => {
                let not = format!("not asked: {reason}");
                [String::new(), not.clone(), not]
            }
            Self::Asked {
                computed,
                converged,
                n_holds,
                n_noisy,
            } => {
                let word = |yes| if yes { "yes" } else { "no" };
                let share = *n_holds as f64 / *n_noisy as f64;
                let perturbed = if *n_noisy == 0 {
                    "not asked: no noisy records".into()
                } else {
                    format!("{}: in {n_holds} of {n_noisy} runs", word(share >= ENOUGH))
                };
                [computed.clone(), word(*converged).into(), perturbed]
            }
        }
    }
}

/// The verdict of exact runs on every claim; nothing where they have nothing to say.
///
/// # Errors
/// [`StudyError::MissingScene`] when a scene that a claim needs is not there.
pub(crate) fn verdicts(exact: &[Completed]) -> Result<Vec<Option<Exactly>>, StudyError> {
    let runs = Runs::new(exact);
    let verdict = |(test, silent): &(super::Test, Option<&str>)| {
        if silent.is_some() {
            return Ok(None);
        }
        let claim = test(&runs)?;
        Ok(Some(Exactly {
            holds: claim.finding != Finding::DoesNotHold,
            computed: claim.computed,
        }))
    };
    TESTS.iter().map(verdict).collect()
}

/// What became of every claim: of the exact runs, and of noisy ones.
pub(crate) fn survivals(
    exact: &[Option<Exactly>],
    noisy: &[Vec<Option<Exactly>>],
) -> Vec<Survival> {
    let survival = |(index, verdict): (usize, &Option<Exactly>)| match (verdict, TESTS[index].1) {
        (Some(verdict), _) => {
            let holds =
                |run: &&Vec<Option<Exactly>>| run[index].as_ref().is_some_and(|run| run.holds);
            Survival::Asked {
                computed: verdict.computed.clone(),
                converged: verdict.holds,
                n_holds: noisy.iter().filter(holds).count(),
                n_noisy: noisy.len(),
            }
        }
        (None, reason) => Survival::NotAsked(reason.unwrap_or("")),
    };
    exact.iter().enumerate().map(survival).collect()
}
