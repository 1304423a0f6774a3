//! The first lines of `compare`: what differs, how hard floors touch, what it does to the buildings, and which gap they need.

use std::collections::BTreeMap;

use pounding::assess::{JudgedSeparations, beyond_belief};
use pounding::report::{Blow, OffSeat, other_direction};
use pounding::scene::{Error, RunResult};
use pounding::text::{NONE, millimetres_up, percent, short, two_digits};
use serde_json::Value;

use super::ComparedRun;
use super::rows::{ComparedRow, ComparedValue};

/// Fields that differ and have a row.
const MOST: usize = 2;

/// Other fields that differ and are named.
const NAMED: usize = 8;

/// What both directions of shaking of a scene gave.
struct BothWays<'a> {
    scene: &'a ComparedRun,
    other: Option<RunResult>,
    /// Largest width that a gap needs while nothing touches \[m\]; `None` if there is no gap, or if a structure would not stand alone.
    needed: Option<f64>,
}

impl<'a> BothWays<'a> {
    fn of(scene: &'a ComparedRun) -> Result<Self, Error> {
        let prepared = &scene.prepared;
        let needed = if prepared.pairs().is_empty() {
            None
        } else {
            let reversed = prepared.under(|record| record.scaled(-1.0))?;
            let both = [prepared, &reversed].map(JudgedSeparations::of);
            let [one, other] = both;
            let both = [one?, other?];
            // Of a structure that would not stand alone no gap is needed.
            let stands = both.iter().all(|one| beyond_belief(&one.excesses).is_none());
            let widths = both.iter().flat_map(|one| &one.separations).map(|one| one.required);
            widths.reduce(f64::max).filter(|_| stands)
        };
        Ok(Self {
            scene,
            other: other_direction(prepared).ok(),
            needed,
        })
    }

    fn runs(&self) -> impl Iterator<Item = &RunResult> {
        std::iter::once(&self.scene.review.outcome).chain(self.other.as_ref())
    }

    /// The largest of a number of every blow, in thousands.
    fn hardest(&self, number: fn(&Blow) -> Option<f64>) -> Option<f64> {
        let blows = self.runs().flat_map(Blow::all);
        let largest = blows.filter_map(|blow| number(&blow)).reduce(f64::max);
        largest.map(|value| 1e-3 * value)
    }
}

/// The rows, and sentences below them.
pub(super) fn rows(runs: &[ComparedRun]) -> Result<(Vec<ComparedRow>, Vec<String>), Error> {
    let both: Vec<BothWays<'_>> = runs.iter().map(BothWays::of).collect::<Result<_, _>>()?;
    let differing = differing(runs);
    let mut rows: Vec<ComparedRow> = differing.iter().take(MOST).map(field).collect();
    let of = |name: &str, number: &dyn Fn(&BothWays<'_>) -> Option<f64>| ComparedRow {
        name: name.into(),
        cells: both.iter().map(|one| ComparedValue::from(number(one))).collect(),
    };
    rows.push(ComparedRow {
        name: "touches".into(),
        cells: both
            .iter()
            .map(|one| {
                let most = one.runs().map(|run| run.collisions.all().len()).max();
                most.map_or(NONE.into(), |most| most.to_string()).into()
            })
            .collect(),
    });
    let text = |name: &str, cell: &dyn Fn(&BothWays<'_>) -> Option<String>| ComparedRow {
        name: name.into(),
        cells: both.iter().map(|one| cell(one).unwrap_or_else(|| NONE.into()).into()).collect(),
    };
    rows.push(text("largest force [kN]", &|one| Some(two_digits(one.hardest(|blow| blow.force)?))));
    rows.push(of("largest impulse [kN·s]", &|one| one.hardest(|blow| Some(blow.impulse))));
    rows.push(ComparedRow {
        name: "worst strain, part of its limit".into(),
        cells: both.iter().map(|one| strain(one).into()).collect(),
    });
    if both.iter().any(|one| one.scene.prepared.scene().has_seats()) {
        rows.push(text("leaves its seat", &unseated));
    }
    rows.push(text("gap needed [mm]", &|one| Some(millimetres_up(one.needed?))));
    rows.push(text("warnings, see run", &|one| Some(one.scene.review.excesses.len().to_string())));
    let mut said = vec![
        "each number is the larger of both directions under one record, as strong as the scene makes it: no design; `pounding assess` takes a \
         folder of records and a target"
            .to_owned(),
    ];
    if both.iter().any(|one| one.other.is_none()) {
        said = vec!["a run in the other direction fails; its scene has the numbers of one direction".into()];
    }
    match differing.len().saturating_sub(MOST) {
        0 => {}
        1 => said.push(format!("{} differs, too", differing[MOST].0)),
        n => {
            let names: Vec<&str> = differing.iter().skip(MOST).take(NAMED).map(|(name, _)| name.as_str()).collect();
            let more = if n > names.len() {
                format!(", and {} more", n - names.len())
            } else {
                String::new()
            };
            said.push(format!("{n} more fields differ: {}{more}", names.join(", ")));
        }
    }
    said.push("--details prints every floor and pair, in the direction of the scene".into());
    Ok((rows, said))
}

