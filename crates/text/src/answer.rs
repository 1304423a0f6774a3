//! The answer of a command, written in one place as a list of parts in reading order. A terminal and a page show the parts. Programs get
//! separate facts as JSON, or a table as CSV.

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
    /// Returns the requested form. The caller sets at most one of the three arguments.
    pub fn asked(details: bool, csv: bool, json: bool) -> Self {
        match (details, csv, json) {
            (_, true, _) => Self::Csv,
            (.., true) => Self::Json,
            (true, ..) => Self::Details,
            _ => Self::Brief,
        }
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

/// How a page lays out sentences.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Manner {
    /// Each sentence is a paragraph.
    Plain,
    /// Each sentence is a paragraph in smaller letters.
    Soft,
    /// A list.
    List,
    /// A list in a warning box. The box begins with this title.
    Box(&'static str),
    /// A list next to the figure of the previous part.
    Beside,
    /// The verdict box of a page: one sentence in bold, and a list of the sentences after it.
    Verdict {
        /// Number of ordinary sentences before the bold one.
        before: usize,
        /// Whether something touches, or a building fails without a touch.
        touch: bool,
    },
    /// Two columns: the text before `: ` and the text after it. A terminal shows two columns only if the label is empty.
    Facts,
}

/// Sentences with a label in front.
#[derive(Debug, Clone, PartialEq)]
pub struct Sentences {
    /// The label before the first line in a terminal.
    pub label: &'static str,
    /// The sentences.
    pub lines: Vec<String>,
    /// Their layout on a page.
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
        // If the first fact is named like the label, as in `method: exact` with the label `Method`, its name is left out.
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
    /// The heading of an appendix. In print it starts a new sheet.
    Appendix(String),
    /// Sentences with their label and layout.
    Words(Sentences),
    /// A table.
    Table(Grid),
    /// A place for the figure of this name on a page.
    Figure(&'static str),
    /// Text that is printed unchanged. On a page it is HTML; in a terminal it is, for example, commands to copy.
    Markup(String),
}

/// The answer of a command.
#[derive(Default)]
pub struct Answer<'a> {
    parts: Vec<(Where, Part)>,
    facts: BTreeMap<&'static str, Value>,
    /// Makes the JSON, if it is not made from `facts`.
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

    /// Returns the answer with one more part.
    #[must_use]
    pub fn part(mut self, place: Where, part: Part) -> Self {
        self.parts.push((place, part));
        self
    }

    /// Adds sentences with a label. Adds nothing if there are no sentences.
    #[must_use]
    pub fn say(self, place: Where, label: &'static str, lines: Vec<String>) -> Self {
        self.say_as(place, Manner::Plain, label, lines)
    }

    /// Adds sentences with a label and a layout for pages. Adds nothing if there are no sentences.
    #[must_use]
    pub fn say_as(self, place: Where, manner: Manner, label: &'static str, lines: Vec<String>) -> Self {
        if lines.is_empty() {
            return self;
        }
        self.part(place, Part::Words(Sentences { label, lines, manner }))
    }

    /// Adds a table. Adds nothing if it has no rows.
    #[must_use]
    pub fn table(self, place: Where, grid: Grid) -> Self {
        if grid.is_empty() {
            self
        } else {
            self.part(place, Part::Table(grid))
        }
    }

    /// Adds a heading to the page.
    #[must_use]
    pub fn heading(self, text: impl Into<String>) -> Self {
        self.part(Where::Page, Part::Heading(text.into()))
    }

    /// Adds the heading of an appendix to the page. In print it starts a new sheet.
    #[must_use]
    pub fn appendix(self, text: impl Into<String>) -> Self {
        self.part(Where::Page, Part::Appendix(text.into()))
    }

    /// Adds a figure to the page.
    #[must_use]
    pub fn figure(self, name: &'static str) -> Self {
        self.part(Where::Page, Part::Figure(name))
    }

    /// Adds a fact for programs.
    #[must_use]
    pub fn fact(mut self, name: &'static str, value: impl Into<Value>) -> Self {
        self.facts.insert(name, value.into());
        self
    }

    /// Sets the JSON. It replaces the facts.
    #[must_use]
    pub fn with_json(self, json: impl Fn() -> String + 'a) -> Self {
        Self {
            json: Some(Box::new(json)),
            ..self
        }
    }

    /// Sets the table for programs.
    #[must_use]
    pub fn with_csv(self, csv: impl Fn() -> String + 'a) -> Self {
        Self {
            csv: Some(Box::new(csv)),
            ..self
        }
    }

    /// Returns the parts, each with the place where it is shown.
    pub fn parts(&self) -> &[(Where, Part)] {
        &self.parts
    }

    /// Returns the answer in this form.
    ///
    /// # Panics
    /// If CSV is asked for and [`with_csv`](Self::with_csv) was not called: a command without a table has no such option.
    pub fn text(&self, form: Form) -> String {
        match form {
            Form::Brief => self.terminal(false),
            Form::Details => self.terminal(true),
            Form::Csv => self.csv.as_ref().expect("a command with this option has a table")(),
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
