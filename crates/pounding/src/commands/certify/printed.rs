//! A certificate as text, CSV or JSON.

use pounding::contact::Calibration;
use pounding::scene::{CertificateFact, CertificateValue, DeliveredBy};
use pounding::text::{Cell, csv_text, digits};

use crate::text::{NONE, paragraph, short, table};

/// For a reader.
pub(super) fn text(calibration: Calibration, facts: &[CertificateFact], methods: &[DeliveredBy]) -> String {
    let calibration = match calibration {
        Calibration::Exact => "damping from the exact relation",
        Calibration::Literature => "damping from the literature's formula",
    };
    let mut text = format!("Certificate of a free impact, {calibration}\n\n");
    for fact in facts {
        let value = match &fact.said {
            CertificateValue::Number(number) => number.map_or(NONE.into(), digits),
            CertificateValue::Words(words) => words.clone(),
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
    let rows: Vec<_> = methods.iter().map(row).collect();
    let failed = methods.iter().filter_map(|line| {
        let reason = line.delivered.as_ref().err()?;
        Some(format!("\n{}: {reason}", line.method.label()))
    });
    let notes = format!("{NOTES}{}", failed.collect::<String>());
    format!("{text}\n{}\n{}", table(&header, &rows), paragraph("Notes", &notes))
}

const NOTES: &str = "Least and largest e over sixteen places in the step at which the gap closes. Error: the largest \
                     distance from the e that the exact method delivers.";

/// A line of the table of methods.
fn row(line: &DeliveredBy) -> Vec<String> {
    let mut row = vec![line.method.label().to_string(), short(1e3 * line.step)];
    match line.numbers() {
        Some(numbers) => {
            row.extend(numbers.map(|(_, number)| number.map_or(NONE.into(), short)));
        }
        None => row.extend(["fails", NONE, NONE, NONE].map(String::from)),
    }
    row
}

/// For a table: a row for each number.
pub(super) fn csv(facts: &[CertificateFact], methods: &[DeliveredBy]) -> String {
    let header = ["method", "quantity", "value", "unit"];
    let mut rows = Vec::new();
    for fact in facts {
        let value = match &fact.said {
            CertificateValue::Number(value) => Cell::exact(*value),
            CertificateValue::Words(words) => words.as_str().into(),
        };
        rows.push([Cell::default(), fact.key.into(), value, fact.unit.into()]);
    }
    for line in methods {
        let row = |key: &str, value: Cell, unit: &str| [line.method.name().into(), key.into(), value, unit.into()];
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