/// The first deck that leaves its seat in either direction, and when; `None` if none does.
fn unseated(both: &BothWays<'_>) -> Option<String> {
    let all = both.runs().filter_map(|run| OffSeat::first(&both.scene.prepared, run));
    let first = all.min_by(|one, other| one.time.total_cmp(&other.time))?;
    Some(format!("{}, at {} s", first.names[1], short(first.time)))
}

/// The drift, ductility or force that is the largest part of its limit, and which it is.
fn strain(both: &BothWays<'_>) -> String {
    let strains = both.runs().filter_map(|run| both.scene.prepared.strain(run));
    let worst = strains.max_by(|one, other| one.0.total_cmp(&other.0));
    worst.map_or(NONE.into(), |(share, worst)| {
        let share = if share < f64::MAX && worst.is_judged() {
            format!("{} ", percent(share))
        } else {
            String::new()
        };
        format!("{share}({})", worst.kind.brief(worst.found))
    })
}

/// A field that differs: its name, and its value in every scene.
type Differing = (String, Vec<String>);

fn field((name, values): &Differing) -> ComparedRow {
    ComparedRow {
        name: name.clone(),
        cells: values.iter().cloned().map(ComparedValue::from).collect(),
    }
}

/// The fields of scenes that differ; those of equal list entries are one.
fn differing(runs: &[ComparedRun]) -> Vec<Differing> {
    let flat = |run: &ComparedRun| {
        let mut all = BTreeMap::new();
        let words = serde_json::to_value(run.prepared.scene()).unwrap_or_default();
        flatten(&words, String::new(), &mut all);
        all.remove("name");
        all
    };
    let all: Vec<BTreeMap<String, String>> = runs.iter().map(flat).collect();
    let mut names: Vec<&String> = all.iter().flat_map(BTreeMap::keys).collect();
    names.sort();
    names.dedup();
    let of = |name: &String| -> Differing {
        let value = |scene: &BTreeMap<String, String>| scene.get(name).cloned().unwrap_or(NONE.into());
        (name.clone(), all.iter().map(value).collect())
    };
    let differs = |(_, values): &Differing| values.windows(2).any(|two| two[0] != two[1]);
    names.into_iter().map(of).filter(differs).collect()
}

/// Values by their path; the values of all entries of a list are one text if they are alike.
fn flatten(value: &Value, path: String, into: &mut BTreeMap<String, String>) {
    match value {
        Value::Object(fields) => {
            for (name, field) in fields {
                let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
                flatten(field, path, into);
            }
        }
        Value::Array(entries) => {
            for entry in entries {
                flatten(entry, format!("{path}[*]"), into);
            }
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {
            let text = value.as_f64().map_or_else(|| value.to_string().trim_matches('"').to_owned(), short);
            let known = into.entry(path).or_default();
            let is_new = known.split(", ").all(|one| one != text);
            if known.is_empty() {
                *known = text;
            } else if is_new {
                *known = format!("{known}, {text}");
            }
        }
    }
}
