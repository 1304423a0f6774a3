//! The answer of a command, once: parts in the order in which they are read. A terminal, a page and programs render them.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::terminal::facts;
use crate::{Grid, json_text, paragraph};

/// The form in which an answer is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// For people: the first screen.
    Brief,
    /// For people: everything.
    Details,
    /// A table for programs.
    Csv,
    /// Everything for programs.
    Json,
}

impl Form {
    /// The form that is asked for; at most one of these is true.
    pub fn asked(details: bool, csv: bool, json: bool) -> Self {
        match (details, csv, json) {
            (_, true, _) => Self::Csv,
            (.., true) => Self::Json,
            (true, ..) => Self::Details,
            _ => Self::Brief,
        }
    }

    /// Whether people read it.
    pub fn is_for_people(self) -> bool {
        matches!(self, Self::Brief | Self::Details)
    }
}

/// Where people read a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Where {
    /// In a terminal and on a page.
    Everywhere,
    /// In a terminal.
    Terminal,
    /// In a terminal without details.
    FirstScreen,
    /// In a terminal with details, and on a page.
    Details,
    /// On a page.
    Page,
}

/// How sentences stand on a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Manner {
    /// A paragraph each.
    Plain,
    /// A paragraph each, in smaller letters.
    Soft,
    /// A list.
    List,
    /// A list in a box under a title, which warns.
    Box(&'static str),
    /// A list beside the figure before it.
    Beside,
    /// The answer at the top of a page: a sentence in bold letters, and a list of those behind it.
    Verdict {
        /// How many sentences stand before it.
        before: usize,
        /// Whether something touches.
        touch: bool,
    },
    /// Two columns: what stands before `: ` and what behind it; also in a terminal, if the sentences stand under no word.
    Facts,
}

/// Sentences under a word.
#[derive(Debug, Clone, PartialEq)]
pub struct Sentences {
    /// The word before the first line in a terminal.
    pub label: &'static str,
    /// The sentences.
    pub lines: Vec<String>,
    /// How they stand on a page.
    pub manner: Manner,
}

impl Sentences {
    fn terminal(&self) -> String {
        if self.manner != Manner::Facts {
            return paragraph(self.label, &self.lines.join("\n"));
        }
        if self.label.is_empty() {
            return facts(&self.lines);
        }
        // The first fact has the word for its name, as in `method: exact` under `Method`.
        let name = format!("{}: ", self.label.to_lowercase());
        let text = self.lines.join("\n");
        paragraph(self.label, text.strip_prefix(&name).unwrap_or(&text))
    }
}

/// A part of an answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// A heading on a page.
    Heading(String),
    /// A heading on a page that begins a new sheet of paper.
    Appendix(String),
    /// Sentences.
    Words(Sentences),
    /// A table.
    Table(Grid),
    /// A place for the figure of this name on a page.
    Figure(&'static str),
    /// A text as it is: markup on a page; in a terminal, for example, commands to be copied.
    Markup(String),
}

/// The answer of a command.
#[derive(Default)]
pub struct Answer<'a> {
    parts: Vec<(Where, Part)>,
    facts: BTreeMap<&'static str, Value>,
    /// The whole JSON, if it is no collection of facts.
    json: Option<Box<dyn Fn() -> String + 'a>>,
    csv: Option<Box<dyn Fn() -> String + 'a>>,
}

impl std::fmt::Debug for Answer<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Answer")
            .field("parts", &self.parts)
            .field("facts", &self.facts)
            .finish_non_exhaustive()
    }
}

impl<'a> Answer<'a> {
    /// An answer without parts.
    pub fn new() -> Self {
        Self::default()
    }

    /// An answer that is a text as it is, in whatever form.
    pub fn verbatim(text: String) -> Self {
        let (csv, json) = (text.clone(), text.clone());
        Self::new()
            .part(Where::Terminal, Part::Markup(text))
            .with_csv(move || csv.clone())
            .with_json(move || json.clone())
    }

    /// Returns the answer with one part more.
    #[must_use]
    pub fn part(mut self, place: Where, part: Part) -> Self {
        self.parts.push((place, part));
        self
    }

    /// Returns the answer with sentences under a word, if there are any.
    #[must_use]
    pub fn say(self, place: Where, label: &'static str, lines: Vec<String>) -> Self {
        self.say_as(place, Manner::Plain, label, lines)
    }

