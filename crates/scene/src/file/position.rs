//! Position of a field in a file, for the line in a message.

use std::collections::BTreeMap;

use serde_json::value::RawValue;
use toml::de::{DeTable, DeValue};

/// A step on the path to a field.
enum Step<'p> {
    Field(&'p str),
    Item(usize),
}

/// First bytes of the name and of the value of a field, for example `structures[1].sdof.mass_kg`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct FieldBytes {
    /// First byte of the name, or of the item of a list.
    pub(crate) name: usize,
    /// First byte of the value.
    pub(crate) value: usize,
}

impl FieldBytes {
    /// Finds a field in valid JSON or TOML.
    pub(crate) fn find(text: &str, is_json: bool, place: &str) -> Option<Self> {
        if is_json { in_json(text, place) } else { in_toml(text, place) }
    }
}

fn in_toml(text: &str, place: &str) -> Option<FieldBytes> {
    let table = DeTable::parse(text).ok()?;
    let root = DeValue::Table(table.into_inner());
    let (mut value, mut spot) = (&root, None);
    for step in steps(place) {
        let (name, found) = match (step, value) {
            (Step::Field(name), DeValue::Table(table)) => {
                let (key, value) = table.iter().find(|(key, _)| key.get_ref() == name)?;
                (key.span(), value)
            }
            (Step::Item(index), DeValue::Array(items)) => {
                let item = items.get(index)?;
                (item.span(), item)
            }
            _ => return None,
        };
        value = found.get_ref();
        spot = Some(FieldBytes {
            name: name.start,
            value: found.span().start,
        });
    }
    spot
}

fn in_json(text: &str, place: &str) -> Option<FieldBytes> {
    let mut value: &RawValue = serde_json::from_str(text).ok()?;
    let mut spot = None;
    for step in steps(place) {
        let name = match step {
            Step::Field(name) => {
                let fields: BTreeMap<String, _> = serde_json::from_str(value.get()).ok()?;
                value = fields.get(name).copied()?;
                Some(format!("\"{name}\""))
            }
            Step::Item(index) => {
                let items: Vec<_> = serde_json::from_str(value.get()).ok()?;
                value = items.get(index).copied()?;
                None
            }
        };
        let start = value.get().as_ptr().addr() - text.as_ptr().addr();
        spot = Some(FieldBytes {
            name: name.map_or(Some(start), |name| text[..start].rfind(&name))?,
            value: start,
        });
    }
    spot
}

fn steps(place: &str) -> impl Iterator<Item = Step<'_>> {
    let pieces = place.split(['.', '[']);
    pieces.map(|piece| match piece.strip_suffix(']') {
        Some(index) => index.parse().map_or(Step::Field(piece), Step::Item),
        None => Step::Field(piece),
    })
}

#[cfg(test)]
mod tests {
    use super::{in_json, in_toml};

    const TOML: &str = "name = \"x\"\n\n[record]\nfile = \"a[0].b\"\nband_pass = { low_hz = 1, high_hz = 2 }\n\n\
                        [[structures]]\n[structures.sdof]\nmass_kg = 1\ndamping.ratio = 2\n\n[[structures]]\nwall = {}\n";
    const JSON: &str =
        "{\"name\": \"x {\\\" [\",\n \"list\": [1, {\"a\": [true, -2e3]},\n  {\"b\": {\"c\": null,\n \"d\" : 7}}],\n \"end\": 0}\n";

    #[test]
    fn reference_lines_of_fields() {
        let toml = |place: &str| {
            let spot = in_toml(TOML, place)?;
            Some(TOML[..spot.name].matches('\n').count() + 1)
        };
        for (place, expected) in [
            ("name", 1),
            ("record.file", 4),
            ("record.band_pass.high_hz", 5),
            ("structures[0].sdof.mass_kg", 9),
            ("structures[0].sdof.damping.ratio", 10),
            ("structures[1].wall", 13),
        ] {
            assert_eq!(toml(place), Some(expected), "{place}");
        }
        let json = |place: &str| {
            let spot = in_json(JSON, place)?;
            Some(JSON[..spot.name].matches('\n').count() + 1)
        };
        for (place, expected) in [
            ("name", 1),
            ("list", 2),
            ("list[1].a[1]", 2),
            ("list[2].b", 3),
            ("list[2].b.d", 4),
            ("end", 5),
        ] {
            assert_eq!(json(place), Some(expected), "{place}");
        }
    }

    #[test]
    fn extreme_fields_that_are_not_there() {
        for place in ["", "top level", "name.x", "list[3]", "list[0].a", "x[", "list[1].a[9]", "list[x]"] {
            assert_eq!(in_json(JSON, place), None, "{place}");
            assert_eq!(in_toml(TOML, place), None, "{place}");
        }
        for length in 0..JSON.len() {
            let _ = in_json(&JSON[..length], "list[2].b.d");
        }
    }
}
