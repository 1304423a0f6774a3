//! Places in a scene, as in messages: `structures[0].sdof.period_s`.

use pounding_text::Refused;
use serde_json::{Map, Value};

/// The path to a field of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct FieldPath(Vec<PathStep>);

#[derive(Debug, Clone, PartialEq, Eq)]
enum PathStep {
    Field(String),
    Item(usize),
    /// `[*]`: every item.
    Every,
}

fn indices(found: usize) -> String {
    match found {
        0 => "no items".into(),
        1 => "[0]".into(),
        _ => format!("[0] to [{}]", found - 1),
    }
}

impl FieldPath {
    /// The places that a text names in a scene, at least one.
    pub(super) fn all(text: &str, scene: &Value) -> Result<Vec<Self>, Refused> {
        let steps = steps(text).ok_or_else(|| {
            let found = Refused::default().found(format!("\"{text}\""));
            found.allowed_is("the way to a field of the scene, such as \"contacts[0].gap_m\"")
        })?;
        let mut found = Vec::new();
        expand(&steps, scene, &mut Vec::new(), &mut found)?;
        Ok(found)
    }

    /// Whether both are a common field, or one is inside the other.
    pub(super) fn meets(&self, other: &Self) -> bool {
        self.0.starts_with(&other.0) || other.0.starts_with(&self.0)
    }

    /// Its first field.
    pub(super) fn begins_with(&self, field: &str) -> bool {
        matches!(self.0.first(), Some(PathStep::Field(first)) if first == field)
    }

    /// Whether it is this field, or inside it.
    pub(super) fn is_in(&self, text: &str) -> bool {
        steps(text).is_some_and(|steps| self.0.starts_with(&steps))
    }

    /// Whether a field is this field, or inside it.
    pub(super) fn holds(&self, text: &str) -> bool {
        steps(text).is_some_and(|steps| steps.starts_with(&self.0))
    }

    /// For a field of an item of a list, its index and the path from there: `structures[0].sdof.mass_kg` gives 0 and `sdof.mass_kg`.
    pub(super) fn in_item_of(&self, list: &str) -> Option<(usize, String)> {
        match &self.0[..] {
            [PathStep::Field(name), PathStep::Item(index), rest @ ..] if name == list => Some((*index, named(rest))),
            _ => None,
        }
    }

    /// The value at this place, created if it is missing; `None` if another value blocks the path.
    pub(super) fn slot<'v>(&self, scene: &'v mut Value) -> Option<&'v mut Value> {
        self.0.iter().try_fold(scene, |value, step| {
            if value.is_null() {
                *value = Value::Object(Map::new());
            }
            match (step, value) {
                (PathStep::Field(name), Value::Object(fields)) => {
                    // Looked up first: a new key needs an allocation.
                    if !fields.contains_key(name) {
                        fields.insert(name.clone(), Value::Null);
                    }
                    fields.get_mut(name)
                }
                (PathStep::Item(index), Value::Array(items)) => items.get_mut(*index),
                _ => None,
            }
        })
    }
}

impl std::fmt::Display for FieldPath {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&named(&self.0))
    }
}

fn named(steps: &[PathStep]) -> String {
    let mut text = String::new();
    for step in steps {
        match step {
            PathStep::Field(name) if text.is_empty() => text.push_str(name),
            PathStep::Field(name) => text = format!("{text}.{name}"),
            PathStep::Item(index) => text = format!("{text}[{index}]"),
            PathStep::Every => text.push_str("[*]"),
        }
    }
    text
}

/// The steps of a text; `None` if it is no path to a field.
fn steps(text: &str) -> Option<Vec<PathStep>> {
    let mut steps = Vec::new();
    for piece in text.split('.') {
        let mut parts = piece.split('[');
        let name = parts.next().filter(|name| !name.is_empty())?;
        if !name.chars().all(|letter| letter.is_alphanumeric() || letter == '_') {
            return None;
        }
        steps.push(PathStep::Field(name.into()));
        for part in parts {
            let item = part.strip_suffix(']')?;
            steps.push(match item {
                "*" => PathStep::Every,
                index => PathStep::Item(index.parse().ok()?),
            });
        }
    }
    Some(steps)
}

