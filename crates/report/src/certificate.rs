//! What a contact law and methods deliver to a free impact, for people and for programs.

use pounding_contact::Calibration;
use pounding_scene::{Certificate, CertificateFact, CertificateRequest, CertificateValue, DeliveredBy, FreeCollision, StepMethod};
use pounding_text::{Answer, Cell, Manner, NONE, Refused, Shown, Table, Unit, Where, digits, short};
use serde_json::{Value, json};

/// A number of a certificate, on a line for programs.
struct CertifiedNumber<'a> {
    /// `None` for the free impact itself.
    method: Option<&'a str>,
    quantity: &'a str,
    value: Cell,
    unit: &'a str,
}

/// The certificate of a law, with what methods deliver at a time step \[s\]: one method, or all that differ.
///
/// # Errors
/// Refuses what [`Certificate::new`] refuses.
pub fn certificate(
    request: &CertificateRequest,
    collision: &FreeCollision,
    time_step: Option<f64>,
    method: Option<StepMethod>,
) -> Result<Answer<'static>, Refused> {
    let certificate = Certificate::new(request, collision)?;
    let methods = time_step.map_or_else(Vec::new, |step| certificate.lines(collision, step, method));
    let facts = certificate.facts(request, collision);
    let calibration = match request.calibration {
        Calibration::Exact => "damping from the exact relation",
        Calibration::Literature => "damping from the literature's formula",
    };
    let said = facts.iter().map(|fact| {
        let value = match &fact.said {
            CertificateValue::Number(number) => number.map_or(NONE.into(), digits),
            CertificateValue::Words(words) => words.clone(),
        };
        format!("{}: {value} {}", fact.words, fact.unit)
    });
    let said = std::iter::once(format!("impact: free, {calibration}")).chain(said).collect();
    let answer = Answer::new().say_as(Where::Terminal, Manner::Facts, "", said);
    let answer = facts.iter().fold(answer, |answer, fact| answer.fact(fact.key, said_json(fact)));
    let answer = if methods.is_empty() {
        answer
    } else {
        let failed = methods
            .iter()
            .filter_map(|one| Some(format!("{}: {}", one.method.label(), one.delivered.as_ref().err()?)));
        let notes = std::iter::once(NOTES.into()).chain(failed).collect();
        answer
            .table(Where::Terminal, table(&methods).grid())
            .say(Where::Terminal, "Notes", notes)
    };
    let delivered = table(&methods).json();
    Ok(answer.fact("methods", delivered).with_csv(move || numbers(&facts, &methods).csv()))
}

const NOTES: &str = "Least and largest e over sixteen places in the step at which the gap closes. Error: the largest \
                     distance from the e that the exact method delivers.";

/// What every method delivers, for people and for programs.
fn table(methods: &[DeliveredBy]) -> Table<'_, &DeliveredBy> {
    let table = Table::of(methods)
        .both("method", "Method", |one| one.method.name(), |one| one.method.label())
        .number("time_step_s", "Step", &Unit::MILLISECOND, |one| one.step);
    let table = DeliveredBy::NUMBERS.iter().enumerate().fold(table, |table, (index, number)| {
        let known = move |one: &&DeliveredBy| one.delivered.as_ref().ok().map(number.of);
        table.both(
            number.key,
            number.heading,
            move |one| Cell::exact(known(one).flatten()),
            move |one| match known(one) {
                None if index == 0 => Shown::from("fails"),
                number => number.flatten().map(short).into(),
            },
        )
    });
    table.column("failed", |one| one.delivered.as_ref().err().cloned())
}

fn numbers<'a>(facts: &'a [CertificateFact], methods: &'a [DeliveredBy]) -> Table<'a, CertifiedNumber<'a>> {
    let facts = facts.iter().map(|fact| CertifiedNumber {
        method: None,
        quantity: fact.key,
        value: match &fact.said {
            CertificateValue::Number(value) => Cell::exact(*value),
            CertificateValue::Words(words) => words.as_str().into(),
        },
        unit: fact.unit,
    });
    let methods = methods.iter().flat_map(|one| {
        let number = |quantity, value, unit| CertifiedNumber {
            method: Some(one.method.name()),
            quantity,
            value,
            unit,
        };
        let delivered = one.delivered.as_ref().into_iter();
        let delivered = delivered.flat_map(move |delivered| {
            let numbers = DeliveredBy::NUMBERS.iter();
            numbers.map(move |known| number(known.key, Cell::exact((known.of)(delivered)), ""))
        });
        let failed = one.delivered.as_ref().err();
        let failed = failed.map(|reason| number("failed", reason.as_str().into(), ""));
        std::iter::once(number("time_step_s", Cell::exact(one.step), "s"))
            .chain(delivered)
            .chain(failed)
    });
    Table::of(facts.chain(methods))
        .column("method", |row| row.method)
        .column("quantity", |row| row.quantity)
        .column("value", |row| row.value.clone())
        .column("unit", |row| row.unit)
}

fn said_json(fact: &CertificateFact) -> Value {
    match &fact.said {
        CertificateValue::Number(number) => json!(number),
        CertificateValue::Words(words) => json!(words),
    }
}
