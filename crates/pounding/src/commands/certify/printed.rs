//! A certificate as text, CSV or JSON.

use pounding::contact::Calibration;
use pounding::scene::{Delivered, StepMethod};
use pounding::text::{Cell, csv_text, digits, json_text};
use serde_json::{Map, Value, json};

use crate::text::{NONE, paragraph, short, table};

/// One line of a certificate.
pub(super) struct Fact {
    /// Name in CSV and JSON, with its unit.
    pub(super) key: &'static str,
    /// Name in text.
    pub(super) words: &'static str,
    pub(super) unit: &'static str,
    pub(super) said: Said,
}

/// What the line says.
pub(super) enum Said {
    Number(Option<f64>),
    Words(String),
}

/// What one method delivers, or why it fails.
pub(super) struct Line {
    pub(super) method: StepMethod,
    /// Time step \[s\].
    pub(super) step: f64,
    pub(super) delivered: Result<Delivered, String>,
}

/// For a reader.
pub(super) fn text(calibration: Calibration, facts: &[Fact], methods: &[Line]) -> String {
    let calibration = match calibration {
        Calibration::Exact => "damping from the exact relation",
        Calibration::Literature => "damping from the literature's formula",
    };
    let mut text = format!("Certificate of a free impact, {calibration}\n\n");
    for fact in facts {
        let value = match &fact.said {
            Said::Number(number) => number.map_or(NONE.into(), digits),
            Said::Words(words) => words.clone(),
        };
        text.push_str(format!("{:32}{value} {}", fact.words, fact.unit).trim_end());
        text.push('\n');
    }
    if methods.is_empty() {
        return text;
    }
    let header = [
        ["Method", ""],
        ["Step", "[ms]"],
        ["Steps per", "contact"],
        ["Least", "e"],
        ["Largest", "e"],
        ["Error", ""],
    ];
    let rows: Vec<_> = methods.iter().map(Line::row).collect();
    let failed = methods.iter().filter_map(|line| {
        let reason = line.delivered.as_ref().err()?;
        Some(format!("\n{}: {reason}", line.method.label()))
    });
    let notes = format!("{NOTES}{}", failed.collect::<String>());
    format!(
        "{text}\n{}\n{}",
        table(&header, &rows),
        paragraph("Notes", &notes)
    )
}

const NOTES: &str = "Least and largest e over sixteen places in the step at which the gap closes. Error: the largest \
                     distance from the e that the exact method delivers.";

impl Line {
    /// Its numbers by name; nothing where the method fails.
    fn numbers(&self) -> Option<[(&'static str, Option<f64>); 4]> {
        let delivered = self.delivered.as_ref().ok()?;
        let [least, largest] = delivered.range;
        Some([
            ("steps_per_contact", delivered.steps_per_contact),
            ("least_restitution", Some(least)),
            ("largest_restitution", Some(largest)),
            ("largest_error", Some(delivered.error)),
        ])
    }

    fn row(&self) -> Vec<String> {
        let mut row = vec![self.method.label().to_string(), short(1e3 * self.step)];
        match self.numbers() {
            Some(numbers) => {
                row.extend(numbers.map(|(_, number)| number.map_or(NONE.into(), short)));
            }
            None => row.extend(["fails", NONE, NONE, NONE].map(String::from)),
        }
        row
    }
}

/// For a table: a row for each number.
pub(super) fn csv(facts: &[Fact], methods: &[Line]) -> String {
    let header = ["method", "quantity", "value", "unit"];
    let mut rows = Vec::new();
    for fact in facts {
        let value = match &fact.said {
            Said::Number(value) => Cell::exact(*value),
            Said::Words(words) => words.as_str().into(),
        };
        rows.push([Cell::default(), fact.key.into(), value, fact.unit.into()]);
    }
    for line in methods {
        let row = |key: &str, value: Cell, unit: &str| {
            [line.method.name().into(), key.into(), value, unit.into()]
        };
        rows.push(row("time_step_s", Cell::exact(line.step), "s"));
        for (key, value) in line.numbers().into_iter().flatten() {
            rows.push(row(key, Cell::exact(value), ""));
        }
        if let Err(reason) = &line.delivered {
            rows.push(row("failed", reason.as_str().into(), ""));
        }
    }
    csv_text(&header, rows)
}

/// For a program.
pub(super) fn json(facts: &[Fact], methods: &[Line]) -> String {
    let fact = |fact: &Fact| {
        let value = match &fact.said {
            Said::Number(number) => json!(number),
            Said::Words(words) => json!(words),
        };
        (fact.key.to_string(), value)
    };
    let mut object: Map<_, _> = facts.iter().map(fact).collect();
    let method = |line: &Line| {
        let mut one = Map::new();
        one.insert("method".into(), json!(line.method.name()));
        one.insert("time_step_s".into(), json!(line.step));
        for (key, value) in line.numbers().into_iter().flatten() {
            one.insert(key.into(), json!(value));
        }
        if let Err(reason) = &line.delivered {
            one.insert("failed".into(), json!(reason));
        }
        Value::Object(one)
    };
    object.insert("methods".into(), methods.iter().map(method).collect());
    json_text(&Value::Object(object))
}