/// Walks on from `value`, which lies at `way`.
fn expand(rest: &[PathStep], value: &Value, way: &mut Vec<PathStep>, found: &mut Vec<FieldPath>) -> Result<(), Refused> {
    let Some((step, rest)) = rest.split_first() else {
        found.push(FieldPath(way.clone()));
        return Ok(());
    };
    let mut go = |step: PathStep, value: &Value| {
        way.push(step);
        let gone = expand(rest, value, way, found);
        way.pop();
        gone
    };
    match (step, value) {
        (PathStep::Field(name), Value::Object(fields)) => go(step.clone(), fields.get(name).unwrap_or(&Value::Null)),
        // A missing value of the scene may be a table.
        (PathStep::Field(_), Value::Null) => go(step.clone(), &Value::Null),
        (PathStep::Field(_), _) => {
            let none = Refused::default().found(format!("no table `{}` in the scene", named(way)));
            Err(none.so(": ", "write it there as a table with its fields"))
        }
        (PathStep::Item(index), Value::Array(items)) => {
            let Some(item) = items.get(*index) else {
                let none = Refused::default().found(format!("{}[{index}]", named(way)));
                return Err(none.allowed_are(format!("{} in the scene", indices(items.len()))));
            };
            go(step.clone(), item)
        }
        (PathStep::Every, Value::Array(items)) => {
            let has = |item: &Value| match rest.first() {
                Some(PathStep::Field(name)) => item.get(name).is_some(),
                _ => true,
            };
            let before = found.len();
            for (index, item) in items.iter().enumerate().filter(|(_, item)| has(item)) {
                way.push(PathStep::Item(index));
                let gone = expand(rest, item, way, found);
                way.pop();
                gone?;
            }
            if found.len() == before {
                let (list, field) = (named(way), named(rest));
                let none = Refused::default().found(format!("no item of `{list}` with the field `{field}` in the scene"));
                return Err(none.help("add it there, or name another"));
            }
            Ok(())
        }
        (PathStep::Item(_) | PathStep::Every, _) => {
            let none = Refused::default().found(format!("no list `{}` in the scene", named(way)));
            Err(none.allowed_are("the lists that it has"))
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::FieldPath;

    #[test]
    fn reference_places_in_a_scene() {
        let scene = json!({
            "structures": [{"sdof": {"mass_kg": 1.0}}, "wall", {"sdof": {"mass_kg": 2.0}}],
            "contacts": [{"gap_m": 0.1}, {"gap_m": 0.2}],
            "method": "exact",
        });
        let named = |text: &str| match FieldPath::all(text, &scene) {
            Ok(places) => places.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "),
            Err(error) => error.to_string(),
        };
        for (text, wanted) in [
            ("contacts[1].gap_m", "contacts[1].gap_m"),
            ("contacts[*].gap_m", "contacts[0].gap_m contacts[1].gap_m"),
            (
                "structures[*].sdof.period_s",
                "structures[0].sdof.period_s structures[2].sdof.period_s",
            ),
            ("record.scale", "record.scale"),
            ("duration_s", "duration_s"),
        ] {
            assert_eq!(named(text), wanted);
        }
        for (text, begins) in [
            ("", "found \"\""),
            ("contacts[x].gap_m", "found \"contacts[x].gap_m\""),
            ("contacts[2].gap_m", "found contacts[2], allowed are [0] to [1]"),
            ("contacts.gap_m", "found no table `contacts`"),
            ("method.exact.tolerance", "found no table `method`"),
            ("record[0]", "found no list `record`"),
            ("structures[*].building.name", "found no item of `structures`"),
        ] {
            assert!(named(text).starts_with(begins), "{text}: {}", named(text));
        }
        let mut changed = scene.clone();
        let place = &FieldPath::all("record.scale_to.pga_g", &scene).expect("a place")[0];
        *place.slot(&mut changed).expect("a slot") = json!(0.3);
        assert_eq!(changed["record"]["scale_to"]["pga_g"], json!(0.3));
    }
}
