//! Builds the answer of a run, which both the terminal and the page show. Programs read `summary.json`.

mod brief;
mod effects;
mod facts;
mod scene;
mod tables;
mod verdict;

pub use facts::{method_facts, record_facts};
pub use scene::damping_facts;

use pounding_scene::{BetweenSamples, Error, Excess, Implausible, Method, RunResult, Warning};
use pounding_text::{Answer, Grid, Manner, Where, digits};

use crate::assumed::{self, Assumed};
use crate::not_modelled::{self, Found};
use crate::page::{BEFORE, UNUSUAL, sentence};
use crate::row;
use crate::summary::RecordSummary;
use crate::{InWords, Report, Summary};

impl Report<'_> {
    /// Returns the answer. It says whether structures touch, how hard, what this does to the buildings, and how accurate these results are.
    /// Its JSON is the [`Summary`].
    pub fn answer(&self) -> Answer<'_> {
        let (prepared, review) = (self.prepared, self.review());
        let (summary, words) = (self.summary(), InWords::of(prepared, review));
        let answer = self.begin(&summary);
        // One box answers; the run of the scene's own direction follows it as a list.
        let manner = match self.directions {
            Some(_) => Manner::List,
            None => verdict::manner(&summary),
        };
        let answer = self
            .both_directions(answer)
            .say(Where::FirstScreen, "Scene", brief::scene(prepared, review))
            .say(Where::FirstScreen, "Tables", self.says_tables())
            .say_as(Where::Page, manner, "", verdict::lines(&summary, review))
            .say_as(Where::Page, Manner::Box(not_modelled::TITLE), "", self.not_modelled())
            .table(Where::Page, brief::buildings(prepared, &words))
            .table(Where::FirstScreen, brief::pairs(prepared, &review.outcome))
            .say_as(Where::Terminal, Manner::Soft, "Force", brief::forces(prepared, &review.outcome))
            .say_as(Where::Page, Manner::Soft, "", self.says_forces())
            .say(Where::FirstScreen, "Apart", brief::apart(prepared, &review.outcome))
            .table(Where::FirstScreen, brief::openings(prepared, &words))
            .table(Where::Page, brief::openings(prepared, &words))
            .say_as(Where::Terminal, Manner::Soft, "Seats", brief::says_seats(prepared))
            .say(Where::Page, "", self.says_seats())
            .table(Where::FirstScreen, brief::buildings(prepared, &words))
            .table(Where::FirstScreen, tables::links(prepared, &words))
            .say(Where::FirstScreen, "Samples", self.says_samples());
        let answer = self
            .warnings(answer)
            .figure("animation")
            .figure("profiles")
            .table(
                Where::Page,
                row::table(prepared.scene(), prepared.floors(), "Times", row::of_run(prepared, &review.outcome)),
            )
            .figure("blow")
            .heading("What was assumed")
            .table(Where::Page, self.assumed())
            .appendix("motion")
            .figure("displacements");
        let answer = self.touches(answer, &summary, &words);
        let answer = match &self.effects {
            Some(effects) => effects::parts(answer.heading("What pounding does to every storey"), prepared, effects),
            None => answer,
        };
        let answer = answer
            .heading("Structures")
            .table(Where::Details, tables::structures(prepared, &words))
            .table(Where::Details, tables::motions(prepared, &words))
            .table(Where::Details, tables::storeys(prepared, &words))
            .say_as(
                Where::Details,
                Manner::Soft,
                "Notes",
                vec![tables::notes(prepared, &review.outcome)],
            )
            .figure("hysteresis");
        self.made_of(answer, &summary)
            .say(Where::FirstScreen, "More", vec![MORE.into()])
            .with_json(|| self.summary().to_json())
    }

    /// The answer with what precedes all else: a collapse, unless the sentences of both directions name it, unusual values and warnings.
    fn begin(&self, summary: &Summary) -> Answer<'_> {
        let collapse = self.prepared.says_collapse(&self.review().outcome);
        let collapse = collapse.filter(|_| self.directions.is_none());
        let unusual = Implausible::lines(summary.unusual.iter().map(|one| ("", one)));
        Answer::new()
            .say_as(
                Where::Everywhere,
                Manner::Box("Collapse"),
                "Collapse",
                collapse.iter().map(|said| sentence(said)).collect(),
            )
            .say_as(Where::Everywhere, Manner::Box(UNUSUAL), "Unusual", unusual)
            .say_as(Where::Page, Manner::Box(BEFORE), "", self.notices())
    }

    /// What the record leaves open between its samples.
    fn says_samples(&self) -> Vec<String> {
        let says = |found: &Result<BetweenSamples, Error>| match found {
            Ok(between) => between.to_string(),
            Err(error) => format!("not known, the run with a band-limited record fails: {error}"),
        };
        self.between_samples.iter().map(says).collect()
    }

    /// Adds the pairs and their collisions.
    fn touches<'a>(&self, answer: Answer<'a>, summary: &Summary, words: &InWords<'_>) -> Answer<'a> {
        let (prepared, outcome) = (self.prepared, &self.review().outcome);
        answer
            .heading("Pairs")
            .table(Where::Details, tables::pairs(prepared, words))
            .say_as(Where::Everywhere, Manner::Soft, "Leaning", tables::leaning(prepared, outcome))
            .say(Where::Terminal, "Pairs", no_pairs(summary))
            .say(Where::Page, "", no_pairs(summary).iter().map(|none| sentence(none)).collect())
            .figure("gaps")
            .heading_of("Collisions", tables::collisions(prepared, outcome))
            .heading_of("Links", tables::links(prepared, words))
    }

    /// What the used part of a seat is, in sentences of a page.
    fn says_seats(&self) -> Vec<String> {
        brief::says_seats(self.prepared).iter().map(|said| sentence(said)).collect()
    }

    /// Adds the facts of the run: its scene, ground motion, method, errors, histories, work and energy.
    fn made_of<'a>(&self, answer: Answer<'a>, summary: &Summary) -> Answer<'a> {
        let (prepared, review) = (self.prepared, self.review());
        answer
            .heading("Scene")
            .say(Where::Details, "Scene", vec![summary.scene.name.clone()])
            .table(Where::Details, scene::structures(prepared))
            .say_as(Where::Details, Manner::Soft, "Damping", damping_facts(prepared, &review.outcome))
            .table(Where::Details, scene::contacts(&summary.scene))
            .table(Where::Details, scene::links(&summary.scene))
            .heading("Ground motion")
            .say_as(Where::Details, Manner::Facts, "Record", record_facts(prepared))
            .figure("ground-motion")
            .heading("Method")
            .say_as(
                Where::Details,
                Manner::Facts,
                "Method",
                method_facts(prepared, review.outcome.collapse),
            )
            .say_as(Where::Details, Manner::Facts, "Errors", facts::errors(prepared, review))
            .say_as(
                Where::Page,
                Manner::Facts,
                "Histories",
                facts::histories(summary, self.sampling.words),
            )
            .say_as(Where::Details, Manner::Facts, "Work", facts::work(review))
            .heading("Energy")
            .say_as(Where::Details, Manner::Facts, "Energy", facts::ledger(summary))
    }

    /// Adds a sentence for each direction of shaking, if both were requested. The worse direction comes first, unless the other run failed.
    fn both_directions<'a>(&self, answer: Answer<'a>) -> Answer<'a> {
        let Some(directions) = &self.directions else {
            return answer;
        };
        let touch = |run: &RunResult| !run.collisions.all().is_empty();
        let manner = Manner::Verdict {
            before: 0,
            touch: touch(&self.review.outcome) || directions.other.as_ref().is_some_and(touch),
        };
        answer
            .say_as(Where::Everywhere, manner, "Answer", directions.sentences.to_vec())
            .say(
                Where::Page,
                "",
                vec!["The results below are for the direction of shaking that the scene gives.".into()],
            )
    }

    /// Whose numbers the tables below an answer about both directions have.
    fn says_tables(&self) -> Vec<String> {
        let direction = self.directions.as_ref().map(|_| self.prepared.scene().record.direction());
        let effects = if self.effects.is_some() {
            "; effects of both directions"
        } else {
            ""
        };
        let said = direction.map(|direction| format!("shaken {direction}{effects}"));
        said.into_iter().collect()
    }

    /// Adds the warnings, or says that there are none. If a warning concerns errors, it also names the command that helps.
    fn warnings<'a>(&self, answer: Answer<'a>) -> Answer<'a> {
        let mut warnings = self.notices();
        let is_error = |one: &Warning| matches!(one, Warning::Error { .. });
        if self.review.warnings.iter().any(is_error) {
            warnings.push("`pounding advise SCENE --accuracy 3%` finds a method and time step".into());
        }
        let others = self.directions.iter().filter_map(|both| both.other.as_ref());
        let runs: Vec<&RunResult> = std::iter::once(&self.review.outcome).chain(others).collect();
        warnings.extend(Excess::says_assumed(self.prepared.floors(), |floor| {
            let drifts = runs.iter().map(|run| run.peaks.of(floor).drift().value.abs());
            drifts.fold(0.0, f64::max)
        }));
        if warnings.is_empty() {
            let besides = if self.prepared.doubts().is_empty() {
                "none"
            } else {
                "none, apart from the unusual values above"
            };
            return answer.say(Where::Terminal, "Warnings", vec![besides.into()]);
        }
        answer.say(Where::Terminal, "Warnings", warnings)
    }

    /// The sentence about forces, which a terminal begins with a label.
    fn says_forces(&self) -> Vec<String> {
        let said = brief::forces(self.prepared, &self.review().outcome).into_iter();
        said.map(|said| sentence(&format!("the forces are {}", said.replace("; grows", "; they grow"))))
            .collect()
    }

    /// The effects that the model leaves out and that matter for the scene.
    fn not_modelled(&self) -> Vec<String> {
        let both = std::iter::once(&self.review.outcome).chain(self.other());
        let found: Vec<_> = both.clone().flat_map(|run| self.prepared.excesses(run)).collect();
        let found = Found {
            scene: self.prepared.scene(),
            excesses: &found,
            touch: both.into_iter().any(|run| !run.collisions.all().is_empty()),
        };
        found.not_modelled()
    }

    /// What the run assumes.
    fn assumed(&self) -> Grid {
        let (prepared, scene) = (self.prepared, self.prepared.scene());
        let method = scene.method.name().replace('_', " ");
        let step = scene.method.time_step();
        let step = step.map_or_else(String::new, |step| format!(", steps of {} s", digits(step)));
        let directions = match self.directions {
            Some(_) => "both, as given and reversed",
            None => scene.record.direction(),
        };
        let record = RecordSummary::of(prepared);
        let first = vec![
            Assumed::unless_default("Method", format!("{method}{step}"), scene.method == Method::EXACT),
            assumed::duration(prepared),
            Assumed::unless_default("Directions of shaking", directions, self.directions.is_some()),
            Assumed::unless_default("Processing of the record", facts::processed(&record), record.processing.is_empty()),
        ];
        Assumed::table(first, scene, prepared.floors())
    }
}

/// Returns the sentence that replaces the table of pairs if the scene has no pairs.
fn no_pairs(summary: &Summary) -> Vec<String> {
    let none = summary.pairs.is_empty();
    none.then(|| "none: no contact is modelled".into()).into_iter().collect()
}

const MORE: &str = "--details prints every floor, the record, errors and work; --out FOLDER writes a report; `pounding explain WORD` says what a word means";

/// Adds a heading and its table, or neither if the table is empty.
trait HeadingOf {
    fn heading_of(self, title: &str, table: Grid) -> Self;
}

impl HeadingOf for Answer<'_> {
    fn heading_of(self, title: &str, table: Grid) -> Self {
        if table.is_empty() {
            self
        } else {
            self.heading(title).table(Where::Details, table)
        }
    }
}