    /// Returns the answer with sentences that stand on a page in this manner, if there are any.
    #[must_use]
    pub fn say_as(self, place: Where, manner: Manner, label: &'static str, lines: Vec<String>) -> Self {
        if lines.is_empty() {
            return self;
        }
        self.part(place, Part::Words(Sentences { label, lines, manner }))
    }

    /// Returns the answer with a table, if it has rows.
    #[must_use]
    pub fn table(self, place: Where, grid: Grid) -> Self {
        if grid.is_empty() {
            self
        } else {
            self.part(place, Part::Table(grid))
        }
    }

    /// Returns the answer with a heading on its page.
    #[must_use]
    pub fn heading(self, text: impl Into<String>) -> Self {
        self.part(Where::Page, Part::Heading(text.into()))
    }

    /// Returns the answer with a heading on its page that begins a new sheet of paper.
    #[must_use]
    pub fn appendix(self, text: impl Into<String>) -> Self {
        self.part(Where::Page, Part::Appendix(text.into()))
    }

    /// Returns the answer with a figure on its page.
    #[must_use]
    pub fn figure(self, name: &'static str) -> Self {
        self.part(Where::Page, Part::Figure(name))
    }

    /// Returns the answer with a fact for programs.
    #[must_use]
    pub fn fact(mut self, name: &'static str, value: impl Into<Value>) -> Self {
        self.facts.insert(name, value.into());
        self
    }

    /// Returns the answer with this JSON in place of its facts.
    #[must_use]
    pub fn with_json(self, json: impl Fn() -> String + 'a) -> Self {
        Self {
            json: Some(Box::new(json)),
            ..self
        }
    }

    /// Returns the answer with this table for programs.
    #[must_use]
    pub fn with_csv(self, csv: impl Fn() -> String + 'a) -> Self {
        Self {
            csv: Some(Box::new(csv)),
            ..self
        }
    }

    /// The parts, each with where people read it.
    pub fn parts(&self) -> &[(Where, Part)] {
        &self.parts
    }

    /// The answer in a form; without a table for programs the CSV is empty.
    pub fn text(&self, form: Form) -> String {
        match form {
            Form::Brief => self.terminal(false),
            Form::Details => self.terminal(true),
            Form::Csv => self.csv.as_ref().map_or_else(String::new, |csv| csv()),
            Form::Json => self.json.as_ref().map_or_else(|| json_text(&self.facts), |json| json()),
        }
    }

    fn terminal(&self, details: bool) -> String {
        let is_shown = |place: Where| match place {
            Where::Everywhere | Where::Terminal => true,
            Where::FirstScreen => !details,
            Where::Details => details,
            Where::Page => false,
        };
        let shown = self.parts.iter().filter(|(place, _)| is_shown(*place));
        let texts = shown.filter_map(|(_, part)| match part {
            Part::Words(words) => Some(words.terminal()),
            Part::Table(grid) => Some(grid.terminal(details)),
            Part::Markup(text) => Some(text.clone()),
            Part::Heading(_) | Part::Appendix(_) | Part::Figure(_) => None,
        });
        texts.collect::<Vec<_>>().join("\n")
    }
}

#[cfg(test)]
mod tests {
    use super::{Answer, Form, Where};
    use crate::{Table, Unit};

    #[test]
    fn reference_one_answer_in_every_form() {
        let gaps = Table::of([("a – b", 0.0412)])
            .shown("Gap", |row| row.0)
            .number("needed_m.largest", "Needed", &Unit::NEEDED, |row| row.1);
        let answer = Answer::new()
            .say(Where::Everywhere, "Answer", vec!["30 mm is not enough".into()])
            .table(Where::Details, gaps.grid())
            .fact("gaps", gaps.json())
            .with_csv(move || gaps.csv());
        assert_eq!(answer.text(Form::Brief), "Answer    30 mm is not enough\n");
        insta::assert_snapshot!(answer.text(Form::Details), @r"
        Answer    30 mm is not enough

        Gap    Needed
                 [mm]
        a – b    41.2
        ");
        assert_eq!(answer.text(Form::Csv), "needed_m.largest\n0.0412\n");
        let json: serde_json::Value = serde_json::from_str(&answer.text(Form::Json)).unwrap();
        assert_eq!(json, serde_json::json!({"gaps": [{"needed_m": {"largest": 0.0412}}]}));
    }
}
