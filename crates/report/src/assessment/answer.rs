//! The answer of an assessment, once, for the terminal, the page and programs.

use pounding_assess::{Rule, TargetFit};
use pounding_text::{Answer, Manner, Where};
use serde_json::{Value, json};

use super::AssessmentReport;
use super::tables::{first, statistics};
use crate::SCHEMA_VERSION;
use crate::gaps::says_moat;
use crate::not_modelled;
use crate::page::{BEFORE, UNUSUAL, sentence};
use crate::rules::{notes, sources};

impl AssessmentReport {
    /// The answer: the gaps, the effects of touching, and how sure these are. Its CSV has a line for each number \[SI\]: record, reversed, building,
    /// floor, neighbour, quantity, value.
    pub fn answer(&self) -> Answer<'_> {
        let unusual = self.unusual().iter().map(ToString::to_string).collect();
        // What no gap helps against is the bold sentence of the page.
        let is_over = !self.over_capacity().is_empty() || self.isolators_over().is_some() || self.off_seats().is_some();
        let verdict = Manner::Verdict {
            before: if is_over { 0 } else { self.before().len() },
            touch: is_over || !self.hit().is_empty(),
        };
        let answer = Answer::new()
            .say_as(Where::Everywhere, Manner::Box(UNUSUAL), "Unusual", unusual)
            .say_as(Where::Page, Manner::Box(BEFORE), "", self.warnings())
            .say_as(Where::Everywhere, verdict, "Answer", self.sentences())
            .figure("animation")
            .say_as(Where::Everywhere, Manner::Beside, "Motions", self.shaking())
            .say(Where::Terminal, "Warnings", self.warnings())
            .say_as(Where::Page, Manner::Box(not_modelled::TITLE), "", self.not_modelled())
            .figure("spectra");
        let answer = self
            .widths(answer)
            .heading("What was assumed")
            .table(Where::Page, self.assumed())
            .appendix("what touching does");
        let mut answer = self.touching(answer);
        if self.assessment.disbelieved < self.assessment.cases {
            answer = answer.figure("amplification");
        }
        let answer = answer.figure("neighbour");
        let answer = self.rules_and_motions(answer);
        self.facts(answer).with_csv(|| self.numbers().csv())
    }

    /// The widths that are needed, and those of rules; nothing if no event is believed while the buildings stand alone.
    fn widths<'a>(&'a self, answer: Answer<'a>) -> Answer<'a> {
        if self.assessment.believed_alone() == 0 {
            return answer;
        }
        answer
            .heading("Required gap")
            .say(Where::Page, "", vec![REQUIRED.into()])
            .table(Where::Everywhere, first(&self.gaps()))
            .figure("gap")
            .heading("Rules of codes beside the time history")
            .say(Where::Page, "", vec![RULES.into()])
            .table(Where::Page, self.official())
            .say_as(Where::Page, Manner::Soft, "", self.rule_notes())
            .table(Where::Page, self.meetings())
            .figure("profiles")
    }

    fn touching<'a>(&'a self, answer: Answer<'a>) -> Answer<'a> {
        let answer = match self.animation {
            Some(_) => answer.figure("row"),
            None => answer,
        };
        let hit = self.hit();
        if hit.is_empty() {
            let none = if self.leaves_out() {
                "No floors that were looked at touch."
            } else {
                "Nothing touches."
            };
            let why = self.floors.says_no_contact().map_or_else(|| none.into(), sentence);
            return answer.say(Where::Page, "", vec![why]);
        }
        if self.assessment.disbelieved == self.assessment.cases {
            let none = format!("No effect of touching is shown, since no {} is believed.", self.sample());
            return answer.say(Where::Page, "", vec![none]);
        }
        let worse = self.worse();
        let [one, several] = match self.scene.words().storey {
            "storey" => ["storey", "Storeys"],
            _ => ["structure", "Structures"],
        };
        let storeys = if worse.is_empty() {
            format!("No {one} gets worse by more than 10 %.")
        } else {
            format!("{several} whose drift, shear force or acceleration becomes more than 10 % larger:")
        };
        let [from, to] = self.stiffness.map(pounding_text::digits);
        let runs = match self.assessment.disbelieved {
            0 => "all runs",
            _ => "the events that count",
        };
        let forces = format!(
            "Largest forces and impulses of {runs}; pushes, which last longer than 0.25 s and than blows of the contact, have no impulse here. The range is that of \
             the contact, {from} to {to} times as stiff as in the scene. Nobody knows the stiffness better, and it decides forces and accelerations."
        );
        let worse = first(&self.storeys(worse));
        let mut answer = answer
            .say(Where::Page, "", vec![storeys])
            .say_as(Where::Page, Manner::Soft, "", vec![STOREYS.into()])
            .table(Where::Page, worse.clone())
            .table(Where::FirstScreen, worse)
            .say(Where::Page, "", vec![forces])
            .table(Where::Everywhere, first(&self.pairs(hit)));
        if let Some(effect) = self.bumpers() {
            answer = answer
                .heading("Bumpers in the gaps")
                .say(Where::Page, "", vec![self.bumper_says().join(" ")]);
            if self.bumpers_hold() {
                answer = answer
                    .table(Where::Details, self.bumper_pairs(effect).grid())
                    .table(Where::Details, self.bumper_storeys(effect).grid());
            }
        }
        answer
    }

    /// What stands beside the widths of rules: their sources, and why a moat has none.
    fn rule_notes(&self) -> Vec<String> {
        let notes = notes(&self.scene, &self.ruled_gaps(), &Rule::ALL);
        notes.into_iter().chain(says_moat(&self.floors)).collect()
    }

    fn rules_and_motions<'a>(&'a self, answer: Answer<'a>) -> Answer<'a> {
        let answer = if self.assessment.believed_alone() == 0 {
            answer
        } else {
            answer
                .table(Where::Terminal, first(&self.rules()))
                .say_as(Where::Terminal, Manner::Soft, "Rules", self.rule_notes())
                .say_as(Where::Details, Manner::Soft, "Codes", vec![sources(&Rule::ALL)])
        };
        answer
            .heading("Motions")
            .table(Where::Details, self.runs().grid())
            .say_as(Where::Everywhere, Manner::List, "Records", self.remarks().to_vec())
            .heading(match self.scene.words().storey {
                "storey" => "Every storey",
                _ => "Every structure",
            })
            .say_as(Where::Details, Manner::Soft, "Storeys", vec![STOREYS.into()])
            .table(Where::Details, self.storeys(self.every_storey()).grid())
            .say(Where::FirstScreen, "More", vec![MORE.into()])
    }

    /// Everything for programs, SI units.
    fn facts<'a>(&'a self, answer: Answer<'a>) -> Answer<'a> {
        let assessment = &self.assessment;
        let by_stiffness = assessment.by_stiffness.as_ref().map(|effect| {
            json!({
                "drift_largest_over_least": statistics(&effect.drift),
                "acceleration_largest_over_least": statistics(&effect.acceleration),
                "impulse_largest_over_least": statistics(&effect.impulse),
            })
        });
        let pairs = assessment.pairs.iter().enumerate().collect();
        answer
            .fact("schema_version", SCHEMA_VERSION)
            .fact("version", env!("CARGO_PKG_VERSION"))
            .fact("unusual", json!(self.unusual()))
            .fact("cautions", self.before())
            .fact("answers", self.answers())
            .fact("proposals", self.proposals())
            .fact("code", json!(self.code.map(Rule::cited)))
            .fact("neighbour", self.prior_json())
            .fact("bumper", self.bumper_json())
            .fact("warnings", self.warnings())
            .fact("runs", assessment.runs)
            .fact("stiffness_factors", json!(self.stiffness))
            .fact("scaling", json!(self.scaling.words))
            .fact("scaled", self.scaling.to.to_string())
            .fact("target", json!(self.fit.as_ref().map(fit)))
            .fact("events", assessment.events)
            .fact("cases", assessment.cases)
            .fact("collapsed", assessment.collapsed)
            .fact("left_out", self.folder.left_out.clone())
            .fact("by_stiffness", json!(by_stiffness))
            .fact("gaps", self.gaps().json())
            .fact("floors", self.storeys(self.floors_in_order()).json())
            .fact("pairs", self.pairs(pairs).json())
            .fact("motions", self.runs().json())
            .fact("scene", json!(self.asked))
    }
}

const REQUIRED: &str = "The width that keeps the neighbours apart under an event: the largest closing of the gap while \
                        nothing touches, of its components in both directions.";

const RULES: &str = "Each rule in its own form, with the displacements u of the time history of both buildings while nothing touches. “At worst” is \
                     its width as a part of the one that the time history needs.";

const STOREYS: &str = "Median / 84 % of the events in which their building touches, of fewer than seven events the largest alone. Drift and shear force \
                       are those of the storey; the acceleration is that of the floor above it, with the contact that gives least to the one that \
                       gives most.";

const MORE: &str =
    "--details prints every run and storey, --out FOLDER writes a report, --bumper proposed says what bumpers in the gaps change";

fn fit(fit: &TargetFit) -> Value {
    let (share, period) = fit.least();
    json!({
        "least_share": share,
        "least_share_at_s": period,
        "peak_share": fit.peak_share,
        "periods_s": fit.periods,
        "target_g": fit.target,
        "mean_g": fit.mean,
    })
}
