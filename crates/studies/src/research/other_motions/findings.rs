//! The paper's claims under every motion in both directions.

use super::Case;
use super::shaking::Shaking;
use super::world::MotionCase;
use crate::files::direction;
use crate::paper::claims::{Claim, ClaimCount, Finding};
use pounding_text::Table;

/// A claim under every motion in both directions, as given and reversed.
pub(super) struct TestedClaim<'a> {
    /// The claim, with the computed numbers of the first case.
    pub(super) claim: &'a Claim,
    pub(super) findings: Vec<[Finding; 2]>,
}

impl TestedClaim<'_> {
    pub(super) fn tally(&self) -> ClaimCount {
        ClaimCount::of(self.findings.iter().flatten().copied())
    }

    /// The finding in the paper's case, or in the case of its other direction.
    fn of_paper(&self, papers: Option<Case>, other: bool) -> Option<&'static str> {
        let case = papers?;
        let both = self.findings.get(case.motion)?;
        Some(both[usize::from(case.reversed != other)].words())
    }

    /// The cases with a finding, as text.
    fn under(&self, motions: &[Shaking], wanted: Finding) -> String {
        let words = |(motion, both): (&Shaking, &[Finding; 2])| {
            let directions = match both.map(|finding| finding == wanted) {
                [false, false] => return None,
                [true, true] => "both directions",
                [_, reversed] => direction(reversed),
            };
            Some(format!("{} ({directions})", motion.name))
        };
        let cases = motions.iter().zip(&self.findings).filter_map(words);
        cases.collect::<Vec<_>>().join("; ")
    }
}

/// The tested claims in their order.
pub(super) fn all(worlds: &[[MotionCase; 2]]) -> Vec<TestedClaim<'_>> {
    let first = worlds.first().map_or(&[][..], |[world, _]| &world.claims);
    let asked = |(index, claim): (usize, _)| {
        let findings = worlds.iter().map(|both| both.each_ref().map(|world| world.claims[index].finding));
        TestedClaim {
            claim,
            findings: findings.collect(),
        }
    };
    first.iter().enumerate().map(asked).collect()
}

/// Table with one row per claim: the number of cases in which it holds, its finding in the paper's case, and the cases in which it fails.
/// For changed scenes a column adds the number of `plain` cases in which it holds.
pub(super) fn table(motions: &[Shaking], all: &[TestedClaim<'_>], plain: Option<&[TestedClaim<'_>]>, papers: Option<Case>) -> String {
    let mut table = Table::of(all.iter().enumerate())
        .column("claim", |(_, one)| one.claim.claim)
        .column("where", |(_, one)| one.claim.place)
        .column("cases", |(_, one)| one.tally().cases)
        .column("holds", |(_, one)| one.tally().holds)
        .column("holds_only_as_stated", |(_, one)| one.tally().only_as_stated)
        .column("does_not_hold", |(_, one)| one.tally().does_not_hold())
        .column("does_not_apply", |(_, one)| one.tally().does_not_apply)
        .column("papers_record_and_direction", |(_, one)| one.of_paper(papers, false))
        .column("papers_record_other_direction", |(_, one)| one.of_paper(papers, true))
        .column("does_not_hold_under", |(_, one)| one.under(motions, Finding::DoesNotHold))
        .column("does_not_apply_under", |(_, one)| one.under(motions, Finding::DoesNotApply));
    if let Some(plain) = plain {
        table = table.column("holds_of_papers_scenes", |(index, _)| plain[*index].tally().holds);
    }
    table.csv()
}

/// Table with one row per claim, motion and direction, with the computed numbers.
pub(super) fn verdicts(motions: &[Shaking], worlds: &[[MotionCase; 2]]) -> String {
    let cases = || {
        motions
            .iter()
            .zip(worlds)
            .flat_map(|(motion, both)| both.iter().zip([false, true]).map(move |world| (motion, world)))
    };
    let of_claim = |index| cases().map(move |(motion, (world, reversed))| (motion, reversed, &world.claims[index]));
    let n_claims = worlds.first().map_or(0, |[world, _]| world.claims.len());
    Table::of((0..n_claims).flat_map(of_claim))
        .column("claim", |(.., claim)| claim.claim)
        .column("motion", |(motion, ..)| motion.name.clone())
        .column("direction", |(_, reversed, _)| direction(*reversed))
        .column("verdict", |(.., claim)| claim.finding.words())
        .column("computed", |(.., claim)| claim.computed.clone())
        .csv()
}
