//! Verdicts on the claims by exact runs, and by exact runs under noisy records.

use super::{Asked, Claim, ClaimCount, Finding, Runs, TESTS, Test};
use crate::files::yes_or_no;
use crate::{Completed, StudyError};

/// Share of the noisy records in which a claim must hold to survive \[–\].
const ENOUGH: f64 = 0.95;

/// The verdict of exact runs on a claim.
#[derive(Debug, Clone, PartialEq)]
pub enum Survival {
    /// Exact runs cannot test the claim; the text is the reason.
    NotAsked(&'static str),
    /// Exact runs test the claim.
    Asked {
        /// The computed numbers under the paper's record, in words.
        computed: String,
        /// The verdict under the paper's record.
        finding: Finding,
        /// Number of noisy records under which the claim holds.
        n_holds: usize,
        /// Number of noisy records.
        n_noisy: usize,
    },
}

impl Survival {
    /// Table cells: the computed numbers, the verdict, and whether the claim survives perturbation.
    pub(super) fn cells(&self) -> [String; 3] {
        match self {
            Self::NotAsked(reason) => {
                let not = format!("not asked: {reason}");
                [String::new(), not.clone(), not]
            }
            Self::Asked {
                computed,
                finding,
                n_holds,
                n_noisy,
            } => {
                let share = *n_holds as f64 / *n_noisy as f64;
                let perturbed = if *n_noisy == 0 {
                    "not asked: no noisy records".into()
                } else {
                    format!("{}: in {n_holds} of {n_noisy} runs", yes_or_no(share >= ENOUGH))
                };
                [computed.clone(), finding.words().into(), perturbed]
            }
        }
    }

    /// The table cell with the number of other ground motions under which the claim holds.
    pub(super) fn beyond(&self, tally: Option<ClaimCount>) -> String {
        match (self, tally) {
            (Self::NotAsked(reason), _) => format!("not asked: {reason}"),
            (Self::Asked { .. }, None) => "not asked: no other ground motions".into(),
            (Self::Asked { .. }, Some(tally)) => tally.words(),
        }
    }
}

/// The claims that exact runs can test: their index among all claims, and a short name with line breaks.
pub(crate) fn asked() -> impl Iterator<Item = (usize, &'static str)> {
    let words = |(index, Test(_, _, asked, _)): (usize, &Test)| match *asked {
        Asked::Exactly(words) => Some((index, words)),
        Asked::Not(_) => None,
    };
    TESTS.iter().enumerate().filter_map(words)
}

/// The verdicts of exact runs on every claim; `None` for a claim that they cannot test.
///
/// # Errors
/// [`StudyError::MissingScene`] if a scene that a claim needs is missing.
pub(crate) fn verdicts(exact: &[Completed]) -> Result<Vec<Option<Claim>>, StudyError> {
    let runs = Runs::new(exact);
    let verdict = |test: &Test| match test.2 {
        Asked::Exactly(_) => test.run(&runs).map(Some),
        Asked::Not(_) => Ok(None),
    };
    TESTS.iter().map(verdict).collect()
}

/// Combines the verdicts of the exact runs with those of the noisy runs.
pub(crate) fn survivals(exact: &[Option<Claim>], noisy: &[Vec<Option<Claim>>]) -> Vec<Survival> {
    let survival = |(index, verdict): (usize, &Option<Claim>)| match (verdict, TESTS[index].2) {
        (Some(verdict), _) => {
            let holds = |run: &&Vec<Option<Claim>>| run[index].as_ref().is_some_and(|run| run.finding.holds());
            Survival::Asked {
                computed: verdict.computed.clone(),
                finding: verdict.finding,
                n_holds: noisy.iter().filter(holds).count(),
                n_noisy: noisy.len(),
            }
        }
        (None, Asked::Not(reason)) => Survival::NotAsked(reason),
        (None, Asked::Exactly(_)) => unreachable!("verdicts answers what is asked"),
    };
    exact.iter().enumerate().map(survival).collect()
}
