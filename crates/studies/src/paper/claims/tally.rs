//! In how many cases a claim holds.

use super::Finding;

/// In how many cases a claim holds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ClaimCount {
    /// How many cases there are.
    pub cases: usize,
    /// In how many of them it holds, be it only as stated.
    pub holds: usize,
    /// In how many of these only as stated.
    pub only_as_stated: usize,
    /// In how many it does not apply.
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

    /// In how many cases it does not hold though it applies.
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
