//! The paper's claims under every motion in both directions.

use super::Case;
use super::numbers::direction;
use super::shaking::Shaking;
use super::world::MotionCase;
use crate::paper::claims::{Claim, ClaimCount, Finding};
use pounding_text::to_csv;

/// A claim under every motion in both directions, as recorded and reversed.
pub(super) struct Asked<'a> {
    /// The claim; what was computed is that of the first case.
    pub(super) claim: &'a Claim,
    pub(super) findings: Vec<[Finding; 2]>,
}

impl Asked<'_> {
    pub(super) fn tally(&self) -> ClaimCount {
        ClaimCount::of(self.findings.iter().flatten().copied())
    }
}

/// The claims that were asked, in their order.
pub(super) fn all<'a>(worlds: &'a [[MotionCase; 2]]) -> Vec<Asked<'a>> {
    let first = worlds.first().map_or(&[][..], |[world, _]| &world.claims);
    let asked = |(index, claim): (usize, &'a Claim)| {
        let finding = |world: &MotionCase| world.claims[index].finding;
        Asked {
            claim,
            findings: worlds.iter().map(|[one, other]| [finding(one), finding(other)]).collect(),
        }
    };
    first.iter().enumerate().map(asked).collect()
}

/// A row per claim: in how many cases it holds, what it does in the paper's own, and where it fails; of changed scenes also in
/// how many cases it holds of the `plain` ones.
pub(super) fn table(motions: &[Shaking], all: &[Asked<'_>], (plain, papers): (Option<Vec<Asked<'_>>>, Option<Case>)) -> String {
    let mut header = [
        "claim",
        "where",
        "cases",
        "holds",
        "holds_only_as_stated",
        "does_not_hold",
        "does_not_apply",
        "papers_record_and_direction",
        "papers_record_other_direction",
        "does_not_hold_under",
        "does_not_apply_under",
    ]
    .map(String::from)
    .to_vec();
    header.extend(plain.is_some().then(|| "holds_of_papers_scenes".into()));
    let row = |(index, asked): (usize, &Asked<'_>)| {
        let tally = asked.tally();
        let counts = [
            tally.cases,
            tally.holds,
            tally.only_as_stated,
            tally.does_not_hold(),
            tally.does_not_apply,
        ];
        let of_paper = |other: bool| {
            let case = papers?;
            let both = asked.findings.get(case.motion)?;
            Some(both[usize::from(case.reversed != other)].words())
        };
        let mut row = vec![asked.claim.claim.into(), asked.claim.place.into()];
        row.extend(counts.map(|count| count.to_string()));
        row.extend([false, true].map(|other| of_paper(other).unwrap_or_default().into()));
        for finding in [Finding::DoesNotHold, Finding::DoesNotApply] {
            row.push(under(motions, &asked.findings, finding));
        }
        let plain = plain.as_ref().map(|plain| plain[index].tally());
        row.extend(plain.map(|tally| tally.holds.to_string()));
        row
    };
    to_csv(&header, &all.iter().enumerate().map(row).collect::<Vec<_>>())
}

/// The cases with a finding, in words.
fn under(motions: &[Shaking], findings: &[[Finding; 2]], wanted: Finding) -> String {
    let words = |(motion, both): (&Shaking, &[Finding; 2])| {
        let directions = match both.map(|finding| finding == wanted) {
            [false, false] => return None,
            [true, true] => "both directions",
            [_, reversed] => direction(reversed),
        };
        Some(format!("{} ({directions})", motion.name))
    };
    let cases = motions.iter().zip(findings).filter_map(words);
    cases.collect::<Vec<_>>().join("; ")
}

/// A row per claim, motion and direction, with what was computed.
pub(super) fn verdicts(motions: &[Shaking], worlds: &[[MotionCase; 2]]) -> String {
    let header = ["claim", "motion", "direction", "verdict", "computed"].map(String::from);
    let mut rows = Vec::new();
    for index in 0..all(worlds).len() {
        for (motion, both) in motions.iter().zip(worlds) {
            for (world, reversed) in both.iter().zip([false, true]) {
                let claim = &world.claims[index];
                rows.push(vec![
                    claim.claim.into(),
                    motion.name.clone(),
                    direction(reversed).into(),
                    claim.finding.words().into(),
                    claim.computed.clone(),
                ]);
            }
        }
    }
    to_csv(&header, &rows)
}
