//! What surrounds the answer of an assessment on its page: rules in their own form, who hits whom, assumptions, limits of the model.

use pounding_assess::AssessedRun;
use pounding_text::{Grid, Shown, Table, Unit, digits, two_digits};

use super::AssessmentReport;
use crate::assumed::{Assumed, DEFAULT, SCENE};
use crate::not_modelled::Found;
use crate::row::{self, Meeting};

/// Every assessment has it.
const ASSESS: &str = "every assessment";

impl AssessmentReport {
    /// Every rule for every gap in its own form, beside the time history.
    pub(super) fn official(&self) -> Grid {
        Table::of(self.gaps_and_rules())
            .shown("Rule", |(gap, rule)| {
                let between = (self.assessment.gaps.len() > 1).then(|| self.gap_names(gap).join(" – "));
                Shown::from(rule.rule.name()).over(between)
            })
            .shown("Its form", |(_, rule)| Shown::from(rule.rule.words().form).long())
            .shown_number("Median", &Unit::WIDTH, |(_, rule)| rule.width.median())
            .shown_number("Largest", &Unit::WIDTH, |(_, rule)| rule.width.largest())
            .shown_number("Time history, largest", &Unit::NEEDED, |(gap, _)| gap.required.largest())
            .shown("Too narrow", |(_, rule)| {
                format!("{} of {}", rule.too_narrow, rule.width.sorted().len())
            })
            .shown_number("At worst", &Unit::WHOLE_PERCENT, |(_, rule)| rule.least_share)
            .grid()
    }

    /// Who hits whom in a row of three or more.
    pub(super) fn meetings(&self) -> Grid {
        let facing = self.floors.facing();
        let hit = self.hit();
        let meeting = |gap: &pounding_assess::GapAssessment| {
            let mut own = hit.iter().filter(|(pair, _)| facing[*pair].contact == gap.left);
            Meeting {
                gap: gap.left,
                times: self.of_cases(gap.touching),
                hardest: own.next().map(|(pair, one)| {
                    let force = one
                        .peak_force
                        .as_ref()
                        .map(|[_, high]| format!("{} kN", two_digits(1e-3 * high.largest())));
                    let speed = || format!("{} m/s", two_digits(one.approach_speed.unwrap_or(0.0)));
                    (*pair, force.unwrap_or_else(speed))
                }),
            }
        };
        let all = self.assessment.gaps.iter().map(meeting).collect();
        row::table(&self.scene, &self.floors, "They touch in", all)
    }

    /// What the assessment assumes.
    pub(super) fn assumed(&self) -> Grid {
        let [from, to] = self.stiffness.map(digits);
        let first = vec![
            Assumed::new("Method", "exact", ASSESS),
            Assumed::new("Directions of shaking", "both of each record", ASSESS),
            Assumed::new(
                "Scaling of the records",
                self.scaling.to.to_string(),
                if self.scaling.words.is_some() { "option" } else { SCENE },
            ),
            Assumed::new("Range of the contact stiffness", format!("{from} to {to} times that below"), {
                let usual = AssessedRun::stiffness_range(&self.scene);
                let is_usual = self.stiffness.iter().zip(usual).all(|(own, usual)| (own - usual).abs() <= 0.0);
                if is_usual { DEFAULT } else { "option" }
            }),
        ];
        Assumed::table(first, &self.scene, &self.floors)
    }

    /// The effects that the model leaves out and that matter for the scene.
    pub(super) fn not_modelled(&self) -> Vec<String> {
        let found = Found {
            scene: &self.scene,
            excesses: &self.excesses(),
            touch: !self.hit().is_empty(),
        };
        found.not_modelled()
    }
}
